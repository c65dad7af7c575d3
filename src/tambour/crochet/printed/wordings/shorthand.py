"""Printed patterns, shorthand: stitches as pages of the web spell them, put as other patterns do: ``2sc6``, ``sc twice in next st``."""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import pairwise
from typing import Final

from tambour.crochet.printed.cursor import OPEN
from tambour.crochet.printed.tokens import Row, Token

_PLAIN: Final = ("sc", "hdc", "dc", "tr")
_MOST: Final = 6  # stitches in one: "5dc1"


def grown(tokens: list[Token]) -> list[Token]:
    """Words as read, with "sc twice in next st" as "2 sc in next st" and "2sc6" as "2 sc in each of next 6 sts"."""
    made: list[Token] = []
    at = 0
    while at < len(tokens):
        token = tokens[at]
        after = tokens[at + 1 : at + 4]
        if (past := _of_each(tokens, at)) > at:
            at = past
        elif token.value in _LEADS and (put := _from_hook(tokens, at)) is not None:
            words, at = put
            made += words
        elif token.kind == "stitch" and (many := _often(after)) is not None:
            number, length = many
            made += [Token("number", str(number), token.start, token.start, number), token]
            at += 1 + length
        elif token.kind == "number" and _several(token, after):
            made += [token, after[0], *_each(after[1])]
            at += 3
        else:
            made.append(token)
            at += 1
    return made


def apart(tokens: list[Token]) -> list[Token]:
    """Stitches with commas between them for other signs, "sc-inc", "2 sc + inc", "sc/dec"."""
    made = list(tokens)
    listed = False
    for k in range(1, len(tokens) - 1):
        if tokens[k].word not in BETWEEN or tokens[k - 1].kind != "stitch":
            continue
        behind = tokens[k + 1 : k + 3]
        counted = len(behind) == 2 and behind[0].kind == "number" and behind[1].kind == "stitch"
        shapes = [t.value for t in (tokens[k - 1], *behind[: 1 + counted])]
        ended = k + 3 >= len(tokens) or tokens[k + 3].word in _PAST
        if counted and ended and tokens[k].word == "-" and not listed and behind[1].value not in _SHAPED:
            continue  # "16 sc, sc2tog—17 sc.": how many there are now
        if (behind[0].kind == "stitch" or counted) and any(value in _SHAPED for value in shapes):
            made[k] = replace(tokens[k], word=",")
            listed = True
    return made


def beside(tokens: list[Token]) -> list[Token]:
    """Stitches that only stand beside each other before "x 6", "1 sc 1 inc x 6", "sc inc x 6 (18)", "sc3 inc1 x3", with commas between them."""
    end = next((k for k in range(1, len(tokens) - 1) if _times_at(tokens, k)), 0)
    if not end:
        return tokens
    count = _count_behind(tokens, end)
    tokens = _many_first(tokens, end, count)
    made: list[Token] = []
    for k, token in enumerate(tokens[:end]):
        before = tokens[k - 1] if k else None
        if token.kind == "stitch" and " " in token.word and token.value in _SHAPED and _of_two(before, token, count):
            middle = token.start + len(token.word.split()[0])
            made.append(replace(token, word="sc", value="sc", end=middle))
            made.append(Token("mark", ",", middle, middle))
            made.append(replace(token, word=token.value, start=min(middle + 1, token.end)))
            continue
        grown = (
            before is not None and before.kind == "number" and before.glued and k > 1 and tokens[k - 2].kind == "stitch"
        )
        last = tokens[k - 2] if grown else before
        named = tokens[k + 1] if token.kind == "number" and not token.glued and k + 1 < end else token
        stitches = last is not None and last.kind == named.kind == "stitch" and token.kind in ("number", "stitch")
        if stitches and last is not None and (last.value in _SHAPED) != (named.value in _SHAPED):
            made.append(Token("mark", ",", token.start, token.start))
        made.append(token)
    return [*made, *tokens[end:]]


def _many_first(tokens: list[Token], end: int, count: tuple[int, int] | None) -> list[Token]:
    """Puts "sc 2 inc x 6 (24)" as "2 sc inc x 6 (24)", where the count says that the number is of the stitch before it."""
    if end < 3 or count is None:
        return tokens
    plain, number, shaped = tokens[end - 3 : end]
    if plain.value not in _PLAIN or number.kind != "number" or number.glued or shaped.value not in ("inc", "dec"):
        return tokens
    if end > 3 and tokens[end - 4].kind == "number":
        return tokens  # "1 sc 1 inc x 6"
    once = 2 if shaped.value == "inc" else 1
    if count[0] * (number.value + once) != count[1]:
        return tokens
    return [*tokens[: end - 3], number, plain, *tokens[end - 1 :]]


