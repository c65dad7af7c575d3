"""Cloth: thread as it lies on cloth that moves."""
