"""Limit: how much memory and time a piece may take."""

from __future__ import annotations

import re
from dataclasses import dataclass

from tambour.core.errors import Problem, TambourError

_BYTES = {"kb": 10**3, "mb": 10**6, "gb": 10**9, "kib": 2**10, "mib": 2**20, "gib": 2**30}
_TIMES = {"s": 1.0, "min": 60.0, "m": 60.0, "h": 3600.0}
LEAST = 400 * 10**6
"""Bytes that a worker needs before it has made anything."""


@dataclass(frozen=True, slots=True)
class Limit:
    """memory : bytes, or None ; seconds : or None."""

    memory: int | None = None
    seconds: float | None = None

    @classmethod
    def of(cls, text: str) -> Limit:
        """The limit that ``2GB,60s``, ``2GB`` or ``10min`` tell; TambourError for what is none."""
        memory, seconds, problems = None, None, []
        for word in text.split(","):
            found = re.fullmatch(r"\s*(\d+(?:\.\d+)?)\s*([a-zA-Z]+)\s*", word)
            unit = found[2].lower() if found else ""
            if found and unit in _BYTES:
                memory = int(float(found[1]) * _BYTES[unit])
                if memory < LEAST:
                    told = f"{word.strip()} is less than a worker needs to begin with"
                    problems.append(Problem(told, f"{LEAST // 10**6} MB or more", where="{--limit}"))
            elif found and unit in _TIMES and float(found[1]) > 0:
                seconds = float(found[1]) * _TIMES[unit]
            else:
                hint = "such as 2GB, 60s, or both: 2GB,60s"
                problems.append(Problem(f'"{word.strip()}" is neither memory nor time', hint, where="{--limit}"))
        if problems:
            raise TambourError(problems)
        return cls(memory, seconds)
