"""Printed patterns, accounted: words of a round that its reading passed over stand beside it in print, so that none is lost unsaid."""

from __future__ import annotations

import re
from bisect import bisect_left
from dataclasses import replace
from itertools import pairwise
from typing import Final

from tambour.core.errors import Span
from tambour.core.rgb import RGB
from tambour.crochet.language.tree import Action, Line
from tambour.crochet.printed.parts.bases import UNKNOWN
from tambour.crochet.printed.parts.part import Draft
from tambour.crochet.printed.state import State
from tambour.crochet.printed.tokens import Token

_WORD: Final = re.compile(r"[^\W\d_]{2,}")
_STOPS: Final = frozenset((",", ".", ";", ":", "(", ")", "[", "]", "{", "}", "=", "!", "*", "**", "<", ">", "|", "/", "--", "---"))  # fmt: skip
_USUAL: Final = frozenset(
    """sc inc dec hdc dc tr dtr sl st sts slst ss ch chs stitch stitches rnd rnds round rounds row rows in each every of the
    next and times time around all to from rep repeat into first last second third fourth fifth sixth two three four five six
    seven eight nine ten once twice across join with magic ring circle loop loops only back front both bl fl blo flo blos mr mc
    invdec invinc working work worked turn hook chain make same remaining rem skip sctog hdctog dctog tog together end yarn
    fo fasten off as for until color change then another you there is are be on by st. htr ea beg beginning sp space spaces
    ms fm km lm zun abn runde runden reihe masche maschen jede jeder tour tours rang rangs augm dim maille mailles chaque
    vuelta vueltas cada aum dism pt pts pb toer toeren rij vaste vasten meerd mind elke steek steken""".split()
)
"""Words of rounds that want no second look."""
_QUIET: Final = frozenset(
    """up down out it its this that these those they we our your my now here throughout through any other another others one given follows following
    below above previous prev said just made makes making more rest remaining unworked skipped draw drawing yoh yo alternate alt
    alternately demonstrated shown diagram page photo picture desired progresses completed complete established established
    until while when time start starting begin begins beginning begun continue continuing cont continuous continuously spiral
    spirals count counts counted counting total row rows blocks references foundation evenly either along also again same
    second round rounds around was were has have having had will would should can could may might do does not no so but or an if
    top opposite side sides edge per at by on off over under about between after before again another first last both each
    rep repeat chain chains stitch stitches loop loops hook yarn work works worked working using use way ways total lp lps bump bumps
    pick attach joining joined break cut drop carry pm marker markers mark marked marking place placing placed""".split()
)
"""Words that a round's reading takes in, or that tell a hand nothing by themselves."""
_HOW: Final = ("light", "firm")
UNHEADED: Final = "of this heading only the first yarn is worked with"
_ALIKE: Final = frozenset("alike pieces piece pcs stück parts part both identical yarn".split())
_SMALL_WORDS: Final = re.compile(r"[^\S\n]*(?:[^\W\d_]+[^\S\n]+)*")
_HEADED: Final = 120  # letters of a line that is a heading
_ENDED: Final = re.compile(
    r"\(?\d+ [^\W\d]+ (?:rem(?:ain\w*)? )?(?:at|after) (?:the )?(?:end of )?[^\W\d]+\.? ?\d*\)?", re.IGNORECASE
)
"""A count that says of which round it is: "24 sc at end of Rnd 3"."""
_SMALL: Final = 2  # letters of a yarn's or a stitch's short name


def beside(p: State, draft: Draft) -> list[Line]:
    """A part's lines, each with the clauses of its words that name what nothing of its reading stands for: a hook, a face, a tail that is
    left, the place that a stitch is made for."""
    text = p.source.text.text
    tokens = [t for row in p.rows for t in row.tokens]
    starts = [t.start for t in tokens]
    told = [
        q.span
        for q in (*p.unread, *p.source.problems)
        if q.span is not None and q.span.end > q.span.start and not q.message.startswith(UNKNOWN)
    ]  # an edge that is not known may be found after all
    told += [one.span for one in p.sentences]
    made = []
    rounds = {line.span for line in draft.lines if line.in_round}
    for line in draft.lines:
        span = line.span
        twofold = not line.in_round and span in rounds  # the round of these words has them
        if (
            line.gap
            or twofold
            or span == draft.span
            or not (line.items or line.again)
            or not _looked_at(text[span.start : span.end])
        ):
            made.append(line)
            continue
        some = tokens[bisect_left(starts, span.start) : bisect_left(starts, span.end)]
        known = [*told, *line.notes]
        left = [
            s
            for s in _passed(p, line, p.vocabulary.read(_parted(text, some)))
            if not any(k.start < s.end and s.start < k.end for k in known)
        ]
        made.append(replace(line, notes=tuple(sorted((*line.notes, *left), key=lambda s: s.start))) if left else line)
    return made


