"""Columns: satin, along two rails or across an area's middle lines."""
