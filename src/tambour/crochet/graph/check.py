"""Check: the tech edit. What a reader who works the pattern through would send back to its designer."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from typing import Final

import numpy as np

from tambour.core.check import Array
from tambour.core.errors import Problem, Span
from tambour.crochet.graph.built import SAYS, Built, Worked
from tambour.crochet.language.finishes import ASIDE, GUESSED, MEANT, UNSEEN, Eye, Placed
from tambour.crochet.language.stitches import HEIGHTS
from tambour.crochet.language.tree import Group, Item
from tambour.crochet.words.table import TERMS, WHOLE

NEAR = 0.2
"""A stated size may differ from the predicted one by this share: hands differ as much."""

_LENGTH = re.compile(r"(?<![\d/.,])(\d+(?:[.,]\d+)?)\s*(mm|cm|inches|inch|in\b|\"|″|”)", re.IGNORECASE)
_MM = {"mm": 1.0, "cm": 10.0}
_YARN = re.compile(
    r"\b(lace|fingering|sock|sport|dk|double knitting|light worsted|worsted|aran|bulky|chunky|roving|jumbo|cotton|wool|"
    r"acrylic|merino|alpaca|chenille|velvet|mohair|linen|jute|raffia|twine|\d+[ -]ply)\b"
    r"|\b\d+ (?:balls?|skeins?|hanks?|cones?)\b|\(\s*[\d.]+ ?(?:g|oz)\b[^()\n]{0,40}\b(?:m|yds?|yards?|metres|meters)\b[^()\n]{0,12}\)",
    re.IGNORECASE,
)
_EYE = re.compile(r"(\d+(?:[.,]\d+)?)\s*-?\s*mm", re.IGNORECASE)


def tech_edit(built: Built) -> list[Problem]:
    """Everything wrong or doubtful in a pattern that could be worked, in the order of the text.

    Stated counts against the work, numbers of rounds (:mod:`parse` and :mod:`build` tell these as doubts); rounds that
    leave stitches or run past their end; parts that are never sewn on; stuffing in an open part; yarn and eyes that
    the materials do not name.
    """
    found = [
        replace(p, warning=False)
        for p in built.warnings
        if not p.message.startswith(("approximated", GUESSED, MEANT, UNSEEN))
    ]
    found += _rounds(built)
    wrong = {p.span for p in found}
    off = {w.part for w in built.worked if w.line.stated_span in wrong or w.line.span in wrong}
    found += [*_loose(built), *_open(built, off), *_materials(built)]
    return sorted(dict.fromkeys(found), key=lambda p: p.span.start if p.span else 0)


_COUNTS = re.compile(
    rf"{SAYS} \d+ stitches|this round (?:leaves|needs) \d+|round \d+ leaves rounds out|\d+ would follow"
)


def miscounted(problem: Problem) -> bool:
    """Whether a problem is of counts, those of stitches or of rounds: what a designer looks for first."""
    return _COUNTS.search(problem.message) is not None


def size_edit(built: Built, size_mm: tuple[float, ...]) -> list[Problem]:
    """The size that the pattern states against the one predicted; no problem when it states none.

    size_mm : width, height, depth of the settled piece
    """
    words, span = built.pattern.stated.get("size", ("", Span(0, 0)))
    said = [float(n.replace(",", ".")) * _MM.get(unit.lower(), 25.4) for n, unit in _LENGTH.findall(words)]
    if not said or not max(size_mm, default=0.0):
        return []
    largest = max(said)
    seated = len(said) > 1 and _seated(built.pattern.terms).search(words)  # "13 cm sitting, 20 cm standing"
    if any(abs(one - length) <= NEAR * length for one in (said if seated else [largest]) for length in size_mm):
        return []
    shown = " × ".join(f"{length / 10:.1f}" for length in size_mm)
    message = f"the pattern says {largest / 10:.1f} cm; by its gauge and rounds the piece is {shown} cm"
    return [Problem(message, "correct the size, the gauge or the hook", span, built.pattern.text)]


def _seated(code: str) -> re.Pattern[str]:
    said = TERMS[code or WHOLE].heard.said.get("sitting", ())
    return re.compile(rf"\b(?:{'|'.join(said) or '(?!)'})\b", re.IGNORECASE)


def instance(built: Built, part: int) -> str:
    """A part's name as the text calls it: ``Ear.2`` for a second copy."""
    facts = built.parts[part]
    section = built.pattern.parts[facts.section]
    return f"{section.name}.{facts.copy}" if section.copies > 1 else section.name


