"""Printed patterns, stepped: tables of a step, its stitches and by how many they grow, as Japanese lessons have them: ``7 | 42 | +6``, ``9~15 | 48 | no change``;
their stitches called eyes, and their copies sheets."""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import pairwise
from typing import Final

from tambour.crochet.printed.tokens import Row, Token

_RANGES: Final = ("-", "~", "・", "·", "/", "〜", "&", "to", "and", ",")
_MOST: Final = 400
_RUN: Final = 3  # lines of a table, at least
_EVEN: Final = re.compile(
    r"^(?:no (?:change|inc\w*|dec\w*)|without .*|same|as is|even|straight|plain|±\s*0|\+?\s*0|=|-|\W*)$"
)
_EYES: Final = re.compile(
    r"\beyes?\s*\(\s*st|\bhalf eyes?\b|\b(?:in|into|sc|inc|dec)(?: each| every)?(?: 1| one)? eyes?\b|\bchain \d+ eyes\b",
    re.IGNORECASE,
)
_BACK: Final = re.compile(r"\b(?:back|rear|far) (?:half|side|loop)\b|\bblo\b", re.IGNORECASE)
_FRONT: Final = re.compile(r"\b(?:front|near) (?:half|loop)\b|\bflo\b", re.IGNORECASE)
_GROWN: Final = re.compile(r"([+\-−–])\s*(\d{1,3})\b")
_STITCH: Final = re.compile(r"\b\d*\s*(?:sc|dc|hdc|tr|inc|dec|ch|sl ?st|ss|x|v|a)\b", re.IGNORECASE)
_SHEETS: Final = frozenset("sheet sheets pieces piece pcs pc pieces. copies".split())
_HEADLINE: Final = 14  # words
_CELL: Final = re.compile(r"\||\t|\s{2,}")


def stepped(text: str, rows: list[Row], called: str) -> list[Row]:
    """``rows`` with such tables as lines of rounds, which are ``called`` so, and their words as English has them."""
    eyes = _EYES.search(text) is not None
    made = [one for row in rows for one in (_worded(text, row, eyes) if row.tokens else [row])]
    k = 0
    while k < len(made):
        run = _run(text, made, k)
        if len(run) < _RUN and not (run and eyes):
            k += 1
            continue
        before = 0
        above = max((n for n in range(max(0, k - _ABOVE), k) if (hues := _hues(made[n].tokens))), default=None)
        hues = {}
        if above is not None:
            hues, made[above] = _hues(made[above].tokens), replace(made[above], tokens=[])
        for at, steps, count, cells in run:
            yarn = [hues[steps[0].value]] if steps[0].value in hues else []
            made[at] = _round(text, made[at], (steps, count, before), [*yarn, *cells], called)
            before = int(count.value)
        if (
            k
            and (titles := made[k - 1].tokens)
            and not any(t.kind == "number" for t in titles)
            and any(t.word == "|" for t in titles)
        ):
            made[k - 1] = replace(made[k - 1], tokens=[])
        k = run[-1][0] + 1
    return made


def _hues(tokens: list[Token]) -> dict[int, list[Token]]:
    """The yarns of "rnd 1 ~ 11 blue, rnd 12 ~ 17 white", by the rounds that each begins at; none where a line says anything else."""
    made: dict[int, list[Token]] = {}
    parts: list[list[Token]] = [[]]
    for token in tokens:
        if token.word in (",", ";", "/"):
            parts.append([])
        else:
            parts[-1].append(token)
    for part in parts:
        named = [t for t in part if t.word in ("rnd", "step", ":")]
        numbers = [t for t in part if t.kind == "number"]
        words = [t for t in part if t.kind == "word" and t not in named]
        signs = [t for t in part if t.kind == "mark" and t not in named]
        if (
            not named
            or not 0 < len(numbers) <= 2
            or not 0 < len(words) <= 3
            or any(t.word not in _RANGES for t in signs)
        ):
            return {}
        made[int(numbers[0].value)] = words
    return made


_ABOVE: Final = 4  # lines between such a list and its table
_Cells = list[list[Token]]


def _cells(text: str, row: Row) -> _Cells:
    """The words of a line by its columns."""
    cells: _Cells = [[]]
    for k, token in enumerate(row.tokens):
        if token.word == "|":
            cells.append([])
            continue
        if k and cells[-1] and _CELL.search(text[row.tokens[k - 1].end : token.start]):
            cells.append([])
        cells[-1].append(token)
    return cells


