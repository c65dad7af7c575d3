"""Printed patterns, pages: what stands around a pattern on a page of the web or of a magazine, and is none: comments below it, links to others, running heads."""

from __future__ import annotations

import re
from collections import Counter
from dataclasses import replace
from typing import Final

from tambour.crochet.printed.heads import heads
from tambour.crochet.printed.tokens import Row
from tambour.crochet.printed.wordings.vocabulary import Vocabulary

_BELOW: Final = re.compile(
    r"(?:\d+\s+)?(?:comments?|responses?|replies|reviews)(?:\s*\(\d+\))?:?|leave a (?:reply|comment)\b.*|reader interactions|\d+ thoughts? on\b.*"
    r"|you (?:may|might)(?: also)? (?:like|enjoy|love)\b.*|(?:related|more|similar|other) (?:posts|patterns|articles|stories)\b.*|(?:primary|footer) sidebar"
    r"|.*\b\d+ comments?\s+\d+ shares?|like\s+comment\s+share|view (?:all )?\d+ (?:more )?comments?|next (?:month|issue|week)\b.*"
    r"|(?:kommentare|kommentar schreiben|commentaires|laisser un commentaire|comentarios|reacties|geef een reactie)\b.*",
    re.IGNORECASE,
)
"""A line below which nothing is the pattern's."""
_LINK: Final = re.compile(
    r"(?:related|see also|read (?:more|next|also)|also read|more from|pin (?:it|this|for later)|jump to|skip to|continue reading|advertisement|sponsored|shop now|"
    r"subscribe|sign up|follow (?:me|us)|share (?:this|on)|tweet|save this|print (?:this|page)|posted (?:on|in|by)|filed under|tagged|categories|tags)\b",
    re.IGNORECASE,
)
_TITLE: Final = re.compile(r"[^\W\d_]{2,}(?:[^\w\d]+[^\W\d_]+)+(?:\s+\d{1,3})?")
_REPEATED: Final = 3  # so often a running head stands in a text
_WORDS: Final = 12


def pages(text: str, rows: list[Row], vocabulary: Vocabulary) -> list[Row]:
    """``rows`` without the words of such lines."""
    said = [" ".join(text[row.start : row.end].split()) if row.tokens else "" for row in rows]
    often = Counter(said)
    ends = {k for k, line in enumerate(said) if line and _BELOW.fullmatch(line)}
    some = {k for k, line in enumerate(said) if line and (_LINK.match(line) or often[line] >= _REPEATED)}
    if not ends and not some:
        return rows
    heard = set()
    for k, row in enumerate(rows):
        read = vocabulary.read(row.tokens) if row.tokens and (ends or k in some) else []
        if read and heads(read) and any(t.kind == "stitch" or t.value in ("round", "row") for t in read):
            heard.add(k)
    last = max(heard, default=len(rows))
    below = min((k for k in ends if k > last), default=len(rows))
    made = []
    for k, row in enumerate(rows):
        none = k >= below
        if k in some and k not in heard and not none and not row.marked:
            link = _LINK.match(said[k]) is not None and len(row.tokens) <= _WORDS and not said[k].endswith(".")
            running = often[said[k]] >= _REPEATED and _TITLE.fullmatch(said[k]) is not None and _page(said, k)
            none = (link or running) and not any(t.kind == "stitch" for t in vocabulary.read(row.tokens))
        made.append(replace(row, tokens=[]) if none else row)
    return made


def _page(said: list[str], at: int) -> bool:
    """Whether the number of a page stands beside a line."""
    return any(line.strip("-– |").isdigit() for line in said[max(0, at - 1) : at + 2]) or said[at].split()[-1].isdigit()
