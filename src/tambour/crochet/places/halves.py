"""Halves: two pieces alike, worked in rows, that are laid on each other and sewn together all round, with stuffing between them."""

from __future__ import annotations

import copy
import re
from dataclasses import replace
from typing import Final

import numpy as np

from tambour.crochet.graph.assemble import assemble
from tambour.crochet.graph.built import Built
from tambour.crochet.graph.spots import Spots
from tambour.crochet.places.names import Made

_TOGETHER: Final = re.compile(
    r"\b(?:pieces?|halves|front and back|back and front|bod(?:y|ies)|fronts?|backs?|sides)\b[^.\n]{0,90}\b(?:tog|together)\b"
    r"|\b(?:ws|rs|wrong sides?|right sides?)\s+(?:tog|together|facing)\b"
    r"|\bmatching pieces\b"
)
_TWO: Final = re.compile(r"\b(?:2|two|both) (?:matching )?(?:pieces|halves|sides)\b[^.\n]{0,20}\b(?:tog|together)\b")
"""Two of several pieces make one thing."""
_LEAST: Final = 60
"""A half has so many stitches or more; smaller ones are ears and leaves in two layers."""
_FACES: Final = ({"front", "back"},)


def halves(built: Built) -> list[tuple[int, int]]:
    """The parts of built, by number, that are sewn together all round: the front one first."""
    pattern, spots = built.pattern, Spots(built)
    text = pattern.text.text.lower()
    if not _TOGETHER.search(text) or not re.search(r"\bstuff|\bfiber\s?fil", text):
        return []
    found: list[tuple[int, int]] = []
    made = [Made(section.name, section.copies) for section in pattern.parts]
    for section in made:
        one, other = (spots.parts.get(f"{section.name}.{k}") for k in (1, 2))
        if section.copies == 2 and one is not None and other is not None and section.kind in _LARGE:
            found.append((one, other))
        if section.copies > 2 and section.copies % 2 == 0 and not section.kind and _TWO.search(text):
            every = [spots.parts[f"{section.name}.{k}"] for k in range(1, section.copies + 1)]
            found += list(zip(every[::2], every[1::2]))  # fish, of which each is two pieces
    single = [m for m in made if m.copies == 1 and f"{m.name}.1" in spots.parts and not m.worn]
    for front in single:
        for back in single:
            if (set(front.words) ^ set(back.words)) == {"front", "back"} and "front" in front.words:
                found.append((spots.parts[f"{front.name}.1"], spots.parts[f"{back.name}.1"]))
    graph = built.graph
    return [
        (a, b)
        for a, b in found
        if spots.in_rows[a]
        and spots.in_rows[b]
        and graph.parts[a].end - graph.parts[a].start == graph.parts[b].end - graph.parts[b].start >= _LEAST
    ]


_LARGE: Final = frozenset(("body", "head", "", "bow"))
"""Kinds of parts that are made of two halves."""


def joined(built: Built) -> Built:
    """``built`` with its halves sewn together; the one behind shows its other side."""
    pairs = halves(built)
    if not pairs:
        return built
    spots, graph = Spots(built), built.graph
    sewn = [(int(a), int(b)) for a, b in built.sewn.tolist()]
    hook = copy.copy(built.hook)
    behind = set()
    for one, other in pairs:
        shift = graph.parts[other].start - graph.parts[one].start
        edge = spots.edge(one)
        sewn += [(int(max(n, n + shift)), int(min(n, n + shift))) for n in edge]
        behind.add(other)
    of = graph.part
    hook.faces = [(a, c, b) if int(of[a]) in behind else (a, b, c) for a, b, c in hook.faces]
    stitch = (graph.stitch_width, graph.stitch_width)
    made, shell = assemble(hook, list(graph.parts), sewn, stitch)
    return replace(built, graph=made, shell=shell, sewn=np.array(sewn, np.int32).reshape(-1, 2), hook=hook)
