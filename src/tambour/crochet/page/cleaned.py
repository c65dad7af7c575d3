"""Cleaned: a designer's lines as sentences, without what lists, tables and Markdown put about them."""

from __future__ import annotations

import re
from html import unescape
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.page.ordered import paragraph, spans_marked

_HEAD: Final = re.compile(r"^[\s#*_=|+~]*(.*?)[\s*_=:|+~]*$")
BULLET: Final = re.compile(r"^[\s#>*•–~☐-]+(?=\S)")
_SIGNS: Final = "\\s~=_+|\u2500-\u27bf\ufe0f\U0001f300-\U0001faff"
ORNAMENT: Final = re.compile(rf"^[{_SIGNS}]+|[{_SIGNS}]+$")
"""What lines are decorated with: rules, hearts, boxes, flowers."""
FOOT: Final = re.compile(
    r"^(?!.*\b(?:see|refer|diagrams?|charts?)\b)(?!\W*(?:turn|go|as|cut|use|follow)\b).{0,70}(?:\bpage|\bseite|\bpágina|\bpagina|\bp\.)\s*\d+(?:\s*(?:of|/|von|de|sur|van)\s*\d+)?\W*$",
    re.IGNORECASE,
)
"""The foot of a page, amid the text."""
_STARRED: Final = re.compile(r"(?<!\w)\*(?=\S)([^*]+?)(?<=\S)\*(?!\w)")
"""What stands between asterisks is printed in italics elsewhere."""
_LINK: Final = re.compile(r"\[([^\]\n]+)\]\([^)\s]*\)")
_ESCAPED: Final = re.compile(r"\\([*_\[\]()#>-])")
AD: Final = re.compile(
    r"^\W*(?:advertisement|sponsored|ad|cookie settings|jump to (?:the )?(?:recipe|pattern)|print (?:the )?pattern"
    r"|(?:photo|image|picture|foto|imagen)\s*\d*:.*|home\b.{0,60}\b(?:contact|shop|about)(?: me| us)?|.*\baffiliate links?\b.*)\W*$",
    re.IGNORECASE,
)
"""A line of a page of the web that is nobody's sentence."""
_SENTENCE: Final = re.compile(r"(?<=[.!?])\s+(?=[A-ZÀ-Þ\"“(])")
_AGAIN: Final = re.compile(
    r"\b(?:from|between) \*+ (?:to|and) \*|\*[^*]+\*,? (?:rep(?:eat)?\b|[x×] ?\d|\d+ ?(?:times|x)\b)", re.IGNORECASE
)
"""A round whose asterisks say what is worked again."""
_FROM_SIGN: Final = re.compile(r"\s*\*(?=\w)")
LETTER: Final = re.compile(r"[^\W\d_]{2}")
_PATTERN: Final = re.compile(r"^[\[(](?:free |crochet |amigurumi )*pattern[\])]\s*(?=\S)", re.IGNORECASE)
"""What says that it is one, before a title."""
_APART: Final = re.compile(r"\S(?:\s+\S)+")
"""Letters by themselves."""
_ASIDE: Final = re.compile(r"\s*[(\[][^)\]]*[)\]]\W*$")
_HEADING: Final = 6
"""So many words, at the most, has a heading in capitals."""
NAMES: Final = 3
"""So few words without a point head what stands below them."""


def titled(words: str) -> str:
    """A title without its ornaments, and its letters together where they are set apart: "B E N   T H E   C A T".

    >>> titled("~ B E N   T H E   C A T ~"), titled("[Pattern] Momo")
    ('BEN THE CAT', 'Momo')
    """
    said = _PATTERN.sub("", ORNAMENT.sub("", words.strip()))
    groups = re.split(r"\s{2,}", said)
    if _APART.fullmatch(said) and len(groups) > 1:
        groups = [group.replace(" ", "") for group in groups]
    return " ".join(" ".join(groups).split())


def heads(words: str) -> bool:
    """Whether a sentence of hers is a heading: a few words in capitals, and what brackets say behind them.

    >>> heads("SPOUT (color C)"), heads("DO NOT STUFF."), heads("A LITTLE CAT")
    (True, False, True)
    """
    plain = _ASIDE.sub("", words).strip(" :")
    letters = plain.isupper() and len(plain) > 2 and plain[0].isalpha() and not any(c.isdigit() for c in plain)
    return letters and len(plain.split()) <= _HEADING and not plain.endswith((".", "!", "?"))


def plain_of(line: str) -> str:
    """A line as a heading has it: in small letters, without the signs about it."""
    found = _HEAD.match(line)
    return found[1].strip().lower() if found else ""


def cleaned(words: str, text: str = "") -> str:
    """A sentence without what lists and Markdown put about it, and with its point; of a ``text`` that marks what is worked again
    with two asterisks they stay."""
    marked = spans_marked(text or words) or _AGAIN.search(words) is not None
    if _FROM_SIGN.match(words) and words.count("*") == 1 and "from *" in paragraph(words, text):
        return f"*{cleaned(words.lstrip()[1:], text)}"  # "*Ch 3. … Rep from * around."
    if words.lstrip().startswith("|"):  # a row of a table
        words = " – ".join(cell.strip() for cell in words.strip().strip("|").split("|") if cell.strip())
    words = _ESCAPED.sub(r"\1", _LINK.sub(r"\1", unescape(words)))
    if marked:
        words = " ".join(re.sub(r"^[\s#>•–~☐-]+(?=\S)", "", words).split())
    else:
        words = _STARRED.sub(r"\1", " ".join(BULLET.sub("", words).replace("**", "").split()))
    words = ORNAMENT.sub("", words).rstrip(",;")
    return words if not words or words[-1] in ".!?:)" or words.isupper() or len(words.split()) < NAMES else f"{words}."


def sentences(text: str, a: int, b: int) -> list[tuple[str, Span]]:
    """The sentences of a line, with their places; headings and bare counts are none."""
    made = []
    at = a
    for piece in _SENTENCE.split(text[a:b]):
        begin = text.index(piece, at)
        at = begin + len(piece)
        words = cleaned(piece, text)
        if LETTER.search(words):
            made.append((words, Span(begin, at)))
    return made
