"""Geometry that two crafts share: polylines, polygons, hatching, tubes, surfaces."""
