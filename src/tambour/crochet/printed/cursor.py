"""Printed patterns, the cursor: a place in a list of tokens, and the fault that points at one."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.printed.tokens import Token

OPEN: Final = {"(": ")", "[": "]", "{": "}", "<": ">"}


class NotUnderstood(Exception):
    """A token that does not fit, and what would."""

    def __init__(self, token: Token, message: str, hint: str = "") -> None:
        super().__init__(message)
        self.token, self.message, self.hint = token, message, hint


@dataclass
class Cursor:
    """A place in a list of tokens."""

    tokens: list[Token]
    at: int = 0

    def look(self, ahead: int = 0) -> Token | None:
        """The token so far ahead, None at the end."""
        at = self.at + ahead
        return self.tokens[at] if 0 <= at < len(self.tokens) else None

    def key(self, *names: str, ahead: int = 0) -> bool:
        """Whether the token there is one of these concepts."""
        at, tokens = self.at + ahead, self.tokens  # as look, which a call would cost
        return 0 <= at < len(tokens) and tokens[at].kind == "key" and tokens[at].value in names

    def mark(self, *words: str, ahead: int = 0) -> bool:
        """Whether the token there is one of these marks."""
        at, tokens = self.at + ahead, self.tokens  # as look, which a call would cost
        return 0 <= at < len(tokens) and tokens[at].kind == "mark" and tokens[at].word in words

    def kind(self, kind: str, ahead: int = 0) -> bool:
        """Whether the token there is of this kind."""
        token = self.look(ahead)
        return token is not None and token.kind == kind

    def take(self) -> Token:
        """The token here; the cursor goes on."""
        token = self.tokens[self.at]
        self.at += 1
        return token

    def skip_key(self, *names: str) -> bool:
        """Goes past one of these concepts, if it is here."""
        found = self.key(*names)
        self.at += found
        return found

    def whole(self, ahead: int = 0) -> int | None:
        """The whole number there."""
        token = self.look(ahead)
        return token.value if token is not None and token.kind == "number" and isinstance(token.value, int) else None


@dataclass(frozen=True)
class Refers:
    """Which rounds are worked once more.

    numbers : theirs; empty for ``latest``, the last so many, for ``marks``, from the asterisks of the one to those of the other, and for all of a part, up to
        its round ``through``
    part : the words that name it, "" for the part under way
    times : how often all of them are worked, None for once or as often as the line has rounds
    length : mm, "until piece measures 3 ins"; whole : that is measured from the beginning, and not from a marker
    upto : so many rounds in all ("until there are 32 rows"); vague : until something that no number says
    mirrored : sides are reversed; until : "to 21 sts": they are worked until there are so many
    """

    span: Span
    numbers: tuple[int, ...] = ()
    latest: int = 0
    marks: tuple[str, str] | None = None
    through: int = 0
    part: str = ""
    times: int | None = None
    length: float | None = None
    whole: bool = True
    mirrored: bool = False
    until: int = 0
    upto: int = 0
    vague: bool = False