def _of_two(before: Token | None, token: Token, count: tuple[int, int] | None) -> bool:
    """Whether "sc inc" before "x 6" is two stitches: its count says so, or, where none does, a number before it: "2 sc inc x 6"."""
    many = before.value if before is not None and before.kind == "number" and isinstance(before.value, int) else 1
    if count is None:
        return many > 1
    return count[0] * (many + (2 if token.value == "inc" else 1)) == count[1]


def _times_at(tokens: list[Token], k: int) -> bool:
    """Whether "x 6", "6 x" or "6 times" stands at ``k``, behind a stitch."""
    one, two = tokens[k], tokens[k + 1]
    signs = one.word == "x" or two.word == "x" or two.value == "times" or (one.word == "*" and two.glued)
    stitched = tokens[k - 1].kind == "stitch" or (tokens[k - 1].kind == "number" and tokens[k - 1].glued)
    many = next((t for t in (one, two) if t.kind == "number" and isinstance(t.value, int)), None)
    return signs and many is not None and stitched and not (one.kind == "number" and one.glued)


def _count_behind(tokens: list[Token], k: int) -> tuple[int, int] | None:
    """How often "x 6 (18)" at ``k`` says, and its count; None where none stands behind it."""
    often = next(t.value for t in tokens[k : k + 2] if t.kind == "number")
    said = [t for t in tokens[k + 2 : k + 4] if t.kind == "number" and isinstance(t.value, int)]
    return (int(often), int(said[0].value)) if said and tokens[k + 2].kind == "mark" else None


BETWEEN: Final = frozenset("-/+")
_PAST: Final = frozenset((".", ";", "(", "[", "*", "**"))
"""Behind a number of stitches these end the sentence."""


def singles(tokens: list[Token]) -> list[Token]:
    """Numbers that stand alone beside increases and decreases, "(3, inc) x 6", "4, dec, 5, dec", with the single crochets that they count."""
    made: list[Token] = []
    for k, token in enumerate(tokens):
        made.append(token)
        after = tokens[k + 1].word if k + 1 < len(tokens) else ""
        if token.kind != "number" or not k or tokens[k - 1].word not in _BEFORE or not isinstance(token.value, int):
            continue
        if tokens[k - 1].word == "*" and k > 1 and tokens[k - 2].word not in (",", ":", "."):
            continue  # "(V, 2X) * 5, V"
        starred = after == "*" and any(t.word == "*" for t in tokens[:k])
        stands = after in (",", ")", "]") or starred or (after in OPEN and _counted(tokens, k + 1))
        if stands and _listed(tokens, k):
            made.append(Token("stitch", "sc", token.end, token.end, "sc"))
    return made


def grouped(tokens: list[Token]) -> list[Token]:
    """``sc, inc x 6 (18)`` with its brackets, where only all of it so often makes the round's own count."""
    tail = len(tokens) - 3
    if tail < 5 or tokens[tail].word != "(" or tokens[tail + 1].kind != "number" or tokens[-1].word != ")":
        return tokens
    begin = next((k for k in range(tail - 1, -1, -1) if tokens[k].word == ":"), -1) + 1
    end = tail - (tokens[tail - 1].word == ")" and tokens[tail - 4].word == "(")
    if end < 2 or tokens[end - 1].kind != "number" or tokens[end - 2].word not in ("x", "*"):
        return tokens
    many = tokens[end - 1].value
    last = end - 2 - (end < tail)
    pieces: list[list[Token]] = [[]]
    for token in tokens[begin:last]:
        if token.word == ",":
            pieces.append([])
        else:
            pieces[-1].append(token)
    made = [_makes(piece) for piece in pieces]
    if len(made) < 2 or 0 in made or not isinstance(many, int):
        return tokens
    if sum(made[:-1]) + many * made[-1] == tokens[tail + 1].value or many * sum(made) != tokens[tail + 1].value:
        return tokens
    opens, closes = (
        Token("mark", sign, tokens[at].start, tokens[at].start) for sign, at in (("(", begin), (")", last))
    )
    return [*tokens[:begin], opens, *tokens[begin:last], closes, tokens[end - 2], tokens[end - 1], *tokens[tail:]]


