"""Hands: what a knitter follows: charts, rows, catches, yarn."""
