"""Ground: what every room of the craft speaks of: constants, kinds, marks."""