def _makes(piece: list[Token]) -> int:
    """How many stitches "2 sc", "sc 2", "inc" makes; 0 for anything else."""
    numbers = [t.value for t in piece if t.kind == "number" and isinstance(t.value, int)]
    stitches = [t.value for t in piece if t.kind == "stitch"]
    if len(stitches) != 1 or len(numbers) > 1 or len(piece) != len(numbers) + 1:
        return 0
    return (numbers or [1])[0] * {"inc": 2, "dec": 1, "sc": 1, "hdc": 1, "dc": 1}.get(stitches[0], 0)


def _listed(tokens: list[Token], at: int) -> bool:
    """Whether the number at ``at`` is one of a list, within its brackets, in which increases or decreases stand between commas."""
    begin = next((k for k in range(at - 1, -1, -1) if tokens[k].word in (*OPEN, ")", "]", ":", ".", "*")), -1) + 1
    end = next((k for k in range(at, len(tokens)) if tokens[k].word in (*OPEN, ")", "]", ".", ";", "*")), len(tokens))
    shaped = [k for k in range(begin, end) if tokens[k].kind == "stitch" and tokens[k].value in _SHAPED]
    return any(w.word == "," for w in tokens[begin:end]) and any(
        (k == begin or tokens[k - 1].word == ",") or tokens[k - 1].kind == "number" for k in shaped
    )


def _counted(tokens: list[Token], at: int) -> bool:
    """Whether a bracket with a number alone stands at ``at``."""
    return len(tokens) > at + 2 and tokens[at + 1].kind == "number" and tokens[at + 2].word in (")", "]")


_SHAPED: Final = ("inc", "dec")
_BEFORE: Final = (",", "(", "[", ":", "*")


def had(tokens: list[Token]) -> list[Token]:
    """A round without the sentence that only says what there is then, "You have 8 curly tentacles (16 sl sts on the head)", but for its count."""
    at = next(
        (k for k in range(2, len(tokens) - 2) if tokens[k].word == "have" and tokens[k - 1].word in (".", "!")), 0
    )
    if not at or any(t.word in (".", "!") and not t.glued for t in tokens[at:-1]):
        return tokens
    bracket = next((k for k in range(at, len(tokens) - 1) if tokens[k].word == "("), at)
    counts = [
        t
        for t, after in pairwise(tokens[bracket:])
        if t.kind == "number" and isinstance(t.value, int) and (after.kind == "stitch" or after.value == "stitch")
    ]
    if bracket == at and not counts:
        return tokens[:at]
    if len(counts) != 1:
        return tokens
    number = counts[0]
    opens, closes = (Token("mark", sign, number.start, number.end) for sign in "()")
    return [*tokens[:at], opens, number, closes]


def _of_each(tokens: list[Token], at: int) -> int:
    """Where words end that say only that rounds are alike: "5 rounds, each round 30 sc", "6 sc in each round", "unchanged"; ``at`` for none."""
    end = at
    while end < len(tokens) and (tokens[end].word == "," or tokens[end].value == "in") and end - at < 2:
        end += 1
    if end + 1 < len(tokens) and tokens[end].value == "each" and tokens[end + 1].value in ("round", "row"):
        behind = tokens[end + 2] if end + 2 < len(tokens) else None
        counts = behind is None or behind.kind in ("mark", "number")
        stitches = at and (tokens[at - 1].kind == "stitch" or tokens[at - 1].value in ("round", "row"))
        return end + 2 if counts and (stitches or end == at) else at
    return at + 1 if tokens[at].word in _ALIKE and at and tokens[at - 1].value in ("round", "row", "stitch") else at


_NTH: Final = range(2, 41)
_REACH: Final = 3  # words between a chain and the hook that it is counted from


_LEADS: Final = frozenset(("in", "from", "begin"))


def _nth(tokens: list[Token], at: int) -> tuple[int, int]:
    """The number of "3." or "third", and where the words behind it begin; 0 for none."""
    token = tokens[at] if at < len(tokens) else None
    if token is None:
        return 0, at
    point = at + 1 < len(tokens) and tokens[at + 1].word == "." and tokens[at + 1].glued
    nth = token.kind == "ordinal" or (token.kind == "number" and point)
    if not nth or not isinstance(token.value, int) or token.value not in _NTH:
        return 0, at
    return token.value, at + 1 + (token.kind == "number")


