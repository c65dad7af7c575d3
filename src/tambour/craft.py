"""Craft: the record that every craft fills in, and all that the house knows of it."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from importlib import import_module
from typing import TYPE_CHECKING, Any

from tambour.core.errors import Problem, TambourError, did_you_mean

if TYPE_CHECKING:
    from tambour.core.params import Params
    from tambour.core.progress import Progress


def _no_facts(piece: Any) -> dict[str, Any]:
    return {}


def _plain_name(params: Params) -> str:
    return ""


def _no_objection(params: Params, views: Sequence[str]) -> None:
    pass


def _no_preference(params: Params) -> Mapping[str, str]:
    return {}


@dataclass(frozen=True, slots=True)
class Lazy:
    """A function by its place, ``package.module:name``, imported when it is first called.

    So a craft's table names all that it can do, and loads none of it.

    >>> Lazy("math:sqrt")(9)
    3.0
    """

    where: str

    def __call__(self, *given: Any) -> Any:
        return self.found(*given)

    @property
    def found(self) -> Callable[..., Any]:
        """The function itself.

        >>> import math
        >>> Lazy("math:sqrt").found is math.sqrt
        True
        """
        module, name = self.where.split(":")
        function: Callable[..., Any] = getattr(import_module(module), name)
        return function


@dataclass(frozen=True, slots=True)
class View:
    """One way to look at a piece: ``make(piece)`` gives a value of type ``value``.

    ``suffixes``: the file types whose default view this is. ``stage``: the stage of the report that its time counts to.

    >>> view = View(len, "dict", "how long it is", (".json",))
    >>> view.make([1, 2])
    2
    """

    make: Callable[[Any], Any]
    value: str
    help: str
    suffixes: tuple[str, ...] = ()
    stage: str = "view"


Edit = Mapping[str, Any]
"""An edit as data: ``{"edit": KIND, field: value, …}``."""


@dataclass(frozen=True, slots=True)
class Change:
    """A kind of edit that a craft understands: a small Params says what one holds.

    words : how one is spelt after ``KIND:``, its fields in braces: ``{row},{stitch}={yarn}``
    before : (source, params, edits) → (source, params), for what is changed before the piece is made; or
    after : (piece, edits, progress) → piece, for what is changed on the made piece

    >>> from tambour.run import craft
    >>> craft("knit").changes["stitch"].words
    '{row},{stitch}={yarn}'
    """

    help: str
    params: type[Params]
    words: str
    before: Callable[[Any, Any, Sequence[Any]], tuple[Any, Any]] | None = None
    after: Callable[[Any, Sequence[Any], Progress], Any] | None = None


@dataclass(frozen=True, slots=True)
class Craft:
    """A craft.

    name : the command, the folder of examples and goldens
    help : one line
    params : its Params
    reads : value types a source may be read as, in order of preference; empty: it needs no source
    make : ``make(source, params, progress) -> piece``; pure, deterministic
    views : name → View
    facts : piece → what the report says about it
    stem : params → name (without suffix) for files that were asked for by suffix alone; "" takes the source's
    optional_source : the craft can also start from nothing
    check : (params, the views that are asked for); raises TambourError, before any work, for what cannot be made of them
    changes : name → Change, the edits that it understands
    prefer : params → {suffix: view} where they choose another default view than the views' own suffixes do
    inner : facts that tell how a piece was reached, which the summary leaves to ``--verbose``

    >>> from tambour.run import craft
    >>> knit = craft("knit")
    >>> "Picture" in knit.reads, "chart" in knit.views
    (True, True)
    """

    name: str
    help: str
    params: type[Params]
    reads: tuple[str, ...]
    make: Callable[[Any, Any, Progress], Any]
    views: Mapping[str, View]
    facts: Callable[[Any], dict[str, Any]] = _no_facts
    stem: Callable[[Any], str] = _plain_name
    optional_source: bool = False
    check: Callable[[Any, Sequence[str]], None] = _no_objection
    prefer: Callable[[Any], Mapping[str, str]] = _no_preference
    changes: Mapping[str, Change] = field(default_factory=dict)
    inner: tuple[str, ...] = ()

    def edits(self, given: Sequence[Edit | str]) -> list[tuple[str, Params]]:
        """Edits as values, checked: each as text (``stitch:12,30=CC``) or as data (``{"edit": "stitch", "row": 12, …}``).

        TambourError with all that is wrong in them.

        >>> from tambour.run import craft
        >>> craft("knit").edits(["stitch:12,30=CC"])[0][1].row
        12
        """
        made: list[tuple[str, Params]] = []
        problems: list[Problem] = []
        for one in given:
            try:
                made.append(_edit(self, one))
            except TambourError as error:
                problems += error.problems
        if problems:
            raise TambourError(problems)
        return made


def _edit(craft: Craft, given: Edit | str) -> tuple[str, Params]:
    shown = given if isinstance(given, str) else repr(dict(given)) if isinstance(given, Mapping) else repr(given)
    where = f"{{--edit}} {shown[:120]}"
    if isinstance(given, str):
        kind, _, words = given.partition(":")
    else:
        kind = str(given.get("edit", "")) if isinstance(given, Mapping) else ""
    if kind not in craft.changes:
        forms = [f"{name}:{change.words}".replace("{", "").replace("}", "") for name, change in craft.changes.items()]
        hint = did_you_mean(kind, craft.changes) or f"there is {', '.join(forms)}"
        raise TambourError(f'{craft.name} has no edit "{kind}"', hint=hint, where=where)
    change = craft.changes[kind]
    if isinstance(given, str):
        pattern = re.sub(r"\\\{(\w+)\\\}", r"(?P<\1>.+)", re.escape(change.words))
        found = re.fullmatch(pattern, words.strip(), re.DOTALL)
        if found is None:
            form = change.words.replace("{", "").replace("}", "").upper()
            raise TambourError("this edit cannot be read", hint=f"its form is {kind}:{form}", where=where)
        values: dict[str, Any] = {name: word.strip() for name, word in found.groupdict().items()}
    else:
        values = {str(k): v for k, v in given.items() if k != "edit"}
    spell = where.replace("{", "{{").replace("}", "}}") + ": {}"
    return kind, change.params.of(values, spell=spell)


def plain_edit(kind: str, edit: Params) -> Edit:
    """An edit as data, as reports and files of edits hold it.

    >>> from tambour.run import craft
    >>> plain_edit(*craft("knit").edits(["stitch:12,30=CC"])[0])
    {'edit': 'stitch', 'row': 12, 'stitch': 30, 'yarn': 'CC'}
    """
    return {"edit": kind, **{name: value for name, value in edit.plain().items() if name != "edition"}}
