"""Six models of our own, for the page of models: solids joined softly, as closed meshes in colours, y up and their front ahead.

python docs/models.py FOLDER writes teddy.ply, whale.ply, cactus.ply, cup.ply, pear.ply and snail.ply (scikit-image, of the extra dev).
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np

from tambour import files
from tambour.core.check import Array
from tambour.core.mesh import Mesh

Solid = Callable[[Array], Array]
Coloured = tuple[Solid, tuple[int, int, int]]

BROWN, SAND, BLUE, WHITE = (150, 100, 60), (236, 214, 170), (70, 110, 170), (240, 238, 232)
BLACK = (24, 22, 22)
GREEN, POT, RED, PEAR, ROSE = (90, 140, 80), (190, 110, 80), (190, 50, 50), (190, 190, 70), (220, 140, 150)


def ball(at: tuple[float, float, float], size: tuple[float, float, float]) -> Solid:
    """An ellipsoid about ``at`` with half axes ``size``."""
    centre, half = np.array(at), np.array(size)

    def solid(p: Array) -> Array:
        q = (p - centre) / half
        r = np.sqrt((q**2).sum(-1))
        return np.asarray((r - 1.0) * r / np.maximum(np.sqrt((q**2 / half**2).sum(-1)), 1e-9) * (r > 0))

    return solid


def rod(a: tuple[float, float, float], b: tuple[float, float, float], ra: float, rb: float | None = None) -> Solid:
    """A rod with round ends from ``a`` to ``b``, its radius going over from ``ra`` to ``rb``."""
    p0, p1 = np.array(a), np.array(b)
    end = ra if rb is None else rb

    def solid(p: Array) -> Array:
        t = np.clip(((p - p0) @ (p1 - p0)) / ((p1 - p0) @ (p1 - p0)), 0.0, 1.0)
        return np.asarray(np.sqrt(((p - p0 - t[..., None] * (p1 - p0)) ** 2).sum(-1)) - (ra + t * (end - ra)))

    return solid


def mirrored(solid: Solid) -> Solid:
    """A solid and its mirror image, left and right."""
    return lambda p: np.minimum(solid(p), solid(p * np.array([-1.0, 1.0, 1.0])))


def mesh(parts: list[Coloured], soft: float, size: float, hollow: Solid | None = None, cells: int = 84) -> Mesh:
    """The closed surface of ``parts`` joined softly, each corner in the colour of the part that is nearest; less ``hollow``."""
    from skimage.measure import marching_cubes

    axis = np.linspace(-size, size, cells)
    grid = np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), -1)
    every = np.stack([solid(grid) for solid, _ in parts])
    low = every.min(0)
    field = low - soft * np.log(np.exp(-(every - low) / soft).sum(0))
    if hollow is not None:
        field = np.maximum(field, -hollow(grid))
    x, faces, _, _ = marching_cubes(field, 0.0)
    x = x / (cells - 1) * 2.0 * size - size
    near = np.stack([solid(x) for solid, _ in parts]).argmin(0)
    color = np.array([c for _, c in parts], np.uint8)[near]
    return Mesh(10.0 * x, faces[:, ::-1].copy(), color=color)


def teddy() -> Mesh:
    """A teddy that stands."""
    return mesh(
        [
            (ball((0, -1.6, 0), (2.1, 2.4, 1.9)), BROWN),
            (ball((0, 2.5, 0.2), (2.1, 1.9, 1.9)), BROWN),
            (ball((0, 2.0, 1.9), (0.95, 0.8, 0.75)), SAND),
            (mirrored(ball((0.9, 3.1, 2.0), (0.34, 0.34, 0.34))), BLACK),
            (ball((0, 2.3, 2.72), (0.34, 0.3, 0.3)), BLACK),
            (mirrored(ball((1.7, 4.2, 0.1), (0.85, 0.85, 0.5))), BROWN),
            (mirrored(rod((1.9, -0.2, 0.4), (3.6, -1.9, 0.9), 0.75, 0.8)), BROWN),
            (mirrored(rod((1.0, -3.0, 0.3), (1.4, -5.0, 0.7), 0.95, 1.0)), SAND),
        ],
        0.12,
        6.6,
    )


def whale() -> Mesh:
    """A whale with flukes and fins, its belly white."""
    return mesh(
        [
            (rod((0, 0.2, 1.6), (0, 1.0, -4.6), 2.5, 0.7), BLUE),
            (ball((0, -0.5, 1.6), (2.2, 2.15, 2.5)), WHITE),
            (mirrored(ball((1.7, 1.38, 3.2), (0.28, 0.28, 0.28))), BLACK),
            (mirrored(ball((1.5, 1.2, -5.6), (1.5, 0.45, 0.9))), BLUE),
            (mirrored(rod((2.0, -0.7, 1.2), (4.0, -1.5, 0.2), 0.75, 0.5)), BLUE),
        ],
        0.15,
        7.2,
    )


def cactus() -> Mesh:
    """A cactus with two arms in a pot, a flower on top."""
    return mesh(
        [
            (rod((0, -1.5, 0), (0, 3.4, 0), 1.6, 1.45), GREEN),
            (rod((1.2, 0.2, 0), (3.0, 0.6, 0), 0.75), GREEN),
            (rod((3.0, 0.6, 0), (3.1, 2.4, 0), 0.75), GREEN),
            (rod((-1.2, 1.2, 0), (-2.8, 1.5, 0), 0.7), GREEN),
            (rod((-2.8, 1.5, 0), (-2.9, 2.9, 0), 0.7), GREEN),
            (ball((0, 5.2, 0), (0.8, 0.6, 0.8)), ROSE),
            (ball((0, -3.4, 0), (2.6, 1.9, 2.6)), POT),
        ],
        0.12,
        6.2,
    )


def _about(p: Array) -> Array:
    """How far points lie from the upright axis."""
    return np.asarray(np.sqrt(p[..., 0] ** 2 + p[..., 2] ** 2))


def cup() -> Mesh:
    """A beaker: a thick wall about a hollow."""

    def outer(p: Array) -> Array:
        return np.asarray(np.maximum(_about(p) - 3.0 - 0.08 * p[..., 1], np.abs(p[..., 1]) - 3.2))

    def inner(p: Array) -> Array:
        return np.asarray(np.maximum(_about(p) - 2.0 - 0.08 * p[..., 1], -(p[..., 1] + 2.0)))

    return mesh([(outer, RED)], 0.1, 4.6, inner)


def pear() -> Mesh:
    """A pear with its stalk."""
    return mesh(
        [
            (ball((0, -1.4, 0), (2.8, 2.6, 2.8)), PEAR),
            (ball((0, 1.6, 0), (1.6, 2.3, 1.6)), PEAR),
            (rod((0, 3.6, 0), (0.4, 5.0, 0), 0.42), BROWN),
        ],
        0.45,
        5.8,
    )


def snail() -> Mesh:
    """A snail with its shell and two horns."""
    return mesh(
        [
            (rod((0, -2.0, -3.8), (0, -2.0, 2.6), 0.9, 1.15), SAND),
            (rod((0, -1.8, 2.6), (0, 0.2, 4.0), 1.1, 1.15), SAND),
            (mirrored(rod((0.5, 0.9, 4.2), (1.1, 2.8, 4.6), 0.4)), SAND),
            (mirrored(ball((0.5, 0.55, 5.18), (0.24, 0.24, 0.24))), BLACK),
            (ball((0, 0.7, -0.9), (1.9, 2.6, 2.6)), ROSE),
        ],
        0.12,
        6.0,
    )


MODELS = {"teddy": teddy, "whale": whale, "cactus": cactus, "cup": cup, "pear": pear, "snail": snail}

if __name__ == "__main__":
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for name, make in MODELS.items():
        files.write(make(), folder / f"{name}.ply", "Mesh")
        print(f"wrote {folder / name}.ply")
