"""Machines: what each can take, and text that other programs read."""
