"""Improve: a pattern that a person wrote, brought nearer to a shape, with as much of it kept as may be."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from tambour.core.errors import Problem, TambourError, Text
from tambour.core.progress import Progress
from tambour.crochet.params import CrochetParams
from tambour.crochet.score import Score, aimed_at, score

if TYPE_CHECKING:
    from tambour.core.mesh import Mesh
    from tambour.crochet.model.outline import Outline

TRIES = 4
"""How often a pattern is corrected at the most."""
GAIN = 0.01
"""A mean distance that is smaller by less than this, in stitches, is no better."""


@dataclass(frozen=True, slots=True)
class Improved:
    """text : the pattern, the same as before where nothing came nearer; before, after : its scores; history : of all tries, the mean.

    >>> Improved(Text("R1: MR(6)"), Score(1.5), Score(0.2), (1.5, 0.4, 0.2)).after.mean
    0.2
    """

    text: Text
    before: Score
    after: Score
    history: tuple[float, ...]


def improve(
    pattern: Text | str,
    target: Mesh | Outline,
    params: CrochetParams | None = None,
    *,
    warn: Callable[[Problem], None] = lambda problem: None,
    tries: int = TRIES,
) -> Improved:
    r"""The pattern with its rounds changed so that its plush is like ``target``: rounder here, longer there.

    pattern : one part, in rounds from a magic ring; target : a mesh in mm, upright, or an outline
    params : gauge and stuffing; warn : is told what of her rounds could not be kept

    The target's outline, its girths about the upright, is given to the part (:func:`tambour.crochet.model.reshape.reshaped`): rounds
    that fit stay, and so does all other text. What it then still lacks at rest is corrected, and the nearest is given.
    Raises TambourError for a pattern that cannot be reshaped.

    >>> from tambour.crochet.model.outline import formula
    >>> egg = formula(Text("r = 25 * sin(pi * t) * (1.2 - 0.4 * t)\nheight = 60"))
    >>> mine = "# my ball\nR1: MR(6)\nR2: 6 inc\nR3: [sc, inc] x 6\nR4-R8: 18 sc\nR9: [sc, dec] x 6\nR10: 6 dec\nFO"
    >>> made = improve(mine, egg)
    >>> made.before.mean > 1.0, made.after.mean < 0.3, made.text.text.split("\n")[:2]
    (True, True, ['# my ball', 'R1: MR(6)'])
    """
    from tambour.crochet.model.outline import Outline as Drawn
    from tambour.crochet.model.profile import girths
    from tambour.crochet.model.reshape import reshaped
    from tambour.crochet.plush import make

    told = params or CrochetParams()
    text = pattern if isinstance(pattern, Text) else Text(pattern, "pattern")
    aim = aimed_at(target)
    line = target if isinstance(target, Drawn) else girths(target)
    before = next(score([text], aim, told))
    if before.reason:
        make(text, told, Progress())  # tells what is wrong, with its place
    best, found, history, now = before, text, [before.mean], text
    for _ in range(tries):
        piece = make(now, told, Progress())
        if len(piece.built.pattern.parts) != 1:
            names = ", ".join(p.name for p in piece.built.pattern.parts)
            raise TambourError(
                f"the pattern has several parts: {names}", hint="improve them one by one", where=text.name
            )
        doubts: list[Problem] = []
        new = reshaped(piece.built, [line], "", told, piece.stitch, doubts.append)
        if new.text == now.text:
            break
        now = new
        one = next(score([now], aim, told))
        history.append(one.mean)
        if one.mean < best.mean - GAIN:
            best, found = one, now
            for doubt in doubts:
                warn(doubt)
        elif len(history) > 2:
            break
    return Improved(found, before, best, tuple(history))
