"""Axes: the values that a sweep goes through: ``max_float=3,4,5``, ``seed=0..9``, ``mist=0..1..0.25``, ``colors=[…]``."""

from __future__ import annotations

import itertools
import json
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from decimal import Decimal
from typing import Any

from tambour.core.errors import Problem, TambourError, did_you_mean
from tambour.craft import Craft
from tambour.run import outputs

_RANGE = re.compile(r"\s*(-?\d+(?:\.\d+)?)\s*\.\.\s*(-?\d+(?:\.\d+)?)\s*(?:\.\.\s*(\d+(?:\.\d+)?)\s*)?")
MOST = 10_000_000
"""Values of an axis, and pieces of a sweep, above which nothing is begun."""
TOLD = 20
"""Problems of combinations that are told one by one."""

Axes = Mapping[str, Sequence[Any]]
"""Field → the values that it goes through, as the craft's Params take them."""


def values(text: str) -> list[Any]:
    """The values of ``3,4,5``, ``0..9``, ``0..1..0.25`` or a JSON list; ValueError for what is none."""
    if text.strip().startswith("["):
        try:
            found = json.loads(text)
        except (ValueError, RecursionError):
            raise ValueError("this begins as a JSON list and is none") from None
        return list(found)
    if match := _RANGE.fullmatch(text):
        first, last, step = (Decimal(word) for word in (match[1], match[2], match[3] or "1"))
        if not step or last < first:
            raise ValueError("a range goes up: FIRST..LAST or FIRST..LAST..STEP")
        count = int((last - first) / step) + 1
        if count > MOST:
            raise ValueError(f"{count:,} values are too many")
        return [f"{(first + k * step):f}" for k in range(count)]
    if not text.strip():
        raise ValueError("no value is given")
    return [word.strip() for word in text.split(",")]


def field(craft: Craft, name: str) -> str:
    """The field that a name tells; TambourError when there is none."""
    known = craft.params.asked()
    plain = name.strip().lstrip("-").replace("-", "_")
    found = next((n for n in (plain, f"{plain}_") if n in known), "")
    if not found:
        words = [n.rstrip("_") for n in known]
        hint = did_you_mean(plain, words) or f"{craft.name} has {', '.join(words)}"
        raise TambourError(f'{craft.name} has no parameter "{name.strip()}"', hint=hint, where=f"{{--set}} {name}")
    return found


def axes(craft: Craft, given: Iterable[str] | Mapping[str, Any]) -> tuple[Axes, list[Problem]]:
    """The axes that texts (``max_float=3,4,5``) or a mapping tell, and warnings: what is named twice.

    Each value is tried by itself; TambourError with all that is wrong.
    """
    made: dict[str, list[Any]] = {}
    problems: list[Problem] = []
    doubts: list[Problem] = []
    for one in given.items() if isinstance(given, Mapping) else (text.partition("=")[::2] for text in given):
        name, told = one
        where = f"{{--set}} {name}"
        try:
            key = field(craft, name)
            if key in made:
                raise ValueError("is set twice")
            if isinstance(told, str):
                listed = values(told)
            else:
                listed = [_plain(craft, key, v) for v in (told if isinstance(told, (list, tuple, range)) else [told])]
        except TambourError as error:
            problems += error.problems
            continue
        except ValueError as error:
            problems.append(Problem(str(error), "such as NAME=3,4,5 or NAME=0..9", where=where))
            continue
        made[key] = []
        seen: dict[str, Any] = {}
        for value in listed:
            try:
                params = craft.params.of({key: value})
                same = repr(getattr(params, key))
            except TambourError as error:
                # What is wrong with a value alone; what only other values could mend is tried with them.
                own = [p for p in error.problems if p.where]
                problems += [Problem(p.message, p.hint, where=where) for p in own]
                same = repr(value)
            if same in seen:
                doubts.append(Problem(f"{value} is {seen[same]}, and is made once", where=where, warning=True))
                continue
            seen[same] = value
            made[key].append(value)
    if problems:
        raise TambourError(_once(problems))
    return made, doubts


def _plain(craft: Craft, name: str, value: Any) -> Any:
    """A value of a program as the command line would give it: numbers for texts are texts."""
    takes_text = craft.params.model_fields[name].annotation in (str, str | None)
    return str(value) if takes_text and isinstance(value, (int, float)) else value


def combinations(found: Axes) -> Iterator[dict[str, Any]]:
    """Every combination, the last axis the fastest."""
    for chosen in itertools.product(*found.values()):
        yield dict(zip(found, chosen))


def judged(craft: Craft, found: Axes, out: Sequence[str]) -> tuple[int, list[Problem]]:
    """How many combinations there are, and warnings: what has no effect. TambourError for those that cannot be."""
    count = 1
    for listed in found.values():
        count *= len(listed)
    if count > MOST:
        raise TambourError(f"these are {count:,} combinations: at most {MOST:,} are made", where="{--set}")
    known: dict[str, list[str]] = {}

    def views(prefer: Mapping[str, str]) -> list[str]:
        if repr(prefer) not in known:
            known[repr(prefer)] = [o.view for o in outputs(craft, [f"piece{kind}" for kind in out], "", prefer)]
        return known[repr(prefer)]

    problems: list[Problem] = []
    idle: dict[str, int] = {}
    told: dict[str, Problem] = {}
    for chosen in combinations(found):
        try:
            params = craft.params.of(chosen)
            craft.check(params, views(craft.prefer(params)))
            for doubt in params.idle():
                told.setdefault(str(doubt), doubt)
                idle[str(doubt)] = idle.get(str(doubt), 0) + 1
        except TambourError as error:
            at = " ".join(f"{n.rstrip('_')}={v}" for n, v in chosen.items())
            problems += [
                Problem(p.message, p.hint, where=f"{at}: {p.where}" if p.where else at) for p in error.problems
            ]
    if problems:
        alike = _once(problems)
        more = [Problem(f"and {len(alike) - TOLD:,} more like these")] if len(alike) > TOLD else []
        raise TambourError([*alike[:TOLD], *more])
    doubts = []
    for words, times in idle.items():
        p = told[words]
        often = "" if times == count else f", in {times:,} of {count:,} combinations"
        doubts.append(Problem(p.message + often, p.hint, where=p.where, warning=True))
    return count, doubts


def _once(problems: Sequence[Problem]) -> list[Problem]:
    return list({str(p): p for p in problems}.values())
