"""Shape: from a stitch graph to its shape, by the way that was asked for; step by step, for whoever looks on."""

from __future__ import annotations

from collections.abc import Callable, Generator
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from tambour.core.check import Array
from tambour.core.digest import digest
from tambour.core.graph import StitchGraph
from tambour.core.packed import Packed
from tambour.crochet.finish.limp import lain, limbs
from tambour.crochet.finish.stood import at_rest, clad, on_its_feet, standing, upright
from tambour.crochet.graph.layout import on_axis, rounds
from tambour.crochet.graph.sided import sided, turned_by
from tambour.crochet.settle.arrange import arrange, clusters, cut, parts
from tambour.crochet.settle.body import Body, State, build, displacement, volumes
from tambour.crochet.settle.laid import Sheets, braced, flattened, laid
from tambour.crochet.settle.snug import pressed, snug
from tambour.geometry.motion import fit, turned

if TYPE_CHECKING:
    from tambour.crochet.finish.joining import Joined, Joining
    from tambour.crochet.params import CrochetParams
    from tambour.crochet.settle.rest import Rest

GRAIN = 9
"""Decimals, in stitches, that positions have where settling begins: the last bits of a sine or a root depend on the
machine, and a soft shape would enlarge them."""
ROUGHLY = 30.0
"""How many times farther from rest a shape may be that only tells how far stuffing stretches it."""
FALLEN = 0.9
"""The cosine of the angle from which on a part has fallen over while it settled."""
BUILDING = 60_000_000
"""Node-steps that building one by one may take before settling, some 4,000 stitches in 20 s; what is left then comes at once."""


@dataclass(frozen=True, eq=False, slots=True)
class Shape:
    """Positions x (N, 3) and centroids c (C, 3), of parts first (P + 1,), all in stitches; and how it was reached.

    residual : largest force left, in stitches; move : rms of the last quasi-Newton move; volume (P,)
    settled : the goal was reached (for steps and none: nothing was promised)
    hurried : building one by one was cut short; worked : the nodes that had their place by then
    joined : how placed parts were sewn on, None where none are; x there is from before they settled together
    task : what was brought to rest at last: with its seams, and stuffed as its parts hold it; None where nothing was settled
    """

    x: Array
    c: Array
    residual: float
    move: float
    evaluations: int
    settled: bool
    volume: Array
    hurried: bool = False
    worked: int = -1
    joined: Joined | None = None
    task: Task | None = None

    def body(self) -> Body | None:
        """The body that is at rest in ``x`` and ``c``: what pulls at it now meets the forces that shaped it."""
        if self.task is None:
            return None
        body = self.task.body(self.task.graph, self.task.used)
        if self.joined is not None:
            body = self.joined.on(body, np.arange(len(body)))
        return body


@dataclass(frozen=True, eq=False, slots=True)
class Look:
    """A glance at the work: positions x (M, 3), in stitches, of the nodes that are there; done of total."""

    x: Array
    done: int
    total: int


Shaping = Generator[Look, None, Shape]


Known = dict[str, tuple[Array, Array, "Rest", Array]]
"""What a body of fabric is, where it begins and how it is stuffed → its nodes and centroids at rest, about its first node as it was; how
it came to rest; and its volumes."""


@dataclass(frozen=True, eq=False, slots=True)
class Task:
    """A graph and how to shape it.

    width : mm per stitch; counts (P,) centroids of each part
    snug : settled parts keep the size of their gauge (:mod:`tambour.crochet.settle.snug`) instead of what springs give way
    joining : the parts to be placed; laid : those that hands lay smooth, by name
    known : how parts came to rest by themselves, by what they are: for several tasks that differ only in how parts are placed
    """

    graph: StitchGraph
    params: CrochetParams
    width: float
    stuffing: str
    start: str
    counts: Array
    snug: bool = False
    joining: Joining | None = None
    laid: frozenset[str] = frozenset()
    known: Known | None = None

    def body(self, graph: StitchGraph, counts: Array) -> Body:
        """The body of ``graph``, a cut of this task's."""
        return build(graph, self.params, self.width, self.stuffing, counts, self.laid)

    @property
    def used(self) -> Array:
        """Centroids that there are: none but with centroid stuffing."""
        return self.counts if self.stuffing == "centroid" else np.zeros_like(self.counts)


