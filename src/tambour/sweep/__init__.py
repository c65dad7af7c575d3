"""Sweep: many pieces of one craft: every source with every combination of values, named by what they are made of."""

from tambour.sweep.course import Result, sweep

__all__ = ["Result", "sweep"]
