"""LALR: how a line goes through the tables of a grammar, and the tree that it gives.

The tables are made from ``pattern.lark`` by Lark, once, and kept beside it: making them takes longer than most patterns.
What Lark gives for a line, and what it says is wanted where one does not fit, is given here (a test holds them together).
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cache, cached_property
from importlib.resources import files
from typing import Any

END = "$END"


class Token(str):
    """A piece of a line: its text, the name of its kind, and where it begins and ends."""

    __slots__ = ("end_pos", "start_pos", "type")

    def __new__(cls, kind: str, text: str, start: int) -> Token:
        made = super().__new__(cls, text)
        made.type, made.start_pos, made.end_pos = kind, start, start + len(text)
        return made

    type: str
    start_pos: int
    end_pos: int


@dataclass(frozen=True, slots=True)
class Tree:
    """A rule of the grammar, by its name, and what it was made of."""

    data: str
    children: list[Any]

    def tokens(self) -> Iterator[Token]:
        """All tokens in it, from left to right."""
        for child in self.children:
            if isinstance(child, Tree):
                yield from child.tokens()
            else:
                yield child


@dataclass
class DoesNotFit(Exception):
    """A line that the grammar does not have: the first token (its kind END at the line's end) or sign that does not fit,
    and the names of what would."""

    token: Token
    wanted: set[str]


@dataclass(frozen=True)
class Grammar:
    """A grammar's tables.

    terminals : names and regular expressions, those that win before the others; ignored : names of what is left out
    rules : name, what becomes of each symbol ("-" it is dropped, "+" kept, "*" its children stand in its place), and
        whether an only child stands in its place
    states : what follows on a symbol: a state, or -1 - a rule that is made; start, end : their first and last
    """

    terminals: dict[str, str]
    ignored: list[str]
    rules: list[tuple[str, str, bool]]
    states: list[dict[str, int]]
    start: int
    end: int
    _known: dict[frozenset[str], re.Pattern[str]] = field(default_factory=dict)

    def parse(self, line: str) -> Tree:
        """The tree of a line. Raises DoesNotFit."""
        states, at = [self.start], 0
        made: list[Any] = []
        while True:
            token = self._token(line, at, self.states[states[-1]])
            at = token.end_pos
            while (follows := self.states[states[-1]].get(token.type)) is not None and follows < 0:
                name, kept, single = self.rules[-1 - follows]
                children = self._children(kept, made[len(made) - len(kept) :])
                del states[len(states) - len(kept) :], made[len(made) - len(kept) :]
                made.append(children[0] if single and len(children) == 1 else Tree(name, children))
                states.append(self.states[states[-1]][name])
            if states[-1] == self.end and token.type == END:
                return made[-1]
            if follows is None:
                raise DoesNotFit(token, {s for s in self.states[states[-1]] if s.isupper()})
            states.append(follows)
            made.append(token)

    @staticmethod
    def _children(kept: str, made: list[Any]) -> list[Any]:
        found: list[Any] = []
        for what, child in zip(kept, made):
            if what == "*":
                found += child.children
            elif what == "+":
                found.append(child)
        return found

    def _token(self, line: str, at: int, state: dict[str, int]) -> Token:
        """The next token of the line, of those that the state can take."""
        wanted = state.keys() & self.terminals.keys()
        match = self._next(line, at, frozenset(wanted))
        if match is not None:
            return match
        # What could stand elsewhere is told as what it is.
        other = self._next(line, at, self._all)
        begin = other.start_pos if other is not None else self._ignore.match(line, at).end()  # type: ignore[union-attr]
        raise DoesNotFit(other or Token("", line[begin], begin), wanted or {"<END-OF-FILE>"})

    def _next(self, line: str, at: int, wanted: frozenset[str]) -> Token | None:
        at = self._ignore.match(line, at).end()  # type: ignore[union-attr]
        if at == len(line):
            return Token(END, "", at)
        if wanted not in self._known:
            names = [name for name in self.terminals if name in wanted]
            self._known[wanted] = re.compile("|".join(f"(?P<{name}>{self.terminals[name]})" for name in names))
        found = self._known[wanted].match(line, at)
        # Where only the end fits there is nothing to match, which every character begins with.
        return Token(found.lastgroup, found[0], at) if found and found.lastgroup else None

    @cached_property
    def _all(self) -> frozenset[str]:
        return frozenset(self.terminals)

    @cached_property
    def _ignore(self) -> re.Pattern[str]:
        return re.compile("|".join([*self.ignored, ""]))


@cache
def grammar() -> Grammar:
    """The grammar of a pattern's line."""
    told = json.loads(files("tambour.crochet.language").joinpath("pattern.json").read_text(encoding="utf-8"))
    return Grammar(**told | {"rules": [tuple(rule) for rule in told["rules"]]})
