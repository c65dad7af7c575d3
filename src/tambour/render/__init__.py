"""Render: drawings, strands and meshes become pictures; no display, no GPU."""
