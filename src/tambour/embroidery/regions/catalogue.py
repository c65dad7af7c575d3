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


BROTHER = """007 405 534 070 800 337 620 810 612 502 214 208 205 513 328 005 330 010 704 900 406 869 707 058 086 323 079 030 001 613
542 019 126 812 348 339 509 415 817 399 517 307 085 808 804 607 843 807 333 519 107 209 017 507 614 515 124 206 420 202 027""".split()
"""What is printed on the spools of Brother's polyester for the colours 1 to 61 of PES 1; the last three of its 64 are no threads, but
stand for the steps of appliqué."""


def palette(name: str) -> tuple[Thread, ...]:
    """The colours that machines of ``name``, one of TABLES, have in their memory: ``code`` is the number there."""
    module, maker = TABLES[name]
    entries: list[Any] = [t for t in import_module(f"pystitch.EmbThread{module}").get_thread_set() if t is not None]
    return tuple(
        Thread((t.get_red(), t.get_green(), t.get_blue()), t.description or "", maker, t.catalog_number or "")
        for t in entries
    )


def catalogue(name: str) -> tuple[Thread, ...]:
    """The threads of the maker ``name`` that one can buy; ``code`` is the number on the spool, "" where it is not known."""
    held = palette(name)
    if name == "brother":
        names = [*(t.name for t in held[:41]), "Linen", *(t.name for t in held[42:])]  # pystitch has Flesh Pink twice
        return tuple(replace(t, name=name, code=code) for t, name, code in zip(held, names, BROTHER, strict=False))
    return tuple(replace(t, code="") for t in held) if name == "viking" else held  # a place in its machines' list


def matched(threads: tuple[Thread, ...], name: str) -> tuple[Thread, ...]:
    """For each thread the nearest of a catalogue, two colours never the same thread while there are enough."""
    return nearest(threads, catalogue(name))


def nearest(threads: tuple[Thread, ...], held: tuple[Thread, ...]) -> tuple[Thread, ...]:
    """For each thread the nearest of ``held``, two colours never the same while there are enough."""
    index = nearest_distinct(np.array([t.rgb for t in threads], np.uint8), np.array([t.rgb for t in held], np.uint8))
    return tuple(held[k] for k in index.tolist())


def with_catalogue(plan: ThreadPlan, name: str | None) -> ThreadPlan:
    """The plan in threads of the catalogue ``name``; as it is without one."""
    return plan if name is None or not plan.threads else replace(plan, threads=matched(plan.threads, name))


def screen(threads: tuple[Thread, ...]) -> list[dict[str, Any]]:
    """What a machine that knows only the 64 colours of PES 1 shows for each thread: code, name and colour."""
    return [{"code": t.code, "name": t.name, "rgb": list(t.rgb)} for t in nearest(threads, palette("brother"))]
