"""The hook: works stitch after stitch into a graph and closes the fabric's faces as it goes (seed 000)."""

from __future__ import annotations

from collections import deque
from itertools import pairwise

from tambour.core.errors import Problem, Span, Text
from tambour.core.graph import BACK, BLO, BOTH, FLO, FRONT, PLAIN, ROOT, TIP
from tambour.crochet.graph.moment import Moment, Round, Strand, Stretches
from tambour.crochet.graph.plainly import TOO_LOW, plainly, strip
from tambour.crochet.language.stitches import JOIN, KNOT, NEXT, OVER, THROUGH, UNDYED, Stitch

LIFT = 5
"""Chains that only lift the yarn for a row or round, at most: a longer chain at a row's end is worked into."""


class HookError(Exception):
    """A step that the hook cannot do, with the Problem that says why."""

    def __init__(self, problem: Problem) -> None:
        super().__init__(problem.message)
        self.problem = problem


class Hook:
    """State of the hook: the seed's global state, and ``now``, its Moment.

    Per node: ``parent``, ``previous``, ``style`` (an index into ``styles``: kind, height, part, colour, loop, direction,
    peculiarity, span) and its anchors, ragged. ``faces`` are triangles, outside counter-clockwise for right-handed work
    (along the round × up the fabric points inside).
    """

    def __init__(self, text: Text) -> None:
        self.text = text
        self.parent: list[int] = []
        self.previous: list[int] = []
        self.style: list[int] = []
        self.anchors: list[int] = []
        self.ends: list[int] = [0]
        self.faces: list[tuple[int, int, int]] = []
        self.face_stretch: list[int] = []
        self.joins: list[tuple[int, int]] = []
        self.aside: dict[int, float] = {}  # stitches in a chain space → how far they stand from their chain
        self.over: list[tuple[int, int, float]] = []  # … and the stitches beside the space, and how far from over them
        self.risen: dict[
            int, tuple[bool, int]
        ] = {}  # first stitches after a turn or a join → whether chains lift them,
        # and how many stitches of the edge they pass
        self.rings: dict[int, int] = {}  # roots of rings of any stitches → how many stand around them
        self.laid: list[tuple[int, int]] = []  # stitches of two layers that one stitch was worked through
        self.lifts: dict[int, None] = {}  # chains that only lift the yarn to the next round or row
        self.waiting: list[Strand] = []  # that are worked once their round is whole
        self.hanging = 0  # nodes that they will make
        self.strung: set[int] = set()  # nodes of strands, which are of no round
        self.styles: list[tuple[str, float, int, tuple[int, int, int], int, int, int, Span]] = []
        self._style_of: dict[tuple[object, ...], int] = {}
        self._looks: dict[tuple[object, ...], list[int]] = {}  # of a stitch at a place of the text
        self.rounds: list[Round] = []
        self.round: list[int] = []
        self.stretches = Stretches()
        self.marks: dict[str, int] = {}
        self.labels: dict[str, tuple[Moment, int]] = {}  # label → its moment and its edge
        self.color: tuple[int, int, int] = UNDYED
        self.part = -1
        self.begun = False
        self.ahead = 0  # anchors left to go once around, from where the line began
        self.joined = 0  # anchors that slip stitches took in this line
        self.now = Moment()
        self.last_mark: str | None = None
        self.span = Span(0, 0)
        self.trailing = False  # the last round has just been worked whole, in the line under way
        self.first = 0
        self.piece = (0, 0)  # the first node and the first face of the part
        self._picots = 0  # chains of picots, which are no stitches of the round
        self._number = 0
        self.written = 0  # the number of the line under way, 0 for none
        self._beside = False  # a chain begins another piece beside what the part holds
        self._chained: Round | None = None  # the last round, when it is a foundation chain

    def fail(self, message: str, hint: str = "", span: Span | None = None) -> HookError:
        """The error to raise at the action under way."""
        return HookError(Problem(message, hint, span or self.span, self.text))

    def __len__(self) -> int:
        return len(self.parent)

    # -- parts and rounds -------------------------------------------------------------------------------------------

    def begin_part(self) -> None:
        """A new part: fresh moment, loops both."""
        self.part += 1
        self.begun = False
        self.now = Moment(stretch=self.stretches.begin())
        self.first, self._picots, self._number, self._chained = len(self), 0, 0, None
        self.piece = len(self), len(self.faces)
        self.written, self._beside = 0, False

    def begin_line(self) -> None:
        """A line that is a round begins: what was skipped at the end of the last one stays skipped."""
        if self.now.left <= 0 < self.now.count and len(self) > self.first and not self.now.chain:
            self.end_round(True)
        self.ahead, self.joined, self.trailing = self.now.count, 0, False

    def end_part(self) -> None:
        """Closes the round under way."""
        self.end_round(False)

    def end_round(self, whole: bool) -> None:
        """The nodes since the last round's end become a round; anchors that lie ahead are the next round's."""
        first, last = self.first, len(self) - 1
        if first <= last:
            while first <= last and self.styles[self.style[first]][6] == ROOT:
                first += 1
            top = last
            while top >= first and self.styles[self.style[top]][6] == TIP:
                top -= 1
            if first <= top:
                self._count_round(first, top, first > self.first)
                at = self.ends[first]
                under = self.anchors[at] if self.ends[first + 1] > at else self.previous[first]
                below = self.round[under] if 0 <= under < len(self.round) else -1
                self.rounds.append(
                    Round(
                        self.part,
                        self._number,
                        first,
                        top,
                        top + 1 - first - self.lifting(first, top + 1) - self._picots,
                        self.styles[self.style[first]][7],
                        below,
                        whole,
                    )
                )
                if self.ends[top + 1] == self.ends[first]:
                    self._chained = self.rounds[-1]
            self.round += [len(self.rounds) - 1] * (len(self) - len(self.round))
        self.first, self._picots = len(self), 0
        self.now.left = self.now.count
        self.trailing = False

    def lifting(self, first: int, end: int) -> int:
        """How many of the nodes ``first`` to before ``end`` are chains that only lift the yarn."""
        return sum(map(self.lifts.__contains__, range(first, end))) if self.lifts else 0

    def round_done(self) -> None:
        """The round below is used up."""
        self.end_round(True)
        self.trailing = True

    def bridged(self) -> None:
        """The chain just made to another edge bears no number of its own where a round follows on its line."""
        self._chained = self.rounds[-1] if self.rounds else None

    def _count_round(self, first: int, last: int, ringed: bool) -> None:
        """The number of a round: the one written on its line, where that is larger than the last, or a ring or a chain begins beside
        what is there: the second of two legs. Else one more. A chain that the round stands on is round 0, or the number before."""
        beside, self._beside = ringed or self._beside, self.ends[last + 1] == self.ends[first]
        if self.written > self._number or (beside and 0 < self.written < self._number):
            self._number = self.written
        elif self._chained is not None and 0 < self.written == self._number:
            self._chained.number -= 1
        elif self._number or self.ends[last + 1] > self.ends[first]:
            self._number += 1
        self._chained = None

    def need_start(self) -> None:
        """HookError before the part has begun."""
        if not self.begun:
            raise self.fail("a part begins with a magic ring or a chain", "write MR(6) or ch(12) first")

    # -- nodes ------------------------------------------------------------------------------------------------------

    def look(self, kind: str, height: float, peculiarity: int = PLAIN) -> int:
        """The style index of nodes made by the action under way."""
        now = self.now
        key = (kind, height, self.part, self.color, now.loop, now.direction, peculiarity, self.span)
        found = self._style_of.get(key)
        if found is None:
            found = self._style_of[key] = len(self.styles)
            self.styles.append((kind, height, self.part, self.color, now.loop, now.direction, peculiarity, self.span))
        return found

    def node(self, style: int, anchors: list[int], previous: int, parent: int) -> int:
        """A new node; gives its index."""
        self.parent.append(parent)
        self.previous.append(previous)
        self.style.append(style)
        self.anchors += anchors
        self.ends.append(len(self.anchors))
        return len(self.parent) - 1

    def face(self, a: int, b: int, c: int) -> None:
        """A triangle of the fabric, unless it has no extent; turned rows are seen from their back."""
        if a != b and b != c and a != c:
            self.faces.append((a, b, c) if self.now.direction > 0 else (b, a, c))
            self.face_stretch.append(self.now.stretch)

    def fill(self, path: list[int]) -> None:
        """The triangles between the hook's node ``path[0]`` and the rest of ``path``, a closed stretch of the edge."""
        for a, b in pairwise(path[1:]):
            self.face(b, a, path[0])

    def magic_ring(self, size: int) -> None:
        """A root and ``size`` stitches into it, a fan round it; the ring's end is joined by the next round."""
        self.end_round(False)
        self.begun = True
        now = self.now = Moment(loop=self.now.loop, stretch=self.stretches.begin())
        root = self.node(self.look("ring", 0.0, ROOT), [], -1, -1)
        look = self.look("sc", 1.0)
        first = len(self)
        for k in range(size):
            self.node(look, [root], first + k - 1 if k else -1, root)
        for k in range(1, size):
            self.face(root, first + k - 1, first + k)
        self.face(root, first + size - 1, first)
        now.front, now.count, now.spine = deque(range(first, first + size)), size, [first + size - 1]
        self.joined = 0
        self.end_round(True)
        self.ahead = size

    def stitch(self, stitch: Stitch, times: int) -> None:
        """``stitch``, ``times`` in a row, into anchor after anchor. Errors are raised at the action under way."""
        if not self.begun and stitch.name == "ch":
            self.foundation()
        self.need_start()
        now = self.now
        if stitch.pulls:
            self.begin_stretch()
        key = (id(stitch), id(self.span), self.part, self.color, now.loop, now.direction)
        looks = self._looks.get(key)
        if looks is None:
            looks = [self.look(m.kind, m.height, self.single()) if m.what == OVER else -1 for m in stitch.moves]
            self._looks[key] = looks
        if stitch.takes == stitch.makes == 1 and len(looks) == 2:
            plainly(self, looks[1], times)
            return
        front = now.front
        faces, stretches, stretch, forward = self.faces, self.face_stretch, now.stretch, now.direction > 0
        for _ in range(times):
            spine = now.spine
            path = spine[::-1]
            pulled: list[int] = []
            touched = False
            for move, look in zip(stitch.moves, looks):
                what = move.what
                if what == OVER:
                    c = len(self.parent)
                    if pulled:
                        parent = pulled[-1]
                        if now.loop != BOTH and self.parent[parent] < 0:
                            raise self.fail(*TOO_LOW)
                        self.node(look, pulled, path[0], parent)
                        if now.starting:
                            self.rise(c, path)
                        pulled = []
                        strip(faces, stretches, stretch, forward, path, c)
                        front.append(c)
                        now.count += 1
                        path = [c, path[-1]]
                    else:
                        self.node(look, [], path[0] if path else -1, -1)
                        if now.starting:
                            self.lifts[c] = None
                            if now.ring:
                                front.append(~c)
                        else:
                            self.chained(c, move.kind != "picot")
                        path.insert(0, c)
                    continue
                if what == KNOT:
                    self.knot(path)
                    continue
                while front and front[0] < 0:
                    path.append(~front.popleft())
                if not front:
                    raise self.used_up()
                anchor = front[0]
                if what == NEXT:
                    front.popleft()
                    self.used(1)
                    if path[-1] != anchor:
                        path.append(anchor)
                    touched = False
                    continue
                if path[-1] != anchor:
                    path.append(anchor)
                touched = True
                if what == THROUGH:
                    pulled.append(anchor)
                elif what == JOIN:
                    if now.starting and now.ring:
                        # Slip stitches before a round carry the yarn along the edge, which stays as it is.
                        while len(path) > 1 and len(front) > 1 and front[-2] in (path[1], ~path[1]):
                            front.pop()  # back down chains just made, which stand off the edge
                            path.pop(0)
                        front.extend(~n for n in path[1:])
                        path = [anchor]
                    else:
                        self.tie(path)
                        path = [path[0], anchor]
                    self.joined += 1
            if touched:
                front.popleft()
                self.used(1)
            path.reverse()
            now.spine = path
            if now.left <= 0 and touched:
                self.round_done()

    def rise(self, node: int, path: list[int]) -> None:
        """``node`` is the first of a round or row; the yarn comes from the head of ``path``, on the edge below it, or from
        chains that lift it, and goes as far along as the rest of ``path``."""
        chains = 0
        while chains < len(path) - 1 and self.ends[path[chains] + 1] == self.ends[path[chains]]:
            chains += 1
        self.risen[node] = (chains > 0, len(path) - 1 - chains)
        self.now.starting = False

    def chained(self, node: int, anchor: bool) -> None:
        """Puts a chain on the edge. One that follows a round's last stitch in the same line is still of that round."""
        now = self.now
        now.front.append(node if anchor else ~node)
        now.count += anchor
        self._picots += not anchor
        if self.trailing and self.first == node:
            this = self.rounds[-1]
            this.last, this.count = node, this.count + anchor
            self.round.append(len(self.rounds) - 1)
            self.first = node + 1
            self._picots, now.left = 0, now.left + anchor

    def used_up(self) -> HookError:
        """The error of an edge without anchors."""
        return self.fail(
            "there is no stitch left to work into", "begin with a ring or a chain, or say which round this is worked on"
        )

    def knot(self, path: list[int]) -> None:
        """Ties the picot at the head of ``path`` to the stitch that it began at."""
        base = next((n for n in path if self.styles[self.style[n]][0] != "picot"), path[0])
        if base != path[0]:
            self.joins.append((path[0], base))

    def tie(self, path: list[int]) -> None:
        """Joins the hook's node to the end of ``path`` and closes what is between; a chain that stands there is tied too."""
        self.fill(path)
        self.joins.append((path[0], path[-1]))
        if len(path) > 2 and path[-2] in self.lifts:
            self.joins.append((path[0], path[-2]))

    def used(self, anchors: int) -> None:
        """Anchors that are on the edge no more."""
        self.now.count -= anchors
        self.now.left -= anchors
        self.ahead -= anchors

    def single(self) -> int:
        """The peculiarity of a stitch worked into the present loops."""
        return {BOTH: PLAIN, FRONT: FLO, BACK: BLO}[self.now.loop]

    def foundation(self) -> None:
        """A chain begins a piece of work."""
        self.end_round(False)
        self.begun = True
        self.now = Moment(loop=self.now.loop, stretch=self.stretches.begin(), chain=True)

    def begin_stretch(self) -> None:
        """Stitches are worked into the present stretch from here on; a foundation chain becomes a ring."""
        if self.now.chain:
            self.now.chain = False
            self.now.spine = self.now.spine[-1:]
            self.end_round(False)
        elif self.now.left <= 0 < self.now.count and len(self) > self.first:
            self.end_round(True)  # its last stitches were skipped
        stretch = self.stretches.all[self.now.stretch]
        if not stretch.begun:
            stretch.begun, stretch.back = True, self.now.loop == BACK

    # -- the edge ---------------------------------------------------------------------------------------------------

    def loops(self, loop: int) -> None:
        """The loops that stitches go into from here on."""
        self.need_start()
        self.now.loop = loop

    def need_edge(self, word: str) -> None:
        """HookError unless there is an edge that the action ``word`` can work on."""
        self.need_start()
        if self.now.count == 0:
            raise self.fail(
                f"there is no edge to {word}",
                "the work was fastened off: begin with a ring or a chain, or say which round this is worked on",
            )

    def mark(self, label: str) -> None:
        """Keeps the moment, to come back to."""
        self.need_start()
        now = self.now
        if now.count == 0:
            raise self.fail("this mark is of no use: no stitch is left to work into", "mark before FO")
        if label in self.labels:
            raise self.fail(f'there is a mark "{label}" already', "a mark in a repeated round is set once too often")
        edge = self.stretches.edge(now.stretch)
        self.labels[label] = (now.copy(), edge)
        self.marks[label] = now.spine[-1]
        now.stretch = self.stretches.begin(edge)
        self.last_mark = label

    def goto(self, label: str) -> None:
        """Back to a kept moment; the next stitch links to the one before the mark."""
        self.need_start()
        moment, edge = self.labels[label]
        self.end_round(False)
        self.now = moment.copy()
        self.now.stretch = self.stretches.begin(edge)
        self.end_round(False)
        self.ahead, self.joined = self.now.count, 0
