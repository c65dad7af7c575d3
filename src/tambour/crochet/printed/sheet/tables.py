"""Printed patterns, tables: rounds set in columns, of their number, their words and their stitches: ``1 | 6 sc in MR | 6``, pasted with or without signs
between them, as other patterns write them: ``1: 6 sc in MR (6)``."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from tambour.crochet.printed.cursor import OPEN
from tambour.crochet.printed.tokens import Row, Token
from tambour.crochet.printed.wordings.vocabulary import Vocabulary
from tambour.crochet.words.table import TERMS

_RUN: Final = 3  # rows of numbers that follow each other, before they are a table's without a line of titles
_TITLES: Final = 8  # words of a line that says what the columns hold
_TOTALS: Final = frozenset("total totals count counts # sts st maschenzahl anzahl totaal nombre no".split())
_WORDED: Final = frozenset(
    "instruction instructions pattern directions description what anleitung beschreibung instrucciones explications instructie patroon".split()
)
_ROWS: Final = frozenset(("rows", "reihen", "rangs", "filas", "toeren"))
_HEADED: Final = 3  # lines above a table among which its heading may say that it is in rows
_RANGED: Final = ("-", "&", "/", "~")
_MOST: Final = 400  # of a number of a round


def tabled(text: str, rows: list[Row], vocabulary: Vocabulary) -> list[Row]:
    """``rows`` with those of tables as lines of rounds; their titles pass as they stand."""
    made = list(rows)
    called = TERMS[vocabulary.code].words["round"][0].lower()
    k = 0
    while k < len(rows):
        if not rows[k].tokens:
            k += 1
            continue
        titled = _titles(rows[k].tokens, vocabulary)
        run = _run(rows, k + (titled is not None), vocabulary)
        known = titled is not None and run
        if known or len(run) >= _RUN:
            counted = titled is not None and titled[1]
            first = titled is not None and titled[0]
            ruled = any(t.word == "|" for t in rows[run[0]].tokens)
            first = first or (titled is None and ruled and all(_counted(rows[at].tokens) for at in run))
            if hued := _hued(rows[k].tokens) if titled is not None and ruled else 0:
                for at in run:
                    made[at] = _dyed(made[at], hued)
            above = [row for row in rows[max(0, run[0] - _HEADED) : run[0]] if row.tokens]
            flat = any(t.word in _ROWS for row in above for t in row.tokens)
            named = TERMS[vocabulary.code].words["row"][0].lower() if flat else called
            for n, at in enumerate(run if first or not ruled else []):
                _set(text, made, at, run[n + 1] if n + 1 < len(run) else at + 2, counted, first, named)
            if known and (first or not ruled):
                made[k] = replace(rows[k], tokens=[])
            k = run[-1]
        k += 1
    return made


def _titles(tokens: list[Token], vocabulary: Vocabulary) -> tuple[bool, bool] | None:
    """Whether a line says what columns hold, the first the round: whether the stitches stand before the words, and whether any column has them."""
    words = [t for t in tokens if t.kind == "word" or t.word == "#"]
    if not 1 < len(words) <= _TITLES or any(t.kind in ("number", "ordinal") or t.word in ":.," for t in tokens):
        return None
    read = vocabulary.read(tokens)
    if not read:
        return None
    first, *rest = read
    if first.kind != "key" or first.value not in ("round", "row"):
        return None
    counts = [k for k, t in enumerate(rest) if t.value in ("stitch", "total", "count") or t.word in _TOTALS]
    said = [k for k, t in enumerate(rest) if t.word in _WORDED or t.value == "instructions"]
    if not counts and not said:
        return None
    return bool(counts and said and counts[0] < said[0]), bool(counts)


def _hued(titles: list[Token]) -> int:
    """How many columns stand before the one of colours; 0 for none."""
    before = [t.word for t in titles]
    at = next((k for k, word in enumerate(before) if word in _HUES), 0)
    return before[:at].count("|")


def _dyed(row: Row, hued: int) -> Row:
    """A row with its colour as a word of its round: ``8-11 | DG | sc around | 42`` as "8-11 | with DG, sc around | 42"."""
    bars = [k for k, t in enumerate(row.tokens) if t.word == "|"]
    if len(bars) < hued + 1 or not 0 < bars[hued] - bars[hued - 1] - 1 <= _NAMED:
        return row
    begin, end = bars[hued - 1] + 1, bars[hued]
    place = row.tokens[begin]
    led = Token("word", "with", place.start, place.start)
    stop = replace(row.tokens[end], word=",")
    return replace(row, tokens=[*row.tokens[:begin], led, *row.tokens[begin:end], stop, *row.tokens[end + 1 :]])


_HUES: Final = frozenset("color colour colors colours yarn farbe couleur kleur".split())
_NAMED: Final = 3  # words of a colour


def _run(rows: list[Row], at: int, vocabulary: Vocabulary) -> list[int]:
    """The rows from ``at`` on that bear numbers which follow each other, from 1 or behind those of the page before; others may stand between."""
    run: list[int] = []
    last, stitches, far = None, 0, 0
    for k in range(at, len(rows)):
        tokens = rows[k].tokens
        if not tokens:
            if run and far > 1:
                break
            far += bool(run)
            continue
        found = _number(tokens)
        if found is None or (last is not None and found[0] != last + 1):
            if not run or (found is not None and found[0] == 1) or far > 1:
                break
            far += 1
            continue
        last, far = found[1], 0
        run.append(k)
        stitches += any(t.kind == "stitch" or t.value in ("ring", "around") for t in vocabulary.read(tokens))
    return run if 2 * stitches > len(run) else []


def _number(tokens: list[Token]) -> tuple[int, int, int] | None:
    """The first and the last number of the rounds that a row begins with and no mark parts from their words, and where these begin."""
    first = tokens[0]
    if first.kind != "number" or not isinstance(first.value, int) or not 0 < first.value < _MOST or len(tokens) < 2:
        return None
    last, at = first.value, 1
    if len(tokens) > 3 and (tokens[1].word in _RANGED or tokens[1].word in ("to", "and")):
        if not isinstance(tokens[2].value, int) or tokens[2].kind != "number" or tokens[2].value <= last:
            return None
        last, at = tokens[2].value, 3
    after = tokens[at]
    if after.word == "|":
        at += 1
    elif after.glued or (after.kind == "mark" and after.word not in OPEN and after.word != "*"):
        return None
    return first.value, last, at


def _counted(tokens: list[Token]) -> bool:
    """Whether a row's second column holds the stitches of its round, and nothing else: ``7-9 | 21 | sc around``."""
    bars = [k for k, t in enumerate(tokens) if t.word == "|"]
    return len(bars) > 1 and bars[1] == bars[0] + 2 < len(tokens) - 1 and tokens[bars[0] + 1].kind == "number"


