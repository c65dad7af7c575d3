"""Plain: a written pattern without the marks of Markdown, and what is put into a piece while hands still reach inside."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Final

from tambour.crochet.graph.built import Built
from tambour.crochet.language.finishes import Eye
from tambour.crochet.page.placed import Spoken
from tambour.crochet.page.wording import Row, Words

if TYPE_CHECKING:
    from tambour.crochet.words.table import Terms


_BOLD: Final = re.compile(r"(?<!\*)\*\*(?=[^\s*])(.+?)(?<=[^\s*])\*\*(?!\*)")
"""Not "from ** to **", which is no Markdown."""


def unmarked(text: str) -> str:
    r"""Markdown as plain text: headings underlined, no asterisks, no blanks at the ends of lines.

    >>> print(unmarked("# Bear  \n**Gauge:** 20 sc"), end="")
    Bear
    ====
    Gauge: 20 sc
    """
    made = []
    for line in text.rstrip("\n").split("\n"):
        level = len(line) - len(line.lstrip("#"))
        words = _BOLD.sub(r"\1", line.rstrip()).lstrip("#").lstrip() if level else line.rstrip()
        words = re.sub(r"^\*(\S.*\S)\*$", r"\1", _BOLD.sub(r"\1", words))
        made += [words, ("=" if level == 1 else "-") * len(words)] if level else [words]
    return "\n".join(made) + "\n"


def as_she_writes(terms: Terms, text: str) -> Terms:
    """English words spelled as the designer spells, and with her own word for a decrease, that a booklet does not mix two; every other
    language as it is."""
    return _as_she_decreases(_as_she_spells(terms, text), text)


def _as_she_decreases(terms: Terms, text: str) -> Terms:
    """English words with her own for a decrease: where she works "sc2tog" and nowhere "dec", a booklet does not mix the two."""
    hers = "dc2tog" if terms.code == "uk" else "sc2tog"
    words = terms.stitches.get("dec", ())
    low = text.lower()
    if hers not in words or low.count(hers) <= len(re.findall(r"\bdec\b", low)):
        return terms
    return replace(terms, stitches=dict(terms.stitches) | {"dec": (hers, *(w for w in words if w != hers))})


_BRITISH: Final = {"gray": "grey", "color": "colour", "center": "centre", "fiber": "fibre"}


def _as_she_spells(terms: Terms, text: str) -> Terms:
    """English words as the designer spells: British ones where ``text`` has some and no American ones (US stitches are often
    written so), else each of them that it has, that a booklet does not mix the two; every other language as it is."""
    if terms.base not in ("", terms.code) or terms.colors["blue"][0] != "blue":
        return terms
    low = text.lower()
    british = {a: b for a, b in _BRITISH.items() if b in low and a not in low}
    if not british:
        return terms
    british = _BRITISH if all(a not in low for a in _BRITISH) else british

    def said(words: str) -> str:
        return re.sub("|".join(british), lambda found: british[found[0]], words)

    return replace(
        terms,
        page={key: said(words) for key, words in terms.page.items()},
        colors={css: tuple(dict.fromkeys((said(words[0]), *words))) for css, words in terms.colors.items()},
    )


def reach(rounds: Sequence[tuple[int, bool]]) -> int:
    """After which of the rounds (count, whether it is one) hands still reach inside: the last with half of the most stitches."""
    most = max((count for count, _ in rounds), default=0)
    return max((k for k, (count, makes) in enumerate(rounds) if makes and most and 2 * count >= most), default=-1)


def fills(built: Built, part: int) -> bool:
    """Whether a part is stuffed though its pattern says nothing of it: its rounds end narrower than they were.

    What people write is printed as they say it.
    """
    mine = [r for r in built.rounds if r.part == part and not r.aside]
    counts, ends = [r.count for r in mine], [n for r in mine for n in (r.first, r.last)]
    if built.pattern.terms or len(counts) < 3 or counts[-1] == max(counts):
        return False
    return built.graph.parts[part].stuffing > 0.0 and not bool((built.graph.direction[ends] < 0).any())


def eyes_now(page: Mapping[str, str], said: Sequence[str]) -> str:
    """What is said of eyes between the rounds: when, and where; ``page`` : the booklet's words."""
    first, *others = said
    return " ".join([f"{page['eyes now']}: {first[:1].lower()}{first[1:]}", *others])


def with_eyes(made: Words, built: Built) -> Words:
    """The words with the eyes where they are put in, and no more at the end."""
    spoken, finish = Spoken(built, made.terms), built.pattern.finish
    parts, done = [], list[str]()
    for part in made.parts:
        name = built.pattern.parts[part.section].name
        eyes = [r for r in finish if isinstance(r, Eye) and r.spot.part in (name, f"{name}.1")]
        last = max((row.number for row in part.lines), default=0)
        eyes = [r for r in eyes if r.spot.round <= last + 1]  # legs are written before the body that goes on from them
        if not eyes:
            parts.append(part)
            continue
        level = max(r.spot.round for r in eyes)
        rows = list(part.lines)
        inside = reach([(row.count, bool(row.label)) for row in rows])
        worked = max((k for k, row in enumerate(rows) if row.label and row.number >= level), default=inside)
        first = next((k for k, row in enumerate(rows) if row.label and row.number >= level), worked)
        at = min(max(first, 0), inside) if inside >= 0 else len(rows) - 1
        said = spoken(eyes)
        done += said
        parts.append(replace(part, lines=(*rows[: at + 1], Row("", eyes_now(made.terms.page, said)), *rows[at + 1 :])))
    return replace(made, parts=tuple(parts), finish=tuple(s for s in made.finish if s not in done))
