"""Reshape: one part of a written pattern gets another outline; its rounds stay where they fit, all other text as it is."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import dataclass
from itertools import groupby, pairwise
from typing import TYPE_CHECKING

from tambour.core.errors import Problem, Span, TambourError, Text, did_you_mean
from tambour.crochet.graph.built import Built, Done
from tambour.crochet.model.outline import Outline
from tambour.crochet.model.readable import period
from tambour.crochet.model.recount import DRAWN, chosen, kept, wanted
from tambour.crochet.model.rounds import even
from tambour.crochet.settle.snug import stretch

if TYPE_CHECKING:
    from tambour.crochet.params import CrochetParams
    from tambour.crochet.piece import Plush

_HEAD = re.compile(r"(?P<word>[ \t*•-]*(?:R|Rnd|Rnds|Round|Rounds)?[ \t.]*)(?P<first>\d+)?(?P<more>[ \t]*[-–][ \t]*(?:R|Rnd)?[ \t]*\d+)?[ \t]*:", re.I)  # fmt: skip
_SIMPLE = re.compile(r"[\s\d,.;()\[\]x*×=-]*(?:(?:sc|inc|dec|in|BLO|FLO|mr|magic|ring|around|each|st|sts|stitches|rounds?|rnds?)[\s\d,.;()\[\]x*×=-]*)*(?:#.*)?$", re.I)  # fmt: skip


_COUNT = re.compile(r"\(\d+\)|\[\d+\]|\{\d+\}")


@dataclass(frozen=True, slots=True)
class Row:
    """A round as it is written: its count, the line (start and end in the text) that it is one of, its number, and whether
    the line holds nothing but single crochets, increases and decreases; loop : "BLO, ", "FLO, " or ""."""

    count: int
    line: tuple[int, int]
    number: int | None
    simple: bool
    loop: str


def source(piece: Plush) -> Text:
    """The pattern's own text, as it was read and redrawn."""
    return piece.built.pattern.whole or piece.built.pattern.text


def rows(built: Built, part: int) -> list[Row] | str:
    """The rounds of a part that is worked round upon round from a ring; else why it is not."""
    text = built.pattern.text.text
    made: list[Row] = []
    for w in (w for w in built.worked if w.part == part and w.line.in_round):
        if made and (not w.ring or w.below != made[-1].count or w.left):
            return f"round {w.line.number or len(made) + 1} does not go on from the whole round before it"
        start = text.rfind("\n", 0, w.line.span.start) + 1
        end = text.find("\n", w.line.span.end)
        line = (start, len(text) if end < 0 else end)
        said = text[line[0] : line[1]]
        head = _HEAD.match(said)
        body = said[head.end() :] if head else said
        found = re.search(r"\b(BLO|FLO)\b", body)
        made.append(Row(w.edge, line, w.line.number, bool(_SIMPLE.match(body)), f"{found[1]}, " if found else ""))
    if len(made) < 3:
        return "it has fewer than three rounds"
    if not any(d.what == "mr" for d in _log(built, part)):
        return "it does not begin in a magic ring"
    return made


def _log(built: Built, part: int) -> list[Done]:
    parts = -1
    mine = []
    for done in built.log:
        parts += done.what == "part"
        if parts == part:
            mine.append(done)
    return mine


