"""Played: a toy under the hand, a move at a time: stitches pulled and pinned, or the piece worked one by one while it moves.

Nothing here changes a piece: what is kept is always what the pattern makes.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.core.packed import Packed
from tambour.crochet.piece import Plush
from tambour.crochet.settle.body import Body, State, build, centroid_counts

MOST = 60
"""Evaluations after each word of the hand: by then what it pulls has come to rest, or is on its way."""

STANDS = 8
"""While nothing is pinned, the eighth of the stitches that is farthest from the hand stays: else all would go with it."""
WHOLE = 8.0
"""Seconds that a piece takes at the least to be worked one by one: it is done to be seen."""


def _worked(piece: Plush) -> tuple[Body, Array]:
    """The piece's body before anything is sewn on, and how many centroids each part has."""
    graph, width = piece.built.graph, piece.stitch[0]
    shell = replace(graph, faces=graph.faces[piece.built.shell])
    counts = centroid_counts(shell, piece.params, [part.centroids for part in piece.built.parts])
    used = counts if piece.stuffing == "centroid" else np.zeros_like(counts)
    return build(shell, piece.params, width, piece.stuffing, used), used


class Held:
    """A finished toy, some of whose stitches a hand holds or pins; the rest follows, and goes back when it lets go.

    It is moved by the settling that shaped it, of the very body that came to rest there. A shape that was not
    settled (--solver steps, none) finds its own while it is held, and is as it was when it is let go.
    """

    def __init__(self, piece: Plush) -> None:
        self.width = piece.stitch[0]
        self.body = piece.shape.body() or _worked(piece)[0]
        self.state = State(piece.positions / self.width, piece.centroids / self.width, np.zeros(len(self.body.amount)))
        self.rest = self.state.x.copy()
        self.pins: set[int] = set()
        self.grab: Array = np.zeros(0, int)
        self.stand: Array = np.zeros(0, int)
        self._work: Generator[Any, None, Any] | None = None
        self._solves: dict[bytes, Callable[[Array], Array]] = {}

    @property
    def moving(self) -> bool:
        """Whether it is not yet at rest."""
        return self._work is not None

    @property
    def free(self) -> bool:
        """Whether nothing holds it."""
        return not self.pins and not len(self.grab)

    def hear(self, word: Mapping[str, Any]) -> None:
        """A word of the hand: ``hold`` a node at x, y, z mm, ``pin`` a node or let its pin go, ``release`` what is held,
        ``loose``: let all go."""
        kind, node = word["type"], int(word.get("node", -1))
        if kind in ("hold", "pin") and not 0 <= node < len(self.body):
            return
        if kind == "hold":
            if not len(self.grab) or self.grab[0] != node:
                a, b = self.body.edges[:, 0], self.body.edges[:, 1]
                self.grab = np.array([node, *np.unique(np.r_[a[b == node], b[a == node]])])
                far = ((self.rest - self.rest[node]) ** 2).sum(1)
                self.stand = np.argsort(far, kind="stable")[-max(1, len(far) // STANDS) :]
            to = np.array([word["x"], word["y"], word["z"]], np.float64) / self.width
            self.state.x = self.state.x.copy()
            self.state.x[self.grab] += to - self.state.x[node]
        elif kind == "pin":
            self.pins ^= {node}
        elif kind == "release":
            self.grab = np.zeros(0, int)
        elif kind == "loose":
            self.grab, self.pins = np.zeros(0, int), set()
        self._begin()

    def _begin(self) -> None:
        from tambour.crochet.settle.rest import laplacian, settle, tolerance

        held = np.zeros(len(self.body), bool)
        held[[*self.grab.tolist(), *self.pins]] = True
        if len(self.grab) and not self.pins:
            held[self.stand] = True
        key = np.packbits(held).tobytes()
        if key not in self._solves:
            self._solves = {key: laplacian(self.body, held)}
        self.state.listed = None
        goal = 10.0 * tolerance(len(self.body))
        self._work = settle(self.body, self.state, goal, MOST, held, self._solves[key])

    def move(self) -> float:
        """One move, and seconds to wait after it; the last one brings back exactly what nothing holds any more."""
        assert self._work is not None
        try:
            next(self._work)
        except StopIteration:
            self._work = None
            if self.free:
                self.state.x = self.rest.copy()
        return 0.0

    def seen(self) -> Packed:
        """``positions`` (N, 3) mm as they are."""
        return Packed({"positions": (self.state.x * self.width).astype(np.float32)}, {"pins": sorted(self.pins)})


class Worked:
    """The piece worked one by one while it moves, as ``--start one-by-one`` does: it plays, goes on by a stitch, begins anew."""

    def __init__(self, piece: Plush) -> None:
        self.piece, self.width = piece, piece.stitch[0]
        self.whole, self.counts = _worked(piece)
        self.playing, self.wanted = False, 0
        self._anew()

    def _anew(self) -> None:
        from tambour.crochet.settle.plain_steps import Building

        p = self.piece.params
        self.work = Building(
            self.piece.built.graph,
            self.whole,
            p.link_distance,
            p.wait_force,
            p.wait_steps,
            self.counts,
            p.nodes_per_centroid,
        )
        self.work.grow()

    @property
    def moving(self) -> bool:
        """Whether it goes on by itself."""
        return (self.playing or len(self.work.body) < self.wanted) and not self.work.done

    @property
    def free(self) -> bool:
        """Whether nothing is asked of it."""
        return False

    def hear(self, word: Mapping[str, Any]) -> None:
        """``play``, ``pause``, ``step`` (by ``count`` stitches) or ``restart``."""
        kind = word["type"]
        if kind == "restart":
            self.wanted = 0
            self._anew()
        elif kind == "step":
            self.playing, self.wanted = False, len(self.work.body) + max(1, int(word.get("count", 1)))
        else:
            self.playing = kind == "play"
            self.wanted = 0

    def move(self) -> float:
        """One step of all that is worked, with the next node where it is time, and seconds to wait after it."""
        before = len(self.work.body)
        self.work.tick()
        return WHOLE / len(self.whole) if len(self.work.body) > before else 0.0

    def seen(self) -> Packed:
        """``positions`` (M, 3) mm of what is worked."""
        facts = {"done": len(self.work.body), "total": len(self.whole)}
        return Packed({"positions": (self.work.state.x * self.width).astype(np.float32)}, facts)
