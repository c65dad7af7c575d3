"""Reading: whether a text is in tambour's own language or printed as people write patterns, and its pattern either way."""

from __future__ import annotations

import re
from typing import Final

from tambour.core.errors import TambourError, Text
from tambour.crochet.parse import parse
from tambour.crochet.printed import NOT_UNDERSTOOD, read_printed
from tambour.crochet.restated import restated
from tambour.crochet.syntax import Pattern

# What only tambour's own language says, at the beginning of a line.
_OWN: Final = re.compile(
    r"^[ \t]*(?::|\d+[ \t]*:[^\n]*\bMR\(|define[ \t]+\w+[^\n]{0,40}=|@(?!terms\b)\w+[ \t]*=|(?:mark|goto|attach|sew|color|place|eye"
    r"|embroider|felt|hair)[ \t]*\(|[A-Za-z_]\w*[ \t]*\{[ \t]*$)",
    re.MULTILINE,
)
_FEW: Final = 3
_MORE: Final = 40
_HEADING: Final = re.compile(r"^[ \t]*##", re.MULTILINE)


def read(text: Text, *, max_stitches: int = 200_000, strict: bool = False) -> Pattern:
    """The pattern that ``text`` says, in tambour's own language (parse) or printed (read_printed).

    An ``.acl`` file is always in the language; so is a text with lines that only the language has, and one whose rounds
    all parse.

    Raises TambourError with every problem of the text, or with one line when it holds no instructions.
    """
    known = restated(text, max_stitches=max_stitches)
    if known is not None:
        return known
    if text.name.lower().endswith(".acl") or _OWN.search(text.text) or not _worded(text.text):
        return parse(text, max_stitches=max_stitches, strict=strict)
    if not _HEADING.search(text.text):
        try:
            # A text that is no language of ours soon shows it.
            for lines in (_FEW, _MORE):
                sample = "\n".join(text.text[: lines * 200].split("\n")[:lines])
                if len(sample) < len(text.text):
                    parse(Text(sample, text.name))
            return parse(text, max_stitches=max_stitches, strict=strict)
        except TambourError:
            pass  # as print it may be read
    return read_printed(text, max_stitches=max_stitches, strict=strict)


def _worded(text: str) -> bool:
    """Whether a text says anything that is no comment."""
    return any(
        (line.strip() and not line.lstrip().startswith("#")) or line.lstrip().startswith("##")
        for line in text.split("\n")
    )


def account(pattern: Pattern) -> dict[str, object]:
    """What the report says of a printed pattern: its terms, the lines passed over, and those that were not understood."""
    if not pattern.terms:
        return {}
    text = pattern.text
    doubts = [p for p in pattern.warnings if p.message == NOT_UNDERSTOOD and p.span is not None]
    return {
        "terms": pattern.terms,
        "passed_over": len({text.place(span.start)[0] for span in pattern.passed}),
        "not_understood": [
            {"line": text.place(p.span.start)[0], "text": text.text[p.span.start : p.span.end]}
            for p in doubts
            if p.span
        ],
        "stated": {key: words for key, (words, _) in pattern.stated.items()},
    }
