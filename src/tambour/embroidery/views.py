"""What a piece can be looked at as, and made into: views, each loading its room on first use."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tambour.craft import View


def _lazy(module: str, name: str) -> Callable[[Any], Any]:
    """A view's function, imported when it is called."""

    def make(piece: Any) -> Any:
        from importlib import import_module

        return getattr(import_module(f"tambour.embroidery.{module}"), name)(piece)

    return make


_MACHINE = (".dst", ".pes", ".pec", ".exp", ".jef", ".vp3", ".xxx", ".u01", ".tbf", ".sew")

VIEWS: dict[str, View] = {
    "machine": View(_lazy("looks", "machine"), "ThreadPlan", "for the embroidery machine", _MACHINE),
    "preview": View(
        _lazy("looks", "preview"), "Picture", "thread on cloth, from above", (".png", ".jpg", ".jpeg", ".webp")
    ),
    "lines": View(_lazy("draw", "stitch_lines"), "Drawing", "the needle's way as lines", (".svg",)),
    "worksheet": View(
        _lazy("worksheet", "worksheet"), "Drawing", "pages to work from: true size, colours, stops", (".pdf",)
    ),
    "cloth": View(
        _lazy("looks", "scene"),
        "Scene",
        "thread in space on its cloth",
        (".glb", ".usdc", ".usda", ".usd", ".obj", ".npz"),
        "bind",
    ),
    "density": View(_lazy("looks", "density"), "Picture", "how much thread lies where"),
    "simulate": View(_lazy("looks", "simulate"), "Pictures", "the needle at work", (".gif",)),
    "stitches": View(_lazy("draw", "stitch_table"), "dict", "every needle point as data", (".json",)),
}
