"""Live: an embroidery as a screen draws it, its thread in the order of sewing, and the colours that it is sewn in."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from tambour.color import plain_name
from tambour.core.packed import Packed, of_strands
from tambour.core.paths import Paths
from tambour.core.rgb import hexed
from tambour.core.steps import Step, told
from tambour.core.strands import Strands
from tambour.core.thread import COLOR, COMMANDS, STITCH, STOP, Thread
from tambour.embroidery.cloth.thread import curves
from tambour.embroidery.lines.density import density_map
from tambour.embroidery.looks.preview import stitches
from tambour.embroidery.params import hoop_size
from tambour.embroidery.piece import KINDS, Piece
from tambour.embroidery.plan.facts import EXTRA, SPEED

if TYPE_CHECKING:
    from tambour.core.check import Array

DENSITY = 1.0
"""Side of a cell of the map of density, mm."""


def live(piece: Piece) -> Packed:
    """The thread on flat cloth, needle point by needle point; what is known of each; the regions' outlines.

    The thread as :func:`tambour.core.packed.of_strands` packs it, a unit being a needle point: x as in the plan, y the
    height over the cloth, z the plan's y. Per needle point (N,): ``xy`` (N, 2) mm, ``command``, ``thread``,
    ``region``, ``kind``, ``seconds`` (the machine's time when it is done). ``outline`` (Q, 2) mm, its lines by
    ``outline_offsets`` (L + 1,), each of the region ``outline_region`` (L,). ``density`` (H, W) mm of thread per mm².
    """
    plan = piece.plan
    k = stitches(plan)
    radius = piece.params.thread / 2
    led = curves(
        plan.xy[k - 1],
        plan.xy[k],
        radius=radius,
        theta=float(np.radians(piece.params.theta)),
        ends=piece.params.ends,
        base=piece.elevation[k],
    )
    unit = k[led.stitch]
    threads = np.array([t.rgb for t in plan.threads], np.uint8).reshape(-1, 3)
    coords = np.column_stack([led.plan[:, 0], led.height, led.plan[:, 1]])
    laid = Strands(
        Paths(coords, led.offsets),
        np.full(len(coords), radius),
        threads[plan.thread[unit]],
        source=unit.astype(np.int32),
    )
    hues = threads[plan.thread] if len(threads) else np.zeros((len(plan), 3), np.uint8)
    arrays, facts = of_strands(laid, np.repeat(unit, np.diff(led.offsets)), len(plan), hues)
    low, high = (plan.xy.min(0), plan.xy.max(0)) if len(k) else (np.zeros(2), np.zeros(2))
    corner = np.floor(low) - 1
    lines = [path for r in piece.regions for path in r.paths]
    of = [i for i, r in enumerate(piece.regions) for _ in r.paths]
    outline = Paths.of(lines)
    bounds = (float(corner[0]), float(corner[1]), float(np.ceil(high[0]) + 1), float(np.ceil(high[1]) + 1))
    arrays |= {
        "xy": plan.xy.astype(np.float32),
        "command": plan.command,
        "thread": plan.thread,
        "region": piece.region,
        "kind": piece.kind,
        "seconds": seconds(piece).astype(np.float32),
        "outline": outline.coords.astype(np.float32),
        "outline_offsets": outline.offsets.astype(np.uint32),
        "outline_region": np.array(of, np.int32),
        "density": density_map(np.column_stack([plan.xy[k - 1], plan.xy[k]]), np.ones(len(k)), bounds, DENSITY).astype(
            np.float32
        ),
    }
    facts |= {
        "craft": "embroidery",
        "unit": "needle point",
        "commands": list(COMMANDS),
        "kinds": list(KINDS),
        "threads": [
            {"rgb": list(t.rgb), "name": t.name, "catalogue": t.catalogue, "code": t.code} for t in plan.threads
        ],
        "hoop": None if piece.params.hoop is None else list(hoop_size(piece.params.hoop)),
        "regions": _regions(piece),
        "size": (high - low).tolist(),
        "minutes": float(arrays["seconds"][-1]) / 60,
        "density": {"x": bounds[0], "y": bounds[1], "cell": DENSITY},
    }
    return Packed(arrays, facts)


def _regions(piece: Piece) -> list[dict[str, Any]]:
    """Every region: its name, stitch, colour, the needle points that it lies between, its stitches, how it is sewn."""
    listed = []
    for k, r in enumerate(piece.regions):
        own = np.flatnonzero(piece.region == k)
        listed.append(
            {
                "id": r.id,
                "stitch": r.stitch,
                "role": r.role,
                "color": list(r.color),
                "width": r.width,
                "first": int(own[0]) if len(own) else 0,
                "end": int(own[-1]) + 1 if len(own) else 0,
                "count": int((piece.plan.command[own] == STITCH).sum()),
                "params": r.params.plain(),
                "trim": "trim" in r.flags,
                "stop": "stop" in r.flags,
                "rails": [line.tolist() for line in r.paths][:2] if r.role == "rails" else None,
            }
        )
    return listed


def seconds(piece: Piece) -> Array:
    """The machine's time (N,) when each needle point is done; threading and trimming as :data:`EXTRA` has them."""
    takes = np.zeros(len(COMMANDS))
    takes[STITCH] = 60 / SPEED
    for command, time in EXTRA.items():
        takes[command] = time
    return np.cumsum(takes[piece.plan.command])


def steps(piece: Piece) -> dict[str, Any]:
    """The stretches that are sewn without a stop, with the thread of each."""
    plan = piece.plan
    n = len(plan)
    begins = np.flatnonzero(np.isin(plan.command, (COLOR, STOP))).tolist()
    made: list[Step] = []
    for first, end in zip([0, *begins], [*begins, n]):
        sewn = int((plan.command[first:end] == STITCH).sum())
        if first == end or (not sewn and end < n):  # a change at the very beginning, or right after another
            continue
        thread = _called(plan.threads[int(plan.thread[end - 1])]) if plan.threads else ""
        changed = made and plan.command[first] == COLOR
        stop = f"change to {thread}" if changed else "the machine stops" if made else f"begin with {thread}"
        words = f"{sewn:,} stitches in {thread}"
        begin = made[-1].end if made else 0
        made.append(Step(f"Color {len(made) + 1}", words, begin, end, sewn, stop=stop))
    return told("embroidery", "needle point", n, made)


def _called(thread: Thread) -> str:
    """A thread's name and code, else what its colour is called, and it."""
    named = " ".join(filter(None, (thread.catalogue, thread.code, thread.name)))
    return named or f"{plain_name(np.array(thread.rgb, np.uint8))} {hexed(thread.rgb)}"
