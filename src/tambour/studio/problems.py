"""Problems: what is wrong, as a page is told it: with the field's label for an option, and its place in the text."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from functools import cache
from typing import TYPE_CHECKING, Any

from tambour.core.errors import Problem, TambourError, spelt

if TYPE_CHECKING:
    from tambour.core.params import Params
    from tambour.craft import Craft

_NAMED = re.compile(r"\{--([a-z][a-z0-9-]*)\}")


@cache
def _form(params: type[Params]) -> Mapping[str, Any]:
    return params.form()


def plain(problem: Problem, craft: Craft | None = None) -> dict[str, Any]:
    """A problem as data: message, hint, line, column, length, span, where, fields, warning."""
    form = {} if craft is None else _form(craft.params)

    def field(option: str) -> str:
        name = option.replace("-", "_")
        return next((n for n in (name, f"{name}_") if n in form), name)

    def label(option: str) -> str:
        known = form.get(field(option))
        return option.replace("-", " ") if known is None else f"“{known['label']}”"

    told = problem.plain()
    fields = dict.fromkeys(field(n) for text in (told["where"], told["message"]) for n in _NAMED.findall(text))
    told |= {name: spelt(told[name], label) for name in ("message", "hint", "where")}
    span = problem.span if problem.source is not None else None
    told["span"] = None if span is None else [span.start, span.end]
    return {**told, "fields": [name for name in fields if name in form]}


def plains(problems: Iterable[Problem] | TambourError, craft: Craft | None = None) -> list[dict[str, Any]]:
    """Problems as data, equal ones once."""
    listed: list[dict[str, Any]] = []
    for problem in problems.problems if isinstance(problems, TambourError) else problems:
        told = plain(problem, craft)
        if told not in listed:
            listed.append(told)
    return listed


def said(message: str, hint: str = "", where: str = "", fields: Iterable[str] = ()) -> dict[str, Any]:
    """A problem of the studio's own."""
    return {**plain(Problem(message, hint, where=where)), "fields": list(fields)}
