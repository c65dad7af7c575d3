"""Tubes: closed, round, untwisted, each strand its own."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from tambour.core.paths import Paths
from tambour.core.strands import Strands
from tambour.geometry import tube
from tambour.geometry.surface import closed, face_normals, vertex_normals


def helix(turns: float = 3, points: int = 200, radius: float = 10.0) -> np.ndarray:
    t = np.linspace(0, 2 * np.pi * turns, points)
    return np.stack([radius * np.cos(t), 0.8 * t, radius * np.sin(t)], axis=1)


def strands(*lines: np.ndarray, radius: float = 1.0) -> Strands:
    paths = Paths.of(lines, 3)
    color = np.arange(3 * len(lines), dtype=np.uint8).reshape(-1, 3)
    return Strands(paths, np.full(len(paths.coords), radius), color)


def volume(mesh) -> float:  # type: ignore[no-untyped-def]
    a, b, c = (mesh.vertices[mesh.faces[:, k]] for k in range(3))
    return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)


@pytest.mark.parametrize("sides", [3, 6, 16])
def test_tubes_are_closed_and_turned_outwards(sides: int) -> None:
    mesh = tube.sweep(strands(helix(), helix(1, 40, 30)), sides=sides)
    assert closed(mesh.faces)
    # A closed mesh of two pieces has Euler characteristic 4.
    assert len(mesh.vertices) - len(mesh.faces) * 3 // 2 + len(mesh.faces) == 4
    assert volume(mesh) > 0
    np.testing.assert_array_equal(np.unique(mesh.color, axis=0), [[0, 1, 2], [3, 4, 5]])


def test_volume_is_that_of_a_round_tube() -> None:
    line = helix(2, 2000)
    length = np.linalg.norm(np.diff(line, axis=0), axis=1).sum()
    assert volume(tube.sweep(strands(line), sides=64)) == pytest.approx(np.pi * (length + 1.3), rel=0.01)


def frames_plainly(points: np.ndarray) -> np.ndarray:
    """Each normal is the last one turned by the smallest rotation that takes one tangent to the next."""
    tangent = np.gradient(points, axis=0)
    tangent[0], tangent[-1] = points[1] - points[0], points[-1] - points[-2]
    tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
    made = [np.array([0.0, 1, 0]) - tangent[0, 1] * tangent[0]]
    made[0] /= np.linalg.norm(made[0])
    for a, b in pairwise(tangent):
        axis = np.cross(a, b)
        rotated = made[-1] + np.cross(axis, made[-1]) + np.cross(axis, np.cross(axis, made[-1])) / (1 + a @ b)
        made.append(rotated / np.linalg.norm(rotated))
    return np.array(made)


def test_frames_do_not_twist() -> None:
    line = helix(2, 800)
    tangent, across = np.zeros_like(line), np.zeros_like(line)
    tube.frames(line, np.array([0, 800]), tangent, across, np.zeros((0, 3)))
    np.testing.assert_allclose((tangent * across).sum(1), 0, atol=1e-12)
    np.testing.assert_allclose(np.linalg.norm(across, axis=1), 1, atol=1e-12)
    np.testing.assert_allclose(across, frames_plainly(line), atol=2e-3)


def test_odd_strands_are_swept() -> None:
    point, still = np.zeros((1, 3)), np.zeros((3, 3))
    back = np.array([[0, 0, 0], [0, 5, 0], [0, 0, 0.0]])
    mesh = tube.sweep(strands(point, still, back, helix()), sides=5)
    assert np.isfinite(mesh.vertices).all() and closed(mesh.faces)
    assert len(tube.sweep(strands(point)).faces) == 0


def test_uv_counts_turns() -> None:
    line = np.stack([np.linspace(0, 60, 50), np.zeros(50), np.zeros(50)], axis=1)
    mesh = tube.sweep(strands(line), lay=6.0)
    assert mesh.uv is not None
    assert mesh.uv[:, 0].max() == pytest.approx(10, abs=0.2) and mesh.uv[:, 1].max() == pytest.approx(5 / 6)


def test_plies_wind_about_the_tube() -> None:
    line = np.stack([np.linspace(0, 24, 300), np.zeros(300), np.zeros(300)], axis=1)
    mesh = tube.sweep(strands(line), sides=48, plies=3, lay=6.0)
    inside = (mesh.vertices[:, 0] > 2) & (mesh.vertices[:, 0] < 22)
    points, uv = mesh.vertices[inside], mesh.uv[inside]
    reach = np.hypot(points[:, 1], points[:, 2])
    assert 0.7 < reach.min() < 0.85 and 1.05 < reach.max() < 1.2
    # As deep as asked, 0.3 radii, however round their bottom is; and there is as much yarn as without them.
    assert reach.max() - reach.min() == pytest.approx(0.3, abs=0.002)
    assert reach.mean() == pytest.approx(1.0, abs=0.002)
    # Farthest from the axis where the ply's number of turns is whole.
    phase = (3 * (uv[:, 1] - uv[:, 0])) % 1
    assert np.abs(phase[reach > 1.08] - np.round(phase[reach > 1.08])).max() < 0.2


@pytest.mark.parametrize("climb", [6.0, -6.0])
def test_a_twist_is_even_as_seen_from_outside(climb: float) -> None:
    """A helix to one side opens its plies, one to the other closes them: of a V's legs one looked untwisted, the other a corkscrew."""
    t = np.linspace(0.0, 12.0, 600)
    line = np.stack([6.0 * np.cos(t), climb * t, 6.0 * np.sin(t)], axis=1)
    outward = np.stack([np.cos(t), np.zeros(600), np.sin(t)], axis=1)

    def winds(**more: np.ndarray) -> float:
        """Turns of the twist a millimetre, as seen on the outer side."""
        mesh = tube.sweep(strands(line), sides=48, lay=10.0, **more)
        rings, uv = (each[1 + 48 : -1 - 48].reshape(600, 48, -1) for each in (mesh.vertices, mesh.uv))
        outer = ((rings - line[:, None]) * outward[:, None]).sum(2).argmax(1)
        at = np.arange(600), outer
        phase = np.unwrap(uv[*at, 0] - uv[*at, 1], period=1.0)
        return float(np.polyfit(np.hypot(6.0, climb) * t, phase, 1)[0])

    assert abs(winds() - 0.1) > 0.01
    assert winds(outward=outward) == pytest.approx(0.1, rel=0.02)


def test_normals_against_faces() -> None:
    mesh = tube.sweep(strands(helix()), sides=24)
    normals = vertex_normals(mesh.vertices, mesh.faces)
    flat = face_normals(mesh.vertices, mesh.faces)
    expected = np.zeros_like(normals)
    a, b, c = (mesh.vertices[mesh.faces[:, k]] for k in range(3))
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1, keepdims=True)
    for k in range(3):
        np.add.at(expected, mesh.faces[:, k], flat * area)
    np.testing.assert_allclose(normals, expected / np.linalg.norm(expected, axis=1, keepdims=True), atol=1e-9)


def test_a_missing_face_is_noticed() -> None:
    mesh = tube.sweep(strands(helix()))
    assert closed(mesh.faces) and not closed(mesh.faces[1:])
    turned = mesh.faces.copy()
    turned[5] = turned[5, ::-1]
    assert not closed(turned)
