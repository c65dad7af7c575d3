"""Finish: parts placed and sewn on, faces, felt and hair."""
