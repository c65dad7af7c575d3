"""Whole: a mesh as one closed surface or several, its corners welded; what cannot be worked is told in one line."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from tambour.core.check import Array
from tambour.core.errors import TambourError
from tambour.core.mesh import Mesh

if TYPE_CHECKING:
    from tambour.core.picture import Picture

WELD = 1e-5
"""Corners nearer to each other than this share of the size are one."""
MOST = 600_000
"""The most triangles that are looked at."""
THIN = 1e-3
"""Thinner than this share of its length a model is flat: it has no inside."""
FLAT = "the model is flat: it holds nothing", "give it thickness; stuffing needs an inside"
CRUMB = 0.01
"""A body with a smaller share of the area than this is left out, with a word."""
HUNG = 0.01
"""Triangles that hang on a skin by an edge are left out where they are less than this share of its surface; more is a sheet that was meant."""


def bodies(mesh: Mesh, tell: list[str]) -> list[tuple[Array, Array, Array]]:
    """Every closed body of ``mesh``: vertices (V, 3), faces (F, 3), and of every vertex the one of the mesh that it was.

    What is left out or mended is told to ``tell``. TambourError, in one line, for what is no closed surface, or has handles.
    """
    if len(mesh.faces) > MOST:
        raise TambourError(
            f"the model has {len(mesh.faces):,} triangles, more than {MOST:,}",
            hint="simplify it first; stitches are far coarser",
        )
    if len(mesh.faces) < 4 or not np.isfinite(mesh.vertices).all():
        raise TambourError("the model is no closed surface: it has fewer than four triangles, or corners nowhere")
    used = corners(mesh.faces)
    extent = np.ptp(mesh.vertices[used], axis=0)
    size = float(extent.max())
    if size <= 0.0 or not np.isfinite(size):
        raise TambourError("all corners of the model lie in one place", hint="export it once more")
    if extent.min() < THIN * size:
        raise TambourError(FLAT[0], hint=FLAT[1])
    # About its own middle: far from it volumes drown in the last bits.
    x, faces, origin = welded(mesh.vertices - mesh.vertices[used].mean(0), mesh.faces, WELD * size)
    faces = faces[(faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2]) & (faces[:, 2] != faces[:, 0])]
    faces = faces[np.sort(np.unique(np.sort(faces, axis=1), axis=0, return_index=True)[1])]
    if len(faces) < 4:
        raise TambourError(
            "the model has no surface: all its triangles are lines or points", hint="export it once more"
        )
    found = []
    label = pieces(len(x), faces)
    areas = area(x, faces)
    total = float(areas.sum())
    small = 0
    for k in np.unique(label[faces[:, 0]]):
        mine = faces[label[faces[:, 0]] == k]
        share = float(areas[label[faces[:, 0]] == k].sum()) / max(total, 1e-300)
        if share < CRUMB:
            small += 1
            continue
        found.append((share, mine))
    if small:
        tell.append(f"{small} small bodies of the model are left out: together they are hardly a stitch")
    if not found:
        raise TambourError(
            f"the model is {small:,} pieces that hang together nowhere",
            hint="weld its corners, then export it once more",
        )
    found.sort(key=lambda item: -item[0])
    made = []
    for _, mine in found:
        here = corners(mine)
        number = np.full(len(x), -1)
        number[here] = np.arange(len(here))
        made.append(_closed(x[here], number[mine], origin[here], tell))
    return _joined(made, tell) if len(made) > 1 else made


def _joined(made: list[tuple[Array, Array, Array]], tell: list[str]) -> list[tuple[Array, Array, Array]]:
    """Several bodies, those that go into each other as one; told is what was done, and of what stays apart that nothing sews it on."""
    from tambour.crochet.model.united import overlapping, united

    together = overlapping(made)
    for group in together:
        if len(group) > 1:
            tell.append(
                f"{len(group)} bodies of the model go into each other: they are worked as the one skin that is seen of them"
            )
    if len(together) > 1:
        tell.append(
            f"the model is {len(together)} bodies that do not hang together: each is a piece of its own, and nothing says where it is sewn on; "
            "let them go into each other by a stitch where they are to be one"
        )
    return [
        made[group[0]] if len(group) == 1 else _closed(*united([made[k] for k in group]), tell) for group in together
    ]


def welded(vertices: Array, faces: Array, near: float) -> tuple[Array, Array, Array]:
    """The mesh with corners that share a cell of width ``near`` as one, and the first corner that each of them was."""
    grid = np.round(vertices / near).astype(np.int64)
    _, first, inverse = np.unique(grid, axis=0, return_index=True, return_inverse=True)
    return np.ascontiguousarray(vertices[first], np.float64), inverse.reshape(-1)[faces].astype(np.int64), first


def corners(faces: Array) -> Array:
    """The vertices (K,) that faces (F, 3) have, rising."""
    return np.flatnonzero(np.bincount(faces.ravel()))


def pieces(count: int, faces: Array) -> Array:
    """The connected piece of every vertex (V,)."""
    from tambour.crochet.settle.arrange import labels

    return labels(count, np.concatenate([faces[:, :2], faces[:, 1:]]))


def area(vertices: Array, faces: Array) -> Array:
    """The area (F,) of every face."""
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    return np.asarray(0.5 * np.sqrt((np.cross(b - a, c - a) ** 2).sum(1)))


def volume(vertices: Array, faces: Array) -> float:
    """The volume within closed faces, negative where they are inside out."""
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    return float((a * np.cross(b, c)).sum()) / 6.0


def _closed(x: Array, faces: Array, origin: Array, tell: list[str]) -> tuple[Array, Array, Array]:
    extent = np.sort(np.ptp(x, axis=0))
    faces = _unflapped(x, faces, tell)
    count = _shared(faces)
    if more := len(np.unique(count[0][count[1] > 2])):
        raise TambourError(
            f"the model is no single skin: {more} edge{'s belong' if more > 1 else ' belongs'} to more than two triangles",
            hint="join its parts into one body (a boolean union, or a remesh) and remove walls inside it",
        )
    if (count[1] == 1).any():
        x, faces, origin = closed_up(x, faces, origin, tell)
    faces = _oriented(faces)
    if volume(x, faces) < 0.0:
        faces = faces[:, ::-1].copy()
    if extent[0] < THIN * extent[2] or volume(x, faces) < 1e-5 * float(area(x, faces).sum()) ** 1.5:
        raise TambourError(FLAT[0], hint=FLAT[1])
    # Corners where two skins only touch are two corners.
    x, faces, origin = _parted(x, faces, origin)
    label = pieces(len(x), faces)
    if label.max() > 0:
        keep = int(np.bincount(label[faces[:, 0]], area(x, faces)).argmax())
        faces = faces[label[faces[:, 0]] == keep]
        here = corners(faces)
        faces = np.searchsorted(here, faces)
        x, origin = x[here], origin[here]
        tell.append("what hung on the model by a single corner is left out")
    holes = 1 - (len(x) - 3 * len(faces) // 2 + len(faces)) // 2
    if holes > 0:
        raise Handles(x, faces, holes)
    return x, faces, origin


def _shared(faces: Array) -> tuple[Array, Array]:
    """Of every side (F, 3) of the faces the number of its edge, and how many faces have that."""
    pairs = np.sort(np.concatenate([faces[:, :2], faces[:, 1:], faces[:, ::2]]), axis=1)
    _, place, count = np.unique(pairs, axis=0, return_inverse=True, return_counts=True)
    place = place.reshape(3, -1).T
    return place, count[place]


def _unflapped(x: Array, faces: Array, tell: list[str]) -> Array:
    """The faces without those few that only hang on a skin: on edges that are whole without them, with nothing on their other sides."""
    left = faces
    while True:
        _, count = _shared(left)
        hangs = (count > 2).any(1) & (count != 2).all(1) & (count == 1).any(1)
        if not hangs.any() or hangs.all():
            break
        left = left[~hangs]
    if area(x, left).sum() < (1.0 - HUNG) * area(x, faces).sum():
        return faces
    if less := len(faces) - len(left):
        tell.append(
            f"{less} triangle{'s' if less > 1 else ''} hanging on the model by an edge {'are' if less > 1 else 'is'} left out"
        )
    return left


class Handles(TambourError):
    """A body with handles: its surface, and how many there are."""

    def __init__(self, vertices: Array, faces: Array, count: int) -> None:
        self.vertices, self.faces, self.count = vertices, faces, count
        loop = where(vertices, faces)
        at = loop.mean(0)
        low, high = vertices.min(0), vertices.max(0)
        share = np.round(100 * (at - low) / np.maximum(high - low, 1e-12)).astype(int)
        words = "a handle" if count == 1 else f"{count} handles"
        super().__init__(
            f"the model has {words} (holes through it), the tightest near {share[0]} % of its width, {share[1]} % of its "
            f"height and {share[2]} % of its depth: rounds cannot be worked through it",
            hint="fill the hole, or cut the handle off and model it as a body of its own",
        )
        self.seen = "handles", lambda: marked(vertices, faces, loop)


def where(vertices: Array, faces: Array) -> Array:
    """A short loop (K, 3) around a handle of a closed surface of genus 1 or more: where two fronts meet."""
    from tambour.crochet.model.geodesic import distances, girth, lines

    d = distances(vertices, faces, np.array([int(vertices[:, 1].argmin())]))
    best, found = np.inf, vertices
    past = 1
    for value in np.linspace(0.02, 0.98, 49) * float(d[np.isfinite(d)].max()):
        loops = lines(vertices, faces, d, float(value))
        if len(loops) != past and len(loops) > 1:
            short = min(loops, key=girth)
            if girth(short) < best:
                best, found = girth(short), short
        past = len(loops)
    return found


RED, GREY = (196, 54, 40), (206, 202, 194)
"""A handle's tightest place in a picture, and the rest of the model."""


