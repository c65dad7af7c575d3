"""Printed patterns, rounds as established: increases or decreases that go on as they began, until there are so many stitches."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.language.stitches import STITCHES
from tambour.crochet.language.tree import Action, Group, Line
from tambour.crochet.printed.cursor import Cursor, NotUnderstood
from tambour.crochet.printed.heads import Head
from tambour.crochet.printed.parts.counted import count_in
from tambour.crochet.printed.rounds.doubts import decided
from tambour.crochet.printed.rounds.items import closes
from tambour.crochet.printed.rounds.reader import Body
from tambour.crochet.printed.rounds.references import until
from tambour.crochet.printed.state import State
from tambour.crochet.printed.tokens import Token, rows
from tambour.crochet.words.numbers import NUMBER, NUMBERS
from tambour.crochet.words.table import TERMS

_MOST: Final = 100  # rounds
_TWO: Final = 2  # rounds of a head that may go on as others did
_SHAPE: Final = r"(?:inc|incs|increases?|increasing|dec|decs|decreases?|decreasing)"
_SO: Final = frozenset(("established", "manner"))
_STEP: Final = re.compile(
    rf"\b{_SHAPE} (?:by )?(\d+)\b(?! (?:more )?times)|\b(\d+) (?:more )?(?:sts?|sc|dc|stitches|{_SHAPE}) (?:evenly )?(?:(?:in|on|per|each|every) ?)+(?:rounds?|rnds?)"
)
_UNTIL: Final = re.compile(
    r"\b(?:until|till|to) (?:you have |there are |you get |you reach |having )?(?:a total of )?(\d+) ?(?:sts?|sc|dc|stitches)?\b"
)
_ROUND: Final = re.compile(
    r"\buntil (?:the )?(?:rnd|round|row) (.*) (?:has been|is|was|have been) (?:worked|done|completed?|made)"
)
"""The round that is the last: "until the rnd '1dc in each of next 7dc, 2dc in next dc' has been worked"."""
_BETWEEN: Final = re.compile(r"(?:next|[(\[*]|^) ?(\d+) (?:sc|dc|sts?|stitches)\b(?! in)")
_TIMES: Final = re.compile(rf"\b({NUMBER}) (?:more )?times\b|\b(twice|thrice)\b")
_EVENLY: Final = re.compile(
    rf"^[~, ]*{_SHAPE} (?:by )?\d+(?: (?:sts?|sc|dc|stitches))?(?: around)?(?: evenly)?(?: \(|$)"
)
_MORE: Final = re.compile(rf"\b({NUMBER}) (?:more |further |additional )?(?:rounds|rnds|round|rnd)\b")


def established(p: State, tokens: list[Token], head: Head | None = None) -> bool:
    """Works rounds that a sentence says as those before: "Cont as established, inc 8 sc every rnd until there are 72 sc", "Cont in this way,
    working 1 extra dc between incs, until there are 54 sts", "… dec 8 sc on next and following 6th rnd", or ``head`` before its words, "9th to
    13th rnds: Cont in this manner, inc 6 sc each rnd. 78 sc."; whether it is such. They are spaced as those of the round before; where that
    does not say how, evenly, which is told."""
    draft = p.parts[-1] if p.parts else None
    if draft is None or not draft.edge or draft.flat or p.mode in ("materials", "abbreviations", "notes"):
        return False
    words = " ".join([t.word for t in tokens])
    several = head is None or len(head.numbers) >= _TWO or head.many >= _TWO
    evenly = (
        head is not None and words.startswith("~") and _EVENLY.match(words) is not None
    )  # "Next 4 rnds: Inc 6 sts evenly spaced. (48)"
    if not several or not (evenly or any(t.word in _SO for t in tokens)):
        return False
    grown = draft.edge - draft.edges.get(draft.last - 1, draft.edge)
    said = _STEP.search(words)
    down = re.search(r"\b(?:dec\w*|decreas\w*)\b", words) is not None
    step = (-1 if down else 1) * int(next(n for n in said.groups() if n)) if said is not None else grown
    if (
        said is None
        and grown > 0
        and re.search(
            r"\b(?:less|fewer) \w+ (?:between|before|after)\b|\b\w+ (?:less|fewer) (?:between|before|after)\b", words
        )
    ):
        return False  # fewer between increases come of no round that grew
    many = len(head.numbers) or head.many if head is not None else 0
    stated = _stated(p, tokens) if head is not None else None
    step = (stated - draft.edge) // many if stated is not None and many and (stated - draft.edge) % many == 0 else step
    shaped = _shaped(p, tokens, words, step, draft.edge, many, _spaced(draft.lines))
    if not step or not shaped or len(shaped) > _MOST:
        return False
    if many and (shaped[-1] + 1 != many or stated not in (None, draft.edge + step * len(shaped))):
        return False
    span = Span(tokens[0].start, tokens[-1].end)
    joined = bool(draft.lines) and closes(draft.lines[-1])
    sc = TERMS[p.language.code].stitches["sc"][0].lower()
    even = f"1 {sc} in each {sc} around"
    bodies: list[Body] = []
    edge, between = draft.edge, _spaced(draft.lines)
    between = between if abs(step) == abs(grown) and (grown > 0) == (step > 0) else None
    for k in range(shaped[-1] + 1):
        shape = "inc" if step > 0 else "dec"
        if k not in shaped:
            said_so = even
        elif between is not None:
            between += 1 if step > 0 else -1
            said_so = f"({between} {sc}, {shape}) {abs(step)} times" if between > 0 else f"{shape} {abs(step)} times"
        else:
            said_so = f"{even}, {shape} {abs(step)} sts evenly spaced"
        words_read = p.vocabulary.read(rows(f"{said_so}{'. Join.' if joined else '.'}")[0].tokens)
        try:
            body = decided(
                p.source, [replace(t, start=span.start, end=span.end) for t in words_read], p.palette, edge, p.phrases
            )
        except NotUnderstood:
            return False
        edge += step if k in shaped else 0
        bodies.append(body)
    if stated is not None:
        bodies[-1].stated, bodies[-1].stated_span = stated, span
    for k, body in enumerate(bodies):
        number = (head.numbers[k],) if head is not None and head.numbers else (draft.last + 1,)
        draft.add(p.source, Head(number, span, 0, False, True), body, span)
    p.understood += 1
    if between is None:
        kind = "increases" if step > 0 else "decreases"
        message = f"rounds as established: {len(bodies)} of them, their {kind} spread evenly"
        p.source.doubt(message, "write them out", span)
    return True


def _shaped(p: State, tokens: list[Token], words: str, step: int, edge: int, many: int, between: int | None) -> range:
    """Which of the rounds to come are shaped, counted from 0; none where the words do not say how long it goes on."""
    at = next((k for k, t in enumerate(tokens) if t.kind == "stitch" and t.value in ("inc", "dec")), 0)
    c = Cursor(tokens)
    every = 2 if any(c.key("other", ahead=k) and c.key("round", ahead=k + 1) for k in range(len(tokens))) else 1
    count = next((n for k in range(len(tokens)) if (n := until(Cursor(tokens, k)))), 0)
    plain = _UNTIL.search(words)
    count = count or (int(plain[1]) if plain is not None else 0)
    ordinal = next((t.value for t in tokens[at:] if t.kind == "ordinal"), 0)
    last = _ROUND.search(words)
    more = _MORE.search(words)
    if step and count and (count - edge) % step == 0 and 0 < (count - edge) // step <= _MOST:
        return range(0, (count - edge) // step * every, every)
    if last is not None and between is not None:
        found = _BETWEEN.search(last[1])
        goal = int(found[1]) if found is not None else 1
        return range(min(abs(goal - between), _MOST + 1))
    if many:
        return range(many)
    if more is not None:
        return range(0, (NUMBERS.get(more[1]) or int(more[1])) * every, every)
    if (times := _TIMES.search(words)) is not None:
        often = {"twice": 2, "thrice": 3}.get(times[2] or "") or NUMBERS.get(times[1]) or int(times[1])
        return range(0, often * every, every)
    if isinstance(ordinal, int) and ordinal > 1 and any(c.key("next", ahead=k) for k in range(at, len(tokens))):
        return range(0, ordinal + 1, ordinal)  # "on next and following 6th rnd"
    return range(0)


def _stated(p: State, tokens: list[Token]) -> int | None:
    """The count behind the last of several rounds: "36 sts.", "(24, 30, 36)"."""
    if tokens[-1].word in (")", "]"):
        numbers = [t.value for t in tokens[-8:] if t.kind == "number"]
        return int(numbers[-1]) if numbers else None
    found = count_in(tokens, p.source.stitches, p.palette)
    return None if found is None else int(found.value)


def _spaced(lines: list[Line]) -> int | None:
    """How many stitches the last round has between its increases, or decreases: 3 of "(3 sc, inc) x 6", 0 of "inc x 6"; None of others."""
    last = lines[-1] if lines else None
    last = last.again.lines[-1] if last is not None and last.again is not None else last
    groups = [i for i in last.items if isinstance(i, Group)] if last is not None else []
    works = [i for i in last.items if isinstance(i, Action) and i.name in STITCHES] if last is not None else []
    plain = [i for i in works if i.name not in ("ch", "slst")]
    if len(groups) == 1 and not plain:
        inner = [i for i in groups[0].items if isinstance(i, Action)]
        if len(inner) == len(groups[0].items) and sum(i.name in ("inc", "dec") for i in inner) == 1:
            others = [i for i in inner if i.name not in ("inc", "dec")]
            return sum(i.times for i in others) if all(i.name == "sc" for i in others) else None
    if len(plain) == 1 and not groups and plain[0].name in ("inc", "dec"):
        return 0
    return None
