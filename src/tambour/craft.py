"""Craft: the record that every craft fills in, and all that the house knows of it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from importlib import import_module
from typing import TYPE_CHECKING, Any

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
    """

    where: str

    def __call__(self, *given: Any) -> Any:
        return self.found(*given)

    @property
    def found(self) -> Callable[..., Any]:
        """The function itself."""
        module, name = self.where.split(":")
        function: Callable[..., Any] = getattr(import_module(module), name)
        return function


@dataclass(frozen=True, slots=True)
class View:
    """One way to look at a piece: ``make(piece)`` gives a value of type ``value``.

    ``suffixes``: the file types whose default view this is. ``stage``: the stage of the report that its time counts to.
    """

    make: Callable[[Any], Any]
    value: str
    help: str
    suffixes: tuple[str, ...] = ()
    stage: str = "view"


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
    prefer : params → {suffix: view} where they choose another default view than the views' own suffixes do
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