def marked(vertices: Array, faces: Array, loop: Array) -> Picture:
    """A picture of a surface with what lies about a loop (K, 3) of it in red: from where the loop is nearest, and from its side."""
    from math import atan2, radians

    from tambour.core.picture import Picture
    from tambour.geometry.near import nearest
    from tambour.render.raster import picture

    size = float(np.ptp(vertices, axis=0).max())
    x, f, _ = refined(vertices, faces, 0.03 * size)
    near = nearest(x, loop)[0][:, 0] < 0.03 * size
    mesh = Mesh(x, f, color=np.where(near[:, None], RED, GREY).astype(np.uint8))
    off = loop.mean(0) - x.mean(0)
    ahead = atan2(float(off[0]), float(off[2]))
    sides = [
        picture(mesh, width=600, height=600, azimuth=ahead + turn, elevation=radians(20.0), ground=False).rgba
        for turn in (radians(20.0), radians(110.0))
    ]
    return Picture(np.concatenate(sides, axis=1))


def closed_up(x: Array, faces: Array, origin: Array, tell: list[str]) -> tuple[Array, Array, Array]:
    """The mesh with its small holes closed by fans; TambourError where it is open wide."""
    turned = np.concatenate([faces[:, :2], faces[:, 1:], faces[:, ::-2]])
    n = len(x)
    pairs = np.sort(turned, axis=1)
    _, place, count = np.unique(pairs, axis=0, return_inverse=True, return_counts=True)
    rim = turned[count[place.reshape(-1)] == 1]
    after: dict[int, list[int]] = {}
    for a, b in rim.tolist():
        after.setdefault(b, []).append(a)
    added, points, number = [], [], n
    total = float(area(x, faces).sum())
    holes = 0
    for begin in sorted(after):
        while after.get(begin):
            loop, seen, at = [begin], {begin}, after[begin].pop()
            while at not in seen and after.get(at):
                loop.append(at)
                seen.add(at)
                at = after[at].pop()
            if at in loop[1:]:  # holes that touch at a corner are two: the way up to it is walked again
                after[begin].append(loop[1])
                for one, other in pairwise(loop[1 : loop.index(at) + 1]):
                    after[one].append(other)
                loop = loop[loop.index(at) :]
            ring = x[loop]
            middle = ring.mean(0)
            across = 0.5 * np.sqrt((np.cross(ring - middle, np.roll(ring, -1, 0) - middle) ** 2).sum(1)).sum()
            if at != loop[0] or len(loop) < 3 or across > 0.1 * total:
                share = round(100 * across / max(total, 1e-300))
                raise TambourError(
                    f"the model is open: a hole with a rim of {len(loop)} edges, {share} % of the surface",
                    hint="close it (fill holes) in the program that it comes from",
                )
            added += [(loop[k], loop[(k + 1) % len(loop)], number) for k in range(len(loop))]
            points.append(middle)
            number += 1
            holes += 1
    tell.append(f"{holes} small hole{'s' if holes > 1 else ''} of the model {'were' if holes > 1 else 'was'} closed")
    made = np.concatenate([x, np.array(points)]), np.concatenate([faces, np.array(added)])
    return *made, np.concatenate([origin, np.full(len(points), origin[0])])


