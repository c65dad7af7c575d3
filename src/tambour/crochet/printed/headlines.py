"""Printed patterns, headlines: what a line says as a whole: a part's name and copies, a colour of its own, a value below its heading."""

from __future__ import annotations

import re
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.places.names import kind_of, one
from tambour.crochet.printed.cursor import Cursor
from tambour.crochet.printed.notes import MODES, Heading, heading, plain_name
from tambour.crochet.printed.state import State
from tambour.crochet.printed.tokens import Row, Token
from tambour.crochet.yarns import class_of, hook_of

_YARN: Final = re.compile(
    r"^(?![^\n]*\b(?:hooks?|needles?|eyes?)\b)[^\n]*\b(?:yarn|cotton|wool|acrylic|dk|worsted|aran|sport|fingering|bulky|chunky)\b",
    re.IGNORECASE,
)
"""A line of a list that is of yarn."""


def below(p: State, row: Row, tokens: list[Token]) -> list[tuple[str, str, Span]]:
    """What a line states of gauge and size below a heading that says only which, and of the hook in a list of materials."""
    span = Span(row.tokens[0].start, row.tokens[-1].end)
    words = p.source.text.text[span.start : span.end]
    below, p.below = p.below, ""
    if p.mode == "materials" and not below and "yarn" not in p.stated and _YARN.search(words) and class_of(words):
        return [("yarn", words, span)]
    if p.mode != "materials" or not any(t.kind == "number" for t in tokens):
        return []
    if below:
        return [(below, words, span)]
    hook = any(t.kind == "key" and t.value == "hook" for t in tokens) and "hook" not in p.stated
    return [("hook", words, span)] if hook and hook_of(words) is not None else []


def headed(text: str, row: Row, tokens: list[Token]) -> int:
    """Where the colon stands behind the name of a part that a line begins with and goes on; 0 where it does not."""
    at = next((k for k, t in enumerate(tokens[:12]) if t.word == ":"), 0)
    if (
        not at
        or at + 1 >= len(tokens)
        or tokens[0].kind == "stitch"
        or tokens[0].value in (*MODES, "round", "row", "repeat")
    ):
        return 0
    if tokens[at + 1].word not in ("see", "fold") and not any(
        t.kind == "stitch" or (t.kind == "key" and t.value in ("ring", "make", "with", "begin", "as", "join"))
        for t in tokens[at + 1 :]
    ):
        return 0
    raw = [t for t in row.tokens if t.end <= tokens[at].end]
    found = heading(text, Row(raw, row.start, raw[-1].end, row.marked), tokens[: at + 1])
    return at if found is not None and found.strong else 0


def trailing(p: State, row: Row, tokens: list[Token]) -> int:
    """Where the sentences of a line end that the heading of the next part stands behind: "Fasten off. Ties (make 2)"; 0 where none does."""
    line = p.source.text.text[row.tokens[0].start : row.tokens[-1].end]
    if "(" not in line or copied(p, row, line) is None:
        return 0
    bracket = max(k for k, t in enumerate(tokens) if t.word == "(") if any(t.word == "(" for t in tokens) else 0
    return next((k for k in range(bracket - 2, 1, -1) if tokens[k].word in (".", "!") and not tokens[k + 1].glued), 0)


def copied(p: State, row: Row, line: str) -> Heading | None:
    """A heading that says its copies as the table of terms does: ``Arm (make 2)``."""
    mark = line.rfind("(")
    said = p.phrases.read(line[mark:], ("copies",)) if mark > 0 else None
    name = plain_name(line[:mark].strip()) if said is not None else ""
    if said is None or not name:
        return None
    span = Span(row.tokens[0].start, row.tokens[-1].end)
    return Heading(name, span, max(1, said[1]["count"]), span, True, True)


_SMALL: Final = re.compile(r"[a-z]+(?: [a-z]+){0,2}")


def small(p: State, row: Row, line: str) -> Heading | None:
    """A heading in small letters that names a part, on a line of its own before what founds it or names its rounds: "hair", "left leg"."""
    if not _SMALL.fullmatch(line) or not kind_of(one(line.split()[-1])) or p.mode in ("materials", "abbreviations"):
        return None
    text = p.source.text.text
    before = text[: row.start].rstrip(" \t")
    after = text[row.end :].lstrip()
    ended = before.rstrip("\n*")[-1:] in (".", ")", "]", "") or before.endswith("\n\n")
    if not (ended or p.heading is not None):
        return None
    if not after[:1].isupper():
        return None
    return Heading(plain_name(line), Span(row.tokens[0].start, row.tokens[-1].end), 1, None, True, False)


def colorless(p: State, tokens: list[Token]) -> list[Token]:
    """A heading without the colour that it says in brackets: "Head (cream)", "Ears (blue yarn, make 2)"."""
    for k, token in enumerate(tokens[:-2]):
        found = p.palette.color(Cursor(tokens, k + 1)) if token.word in ("(", "[") else None
        end = k + 1 + (found[1] if found is not None else 0)
        while (
            found is not None and end < len(tokens) and (tokens[end].value == "yarn" or tokens[end].word in (",", ";"))
        ):
            end += 1
        if (
            found is not None
            and end < len(tokens)
            and (tokens[end].word in (")", "]", "x") or tokens[end].value == "make")
        ):
            whole = tokens[end].word in (")", "]")
            return tokens[: k + 1 - whole] + tokens[end + whole :]
    return tokens


def named_color(p: State, tokens: list[Token]) -> bool:
    """``A = brown``, ``Color B: white``, ``Main color (MC): cream``; whether the line says such."""
    found = False
    for k in range(len(tokens) - 2):
        at = k + 1 + (tokens[k + 1].word == ")")
        if tokens[k].kind not in ("word", "key") or len(tokens[k].word) > 2 or at + 1 >= len(tokens):
            continue
        shade = p.palette.color(Cursor(tokens, at + 1)) if tokens[at].word in ("=", ":", "-") else None
        if shade is not None:
            p.palette.given.setdefault(tokens[k].word, shade[0])
            found = True
    return found
