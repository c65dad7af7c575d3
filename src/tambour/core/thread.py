"""ThreadPlan: what an embroidery machine does, needle point by needle point."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Final

import numpy as np

from tambour.core.check import Array, array, put, within
from tambour.core.errors import LawError

STITCH: Final = 0
JUMP: Final = 1
TRIM: Final = 2
STOP: Final = 3
COLOR: Final = 4
END: Final = 5
COMMANDS: Final = ("stitch", "jump", "trim", "stop", "color", "end")


@dataclass(frozen=True, slots=True)
class Thread:
    """A thread: sRGB colour, name, catalogue and code one can buy it by.

    >>> Thread((200, 30, 40), "Red").code
    ''
    """

    rgb: tuple[int, int, int]
    name: str = ""
    catalogue: str = ""
    code: str = ""


@dataclass(frozen=True, eq=False, slots=True)
class ThreadPlan:
    """The needle's way.

    xy : (N, 2) float64 mm, y down, origin at the hoop's centre; where the needle is after the command
    command : (N,) uint8, one of STITCH, JUMP, TRIM, STOP, COLOR (change to ``thread``), END (last, and only there)
    thread : (N,) int16 → threads
    threads : Thread per needle colour, in order of use
    limit : longest step that is not a jump, mm, or None when no machine has been chosen
    about : facts for the file (``title``), wishes to a format (``pes`` "1" or "6", ``jef-trims`` "yes"), and what a
        reader doubted (``doubts``, one to a line)

    >>> way = np.array([[0, 0], [2, 0], [2, 2], [2, 2]])
    >>> plan = ThreadPlan(way, np.array([STITCH, STITCH, STITCH, END]), np.zeros(4), (Thread((200, 30, 40), "Red"),))
    >>> len(plan), [COMMANDS[c] for c in plan.command]
    (4, ['stitch', 'stitch', 'stitch', 'end'])
    """

    xy: Array
    command: Array
    thread: Array
    threads: tuple[Thread, ...]
    limit: float | None = None
    about: Mapping[str, str] = field(default_factory=dict)

    def __post_init__(self) -> None:
        xy = array("ThreadPlan.xy", self.xy, np.float64, (None, 2))
        n = len(xy)
        command = array("ThreadPlan.command", self.command, np.uint8, (n,))
        thread = array("ThreadPlan.thread", self.thread, np.int16, (n,))
        within("ThreadPlan.command", command, 0, len(COMMANDS))
        within("ThreadPlan.thread", thread, 0, max(1, len(self.threads)))
        if n == 0 or command[-1] != END or (command[:-1] == END).any():
            raise LawError("ThreadPlan.command: must end with END, and hold no other")
        if self.limit is not None and n > 1:
            step = np.hypot(*np.diff(xy, axis=0).T)
            step[command[1:] != STITCH] = 0
            if step.max() > self.limit + 1e-9:
                raise LawError(f"ThreadPlan.xy: a stitch of {step.max():.2f} mm, the limit is {self.limit} mm")
        put(self, xy=xy, command=command, thread=thread)

    def __len__(self) -> int:
        return len(self.xy)
