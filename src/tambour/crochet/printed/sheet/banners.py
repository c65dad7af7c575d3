"""Printed patterns, banners: headings as designers set them: ``*FRONT*``, ``>> WINGS (make 2) <<``, ``~ Body ~``, ``Part 3: Pot``."""

from __future__ import annotations

import re
import unicodedata
from dataclasses import replace
from typing import Final

from tambour.crochet.places.names import kind_of, one
from tambour.crochet.printed.sheet.notes import MODES
from tambour.crochet.printed.tokens import Row, Token
from tambour.crochet.printed.wordings.vocabulary import Vocabulary
from tambour.crochet.printed.yarns.shades import shade
from tambour.crochet.words.numbers import NUMBERS

_FRAMES: Final = frozenset("*~-=<>_·•+#|/\\♥♡☆★^°:")
_TURNS: Final = ("*", "~", "=", "_", "·", "•", "+")
"""What stands before a name and behind it."""
_LINES: Final = frozenset("─━═-=~_")
_WORDS: Final = 6  # of a name
_ASIDE: Final = 8  # tokens behind a framed name: "*ARMS* (make 2)"
_CLOSED: Final = frozenset((".", ",", ";", "!", "?"))


def banners(text: str, rows: list[Row], vocabulary: Vocabulary) -> list[Row]:
    """``rows`` with what frames or numbers a part's name taken off, and such a line marked as a heading."""
    made: list[Row] = []
    for row in rows:
        made += (
            _remarked(text, _unframed(text, _copied(_yarned(text, row), vocabulary), vocabulary), vocabulary)
            if row.tokens
            else [row]
        )
    return made


def begun(text: str, rows: list[Row], vocabulary: Vocabulary) -> list[Row]:
    """``rows`` with how a part begins, behind its name, on a line of its own: ``BODY (A) - starts at the bottom``, ``2) HEAD -- begin in black, at
    the crown``, ``HAT (green), from the tip``; and without "in rows" among its yarns: ``AWNING (red, in rows)``."""
    return [one_ for row in rows for one_ in (_begun(text, row, vocabulary) if row.tokens else [row])]


_BEGINS: Final = frozenset(
    "start starts starting started begin begins beginning begun worked working made crocheted from".split()
)
_MANNERS: Final = frozenset(("rows", "rounds", "one"))  # "in one piece"
_HOW: Final = 14  # words that say where a part begins
_IN_ROWS: Final = re.compile(
    r"[,;] (?:(?:worked |crocheted |made )?in (?:rows|rounds|the round|a spiral|one piece)(?: from [^,;)]*)?"
    r"|(?:ch 1|1 ch)(?: and| to)? turn(?: (?:after )?(?:each|every) row)?)(?= [,;)])"
)
"""What a heading says among its yarns of how its part is worked."""


def _unnumbered(text: str, tokens: list[Token]) -> list[Token]:
    """A heading without its number before a rule: ``4 | DOOR (brown)``."""
    if len(tokens) < 3 or tokens[0].kind != "number" or tokens[1].word not in ("|", "│", "¦"):
        return tokens
    end = next((k for k in range(2, len(tokens)) if tokens[k].kind != "word"), len(tokens))
    name = text[tokens[2].start : tokens[end - 1].end] if end > 2 else ""
    return tokens[2:] if name.isupper() and len(name) > 2 else tokens  # no stitch: "MR"


def _led(how: list[Token]) -> str:
    """The word that says where a part begins, its yarn before it left out: "with orange, | from the tip"."""
    comma = next((k for k, t in enumerate(how[: _YARN + 2]) if t.word == ","), 0)
    dyed = comma > 1 and how[0].word in ("with", "in", "using") and comma + 1 < len(how)
    return how[comma + 1].word if dyed else how[0].word


