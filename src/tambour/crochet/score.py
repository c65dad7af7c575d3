"""Score: how near the plush of each of many patterns comes to a shape; for whoever searches among patterns."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from tambour.core.errors import TambourError, Text
from tambour.core.progress import Progress
from tambour.crochet.params import CrochetParams

if TYPE_CHECKING:
    from tambour.core.mesh import Mesh
    from tambour.crochet.model.distance import Target
    from tambour.crochet.model.outline import Outline


@dataclass(frozen=True, slots=True)
class Score:
    """How near a plush comes to a shape, in stitches; inf where there is no plush, ``reason`` says why.

    mean : of both surfaces, each from the other: the smaller, the better; p95, largest : of 100 points 95, and all, are nearer
    stitches : of the pattern; settled : whether its shape is at rest

    >>> min([Score(0.7), Score(0.3), Score(float("inf"), reason="no ring")], key=lambda one: one.mean).mean
    0.3
    """

    mean: float
    p95: float = float("inf")
    largest: float = float("inf")
    stitches: int = 0
    settled: bool = False
    reason: str = ""


def score(
    patterns: Iterable[Text | str], target: Mesh | Outline | Target, params: CrochetParams | None = None
) -> Iterator[Score]:
    r"""The score of every pattern, in order, as they are asked for; a pattern that cannot be worked has one too.

    patterns : texts, in tambour's own language or printed; they are worked, stuffed and sewn, their yarn is not led
    target : a mesh in mm, upright (+y), its front at +z; or an :class:`Outline`, turned about its axis; or, for many calls,
        :func:`aimed_at` of one
    params : gauge and stuffing

    The plush is turned about the upright and moved as is best, never scaled. The same numbers for any number of threads.

    >>> from tambour.crochet.model.outline import formula
    >>> ball = formula(Text("r = sqrt(max(0, 900 - (z - 30) ** 2))\nheight = 60"))
    >>> rounds = "R1: MR(6)\nR2: 6 inc\nR3: [sc, inc] x 6\nR4: [2 sc, inc] x 6\nR5: [3 sc, inc] x 6\nR6: [4 sc, inc] x 6"
    >>> ends = "[4 sc, dec] x 6\n: [3 sc, dec] x 6\n: [2 sc, dec] x 6\n: [sc, dec] x 6\n: 6 dec\nFO"
    >>> tries = [f"{rounds}\n{plain}: 36 sc\n: {ends}" for plain in (2, 6, 12)] + ["R1: 6 sc"]
    >>> found = list(score(tries, ball))
    >>> [one.mean < 0.5 for one in found], found[3].reason
    ([False, True, False, False], 'a part begins with a magic ring or a chain')
    """
    from tambour.crochet.finish.covered import seen
    from tambour.crochet.model.aim import lain
    from tambour.crochet.plush import make

    told = params or CrochetParams()
    aim = aimed_at(target)
    for pattern in patterns:
        text = pattern if isinstance(pattern, Text) else Text(pattern, "pattern")
        try:
            piece = make(text, told, Progress())
        except TambourError as error:
            yield Score(float("inf"), reason=error.problems[0].message)
            continue
        graph = piece.built.graph
        faces = seen(graph, piece.positions, piece.shape.joined, graph.faces[piece.built.shell])
        if not len(faces):
            yield Score(float("inf"), reason="the pattern makes no fabric")
            continue
        found = lain(aim, piece.positions, faces)
        unit = piece.stitch[0]
        count = len(graph)
        yield Score(found.mean / unit, found.p95 / unit, found.largest / unit, count, piece.shape.settled)


def aimed_at(target: Mesh | Outline | Target) -> Target:
    r"""A shape made ready to be measured against, again and again. Raises TambourError for a mesh without faces.

    >>> from tambour.crochet.model.outline import formula
    >>> round(aimed_at(formula(Text("r = 20\nheight = 30"))).size, 1)
    64.0
    """
    from tambour.crochet.model.distance import Target as Ready
    from tambour.crochet.model.outline import Outline as Drawn

    if isinstance(target, Ready):
        return target
    if isinstance(target, Drawn):
        from tambour.crochet.model.profile import swept

        return Ready.of(*swept(target))
    if not len(target.faces):
        raise TambourError("the target has no surface", hint="a mesh of triangles is wanted")
    return Ready.of(target.vertices, target.faces)