def _from_hook(tokens: list[Token], at: int) -> tuple[list[Token], int] | None:
    """``in 2nd ch from hook`` for "ab der 2. Lm von der Nadel", "vanaf de 2e l op de haaknaald"; and where such words end."""
    if tokens[at].kind != "key" or tokens[at].value not in ("from", "in", "begin") or at + 3 >= len(tokens):
        return None
    nth, end = _nth(tokens, at + 1)
    if not nth or end >= len(tokens) or tokens[end].value != "ch":
        return None
    hook = next((k for k in range(end + 1, min(end + 1 + _REACH, len(tokens))) if tokens[k].value == "hook"), 0)
    if not hook or any(t.kind in ("stitch", "number") for t in tokens[end + 1 : hook]):
        return None
    behind = at > 0 and tokens[at - 1].kind in ("stitch", "number")
    if tokens[end + 1].value == "from" and (tokens[at].value == "in" or behind):
        return None  # as it is usually said, or read behind its stitches (underside)
    place = tokens[at].start

    def key(word: str, value: str) -> Token:
        return Token("key", word, place, tokens[hook].end, value)

    return [
        key("in", "in"),
        Token("ordinal", str(nth), tokens[at + 1].start, tokens[end - 1].end, nth),
        tokens[end],
        key("from", "from"),
        tokens[hook],
    ], hook + 1


_ALIKE: Final = frozenset(("unchanged", "alike"))
SAYING: Final = frozenset(("hook", "twice", "times")) | _ALIKE


def _often(after: list[Token]) -> tuple[int, int] | None:
    """How often a stitch is worked "twice in", "4 times into", and how many words say so."""
    if len(after) > 1 and after[0].value == "twice" and after[1].value == "in":
        return 2, 1
    counted = (
        len(after) > 2 and isinstance(after[0].value, int) and after[1].value == "times" and after[2].value == "in"
    )
    return (after[0].value, 2) if counted else None


def _several(token: Token, after: list[Token]) -> bool:
    """Whether a number begins "2sc6": so many in one, for so many stitches."""
    return (
        len(after) > 1
        and isinstance(token.value, int)
        and 2 <= token.value <= _MOST
        and after[0].kind == "stitch"
        and after[0].value in _PLAIN
        and after[0].glued
        and after[1].kind == "number"
        and after[1].glued
        and isinstance(after[1].value, int)
    )


def _each(number: Token) -> list[Token]:
    """``in each of next 6 sts`` at the place of the 6."""

    def key(word: str) -> Token:
        return Token("key", word, number.start, number.end, word)

    if number.value == 1:
        return [key("in"), key("next"), key("stitch")]
    return [key("in"), key("each"), key("next"), number, key("stitch")]


def numbered(rows: list[Row]) -> list[Row]:
    """Lines that only a number and a dash begin, "7 - 22 (16 rnds) - 36 sc", as others do with a colon; where they follow each other."""
    made = list(rows)
    last = 0
    run: list[tuple[int, int]] = []
    for k, row in enumerate(rows):
        if not row.tokens:
            continue
        found = _dashed(row.tokens)
        if found is None:
            continue
        first, end, at = found
        if first == 1 or first != last + 1:
            _coloned(made, run)
            run, last = [], 0
        if first == last + 1:
            run.append((k, at))
            last = end
    _coloned(made, run)
    return made


_RUN: Final = 3  # lines that follow each other before their dashes are heads


def _coloned(rows: list[Row], run: list[tuple[int, int]]) -> None:
    for k, at in run if len(run) >= _RUN else []:
        row = rows[k]
        dash = row.tokens[at]
        colon = Token("mark", ":", dash.start, dash.end, None, dash.glued)
        rows[k] = Row([*row.tokens[: min(at, 3)], colon, *row.tokens[at + 1 :]], row.start, row.end, row.marked)