def _begun(text: str, row: Row, vocabulary: Vocabulary) -> list[Row]:
    tokens = _unnumbered(text, row.tokens)
    if not any(t.kind == "word" and (t.word in _BEGINS or t.word in _MANNERS) for t in tokens[1:]):
        return [row if tokens is row.tokens else replace(row, tokens=tokens, marked=max(row.marked, 1))]
    led = 2 if tokens[0].kind == "number" and len(tokens) > 2 and tokens[1].word in (".", ")", ":", "-") else 0
    at = next((k for k in range(led + 1, len(tokens) - 1) if tokens[k].word in ("-", "--", ",", "–", "—")), 0)
    on = at
    while 0 < on < len(tokens) and tokens[on].kind == "mark":
        on += 1
    name, how = tokens[led:at], tokens[on:]
    bracket = next((k for k, t in enumerate(name) if t.word in ("(", "[")), len(name))
    closed = bracket == len(name) or name[-1].word in (")", "]")
    called = [t for t in name[:bracket] if t.kind != "mark"]
    named = bool(called) and (
        text[called[0].start : called[-1].end].isupper()
        or kind_of(one(called[-1].word)) != ""
        or tokens[-1].word == ":"  # "Carrot – with orange, from the tip:"
    )
    if (
        at
        and closed
        and named
        and 1 < len(how) <= _HOW
        and (_led(how) in _BEGINS or (how[0].word == "in" and how[1].word in _MANNERS))
        and _title(text, name, vocabulary)
        and not any(t.kind in ("stitch", "number") for t in vocabulary.read(how))
    ):
        return [
            Row(tokens[:at], row.start, tokens[at - 1].end, max(row.marked, 1)),
            Row(how, how[0].start, row.end),
        ]
    bracket = next((k for k, t in enumerate(tokens) if k and t.word == "("), 0)
    shut = next((k for k in range(bracket, len(tokens)) if tokens[k].word == ")"), 0)
    headed = bracket and (shut == len(tokens) - 1 or (shut and tokens[shut + 1].word == "."))
    while headed and (said := _IN_ROWS.search(words := " ".join(t.word for t in tokens[: shut + 1]))):
        at, many = len(words[: said.start()].split()), len(said[0].split())
        tokens, shut = [*tokens[:at], *tokens[at + many :]], shut - many
    return [row if tokens is row.tokens else replace(row, tokens=tokens)]


_YARN: Final = 3  # words of a yarn's name


def _copied(row: Row, vocabulary: Vocabulary) -> Row:
    """A heading with its copies and the yarn behind them as most have it: ``LEG 6x C1``, ``HORN 2x dark brown``; an x may be a stitch elsewhere."""
    tokens = row.tokens
    at = next((k for k, t in enumerate(tokens) if t.kind != "word"), 0)
    if not 0 < at <= _WORDS or not tokens[0].capital or tokens[at].kind != "number" or at + 1 == len(tokens):
        return row
    many, times, yarn = tokens[at], tokens[at + 1], tokens[at + 2 :]
    make = Token("word", "make", many.start, many.start)
    if (
        times.word != "x"
        or len(yarn) > _YARN
        or any(t.kind != "word" for t in yarn)
        or vocabulary.read([make])[0].kind != "key"
    ):
        return row
    signs = [Token("mark", sign, times.end, times.end, None, sign == ")") for sign in "()"]
    behind = [Token("word", "with", times.end, times.end), *yarn] if yarn else []
    return replace(row, tokens=[*tokens[:at], signs[0], make, many, *behind, signs[1]])