def _rounds(built: Built) -> Iterator[Problem]:
    """The first round of each part that does not use up the round below: what follows it is out of step by its fault.

    The last round of a part may stop where it likes.
    """
    told: set[int] = set()
    last = {w.part: k for k, w in enumerate(built.worked) if w.line.in_round}
    counted = {p.span for p in built.warnings}
    before: dict[int, bool] = {}  # whether the round before this one of a part is told for its count already
    for k, w in enumerate(built.worked):
        # A partial round before a mark, goto or attach leaves the rest on purpose.
        leaves = k + 1 < len(built.worked) and not built.worked[k + 1].line.in_round
        follows = before.get(w.part, False)
        before[w.part] = w.line.stated_span is not None and w.line.stated_span in counted
        if not (w.ring or _past(w)) or w.left == 0 or w.part in told or w.line.stated_span in counted or follows:
            continue
        if w.left > 0 and (leaves or k == last[w.part] or _stops(w.line.items)):
            continue
        told.add(w.part)
        off = w.line.stated is not None and w.left > 0 and w.made != w.line.stated == w.made + w.left
        at = w.line.stated_span if off and w.line.stated_span is not None else w.line.span
        yield Problem(_uneven(w, off), "correct the repeats, or say where the round begins", at, built.pattern.text)


def _past(w: Worked) -> bool:
    """Whether a row of stitches alone runs past its end. One with strands, chains amid it or stitches into spaces has those to stand on."""
    if w.left >= 0 or not w.below or w.line.gap or w.line.again is not None or not w.line.in_round:
        return False
    return all(name in _ALONG or _KINDLESS.sub("", name) in HEIGHTS for name in _names(w.line.items))


_ALONG: Final = frozenset("turn lift inc dec color blo flo bl skip".split())
_LIFTED: Final = frozenset("turn color blo flo bl".split())
_KINDLESS: Final = re.compile(r"(?:inc|dec)\d*$|\d+$")


def _names(items: tuple[Item, ...]) -> Iterator[str]:
    before: Item | None = None
    for item in items:
        if isinstance(item, Group):
            yield from _names(item.items)
        else:  # a chain amid the row can be worked along; one before its stitches lifts it
            lifts = before is None or (not isinstance(before, Group) and before.name in _LIFTED)
            yield "lift" if item.name == "ch" and lifts else item.name
        before = item


def _uneven(w: Worked, off: bool) -> str:
    if off:
        return f"{SAYS} {w.line.stated} stitches, the round makes {w.made} and leaves {w.left} of those below unworked"
    if w.left > 0:
        return f"this round leaves {w.left} of the {w.below} stitches below it unworked"
    return f"this round needs {w.below - w.left} stitches below it, there are {w.below}"


def _stops(items: tuple[Item, ...]) -> bool:
    """Whether a round ends in a slip stitch: it steps down to the edge and need not go all round."""
    last = items[-1] if items else None
    return _stops(last.items) if isinstance(last, Group) else last is not None and last.name in ("slst", "join", "fo")


def _loose(built: Built) -> Iterator[Problem]:
    """Parts of a pattern with several that nothing holds to the others."""
    graph, pattern = built.graph, built.pattern
    if len([p for p in pattern.parts if p.lines]) < 2:
        return
    parent = list(range(len(graph.parts)))

    def top(k: int) -> int:
        while parent[k] != k:
            k = parent[k]
        return k

    across = graph.part[graph.edges]
    for a, b in np.unique(across[across[:, 0] != across[:, 1]], axis=0).tolist():
        parent[top(a)] = top(b)
    names = {instance(built, k): k for k in range(len(built.parts))}
    for finish in pattern.finish:
        if isinstance(finish, Placed):
            a, b = (names.get(n, names.get(f"{n}.1")) for n in (finish.part, finish.spot.part))
            if a is not None and b is not None:
                parent[top(a)] = top(b)
    stitches = np.zeros(len(parent), int)
    for k, part in enumerate(graph.parts):
        stitches[top(k)] += part.end - part.start
    section = [pattern.parts[built.parts[k].section].name for k in range(len(graph.parts))]
    main = {int(stitches.argmax())}
    for toy in pattern.toys:  # each of several toys stands for itself
        own = [top(k) for k, name in enumerate(section) if name in toy]
        main |= {max(own, key=lambda at: stitches[at])} if own else set()
    worn = {one.part.partition(".")[0] for one in pattern.worn}
    # Clothes, and what has no name, are told together where the assembly was read.
    told = {
        n
        for p in built.warnings
        if p.message.startswith(ASIDE)
        for n in p.message.removeprefix(f"{ASIDE}: ").split(", ")
    }
    for k, part in enumerate(graph.parts):
        if part.end > part.start and top(k) not in main and section[k] not in told | worn:
            name, at = instance(built, k), pattern.parts[built.parts[k].section].span
            yield Problem(
                f"{name} is never sewn on", "say where it goes: on which part, between which rounds", at, pattern.text
            )


