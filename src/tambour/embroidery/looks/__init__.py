"""Looks: previews, drawings and pages of a finished plan."""