def _yarned(text: str, row: Row) -> Row:
    """A name in capitals with its yarn behind it: ``BODY start w yellow``, ``WINGS white x2``, ``EARS 2x in pale pink``."""
    tokens = row.tokens
    at = next((k for k, t in enumerate(tokens) if t.kind != "word" or not text[t.start : t.end].isupper()), 0)
    if (
        not 0 < at <= _NAME
        or row.marked
        or len(tokens) > at + _BEHIND
        or (at == 1 and len(tokens[0].word) <= _LETTERS)  # "A = red", "MC: cream" in a list of yarns
        or any(t.word in (*_CLOSED, "(", "[") for t in tokens)
    ):
        return row
    rest = [t for t in tokens[at:] if t.word not in ("(", ")", ",", "-", ":")]
    rest = [
        replace(t, kind="number", value=int(t.word[1:])) if t.word[:1] == "x" and t.word[1:].isdigit() else t
        for t in rest
    ]
    numbers = [t for t in rest if t.kind == "number"]
    hue = [t for t in rest if t.kind == "word" and t.word not in _LEADS]
    if not 0 < len(hue) <= _YARN or shade(" ".join(t.word for t in hue)) is None or len(numbers) > 1:
        return row
    many = next((t for t in numbers if isinstance(t.value, int)), None)
    a, b = tokens[at], tokens[-1]
    made = [Token("word", "make", many.start, many.start), many] if many is not None else []
    inner = [*made, Token("word", "with", a.start, a.start), *hue]
    signs = [Token("mark", "(", a.start, a.start), Token("mark", ")", b.end, b.end, None, True)]
    return replace(row, tokens=[*tokens[:at], signs[0], *inner, signs[1]])


_NAME: Final = 3
_LETTERS: Final = 2  # of what a list calls a yarn
_BEHIND: Final = 8
_LEADS: Final = frozenset(
    "start starting starts begin beginning w with in using use work worked x make color colour yarn".split()
)


_REMARK: Final = 4  # words of a remark that is none of a heading's own


def _remarked(text: str, row: Row, vocabulary: Vocabulary) -> list[Row]:
    """A heading with a remark in brackets as two lines: ``Scarf (back and forth, every 4 rows another colour)``, ``BOW TIE (boys & girls both
    look smashing in one) - second colour``."""
    tokens = row.tokens
    opened = next((k for k, t in enumerate(tokens) if t.word == "("), 0)
    closed = next((k for k, t in enumerate(tokens) if t.word == ")"), 0)
    if not 0 < opened < closed or not tokens[0].capital or opened > _WORDS:
        return [row]
    name, inner, behind = tokens[:opened], tokens[opened + 1 : closed], tokens[closed + 1 :]
    words = [t for t in inner if t.kind == "word"]
    if len(words) < _REMARK or any(t.kind != "word" for t in name) or not kind_of(one(name[-1].word)):
        return [row]
    if any(t.kind == "key" and t.value in ("make", "times") for t in vocabulary.read(inner)) or (
        behind and behind[0].word == ":"
    ):
        return [row]
    if (
        any(t.kind == "stitch" for t in vocabulary.read(name))
        or len(behind) > _ASIDE
        or any(t.word == ":" for t in behind)
    ):
        return [row]
    first = [*name, *behind]
    return [
        Row(first, row.start, row.end, max(row.marked, 1)),
        Row(inner, inner[0].start, inner[-1].end),
    ]


def _unframed(text: str, row: Row, vocabulary: Vocabulary) -> Row:
    tokens, framed = _ruled(row.tokens), False
    begin = next((k for k, t in enumerate(tokens) if not _frame(t)), len(tokens))
    end = len(tokens)
    while end > begin and _frame(tokens[end - 1]):
        end -= 1
    led = begin > 0 or any(c in _FRAMES for c in text[row.start : tokens[0].start])
    listed = tokens[begin : begin + 2] if led and end < len(tokens) and end - begin > 2 else []
    if listed and listed[0].kind == "number" and listed[1].word in (".", ")", ":"):
        begin += 2  # "+++ 8. COLLAR +++"
    if begin and tokens[0].word in _TURNS and end == len(tokens):  # "*ARMS* 2x", "~ CRUST ~ (brown)"
        close = next((k for k in range(begin, end) if tokens[k].word == tokens[0].word), end)
        behind = tokens[close:]
        while behind and behind[0].word == tokens[0].word:
            behind = behind[1:]
        ended = any(t.word == tokens[0].word or (t.word in _CLOSED and t.word != ",") for t in behind)
        copied = close < end and len(behind) <= _ASIDE and not ended
        if copied and _title(text, tokens[begin:close], vocabulary):
            return Row([*tokens[begin:close], *behind], row.start, row.end, max(row.marked, 1))
    elif close := _pictured(text, row, tokens[:end]):  # "♥ BELL ♥ lavender", "♥ ARMS ♥ make 2 in pink"
        behind = [t for t in tokens[close:end] if not _picture(t)]
        if len(behind) <= _ASIDE and _title(text, tokens[:close], vocabulary):
            if behind and behind[0].kind == "word" and not any(t.word in _CLOSED for t in behind):
                signs = [Token("mark", sign, at, at) for sign, at in (("(", behind[0].start), (")", behind[-1].end))]
                behind = [signs[0], *behind, signs[1]]
            return Row([*tokens[:close], *behind], row.start, row.end, max(row.marked, 1))
    elif led and end < len(tokens) and _title(text, tokens[begin:end], vocabulary):
        tokens, framed = tokens[begin:end], True
    at = _label(tokens, vocabulary)
    if at and _title(text, tokens[at:], vocabulary):
        tokens, framed = tokens[at:], True
    return replace(row, tokens=tokens, marked=max(row.marked, 1)) if framed else row