def first_positions(task: Task) -> tuple[Array, Array]:
    """First positions by rounds (N, 3), parts apart and each about its own axis, and centroids (C, 3) on the axes."""
    graph = task.graph
    x = rounds(graph, graph.rest / task.width) * task.params.link_distance
    if task.joining is not None:
        spots = task.joining.spots
        x = turned_by(spots, sided(spots, x), spots.turns)
    made = [on_axis(x, p.start, p.end, int(k)) for p, k in zip(graph.parts, task.used) if k]
    return x, np.concatenate(made) if made else np.zeros((0, 3))


def placed(task: Task, x: Array, c: Array) -> tuple[Task, Array, Array, Joined | None]:
    """Every part moved as a whole to where it belongs: the task with its seams, positions and centroids."""
    from tambour.crochet.finish.joining import join, with_seams

    joined, moved = None, x
    if task.joining is not None and task.joining.joins:
        joined = join(task.joining, x, parts(task.graph))
        moved = joined.x
        task = replace(task, graph=with_seams(task.graph, np.concatenate(joined.seams), task.width))
    moved = arrange(task.graph, moved, None if joined is None else joined.held)
    return task, moved, carried(task, x, moved, c), joined


def carried(task: Task, x: Array, moved: Array, c: Array) -> Array:
    """Centroids moved as their parts were, from x to ``moved``."""
    first = np.concatenate([[0], np.cumsum(task.used)])
    c = c.copy()
    for k, p in enumerate(task.graph.parts):
        if first[k + 1] > first[k]:
            a, b = x[p.start : p.end], moved[p.start : p.end]
            turn, shift = fit(a, b, np.ones(len(a)))
            c[first[k] : first[k + 1]] = turned(c[first[k] : first[k + 1]], turn) + shift
    return c


def seen(look: Look, width: float) -> Packed:
    """A glance as a screen takes it: ``positions`` (M, 3) mm, of stitches ``width`` mm wide."""
    return Packed(
        {"positions": (look.x * width).astype(np.float32)}, {"done": int(look.done), "total": int(look.total)}
    )


def simulate(task: Task, tell: Callable[[Look], None] = lambda look: None) -> Shape:
    """The shape of ``task``'s graph by its solver: settle, steps or none. ``tell`` is shown every move."""
    work = shaping(task)
    while True:
        try:
            look = next(work)
        except StopIteration as end:
            shape: Shape = end.value
            return shape
        tell(look)


def shaping(task: Task) -> Shaping:
    """The same, one move after the other: yields a look at the piece after each, returns the shape."""
    from tambour.crochet.settle.plain_steps import Building, steps

    params, graph = task.params, task.graph
    n, p = len(graph), len(graph.parts)
    if n == 0:
        return Shape(np.zeros((0, 3)), np.zeros((0, 3)), 0.0, 0.0, 0, True, np.zeros(p))
    hurried = False
    if task.start == "one-by-one" and params.solver != "none":
        whole = task.body(graph, task.used)
        every, d = params.nodes_per_centroid, params.link_distance
        work = Building(graph, whole, d, params.wait_force, params.wait_steps, task.used, every)
        if params.solver == "steps":
            for k in range(params.steps):
                work.tick()
                yield Look(work.state.x, k, params.steps)
            worked = len(work.body)
            work.finish()
            shape = replace(_measured(whole, work.state, worked < n), worked=worked)
            if task.joining is None or not task.joining.joins:
                return shape
            # Parts are sewn on once they are made: nothing is left to settle them by.
            _, x, c, joined = placed(task, shape.x, shape.c)
            return replace(shape, x=x, c=c, joined=joined)
        spent = 0
        while not work.done and spent < BUILDING:
            work.tick()
            spent += len(work.body) + 200
            yield Look(work.state.x, len(work.body), n)
        hurried = not work.done
        work.finish()
        x, c, evaluations = work.state.x, work.state.c, work.state.evaluations
    else:
        (x, c), evaluations = first_positions(task), 0
    if params.solver != "settle":
        task, x, c, joined = placed(task, x, c)
        whole = task.body(task.graph, task.used)
        if joined is not None:
            whole = joined.on(whole, np.arange(n))
        state = State(x, c, np.zeros(p))
        if params.solver == "steps":
            for k in steps(whole, state, params.steps):
                yield Look(state.x, k, params.steps)
        return replace(_measured(whole, state, False), joined=joined)
    return (yield from _settled(task, x, c, evaluations, hurried))


