"""Build: a Pattern, worked by the hook, becomes a StitchGraph."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from tambour.core.errors import Problem, Span, TambourError
from tambour.core.graph import BACK, BOTH, FRONT, ROOT, TIP, Part
from tambour.crochet.graph.assemble import assemble
from tambour.crochet.graph.attach import attach
from tambour.crochet.graph.built import NOTHING, SAYS, TOO_MANY, Built, Done, PartFacts, Worked
from tambour.crochet.graph.edges import edge
from tambour.crochet.graph.ends import fasten_off, join_round, turn
from tambour.crochet.graph.fits import ENDLESS, IDLE, around, come, ends_around, idle, mixed, slipped, spaces, spread
from tambour.crochet.graph.hook import Hook, HookError
from tambour.crochet.graph.layers import fold, through_both
from tambour.crochet.graph.spaces import into_space, pass_rest, to_space
from tambour.crochet.graph.starts import foundation_row, leave_spare, oval, ring
from tambour.crochet.graph.strands import hang
from tambour.crochet.graph.strands import work as work_strands
from tambour.crochet.language.stitches import LOW, RULES, Stitch
from tambour.crochet.language.tree import Action, Group, Item, Line, Pattern, Section

# Actions that make no node may be repeated this many times per node that a pattern may make.
_IDLE = 4
# Actions after which a line is no longer on the edge that it began on.
_ELSEWHERE = {"mr", "goto", "attach", "turn", "fo", "oval", "fsc", "edge"}


def build(pattern: Pattern, *, stitch: tuple[float, float] = (5.0, 5.0), strict: bool = False) -> Built:
    """Work ``pattern`` with the hook.

    stitch : width and height of a single crochet, mm: the rest length of an edge along a round, and of one into the
        round below (times the height of the stitch)
    strict : a stated count that disagrees with what the round makes is an error

    Raises TambourError with the first fault of every part.
    """
    if not strict and isinstance(pattern.built, Built) and _alike(pattern, pattern.built.pattern):
        return _resized(pattern.built, pattern, stitch)
    worker = _Worker(pattern, strict)
    worker.work()
    if any(not p.warning for p in worker.problems):
        # Doubts are told too: a count that disagrees is often where the fault began.
        raise TambourError(sorted((*pattern.warnings, *worker.problems), key=_place))
    hook = worker.hook
    graph, shell = assemble(hook, worker.parts, worker.sewn, stitch)
    return Built(
        graph,
        tuple(sorted((*pattern.warnings, *worker.problems), key=_place)),
        np.array(worker.sewn, np.int32).reshape(-1, 2),
        tuple(hook.rounds),
        dict(hook.marks),
        tuple(worker.facts),
        shell,
        next((f.initializer for f in worker.facts if f.initializer), None),
        next((p.up for p in pattern.parts if p.up), "end"),
        worker.counts,
        tuple(worker.log),
        tuple(worker.worked),
        pattern,
        hook,
    )


def _alike(one: Pattern, other: Pattern) -> bool:
    """Whether the hook does the same for both."""
    pairs = zip(one.parts, other.parts)
    return len(one.parts) == len(other.parts) and all(a.lines is b.lines and a.copies == b.copies for a, b in pairs)


def _resized(built: Built, pattern: Pattern, stitch: tuple[float, float]) -> Built:
    """What was worked when the pattern was read, with all that is known of it since."""
    facts = [
        replace(f, centroids=s.centroids, stuffing=s.stuffing, initializer=s.initializer)
        for f in built.parts
        for s in (pattern.parts[f.section],)
    ]
    parts = [replace(p, stuffing=_stuffing(f.stuffing)) for p, f in zip(built.graph.parts, facts)]
    graph, shell = assemble(built.hook, parts, [(a, b) for a, b in built.sewn.tolist()], stitch)
    return replace(
        built,
        graph=graph,
        warnings=tuple(sorted((*pattern.warnings, *built.warnings), key=_place)),
        parts=tuple(facts),
        shell=shell,
        initializer=next((f.initializer for f in facts if f.initializer), None),
        up=next((p.up for p in pattern.parts if p.up), "end"),
        pattern=replace(pattern, built=None),
    )


def _stuffing(said: float | None) -> float:
    return 1.0 if said is None else said


def _place(problem: Problem) -> int:
    return problem.span.start if problem.span else 0


class _Worker:
    """Walks the pattern's tree and tells the hook what to do."""

    def __init__(self, pattern: Pattern, strict: bool) -> None:
        self.pattern, self.strict = pattern, strict
        self.hook = Hook(pattern.text)
        self.problems: list[Problem] = []
        self.parts: list[Part] = []
        self.facts: list[PartFacts] = []
        self.sewn: list[tuple[int, int]] = []
        self.seams: dict[tuple[str, ...], Span] = {}
        self.counts: dict[str, int] = {}
        self.log: list[Done] = []
        self.done: dict[int, tuple[Action, Done]] = {}  # what is logged of actions that were done before
        self.more = 0  # times that the last of them was done again since
        self.worked: list[Worked] = []
        self.fresh = 0  # the first node of the row or round under way
        self.stitched = False  # the line under way has made more than chains
        self.along = 0  # stitches worked along its strands
        self.slips = False  # the line under way is a round of slip stitches
        self.left: int | None = None  # stitches not worked into when the round was joined
        self.steps = 0
        self.numbers: list[tuple[int, Span]] = []  # the counts that are being repeated, outermost first
        self.copy = 0  # the copy of a part under way, 0 when there is only one
        self.own: set[str] = set()  # marks of the part under way
        self.again = ""  # what marks are called besides that it sets in rounds written elsewhere
        self.others: set[str] = set()  # those marks
        self.single = {m for p in pattern.parts if p.copies == 1 for line in p.lines for m in _marks(line.items)}
        self.broken = False
        self.rings = 0
        self.tip = True
        self._told: set[Span | None] = set()
        self._approximate: set[str] = set()

    def work(self) -> None:
        for index, section in enumerate(self.pattern.parts):
            if section.copies_span is not None:
                self.numbers.append((section.copies, section.copies_span))
            for copy in range(1, section.copies + 1):
                if not self._part(index, section, copy):
                    break
            if section.copies_span is not None:
                self.numbers.pop()
        self._sew()

    def _part(self, index: int, section: Section, copy: int) -> bool:
        hook = self.hook
        self.copy = copy if section.copies > 1 else 0
        self.tip, self.rings = section.tip_from_fo, 0
        self.own = {label for line in section.lines for label in _marks(line.items)}
        self.others = {label for line in section.lines if line.again for label in _labels(line)} - self.own
        self.again = f"{section.name or 'piece'}.{copy}"
        start = len(hook)
        hook.begin_part()
        name = section.name or "piece"
        name = f"{name} {copy}" if self.copy else name
        self.facts.append(PartFacts(name, index, copy, section.centroids, section.stuffing, section.initializer))
        self._tell(Done("part", 1, (index, copy)))
        fine = True
        try:
            for line in section.lines:
                self._line(line)
        except HookError as error:
            self.problems.append(error.problem)
            fine, self.broken = False, True
        work_strands(hook, last=True)
        hook.end_part()
        hollow = self._hollow(section, start) if fine and section.hollow is not None else (0, 0)
        self.parts.append(Part(name, start, len(hook), _stuffing(section.stuffing), hollow))
        return fine

    def _hollow(self, section: Section, start: int) -> tuple[int, int]:
        """The nodes from the first to the last round that is to lie inside."""
        assert section.hollow is not None
        first, last = section.hollow
        mine = [r for r in self.hook.rounds if r.first >= start]
        inside = [r for r in mine if first <= r.number <= last]
        if not inside or inside[-1].number < last:
            most = max((r.number for r in mine), default=0)
            problem = Problem(
                f"round {last} is not there to be hollow", f"the part has {most} rounds", section.hollow_span,
                self.pattern.text, warning=True,
            )  # fmt: skip
            if problem not in self.problems:
                self.problems.append(problem)
        return (inside[0].first, inside[-1].last + 1) if inside else (0, 0)

    def _line(self, line: Line) -> None:
        if line.times_span is not None:
            self.numbers.append((line.times, line.times_span))
        if line.again is not None:
            self._tell(Done("again", line.times, (line.again.first, line.again.last), (line.again.part,)))
            for one in line.rounds():
                try:
                    self._once(one, one.number)
                except HookError as error:  # the fault is where the rounds are named, not where they are written
                    raise HookError(replace(error.problem, span=line.again.span)) from None
                if one.stated is not None:
                    self._check_count(one, self.worked[-1].made)
        else:
            for repeat in range(line.times):
                self._once(line, None if line.number is None else line.number + repeat)
            if line.stated is not None and line.times:
                self._check_count(line, self.worked[-1].made)
        if line.times_span is not None:
            self.numbers.pop()

    def _once(self, line: Line, number: int | None) -> None:
        """One working of a line, under the number that the round bears."""
        hook = self.hook
        work_strands(hook)
        names = set(_names(line.items))
        elsewhere = line.in_round and (bool(_ELSEWHERE & names) or any(n.startswith("MR{") for n in names))
        self.fresh, below, self.left, self.stitched, self.along = len(hook), hook.now.count, None, False, 0
        if line.in_round:
            hook.now.loop, hook.now.folded = BOTH, False
            hook.begin_line()
            hook.written = number or 0
            self._tell(Done("round", 1, (), (), line.span))
            self._step(1)
            self.slips = slipped(hook, line.items, self.pattern.stitches)
        else:
            self.slips = False
            self._tell(Done("line", 1, (), (), line.span))
        for item in line.items:
            self._item(item)
        if hook.now.spare >= 0:
            leave_spare(hook)
        if line.in_round and spaces(ends_around(line.items), self.pattern.stitches):
            pass_rest(hook)
        edge = hook.now.count + hook.joined
        for note in line.notes:
            self._tell(Done("note", 1, (), (self.pattern.text.text[note.start : note.end],)))
        self._tell(Done("end", edge))
        # A magic ring's root, a tip and chains that only lift the yarn are nodes, but no stitches.
        looks = Counter(hook.style[self.fresh :])
        made = sum(many for look, many in looks.items() if hook.styles[look][6] not in (ROOT, TIP))
        made -= hook.lifting(self.fresh, len(hook))
        left = hook.ahead if self.left is None else self.left
        ring = line.in_round and hook.now.ring and not elsewhere and below > 0
        self.worked.append(Worked(line, hook.part, below, left, made, edge, ring))

    def _check_count(self, line: Line, made: int) -> None:
        """A stated count may mean the stitches made in the round or those on its edge, chains aside or not; slip stitches count there, and
        stitches along strands may."""
        hook = self.hook
        edge = hook.now.count + hook.joined
        if line.stated is None:
            return
        if line.stated in (edge, made, made + self.along, edge + self.along):
            self._check_left(line, made, edge)
            return
        if line.stated == made - sum(
            hook.styles[hook.style[n]][0] == "ch" and n not in hook.lifts for n in range(self.fresh, len(hook))
        ):
            return
        left = max(0, self.hook.ahead) if self.hook.now.ring else 0
        rest = f" and leaves {left} of those below unworked" if left and made + left == edge else ""
        shown = made if rest or self.hook.now.left == self.hook.now.count else edge
        self.problems.append(
            Problem(
                f"{SAYS} {line.stated} stitches, the round makes {shown}{rest}",
                "correct the number, or the stitches before it",
                line.stated_span,
                self.pattern.text,
                warning=not self.strict,
            )
        )

    def _check_left(self, line: Line, made: int, edge: int) -> None:
        """A count that comes out only with stitches below which nothing is worked into may come out by chance."""
        left = self.hook.ahead if self.hook.now.ring else 0
        told = any(
            isinstance(i, Group) and i.times is None for i in line.items
        )  # what goes around tells what it leaves
        if left > 0 and line.stated == edge == made + left and made and not told:
            message = f"{line.stated} stitches are these {made} and {left} of those below, which stay unworked"
            hint = "say into how many stitches it is worked, or how often"
            self.problems.append(Problem(message, hint, line.stated_span, self.pattern.text, warning=True))

    def _item(self, item: Item) -> None:
        if isinstance(item, Action):
            self._action(item)
            return
        if mixed(item):
            while coming := come(self.hook, item):
                self._step(1)
                ahead = self.hook.ahead
                for each in coming:
                    self._item(each)
                if self.hook.ahead >= ahead:
                    raise self.hook.fail(ENDLESS, "give a number instead")
            return
        if item.times is None:
            times, doubt = around(self.hook, item, self.pattern.stitches)
            if doubt is not None:
                self._doubt(*doubt, item.span)
        else:
            times = item.times
        if item.times is not None:
            self.numbers.append((times, item.span))
            if times > IDLE and idle(item):
                raise self.hook.fail(NOTHING, "say what is worked in it", item.span)
        for _ in range(times):
            self._step(1)
            for inner in item.items:
                self._item(inner)
        if item.times is not None:
            self.numbers.pop()

    def _doubt(self, message: str, hint: str, span: Span) -> None:
        if span not in self._told:
            self._told.add(span)
            self.problems.append(Problem(message, hint, span, self.pattern.text, warning=True))

    def _step(self, nodes: int, own: tuple[int, Span] | None = None) -> None:
        """Stops a pattern that grows too large, before it does, at the count that is most to blame."""
        self.steps += 1
        hook, most = self.hook, self.pattern.max_stitches
        nodes += hook.hanging
        if len(hook.parent) + nodes <= most and self.steps <= _IDLE * most + 1000:
            return
        numbers = [*self.numbers, own] if own else self.numbers
        worst = max(numbers, key=lambda n: n[0], default=None)
        what = f"{TOO_MANY} more than {most} stitches" if len(self.hook) + nodes > most else NOTHING
        raise self.hook.fail(what, "{--max-stitches} sets the limit", worst[1] if worst else self.hook.span)

    def _action(self, action: Action) -> None:
        hook = self.hook
        hook.span = action.span
        if action.name not in RULES:
            stitch = self.pattern.stitches[action.name]
            own = (action.times, action.times_span) if action.times_span else None
            self._step(action.times * stitch.nodes, own)
            if action.times:
                self._work(stitch, action)
                self._note(action)
            hook.last_mark = None
            return
        making = action.name in ("mr", "attach", "oval", "fsc", "gap") and bool(action.numbers)
        nodes = action.numbers[0] * (2 if action.name == "fsc" else 1) if making else 0
        self._step(nodes, (action.numbers[0], action.span) if making else None)
        mark = hook.last_mark
        labels = tuple(self._label(name) for name in action.labels)
        if action.name not in ("mark", "sew") and labels and labels[0] not in hook.labels:
            if self.broken:  # set in a part that stopped short: its own problem says so
                return
            raise hook.fail(f'the mark "{action.labels[0]}" is not set yet', "set it first")
        match action.name:
            case "mr":
                self.rings += 1
                self._further(action.span, bool(action.numbers[1]))
                hook.magic_ring(action.numbers[0])
            case "flo" | "blo" | "bl":
                hook.loops({"flo": FRONT, "blo": BACK, "bl": BOTH}[action.name])
            case "color":
                red, green, blue = action.numbers
                hook.color = (red, green, blue)
            case "mark":
                hook.mark(labels[0])
                self.rings = 0  # the edge is kept: another ring may begin beside it
            case "goto":
                hook.goto(labels[0])
            case "attach":
                hook.last_mark = mark
                attach(hook, labels[0], action.numbers[0])
            case "sew":
                self.seams.setdefault(labels, action.span)
            case "fo":
                fasten_off(hook, self.tip)
            case "turn":
                turn(hook)
                if not self.stitched:
                    self.fresh = len(hook)  # what was worked before it belongs to the row below
            case "oval":
                oval(hook, *action.numbers)
            case "tospace":
                to_space(hook, bool(action.numbers[0]))
            case "edge":
                edge(hook, *action.numbers)
            case "fsc":
                foundation_row(hook, action.numbers[0], self.pattern.stitches["sc"])
            case "fold":
                fold(hook, labels[0] if labels else None)
            case "join":
                self.left = hook.ahead  # the next round begins with it
                join_round(hook)
            case "gap":
                spread(hook, action.numbers[0])
        if action.name != "mark":
            hook.last_mark = None
        self._note(action)

    def _further(self, span: Span, named: bool = False) -> None:
        """Doubts a ring beside an edge that no mark keeps."""
        if self.rings > 1 and not named:
            self._doubt("a further magic ring in this part", "a part of its own: == name ==", span)

    def _work(self, stitch: Stitch, action: Action) -> None:
        """The stitch as often as the action says, into what it is worked into."""
        if stitch.approximate and action.name not in self._approximate:
            self._approximate.add(action.name)
            self._doubt(f"approximated: {action.name}", stitch.approximate, action.span)
        self.stitched = self.stitched or stitch.name != "ch"
        if stitch.where == "ring":
            self.rings += 1
            self._further(action.span)
            ring(self.hook, stitch)
        elif stitch.where == "sp":
            into_space(self.hook, stitch, action.times)
        elif stitch.where == "curl":
            hang(self.hook, [(self.pattern.stitches[name], many) for name, many in stitch.inner], action.times)
            self.along += action.times * sum(many for name, many in stitch.inner if name != "ch")
        elif self.hook.now.folded:
            through_both(self.hook, stitch, action.times)
        elif self.slips and stitch.name == "slst":
            self.hook.stitch(LOW, action.times)
        else:
            self.hook.stitch(stitch, action.times)

    def _label(self, name: str) -> str:
        """The label as the hook knows it: inside a part made several times, each copy has its own."""
        if name in self.others:  # they are set there, too
            return f"{name}.{self.again}"
        if self.copy and name in self.own:
            return f"{name}.{self.copy}"
        base, _, copy = name.rpartition(".")
        return base if copy == "1" and base in self.single else name

    def _sew(self) -> None:
        """Sews once everything is worked, so that all copies are there."""
        marks = self.hook.marks
        for (one, other), span in self.seams.items():
            if one not in marks or other not in marks:
                continue  # set in a part that stopped short: its own problem says so
            if marks[one] == marks[other]:
                self._doubt("both marks are on the same stitch: nothing is sewn", "mark two stitches", span)
            else:
                pair = sorted((marks[one], marks[other]))
                self.sewn.append((pair[1], pair[0]))

    def _note(self, action: Action) -> None:
        name, times = action.name, action.times
        self.counts[name] = self.counts.get(name, 0) + times
        if self.log[-1].what == name and name not in RULES:
            self.more += times
            return
        known = self.done.get(id(action))
        if known is None:  # kept with its action, whose id nothing else can have then
            known = self.done[id(action)] = action, Done(name, times, action.numbers, action.labels, action.span)
        self._tell(known[1])

    def _tell(self, done: Done) -> None:
        """Logs what was done, when all of what was done before it is known."""
        if self.more:
            last = self.log[-1]
            self.log[-1] = Done(last.what, last.times + self.more, (), (), last.span)
            self.more = 0
        self.log.append(done)


def _names(items: tuple[Item, ...]) -> Iterator[str]:
    """The actions among ``items``."""
    for item in items:
        if isinstance(item, Group):
            yield from _names(item.items)
        else:
            yield item.name


def _labels(line: Line) -> list[str]:
    """The labels that are set in a line, also in rounds written elsewhere that it works."""
    again = line.again.lines if line.again is not None else ()
    return [*_marks(line.items), *(label for one in again for label in _labels(one))]


def _marks(items: tuple[Item, ...]) -> list[str]:
    """The labels that marks among ``items`` set."""
    found: list[str] = []
    for item in items:
        if isinstance(item, Group):
            found += _marks(item.items)
        elif item.name == "mark":
            found += item.labels
    return found
