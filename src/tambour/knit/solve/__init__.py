"""Solve: from what stitches should be to rows that can be knitted."""
