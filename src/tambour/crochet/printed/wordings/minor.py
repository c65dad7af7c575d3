"""Printed patterns, minor words: what people add within a round, or leave out, put as most say it: "8 more sc", "no increases", "sl st loosely
in each st", "5dc-bobble", "ch 3 over the next 3 sts", "sc 8, inc (2 times)", "8 sc; 2 inc; 8 sc"."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from typing import Final

from tambour.crochet.printed.cursor import OPEN
from tambour.crochet.printed.tokens import Token

_LISTED: Final = frozenset((",", ";", ".", ":", "(", "[", "*"))
_TALL: Final = frozenset(("hdc", "dc", "tr"))
_MADE_OF: Final = frozenset(("of", "with", "using", "made", "worked", "from", "consisting", "stitch"))
_MOST: Final = 12  # stitches of a bump
_TWO: Final = 5  # words of two entries of a count, and the sign between them
_HEAPS: Final = frozenset(("bobble", "popcorn", "puff", "cl"))
_PUT: Final = frozenset(("insert", "place", "put", "attach", "add"))
_BUMPS: Final = frozenset("thumb thumbs nose heel toe finger tail ear eye cheek".split())  # what a stitch stands for
_ENDS: Final = frozenset((",", ".", ";", "(", "[", ")"))
_WORK: Final = frozenset(("the", "your", "work", "here", "now", "again", "over"))
_CLOSING: Final = frozenset(("worked", "for"))
SAYING: Final = frozenset("turn more light not per skipping over leave eyes".split()) | _CLOSING | _HEAPS
"""Words of which a line has one where something may be left out, or put otherwise."""


def plainer(tokens: list[Token]) -> list[Token]:
    """Words as read, without what says nothing more, and in one order."""
    made: list[Token] = []
    at = 0
    while at < len(tokens):
        token = tokens[at]
        if (end := _turned(tokens, at)) > at:
            mark = Token("mark", ",", token.start, token.start)
            made += [mark, next(t for t in tokens[at:end] if t.value == "turn")][token.kind != "mark" :]
            at = end
            continue
        if token.kind == "mark" and token.word != ",":
            made.append(token)
            at += 1
            continue
        found = _dropped(tokens, at, made) or _chained(tokens, at) or _heaped(tokens, at)
        if found is not None:
            words, at = found
            made += words
            continue
        made.append(token)
        at += 1
    return made


def _turned(tokens: list[Token], at: int) -> int:
    """Where words end that turn the work and say no more, "turn here", "turn your work", "(turn now)"; ``at`` for none."""
    bracket = tokens[at].word in ("(", "[")
    end = at + bracket
    if end >= len(tokens) or tokens[end].value != "turn":
        return at
    end += 1
    while end < len(tokens) and tokens[end].word in _WORK:
        end += 1
    closed = end < len(tokens) and tokens[end].word in (")", "]")
    if bracket:
        return end + 1 if closed else at
    ends = end == len(tokens) or tokens[end].kind == "mark"
    return end if ends and end > at + 1 else at


def _closed(tokens: list[Token], at: int, before: Token | None) -> int:
    """Where words at the end of a clause end that say nothing more, "1 sc in first ch worked", "(sc, ch 1, sc) in next st for corner"; 0 for none."""
    end = at + 1
    if tokens[at].word == "for":
        end += end < len(tokens) and tokens[end].word in ("a", "the")
        end = end + 1 if end < len(tokens) and tokens[end].word in ("corner", "corners") else 0
    elif before is None or before.value != "ch":
        return 0
    return end if end and (end == len(tokens) or tokens[end].word in _ENDS) else 0


_MEANT: Final = frozenset(("more", "light", "in", "not", "for", 1))
_SAID: Final = _CLOSING | {"per", "skipping", ","}
"""What something begins with that may be left out."""


def _dropped(tokens: list[Token], at: int, made: list[Token]) -> tuple[list[Token], int] | None:
    """What stands for words that say nothing more, and where they end."""
    token, before = tokens[at], made[-1] if made else None
    if token.value not in _MEANT and token.word not in _SAID:
        return None
    values = [t.value for t in tokens[at : at + 4]]
    stands = before is None or before.word in _LISTED
    numbered = before is not None and before.kind == "number"
    listed = numbered and len(made) > 1 and made[-2].word in (",", "then", "and")
    last = at + 2 >= len(tokens) or tokens[at + 2].kind == "mark"
    if token.value == "more" and listed and last and at + 1 < len(tokens) and tokens[at + 1].kind == "stitch":
        return [], at + 1  # "8 more sc"
    if token.value == "light" and before is not None and before.kind == "stitch" and values[1:2] == ["in"]:
        return [], at + 1
    if token.word in _CLOSING and (found := _closed(tokens, at, before)):
        return [], found
    if token.word == "per" and values[1:3] == ["stitch", "in"] and before is not None and before.kind == "stitch":
        return [replace(tokens[at + 2], start=token.start), _key(token, "each")], at + 3
    led = stands and values[:3] == ["in", "each", "stitch"] and at + 4 < len(tokens) and tokens[at + 3].word == ","
    if led and tokens[at + 4].kind in ("stitch", "number"):
        return [], at + 4  # "working in every st, sc 18"
    shaped = at + 1 < len(tokens) and tokens[at + 1].kind == "stitch" and tokens[at + 1].value in ("inc", "dec")
    if stands and token.value == "not" and shaped:
        past = at + 2
        if past == len(tokens) or tokens[past].word in _ENDS:
            return [], past + (past < len(tokens) and tokens[past].word == ",")
    if token.word == "skipping" and values[2:3] == ["stitch"] and before is not None and before.word == ",":
        return [replace(token, kind="stitch", word="skip", value="skip")], at + 1
    dashed = stands and values[0] == 1 and len(values) > 3 and isinstance(values[1], int) and values[3] in _TALL
    if dashed and tokens[at + 2].word == "-":
        return [], at + 1  # "1 5-dc bobble"
    reason = token.value == "for" and before is not None and (before.kind == "stitch" or before.value == "stitch")
    if reason and at + 1 < len(tokens) and tokens[at + 1].word in _BUMPS and last:
        return [], at + 2  # "bobble in first st for thumb"
    put = token.word == "," and at + 2 < len(tokens) and tokens[at + 1].word in _PUT
    put = put and any(t.value == "eyes" for t in tokens[at + 2 : at + 5])
    if put and any(t.kind == "stitch" for t in made):
        return [replace(token, word=".")], at + 1  # "sc around, insert eyes between rounds 2 and 3"
    return None


def _chained(tokens: list[Token], at: int) -> tuple[list[Token], int] | None:
    """``ch 3 over the next 3 sts`` and ``leave 3 sts, ch 3`` as "ch 3, skip 3"."""
    if tokens[at].value not in ("ch", "leave"):
        return None
    some = tokens[at : at + 6]
    values = [t.value for t in some]
    if len(some) > 4 and values[0] == "ch" and some[1].kind == "number" and values[2] == "over":
        past = 3 + (values[3] == "next")
        if past + 1 < len(some) and some[past].kind == "number" and values[past + 1] in ("stitch", "sc"):
            return [*some[:2], _comma(some[2]), _skip(some[2]), some[past]], at + past + 2
    left = values[:1] == ["leave"] and len(some) > 5 and some[1].kind == "number" and values[2] == "stitch"
    if left and some[3].word == "," and values[4] == "ch" and some[5].kind == "number":
        return [some[4], some[5], _comma(some[5]), _skip(some[0]), some[1]], at + 6
    return None


def _heaped(tokens: list[Token], at: int) -> tuple[list[Token], int] | None:
    """``5dc-bobble`` and ``bobble (5 dc)`` as "5 dc bobble"."""
    one = tokens[at].value == 1 and at + 2 < len(tokens) and tokens[at + 1].kind in ("number", "stitch")
    if (
        one
        and (found := _heaped(tokens, at + 1)) is not None
        and (tokens[at + 1].kind == "number" or len(found[0]) > 2)
    ):
        return found  # "1 5-dc bobble", "1 bobble of 4 dc"
    some = tokens[at : at + 5]
    dashed = len(some) > 3 and some[0].kind == "number" and some[1].value in _TALL and some[2].word == "-"
    if dashed and some[3].kind == "stitch" and some[3].value in _HEAPS:
        return [some[0], some[1], some[3]], at + 4
    if len(some) > 4 and some[0].kind == "stitch" and some[0].value in _HEAPS and some[1].word in OPEN:
        alone = not at or tokens[at - 1].kind == "mark"
        if alone and some[2].kind == "number" and some[3].value in _TALL and some[4].word in (")", "]"):
            return [some[2], some[3], some[0]], at + 5
    if some[0].kind == "stitch" and some[0].value in _HEAPS:
        past = next((k for k, t in enumerate(tokens[at + 1 : at + 5], at + 1) if t.word not in _MADE_OF), at)
        said = tokens[past : past + 2]
        if (
            past > at
            and [t.kind for t in said] == ["number", "stitch"]
            and said[1].value in _TALL
            and _heap(said[0].value)
        ):
            return [*said, some[0]], past + 2  # "bobble of 4 dc", "a bobble made with 4 dc"
    return None


def _heap(many: object) -> bool:
    """Whether so many stitches are closed to one bump."""
    return isinstance(many, int) and 2 <= many <= _MOST


def listed(tokens: list[Token]) -> list[Token]:
    """``8 sc; 2 inc; 8 sc`` with commas."""
    at = [k for k, t in enumerate(tokens) if t.word == ";"]
    if len(at) < 2:
        return tokens
    for k in at:
        before, after = tokens[max(0, k - 2) : k], tokens[k + 1 : k + 3]
        if not all(sorted(t.kind for t in some) == ["number", "stitch"] for some in (before, after)):
            return tokens
    return [replace(t, word=",") if t.word == ";" else t for t in tokens]


def summed(tokens: list[Token]) -> list[Token]:
    """A count that names things first, ``- 1 thumb and 8 sc``, with its stitches first, and one that tells the round over, ``8 sc = 1 bobble + 8 sc``,
    ``bobble, 8 sc (1 bobble, 8 sc)``, as their sum."""
    end = len(tokens) - (bool(tokens) and tokens[-1].word == ".")
    closed = end > 0 and tokens[end - 1].word in (")", "]")
    signs = ("(", "[") if closed else ("-", "=")
    at = next((k for k in range(end - 2, 1, -1) if tokens[k].word in signs), 0)
    if not at or end - closed - at <= _TWO:
        return tokens
    entries: list[list[Token]] = [[]]
    for token in tokens[at + 1 : end - closed]:
        if token.word in (",", "+", "&") or token.value == "and":
            entries.append([])
        else:
            entries[-1].append(token)
    named = all(len(e) in (2, 3) and e[0].kind == "number" and isinstance(e[0].value, int) for e in entries)
    if len(entries) < 2 or not named or any(t.kind not in ("stitch", "word") for e in entries for t in e[1:2]):
        return tokens
    stitches = [e for e in entries if e[1].kind == "stitch"]
    if len(stitches) == len(entries):
        told = [(t.value, u.value) for t, u in pairwise([*tokens[:at], tokens[at]]) if t.kind == "number"]
        told += [(u.value, t.value) for t, u in pairwise(tokens[:at]) if t.kind == "stitch" and u.kind == "number"]
        plain = [
            (1, t.value)
            for k, t in enumerate(tokens[:at])
            if t.kind == "stitch" and not (k and tokens[k - 1].kind == "number")
        ]
        same = all((e[0].value, e[1].value) in (*told, *plain) for e in entries)
        if not same or (not closed and "+" not in {t.word for t in tokens[at:end]}):
            return tokens
        total = sum(e[0].value for e in entries)
        number = Token("number", str(total), tokens[at + 1].start, tokens[end - 1 - closed].end, total)
        return [*tokens[: at + 1], number, *tokens[end - closed :]]
    if closed or not stitches or entries[0][1].kind == "stitch":
        return tokens
    ordered = [*stitches, *(e for e in entries if e[1].kind != "stitch")]
    listed = [t for k, e in enumerate(ordered) for t in ([_key(e[0], "and")] if k else []) + e]
    return [*tokens[: at + 1], *listed, *tokens[end:]]


def often(tokens: list[Token]) -> list[Token]:
    """``sc 8, inc (2 times)``, ``sc 8, inc [x2]``, ``sc 8, inc (rep around)`` with the stitches in brackets, and ``sc 8, inc, repeat once`` as "1 more time"."""
    for k, token in enumerate(tokens):
        once = tokens[k + 1] if k and token.value == "repeat" and k + 1 < len(tokens) else token
        ends = k + 2 >= len(tokens) or tokens[k + 2].word in _ENDS
        if token.value == "repeat" and once.value == "once" and ends and not any(t.word == "*" for t in tokens[:k]):
            more = [Token("number", "1", once.start, once.end, 1), _key(once, "more"), _key(once, "times")]
            return [*tokens[: k + 1], *more, *tokens[k + 2 :]]
        if token.word not in OPEN:
            continue
        end = next((n for n in range(k + 1, min(k + 6, len(tokens))) if tokens[n].word in (")", "]", "}")), 0)
        said = tokens[k + 1 : end]
        if not end or not said or (end + 1 < len(tokens) and tokens[end + 1].word not in ("(", "[", ".", "=", "-")):
            continue
        repeats = [t for t in said if t.value != "repeat"]
        many = next((t for t in repeats if t.kind == "number" and isinstance(t.value, int)), None)
        times = len(repeats) == 2 and many is not None and any(t.word == "x" or t.value == "times" for t in repeats)
        around = len(said) == 2 and [t.value for t in said] == ["repeat", "around"]
        begin = next((n for n in range(k - 1, -1, -1) if tokens[n].word in (":", ".")), -1) + 1
        listed = tokens[begin:k]
        if not (times or around) or not _list(listed):
            continue
        opens, closes = (Token("mark", sign, t.start, t.start) for sign, t in (("(", listed[0]), (")", token)))
        behind = [Token("mark", "x", said[0].start, said[0].end), many] if times and many is not None else said
        return [*tokens[:begin], opens, *listed, closes, *behind, *tokens[end + 1 :]]
    return tokens


def _list(tokens: list[Token]) -> bool:
    """Whether tokens are stitches between commas, and no more: "sc 8, inc"."""
    pieces: list[list[Token]] = [[]]
    for token in tokens:
        if token.word == ",":
            pieces.append([])
        else:
            pieces[-1].append(token)
    return len(pieces) > 1 and all(sorted(t.kind for t in p) in (["stitch"], ["number", "stitch"]) for p in pieces)


def _key(at: Token, value: str) -> Token:
    return Token("key", value, at.start, at.end, value)


def _comma(at: Token) -> Token:
    return Token("mark", ",", at.start, at.start)


def _skip(at: Token) -> Token:
    return Token("stitch", "skip", at.start, at.end, "skip")
