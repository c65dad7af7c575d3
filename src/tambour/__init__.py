"""Tambour: crochet, knitting, ink and embroidery from patterns, pictures and seed numbers.

The names of ``__all__`` are promised, and ``run`` and ``craft`` of ``tambour.run``; everything else may change. They are loaded on first use, so that importing
tambour costs nothing.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any

__version__ = "0.1.0"

_WHERE = {
    "Paths": "core.paths",
    "Drawing": "core.drawing",
    "Styles": "core.drawing",
    "Groups": "core.drawing",
    "Label": "core.drawing",
    "Picture": "core.picture",
    "StitchGraph": "core.graph",
    "Chart": "core.chart",
    "Gauge": "core.chart",
    "ThreadPlan": "core.thread",
    "Thread": "core.thread",
    "Strands": "core.strands",
    "Mesh": "core.mesh",
    "Binding": "core.mesh",
    "Palette": "core.palette",
    "Text": "core.errors",
    "Problem": "core.errors",
    "TambourError": "core.errors",
    "Params": "core.params",
    "Progress": "core.progress",
    "Craft": "craft",
    "View": "craft",
    "CRAFTS": "run",
    "read": "files",
    "write": "files",
}

__all__ = ["__version__", *_WHERE]


def __getattr__(name: str) -> Any:
    if name not in _WHERE:
        raise AttributeError(f"module 'tambour' has no attribute {name!r}")
    return getattr(import_module(f"tambour.{_WHERE[name]}"), name)
