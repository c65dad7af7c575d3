"""Printed patterns, reworked: rounds that are written elsewhere, worked once more ("as Rnds 2-4 of Head", "rep last 2 rnds 3 times")."""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import accumulate
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.graph.hook import LIFT
from tambour.crochet.language.source import Source
from tambour.crochet.language.tree import Action, Again, Item, Line, written
from tambour.crochet.places.names import kind_of
from tambour.crochet.places.names import one as singular
from tambour.crochet.printed.between.unread import NOT_UNDERSTOOD
from tambour.crochet.printed.cursor import Refers
from tambour.crochet.printed.heads import Head
from tambour.crochet.printed.parts.naming import figured, named, version
from tambour.crochet.printed.parts.part import MARKED, MOST_ROUNDS, Draft
from tambour.crochet.printed.parts.recolored import Dye, banded, dye, recolored
from tambour.crochet.printed.parts.redyed import dressed, redyed, turned_to
from tambour.crochet.printed.rounds.items import closes, sets_mark, works
from tambour.crochet.printed.rounds.reader import Body
from tambour.crochet.printed.rounds.reckoned import after, rounds_until
from tambour.crochet.printed.state import State

_LONG: Final = 200  # characters of what a sentence says behind its reference
_SENTENCE: Final = re.compile(r"[.;](?:\s|$)|\n\s*\n")


