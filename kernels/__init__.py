"""Kernels, compiled when Tambour is built, so that nothing is compiled at the user's: ``python -m kernels``."""