def _oriented(faces: Array) -> Array:
    """The faces of a connected surface, every edge run through once in each direction; TambourError for a Möbius strip."""
    count = len(faces)
    half = np.concatenate([faces[:, :2], faces[:, 1:], faces[:, ::-2]])
    owner = np.tile(np.arange(count), 3)
    pairs = np.sort(half, axis=1)
    order = np.lexsort((pairs[:, 1], pairs[:, 0]))
    a, b = order[0::2], order[1::2]
    same = (half[a] == half[b]).all(1)
    if not same.any():
        return faces
    flip = np.zeros(count, np.int64) - 1
    near: list[list[tuple[int, int]]] = [[] for _ in range(count)]
    for i, j, s in zip(owner[a].tolist(), owner[b].tolist(), same.tolist()):
        near[i].append((j, int(s)))
        near[j].append((i, int(s)))
    for begin in range(count):
        if flip[begin] >= 0:
            continue
        flip[begin] = 0
        stack = [begin]
        while stack:
            i = stack.pop()
            for j, s in near[i]:
                want = flip[i] ^ s
                if flip[j] < 0:
                    flip[j] = want
                    stack.append(j)
                elif flip[j] != want:
                    raise TambourError(
                        "the model has one side only, as a Möbius strip has", hint="close it, or give it thickness"
                    )
    faces = faces.copy()
    faces[flip == 1] = faces[flip == 1][:, ::-1]
    return faces