def again(p: State, draft: Draft, head: Head | None, body: Body, span: Span) -> bool:
    """Rounds that are written elsewhere, worked once more; False where they are not there."""
    source, parts = p.source, p.parts
    refers = body.refers
    assert refers is not None
    names = [one.name for one in parts]
    meant = figured([(one.name, one.over) for one in parts], refers.part) if refers.part else None
    meant = named(names, refers.part) if refers.part and meant is None else meant
    origin = draft if not refers.part or meant == -1 else None if meant is None else parts[meant]
    if origin is None and refers.part:
        meant = version([(one.name, one.over) for one in parts[:-1]], draft.name, refers.part)
        origin = None if meant is None else parts[meant]
    if origin is None and refers.part and parts and not parts[0].name and _trunk(refers.part):
        origin = parts[0]  # "Rounds 1-5 of head", where no heading stands over the first part
    if refers.marks and (origin is None or origin.between(refers.marks) is None):
        marks = refers.marks
        origin = next((one for one in reversed(parts) if one.between(marks) is not None), origin)
    if origin is None:
        return False
    lines = origin.referred(refers)
    bare = origin is not draft and [line.number for line in lines[:2]] == [None, 1]
    lines = lines[1:] if bare else lines  # the ring above Round 1 is none of the rounds that numbers mean
    gaps = [i for line in lines[:1] for i in line.items if line.gap and line.stated is None and isinstance(i, Action)]
    guessed = any(i.name == "gap" and i.numbers[:1] != (draft.edge,) for i in gaps)
    if not lines or guessed or any(line.span.start in origin.spread for line in lines):
        return False
    marked = _marked(lines, draft) if origin is not draft else None
    lines = marked or tuple(replace(line, items=tuple(i for i in line.items if not sets_mark(i))) for line in lines)
    numbers = head.numbers if head is not None else ()
    once = sum(line.times for line in lines)
    total = len(numbers) or (head.many if head is not None and head.many > 1 else once * (refers.times or 1))
    if numbers and refers.times and body.stated is not None and once * refers.times != total:
        fair = [n for n in (total, once * refers.times) if _reach(lines, n, draft.edge, source) == body.stated]
        message = f"{total} rounds are said here, and {once * refers.times} further on"
        source.doubt(message, "make them agree", refers.span, True)
        total = fair[0] if len(fair) == 1 else total
    alike = tuple(written(origin.lines, numbers[0], numbers[-1])) if len(numbers) > once and refers.numbers else ()
    fits = alike and body.stated is not None and sum(one.times for one in alike) == total
    if fits and origin is not draft and _reach(alike, total, draft.edge, source) == body.stated:
        # "Rounds 1-6: same as Rounds 1-5 of Head, 36 sc"
        message = f"{total} rounds are said here, and {once} there: the count speaks for {total}"
        source.doubt(message, "make them agree", refers.span, True)
        lines, once = alike, total
    if total > once and total % once and origin is not draft and not refers.times:
        message = f"{total} rounds are said here, and {once} there: {once} are worked"
        source.doubt(message, "make them agree", refers.span, True)
        total = once
    if refers.length is not None:
        joined = "join" in source.text.text[refers.span.start : refers.span.end].lower()
        done = draft.last if refers.whole else _since_join(draft) if joined else 0
        total = max(once, round(refers.length / p.height()) - done)
        message = f"so many rounds as make {refers.length:.0f} mm: {total}, by the gauge"
        source.doubt(message, "a number of rounds would be sure", refers.span)
    if refers.upto and not (total := refers.upto - draft.last) > 0:
        return False
    if refers.vague:
        message = "how long this goes on is said by no number: it is worked once"
        source.doubt(message, "say the rounds, or a length in inches or cm", refers.span)
    if refers.until and not (total := rounds_until(lines, draft.edge, refers.until, source.stitches)):
        return False
    how, plain = _other_yarns(p, refers), draft.begun()
    before_chain: Action | None = None  # the yarn that the chain below is worked in too
    if refers.mirrored:
        source.doubt("sides are not reversed here", "write the mirrored rounds out", refers.span)
    if not draft.begun() or draft.chain is not None:
        first = next(k for k, one in enumerate(origin.lines) if one.in_round and not (bare and one.number is None))
        if lines[0].number == origin.lines[first].number and origin is not draft:
            hues = [
                (line, tuple(i for i in line.items if isinstance(i, Action) and i.name == "color"))
                for line in draft.lines
            ]
            own = [replace(line, items=said) for line, said in hues if said]
            dye = next((i for i in body.items[:1] if isinstance(i, Action) and i.name == "color"), None)
            if not own and how is None and dye is not None and dye.span.start < refers.span.start:
                own, before_chain = [Line((dye,), dye.span, False)], dye
            # "With B, work as for Head" is worked in B.
            begun = [_undyed(line) if own else line for line in origin.lines[:first]]
            begun = recolored(begun, how, True) if how is not None and how.swaps and begun else begun
            plain = plain or bool(own)
            draft.lines, draft.chain, draft.flat = [*own, *begun], None, origin.flat
    number = numbers[0] if numbers else draft.last + 1
    at = head.span if head is not None and numbers else refers.span
    first_number, last_number = lines[0].number or 0, (lines[-1].number or 0) + lines[-1].times - 1
    if total < once and refers.times is None and lines[0].number:
        last_number = lines[0].number + total - 1  # "Rounds 1-3: as for Body" are its first three
    if number + total > MOST_ROUNDS:
        source.error(f"more than {MOST_ROUNDS:,} rounds in one part", "a lower number", at)
        return True
    lines = dressed(lines, origin.lines, origin is draft and total > 1)
    moves, lines = _lifted(draft, lines)
    # Lines that work others again, as those others: round upon round said so would lead too deep.
    lines = tuple(one for line in lines for one in ((line,) if line.again is None else line.rounds()))
    said = [i for i in body.items if isinstance(i, Action) and i.name in ("color", "turn")]
    if how is not None and how.only is None:
        lines = tuple(recolored(list(lines), how, plain or any(i.name == "color" for i in said)))
        body.hues = []
    later = tuple(i for i in said if i.span.start > refers.span.start)  # "Rep Row 2 changing to B in last sc"
    midway = [(hue, n) for hue, n in body.later if isinstance(hue, Action) and 0 <= n - first_number < total - 1]
    later += tuple(hue for hue, n in body.later if isinstance(hue, Action) and (hue, n) not in midway)
    lead = (*moves, *(i for i in said if i.name == "color" and i not in later))
    first_dyes = {i.numbers for i in lead if i.name == "color"}
    if how is None and not body.hues and len(first_dyes) == len(_dyes(lines)) == 1 and first_dyes != _dyes(lines):
        lines = tuple(_undyed(line) for line in lines)  # "With B, rep Rnds 7-9", which are all in A
    lead = tuple(i for i in lead if i is not before_chain)
    again = Again(lines, first_number, last_number, "" if origin is draft else origin.name, refers.span)
    notes = (how.span,) if how is not None else ()  # stands beside what is printed as a reference again
    line = Line(lead, span, True, total, at, number, body.stated, body.stated_span, again, notes)
    if numbers and head is not None:
        draft._numbered(source, head, True)
    made = redyed(line, origin.lines, body.hues) if body.hues else list(line.rounds()) if midway else [line]
    made = turned_to(made, midway, first_number)
    if how is not None and how.only is not None:
        made = banded(list(line.rounds()), how, first_number)
    dyes = _dyes(lines)
    if body.hues and how is None and max(len(body.hues), len(dyes)) > 1:
        message = "these yarns are taken in the order in which colours come there"
        source.doubt(message, "nothing is amiss", refers.span)
    if marked and not body.hues:
        made = list(line.rounds())  # written out, so that they hold marks of their own
    draft.lines += [*made, *([Line(later, span, False)] if later else [])]
    ended = next((i for i in body.items if isinstance(i, Action) and i.name == "fo"), None)
    draft.off = ended.span if ended is not None else draft.off  # "As 4th rnd. Fasten off."
    draft.last, before = number + total - 1, draft.edge
    kept: dict[str, int | None] = {}
    for one in line.rounds():
        back = next((i.labels[0] for i in one.items if isinstance(i, Action) and i.name == "goto"), "")
        items = [i for i in one.items if not sets_mark(i)]
        before, draft.edge = draft.edge, after(items, kept.get(back, draft.edge), source.stitches)
        kept |= {i.labels[0]: draft.edge for i in one.items if isinstance(i, Action) and i.name == "mark"}
        draft.peak = max(draft.peak, draft.edge or 0)
    if draft.other is not None:
        for one in line.rounds():
            draft.other = after(one.items, draft.other, source.stitches)
    if body.stated is not None:
        draft.other = body.stated if draft.edge is not None and draft.edge != body.stated else None
    draft.edge = draft.edge if draft.edge is not None else body.stated
    if draft.edge is not None:
        draft.edges[draft.last] = draft.edge
    draft.shrunk = draft.edge is not None and before is not None and draft.edge < before
    return True