def _dashed(tokens: list[Token]) -> tuple[int, int, int] | None:
    """The first and last number that a line begins with, and where the dash behind them stands."""
    numbers = [t.value for t in tokens[:1] if t.kind == "number" and isinstance(t.value, int)]
    if not numbers or len(tokens) < 3:
        return None
    at = 1
    if len(tokens) > 3 and tokens[1].word in ("-", "&", "and", "to") and isinstance(tokens[2].value, int):
        closes = (
            next((k for k in range(3, min(8, len(tokens))) if tokens[k].word == ")"), 2) if tokens[3].word == "(" else 2
        )
        if closes + 1 < len(tokens) and tokens[closes + 1].word == "-":
            numbers.append(tokens[2].value)
            at = closes + 1
    if tokens[at].word != "-" or tokens[at].glued or tokens[at + 1].glued:
        return None
    return numbers[0], numbers[-1], at


_SHAFTS: Final = (">", "-", "=")  # of an arrow


_GROWN: Final = re.compile(r"x(\d?)((?:sc|hdc|dc|tr)(?:inc|dec|\d?tog)?|inc|dec)")
"""A sign of times that has grown to a stitch: ``2xsc``, ``1x2sc``."""


def signs(rows: list[Row]) -> list[Row]:
    """Lines with a count behind signs of their own, ``>>8``, ``-> 8``, in brackets, numbers grown behind a stitch, ``inc(8) >>16``, before it, and
    signs of times parted from theirs, ``(2xSC, 1x2SC)``."""
    made = []
    for row in rows:
        if any(_GROWN.fullmatch(t.word) for t in row.tokens):
            row = replace(row, tokens=_split(_restated(row.tokens)))
        tokens = row.tokens
        if len(tokens) > 3 and tokens[-1].kind == "number" and tokens[-2].word == ">" and tokens[-3].word in _SHAFTS:
            number = tokens[-1]
            inner = _grown(tokens[:-3])
            opens, closes = (Token("mark", w, number.start, number.end) for w in "()")
            made.append(Row([*inner, opens, number, closes], row.start, row.end, row.marked))
        else:
            made.append(row)
    return made


def _restated(tokens: list[Token]) -> list[Token]:
    """Of a round that is told twice, "ch 1, sc in same st, 2 sc in next st around, (1xsc, 1x2sc)", the bracket."""
    opens = next((k for k, t in enumerate(tokens) if t.word == "(" and k > 1), 0)
    closes = next((k for k in range(opens, len(tokens)) if tokens[k].word == ")"), 0)
    around = opens - 1 - (tokens[opens - 1].word == ",") if opens else 0
    if not closes or tokens[around].word != "around" or not any(_GROWN.fullmatch(t.word) for t in tokens[opens:closes]):
        return tokens
    begin = next((k + 1 for k in range(around) if tokens[k].word == ":"), 0)
    begin += 3 if tokens[begin].word == "ch" and tokens[begin + 2].word == "," else 0
    past = closes + 1 + (closes + 1 < len(tokens) and tokens[closes + 1].word == "around")
    return [*tokens[:begin], *tokens[opens : closes + 1], tokens[around], *tokens[past:]]


def _split(tokens: list[Token]) -> list[Token]:
    """``2xsc`` as "2 x sc" and ``1x2sc`` as "2 sc in each of next 1 sts"."""
    made: list[Token] = []
    for k, token in enumerate(tokens):
        grown = _GROWN.fullmatch(token.word) if k and tokens[k - 1].kind == "number" and token.glued else None
        if grown is None:
            made.append(token)
            continue
        at = token.start + 1
        if not grown[1]:
            made += [replace(token, word="x", end=at), replace(token, word=grown[2], start=at, glued=False)]
            continue
        many = made.pop()
        some = Token("number", grown[1], at, at + 1, int(grown[1]))
        each = [Token("word", w, token.end, token.end) for w in ("in", "each", "of", "next")]
        made += [
            some,
            replace(token, word=grown[2], start=at + 1),
            *each,
            many,
            Token("word", "sts", token.end, token.end),
        ]
    return made


def _grown(tokens: list[Token]) -> list[Token]:
    """``inc(8)`` as "8 inc"."""
    made: list[Token] = []
    for k, token in enumerate(tokens):
        made.append(token)
        bracket = tokens[k - 2 : k + 1]
        if len(bracket) == 3 and token.word == ")" and bracket[1].kind == "number" and bracket[0].word == "(":
            word = tokens[k - 3] if k > 2 else None
            if bracket[0].glued and word is not None and word.kind == "word" and word.word.isalpha():
                made[-4:] = [bracket[1], word]
    return made
