"""Plotter: the scroll as lines of a pen, on pages, in the order in which the pen moves least."""
