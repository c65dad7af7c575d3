"""Floor 0: the values that every craft shares, their laws, and how errors speak.

Import from the modules (``from tambour.core.paths import Paths``): this package itself loads nothing, so that
``tambour --help`` stays instant.
"""
