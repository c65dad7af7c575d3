"""Printed patterns, sizes: a text for several ("S (M, L)", "12 (14, 16) sc") as it reads for one of them, every word in its place; whether it
names them or only writes its numbers so."""

from __future__ import annotations

import re
from collections import Counter
from dataclasses import dataclass
from typing import Final

from tambour.core.errors import Span, Text

_NAMED: Final = re.compile(
    r"(?:^|\n)[ \t#*•-]*(?:(?:finished|doll|toy|available)\s+)?(?:sizes?|to fit(?: (?:\w+ )?sizes?)?)\b[ \t]*[:.]?[* \t]*\n?[ \t]*(?P<first>[^\s()\[\]:,.][^()\[\]:,.\n]{0,24}?)?"
    r"[ \t]*[(\[](?P<more>[^()\[\]\n]{1,80})[)\]]",
    re.IGNORECASE,
)
_PART: Final = re.compile(
    r"\s*[,;–]\s*|\s*(?<!\d)/\s*|\s*/(?!\d)\s*|\s+-\s+|(?<=[a-z])-(?=[A-Z0-9])"
)  # "2/4 yrs" is one
_ONLY: Final = re.compile(
    r"(?:\b(?P<both>(?:all|both) (?:sizes|versions|baskets|hats)\b)|\b(?:for )?(?:sizes?|versions?) (?P<sizes>[^:.\n]{1,60}?),? only|\b(?:for )?(?P<named>[A-Z0-9][^:.\n]{0,40}?) (?:size|version)s? only"
    r"|(?m:^)[ \t]*(?:for )?(?P<thing>(?:extra |x-)?(?:small|medium|large|baby|toddler|child|kid|adult|newborn)s?(?: \w+)?) only)[ \t]*(?P<end>:|[-–—](?=[ ]?[A-Z])|(?m:$))",
    re.IGNORECASE,
)
"""What is for some of the sizes from there on: up to the next such words, or the end of the line or of the lines that follow."""
_TOLD: Final = re.compile(
    r"(?:written|are|is) for (?:(?:the )?sizes? )?(?P<first>[^.;\n(]{1,30}?)(?: \([^)\n]{1,40}\))?[.;,] (?:with )?(?:changes|numbers|those|figures)? ?for (?:(?:the )?sizes? )?(?P<more>[^.\n]{1,80}?)(?: \([^)\n]{1,40}\))? (?:are |is |given )*in (?:parenthes[ei]s|brackets)",
    re.IGNORECASE,
)
_THUS: Final = re.compile(
    r"written (?:for|thus)[^.\n]{0,40}\(|changes[^.\n]{0,60} in (?:parenthes|brackets)", re.IGNORECASE
)
_AMONG: Final = re.compile(r"\s*(?:,|\band\b|&|(?<=[a-z])/(?=[A-Za-z]))\s*(?:and\s+)?")
_UNIT: Final = re.compile(r" (?:mos|yrs)$")  # "Sizes 6/12 and 18/24 mos only"
_NUMBER: Final = r"\d+(?:[.,]\d+)?(?:[ ]?[½¼¾⅓⅔⅛])?"
_USED: Final = re.compile(
    r"(?<![x×*\d.] )(?<![x×*\d.])(?:(?P<ch>\bch(?:ain)? )|\b(?:next|first|last|of|work) |[–—=[-] ?|[.\])] )(?P<a>\d+) ?\((?P<b>\d+(?:\s*[,;–-]\s*\d+)*)\)"
    r"(?(ch)(?=[ ]?[;,.\n])|[ ](?:more )?(?:times|sc|sts?|hdc|dc|tr|ch|stitches|rnds|rounds|rows)\b)",
    re.IGNORECASE,
)
"""Numbers of several sizes among stitches: "ch 35 (40)", "next 11 (5) sts", "] 5 (8) times", "– 54 (60) sc"; not "x 6 (18)"."""
_LETTERS: Final = {"extra small": "xs", "small": "s", "medium": "m", "large": "l", "extra large": "xl", "x-large": "xl"}
_USUAL: Final = (
    ("Small", "Large"),
    ("Child", "Adult"),
    ("Toddler", "Child"),
    ("Small", "Medium", "Large"),
    ("Small", "Medium", "Large", "Extra Large"),
)


@dataclass(frozen=True)
class Sizes:
    """The sizes that a text is for. names : as it says them; span : where; outside : the first number stands before the bracket."""

    names: tuple[str, ...]
    span: Span
    outside: bool

    def which(self, asked: str) -> int | None:
        """The place of a size that is asked for by its name, by its letter or by its number in the list; None for none."""
        want = _short(asked)
        for k, name in enumerate(self.names):
            if _UNIT.sub("", want) == _UNIT.sub("", _short(name)):
                return k
        firsts = [_LETTERS.get(n := (name.lower().split() or [""])[0], n) for name in self.names]
        first = want.split()[0] if want else ""
        if firsts.count(_LETTERS.get(first, first)) == 1:  # "Small Basket" of Small and Large
            return firsts.index(_LETTERS.get(first, first))
        return int(want) - 1 if want.isdigit() and 1 <= int(want) <= len(self.names) else None


