"""Printed patterns, rounds: the words of one round → items; its doubts and its counts."""
