"""Printed patterns, sizes: a text for several ("S (M, L)", "12 (14, 16) sc") as it reads for one of them, every word in its place."""

from __future__ import annotations

import re
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
    r"\b(?:(?P<both>(?:all|both) (?:sizes|versions))|(?:for )?(?:sizes?|versions?) (?P<sizes>[^:.\n]{1,60}?),? only|(?P<named>[A-Z][^:.\n]{0,40}?) (?:size|version)s? only)\s*:",
    re.IGNORECASE,
)
"""What is for some of the sizes from there on, up to the next such words or the end of the line."""
_UNIT: Final = re.compile(r" (?:mos|yrs)$")  # "Sizes 6/12 and 18/24 mos only"
_NUMBER: Final = r"\d+(?:[.,]\d+)?(?:[ ]?[½¼¾⅓⅔⅛])?"
_LETTERS: Final = {"extra small": "xs", "small": "s", "medium": "m", "large": "l", "extra large": "xl", "x-large": "xl"}


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
    return None


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
    for at, mark in enumerate(marks):
        meant = {known.which(name) for name in re.split(r"\s*(?:,|\band\b|&)\s*", mark["sizes"] or mark["named"] or "")}
        end = mark.end()
        if not mark["both"] and None not in meant and k not in meant:
            stop = words.find("\n", mark.end())
            end = min(stop if stop >= 0 else len(words), marks[at + 1].start() if at + 1 < len(marks) else len(words))
        if mark["both"] or None not in meant:
            words = words[: mark.start()] + re.sub(r"[^\n]", " ", words[mark.start() : end]) + words[end:]
    return words


def _lists(known: Sizes) -> re.Pattern[str]:
    """What a list of as many numbers as there are sizes looks like."""
    many = len(known.names) - known.outside
    inner = rf"{_NUMBER}(?:\s*[,;–-]\s*{_NUMBER}){{{many - 1}}}"
    listed = rf"(?:\(\s*{inner}\s*\)|\[\s*{inner}\s*\])"
    return re.compile(rf"(?<![\d.]){_NUMBER}\s?{listed}" if known.outside else listed)


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
