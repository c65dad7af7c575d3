"""Brush: how a stroke is held and what it leaves on the paper."""