def _ruled(tokens: list[Token]) -> list[Token]:
    """Words with a rule behind a label as one stroke: ``PIECE 1 ─── POT``."""
    end = 2
    while end < len(tokens) and tokens[end].word in _LINES:
        end += 1
    return tokens if end < 4 else [*tokens[:2], replace(tokens[2], word="-"), *tokens[end:]]


def _frame(token: Token) -> bool:
    return _picture(token) or (token.kind == "mark" and all(c in _FRAMES for c in token.word))


def _picture(token: Token) -> bool:
    return token.kind == "mark" and unicodedata.category(token.word[0]) in (
        "So",
        "Sm",
        "Cn",
    )  # Cn: younger than Python's table of signs


def _pictured(text: str, row: Row, tokens: list[Token]) -> int:
    """Where a picture that begins a line stands again behind its first words: "♥ BELL ♥ lavender"; else 0."""
    drawn = text[row.start : tokens[0].start].strip() if tokens else ""
    return next((k for k, t in enumerate(tokens) if k and _picture(t) and t.word[0] in drawn), 0)


def _label(tokens: list[Token], vocabulary: Vocabulary) -> int:
    """Where the name behind "Part 3:", "Piece B -" stands; 0 where none does."""
    if len(tokens) > 1 and tokens[0].kind == "number" and len(tokens[0].word) == 2 and tokens[0].word[0] == "0":
        return 1 if tokens[1].kind == "word" else 0  # "02 Gills"
    if len(tokens) < 4 or tokens[0].word not in vocabulary.labels or tokens[2].word not in (":", "-", ".", ")"):
        return 0
    numbered = tokens[1].kind == "number" or (tokens[1].kind == "word" and len(tokens[1].word) <= 2)
    numbered = numbered or tokens[1].word in NUMBERS  # "PART FOUR: DOORSTEP"
    names = tokens[0].word not in vocabulary.steps or all(
        kind_of(one(t.word)) or t.word in ("and", "&") or (t.kind == "key" and t.value in MODES)
        for t in vocabulary.read(tokens[3:])
    )
    return 3 if numbered and names else 0


def _title(text: str, tokens: list[Token], vocabulary: Vocabulary) -> bool:
    """Whether words can be a heading: a few, the first with a capital, that name no stitch, round or list outside brackets."""
    bracket = next((k for k, t in enumerate(tokens) if t.word in ("(", "[", "-", ",") and k), len(tokens))
    name = tokens[:bracket]
    words = [t for t in name if t.kind != "mark"]
    if not words or len(words) > _WORDS or not text[words[0].start].isupper() or words[0].kind != "word":
        return False
    if any(t.word in _CLOSED or t.word in ("*", ":") for t in name):
        return False
    read = vocabulary.read(list(name))
    return not any(
        t.kind == "stitch" or (t.kind == "key" and t.value in ("round", "row", "repeat", "ring", "times", "stitch"))
        for t in read
    )
