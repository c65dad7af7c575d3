"""Geometry that two crafts share: tubes, normals, nearest points, letters as outlines."""
