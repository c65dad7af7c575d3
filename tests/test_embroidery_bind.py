"""Binding and riding: against brute force, on cloth that is folded, vertical or closed."""

from __future__ import annotations

import numpy as np
import pytest

from tambour.core.mesh import Binding, Mesh
from tambour.embroidery.cloth.bind import bind_nearest, bind_ray, crossings, deform, net
from tambour.embroidery.cloth.sheets import sheet
from tambour.geometry.closest import nearest, on_triangle, tree
from tambour.geometry.surface import vertex_normals


def bumpy(amplitude: float = 5.0) -> Mesh:
    flat = sheet(60, 45)
    v = flat.vertices.copy()
    v[:, 2] = amplitude * np.sin(v[:, 0] / 9) * np.cos(v[:, 1] / 7)
    return Mesh(v, flat.faces, uv=flat.uv)


def ball(radius: float = 30.0, n: int = 24) -> Mesh:
    a, b = np.meshgrid(np.linspace(0, 2 * np.pi, 2 * n, endpoint=False), np.linspace(0, np.pi, n + 1)[1:-1])
    v = radius * np.stack([np.sin(b) * np.cos(a), np.cos(b), np.sin(b) * np.sin(a)], -1).reshape(-1, 3)
    v = np.vstack([v, [[0, radius, 0], [0, -radius, 0]]])
    at = np.arange(2 * n * (n - 1)).reshape(n - 1, 2 * n)
    right = np.roll(at, -1, axis=1)
    f = [np.stack([at[:-1], right[:-1], right[1:]], -1).reshape(-1, 3)]
    f += [np.stack([at[:-1], right[1:], at[1:]], -1).reshape(-1, 3)]
    f += [np.stack([np.full(2 * n, len(v) - 2), right[0], at[0]], -1)]
    f += [np.stack([np.full(2 * n, len(v) - 1), at[-1], right[-1]], -1)]
    return Mesh(v, np.vstack(f))


def laid(mesh: Mesh):
    corner = mesh.vertices[mesh.faces]
    return net(corner[..., :2], corner[..., 2], np.arange(len(mesh.faces)), mesh.faces)


def where(mesh: Mesh, b: Binding) -> np.ndarray:
    weight = np.column_stack([1 - b.uv.sum(axis=1), b.uv])
    return (weight[..., None] * mesh.vertices[mesh.faces[b.face]]).sum(axis=1)


def ride_plainly(b: Binding, mesh: Mesh, vertices: np.ndarray) -> np.ndarray:
    """The NumPy twin of ``deform``."""
    normals = vertex_normals(vertices, mesh.faces)
    weight = np.column_stack([1 - b.uv.sum(axis=1), b.uv])
    f = mesh.faces[b.face]
    n = np.einsum("qi,qik->qk", weight, normals[f])
    return np.einsum("qi,qik->qk", weight, vertices[f]) + b.elevation[:, None] * n / np.linalg.norm(n, axis=1)[:, None]


def test_rays_hit_what_lies_below():
    mesh, rng = bumpy(), np.random.default_rng(0)
    points = rng.uniform([-30, -22.5], [30, 22.5], (4000, 2))
    b = bind_ray(laid(mesh), points, np.zeros(4000))
    assert (b.face >= 0).all()
    assert np.abs(where(mesh, b)[:, :2] - points).max() < 1e-9
    assert (bind_ray(laid(mesh), np.array([[31.0, 0], [-90, 400]]), np.zeros(2)).face == -1).all()


def test_the_first_of_several_layers_is_hit():
    flat = sheet(40, 40)
    v = np.vstack([flat.vertices, flat.vertices + np.array([0, 0, 7.0]), flat.vertices - np.array([0, 0, 3.0])])
    n = len(flat.vertices)
    mesh = Mesh(v, np.vstack([flat.faces, flat.faces + n, flat.faces + 2 * n]))
    b = bind_ray(laid(mesh), np.random.default_rng(0).uniform(-20, 20, (500, 2)), np.zeros(500))
    assert np.allclose(where(mesh, b)[:, 2], 7)


