"""Sewable: what a machine, or whoever stands at it, would stumble over: with numbers and places."""

from __future__ import annotations

import numpy as np

from tambour.core.check import Array
from tambour.core.thread import COLOR, JUMP, STITCH, TRIM
from tambour.embroidery.lines.density import density_map
from tambour.embroidery.machines import MACHINES
from tambour.embroidery.piece import LOCK, Piece

# What public machine files hold that people sell, give, ship or sewed: 56 different designs, 45 of digitisers (a thread maker's free
# ones, a shop's orders, samples that come with programs) and 11 made at home. 95th percentiles of the 45: 28 needle points, 9.2 covers,
# 4.1 % short stitches (medians 14, 6.0, 0.5); of all 56: 32, 9.1 and 19 %.
POINTS = 29  # needle points in a cell of 1 mm²: more cut the cloth
COVERS = 9.0  # covers of thread, in the mean of 3 x 3 mm: stiff as a board
SHORT = 0.399  # mm: stitches below break thread; rows 0.4 mm apart turn by just that
SHARE = 0.05  # of all stitches that may be so short
COLORS = 15  # threads: more than machines have needles
CHANGES = 40  # changes of thread
SMALL = 10.0  # mm: a design this small is most likely a mistake of units
HOLE = 0.8  # mm: holes of areas narrower than this in the mean are closed by thread
LOOSE = 12.0  # mm of thread that lies over the cloth uncut


def doubts(piece: Piece) -> list[tuple[str, str]]:
    """What is doubtful to sew, as (what, remedy); nothing where all is well."""
    plan = piece.plan
    sewn = plan.command == STITCH
    points = plan.xy[sewn]
    if not len(points):
        return []
    end = np.flatnonzero(sewn[1:]) + 1
    size = np.hypot(*(plan.xy[end] - plan.xy[end - 1]).T)
    real = (size > 1e-9) & (piece.kind[end] != LOCK)
    made: list[tuple[str, str]] = []
    wide = np.ptp(points, axis=0)
    if wide.max() < SMALL:
        made.append((f"the design is {wide[0]:.1f} x {wide[1]:.1f} mm", "give its size: {--width} 80mm"))
    cell, held = np.unique(np.floor(points).astype(int), axis=0, return_counts=True)
    if held.max() > POINTS:
        at = cell[int(held.argmax())]
        made.append(
            (
                f"{held.max()} needle points in one mm² at {_at(at + 0.5)}; {int((held > POINTS).sum())} places hold more than {POINTS}",
                "fewer layers there, a longer {--row-spacing}, or a larger {--width}",
            )
        )
    most, at = _covers(piece, end)
    if most > COVERS:
        made.append((f"{most:.0f} covers of thread lie on each other at {_at(at)}", "fewer layers, or no {--underlay}"))
    short = float((size[real] < SHORT).mean()) if real.any() else 0.0
    if short > SHARE:
        made.append((f"{short:.0%} of the stitches are under 0.4 mm", "a larger {--width}, or simpler shapes"))
    changes = int((plan.command == COLOR).sum())
    if len(plan.threads) > COLORS or changes > CHANGES:
        made.append((f"{len(plan.threads)} threads and {changes} changes of thread", "{--colors} 8 takes fewer"))
    machine = MACHINES.get(piece.params.machine or "")
    if machine is not None and 1 < machine.needles < len(plan.threads):
        what = f"{len(plan.threads)} threads, and {machine.needles} needles on {piece.params.machine}"
        made.append((what, "{--colors} " + f"{machine.needles} takes fewer"))
    closed, at = _holes(piece)
    if closed:
        made.append(
            (
                f"{closed} holes are so small that thread closes them, as at {_at(at)}"
                if closed > 1
                else f"a hole is so small that thread closes it, at {_at(at)}",
                "with a larger {--width} they stay open; else they are sewn over",
            )
        )
    loose, at = _loose(piece)
    if loose > LOOSE:
        made.append((f"{loose:.0f} mm of thread lie uncut over the cloth at {_at(at)}", "a shorter {--trim}"))
    return made


def crowded(piece: Piece) -> tuple[Array, Array]:
    """The mm² that are too full: (K, 2) their lower corners, and (K,) 1 for too many needle points, 2 for too many covers."""
    plan = piece.plan
    sewn = plan.command == STITCH
    cell, held = np.unique(np.floor(plan.xy[sewn]).astype(int), axis=0, return_counts=True)
    pointed = cell[held > POINTS].astype(float)
    grid, low = _cover_map(piece, np.flatnonzero(sewn[1:]) + 1)
    r, c = np.nonzero(grid > COVERS)
    covered = np.c_[c, r] + low
    return np.concatenate([pointed, covered]), np.r_[np.full(len(pointed), 1), np.full(len(covered), 2)]


def _holes(piece: Piece) -> tuple[int, Array]:
    """How many holes of areas are so small that thread closes them, and the place of the first."""
    count, where = 0, np.zeros(2)
    for region in piece.regions:
        parts = region.paths.parts
        if region.role != "area" or parts is None:
            continue
        for first, past in zip(parts[:-1].tolist(), parts[1:].tolist()):
            for k in range(first + 1, past):
                ring = region.paths[k]
                x, y = ring.T
                area = abs(float((x[:-1] * np.diff(y) - y[:-1] * np.diff(x)).sum())) / 2
                edge = float(np.hypot(*np.diff(ring, axis=0).T).sum())
                if 2 * area / max(edge, 1e-9) < HOLE / 2:
                    where = ring.mean(axis=0) if not count else where
                    count += 1
    return count, where


def _at(p: Array) -> str:
    return f"({p[0]:.0f}, {p[1]:.0f})"


def _covers(piece: Piece, end: Array) -> tuple[float, Array]:
    """The most covers of thread in the mean of 3 x 3 cells of 1 mm, and where."""
    grid, low = _cover_map(piece, end)
    r, c = np.unravel_index(int(grid.argmax()), grid.shape)
    return float(grid[r, c]), low + np.array([c + 0.5, r + 0.5])


def _cover_map(piece: Piece, end: Array) -> tuple[Array, Array]:
    """Covers of thread in the mean of 3 x 3 mm round each mm² (rows, columns), and the map's lower corner."""
    from scipy.ndimage import uniform_filter

    plan = piece.plan
    low, high = plan.xy.min(axis=0) - 2, plan.xy.max(axis=0) + 2
    lines = np.c_[plan.xy[end - 1], plan.xy[end]]
    bounds = (float(low[0]), float(low[1]), float(high[0]), float(high[1]))
    grid = uniform_filter(density_map(lines, np.ones(len(lines)), bounds, 1.0), 3) * piece.params.thread
    return grid, low


def _loose(piece: Piece) -> tuple[float, Array]:
    """The longest move between two needle points on which thread is not cut, and where it begins."""
    plan = piece.plan
    best, where = 0.0, np.zeros(2)
    needle = np.flatnonzero(plan.command == STITCH)
    cuts = np.cumsum((plan.command == TRIM) | (plan.command == COLOR))
    jumps = np.cumsum(plan.command == JUMP)
    moved = (np.diff(jumps[needle]) > 0) & (np.diff(cuts[needle]) == 0)
    if moved.any():
        far = np.hypot(*np.diff(plan.xy[needle], axis=0).T) * moved
        best, where = float(far.max()), plan.xy[needle[int(far.argmax())]]
    return best, where
