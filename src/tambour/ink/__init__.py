"""Ink: a seed → an endless shan-shui hand scroll, as vectors."""

from __future__ import annotations

from tambour.craft import Craft, Lazy
from tambour.ink.edits import LEAVE
from tambour.ink.params import Ink, stem
from tambour.ink.views import VIEWS, check

CRAFT = Craft(
    name="ink",
    help="A seed → an endless shan-shui hand scroll, as vectors.",
    params=Ink,
    reads=(),
    make=Lazy("tambour.ink.views:make"),
    views=VIEWS,
    facts=Lazy("tambour.ink.views:facts"),
    stem=stem,
    check=check,
    changes={"leave": LEAVE},
)
