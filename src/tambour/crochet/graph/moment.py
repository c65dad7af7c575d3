"""Moment: the edge being worked and where on it the hook is (seed 000, "Moments"); the rounds and stretches of fabric.

The edge of the fabric is a walk ``spine → front → back to the hook``. ``front`` holds what lies ahead: anchors, and, as
``~node``, nodes on the edge that are not worked into. ``spine`` is the way from the last anchor worked into up to the
hook. The strip between them is what the next stitch closes.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, field

from tambour.core.errors import Span
from tambour.core.graph import BOTH
from tambour.crochet.language.stitches import Stitch


@dataclass(slots=True)
class Moment:
    """The currently worked edge.

    front : what lies ahead, the next anchor first; ~node: on the edge, but no anchor
    count : anchors in ``front``
    spine : nodes from the last anchor up to the hook; the last is the previous stitch
    loop, direction : the loops worked into; +1, or -1 after a turn
    ring : the edge closes on itself (False: rows)
    chain : nothing but a foundation chain so far; a turn makes rows of it, a stitch makes a ring of it
    left : anchors of the round below that are still to be worked
    stretch : the stretch that new faces belong to
    starting : chains made now only lift the yarn to the next round or row
    bridge : the spine of the edge that a direct ``attach`` came from, and the node it made
    folded : the edge lies flat, and stitches go through both its layers
    hand : the node that the yarn comes from while the edge is folded, -1 for the last of ``spine``
    spare : the last anchor of an oval's base, which may be left out (the first stitch went into it too); -1 for none
    """

    front: deque[int] = field(default_factory=deque)
    count: int = 0
    spine: list[int] = field(default_factory=list)
    loop: int = BOTH
    direction: int = 1
    ring: bool = True
    chain: bool = False
    left: int = 0
    stretch: int = 0
    starting: bool = False
    bridge: tuple[list[int], int] | None = None
    folded: bool = False
    spare: int = -1
    hand: int = -1

    def copy(self) -> Moment:
        """The same moment, to go back to."""
        return Moment(
            deque(self.front),
            self.count,
            list(self.spine),
            self.loop,
            self.direction,
            self.ring,
            self.chain,
            self.left,
            self.stretch,
            self.starting,
            self.bridge,
            self.folded,
            self.spare,
            self.hand,
        )


@dataclass(slots=True)
class Round:
    """Nodes ``first`` to ``last`` of one round (or, in rows, one row).

    number : from 1 within its part; count : its stitches, lifting chains aside; span : the text of its first stitch
    below : the round it is worked into (an index), -1 for a ring or a chain
    whole : it used up the round below; aside : it is no round, but strands that hang off one
    """

    part: int
    number: int
    first: int
    last: int
    count: int
    span: Span
    below: int
    whole: bool
    aside: bool = False


@dataclass(frozen=True, slots=True)
class Strand:
    """A chain to be worked off the node ``base``, and back along: ``inner``, the chain first; its yarn, its place in the text and the
    number of its round."""

    base: int
    inner: tuple[tuple[Stitch, int], ...]
    color: tuple[int, int, int]
    span: Span
    number: int


@dataclass(slots=True)
class Stretch:
    """A stretch of fabric between two places where the work can fork (a mark, an attach, a ring).

    ends : edges (ids) it leaves for others to go on from; an edge that nobody goes on from stays open
    shut : an FO drew its edge together
    begun : a stitch has been worked into it
    faces : how many of its own
    back : its first round is worked into back loops only
    aside : it hangs off the fabric, and is never its outside
    """

    ends: list[int] = field(default_factory=list)
    shut: bool = False
    begun: bool = False
    faces: int = 0
    back: bool = False
    aside: bool = False


class Stretches:
    """The stretches of one part and the edges between them.

    A ``goto`` back to an edge that was worked on already gives that edge a second stretch: the fabric branches, and only
    one of the two is the outside. :meth:`shell` says which stretches the outside is made of.
    """

    def __init__(self) -> None:
        self.all: list[Stretch] = []
        self.followers: list[list[int]] = []  # edge → stretches that go on from it

    def begin(self, *edges: int) -> int:
        """A new stretch that goes on from ``edges`` (none: from a ring or a chain)."""
        self.all.append(Stretch())
        number = len(self.all) - 1
        for edge in edges:
            self.followers[edge].append(number)
        return number

    def edge(self, stretch: int) -> int:
        """A new edge at which ``stretch`` may be gone on from."""
        self.followers.append([])
        self.all[stretch].ends.append(len(self.followers) - 1)
        return len(self.followers) - 1

    def shell(self) -> list[bool]:
        """For each stretch, whether it is part of the outside.

        Of the stretches that go on from one edge, one is taken: rather one that ends up shut, then one that is not worked
        into back loops (those lie inside), then the one with most faces.
        """
        n = len(self.all)
        faces, shut = [0] * n, [False] * n
        chosen: dict[int, int] = {}
        # A stretch's followers are younger than it, so the youngest are settled first.
        for k in range(n - 1, -1, -1):
            stretch = self.all[k]
            faces[k] = stretch.faces
            for edge in stretch.ends:
                after = [f for f in self.followers[edge] if faces[f]]
                if after:
                    chosen[edge] = max(after, key=lambda f: (shut[f], not self.all[f].back, faces[f], -f))
                    faces[k] += faces[chosen[edge]]
            ended = [edge in chosen and shut[chosen[edge]] for edge in stretch.ends]
            shut[k] = stretch.shut or (bool(ended) and all(ended))
        outside = [False] * n
        followed = {f for fs in self.followers for f in fs}
        todo = [k for k in range(n) if k not in followed and not self.all[k].aside]
        while todo:
            k = todo.pop()
            if not outside[k]:
                outside[k] = True
                todo += [chosen[e] for e in self.all[k].ends if e in chosen]
        return outside
