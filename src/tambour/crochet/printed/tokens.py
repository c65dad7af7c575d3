"""Printed patterns, the characters: text → lines of tokens, each with its place."""

from __future__ import annotations

import re
import unicodedata
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, Final

from tambour.core.errors import Span

_HIDDEN: Final = "\u200b\u200c\u200d\u2060\ufeff\u00ad"
"""Signs of no width, as pages of the web hold them inside words: "in\\u00adcrease"."""
# One alternation without nested repeats, so the time is linear whatever the text.
_TOKEN: Final = re.compile(
    r"(?P<newline>\n)"
    r"|(?P<ordinal>(?:\d{0,8}(?:1st|2nd|3rd)|\d{1,8}\drd|\d{1,9}(?:th|er|e|ème|eme|ère|re|ste|de|te|[ºª°](?!C)))(?![^\W\d_]))"
    rf"|(?P<number>\d(?:\d|[{_HIDDEN}](?=\d))*(?:\.\d+)?)"
    rf"|(?P<word>[^\W\d_](?:[\w'’]|[{_HIDDEN}](?=[^\W\d_]))*)"
    r"|(?P<mark>\*\*+|\*|--+|[^\s\w]|_+)"
)
_TURKISH: Final = str.maketrans("ı", "i", "\u0307")
_SPLIT: Final = re.compile(r"/f_([il]) ")  # a ligature that a page lost: "/f_i rst"
_TICKS: Final = re.compile(r"`(?![^\W\d_])|(?<![^\W\d_])`")  # code in Markdown
_TAGS: Final = re.compile(
    r"</?(?:b|strong|i|em|u|p|br|h[1-6]|div|span|font|small|center|li|ul|ol)(?:\s[^<>\n]{0,80})?/?>|&nbsp;",
    re.IGNORECASE,
)
"""What is left of a page of the web."""
_SLANTED: Final = re.compile(r"(?<![\w])_{1,3}(?=[^\W_])|(?<=[^\W_])_{1,3}(?!\w)")
"""Words between strokes, as Markdown has them slanted: "_Ear_"."""
_DASHES: Final = dict.fromkeys("–—−‐‑-", "-") | {"--": "-", "---": "-"}
_MARKS: Final = {"×": "x", "✕": "x", "✖": "x", "∗": "*", "⁎": "*", "＊": "*", "“": '"', "”": '"', "、": ",", "：": ":"}
_WIDE: Final = {0xFF01 + k: 0x21 + k for k in range(94)} | {0x3000: 0x20, 0x2192: 0x3A, 0x279C: 0x3A, 0x21D2: 0x3A}
"""Letters, digits and marks as wide as Chinese ones, "（６）", and arrows behind the head of a round, which stand for a colon."""
_UNSEEN: Final = frozenset(_HIDDEN + "\ufe0f\u20e3")  # also the frame of a key around a number
_SHOWN: Final = str.maketrans(
    "ıİаеорсухіѕјһԁАВЕКМНОРСТХІЅЈοΟυ", "iIaeopcyxisjhdABEKMHOPCTXISJoOu", _HIDDEN
)  # "MAGİC RİNG, ınc", and letters of other alphabets that look like ours
_UP_TO: Final = frozenset(("-", "/", "&", "+", "to", "and"))
_LONGEST: Final = 9  # digits of a number that is taken for one


@dataclass(slots=True)
class Token:
    """A word, number or mark.

    kind : "word", "number", "ordinal" or "mark"; the vocabulary adds "stitch" and "key"
    word : as it is compared: small letters, plain marks
    start, end : its characters in the text
    value : a number's value; what a word means
    glued : nothing stands between it and the token before
    capital : it begins with a capital letter
    """

    kind: str
    word: str
    start: int
    end: int
    value: Any = None
    glued: bool = False
    capital: bool = False

    @property
    def span(self) -> Span:
        """Its characters."""
        return Span(self.start, self.end)


@dataclass(slots=True)
class Row:
    """One line of the text: its tokens and its characters; ``marked`` 0 plain, 1 bold, 2 a heading in Markdown."""

    tokens: list[Token]
    start: int
    end: int
    marked: int = 0