def _run(text: str, rows: list[Row], at: int) -> list[tuple[int, list[Token], Token, _Cells]]:
    """The lines from ``at`` on that begin with numbers which follow each other and have the stitches of each behind it."""
    run: list[tuple[int, list[Token], Token, _Cells]] = []
    last, grown = 0, 0
    for k in range(at, len(rows)):
        if not rows[k].tokens:
            if run:
                break
            continue
        cells = _cells(text, rows[k])
        found = _numbers(cells[0])
        if found is None or len(cells) < 2 or found[0] != last + 1 or not _count(cells[1]):
            break
        last = found[1]
        said = " ".join(text[c[0].start : c[-1].end] for c in cells[2:] if c)
        grown += bool(_GROWN.search(said)) or bool(_EVEN.match(said)) or bool(_BACK.search(said))
        run.append((k, cells[0], cells[1][0], cells[2:]))
    counts = [int(count.value) for _, _, count, _ in run]
    alike = all(b <= 2 * a + 2 for a, b in pairwise(counts))
    return run if grown and alike else []


def _numbers(cell: list[Token]) -> tuple[int, int] | None:
    """The first and last number of the steps of a line."""
    if not cell or cell[0].kind != "number" or not isinstance(cell[0].value, int):
        return None
    if len(cell) == 1:
        return cell[0].value, cell[0].value
    numbers = [t.value for t in cell if t.kind == "number"]
    signs = [t for t in cell if t.kind != "number"]
    if len(numbers) < 2 or any(t.word not in _RANGES for t in signs):
        return None
    return numbers[0], numbers[-1]


def _count(cell: list[Token]) -> bool:
    return len(cell) == 1 and cell[0].kind == "number" and isinstance(cell[0].value, int) and 0 < cell[0].value < _MOST


def _round(text: str, row: Row, said: tuple[list[Token], Token, int], cells: _Cells, called: str) -> Row:
    """A line of a table as the round that it means."""
    steps, count, before = said
    numbers = [t for t in steps if t.kind == "number"]
    head = [numbers[0]]
    if len(numbers) > 1:
        head += [Token("mark", "-", numbers[-1].start, numbers[-1].start), numbers[-1]]
    yarn = next((c for c in cells[:-1] if c and all(t.kind == "word" for t in c)), None) if len(cells) > 1 else None
    how = [t for c in cells if c is not yarn for t in c]
    first, many = row.tokens[0], int(count.value)

    def word(*what: str) -> list[Token]:
        made = []
        for one in what:
            kind = "number" if one.isdigit() else "word" if one.isalpha() else "mark"
            made.append(Token(kind, one, count.start, count.end, int(one) if one.isdigit() else None))
        return made

    words = text[how[0].start : how[-1].end].lower() if how else ""
    body = _body(words, how, (many, before, bool(numbers[0].value == 1)), word)
    dyed = [*word("with"), *yarn, *word(",")] if yarn is not None else []
    named = Token("word", called, first.start, first.start, None, False, True)
    tokens = [named, *head, *word(":"), *dyed, *body]
    tokens += word("(", str(many), ")") if not (body and body[-1].word == ")" and body[-2] is count) else []
    return replace(row, tokens=tokens)


def _body(words: str, how: list[Token], at: tuple[int, int, bool], word) -> list[Token]:  # type: ignore[no-untyped-def]
    """What a round of ``many`` stitches works on one of ``before``, by the words of its columns."""
    many, before, first = at
    if first and ("ring" in words or "loop" in words) and not before:
        return word(str(many), "sc", "in", "mr")
    loops = word("blo", ",") if _BACK.search(words) else word("flo", ",") if _FRONT.search(words) else []
    opened = next((k for k, t in enumerate(how) if t.word == "("), None)
    inner = how[opened + 1 : -1] if opened is not None and how[-1].word == ")" else []
    grown = _GROWN.search(words)
    if inner and grown and _STITCH.search(" ".join(t.word for t in inner)):
        each = any(t.word in ("each", "every", "all") for t in inner)
        return loops + (inner if each else [*word("("), *inner, *word(")", "around")])
    plain = _GROWN.sub("", words).strip(" ()")
    if not grown and _STITCH.search(plain) and not loops:
        return how
    if grown and _STITCH.search(re.sub(r"\b(?:inc|dec)\b", "", plain)):
        said = [t for t in how if not (grown.start() <= t.start - how[0].start < grown.end())]
        empty = {k for k in range(len(said) - 1) if said[k].word == "(" and said[k + 1].word == ")"}
        return [t for k, t in enumerate(said) if k not in empty and k - 1 not in empty]
    if not before or many == before:
        return loops + word("sc", "around")
    if many == 2 * before:
        return loops + word("inc", "around")
    way = "increasing" if many > before else "decreasing"
    return loops + word("sc", "around", ",", way, str(abs(many - before)), "sts")


