"""Printed patterns, yarns: colours by their names, letters and lists."""
