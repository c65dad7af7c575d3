"""Printed patterns, tallies: what a text has of its own before its rounds and behind them, a sign, a word, a bullet of a symbol font, known by its standing
in line after line: ``£ Rnd 3``, ``Ring 3:``, ``… ~18``, ``… /18/``, ``… for a total of 18``; put as others do: ``Rnd 3: … (18)``."""

from __future__ import annotations

import re
import unicodedata
from collections import Counter
from dataclasses import dataclass, replace
from typing import Final

from tambour.crochet.printed.heads import head
from tambour.crochet.printed.sheet.numerals import noted
from tambour.crochet.printed.tokens import Row, Token
from tambour.crochet.printed.wordings.vocabulary import Vocabulary

_RUN: Final = 3  # lines that bear the same sign before it is the text's own
_SHARE: Final = 0.6  # of the rounds, for signs that mean something else in others
_SPLIT: Final = re.compile(r"([a-z]{1,5})_?(\d{1,3})_?")
_UNITS: Final = frozenset("sts st stitch stitches sc dc total altogether loops".split())
_PHRASE: Final = frozenset(
    "total totals count for of a now you have get should will be there are makes making make equals is we giving gives "
    "leaves leaving st sts stitch stitches that tot sum to make".split()
)
_POINTED: Final = frozenset(("t", "tot", "sum", "no", "number"))
_SHORTENED: Final = frozenset(("tot", "no", "sum"))
"""A point behind these ends no sentence."""
_READ: Final = (("-",), ("=",), (":",), (";",), (".",), ("|",))  # signs that every text's counts may have
_BINDING: Final = frozenset(("x", "*", "+", "_"))
"""These bind a number to what is before it, unless they stand behind it too."""
_TIMES: Final = re.compile(r"[x×*]\d+")
_DONE: Final = frozenset("close closed fo fasten off stuff cut end and then finish done .".split())
_CLOSED: Final = frozenset((")", "]", "}"))  # a repeat may end so before its count
_WORKED: Final = frozenset("ring mr mc around each all st sts round times stitch".split())
"""Behind these words a number alone is no number of stitches to work."""
_OPENED: Final = {"(": ")", "[": "]", "{": "}", "<": ">", "【": "】", "«": "»"}
_FRAMES: Final = (("(",), ("[",), ("{",), ("<",))
_OWN: Final = frozenset("st sts stitch stitches of a with".split())
"""These belong to the round, and not to its count, where they stand first."""
_BOUND: Final = frozenset("x times time more st sts stitch stitches sc dc hdc in of from and to".split())
"""Behind these a number in brackets is none that ends a round."""
_INTO: Final = frozenset("next of in the each every first last make work".split())
_PARTING: Final = frozenset((";", ":", "-", "."))
"""Signs that part what is worked from how often."""
_SAID: Final = frozenset((",", "+"))
_ALL: Final = frozenset("all both these those remaining rem following other same".split())
_LONGEST: Final = 6  # words before a count
_COLUMN: Final = "  "
_BESIDE: Final = frozenset((",", "", _COLUMN))
_GAP: Final = 2  # blanks before a number that stood in a column of its own
_YARNS: Final = frozenset("with color colour yarn using join in make size to".split())  # "With Color 2, ch 6"
_APART: Final = 5  # lines from one round to the next
_LETTERS: Final = frozenset("rnd rnds rd round rounds r row rows rondje foundation".split())
_MOST: Final = 400


def tallied(rows: list[Row], vocabulary: Vocabulary, called: str) -> list[Row]:
    """``rows`` with the text's own signs as most texts have them. called : the word for a round."""
    rows = [_again(row, vocabulary) for row in _unlettered(unpointed(rows))]
    return [_parted(row) for row in _counts(_heads(rows, vocabulary, called), vocabulary)]


def _again(row: Row, vocabulary: Vocabulary) -> Row:
    """``row`` with what is said to be repeated in brackets: "1 sc, inc; x 6", "sc, inc: 6 times", "6 times: sc, inc"."""
    tokens = row.tokens
    words = {t.word for t in tokens}
    said = "times" in words or any(word[:1] in ("x", "*") for word in words)
    k = next((k for k in range(2, len(tokens)) if _repeats(tokens, k)), 0) if said else 0
    if not k:
        return row
    begin = _begins(tokens, vocabulary)
    if begin is None:
        return row
    opens, closes = (Token("mark", sign, tokens[begin].start, tokens[begin].start) for sign in "()")
    before = tokens[k - 1]
    if (
        begin < k
        and before.word in _PARTING
        and not any(t.word in _OPENED or t.word in _CLOSED for t in tokens[begin:k])
    ):
        return replace(row, tokens=[*tokens[:begin], opens, *tokens[begin : k - 1], closes, *tokens[k:]])
    if k == begin and k + 2 < len(tokens) and tokens[k + 2].word == ":":
        end = next(
            (n for n in range(k + 3, len(tokens)) if tokens[n].word not in _SAID and tokens[n].kind == "mark"),
            len(tokens),
        )
        return replace(
            row, tokens=[*tokens[:begin], opens, *tokens[k + 3 : end], closes, *tokens[k : k + 2], *tokens[end:]]
        )
    return row


