"""Printed patterns, wordings: the words of a line put as most patterns have them, before it is read."""
