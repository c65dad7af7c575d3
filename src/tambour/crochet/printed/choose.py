"""Reading: whether a text is in tambour's own language or printed as people write patterns, and its pattern either way."""

from __future__ import annotations

import gc
import re
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from typing import TYPE_CHECKING, Final

from tambour.core.errors import Problem, Span, TambourError, Text
from tambour.crochet.language.parse import parse
from tambour.crochet.language.tree import Line, Pattern
from tambour.crochet.printed.restated import restated
from tambour.crochet.printed.sheet.pasted import ours

if TYPE_CHECKING:
    from tambour.crochet.printed.state import Height

# What only tambour's own language says, at the beginning of a line; and what it says besides.
_OWN: Final = re.compile(
    r"[ \t]*(?::|\d+[ \t]*:.*\bMR\(|define[ \t]+\w+.{0,40}=|@(?!terms\b)\w+[ \t]*=|(?:mark|goto|attach|sew|color|place|tie|eye"
    r"|embroider|felt|hair)[ \t]*\(|[A-Za-z_]\w*[ \t]*\{[ \t]*$)"
)
_ALSO: Final = re.compile(
    r"[ \t]*(?:==.*|FO|fo|MR\(\d.*|ch\(?[ \t]*\d.*|R[ \t]*\d[^:]{0,8}:.*|\d+([ \t]*-[ \t]*\d+)?:.*|[}@].*|turn|oval\(.*)[ \t]*$"
)
_LOOKED_AT: Final = 60  # lines with words
_MOST: Final = 100_000  # characters that are looked at
_FEW: Final = 3
_MORE: Final = 40
_HEADING: Final = re.compile(r"^[ \t]*##", re.MULTILINE)


def read(
    text: Text,
    *,
    max_stitches: int = 200_000,
    strict: bool = False,
    high: Height | None = None,
    size: str | None = None,
) -> Pattern:
    """The pattern that ``text`` says, in tambour's own language (parse) or printed (read_printed).

    An ``.acl`` file is always in the language; so is a text with lines that only the language has, when it is not mostly
    something else, and one that parses whole.

    high : what a printed pattern states → the height of a round, mm; size : which of its sizes is read (else the first)

    Raises TambourError with every problem of the text, or with one line when it holds no instructions.
    """
    with _uncollected():
        return _read(text, max_stitches, strict, high, size)


@contextmanager
def _uncollected() -> Iterator[None]:
    """Python's search for values that hold each other rests meanwhile, where it runs: reading makes many small values, few
    of which do, and it would go through all of them again and again."""
    collects = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if collects:
            gc.enable()


def _read(text: Text, max_stitches: int, strict: bool, high: Height | None, size: str | None) -> Pattern:
    if (said := ours(text.text)) != text.text:
        text = replace(text, text=said)
    known = restated(text, max_stitches=max_stitches, strict=strict)
    if known is not None:
        return known
    lines = _lines(text.text)
    if text.name.lower().endswith(".acl") or not lines or _own(lines):
        return parse(text, max_stitches=max_stitches, strict=strict)
    if not _HEADING.search(text.text):
        try:
            # A text that is no language of ours soon shows it.
            for many in (_FEW, _MORE):
                sample = "\n".join(text.text[: many * 200].split("\n")[:many])
                if len(sample) < len(text.text):
                    parse(Text(sample, text.name))
            return parse(text, max_stitches=max_stitches, strict=strict)
        except TambourError:
            pass  # as print it may be read
    return _printed(text, max_stitches, strict, high, size)


def _printed(text: Text, max_stitches: int, strict: bool, high: Height | None, size: str | None) -> Pattern:
    """A printed pattern, in the size that is asked for."""
    from tambour.crochet.printed.pattern import read_printed
    from tambour.crochet.printed.sheet.sizes import sized, sizes
    from tambour.crochet.printed.state import plain_height

    known = sizes(text.text)
    if known is None:
        made = read_printed(text, max_stitches=max_stitches, strict=strict, high=high or plain_height)
        doubt = Problem(
            f'no sizes are named, so "{size}" has no effect', "leave {--size} out", None, text, warning=True
        )
        return made if size is None else replace(made, warnings=(doubt, *made.warnings))
    k = 0 if size is None else known.which(size)
    if k is None:
        raise TambourError(f'there is no size "{size}"', hint=f"one of {', '.join(known.names)}", where="{--size}")
    made = read_printed(sized(text, known, k), max_stitches=max_stitches, strict=strict, high=high or plain_height)
    said = f"this is written for the sizes {', '.join(known.names)}: {known.names[k]} is made"
    doubt = Problem(said, f"another: {{--size}} {known.names[-1]}", known.span, text, warning=True)
    return replace(made, whole=text, warnings=made.warnings if size is not None else (doubt, *made.warnings))


def _lines(text: str) -> list[str]:
    """The first lines of a text that are neither empty nor comments."""
    found: list[str] = []
    for line in text[:_MOST].split("\n"):
        plain = line.strip()
        if plain and (not plain.startswith("#") or plain.startswith("##")):
            found.append(line[:500])
            if len(found) == _LOOKED_AT:
                break
    return found


def _own(lines: list[str]) -> bool:
    """Whether lines are those of tambour's own language: one that only it has, and of the others not too few."""
    only = sum(_OWN.match(line) is not None for line in lines)
    also = sum(_OWN.match(line) is None and _ALSO.match(line) is not None for line in lines)
    return only > 0 and 3 * (only + also) >= len(lines)


def account(pattern: Pattern) -> dict[str, object]:
    """What the report says of a printed pattern: its terms, how many rounds were read and how many taken from their
    counts, the lines passed over, and what was not understood."""
    if not pattern.terms:
        return {}
    text = pattern.text
    rounds = [line for part in pattern.parts for line in part.lines if line.in_round]
    gaps = [line for line in rounds if line.gap]
    taken, whole = sum(line.times for line in gaps), sum(line.times for line in rounds) + len(pattern.left_out)
    return {
        "terms": pattern.terms,
        **({"reading": _summary(pattern, whole, gaps)} if gaps or pattern.left_out else {}),
        "rounds_read": whole - taken - len(pattern.left_out),
        "rounds_taken": taken,
        "passed_over": len({text.place(span.start)[0] for span in pattern.passed}),
        "not_understood": [
            {"line": text.place(p.span.start)[0], "text": text.text[p.span.start : p.span.end], "why": p.message}
            for p in pattern.unread
            if p.span
        ],
        "stated": {key: words for key, (words, _) in pattern.stated.items()},
    }


def _summary(pattern: Pattern, whole: int, gaps: list[Line]) -> str:
    """``41 of 43 rounds read; 2 taken from their counts (lines 31, 57)``."""

    def lines(spans: Iterable[Span]) -> str:
        numbers = list(dict.fromkeys(pattern.text.place(span.start)[0] for span in spans))
        return f"line{'s' if len(numbers) > 1 else ''} {', '.join(map(str, numbers))}"

    taken, out = sum(line.times for line in gaps), len(pattern.left_out)
    said = f"{whole - taken - out} of {whole} rounds read"
    said += f"; {taken} taken from their counts ({lines(line.span for line in gaps)})" if gaps else ""
    return said + (f"; {out} left out ({lines(pattern.left_out)})" if out else "")