def _repeats(tokens: list[Token], k: int) -> bool:
    """Whether "x 6", "6 x" or "6 times" stands there."""
    one, two = tokens[k], tokens[k + 1] if k + 1 < len(tokens) else tokens[k]
    if one.word in ("x", "*"):
        ends = k + 2 >= len(tokens) or tokens[k + 2].kind == "mark"  # no "*2 sc in next st; rep from *"
        return two.kind == "number" and ends and tokens[k - 1].word in _PARTING
    if re.fullmatch(r"x\d+", one.word):
        return tokens[k - 1].word in _PARTING
    return one.kind == "number" and two.word in ("x", "times")


def _parted(row: Row) -> Row:
    """``row`` with a full stop behind its count where she goes on: "sc around (18) this is the knee", "(18) cut the yarn"."""
    tokens = row.tokens
    closed = [k for k, t in enumerate(tokens[:-1]) if k > 3 and (t.word == ")" or t.word == "]")]
    for k in closed:
        after, opens = tokens[k + 1], k - 2 - (tokens[k - 1].word in _UNITS)
        if after.word == "(" and k + 2 < len(tokens):  # "(18) (the knee looks back)"
            after = tokens[k + 2]
        if after.kind != "word" or after.word in _BOUND:
            continue
        number = tokens[opens + 1]
        framed = tokens[opens].word in ("(", "[") and number.kind == "number" and isinstance(number.value, int)
        if framed and opens > 2 and tokens[opens - 1].word not in _INTO:
            stop = Token("mark", ".", tokens[k].end, tokens[k].end, None, True)
            return replace(row, tokens=[*tokens[: k + 1], stop, *tokens[k + 1 :]])
    return row


def _unlettered(rows: list[Row]) -> list[Row]:
    """``rows`` without the letters that number the parts, "A  BODY", "B. HEAD 2x", which may be stitches elsewhere."""
    made = list(rows)
    meant = "a"
    for k, row in enumerate(rows):
        first = row.tokens[0] if len(row.tokens) > 1 else None
        if first is None or first.word != meant or not first.capital:
            continue
        at = 1 + (row.tokens[1].word in (".", ")", ":"))
        named = row.tokens[at] if at < len(row.tokens) else None
        if named is None or named.kind != "word" or len(named.word) < 3 or not (named.capital and named.word.isalpha()):
            continue
        made[k] = replace(row, tokens=row.tokens[at:])
        meant = chr(ord(meant) + 1)
    return made if meant > "b" else rows


def unpointed(rows: list[Row]) -> list[Row]:
    """``rows`` without what stands before rounds as a list's point: any sign, or the letter that a symbol font has for one."""
    points: Counter[str] = Counter()
    for row in rows:
        if len(row.tokens) > 3 and row.tokens[1].word in _LETTERS and not row.tokens[1].glued:
            points[row.tokens[0].word] += 1
    known = {
        w
        for w, n in points.items()
        if n >= _RUN and len(w) == 1 and w not in _OPENED and (w.isalpha() or not w.isalnum())
    }
    if not known:
        return rows
    return [
        replace(row, tokens=row.tokens[1:])
        if len(row.tokens) > 2 and row.tokens[0].word in known and not row.tokens[1].glued
        else row
        for row in rows
    ]


def _heads(rows: list[Row], vocabulary: Vocabulary, called: str) -> list[Row]:
    """Lines whose numbers follow each other behind the same word or sign, and that work stitches, as rounds."""
    made = list(rows)
    run: list[int] = []
    last, shape = 0, ""
    found = [_led(row.tokens) if row.tokens else None for row in rows]
    for k in range(len(rows) + 1):
        one = found[k] if k < len(rows) else None
        if k < len(rows) and one is None:
            continue
        if one is not None and run and one[0] == shape and one[1] == last + 1 and k - run[-1] <= _APART:
            run.append(k)
            last = one[2]
            continue
        if len(run) >= _RUN:
            _renamed(made, run, found, vocabulary, called)
        run = [k] if one is not None and one[1] == 1 else []
        if one is not None:
            shape, last = one[0], one[2]
    return made


_Led = tuple[str, int, int, int, int]


