"""Progress: how long work tells what it is doing, how long each stage took, and what it doubts."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from tambour.core.errors import Problem

LOOK = 0.016
"""Seconds between two looks."""


class Stopped(BaseException):
    """Raised where work shall end at once and leave nothing: by a signal, or by ``show`` for a caller who left."""


Show = Callable[[str, int, int], None]


class Progress:
    """Handed to every ``make``: names stages, counts, collects warnings.

    ``show(stage, done, total)`` is called on every change: a bar in the terminal, nothing in batch. It may raise
    :class:`Stopped`, which ends the work. ``watch`` is shown what is being made, at most every 16 ms. ``tell`` is given
    what must be known before a long wait (:meth:`ahead`), which ``told`` then holds. ``seconds`` holds the time spent in each stage, nested stages taken out of their surroundings.

    >>> progress = Progress()
    >>> with progress.stage("settle"):
    ...     progress.step(1, 2)
    >>> list(progress.seconds)
    ['settle']
    """

    def __init__(
        self,
        show: Show | None = None,
        watch: Callable[[Any], None] | None = None,
        tell: Callable[[Problem], None] | None = None,
    ) -> None:
        self.seconds: dict[str, float] = {}
        self.warnings: list[Problem] = []
        self._show = show or (lambda stage, done, total: None)
        self._open: list[str] = []
        self._since = 0.0
        self._watch = watch
        self._tell = tell
        self.told: list[Problem] = []
        self._looked = 0.0

    @contextmanager
    def stage(self, name: str) -> Iterator[None]:
        """Work done inside is counted as stage ``name``.

        >>> progress = Progress()
        >>> with progress.stage("read"):
        ...     pass
        >>> progress.seconds["read"] >= 0
        True
        """
        self._switch()
        self._open.append(name)
        self._show(name, 0, 0)
        try:
            yield
        finally:
            self._switch()
            self._open.pop()

    def step(self, done: int, total: int) -> None:
        """The open stage has done ``done`` of ``total``.

        >>> progress = Progress(lambda stage, done, total: print(stage, done, "of", total))
        >>> progress.step(1, 2)
         1 of 2
        """
        self._show(self._open[-1] if self._open else "", done, total)

    def look(self, make: Callable[[], Any]) -> None:
        """Show who watches what is being made: ``make()`` is called only when somebody does and the last look is over.

        >>> Progress(watch=print).look(lambda: "half a ball")
        half a ball
        """
        now = time.perf_counter()
        if self._watch is not None and now - self._looked >= LOOK:
            self._watch(make())
            self._looked = time.perf_counter()

    def copy(self) -> Progress:
        """Another one for the same caller, with what was told so far: where work goes on from a state that is kept.

        >>> progress = Progress()
        >>> progress.warn("a doubt")
        >>> len(progress.copy().warnings)
        1
        """
        made = Progress(self._show, self._watch, self._tell)
        made.warnings, made.seconds = list(self.warnings), dict(self.seconds)
        return made

    def warn(self, problem: Problem | str, hint: str = "", where: str = "") -> None:
        """Note a doubt; it is printed, and stands in the report, but stops nothing.

        >>> progress = Progress()
        >>> progress.warn("the pattern names no yarn", where="bear.txt")
        >>> print(progress.warnings[0])
        bear.txt: warning: the pattern names no yarn
        """
        if isinstance(problem, str):
            problem = Problem(problem, hint=hint, where=where)
        self.warnings.append(
            Problem(problem.message, problem.hint, problem.span, problem.source, problem.where, warning=True)
        )

    def ahead(self, message: str, hint: str = "") -> None:
        """Warn of what is to be known before a long wait, at once: who stops the work then has read it.

        >>> heard = []
        >>> Progress(tell=heard.append).ahead("this may take an hour")
        >>> print(heard[0])
        warning: this may take an hour
        """
        self.warn(message, hint)
        if self._tell is not None:
            self.told.append(self.warnings[-1])
            self._tell(self.warnings[-1])

    def _switch(self) -> None:
        now = time.perf_counter()
        if self._open:
            self.seconds[self._open[-1]] = self.seconds.get(self._open[-1], 0.0) + now - self._since
        self._since = now
