"""Problems with a place and a remedy: the only way that bad input is reported.

A :class:`Problem` names what is wrong, where, and what to do. A :class:`TambourError` carries all the problems of one
input; the command line prints them and leaves with exit code 2. Anything else that is raised is a fault of ours.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Span:
    """Characters ``start`` (included) to ``end`` (excluded) of a text."""

    start: int
    end: int


@dataclass(frozen=True, slots=True)
class Text:
    """A text and the name it is known by (a path, ``<stdin>``): the source of every craft that reads language."""

    text: str
    name: str = "<text>"

    def place(self, offset: int) -> tuple[int, int]:
        """Line and column of a character offset, both counted from 1."""
        before = self.text[: max(0, min(offset, len(self.text)))]
        return before.count("\n") + 1, len(before) - (before.rfind("\n") + 1) + 1

    def line(self, number: int) -> str:
        """The text of line ``number`` (from 1), without its end."""
        lines = self.text.split("\n")
        return lines[number - 1].rstrip("\r") if 0 < number <= len(lines) else ""


@dataclass(frozen=True, slots=True)
class Problem:
    """One thing that is wrong (or, as a ``warning``, doubtful) with an input.

    ``where`` names the file, option or field when there is no text to point into; ``hint`` is the remedy.
    """

    message: str
    hint: str = ""
    span: Span | None = None
    source: Text | None = None
    where: str = ""
    warning: bool = False

    def __str__(self) -> str:
        """``file:line:col: message``, the line, a caret, the remedy."""
        kind = "warning: " if self.warning else ""
        lines: list[str] = []
        if self.span is not None and self.source is not None:
            row, column = self.source.place(self.span.start)
            line = self.source.line(row)
            lines.append(f"{self.source.name}:{row}:{column}: {kind}{self.message}")
            if line.strip():
                # A very long line is shown by the part around its mistake.
                left = max(0, column - 61)
                shown = line[left : left + 120].expandtabs(1)
                width = max(1, min(self.span.end - self.span.start, len(shown) - (column - 1 - left)))
                lines.append(f"    {shown}")
                lines.append("    " + " " * (column - 1 - left) + "^" * width)
        else:
            name = self.where or (self.source.name if self.source else "")
            lines.append(f"{name}: {kind}{self.message}" if name else f"{kind}{self.message}")
        if self.hint:
            lines.append(f"  {self.hint}")
        return "\n".join(lines)


class TambourError(Exception):
    """Input that cannot be used, with every problem found in it.

    Raised as ``TambourError("message", hint="…", where="--width")`` for one problem, or with a list of
    :class:`Problem`.
    """

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


def did_you_mean(word: str, known: Iterable[str]) -> str:
    """The hint ``did you mean "x" or "y"?`` for a misspelt word, or an empty string when nothing is near."""
    import difflib

    near = difflib.get_close_matches(word, list(known), n=2, cutoff=0.65)
    return "did you mean " + " or ".join(f'"{w}"' for w in near) + "?" if near else ""
