"""Printed patterns, moved: yarn that is joined elsewhere than where the hook is: at a round made before, or along an edge."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.printed.tokens import Token

_FREE: Final = frozenset(("unused", "unworked", "remaining", "rem", "free", "skipped", "exposed", "leftover"))
_EDGES: Final = frozenset(
    (
        "edge", "side", "edges", "edging", "corner", "corners", "perimeter", "opening", "armhole", "neck", "ends", "sides", "outside",
        "bottom", "tip", "point", "underside", "rows", "waist", "shoulder", "strap", "brim", "center", "centre", "end", "seam",
        "circumference", "border", "top", "piece", "flap", "outer", "inner", "base",
    )
)  # fmt: skip
_LOOPS: Final = ("front loops", "back loops", "loop", "both loops")


@dataclass(frozen=True)
class Moved:
    """Where work goes on: on round ``number`` of the part that ``words`` name (0: the last whose loops were left, ``free``), or along
    an edge that is no round's. ``loops`` : "flo", "blo" or ""."""

    span: Span
    number: int = 0
    before: int = 0
    words: str = ""
    loops: str = ""
    free: bool = False


def moved(tokens: list[Token]) -> Moved | None:
    """Where the words of a clause ("with sl st to front loop of 15th rnd") move the hook to; None where they move it nowhere."""
    if not tokens:
        return None
    span = Span(tokens[0].start, tokens[-1].end)
    number = before = 0
    free = loops = edge = ""
    words: list[str] = []
    for k, token in enumerate(tokens):
        after_it = tokens[k + 1] if k + 1 < len(tokens) else None
        prior = tokens[k - 1] if k else None
        if token.kind == "key" and token.value in ("round", "row"):
            if prior is not None and prior.kind == "ordinal" and isinstance(prior.value, int):
                number = prior.value
            elif after_it is not None and after_it.kind == "number" and isinstance(after_it.value, int):
                number = after_it.value
            elif after_it is not None and after_it.word == "before":
                before = 2
            if token.value == "row" and prior is not None and prior.word in ("of", "end", "ends", "each"):
                edge = "rows"
        elif token.kind == "key" and token.value in _LOOPS:
            loops = {"front loops": "flo", "back loops": "blo"}.get(token.value, "") or loops
            free = free or ("loop" if prior is not None and prior.word in _FREE else "")
        elif token.word in _FREE or (token.kind == "key" and token.value == "rest"):
            near = tokens[k + 1 : k + 4]
            looped = any((t.kind == "key" and t.value in _LOOPS) or t.word in ("loop", "loops") for t in near)
            if looped or token.word in (
                "unworked",
                "skipped",
                "unused",
                "free",
            ):
                free = "loop"
        elif (
            token.word == "end"
            and after_it is not None
            and (after_it.kind == "ordinal" or after_it.value in ("last", "round", "row"))
        ):
            return None  # "at end of last rnd"
        elif token.word in _EDGES or (token.kind == "key" and token.value == "side"):
            if not (token.word in ("top", "end") and _of_chain(tokens[k + 1 :])):
                edge = token.word
        elif token.kind == "word" and token.word not in ("any", "same", "last", "remaining", "evenly"):
            words.append(token.word)
    if any(t.kind == "key" and t.value == "foundation" for t in tokens) or (
        any(t.kind == "stitch" and t.value == "ch" for t in tokens) and not number
    ):
        return Moved(span) if edge or free else None
    if edge and not number:
        return Moved(span)
    if number or before or free:
        return Moved(span, number, before, " ".join(words), loops, bool(free))
    return None


def along_edge(tokens: list[Token]) -> bool:
    """Whether a sentence speaks of an edge as a whole, and of no round: "6 sc evenly up side of Ear to corner"."""
    named = sum(t.word in _EDGES or (t.kind == "key" and t.value in ("side", "thicknesses")) for t in tokens)
    for k, t in enumerate(tokens):
        if t.kind != "key" or t.value not in ("round", "repeat", "as", "ring", "hook") or t.word == "in rnd":
            continue
        counted = (
            k and t.value == "round" and tokens[k - 1].kind == "number"
        )  # "1 rnd of sc evenly around entire edge" names none
        alike = t.value == "as" and any(
            u.word in ("same", "many") for u in tokens[max(0, k - 4) : k]
        )  # "same number of sts as board"
        if not (counted or alike):
            return False
    return bool(named) and not any(t.word in ("sew", "attach", "embroider") for t in tokens)


def _of_chain(tokens: list[Token]) -> bool:
    """Whether "top of" goes on with chains, which stand for a stitch: "in top of beginning ch-3"."""
    return any(t.kind == "stitch" and t.value == "ch" for t in tokens[:4]) or any(
        t.kind == "key" and t.value in ("first", "begin", "foundation") for t in tokens[:2]
    )