def sizes(text: str) -> Sizes | None:
    """What sizes a text says that it is for: "Sizes: S (M, L)", "Size (S, M, L)"; None where it is for one."""
    for found in _NAMED.finditer(text):
        more = [name.strip() for name in _PART.split(found["more"]) if name.strip()]
        first = (found["first"] or "").strip()
        names = (first, *more) if first else tuple(more)
        span = Span(found.start("first") if first else found.start("more") - 1, found.end())
        made = Sizes(names, span, bool(first))
        if 2 <= len(names) <= 12 and all(map(_names_size, names)) and _lists(made).search(text, found.end()):
            return made
    return _unnamed(text)


def _unnamed(text: str) -> Sizes | None:
    """The sizes of a text that has numbers for several and no list of their names: by a sentence, else by what is for some of them only, else
    by their place."""
    lists = [m for m in _USED.finditer(text) if m["a"] != m["b"]]
    if not lists:
        return None
    told = _TOLD.search(text)
    if len(lists) < (1 if told or _THUS.search(text) else 3):
        return None
    lengths = Counter(len(re.findall(r"\d+", m["b"])) for m in lists)
    many, times = lengths.most_common(1)[0]
    if many > 11 or times < 0.8 * len(lists):
        return None
    if told:
        names = (
            told["first"].strip(),
            *(n for n in re.split(r"\s*,\s*(?:and )?|\s+and\s+|\s*&\s*", told["more"]) if n),
        )
        if len(names) == many + 1:
            return Sizes(names, Span(told.start(), told.end()), True)
    only = dict.fromkeys(
        name
        for m in _ONLY.finditer(text)
        for name in _AMONG.split(m["sizes"] or m["named"] or m["thing"] or "")
        if name
    )
    names = tuple(sorted(only, key=_order)) if len(only) == many + 1 else tuple(str(k + 1) for k in range(many + 1))
    usual = next(
        (u for u in _USUAL if len(u) == many + 1 and only and {_short(o) for o in only} <= set(map(_short, u))), names
    )
    names = names if len(only) == many + 1 else usual
    return Sizes(names, Span(lists[0].start("a"), lists[0].end()), True)


def sized(text: Text, known: Sizes, k: int) -> Text:
    """The text for size ``k``: of every list of as many numbers as there are sizes only that one stays, in its place."""

    def chosen(found: re.Match[str]) -> str:
        spans = [(m.start(), m.end()) for m in re.finditer(_NUMBER, found[0])]
        a, b = spans[k]
        return " " * a + found[0][a:b] + " " * (len(found[0]) - b)

    return Text(_lists(known).sub(chosen, _only(text.text, known, k)), text.name, text.photos)


def _only(words: str, known: Sizes, k: int) -> str:
    """``words`` without what is for other sizes only, every other word in its place: "Size L only: …", "Sizes M and L only: …"."""
    marks = list(_ONLY.finditer(words))
    meant = [{known.which(name) for name in _AMONG.split(m["sizes"] or m["named"] or m["thing"] or "")} for m in marks]
    for at, mark in enumerate(marks):
        if None in meant[at] and not mark["both"]:
            continue
        end = mark.end()
        if not mark["both"] and k not in meant[at]:
            line = words.find("\n", mark.end())
            line = line if line >= 0 else len(words)
            gap = re.compile(r"\n[ \t]*\n").search(words, mark.end())
            block = gap.start() if gap is not None else len(words)
            alone = not words[mark.end() : line].strip()
            then = marks[at + 1].start() if at + 1 < len(marks) else len(words)
            # Rounds on the lines below are for those sizes too where others, or all, are named behind them.
            follows = then < block and (marks[at + 1]["both"] or meant[at + 1] != meant[at])
            end = min(then, block if alone or follows else line)
        words = words[: mark.start()] + re.sub(r"[^\n]", " ", words[mark.start() : end]) + words[end:]
    return words


def _lists(known: Sizes) -> re.Pattern[str]:
    """What a list of as many numbers as there are sizes looks like."""
    many = len(known.names) - known.outside
    inner = rf"{_NUMBER}(?:\s*[,;–-]\s*{_NUMBER}){{{many - 1}}}"
    listed = rf"(?:\(\s*{inner}\s*\)|\[\s*{inner}\s*\])"
    return re.compile(rf"(?<![\d.]){_NUMBER}\s?{listed}" if known.outside else listed)


def _order(name: str) -> float:
    """Sizes in the order in which they are listed, the smallest first: months, then years, then words."""
    plain = _short(name)
    number = re.search(r"\d+", plain)
    if number is not None:
        return float(number[0]) * (1 if "mo" in plain else 12)
    words = (
        ("newborn", "infant", "baby"),
        ("toddler",),
        ("xs",),
        ("s", "child", "kid"),
        ("m", "youth", "teen"),
        ("l", "adult"),
        ("xl",),
    )
    return next((1000.0 + k for k, some in enumerate(words) if plain.startswith(some)), 2000.0)


def _names_size(name: str) -> bool:
    """Whether words name a size: a few letters, or a number with what it measures; no sentence and no length in other units."""
    plain = _short(name)
    return bool(
        re.fullmatch(
            r"(?:\d{0,2}x*[sml]|xx?[sl]|[a-z]+(?: [a-z0-9]+)?|\d+(?:/\d+)?(?: ?(?:in|inches|\"|”|months?|mos?|years?|yrs?))?)",
            plain,
        )
    )


def _short(name: str) -> str:
    plain = " ".join(name.lower().replace("'", "").split())
    plain = plain.replace("months", "mos").replace("years", "yrs")
    return _LETTERS.get(plain, plain)