def _led(tokens: list[Token]) -> _Led | None:
    """What a line has before its number, the first and the last number, and where they and the line's words begin."""
    at = 0
    while at < min(4, len(tokens)) and tokens[at].kind != "number":
        if tokens[at].word in _OPENED or tokens[at].word in (",", ":"):
            return None
        grown = _SPLIT.fullmatch(tokens[at].word)
        if grown and tokens[at].kind == "word" and int(grown[2]) < _MOST:
            return _ranged(tokens, at + 1, int(grown[2]), at, grown[1])
        at += 1
    if at >= len(tokens) or tokens[at].kind != "number" or not isinstance(tokens[at].value, int) or at > 3:
        return None
    words = [t.word for t in tokens[:at] if t.word not in ("_", "-")]
    if any(word in _YARNS for word in words):
        return None
    return _ranged(tokens, at + 1, tokens[at].value, at, " ".join(words))


def _ranged(tokens: list[Token], at: int, first: int, begin: int, named: str) -> _Led | None:
    last = first
    if (
        at + 1 < len(tokens)
        and tokens[at].word in ("-", "~", "&", "to", "and")
        and not (named and tokens[at].word == "-" and not tokens[at].glued)
        and not (tokens[at].kind == "mark" and tokens[at].glued and not tokens[at + 1].glued)  # "1- 6 sc"
    ):
        grown = _SPLIT.fullmatch(tokens[at + 1].word)
        value = tokens[at + 1].value if tokens[at + 1].kind == "number" else int(grown[2]) if grown else None
        if isinstance(value, int) and first < value < _MOST:
            last, at = value, at + 2
    signs = []
    while at < len(tokens) and tokens[at].kind == "mark" and tokens[at].word not in _OPENED and tokens[at].word != "*":
        signs.append(tokens[at].word)
        at += 1
    if not 0 < first <= last < _MOST or at >= len(tokens) or not (named or signs):
        return None
    return f"{named}|{''.join(signs)}", first, last, begin, at


def _renamed(rows: list[Row], run: list[int], found: list[_Led | None], vocabulary: Vocabulary, called: str) -> None:
    """Sets the lines of a run as rounds where they work stitches, and are not seen as rounds already."""
    read = [vocabulary.read(rows[k].tokens) for k in run]
    seen = [head(tokens) for tokens in read]
    if sum(one is None for one in seen) < _RUN:
        return
    stitches = sum(any(t.kind == "stitch" or t.value in ("ring", "around", "even") for t in tokens) for tokens in read)
    if stitches < 0.7 * len(run) or not any(t.value in ("ring", "ch") or t.word == "6" for t in read[0]):
        return
    for k in run:
        one = found[k]
        assert one is not None
        _, first, last, begin, at = one
        row, number = rows[k], rows[k].tokens[begin]
        named = Token("word", called, number.start, number.start, None, False, True)
        numbers = [Token("number", str(first), number.start, number.end, first)]
        if last > first:
            numbers += [
                Token("mark", "-", number.end, number.end),
                Token("number", str(last), number.start, number.end, last),
            ]
        colon = Token("mark", ":", number.end, number.end, None, True)
        rows[k] = replace(row, tokens=[named, *numbers, colon, *row.tokens[at:]])


def _counts(rows: list[Row], vocabulary: Vocabulary) -> list[Row]:
    """Counts behind rounds, in brackets."""
    ends: dict[int, tuple[tuple[str, ...], int, int]] = {}
    rounds = 0
    for k, row in enumerate(rows):
        if (
            len(row.tokens) < 3
            or noted(row.tokens)
            or not any(c.isdigit() for t in row.tokens[:3] for c in t.word[-1:])
        ):
            continue
        if (begin := _begins(row.tokens, vocabulary)) is None:
            continue
        rounds += 1
        if (end := _behind(row.tokens[: _tail(row.tokens, vocabulary)], begin)) is not None:
            ends[k] = end
    many = Counter(shape for shape, _, _ in ends.values())
    made = list(rows)
    for k, (shape, at, number) in ends.items():
        if many[shape] < _RUN or (shape[0] in _BESIDE and many[shape] < _SHARE * rounds):
            continue
        row = rows[k]
        count = row.tokens[number]
        opens, closes = (Token("mark", sign, count.start, count.end) for sign in "()")
        tail = _tail(row.tokens, vocabulary)
        stop = row.tokens[tail:] or (row.tokens[-1:] if row.tokens[-1].word == "." else [])
        made[k] = replace(row, tokens=[*row.tokens[:at], opens, replace(count, glued=True), closes, *stop])
    return made


def _tail(tokens: list[Token], vocabulary: Vocabulary) -> int:
    """Where a bracket begins that ends a line and says how many rounds it is, "42  (7 rounds)", or what is done behind the count, "6, close";
    the line's end where none does."""
    comma = max((k for k, t in enumerate(tokens) if t.word in (",", ";")), default=0)
    behind = tokens[comma + 1 :] if comma > 1 and tokens[comma - 1].kind == "number" else []
    if behind and all(t.word in _DONE for t in behind):
        return comma
    k = len(tokens) - 4
    if (
        k < 2
        or tokens[k].word not in _OPENED
        or tokens[-1].word != _OPENED[tokens[k].word]
        or tokens[k + 1].kind != "number"
    ):
        return len(tokens)
    said = vocabulary.read(tokens[k + 2 : -1])
    return k if len(said) == 1 and said[0].value in ("round", "row") else len(tokens)


