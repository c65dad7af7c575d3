"""Pose: how placed parts lean, set by hand in place of what the pattern says."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from tambour.core.errors import Problem, TambourError, did_you_mean
from tambour.crochet.graph.built import Built
from tambour.crochet.language.finishes import KINDS, Placed

ANGLES = ("tilt", "towards", "across")
"""What a pose may set, in degrees."""

_SET = re.compile(r"([a-z]+)\s*=\s*(-?\d{1,4}(?:\.\d+)?)$", re.IGNORECASE)
_USAGE = "a pose is such as pose:Arm.1.tilt=30"


def pose(built: Built, poses: Sequence[str]) -> Built:
    """``built`` with the angles of its placed parts set by ``poses``, each a part's name and ``angle=degrees`` words.

    What the pattern then says of its parts is the posed: writing it back keeps the pose. TambourError with every pose
    that cannot be.
    """
    if not poses:
        return built
    pattern = built.pattern
    copies = {section.name: section.copies for section in pattern.parts}
    finish, problems = list(pattern.finish), []
    names = [f.part for f in finish if isinstance(f, Placed)]
    for text in poses:
        words = text.split()
        at = next((k for k, word in enumerate(words) if "=" in word), len(words))
        name, angles = " ".join(words[:at]), " ".join(words[at:]).replace(",", " ").split()
        found = [k for k, f in enumerate(finish) if isinstance(f, Placed) and _same(f.part, name, copies)]
        if not found:
            hint = did_you_mean(name, names) or (
                f"placed are {', '.join(names)}" if names else "the pattern places no parts: place(…) does"
            )
            problems.append(
                Problem(f'no part "{name}" is placed' if name else "a pose names a part", hint, where="{--edit} pose")
            )
            continue
        if not angles:
            problems.append(Problem(f'"{text}" sets no angle', _USAGE, where="{--edit} pose"))
        values: dict[str, Any] = {}
        for word in angles:
            said = _SET.match(word)
            key = said[1].lower() if said else ""
            if said is None or key not in ANGLES:
                hint = did_you_mean(word.partition("=")[0], ANGLES) or _USAGE
                problems.append(Problem(f'"{word}" is no angle of a pose', hint, where="{--edit} pose"))
                continue
            low, high = KINDS["place"][1][key]
            if not low <= float(said[2]) <= high:
                problems.append(
                    Problem(f'"{word}" does not fit', f"{key} is {low:g} to {high:g}", where="{--edit} pose")
                )
                continue
            values[key] = float(said[2])
        for k in found:
            placed = finish[k]
            assert isinstance(placed, Placed)
            finish[k] = replace(placed, points=None, **values)
    if problems:
        raise TambourError(problems)
    return replace(built, pattern=replace(pattern, finish=tuple(finish)))


def _same(part: str, name: str, copies: dict[str, int]) -> bool:
    """Whether two names mean one part: ``Tail`` and ``Tail.1`` do, where it is made once."""

    def plain(word: str) -> str:
        base, _, copy = word.rpartition(".")
        return base if copy == "1" and copies.get(base) == 1 else word

    return plain(part).lower() == plain(name).lower()
