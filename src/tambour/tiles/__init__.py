"""Tiles: the endless scroll in numbered parts, each made of the seed and its number alone: pictures, plotter sheets, hoops."""