def _begins(tokens: list[Token], vocabulary: Vocabulary) -> int | None:
    """Where a line says what its round works, None where it has no head, or nothing behind it."""
    read = vocabulary.read(tokens)
    first = head(read)
    if first is None or first.end >= len(read):
        return None
    return next((n for n, t in enumerate(tokens) if t.start >= read[first.end].start), None)


def _of_round(tokens: list[Token], k: int) -> bool:
    """Whether stitches are those of the round by the word at ``k`` before them: "in each st: 18", "in next 18 sts: 18"."""
    counted = tokens[k].kind == "number" and tokens[k - 1].word not in ("x", "*")
    return counted or tokens[k].word in _INTO | _ALL


@dataclass(frozen=True)
class _Ending:
    """What a line ends with: signs, words and a number, and signs behind it."""

    at: int  # where it begins
    number: int
    opening: tuple[str, ...]
    said: tuple[str, ...]
    closing: tuple[str, ...]


def _behind(tokens: list[Token], begin: int) -> tuple[tuple[str, ...], int, int] | None:
    """The signs and words about the number that ends a line, where they begin, and where it stands; None where it is a count as
    every text has it, or none."""
    end = _ending(tokens, begin)
    if end is None:
        return None
    opening, said, closing = end.opening, end.said, end.closing
    before = tokens[end.at - 1].word
    if not opening and not said and tokens[end.number].start - tokens[end.at - 1].end >= _GAP:
        return (_COLUMN, *closing), end.at, end.number
    if not opening and not said:
        done = (
            tokens[end.at - 2].kind == "number" and end.at - 2 >= begin
        )  # "6 inc 12": how many of them is said before them
        worked = tokens[end.at - 1].kind == "word" and not (before in _WORKED or _TIMES.fullmatch(before) or done)
        return None if worked or before in _BINDING else (("", *closing), end.at, end.number)
    if not said:
        bound = len(opening) == 1 and opening[0] in _BINDING and opening[0] not in closing
        dots = not closing and set(opening) == {"."}
        if bound or dots or opening in _READ or (opening == ("#",) and before in _LETTERS):
            return None
        framed = opening in _FRAMES and closing == (_OPENED[opening[0]],)
        if framed and len(tokens) == end.number + 2:
            return None  # "(18)" as everywhere
    return (*opening, *said, *closing) if opening else (f"~{' '.join(said)}", *closing), end.at, end.number


def _ending(tokens: list[Token], begin: int) -> _Ending | None:
    """The last number of a line, if nothing but signs and the words of a count stand about it."""
    end = len(tokens)
    while end > begin and tokens[end - 1].kind == "mark":
        end -= 1
    closing = [t.word for t in tokens[end:] if t.word != "." and unicodedata.category(t.word[0]) != "So"]
    while end > begin and (tokens[end - 1].word in _UNITS or tokens[end - 1].word == "now"):
        end -= 1
    if end > begin and tokens[end - 1].word == "in":  # "in total"
        end -= 1
        while end > begin and tokens[end - 1].word in _UNITS:
            end -= 1
    number = end - 1
    if number <= begin or tokens[number].kind != "number" or not isinstance(tokens[number].value, int):
        return None
    sign, word = tokens[number - 1].word, tokens[number - 2].word
    pointed = number - 2 > begin and (
        (sign in (":", "=") and word in _PHRASE | _POINTED) or (sign == "." and word in _SHORTENED)
    )
    at = number - pointed
    pointed = pointed and not (tokens[number - 2].word in _OWN and _of_round(tokens, number - 3))
    at -= pointed
    said: list[str] = [tokens[at].word] if pointed else []  # "Sts = 18", "total: 18"
    while at > begin and tokens[at - 1].word in _PHRASE and len(said) < _LONGEST:
        said.insert(0, tokens[at - 1].word)
        at -= 1
    while (
        len(said) > pointed and said[0] in _OWN and said[1:2] != ["count"]
    ):  # "in each st 12", "in the next st for a total of 12"
        said.pop(0)
        at += 1
    opening: list[str] = []
    while at > begin and tokens[at - 1].kind == "mark" and tokens[at - 1].word not in _CLOSED | {"x"}:
        if opening and tokens[at - 1].word == '"':  # the end of words in quotes
            break
        opening.insert(0, tokens[at - 1].word)
        at -= 1
    return _Ending(at, number, tuple(opening), tuple(said), tuple(closing)) if at > begin else None