def _worded(text: str, row: Row, eyes: bool) -> list[Row]:
    """A line with its eyes as stitches, its steps as rounds, and its sheets as copies; what else a heading says of its steps on a line of its own."""
    tokens = row.tokens
    if eyes and any(t.word in ("step", "steps") for t in tokens):
        tokens = [
            replace(t, word="rnd")
            if t.word in ("step", "steps") and k + 1 < len(tokens) and tokens[k + 1].kind == "number"
            else t
            for k, t in enumerate(tokens)
        ]
    if eyes and any(t.word in ("eye", "eyes") for t in tokens):
        tokens = [
            replace(t, word="sts" if t.word == "eyes" else "st")
            if t.word in ("eye", "eyes") and _stitches(tokens, k)
            else t
            for k, t in enumerate(tokens)
        ]
    found = _copies(text, tokens, eyes)
    if found is not None:
        number, rest, name = found
        make = Token("word", "make", number.start, number.start)
        opens, closes = (Token("mark", w, number.start, number.end) for w in "()")
        head = [*name, opens, make, number, closes]
        if any(t.kind == "number" for t in rest):
            return [Row(head, row.start, row.end, max(row.marked, 1)), Row(rest[1:], rest[1].start, rest[-1].end)]
        return [Row([*head, *rest], row.start, row.end, max(row.marked, 1))]
    if len(tokens) > 2 and tokens[0].word in ("row", "rows", "round", "rnd", "step") and tokens is not None:
        tokens = _last(text, tokens)
    return [row if tokens is row.tokens else replace(row, tokens=tokens)]


def _stitches(tokens: list[Token], k: int) -> bool:
    before = tokens[k - 1] if k else None
    behind = tokens[k + 1] if k + 1 < len(tokens) else None
    if behind is not None and behind.kind == "number" and not behind.glued:
        return False  # "plug-in eye 6 mm"
    return before is not None and (
        before.kind == "number" or before.word in ("half", "each", "every", "of", "last", "next", "one", "1")
    )


def _copies(text: str, tokens: list[Token], eyes: bool) -> tuple[Token, list[Token], list[Token]] | None:
    """The copies of a heading, "HEAD  pale pink  1 sheet", what stands around them, and its name."""
    if not 1 < len(tokens) <= _HEADLINE or tokens[0].kind != "word" or not tokens[0].capital:
        return None
    at = next((k for k, t in enumerate(tokens) if t.word in _SHEETS and k and tokens[k - 1].kind == "number"), 0)
    wide = [k for k in range(1, len(tokens)) if _CELL.search(text[tokens[k - 1].end : tokens[k].start])]
    if (
        not at
        and eyes
        and tokens[-1].kind == "number"
        and len(tokens) - 1 in wide
        and all(t.kind == "word" for t in tokens[:-1])
    ):
        at = len(tokens)
    if not at or not wide or wide[0] > at - 1:
        return None
    number = tokens[at - 1]
    rest = [*tokens[wide[0] : at - 1], *tokens[at + 1 :]]
    if any(t.word == ":" for t in rest) or not isinstance(number.value, int) or not 0 < number.value < 40:
        return None
    return number, [Token("mark", "-", number.start, number.start), *rest] if rest else [], tokens[: wide[0]]


def _last(text: str, tokens: list[Token]) -> list[Token]:
    """``Row 3   dec, 2 sc, dec   4``: the stitches that stand apart at the end, in brackets."""
    number, before = tokens[-1], tokens[-2]
    apart = _CELL.search(text[before.end : number.start]) and number.kind == "number"
    numbers = len([t for t in tokens[:-1] if t.kind == "number"])
    if not apart or not numbers or before.word in ("x", "*", ",", "-") or not isinstance(number.value, int):
        return tokens
    opens, closes = (Token("mark", w, number.start, number.end) for w in "()")
    if before.kind == "number" and len(tokens) == 3:
        return [*tokens[:-1], number, Token("word", "sc", number.end, number.end), opens, number, closes]
    return [*tokens[:-1], opens, number, closes]