def allotted(draft: Draft, head: Head, refers: list[Refers]) -> list[Head | None]:
    """The head of each of several references behind one, "Rnds 35-48: Rep Rnds 11-13 4 times, then Rnds 11 and 12": its numbers shared out
    among them; None for each where they are not as many rounds as they have numbers, or are one."""
    many = [sum(line.times for line in draft.referred(one)) * (one.times or 1) for one in refers]
    plain = all(not (one.part or one.length or one.until or one.upto or one.vague) for one in refers)
    if len(refers) < 2 or not plain or sum(many) != len(head.numbers):
        return [None] * len(refers)
    ends = list(accumulate(many))
    return [replace(head, numbers=head.numbers[b - n : b]) for n, b in zip(many, ends, strict=True)]


def _trunk(words: str) -> bool:
    """Whether words name a head or a body, what a toy's text may begin with under no heading of its own."""
    return bool({kind_of(singular(w)) for w in words.lower().split()} & {"head", "body"})


def _since_join(draft: Draft) -> int:
    """How many rounds have been worked since two pieces were joined to one, that one too; all where none were: it begins at a join."""
    joins = [
        k for k, one in enumerate(draft.lines) if any(isinstance(i, Action) and i.name == "attach" for i in one.items)
    ]
    return sum(one.times for one in draft.lines[joins[-1] :] if one.in_round) if joins else draft.last


def _other_yarns(p: State, refers: Refers) -> Dye | None:
    """What the sentence of a reference says of its yarns; told where they are not known."""
    text, begin = p.source.text.text, refers.span.start
    stop = _SENTENCE.search(text, refers.span.end, refers.span.end + _LONG)
    how = dye(text[begin : stop.start() if stop else refers.span.end + _LONG], begin, p.palette)
    if how is not None and how.unknown:
        p.tell(NOT_UNDERSTOOD, "name yarns that the list of materials has", how.span)
        return None
    return how


def _dyes(lines: tuple[Line, ...]) -> set[tuple[float, ...]]:
    """The colours that lines change to."""
    return {i.numbers for one in lines for i in one.items if isinstance(i, Action) and i.name == "color"}


def _undyed(line: Line) -> Line:
    """A line without its colours."""
    return replace(line, items=tuple(i for i in line.items if not (isinstance(i, Action) and i.name == "color")))


def _marked(lines: tuple[Line, ...], draft: Draft) -> tuple[Line, ...] | None:
    """``lines`` that go back to a round among them ("in unworked back loops of Round 3"), with marks that are the part's own; None where
    they go back nowhere."""
    found = [i for line in lines for one in line.rounds() for i in one.items if isinstance(i, Action) and sets_mark(i)]
    back = {i.labels[0] for i in found if i.name == "goto"} & {i.labels[0] for i in found if i.name == "mark"}
    if not back:
        return None

    def own(item: Item) -> Item | None:
        if not isinstance(item, Action) or not sets_mark(item):
            return item
        label = f"{draft.name or 'piece'}_{item.labels[0].rpartition('_')[2]}".replace(" ", "_").lower()
        return replace(item, labels=(label,)) if item.labels[0] in back else None

    return tuple(replace(line, items=tuple(j for i in line.items if (j := own(i)) is not None)) for line in lines)


def _lifted(draft: Draft, lines: tuple[Line, ...]) -> tuple[tuple[Action, ...], tuple[Line, ...]]:
    """``lines`` as they go on from the last one, and what comes before them: where that says no join and no turn, the
    chains that they begin with would be worked as stitches."""
    first = next((i for i in lines[0].items if not isinstance(i, Action) or i.name != "color"), None)
    moved = any(isinstance(i, Action) and i.name in ("join", "turn") for i in lines[0].items[:2])
    if moved or not (isinstance(first, Action) and first.name == "ch" and first.times <= LIFT):
        return (), lines
    last = _resolved(draft.lines[-1]) if draft.lines else None
    move = Action("turn" if draft.flat else "join", first.span)
    if not closes(_resolved(lines[-1])):
        return (), (replace(lines[0], items=(move, *lines[0].items)), *lines[1:])
    return (() if last is None or closes(last) or not any(map(works, last.items)) else (move,)), lines


def _resolved(line: Line) -> Line:
    """The round that a line works again, which says how it ends; the line itself where it says its own."""
    while line.again is not None:
        line = line.again.lines[-1]
    return line


def _reach(lines: tuple[Line, ...], total: int, edge: int | None, source: Source) -> int | None:
    """Stitches on the edge after so many rounds, ``lines`` again and again."""
    every = [one for line in lines for one in line.rounds()]
    for k in range(min(total, MARKED)):
        edge = after(every[k % len(every)].items, edge, source.stitches)
    return edge
