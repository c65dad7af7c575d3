"""Families: which stitches a region is made of."""
