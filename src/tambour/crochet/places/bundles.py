"""Bundles: tails and pompoms of bare yarn, which are no part of the work: where the text has one made and tied, the toy bears it."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Final

import numpy as np

from tambour.core.errors import Span
from tambour.crochet.finish.hair import cut
from tambour.crochet.language.finishes import Hair, Spot
from tambour.crochet.places.hairdo import said_length, strands
from tambour.crochet.places.said import length
from tambour.crochet.places.stand import Host
from tambour.crochet.places.usual import usual
from tambour.crochet.yarn.loops import RATIO

if TYPE_CHECKING:
    from tambour.crochet.places.assemble import Assembly
    from tambour.crochet.places.beside import Beside

_POMPOM: Final = r"pom-?\s?po[mn]s?\b"
_MADE: Final = rf"\bmak(?:e|ing)\b[^.\n]{{0,30}}{_POMPOM}"
_TAIL: Final = re.compile(
    rf"(?:^|\n)\s*tail\b[ \t]*(?:\([^()\n]*\))?[:.]?\s{{1,3}}(?P<made>[^\n]{{0,60}}?(?:{_MADE}|\bwrap\b[^.\n]{{0,60}}\btimes)[^.\n]*\.?)"
    rf"|(?P<alone>\bmak(?:e|ing) an? (?:\w+ )?{_POMPOM}(?: tail\b|[^.\n]{{0,40}}\b(?:for|as) (?:the |a |his |her |its )?tail\b))"
)
"""A tail that is wound, or is a pompom: under its heading, or in a sentence."""
_BEARD: Final = re.compile(
    r"(?:^|\n)\s*(?:\w+ )?beard\b[ \t]*[:.]?\s{1,3}(?P<made>(?:[^\n]+\n)?[^\n]*?\bcut\b[^\n]*\b(?:lengths?|strands?|pieces?)\b[^\n]*)"
)
"""A beard of strands, under its heading."""
_TRIMMED: Final = 0.85
"""A beard reaches no farther than so much of the way down to what its wearer stands on."""
_UNDER_NOSE, _RISE = 0.6, 0.6
"""So many stitches below a nose's lower edge the strands of a beard are knotted in; beside it they begin higher, by so much of the way to its middle,"""
_WIDE: Final = 0.5
"""along an arc as wide as so much of its wearer, or as its strands cover; """
_NARROW, _ARC = 2.5, (-1.0, -0.5, 0.0, 0.5, 1.0)
"""and no less than so many stitches to either side."""
_TIP: Final = re.compile(
    rf"{_MADE}[^.\n]{{0,40}}\b(?:sew|attach|fasten|tie)\w*\b[^.\n]{{0,20}}\b(?:tip|top|point|end) of (?:the )?(?:hat|cap|beanie)\b"
)
_SIZE: Final = re.compile(r"(\d+(?:\.\d+)?|[½¼¾])\s*-?\s*(mm|cm|in\b|inch\b|\"|”)\s*(?:\w+ )?pom")
_TUFTS, _STRANDS = 44, 32
"""How many strands a pompom shows, and a tail."""
_OF_BODY: Final = 0.3
"""A pompom is so wide as a share of what it is on, where nothing says it; """
_LONG: Final = 0.9
"""a tail is so long, as a share of its height."""


def bundles(toy: Assembly, lies: bool, put: Beside) -> list[Hair]:
    """The tail of yarn, the beard, and the pompom of a hat, that the text has one make. lies : whether the toy does; put : knows where its nose is."""
    made: list[Hair] = []
    tail = _TAIL.search(toy.text) if not any("tail" in p.kinds for p in toy.parts) else None
    if tail is not None:
        host = toy.host((toy.main, 1), "body")
        spot = host.near(host.towards(usual("tail", 1, lying=lies)[0].direction))
        group = "made" if tail["made"] else "alone"
        made += _bundle(toy, host, spot, tail[group], Span(tail.start(group), tail.end(group)))
        # What is said of it besides is said of no part.
        words = [(span, toy.text[span.start : span.end]) for span in toy.heard.lost]
        toy.heard.lost[:] = [
            span for span, said in words if not re.search(r"(?<!long )(?<!yarn )\btail\b|\bbundle", said)
        ]
    beard = _BEARD.search(toy.text) if not any("beard" in p.kinds for p in toy.parts) else None
    if beard is not None:
        made += _beard(toy, put, beard["made"], Span(*beard.span("made")))
    hat = next((p for p in toy.parts if p.single and p.kind == "hat" and not p.worn), None)
    tip = _TIP.search(toy.text) if hat is not None else None
    if tip is not None and hat is not None:
        host = toy.host((hat, 1))
        first, last = (float(host.levels[k][0]) for k in (0, -1))
        closed = first if len(host.levels[0][1]) <= len(host.levels[-1][1]) else last
        made += _bundle(toy, host, host.within(Spot(host.name, closed, 1.0)), tip[0], Span(*tip.span()))
    return made


def _beard(toy: Assembly, put: Beside, words: str, span: Span) -> list[Hair]:
    """The strands of a beard below the nose; none where no nose is known."""
    known = put.known.get("nose")
    if known is None or len(toy.text) != len(toy.built.pattern.text.text):
        return []
    made = next((p for p in toy.parts if known[0] in {p.copy(k) for k in range(1, p.copies + 1)}), None)
    if made is None:
        return []
    host, nose = toy.host((made, 1)), np.mean(known[1], axis=0)
    below = float(nose[1]) - put.deep.get("nose", 1.0) - _UNDER_NOSE
    many = max(strands(words) or _STRANDS, 12)
    wide = max(_NARROW, min(_WIDE * float(host.box[1][0]), many * RATIO))
    rise = _RISE * (float(nose[1]) - below)
    spots = [host.near(host.ahead(float(nose[0]) + t * wide, below + t * t * rise)) for t in _ARC]
    color = next(
        (s.colors[-1][1] for s in toy.sentences if s.colors and span.start <= s.span.start < span.end), Hair(()).color
    )
    room = 2.0 * _TRIMMED * (below - float(host.box[0][1] - host.box[1][1])) * toy.stitch
    hangs = min(said_length(words) or room, room)  # trimmed, so that nobody stands on it
    return [Hair(tuple(Spot(s.part, s.round, s.stitch, span) for s in spots), many, round(hangs, 1), color, span)]


def _bundle(toy: Assembly, host: Host, spot: Spot, words: str, span: Span) -> list[Hair]:
    """The strands of one: short all round as a pompom's, or long and hanging."""
    if not toy.stand.there(spot) or len(toy.text) != len(toy.built.pattern.text.text):
        return []
    half = host.box[1] * toy.stitch
    pompom = re.search(_POMPOM, words) is not None
    said = _SIZE.search(words)
    wide = float(length(said[1], said[2])) if said else _OF_BODY * 2.0 * float(half[0])
    hangs = 0.5 * wide if pompom else _LONG * 2.0 * float(np.max(half[1:]))
    nodes = toy.spots.stitches(toy.spots.last(host.part))
    color = tuple(int(c) for c in toy.built.graph.color[nodes[0]]) if len(nodes) else Hair(()).color
    spot = Spot(spot.part, spot.round, spot.stitch, span)
    what = "pompom" if pompom else "tail of yarn"
    toy.made.guessed.append((what, f"{what} on {host.name.split('.')[0]}"))
    many = _TUFTS if pompom else _STRANDS
    return [Hair((spot,), many, round(cut(hangs, toy.stitch), 1), (color[0], color[1], color[2]), span)]