def _open(built: Built, off: set[int]) -> Iterator[Problem]:
    """Parts of a printed pattern that are to be stuffed, left open and held to nothing: the stuffing falls out. off : those with a round
    that is told already, which may be all that is amiss."""
    graph, pattern = built.graph, built.pattern
    if not pattern.terms:
        return
    placed = [f for f in pattern.finish if isinstance(f, Placed)]
    held = {f.part for f in placed} | {f.spot.part for f in placed if f.spot.stitch is None}  # a roof closes the walls
    held |= {f.removesuffix(".1") for f in held}
    across = graph.part[graph.edges]
    sewn = set(across[across[:, 0] != across[:, 1]].ravel().tolist())
    for k, part in enumerate(graph.parts):
        section = pattern.parts[built.parts[k].section]
        stuffed = section.stuffing is not None and section.stuffing > 0
        name = instance(built, k)
        if (
            not stuffed
            or k in off
            or part.end == part.start
            or k in sewn
            or name in held
            or name.removesuffix(".1") in held
        ):
            continue
        rim = open_edges(built, k)
        made = next((w.edge for w in reversed(built.worked) if w.part == k and w.line.in_round), rim)
        rim = made if abs(rim - made) == 1 else rim  # where a spiral stops, a step is an edge more
        if rim > 2 and built.parts[k].copy == 1:
            message = f"{name or 'the piece'} is stuffed, and its end of {rim} stitches stays open"
            hint = "decrease and fasten off, or say where it is sewn on"
            yield Problem(message, hint, section.span, pattern.text)


def open_edges(built: Built, part: int) -> int:
    """Edges that bound the fabric of a part."""
    faces = built.graph.faces[built.graph.part[built.graph.faces[:, 0]] == part]
    sides = np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
    if not len(sides):
        return 0
    _, times = np.unique(sides, axis=0, return_counts=True)
    return int((times == 1).sum())


def _materials(built: Built) -> Iterator[Problem]:
    """What a printed pattern uses and does not name. The own language needs no list of materials."""
    pattern = built.pattern
    if not pattern.terms:
        return
    text = pattern.text
    if "yarn" not in pattern.stated and not _YARN.search(text.text):
        yield Problem("the pattern names no yarn", "add a line such as: Yarn: worsted, cream", Span(0, 0), text)
    eyes = [f for f in pattern.finish if isinstance(f, Eye)]
    if "eyes" in pattern.stated:
        words, span = pattern.stated["eyes"]
        listed = {float(n.replace(",", ".")) for n in _EYE.findall(words)}
        for size in dict.fromkeys(e.size for e in eyes):
            if listed and size not in listed:
                at = next(e.span for e in eyes if e.size == size)
                shown = " or ".join(f"{n:g}" for n in sorted(listed))
                yield Problem(f"eyes of {size:g} mm here, {shown} mm in the materials", "make them agree", at, text)
        if not eyes:
            yield Problem("these eyes are never put in", "say between which rounds they go", span, text)


def doubtful(built: Built, problems: list[Problem]) -> Array:
    """The stitches (N,) bool that ``problems`` speak of: those written on the same line, or the whole part of a heading."""
    text, starts = built.pattern.text.text, built.graph.span[:, 0]
    headed = np.array([p.span.start for p in built.pattern.parts], int)
    of = np.array([f.section for f in built.parts], int)
    wrong = np.zeros(len(built.graph), np.bool_)
    for problem in problems:
        if problem.span is None:
            continue
        first = text.rfind("\n", 0, problem.span.start) + 1
        end = text.find("\n", problem.span.start)
        line = (starts >= first) & (starts < (len(text) if end < 0 else end))
        section = np.flatnonzero(headed == problem.span.start)
        if not line.any() and len(section) and len(of):
            line = np.isin(of[built.graph.part], section)
        wrong |= line
    return wrong