def reshaped(
    built: Built,
    outlines: list[Outline],
    name: str,
    params: CrochetParams,
    stitch: tuple[float, float],
    warn: Callable[[Problem], None],
) -> Text:
    """The text of a pattern with the outlines of parts drawn anew.

    built : the pattern, worked; outlines : in mm, upright, each called as its part; a single one may have no name
    name : the part of a single outline, "" where it is called so itself, or the pattern has only one
    stitch : width and height of a single crochet, mm. Raises TambourError with the remedy.
    """
    from tambour.crochet.model.profile import outline_of

    text = built.pattern.text
    if built.pattern.terms not in ("", "us"):
        hint = "write it in tambour's own language first: -o mine.acl"
        raise TambourError(
            "only rounds in tambour's language and in US terms can be written anew", hint=hint, where=text.name
        )
    changes: list[tuple[int, int, str]] = []
    for outline, part in _meant(built, outlines, name):
        mine = rows(built, part)
        section = built.pattern.parts[built.parts[part].section]
        if isinstance(mine, str):
            raise TambourError(
                [Problem(f"{section.name or 'the piece'} cannot be reshaped: {mine}", _ONLY, section.span, text)]
            )
        for row in mine:
            head = _HEAD.match(text.text[row.line[0] : row.line[1]])
            if head is None or (row.number is not None and head["first"] is None):
                hint = "head rounds as Rnd 3: or R3:, or write it in tambour's own language first: -o mine.acl"
                raise TambourError([Problem("this round's head would not be kept", hint, Span(*row.line), text)])
        old = outline_of(built, part, params, stitch)
        new = _laid(outline, built, stitch[0])
        changes += _changes(built, part, mine, old, new, stitch, warn)
    made = text.text
    for start, end, words in sorted(changes, reverse=True):
        made = made[:start] + words + made[end:]
    return Text(made, text.name)


def _laid(outline: Outline, built: Built, width: float) -> Outline:
    """The outline from where the work begins: its closed end, if it has one; else the end that is below, or with
    ``@up = start`` above."""
    low, high = (2.0 * math.pi * float(r) / width > DRAWN for r in outline.line[[0, -1], 0])
    turned = low if low != high else built.up == "start"
    return Outline(outline.line[::-1] if turned else outline.line)


_ONLY = "what is redrawn begins in a magic ring and goes on round upon round"


def _meant(built: Built, outlines: list[Outline], name: str) -> list[tuple[Outline, int]]:
    """Which part each outline is meant for."""
    known = {
        (built.pattern.parts[f.section].name or "piece").lower(): k for k, f in reversed([*enumerate(built.parts)])
    }
    names = [built.pattern.parts[k].name or "piece" for k in range(len(built.pattern.parts))]
    if name:
        chosen_ = [o for o in outlines if o.name.lower() == name.lower()] or outlines
        if len(chosen_) > 1:
            raise TambourError(
                f"there are {len(chosen_)} lines for {name}", hint=f'name one of them "{name}"', where="{--reshape}"
            )
        found = [(chosen_[0], name)]
    elif len(outlines) == 1 and len(names) == 1:
        found = [(outlines[0], names[0])]
    else:
        found = [(o, o.name) for o in outlines]
    problems = [
        Problem(
            f'there is no part "{said}"' if said else "a line has no name, and there are several parts",
            did_you_mean(said.lower(), known) or f"the parts are {', '.join(names)}",
            where="{--reshape}",
        )
        for _, said in found
        if said.lower() not in known
    ]
    if problems:
        raise TambourError(problems)
    return [(o, known[said.lower()]) for o, said in found]