def _set(text: str, rows: list[Row], at: int, end: int, counted: bool, first: bool, called: str) -> None:
    """Sets one row as the line of a round, which is ``called`` so, with its words that run on in the rows below it up to ``end``."""
    row = rows[at]
    found = _number(row.tokens)
    assert found is not None
    begin = found[2]
    head, body = row.tokens[: begin - (row.tokens[begin - 1].word == "|")], row.tokens[begin:]
    count: Token | None = None
    if first and body and body[0].kind == "number":
        count, body = body[0], body[1:]
        body = body[1:] if body and body[0].word == "|" else body
    elif len(body) > 1 and body[-1].kind == "number" and body[-2].word not in ("x", "*"):
        before, last = body[-2], body[-1]
        apart = text[before.end : last.start]
        if counted or "\t" in apart or "  " in apart or before.kind == "number" or before.word == "|":
            count, body = last, body[:-2] if before.word == "|" else body[:-1]
    if not body:
        return
    below = rows[at + 1] if at + 1 < min(end, len(rows)) else None
    if below is not None and below.tokens and below.tokens[0].word in ("(", "[", "*") and count is not None:
        body = [*body, *below.tokens]
        rows[at + 1] = replace(below, tokens=[])
        row = replace(row, end=below.end)
    colon = Token("mark", ":", head[-1].end, head[-1].end, None, True)
    named = Token("word", called, head[0].start, head[0].start, None, False, True)
    made = [named, *head, colon, *body]
    if count is not None:
        made += [
            Token("mark", "(", count.start, count.start),
            replace(count, glued=True),
            Token("mark", ")", (ends := max(count.end, body[-1].end)), ends, None, True),
        ]
    rows[at] = replace(row, tokens=made)
