"""NIGHT: whether samples are as large as a night allows (``make fuzz``); by day they are a share of it."""

import os

NIGHT = bool(os.environ.get("TAMBOUR_NIGHT"))
