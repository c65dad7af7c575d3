"""Lines: everything a needle can follow inside an area: rows, curves, flows, and the ways between them."""