def rows(text: str) -> list[Row]:
    """The lines of ``text``; Markdown's signs of weight, quotation and lists are taken off."""
    made: list[Row] = []
    text = _SPLIT.sub(r"   f\1", text)  # places stay as they are
    text = text if text.isascii() else text.translate(_WIDE)
    text = _TICKS.sub(" ", text)
    for marks in (_TAGS, _SLANTED) if "<" in text or "_" in text or "&" in text else ():
        text = marks.sub(_blanked, text)
    tokens: list[Token] = []
    start = last = 0
    for found in _TOKEN.finditer(text):
        kind, at = found.lastgroup, found.start()
        if kind == "newline":
            made.append(_row(tokens, start, at))
            tokens, start, last = [], at + 1, at + 1
            continue
        word, end = found[0], found.end()
        capital = word[0].isupper()
        word = word if word.isascii() else word.translate(_SHOWN) or word
        value: Any = None
        if kind == "word":
            word = word.lower()
            if not word.isascii():
                word = word.replace("’", "'")
                word = unicodedata.normalize("NFKC", word).translate(_TURKISH)  # ligatures of a typeset page
            if (
                len(word) > 1 and word[-1] == "в" and word[:-1].isascii()
            ):  # "6 scв ring", a page put into English by a machine
                tokens.append(Token("word", word[:-1], at, end - 1, None, bool(tokens) and at == last, capital))
                word, at = "in", end - 1
            word = word.removesuffix("'s").rstrip("'") if "'" in word else word
            if word == "a" and found[0] == "A" and tokens:
                value = "A"  # it may be a yarn's letter, where an article would be small
        elif kind == "number":
            if len(word) > _LONGEST:
                kind = "word"
            else:
                value = float(word) if "." in word else int(word)
        elif kind == "ordinal":
            value = int(re.match(r"\d+", word)[0])  # type: ignore[index]
        else:
            word = _DASHES.get(word, _MARKS.get(word, word))
        if word == "\\" or word in _UNSEEN:
            continue
        tokens.append(Token(kind or "mark", word, at, end, value, bool(tokens) and at == last, capital))
        last = end
    made.append(_row(tokens, start, len(text)))
    return made


def _blanked(found: re.Match[str]) -> str:
    return " " * len(found[0])


def _row(tokens: list[Token], start: int, end: int) -> Row:
    marked = 0
    at = 0
    while at < len(tokens) and tokens[at].kind == "mark" and (tokens[at].word in _LEADING or _sign(tokens[at].word)):
        word = tokens[at].word
        if word == "#" and not (at + 1 < len(tokens) and tokens[at + 1].glued and tokens[at + 1].kind == "number"):
            marked = 2  # "#1 Sew the head on" is a step
        if word in ("*", "-", "+") and not _bullet(tokens, at):
            break
        at += 1
    while len(tokens) > at and (tokens[-1].word == "|" or tokens[-1].word in _BOXES):
        tokens.pop()  # "Rounds 10-17: sc 42 {42} ☐☐☐"
    tokens = _dotted(_kerned(_undashed(_unpictured(tokens[at:]))))
    weights = [t for t in tokens if t.word in _WEIGHTS]
    if weights and not any(b.word in _WEIGHTS and a.word in _PAIRED for a, b in pairwise(tokens)):
        if len(weights) == 2 and tokens[0] is weights[0] and not marked:
            after = tokens[tokens.index(weights[1]) + 1 :]
            named = bool(after) and after[0].word in ("(", "make", "x") and len(after) < _ASIDE
            marked = int(not after or (after[-1].word == ":" and len(after) == 1) or named)
        # A closing pair that a repeat follows is a repeat's sign; any other is weight.
        if len(weights) % 2 == 0:
            tokens = [t for t in tokens if t.word not in _WEIGHTS]
    return Row(tokens, start, end, marked)


def _sign(mark: str) -> bool:
    """Whether a mark is a picture, as lists and headings begin with: "☐ Rnd 1", "📌 Head"."""
    return unicodedata.category(mark[0]) in ("So", "Cn") and mark not in "©®"  # Cn: younger than Python's table


def _unpictured(tokens: list[Token]) -> list[Token]:
    """The words of a round without pictures among them, "r4 🖤 sc around ✨ (18)"; one that stands before its last number is the sign of its count."""
    first = tokens[0] if tokens else None
    if first is None or (first.kind not in ("number", "ordinal") and first.word.rstrip("0123456789") not in _ROUNDS):
        return tokens
    if "".join([t.word for t in tokens]).isascii():
        return tokens
    last = next((t for t in reversed(tokens) if t.kind == "number"), None)
    return [
        t
        for k, t in enumerate(tokens)
        if not (t.kind == "mark" and _sign(t.word)) or (k + 1 < len(tokens) and tokens[k + 1] is last)
    ]


