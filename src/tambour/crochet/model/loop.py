"""Loop: a part's rounds tried in the simulation and corrected against the model, until that brings nothing more."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from tambour.core.check import Array
from tambour.crochet.model import bends, readable, threads
from tambour.crochet.model.distance import Distance, Target, distance, outside
from tambour.crochet.model.fronts import DRAWN, Fronts, laid
from tambour.crochet.model.rounds import Round, Rounds, Thread
from tambour.crochet.model.settled import Settled, settled
from tambour.geometry.motion import fit, turned

if TYPE_CHECKING:
    from tambour.crochet.params import CrochetParams

TRIES = 8
"""How often a part is corrected at the most."""
STEP, SLOWER = 0.8, 0.87
"""How much of what a round is too wide is taken off it at once, at first, and by what share less each time after: whole stitches and
repeats make every try a little better or worse than its lengths are, and small steps about the same place even that out."""
HARD = 0.15
"""How much nearer, in stitches, rounds must lie that are harder to follow than was asked for."""
GAIN = 0.004
"""An improvement of the mean distance by less than this, in stitches, is none."""
BENT, IDLE = 5, 3
"""How often a part's bends are corrected, and the widths of its rounds after each; and after how many times in a row that bring nothing
that ends."""
LEANING = 1.0, 0.5
"""Which share of the rounds that may be neither plain nor a repeat may lean: all of them, or half, as increases outside of a bend, which bend a stout
part more than taller stitches do, need such rounds too."""
FLAT = 0.78
"""A limb whose lines enclose a smaller share than this of what circles would is tried without stuffing too, as ears are worked."""
BROAD = 26.0
"""One whose end is so long around, in stitches, is not drawn flat before it is corrected: its end is sewn down in a round, which it would draw to a
slit and dent what is below (an elephant's ears dented its head, a toy at .34 stitch came to .41)."""
ROUND = 0.9
"""A body whose lines enclose a smaller share than this is tried with threads before any round is corrected as well: what stuffing rounds lies outside of
what is flat, and rounds that counts alone had to bring home were a fifth too short, and stayed so once threads held it (a bust .55, and .37 now)."""
BATCHES, SPARE, AGAIN, HARDLY = 4, 6, 3, 4
"""In how many batches threads are pulled, how many more there are where one brings nothing, and how often rounds are corrected after
each; of a part that has no more threads than so many, all are pulled at once."""
HELD = 0.3
"""How much of what a round is too wide is then taken off it at first."""
BOUNDS = 0.6, 1.5
"""Shares of a line's length that its round may come to."""
AT_END, BLUNT = 3, 0.85
"""So many rounds at an end come to this share of it at the least: a thinner end is a peg."""
LONGER, PULLS = 6, 0.6
"""By how many rounds more, or fewer, a body that threads hold is tried, and of which share of what it lies too short or too long at once."""
FEWER, EVENED = 3, 2
"""A part is worked in so many rounds fewer, or more, at the most, than its way is long; how far it goes is told by the means of so many
rounds on either side of each."""


@dataclass(frozen=True, eq=False, slots=True)
class Tried:
    """Rounds and what the simulation made of them.

    goal : (N, 3) where each node of the part belongs on the model; wanted : the lengths that the counts were made for
    holds : the threads that pull it in; target : what it is held against; hard : its rounds are not as easy as was asked for
    """

    rounds: Rounds
    counts: list[int]
    goal: Array
    wanted: Array
    worked: Settled
    distance: Distance
    holds: tuple[threads.Hold, ...]
    target: Target
    hard: bool = False

    @property
    def price(self) -> float:
        """How far it lies off, on the average, and more if it is too hard to follow."""
        return self.distance.mean + (HARD if self.hard else 0.0)

    @property
    def lain(self) -> Array:
        """Where its nodes (N, 3) are once it lies upon its target as well as it can."""
        return turned(self.worked.x, self.distance.turn) + self.distance.shift

    def upon(self, target: Target, goal: Array) -> tuple[Array, float]:
        """The same upon another target, where its nodes belong at ``goal`` (N, 3), and how far it lies from that on the average."""
        how = distance(target, self.worked.x, self.worked.graph.faces, fit(self.worked.x, goal, np.ones(len(goal))))
        return turned(self.worked.x, how.turn) + how.shift, how.mean


@dataclass(frozen=True, eq=False, slots=True)
class Task:
    """A part to be found rounds for. All lengths in stitches, the model's frame.

    way : the lines of its rounds; target : its surface; seam : (3,) where its rounds begin; plain : 0 to 1; hollow : its rounds that lie inside
    lines : the way with rounds of other heights (R,), None where they cannot be; leans : where rounds are taller on one side
    """

    name: str
    way: Fronts
    target: Target
    seam: Array
    plain: float
    up: str
    params: CrochetParams
    stitch: tuple[float, float]
    stuffing: str = ""
    hollow: tuple[int, int] = (0, 0)
    lines: Callable[[Array], Fronts] | None = None
    leans: tuple[bends.Lean | None, ...] = ()


def drafted(task: Task, wanted: Array, holds: tuple[threads.Hold, ...] = ()) -> tuple[Rounds, list[int], Array]:
    """Rounds as long as ``wanted`` (R,): the part, its counts, and where every stitch belongs (N, 3)."""
    made = readable.sparing(list(wanted), task.plain)
    points, rounds = _led(task.way, tuple(made), tuple(task.seam.tolist()), task.plain, tuple(task.leans))
    closed = task.way.closed and made[-1] <= DRAWN
    tip = [task.way.end[None]] if closed else []
    goal = np.concatenate([task.way.tip[None], *points, *tip])
    first = np.concatenate([[1], 1 + np.cumsum(made)])

    def place(node: int) -> tuple[int, int]:
        k = int(np.searchsorted(first, node, "right")) - 1
        return k + 1, node - int(first[k]) + 1

    apart = task.stitch[0]
    pulled = tuple(
        Thread(place(a), place(b), max(1, round(apart * (float(np.sqrt(((goal[a] - goal[b]) ** 2).sum())) - more))))
        for a, b, more in threads.held(holds, made)
    )
    part = Rounds(task.name, made[0], rounds, closed, 1, task.stuffing, None, task.up, task.hollow, pulled)
    return part, made, goal


@lru_cache(maxsize=8)
def _led(
    way: Fronts, counts: tuple[int, ...], seam: tuple[float, ...], plain: float, leans: tuple[bends.Lean | None, ...]
) -> tuple[list[Array], tuple[Round, ...]]:
    """The stitches of rounds of ``counts``, as points, and their words: the same ones are tried with other threads again and again."""
    points = laid(way, list(counts), np.array(seam))
    return points, readable.rounds(way.lines, points, plain, leans)


def tried(task: Task, wanted: Array, holds: tuple[threads.Hold, ...] = ()) -> Tried:
    """Rounds as long as ``wanted``, pulled in by the threads ``holds``, worked and measured."""
    part, made, goal = drafted(task, wanted, holds)
    worked = settled(part, task.params, task.stitch)
    start = fit(worked.x, goal, np.ones(len(goal)))
    lain = distance(task.target, worked.x, worked.graph.faces, start)
    hard = not readable.followable(part.rounds, task.plain)
    return Tried(part, made, goal, wanted, worked, lain, holds, task.target, hard)


def looped(task: Task, first: Tried | None = None, tries: int = TRIES) -> tuple[Task, Tried, list[float]]:
    """The best rounds that corrections lead to, the task with the bends of these, and the mean distances on the way: of counts first,
    then of bends, then of threads as well; of a flat limb that, and threads first, stuffed and without stuffing; of a
    BROAD one that, stuffed and without stuffing."""
    done, best, history = _worked(task, tried(task, task.way.girths) if first is None else first, tries)
    if task.way.closed or not _stuffed(task) or roundness(task.way) > FLAT:
        return done, best, history
    ways = [("none", _worked)] if task.way.girths[-1] >= BROAD else [(task.stuffing, _flat), ("none", _flat)]
    for stuffing, how in ways:
        pressed = replace(task, stuffing=stuffing, lines=None)  # what is flat bends by hand
        pressed, flat, more = how(pressed, tried(pressed, task.way.girths), tries)
        history += more
        if flat.price < best.price - GAIN:
            done, best = pressed, flat
    return done, best, history


def _flat(task: Task, first: Tried, tries: int) -> tuple[Task, Tried, list[float]]:
    """The best rounds of a flat part, pulled in by threads before any is corrected, and by small steps: a bag that stands open lies outside
    of what is flat, and to correct that made all its rounds an eighth too short, as they stayed once threads drew it flat."""
    best, history = pulled(task, first, tries)
    best, more = _counted(task, best, tries, HELD)
    return task, best, history + more


def _stuffed(task: Task) -> bool:
    """Whether there is stuffing in a part."""
    return (task.stuffing or task.params.stuffing) != "none"


def roundness(way: Fronts) -> float:
    """How round the lines of a part are, on the average: what they enclose, as a share of what circles as long would."""
    size = way.girths
    own = [0.5 * np.cross(line, np.roll(line, -1, 0)).sum(0) for line in (line - line.mean(0) for line in way.lines)]
    within = np.sqrt((np.array(own) ** 2).sum(1))
    return float((4.0 * math.pi * within / size).sum() / size.sum())


def _worked(task: Task, first: Tried, tries: int) -> tuple[Task, Tried, list[float]]:
    """The same, filled as the task says."""
    task, best, history = bare(task, first, tries)
    best, more = pulled(task, best, tries)
    return task, best, history + more


def bare(task: Task, first: Tried, tries: int) -> tuple[Task, Tried, list[float]]:
    """The best rounds that corrections of counts, of how many rounds there are and of bends lead to, without threads."""
    best, history = _counted(task, first, tries)
    for change in (resized, bent):
        task, best, more = change(task, best, tries)
        history += more
    return task, best, history


def pulled(task: Task, best: Tried, tries: int) -> tuple[Tried, list[float]]:
    """The best that threads make of ``best``, pulled a batch at a time, each kept that brings enough; and the mean distances on the way.

    Fabric that is held springs from one shape to another: a correction of its rounds is as likely to throw it as to mend it. So every
    batch is pulled tighter than its ends belong and as tight as they do, the next one goes on from the nearest there was, and one that
    brings nothing may be what the next one needs.
    """
    most = threads.most(sum(best.counts), task.plain) if task.params.stuffing != "none" else 0
    was, history = best, list[float]()
    tights = (threads.FIRST, 0.0) if _stuffed(task) else (0.0,)
    add = most if most <= HARDLY else max(2, most // BATCHES)

    def batch(last: Tried, add: int) -> Tried | None:
        """``last`` with up to ``add`` threads more, as near as corrections bring it."""
        holds = [threads.chosen(last, min(add, most - len(last.holds)), tight) for tight in tights]
        if len(holds[0]) == len(last.holds):
            return None
        made = [tried(task, last.wanted, one) for one in holds]
        history.extend(one.distance.mean for one in made)
        now = min(made, key=lambda one: one.price)
        at, step = now, HELD
        for _ in range(min(AGAIN, tries)):
            at = tried(task, corrected(task, at, step), threads.tightened(at, step))
            history.append(at.distance.mean)
            now = at if at.price < now.price else now
            step *= SLOWER
        return now

    def cost(one: Tried) -> float:
        return one.price + threads.EACH * len(one.holds)

    last: Tried | None = best
    for _ in range(BATCHES):  # a batch that brings nothing may be what the next one needs
        if last is None or (last := batch(last, add)) is None:
            break
        best = min(best, last, key=cost)
    for _ in range(SPARE):
        add //= 2
        now = batch(best, add) if add else None
        if now is None:
            break
        if cost(now) < cost(best) - GAIN:
            best, add = now, 2 * add
    return best if task.plain <= 0.0 or threads.worth(was, best) else was, history


def resized(task: Task, best: Tried, tries: int) -> tuple[Task, Tried, list[float]]:
    """The task, and the best rounds of it, with rounds fewer or more, one after another as long as that brings it nearer: fewer by as many
    as its ends stand out of the model (stuffing bulges ends, and counts alone cannot but make them thin), or more or fewer by what
    it came out too short or too long by, as fabric that is curved is."""
    rows, row, history = task.way.rows, task.stitch[1] / task.stitch[0], list[float]()
    if task.lines is None or task.hollow[0] or rows < 3 * FEWER:
        return task, best, history
    least, most = rows - FEWER, rows + FEWER
    while True:
        rows = task.way.rows
        off = signed(task.target, best.worked.x, best.distance)
        out = max(float(off[0]), 0.0) + (max(float(off[-1]), 0.0) if task.way.closed else 0.0)
        more = min(max(rows + (-int(out / row) or round(short(best) / row)), least), most) - rows
        if not more:
            return task, best, history
        way = task.lines(np.ones(rows + more))
        wider = _wider(task, best, way, (np.arange(rows) + 0.5) / rows)
        on = replace(task, way=way, leans=())
        now, through = _counted(on, tried(on, wider * way.girths), -(-tries // 2))
        history += through
        if now.price >= best.price - GAIN:
            return task, best, history
        task, best = on, now


def stretched(task: Task, best: Tried, tries: int) -> tuple[Task, Tried, list[float]]:
    """The task, and the best rounds of it, of a part that threads hold, with rounds more or fewer by a share of what it lies shorter or longer than its model,
    one change after another as long as that brings it nearer: without threads its bulges stood out beyond its ends, and it got too few."""
    history = list[float]()
    if task.lines is None or task.hollow[0] or not best.holds:
        return task, best, history
    least, most = task.way.rows - LONGER, task.way.rows + LONGER
    while True:
        rows = task.way.rows
        many = min(max(rows + round(PULLS * short(best) * task.stitch[0] / task.stitch[1]), least), most)
        if many == rows or many < 3:
            return task, best, history
        at = np.arange(rows) + 0.5
        there = np.minimum((at * many / rows).astype(int), many - 1).tolist()
        leans: list[bends.Lean | None] = [None] * many
        for k, lean in zip(there, task.leans):
            leans[k] = lean or leans[k]
        way = task.lines(bends.heights(leans))
        there += range(many, many + task.way.closing)  # rounds that close a wide end stay the last ones
        holds = tuple((there[k], s, there[n], t, more) for k, s, n, t, more in best.holds)
        on = replace(task, way=way, leans=(*leans[: way.rows], *[None] * way.closing))
        now = tried(on, _wider(task, best, way, at / rows) * way.girths, holds)
        now, through = _counted(on, now, tries, HELD)
        history += through
        if now.price >= best.price - GAIN:
            return task, best, history
        task, best = on, now


def short(made: Tried) -> float:
    """By how much a part lies shorter than its model, lengthwise, in stitches; below 0 where it is longer."""
    return lengthwise(made.goal, made.counts) - lengthwise(made.lain, made.counts)


def lengthwise(x: Array, counts: list[int]) -> float:
    """How long the way is, in stitches, through the middles of the ring and of all rounds of ``counts``, without their wobble. x : (N, 3)."""
    first = np.concatenate([[0], np.cumsum(counts)])
    middles = np.add.reduceat(x[1 : 1 + first[-1]], first[:-1], axis=0) / np.array(counts, float)[:, None]
    padded = np.pad(middles, ((EVENED, EVENED), (0, 0)), mode="edge")
    even = np.mean([padded[k : k + len(middles)] for k in range(2 * EVENED + 1)], axis=0)
    steps = np.concatenate([np.diff(even, axis=0), x[:1] - middles[:1]])
    return float(np.sqrt((steps**2).sum(1)).sum())


def bent(task: Task, best: Tried, tries: int) -> tuple[Task, Tried, list[float]]:
    """The task, and the best rounds of it, with rounds that are taller on one side where the part is to bend, if that brings it nearer."""
    history: list[float] = []
    if task.lines is None or task.hollow[0]:
        return task, best, history
    made = task, best
    for share in LEANING:
        on, now, through = _bent(task, best, tries, share * readable.uneven(task.plain))
        history += through
        made = (on, now) if now.price < made[1].price else made
    return *made, history


def _bent(task: Task, best: Tried, tries: int, share: float) -> tuple[Task, Tried, list[float]]:
    """The same where a ``share`` of all rounds may lean."""
    assert task.lines is not None, "asked before"
    was, now, on, history = (task, best), best, task, list[float]()
    bend, step, idle = np.zeros((task.way.rows, 2)), STEP, 0
    for _ in range(min(BENT, tries)):
        bend = bend + step * bends.needed(now)[: len(bend)]
        leans = bends.leaning(bend, share * len(bend))
        if not any(lean is not None for lean in leans):
            break
        upto = np.cumsum(bends.heights(leans))
        rows = max(3, round(task.way.rows * len(leans) / float(upto[-1])))
        at, own = (np.arange(rows) + 0.5) / rows, (upto - 0.5) / upto[-1]
        bend = np.column_stack([np.interp(at, own, bend[:, k]) for k in range(2)])
        leans = bends.leaning(bend, share * rows)
        way = task.lines(bends.heights(leans))
        leans, bend = [*leans[: way.rows], *[None] * way.closing], bend[: way.rows]
        wider = _wider(on, now, way, own)
        on = replace(task, way=way, leans=tuple(leans))
        now = tried(on, wider * way.girths)
        again = tried(on, corrected(on, now, step))
        history += [now.distance.mean, again.distance.mean]
        now = again if again.price < now.price else now
        idle = 0 if now.price < was[1].price - GAIN else idle + 1
        was = was if idle else (on, now)
        if idle == IDLE:
            break
        step *= SLOWER
    return *was, history


def _wider(task: Task, last: Tried, way: Fronts, at: Array) -> Array:
    """How much longer than its line every round of another ``way`` is, for a start: as much as that of ``last`` at the same share of the way,
    where its own lie ``at`` (R,); rounds that close a wide end are as before."""
    own = last.wanted / task.way.girths
    rows = task.way.rows
    wider = np.interp((np.arange(way.rows) + 0.5) / way.rows, at, own[:rows])
    closing = [*own[rows:], *[1.0] * way.closing][: way.closing]
    return np.concatenate([wider, closing])


def _counted(task: Task, best: Tried, tries: int, step: float = STEP) -> tuple[Tried, list[float]]:
    """The best of the tries that follow ``best``, each corrected by what the last one was off, whether that was better or not;
    after four in a row that were not, by what the best one was."""
    history, now, idle = [best.distance.mean], best, 0
    for _ in range(tries):
        before = now
        now = tried(task, corrected(task, before, step), threads.tightened(before, step))
        history.append(now.distance.mean)
        idle = 0 if now.price < best.price else idle + 1
        best = best if idle else now
        if now.rounds == before.rounds:
            break
        if idle == 4:
            now, idle = best, 0
        step *= SLOWER
    return best, history


def faithful(task: Task, best: Tried) -> float:
    """The mean distance, in stitches, of the same lengths where increases lie wherever the shape wants them: what rounds that
    read more easily are to be held against."""
    return (
        best.distance.mean
        if task.plain <= 0.0
        else tried(replace(task, plain=0.0), best.wanted, best.holds).distance.mean
    )


def corrected(task: Task, last: Tried, step: float) -> Array:
    """The lengths (R,) that would bring every round to the model: those that lie outside of it, or are wider than they belong,
    become shorter.

    Outside alone does not tell: a ball worked too wide is flat, with its middle inside of the model; there rounds would become
    wider still.
    """
    off = signed(task.target, last.worked.x, last.distance)
    count = len(last.counts)
    number = np.clip(last.worked.graph.round, 0, count - 1)
    mean = np.bincount(number, off, count) / np.maximum(np.bincount(number, minlength=count), 1)
    mean = 0.5 * (mean + _wide(last.lain, last.counts) - _wide(last.goal, last.counts))
    smooth = np.convolve(np.pad(mean, 1, mode="edge"), [0.25, 0.5, 0.25], "valid")
    wide = task.way.girths
    least = np.full(count, BOUNDS[0])
    least[:AT_END] = least[count - AT_END * task.way.closed :] = BLUNT
    return np.clip(last.wanted - step * 2.0 * math.pi * smooth, least * wide, BOUNDS[1] * wide)


def _wide(x: Array, counts: list[int]) -> Array:
    """How far the stitches of every round (R,) of ``counts`` lie from its middle, on the average. x : (N, 3), the ring's middle first."""
    first = np.concatenate([[0], np.cumsum(counts)])
    own = x[1 : 1 + first[-1]]
    size = np.array(counts, float)
    middle = np.add.reduceat(own, first[:-1], axis=0) / size[:, None]
    far = np.sqrt(((own - np.repeat(middle, counts, axis=0)) ** 2).sum(1))
    return np.asarray(np.add.reduceat(far, first[:-1]) / size)


def signed(target: Target, x: Array, lain: Distance) -> Array:
    """How far (N,) points lie outside of ``target``, once they are laid upon it; inside is negative."""
    return outside(target, turned(x, lain.turn) + lain.shift)


def missed(target: Target, made: Tried) -> tuple[int, str]:
    """The round that lies farthest from ``target``, and on which side of it that is."""
    off = signed(target, made.worked.x, made.distance)
    number = np.clip(made.worked.graph.round, 0, len(made.counts) - 1)
    nodes = np.bincount(number)
    size, lean = (np.bincount(number, value) / nodes for value in (np.abs(off), off))
    worst = int(size.argmax())
    side = "outside" if lean[worst] > 0 else "inside"
    return worst + 1, "partly outside, partly inside" if abs(lean[worst]) < 0.5 * size[worst] else side
