"""``python -m kernels``: compile what changed, and put the built kernels where Tambour finds them."""

from kernels.build import build

build()
