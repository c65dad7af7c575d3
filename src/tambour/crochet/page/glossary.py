"""Glossary: the abbreviations of a booklet: her list as she has it, then what else stands in its lines, as ours."""

from __future__ import annotations

import re
from typing import Final

from tambour.crochet.page.among import with_hers
from tambour.crochet.page.book import OURS, Book

_USUAL: Final = {
    "FO": "fasten off",
    "sl st": "slip stitch",
    "Sl st": "slip stitch",
    "sts": "stitches",
    "st": "stitch",
    "Rnd": "round",
    "rnd": "round",
    "R": "round",
    "inv dec": "invisible decrease: through the front loops of two stitches together",
    "RS": "right side",
    "WS": "wrong side",
    "tog": "together",
    "w/": "with",
    "join": "slip stitch in the first stitch of the round",
}
"""What designers write in English sentences without explaining it."""

_INVISIBLE: Final = re.compile(r"\binv(?:isible|is|\.)?[ -]?dec(?:rease)?", re.IGNORECASE)
_JOINS: Final = re.compile(
    r"(?<!not )(?<!n't )(?<!n’t )\bjoin\b(?=\s*(?:[.,;)(]|$)|\s+with (?:a )?(?:sl|slip) )", re.IGNORECASE
)
"""How a line says that its round is joined, and no part to another."""
_POINTS: Final = re.compile(r"\s*(?:;|\||\s/(?=\s))\s*|,\s+(?=[\w()./]{1,10}\s*(?:=|\s[-–—]\s))")
"""What stands between the abbreviations of one line."""
_MEANS: Final = re.compile(
    r"(?P<said>[^\s=:–—](?:[^=:–—]{0,14}?[^\s=:–—])?)\s*(?:[=:]|\s[-–—](?=\s))\s*(?P<meaning>\S.*)"
)
"""An abbreviation and its meaning, also of signs: "( ) x 6 = work what is between the brackets 6 times"."""


def glossary(book: Book) -> list[tuple[str, str]]:
    """Abbreviations with their meanings: of a designer's text her own, word for word ("" for a line that is no pair), and then those
    that stand in the booklet and that she does not explain, as ours; what of ours means the same stands together."""
    made: dict[str, list[str]] = {}
    hers = pairs(book.hers.listed) if book.hers is not None else []
    known = {said for one, meaning in hers for said in explained(one or meaning)}
    printed = _printed(book)
    invisible = _INVISIBLE.search(book.piece.built.pattern.text.text) is not None and book.code in ("us", "uk")
    usual = _USUAL if book.hers is not None and book.code in ("us", "uk") else {}
    for said, meaning in (*book.said.abbreviations, *usual.items()):
        if book.hers is not None and (said.lower() in known or not _stands(said, printed)):
            continue
        if invisible and said.lower() in ("dec", "inv dec", "invdec"):
            meaning = book.own["invisible decrease"]
        elif said == book.said.terms.word("dec"):
            meaning = book.own["least"].format(meaning=meaning)
        plain = next((one for one in made if one.lower() == meaning.lower()), meaning)
        own = made.setdefault(plain, [])
        own += [said] if said.lower() not in (other.lower() for other in own) else []
    mark = OURS if book.hers is not None else ""
    return [*hers, *((mark + ", ".join(said), meaning) for meaning, said in made.items())]


def pairs(lines: list[str]) -> list[tuple[str, str]]:
    """Lines of a list of abbreviations as pairs, each whole line with "" before it that is none.

    >>> pairs(["ch - chain; ss - slip stitch", "( ) x 6 = work it 6 times", "MR magic ring"])
    [('ch', 'chain'), ('ss', 'slip stitch'), ('( ) x 6', 'work it 6 times'), ('', 'MR magic ring')]
    """
    made: list[tuple[str, str]] = []
    for line in lines:
        found = [_MEANS.fullmatch(one.strip()) for one in _POINTS.split(line) if one.strip()]
        if not found or any(one is None for one in found):
            made.append(("", line))
        else:
            made += [(one["said"], one["meaning"]) for one in found if one is not None]
    return made


def explained(line: str) -> set[str]:
    """The abbreviations that a line of hers explains: "Rnd(s) = Round(s)", "Sc2(3)tog = …", "inc (increase) = …", "MR magic ring / ch chain"."""
    heads = [re.split(r"\s*[=:–—]|\s-\s", one, maxsplit=1)[0].lower().strip() for one in _POINTS.split(line)]
    heads += [word for head in heads for word in (head.split(" ")[0], " ".join(head.split(" ")[:2]))]
    made = set[str]()
    for head in heads:
        many = re.sub(r"(\w)\((\w{1,3})\)", r"\1\2", head)  # "rnds", "sc23tog"
        other = re.sub(r"\d\((\d)\)", r"\1", head)  # "sc3tog"
        alone = re.sub(r"\s*\([^)]*\)", "", head)
        made |= {word.strip() for said in (head, many, other, alone) for word in re.split(r",|\bor\b|/", said)}
    return made - {""}


def _printed(book: Book) -> str:
    """All that stands among the rounds and behind them."""
    rows = [row for block in book.said.blocks for row in with_hers(book, block)]
    hers = [*book.hers.sentences, *book.hers.intro] if book.hers is not None else []
    return "\n".join([*(f"{row.label} {row.words}" for row in rows), *hers])


def _stands(said: str, printed: str) -> bool:
    """Whether an abbreviation stands in the booklet's lines."""
    if said == "join":
        return _JOINS.search(printed) is not None
    first = f"[{re.escape(said[0].lower())}{re.escape(said[0].upper())}]{re.escape(said[1:])}"
    return re.search(rf"(?<![^\W\d_])(?<![^\W\d_]\d){first}(?!\w)", printed) is not None