def _measured(body: Body, state: State, hurried: bool) -> Shape:
    """A shape with the forces that it has."""
    spent, c = state.evaluations, state.c.copy()
    left = displacement(body, state, False)
    residual = float(np.sqrt((left**2).sum(1).max(initial=0.0)))
    return Shape(state.x, c, residual, 0.0, spent, True, volumes(body, state.x), hurried)


def _settled(task: Task, x: Array, c: Array, evaluations: int, hurried: bool) -> Shaping:
    """Every body of fabric at rest by itself, then the parts of every sewn piece together."""
    from tambour.crochet.settle.rest import laplacian, tolerance
    from tambour.crochet.settle.rest import settle as bring_to_rest

    graph = task.graph
    first = np.concatenate([[0], np.cumsum(task.used)])
    sheets = Sheets()
    if task.snug:
        graph, sheets = laid(graph, lambda piece: task.body(piece, np.zeros(1, np.int64)))
        task, x = replace(task, graph=graph), flattened(graph, x, sheets) if task.start == "rounds" else x
    x, c = np.round(x, GRAIN), np.round(c, GRAIN)
    begun = x.copy()
    volume = np.zeros(len(graph.parts))
    ends: dict[int, Rest] = {}
    known: Known = {} if task.known is None else task.known
    factors: dict[str, Callable[[Array], Array]] = {}
    joined: Joined | None = None

    def settle(nodes: Array, roughly: bool = False) -> Generator[Look, None, None]:
        nonlocal evaluations
        piece = cut(graph, nodes)
        own = np.unique(graph.part[nodes])
        mine = np.concatenate([np.arange(first[p], first[p + 1]) for p in own]).astype(int)
        moved = x[nodes] - x[nodes[0]]
        shape = [piece.edges, piece.edge_kind, piece.rest, piece.faces, piece.plane, piece.peculiarity, task.used[own]]
        key = digest([joined is None, *shape, [p.stuffing for p in piece.parts], np.round(moved, GRAIN)])
        if key not in known:
            state = State(x[nodes], c[mine], np.zeros(len(own)))
            body = braced(task.body(piece, task.used[own]), nodes, sheets)
            if joined is not None:
                body = joined.on(body, nodes)
            fabric = digest([body.edges, body.threads, body.cubic])
            if fabric not in factors:
                factors[fabric] = laplacian(body, np.zeros(len(body), bool))
            goal = ROUGHLY * tolerance(len(body)) if roughly else task.params.tolerance
            work = bring_to_rest(body, state, goal, solve=factors[fabric])
            while True:
                try:
                    done, total = next(work)
                except StopIteration as over:
                    rest: Rest = over.value
                    break
                seen = x.copy()
                seen[nodes] = state.x
                yield Look(seen, done, total)
            evaluations += rest.evaluations
            root = body.root[0]
            shift = x[nodes[root]] - state.x[root]
            found = state.c if task.stuffing == "centroid" else c[mine]
            known[key] = (state.x + shift - x[nodes[0]], found + shift - x[nodes[0]], rest, volumes(body, state.x))
        there, centres, end, volume[own] = known[key]
        x[nodes], c[mine] = there + x[nodes[0]], centres + x[nodes[0]]
        for p in own:
            ends[int(p)] = end

    filled = np.array([p.stuffing > 0.0 for p in graph.parts])[graph.part]
    if task.snug and filled.any():
        for nodes in parts(graph):
            if filled[nodes].any():
                yield from settle(nodes, roughly=True)
        now = pressed(task.body(graph, task.used), volume)
        task = replace(task, graph=snug(graph, x, task.width / task.params.link_distance, now))
        graph = task.graph
    for nodes in parts(graph):
        yield from settle(nodes)
    if task.joining is not None:
        up = risen(x, begun, parts(graph))
        x, c = up, carried(task, x, up, c)
    task, x, c, joined = placed(task, x, c)
    known = {}  # what is sewn together is told by more than its fabric
    x, c = np.round(x, GRAIN), np.round(c, GRAIN)
    graph = task.graph
    piece = clusters(graph)
    bodies = {int(piece[nodes[0]]): 0 for nodes in parts(graph)}
    for nodes in parts(graph):
        bodies[int(piece[nodes[0]])] += 1
    for k, count in bodies.items():
        if count > 1:
            yield from settle(np.flatnonzero(piece == k))
    if joined is not None:
        x, c = standing(task, x, c, joined, piece)
        if task.joining is not None and not task.joining.built.pattern.exact:
            x, c = at_rest(task, x, c, joined, piece)
        elif task.joining is not None and any(s.stands for s in task.joining.built.pattern.parts):
            x, c = on_its_feet(task, x, c, joined, piece)
        joined = replace(joined, upright=upright(graph, joined, x))
        task, x, joined = clad(task, x, joined, piece)
        if len(task.graph.edges) > len(graph.edges):  # what is worn is no piece beside the toy
            graph, piece = task.graph, clusters(task.graph)
            bodies = {int(k): 2 if k in np.unique(piece[joined.held[:, 0]]) else 1 for k in np.unique(piece)}
    elif task.joining is not None:  # arms that are worked off the edge of a head that nothing is sewn to
        for k in np.unique(piece):
            x = lain(x, piece == k, limbs(task, x, None, piece == k))
    if len(bodies) > 1:
        if all(v == 1 for v in bodies.values()):
            moved = arrange(graph, x)
            x, c = moved, carried(task, x, moved, c)
        else:
            x, c = _apart(task, x, c, piece)
    residual, move = max(e.residual for e in ends.values()), max(e.move for e in ends.values())
    settled = all(e.settled for e in ends.values())
    return Shape(x, c, residual, move, evaluations, settled, volume, hurried, -1, joined, task)


def risen(x: Array, begun: Array, bodies: list[Array]) -> Array:
    """Bodies of fabric that fell over while they settled, turned back to how they began: places are told from there."""
    x = x.copy()
    for nodes in bodies:
        turn, shift = fit(x[nodes], begun[nodes], np.ones(len(nodes)))
        if (np.trace(turn) - 1.0) / 2.0 < FALLEN:
            x[nodes] = turned(x[nodes], turn) + shift
    return x


def _apart(task: Task, x: Array, c: Array, piece: Array) -> tuple[Array, Array]:
    """Settled pieces side by side, on one floor."""
    from tambour.crochet.settle.arrange import GAP

    x, c, right = x.copy(), c.copy(), None
    first = np.concatenate([[0], np.cumsum(task.used)])
    floor = float(x[piece == int(np.bincount(piece).argmax()), 1].min())
    for k in range(int(piece.max()) + 1):
        nodes = np.flatnonzero(piece == k)
        if right is not None:
            shift = np.array([right + GAP - x[nodes, 0].min(), floor - x[nodes, 1].min(), 0.0])
            x[nodes] += shift
            for p in np.unique(task.graph.part[nodes]):
                c[first[p] : first[p + 1]] += shift
        right = x[nodes, 0].max()
    return x, c
