"""``python -m tambour``."""

from tambour.cli import main

main()
