"""Problems with a place and a remedy: the only way that bad input is reported.

A :class:`Problem` names what is wrong, where, and what to do. A :class:`TambourError` carries all the problems of one
input; the command line prints them and leaves with exit code 2. Anything else that is raised is a fault of ours.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from typing import Any

_OPTION = re.compile(r"\{--([a-z][a-z0-9-]*)\}")
# What a terminal or a page might obey instead of showing: controls (a tab and a line's end may stay), turns of the
# writing direction, halves of characters.
_DANGEROUS = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u200e\u200f\u2028\u2029\u202a-\u202e\u2066-\u2069\ud800-\udfff]")


_CONTROLS = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f]")
LONGEST_TEXT = 10_000
"""Characters above which no parameter and no name is taken."""


def unspeakable(text: str) -> str:
    r"""Why a text from outside cannot be a parameter or a name; empty when it can.

    >>> unspeakable("a name"), unspeakable("a\x1b[31mname")
    ('', 'holds a control character')
    """
    try:
        text.encode()
    except UnicodeEncodeError:
        return "holds bytes that are no text"
    if _CONTROLS.search(text):
        return "holds a control character"
    return f"has more than {LONGEST_TEXT:,} characters" if len(text) > LONGEST_TEXT else ""


def shown(text: str) -> str:
    r"""A text from a file or a command line as it may stand in a terminal: a visible sign for each control character.

    >>> shown("a\x1b[31mname")
    'a␛[31mname'
    """

    def sign(found: re.Match[str]) -> str:
        code = ord(found[0])
        return chr(0x2400 + code) if code < 0x20 else "\u2421" if code == 0x7F else "\ufffd"

    return _DANGEROUS.sub(sign, text)


def option(name: str) -> str:
    """The command line's spelling of a parameter: ``max_float`` or ``max-float`` is ``--max-float``.

    >>> option("max_float")
    '--max-float'
    """
    return "--" + name.rstrip("_").replace("_", "-")


def spelt(text: str, spell: Callable[[str], str] = option) -> str:
    """A message with each parameter that it names, written ``{--max-float}``, in the caller's spelling.

    >>> spelt("give {--max-float}")
    'give --max-float'
    >>> spelt("give {--max-float}", lambda name: name.replace("-", " "))
    'give max float'
    """
    return _OPTION.sub(lambda found: spell(found[1]), text)


@dataclass(frozen=True, slots=True)
class Span:
    """Characters ``start`` (included) to ``end`` (excluded) of a text."""

    start: int
    end: int


@dataclass(frozen=True, slots=True)
class Text:
    """A text and the name it is known by (a path, ``<stdin>``): the source of every craft that reads language.

    photos : pictures that stood in it, each with its offset and the bytes of its file
    beside : pictures to stand beside it, each with the offset of its line and what draws it, as the bytes of a file
    told : what whoever reads it should know of how its file was read

    >>> Text("R1: MR(6)", "ball.acl").name
    'ball.acl'
    """

    text: str
    name: str = "<text>"
    photos: tuple[tuple[int, bytes], ...] = field(default=(), compare=False, repr=False)
    told: tuple[str, ...] = field(default=(), compare=False, repr=False)
    beside: tuple[tuple[int, Callable[[], bytes]], ...] = field(default=(), compare=False, repr=False)

    def place(self, offset: int) -> tuple[int, int]:
        r"""Line and column of a character offset, both counted from 1.

        >>> Text("R1: MR(6)\nR2: 6 inc").place(14)
        (2, 5)
        """
        offset = max(0, min(offset, len(self.text)))
        return self.text.count("\n", 0, offset) + 1, offset - self.text.rfind("\n", 0, offset)

    def line(self, offset: int) -> str:
        r"""The line in which a character stands, without its end.

        >>> Text("R1: MR(6)\nR2: 6 inc").line(14)
        'R2: 6 inc'
        """
        offset = max(0, min(offset, len(self.text)))
        end = self.text.find("\n", offset)
        return self.text[self.text.rfind("\n", 0, offset) + 1 : len(self.text) if end < 0 else end].rstrip("\r")


@dataclass(frozen=True, slots=True)
class Problem:
    r"""One thing that is wrong (or, as a ``warning``, doubtful) with an input.

    ``where`` names the file, option or field when there is no text to point into; ``hint`` is the remedy. Parameters
    stand in all three as ``{--max-float}``: who tells the problem spells them (:func:`spelt`).

    >>> print(Problem("there is no such file", "did you mean \"bear.txt\"?", where="baer.txt"))
    baer.txt: there is no such file
      did you mean "bear.txt"?
    """

    message: str
    hint: str = ""
    span: Span | None = None
    source: Text | None = None
    where: str = ""
    warning: bool = False

    def plain(self) -> dict[str, Any]:
        """The problem as data: message, hint, line and column (from 1) and length (None without a place in a text),
        where (a file, an option), warning.

        >>> told = Problem("the round makes 11", span=Span(4, 9), source=Text("R2: 6 inc (11)")).plain()
        >>> told["line"], told["column"], told["length"]
        (1, 5, 5)
        """
        at: tuple[int | None, int | None, int | None] = (None, None, None)
        if self.span is not None and self.source is not None:
            at = (*self.source.place(self.span.start), max(1, self.span.end - self.span.start))
        where = self.where or (self.source.name if self.source else "")
        told = {"message": self.message, "hint": self.hint, "line": at[0], "column": at[1], "length": at[2]}
        return {**told, "where": where, "warning": self.warning}

    def __str__(self) -> str:
        """``file:line:col: message``, the line, a caret, the remedy; options as the command line spells them."""
        kind = "warning: " if self.warning else ""
        lines: list[str] = []
        if self.span is not None and self.source is not None:
            row, column = self.source.place(self.span.start)
            line = self.source.line(self.span.start)
            lines.append(f"{self.source.name}:{row}:{column}: {kind}{self.message}")
            if line.strip():
                # A very long line is shown by the part around its mistake.
                left = max(0, column - 61)
                part = line[left : left + 120].expandtabs(1)
                width = max(1, min(self.span.end - self.span.start, len(part) - (column - 1 - left)))
                lines.append(f"    {part}")
                lines.append("    " + " " * (column - 1 - left) + "^" * width)
        else:
            name = self.where or (self.source.name if self.source else "")
            lines.append(f"{name}: {kind}{self.message}" if name else f"{kind}{self.message}")
        if self.hint:
            lines.append(f"  {self.hint}")
        return shown(spelt("\n".join(lines)))


class TambourError(Exception):
    """Input that cannot be used, with every problem found in it.

    Raised as ``TambourError("message", hint="…", where="--width")`` for one problem, or with a list of
    :class:`Problem`.

    >>> try:
    ...     raise TambourError("too narrow", hint="at least {--width} 5mm", where="logo.svg")
    ... except TambourError as error:
    ...     print(error)
    logo.svg: too narrow
      at least --width 5mm
    """

    seen: tuple[str, Callable[[], Any]] | None = None
    """Where a picture shows it best: what that is called, and what draws it."""

    def __init__(
        self,
        problems: str | Problem | Iterable[Problem],
        *,
        hint: str = "",
        where: str = "",
        span: Span | None = None,
        source: Text | None = None,
    ) -> None:
        if isinstance(problems, str):
            problems = Problem(problems, hint=hint, where=where, span=span, source=source)
        self.problems: tuple[Problem, ...] = (problems,) if isinstance(problems, Problem) else tuple(problems)
        super().__init__("\n".join(map(str, self.problems)))


class LawError(ValueError):
    """A value was built from arrays that break its laws: a fault of the caller's code, not of a user's file."""


_NEAR = 0.65  # how alike a word is to the one that may be meant, at least


def did_you_mean(word: str, known: Iterable[str]) -> str:
    """The hint ``did you mean "x" or "y"?`` for a misspelt word, or an empty string when nothing is near.

    >>> did_you_mean("crotchet", ["crochet", "knit"])
    'did you mean "crochet"?'
    """
    import difflib

    n = len(word)
    long = {k: 2 * min(n, k) >= _NEAR * (n + k) for k in range(4 * n + 4)}  # no other can be near
    alike = [k for k in known if long.get(len(k)) and 2 * sum(map(k.__contains__, word)) >= _NEAR * (n + len(k))]
    near = difflib.get_close_matches(word, alike, n=2, cutoff=_NEAR)
    return "did you mean " + " or ".join(f'"{w}"' for w in near) + "?" if near else ""
