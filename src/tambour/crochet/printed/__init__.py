"""Printed: patterns as people print them, read into the same tree: sheet → wordings → rounds → parts, with yarns and what stands between."""