def test_crossings_are_all_edges_and_only_edges():
    mesh, rng = bumpy(), np.random.default_rng(3)
    n = laid(mesh)
    a, b = rng.uniform([-29, -22], [29, 22], (300, 2)), rng.uniform([-29, -22], [29, 22], (300, 2))
    offsets, t = crossings(n, a, b)
    for s in range(300):
        cuts = np.r_[0, t[offsets[s] : offsets[s + 1]], 1]
        assert (np.diff(cuts) > 0).all()
        # Between two cuts the segment lies in one face: its ends and its middle are on that face.
        middle = a[s] + np.outer((cuts[1:] + cuts[:-1]) / 2, b[s] - a[s])
        face = bind_ray(n, middle, np.zeros(len(middle))).face
        for k, f in enumerate(face):
            plane = n.plane[f]
            for at in (cuts[k], cuts[k + 1]):
                p = a[s] + at * (b[s] - a[s])
                u, v = plane[0] + plane[1:3] @ p, plane[3] + plane[4:6] @ p
                assert min(u, v, 1 - u - v) > -1e-6


def test_deforming_keeps_the_elevation_and_agrees_with_numpy():
    mesh, rng = bumpy(), np.random.default_rng(4)
    points, lift = rng.uniform(-20, 20, (3000, 2)), rng.uniform(-0.2, 0.7, 3000)
    b = bind_ray(laid(mesh), points, lift)
    moved = mesh.vertices.copy()
    moved[:, 2] += 9 * np.sin(moved[:, 0] / 6)
    normals = vertex_normals(moved, mesh.faces)
    made = deform(b, mesh.faces, moved, normals)
    assert np.allclose(made, ride_plainly(b, mesh, moved), atol=1e-12)
    on = deform(Binding(b.face, b.uv, np.zeros(3000)), mesh.faces, moved, normals)
    assert np.abs(np.linalg.norm(made - on, axis=1) - np.abs(lift)).max() < 1e-5


@pytest.mark.slow
def test_nearest_point_against_brute_force():
    mesh, rng = ball(), np.random.default_rng(5)
    points = rng.uniform(-40, 40, (150, 3))
    face, uv, far = nearest(tree(mesh.vertices, mesh.faces), points)
    corner = np.ascontiguousarray(mesh.vertices[mesh.faces].reshape(-1, 9))
    every = np.array([[on_triangle(corner, f, *p)[0] for f in range(len(corner))] for p in points])
    assert np.allclose(far**2, every.min(axis=1), atol=1e-9)
    assert np.allclose(np.linalg.norm(where(mesh, Binding(face, uv, far)) - points, axis=1), far)


@pytest.mark.parametrize("kind", ["vertical", "folded", "closed"])
def test_nearest_binding_where_no_ray_falls(kind):
    """Points that stand 0.4 mm off a surface come back where they were, to the bend of the normals."""
    flat = sheet(40, 40)
    if kind == "closed":
        mesh = ball(30, 60)
    else:
        v = flat.vertices.copy()
        if kind == "vertical":
            v = v[:, [1, 0, 2]][:, [2, 1, 0]]  # stands along y and z
        else:  # an S of three layers, one behind the other
            s = v[:, 0] + 20
            v = np.stack([8 * np.sin(s / 40 * 3 * np.pi), v[:, 1], s], axis=1)
        mesh = Mesh(v, flat.faces)
    normals = vertex_normals(mesh.vertices, mesh.faces)
    rng = np.random.default_rng(6)
    n = 800
    face = rng.integers(0, len(mesh.faces), n)
    uv = rng.dirichlet([2, 2, 2], n)[:, 1:]
    true = Binding(face.astype(np.int32), uv, rng.choice([0.4, -0.2], n))
    points = deform(true, mesh.faces, mesh.vertices, normals)
    found = bind_nearest(mesh.vertices, mesh.faces, normals, points)
    assert np.abs(found.elevation - true.elevation).max() < 0.002
    assert np.abs(deform(found, mesh.faces, mesh.vertices, normals) - points).max() < 0.002