def headed(p: State, draft: Draft) -> None:
    """Puts beside a part's first round what its heading says besides name, copies and yarn ("worked flat", "then white for the last row"), so
    that it is printed; where that names a yarn or a number, which the work may want, it is told too."""
    text = p.source.text.text
    name = [w.rstrip("s") for w in draft.name.lower().split()]
    begin = text.rfind("\n", 0, draft.span.start) + 1
    end = text.find("\n", begin)
    first = next(
        (k for k, line in enumerate(draft.lines) if line.in_round and line.span.start > draft.span.start), None
    )
    end = min(
        len(text) if end < 0 else end,
        *(line.span.start for line in draft.lines if line.span.start > draft.span.start),
        len(text),
    )
    row = next(
        (row for row in p.rows if row.tokens and row.tokens[0].start <= draft.span.start <= row.tokens[-1].end), None
    )
    if (
        first is None
        or row is None
        or not name
        or row.tokens[0].start in p.hued
        or name[0] not in text[begin:end].lower()
        or end - begin > _HEADED
    ):
        return
    told = [q.span for q in (*p.unread, *p.source.problems) if q.span is not None and q.span.end > begin]
    worked = {i.numbers for line in draft.lines for i in line.items if isinstance(i, Action) and i.name == "color"}
    hued, left, clause = False, [], []
    for token in [*(t for t in p.vocabulary.read(_parted(text, row.tokens)) if t.end <= end), None]:
        if token is not None and not (token.kind == "mark" and token.word in _STOPS):
            clause.append(token)
            continue
        span = Span(clause[0].start, clause[-1].end) if clause else Span(0, 0)
        named = (
            bool(clause) and clause[0].start <= row.tokens[0].start + 1
        )  # "PUMPKIN (orange)" is no yarn of that name
        hues = [] if named else [hue for t in clause if (hue := _hue(p, t)) is not None]
        rest = [
            t
            for t in clause
            if t.word.isalpha() and _hue(p, t) is None and not _quiet(t) and t.word.rstrip("s") not in name
        ]
        if clause and not any(s.start < span.end and span.start < s.end for s in told):
            if hued and any(hue not in worked for hue in hues):
                p.tell(UNHEADED, "say it on a line of its own, before the round", span)
            elif any(t.value == "hook" for t in clause) or len(rest) > bool(hues):
                left.append(span)
        hued, clause = hued or bool(hues) or (len(clause) == 1 and clause[0].capital and len(clause[0].word) == 1), []
    if left:
        line = draft.lines[first]
        draft.lines[first] = replace(line, notes=(*left, *line.notes))


def _hue(p: State, token: Token) -> RGB | None:
    """The yarn that a word of a heading names."""
    if token.capital and len(token.word) == 1:
        return p.palette.given.get(token.word)
    return p.palette.name(token.word) if token.kind == "word" else None


def _quiet(token: Token) -> bool:
    return (
        len(token.word) <= _SMALL
        or token.kind in ("key", "number", "ordinal")
        or token.word in _QUIET
        or token.word in _USUAL | _ALIKE
    )


def _parted(text: str, tokens: list[Token]) -> list[Token]:
    """``tokens`` with a comma for every stroke that stands between words, and not within one."""
    return [
        replace(t, word=",")
        if t.kind == "mark" and (text[t.start : t.end] in ("–", "—") or text[t.start - 1 : t.end + 1] == " - ")
        else t
        for t in tokens
    ]


def _looked_at(words: str) -> bool:
    return any(m[0].lower() not in _USUAL for m in _WORD.finditer(words))


def _passed(p: State, line: Line, tokens: list[Token]) -> list[Span]:
    """The clauses of a line that hold a word which its reading does not stand for; those that follow each other are one."""
    text = p.source.text.text
    made: list[Span] = []
    clause: list[Token] = []
    joined, begin = False, line.span.start
    for token in [*tokens, None]:
        if token is not None and not (token.kind == "mark" and token.word in _STOPS):
            clause.append(token)
            continue
        if clause and _says(p, line, clause):
            if _ENDED.fullmatch(" ".join(text[clause[0].start : clause[-1].end].split())):
                clause, joined, begin = [], False, clause[-1].end
                continue
            led = text[begin : clause[0].start]  # small words are no tokens: "this will be the front"
            at = clause[0].start - len(led.lstrip()) if _SMALL_WORDS.fullmatch(led) else clause[0].start
            span = Span(at, clause[-1].end)
            made[-1:] = [Span(made[-1].start, span.end)] if joined else [*made[-1:], span]
            joined = token is not None and token.word == ","
        elif clause:
            joined = False
            stuffs = any(t.value == "stuff" for t in clause)
            made += [
                t.span for t in clause if t.kind == "key" and t.value in _HOW and not stuffs
            ]  # "sc around, loosely"
        clause = []
        begin = token.end if token is not None else begin
    return made


def _says(p: State, line: Line, clause: list[Token]) -> bool:
    """Whether a clause holds a word that the tree does not."""
    hooked = any(t.kind == "key" and t.value == "hook" for t in clause)
    if hooked and not any(t.value in ("from", "ch") or t.word in _QUIET for t in clause):
        return True  # "with smaller hook"
    if any(t.value == "join" for t in clause) and any(
        a.kind == "ordinal" and a.value != 1 and (b.kind == "stitch" or b.value == "stitch")
        for a, b in pairwise(clause)
    ):
        return True  # "Join A with sl st to 9th sc of last rnd"
    works = line.again is not None or any(t.kind == "stitch" or t.kind == "number" for t in clause)
    for token in clause:
        if token.kind != "word" or len(token.word) <= _SMALL or token.word in _QUIET or not token.word.isalpha():
            continue
        if p.palette.name(token.word) is not None or (works and _names(p, token.word)):
            continue
        return True
    return False


def _names(p: State, word: str) -> bool:
    """Whether a word is of a part's name: "12 sc of First Leg", "as given for Head"."""
    return any(word.rstrip("s") in (w.rstrip("s") for w in draft.name.lower().split()) for draft in p.parts)