def _changes(
    built: Built,
    part: int,
    mine: list[Row],
    old: Outline,
    new: Outline,
    stitch: tuple[float, float],
    warn: Callable[[Problem], None],
) -> list[tuple[int, int, str]]:
    """What is put in the place of which stretches of the text."""
    text = built.pattern.text
    now = [row.count for row in mine]
    here = built.graph.parts[part]
    width, high = (side * (1.0 + stretch(here.stuffing)) for side in stitch)
    closed = bool((built.graph.peculiarity[here.start : here.end] == 2).any())
    goal = wanted(now, old, new, high, width, closed)
    serve = kept(now, goal)
    counts = chosen(goal, [now[k] if k >= 0 else None for k in serve], 0.5)
    same = [
        k >= 0 and counts[j] == now[k] and (counts[j - 1] == now[k - 1] if j and k else j == k)
        for j, k in enumerate(serve)
    ]
    if all(same) and serve == list(range(len(now))):
        return []
    lost = {
        row.line: row
        for k, row in enumerate(mine)
        if not row.simple and k not in [s for s, ok in zip(serve, same) if ok]
    }
    for row in lost.values():
        warn(
            Problem(
                "this round is redrawn: what it has beside sc, inc and dec is left out",
                "work it in again by hand",
                Span(*row.line),
                text,
                warning=True,
            )
        )
    first = mine[0].number or 1
    numbered = any(row.number is not None for row in mine)
    word = next(
        (m["word"] for row in mine if (m := _HEAD.match(text.text[row.line[0] : row.line[1]])) and m["first"]), "R"
    )
    ends = next((m[0] for row in mine if (m := _COUNT.search(text.text[row.line[0] : row.line[1]]))), "(0)")
    count = ends[0] + "{}" + ends[-1]
    # What every round says, and the line of hers that it is from.
    said: list[tuple[str, tuple[int, int] | None]] = []
    for j, k in enumerate(serve):
        if same[j]:
            line = mine[k].line
            head = _HEAD.match(text.text[line[0] : line[1]])
            said.append((text.text[line[0] + (head.end() if head else 0) : line[1]], line))
        elif j:
            loop = mine[k].loop if k >= 0 else ""
            said.append((f" {loop}{_words(counts[j - 1], counts[j], j)} {count.format(counts[j])}", None))
        else:
            ring = f"{counts[0]} sc in magic ring" if built.pattern.terms else f"MR({counts[0]})"
            said.append((f" {ring} {count.format(counts[0])}", None))
    # Lines between rounds (colours, marks, remarks) stay before the round that they stood before.
    lines = list(dict.fromkeys(row.line for row in mine))
    between = {b: text.text[a[1] : b[0]].strip("\n") for a, b in pairwise(lines)}
    starts = {line: next(k for k, row in enumerate(mine) if row.line == line) for line in lines}
    place = [next((k for k in serve[j:] if k >= 0), len(now) - 1) for j in range(len(serve))]
    out: list[str] = []
    waiting = lines[1:]
    j = 0
    for body, group in groupby(said, key=lambda one: one[0]):
        from_ = [line for _, line in group]
        many, own = len(from_), from_[0] if len(set(from_)) == 1 else None
        while waiting and starts[waiting[0]] <= place[j]:
            if between[waiting[0]]:
                out.append(between[waiting[0]])
            waiting.pop(0)
        a, b = first + j, first + j + many - 1
        if own is not None and [r.number for r in mine if r.line == own] == list(range(a, b + 1)):
            out.append(text.text[own[0] : own[1]])
        elif numbered and word.strip() == "R":
            out.append(f"{word}{a}{f'-R{b}' if b > a else ''}:{body}")
        elif numbered:
            out.append(f"{word.rstrip()}{'s' if b > a else ''} {a}{f'-{b}' if b > a else ''}:{body}")
        else:
            out.append(f"{many if many > 1 else ''}:{body}")
        j += many
    out += [between[line] for line in waiting if between[line]]
    if _mentioned(built, part):
        name = built.pattern.parts[built.parts[part].section].name
        told = f"{len(goal)} rounds now, it had {len(now)}" if len(goal) != len(now) else "other counts now"
        hint = "look whether they are still meant"
        warn(
            Problem(
                f"{name} has {told}: what is sewn or put on it stays at the rounds and stitches that are written",
                hint,
                where=text.name,
                warning=True,
            )
        )
    return [(lines[0][0], lines[-1][1], "\n".join(out))]


def _mentioned(built: Built, part: int) -> bool:
    name = built.pattern.parts[built.parts[part].section].name
    return bool(name) and any(name in str(record) for record in built.pattern.finish)


def _words(below: int, above: int, number: int) -> str:
    """A round from ``below`` to ``above`` stitches, its changes spread evenly, and staggered from round to round."""
    words = list(even(below, above, 0.5 * (number % 2)).words)
    unit = period(words)
    runs = [(w, len(list(g))) for w, g in groupby(words[:unit])]
    told = ", ".join(w if n == 1 else f"{n} {w}" for w, n in runs)
    times = len(words) // unit
    if times == 1:
        return told
    return f"{times} {words[0]}" if unit == 1 else f"[{told}] x {times}"
