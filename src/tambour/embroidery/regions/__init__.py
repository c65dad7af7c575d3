"""Regions: what is to be stitched: from drawings, pictures, text and other machines' files."""
