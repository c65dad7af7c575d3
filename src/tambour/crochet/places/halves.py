"""Halves: two pieces alike, worked in rows, that are laid on each other and sewn together all round, with stuffing between them."""

from __future__ import annotations

import copy
import re
from dataclasses import replace
from typing import Final

import numpy as np

from tambour.crochet.finish.globe import motifs
from tambour.crochet.graph.assemble import assemble
from tambour.crochet.graph.built import Built
from tambour.crochet.graph.spots import Spots, spots_in
from tambour.crochet.places.names import Made

_TOGETHER: Final = re.compile(
    r"\b(?:pieces?|halves|front and back|back and front|bod(?:y|ies)|fronts?|backs?|sides|panels|squares|circles|discs|layers)\b[^.\n]{0,90}"
    r"\b(?:tog|together)\b"
    r"|\bthrough (?:both|the 2|the two)(?: (?:pieces|halves|layers|panels|squares|circles|discs|sides|edges|thicknesses))?\b"
    r"|\b(?:ws|rs|wrong sides?|right sides?)\s+(?:tog|together|facing|out)\b"
    r"|\bmatching pieces\b"
)
_TWO: Final = re.compile(r"\b(?:2|two|both) (?:matching )?(?:pieces|halves|sides)\b[^.\n]{0,20}\b(?:tog|together)\b")
"""Two of several pieces make one thing."""
_LEAST: Final = 60
"""A half has so many stitches or more; smaller ones are ears and leaves in two layers."""
_AGAIN: Final = re.compile(r"_\d+$")
"""What the reader adds to a name that another part has."""
_FACES: Final = ({"front", "back"},)


def halves(built: Built) -> list[tuple[int, int]]:
    """The parts of built, by number, that are sewn together all round: the front one first."""
    pattern, spots = built.pattern, spots_in(built)
    text = pattern.text.text.lower()
    if not _TOGETHER.search(text) or not re.search(r"\bstuff|\bfiber\s?fil", text) or motifs(spots):
        return []  # "join the 2 halves of the ball" speaks of six motifs each
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
    taken = {k for pair in found for k in pair}
    found += [(a, b) for a, b in _held(built, spots, single) if not {a, b} & taken]
    size = {k: built.graph.parts[k].end - built.graph.parts[k].start for pair in found for k in pair}
    return [
        (a, b)
        for a, b in found
        if (spots.in_rows[a] and spots.in_rows[b] and size[a] == size[b] >= _LEAST)
        or (_wide(built, spots, a) and _LEAST <= size[a] <= size[b] and _same(built, spots, a, b))
    ]


def _held(built: Built, spots: Spots, single: list[Made]) -> list[tuple[int, int]]:
    """Pairs of parts made once whose names differ in what only tells two sides apart: "Side A" and "Side B", "Half 1" and "Half 2"."""
    single = [m for m in single if m.kind not in _PAIRS]  # an ear in each of two colours is a pair of ears
    every = [spots.parts[f"{m.name}.1"] for m in single]
    names = [
        " ".join(w for w in re.findall(r"[a-z]+", m.name.lower()) if len(w) > 1 and w not in _SIDES) for m in single
    ]
    of = {
        spots.parts[f"{s.name}.1"]: s.heading for s in built.pattern.parts if s.heading and f"{s.name}.1" in spots.parts
    }
    # Where several parts come again under their own names, the text makes another toy: its cap is no half of the first one's.
    again = [_AGAIN.sub("", m.name) for m in single]
    several = sum(n != m.name for n, m in zip(again, single)) > 1
    pairs = [
        (i, k)
        for i in range(len(every))
        for k in range(i + 1, len(every))
        if not (several and again[i] == again[k] and single[i].name != single[k].name)
    ]
    return [
        (every[i], every[k])
        for i, k in pairs
        if names[i] == names[k] or (of.get(every[i]) and of[every[i]] == of.get(every[k]))
    ]


_SIDES: Final = frozenset("front back first second one two top bottom left right upper lower light dark".split())


def _wide(built: Built, spots: Spots, part: int) -> bool:
    """Whether a part in rounds is open where it is widest, as a disc, an oval, a square or half a ball is."""
    counts = [r.count for r in built.rounds if r.part == part and not r.aside and r.count]
    return not spots.in_rows[part] and len(spots.edge(part)) > 0 and bool(counts) and max(counts) <= counts[-1]


def _same(built: Built, spots: Spots, one: int, other: int) -> bool:
    """Whether the rounds of a part are those that another begins with; what that has more is worked through both."""
    mine, theirs = ([r.count for r in built.rounds if r.part == k and not r.aside] for k in (one, other))
    return not spots.in_rows[other] and theirs[: len(mine)] == mine and len(theirs) <= len(mine) + 1


_PAIRS: Final = frozenset(("ear", "arm", "leg", "foot", "wing"))
"""Kinds of parts of which a toy has two."""
_LARGE: Final = frozenset(("body", "head", "", "bow"))
"""Kinds of parts that are made of two halves."""


def joined(built: Built) -> Built:
    """``built`` with its halves sewn together; the one behind shows its other side."""
    pairs = halves(built)
    if not pairs:
        return built
    spots, graph = spots_in(built), built.graph
    sewn = [(int(a), int(b)) for a, b in built.sewn.tolist()]
    hook = copy.copy(built.hook)
    behind = set()
    for one, other in pairs:
        shift = graph.parts[other].start - graph.parts[one].start
        edge = spots.edge(one) if spots.in_rows[one] else spots.stitches(spots.last(one))
        sewn += [(int(max(n, n + shift)), int(min(n, n + shift))) for n in edge]
        behind.add(other)
    of = graph.part
    hook.faces = [(a, c, b) if int(of[a]) in behind else (a, b, c) for a, b, c in hook.faces]
    stitch = (graph.stitch_width, graph.stitch_width)
    made, shell = assemble(hook, list(graph.parts), sewn, stitch)
    return replace(built, graph=made, shell=shell, sewn=np.array(sewn, np.int32).reshape(-1, 2), hook=hook)