def _parted(x: Array, faces: Array, origin: Array) -> tuple[Array, Array, Array]:
    """The surface with corners where several fans of faces meet as one corner for each fan."""
    # Faces about a corner belong to one fan where they share an edge at it: corners of faces are joined across edges.
    count = len(faces)
    half = np.concatenate([faces[:, :2], faces[:, 1:], faces[:, ::-2]])
    start = np.concatenate([np.arange(count) * 3, np.arange(count) * 3 + 1, np.arange(count) * 3 + 2])
    end = np.concatenate([np.arange(count) * 3 + 1, np.arange(count) * 3 + 2, np.arange(count) * 3])
    pairs = np.sort(half, axis=1)
    order = np.lexsort((pairs[:, 1], pairs[:, 0]))
    a, b = order[0::2], order[1::2]
    from tambour.crochet.settle.arrange import labels

    fans = labels(3 * count, np.concatenate([np.column_stack([start[a], end[b]]), np.column_stack([end[a], start[b]])]))
    made = fans.reshape(-1, 3)
    _, first = np.unique(fans, return_index=True)
    corner = faces.ravel()[first]
    return x[corner], made, origin[corner]


def refined(x: Array, faces: Array, longest: float, most: int = 400_000) -> tuple[Array, Array, Array]:
    """The surface with no edge longer than ``longest``, and the two vertices (V, 2) of the given one that each lies between."""
    between = np.column_stack([np.arange(len(x))] * 2)
    for _ in range(16):
        pairs = np.sort(np.concatenate([faces[:, :2], faces[:, 1:], faces[:, ::-2]]), axis=1)
        edges, place = np.unique(pairs, axis=0, return_inverse=True)
        place = place.reshape(3, -1).T
        size = np.sqrt(((x[edges[:, 0]] - x[edges[:, 1]]) ** 2).sum(1))
        long = size > longest
        if not long.any() or len(faces) > most:
            break
        middle = np.full(len(edges), -1)
        middle[long] = len(x) + np.arange(int(long.sum()))
        x = np.concatenate([x, 0.5 * (x[edges[long, 0]] + x[edges[long, 1]])])
        between = np.concatenate([between, np.column_stack([between[edges[long, 0], 0], between[edges[long, 1], 1]])])
        m = middle[place]
        split = (m >= 0).sum(1)
        made = [faces[split == 0]]
        three, t = m[split == 3], faces[split == 3]
        made += [np.column_stack([t[:, k], three[:, k], three[:, (k + 2) % 3]]) for k in range(3)] + [three]
        for two in (1, 2):
            t, own = faces[split == two], m[split == two]
            lone = (own >= 0).argmax(1) if two == 1 else (own < 0).argmax(1)
            roll = (lone[:, None] + np.arange(3)) % 3
            t, own = np.take_along_axis(t, roll, 1), np.take_along_axis(own, roll, 1)
            a, b, c = t.T
            if two == 1:  # the edge ab is cut
                made += [np.column_stack([a, own[:, 0], c]), np.column_stack([own[:, 0], b, c])]
            else:  # ab is whole, bc and ca are cut
                p, q = own[:, 1], own[:, 2]
                made += [np.column_stack([p, c, q]), np.column_stack([a, b, p]), np.column_stack([a, p, q])]
        faces = np.concatenate(made)
    return x, faces, between
