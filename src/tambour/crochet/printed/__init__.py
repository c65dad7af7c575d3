"""Printed: patterns as people print them, read into the same tree."""
