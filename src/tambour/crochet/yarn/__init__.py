"""Yarn: from a shape to the strands that make it, and to their mesh."""
