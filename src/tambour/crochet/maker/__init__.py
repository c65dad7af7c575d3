"""Maker: what a maker needs to know: gauge, size, materials."""