def _kerned(tokens: list[Token]) -> list[Token]:
    """``tokens`` with the digits of a count together that a page set apart: "2 0 sts"."""
    for k in range(len(tokens) - 2):
        one, two, after = tokens[k : k + 3]
        apart = one.kind == two.kind == "number" and len(one.word) == len(two.word) == 1 and two.start == one.end + 1
        before = k - 1 - (k > 1 and tokens[k - 1].word in (".", "#"))
        ranged = tokens[k - 1].word in _UP_TO and k > 1 and tokens[k - 2].word[-1].isdigit()
        named = (
            not k or tokens[before].word in _ROUNDS or tokens[k - 1].word in ("x", "*") or ranged
        )  # "Rnd 1 6 sc", "R.1 6 sc", "dec x 6 6sts", "rnd 3-5 1 sc in each st", "r6-7 4sc"
        if apart and one.value and not named and after.word in ("sts", "sc", "st", "stitches"):
            whole = Token("number", one.word + two.word, one.start, two.end, 10 * one.value + two.value, one.glued)
            return [*tokens[:k], whole, *_kerned(tokens[k + 2 :])]
    return tokens


def _undashed(tokens: list[Token]) -> list[Token]:
    """``tokens`` without the dash in "18-sts", "6-inc"."""
    return [
        t
        for k, t in enumerate(tokens)
        if not (
            t.word == "-"
            and t.glued
            and k
            and tokens[k - 1].kind == "number"
            and k + 1 < len(tokens)
            and tokens[k + 1].glued
            and (
                tokens[k + 1].word in _STS
                or (tokens[k + 1].word in _SHAPED and k > 1 and tokens[k - 2].word not in _ROUNDS)
            )
        )
    ]


def _dotted(tokens: list[Token]) -> list[Token]:
    """``tokens`` with letters and points together that are one short word: "6 d.c. into loop"."""
    if not any(t.word == "." and t.glued for t in tokens):
        return tokens
    made: list[Token] = []
    at = 0
    while at < len(tokens):
        letters, end = "", at
        while (
            end + 1 < len(tokens)
            and len(tokens[end].word) <= 3
            and tokens[end].kind == "word"
            and tokens[end + 1].word == "."
            and tokens[end + 1].glued
            and (end == at or tokens[end].glued)
        ):
            letters, end = letters + tokens[end].word, end + 2
        if end - at < 4 or letters not in _DOTTED:
            made.append(tokens[at])
            at += 1
            continue
        after = tokens[end] if end < len(tokens) else None
        stops = after is None or after.capital
        last = tokens[end - 1]
        made.append(Token("word", letters, tokens[at].start, last.start, None, tokens[at].glued, tokens[at].capital))
        made += [last] if stops else []
        at = end
    return made


_DOTTED: Final = frozenset("dc sc ss hdc htr tr dtr slst blo flo mr".split())
_SHAPED: Final = frozenset("inc dec sc".split())
_STS: Final = frozenset("st sts stitch stitches".split())
_ROUNDS: Final = frozenset("rnd rnds round rounds row rows r rd".split())
_PAIRED: Final = frozenset(("from", "to", "between", "at"))  # "rep from ** to **", "ending at **": no weight
_ASIDE: Final = 14
"""So many words may follow a bold name on its line: "**Body** (start with blue, at the nose)", "**Fins** make 2, in blue"."""
_WEIGHTS: Final = frozenset(("**", "***", "****", "__", "___"))
_GOES_ON: Final = frozenset(("around", "across", "to", "until", "end", "all", "twice", "once"))  # "Rep from | * around"
_BOXES: Final = frozenset("☐☑□▢◻⬜▫◯")  # that are ticked, one a round
_LEADING: Final = frozenset("#>›»‣⁃∙~•◦▪●○■□★☆♥❤·*-+|")


def _bullet(tokens: list[Token], at: int) -> bool:
    """Whether the mark at ``at`` is a list's: room follows it, and no other of its kind wants it to begin a repeat."""
    if at + 1 >= len(tokens) or tokens[at + 1].glued or tokens[at + 1].word in _GOES_ON:
        return False
    return tokens[at].word != "*" or sum(t.word == "*" for t in tokens[at + 1 :]) % 2 == 0
