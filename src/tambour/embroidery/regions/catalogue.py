"""Thread catalogues: the nearest thread one can buy, from the tables of makers that pystitch (MIT) carries."""

from __future__ import annotations

from dataclasses import replace
from importlib import import_module
from typing import Any

import numpy as np

from tambour.color import nearest_distinct
from tambour.core.thread import Thread, ThreadPlan

TABLES = {
    "brother": ("Pec", "Brother"),
    "janome": ("Jef", "Janome"),
    "husqvarna": ("Hus", "Husqvarna"),
    "viking": ("Shv", "Viking"),
}


def catalogue(name: str) -> tuple[Thread, ...]:
    """The threads of the maker ``name``, one of TABLES."""
    module, maker = TABLES[name]
    entries: list[Any] = [t for t in import_module(f"pystitch.EmbThread{module}").get_thread_set() if t is not None]
    return tuple(
        Thread((t.get_red(), t.get_green(), t.get_blue()), t.description or "", maker, t.catalog_number or "")
        for t in entries
    )


def matched(threads: tuple[Thread, ...], name: str) -> tuple[Thread, ...]:
    """For each thread the nearest of a catalogue, two colours never the same thread while there are enough."""
    held = catalogue(name)
    index = nearest_distinct(np.array([t.rgb for t in threads], np.uint8), np.array([t.rgb for t in held], np.uint8))
    return tuple(held[k] for k in index.tolist())


def with_catalogue(plan: ThreadPlan, name: str | None) -> ThreadPlan:
    """The plan in threads of the catalogue ``name``; as it is without one."""
    return plan if name is None or not plan.threads else replace(plan, threads=matched(plan.threads, name))


def screen(threads: tuple[Thread, ...]) -> list[dict[str, Any]]:
    """What a machine that knows only the 64 colours of PES 1 shows for each thread: code, name and colour."""
    return [{"code": t.code, "name": t.name, "rgb": list(t.rgb)} for t in matched(threads, "brother")]
