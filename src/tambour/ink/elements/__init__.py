"""Elements: everything that a scroll is made of, one kind to a module."""
