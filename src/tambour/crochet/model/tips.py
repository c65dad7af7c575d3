"""Tips: how a model stands, where it is its own mirror image, and from where its rounds are best begun."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from tambour.core.check import Array
from tambour.crochet.model.distance import Target, spread
from tambour.crochet.model.faced import faced
from tambour.crochet.model.geodesic import about, distances, girth, lines
from tambour.crochet.model.ways import between, ringed
from tambour.crochet.model.whole import corners
from tambour.geometry.closest import nearest, tree
from tambour.geometry.motion import axes, turned
from tambour.geometry.stance import RESTS

SIDES: Final = {
    "top": (0.0, 1.0, 0.0),
    "bottom": (0.0, -1.0, 0.0),
    "front": (0.0, 0.0, 1.0),
    "back": (0.0, 0.0, -1.0),
    "left": (-1.0, 0.0, 0.0),
    "right": (1.0, 0.0, 0.0),
}
"""A side → where it lies: y is up, z ahead."""
ALIKE = 0.012
"""A model is its own mirror image where that is no farther off than this share of its size, on the average."""
DEEP, HEAD, FEET = 0.6, 0.15, 0.05
"""An animal is at least so deep for its height, its head lies so far to one end, and what it stands on so far to the other."""
FALLS, FIRM, WAYS = 0.02, 0.1, 48
"""A model falls over whose middle is hardly within what it stands on, as a share of its height, and is firm where it is well within it,
whichever of so many ways one looks."""
FACE, STANDS = 0.08, 0.01
"""What stands, by so much of its height within its feet and more, has its face where its small forms are, if those look and lie so far ahead
or behind; of what swims they are fins."""
STRIDE, NEARER = 0.2, 0.75
"""A model without a mirror has its head so far to one end of its width, and is so much nearer to its image across z than across x."""
LOST, WIDE, LEANING, HOLLOW = 4.0, 0.2, 0.5, 4.0
"""What it costs, in stitches that rings are off, that rounds leave all of a surface out, begin twice as wide as a tip is, lean as far as
can be, and begin inside of a hollow."""
BESIDE = 1.0
"""A tip so near to the mirror plane of its surface, in stitches, is in it: its rounds are as high on the one side as on the other."""
PAIRED, APART = 3, 0.45
"""How many tips are tried with another end, and how far from each other the two lie, as a share of the longest way."""


@dataclass(frozen=True, eq=False, slots=True)
class Mirror:
    """A plane in which a surface is its own mirror image: a point (3,) of it and its unit normal (3,)."""

    point: Array
    normal: Array

    def image(self, x: Array) -> Array:
        """Points (…, 3) in the mirror."""
        return np.asarray(x - 2.0 * self.off(x)[..., None] * self.normal)

    def moved(self, turn: Array, shift: Array) -> tuple[Array, Array]:
        """A turn (3, 3) and a shift (3,) in the mirror."""
        flip = np.eye(3) - 2.0 * self.normal[:, None] * self.normal
        return turned(turned(flip, turn.T), flip), turned(shift, flip)

    def off(self, x: Array) -> Array:
        """How far (…,) points lie to the side of the plane."""
        return np.asarray(((x - self.point) * self.normal).sum(-1))


def mirror(vertices: Array, faces: Array) -> Mirror | None:
    """The plane that a surface is symmetric about, of the three of its box and the three of its axes; None where none is.

    Of several the one across x comes first, then the one that fits best.
    """
    points = spread(vertices, faces, 400)
    found = tree(vertices, faces)
    middle = points.mean(0)
    size = float(np.sqrt((np.ptp(points, axis=0) ** 2).sum()))
    best: tuple[float, Mirror] | None = None
    for k, normal in enumerate([*np.eye(3), *axes(points)[1]]):
        plane = Mirror(middle, normal)
        off = float(nearest(found, plane.image(points))[2].mean()) / size
        if off > ALIKE:
            continue
        score = off + (0.0 if k == 0 else 0.5 * ALIKE)
        if best is None or score < best[0]:
            best = score, plane
    return None if best is None else best[1]


def level(vertices: Array, faces: Array, up: str | None) -> Array:
    """The rotation (3, 3) that stands a model up: y upwards. ``up``: the axis that is, or None to find out.

    y is up, unless the model is its own mirror image across y and not across x (then z is), or lies on a flat base across z
    and has none across y, as what comes from printers does, or would fall over on y and stands firmly on z.
    """
    z_up = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])
    x_up = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    if up is not None:
        return {"y": np.eye(3), "z": z_up, "x": x_up}[up]
    flat = [_base(vertices, faces, k) for k in range(3)]
    plane = mirror(vertices, faces)
    if plane is not None and abs(plane.normal[1]) > 0.9:
        return z_up
    if flat[2] > 0.06 and flat[1] < 0.02:
        return z_up
    points = spread(vertices, faces, 2000)
    return z_up if steady(points, 1) < FALLS and steady(points, 2) > FIRM else np.eye(3)


def facing(vertices: Array, faces: Array, front: str | None) -> Array:
    """The rotation (3, 3) about y that turns the front of a model, which stands upright, to z. ``front``: the side that is,
    or None to find out.

    That is z ahead, and x of what is its own mirror image across z and not across x. But small forms are a face: where they
    clearly look and lie behind (:mod:`tambour.crochet.model.faced`), on a model that is its own mirror image and stands, that is the
    front. And of an animal on its feet whose face does not tell the head is the front: where all that is high lies at one end, and what is low at the other, the high end. One that is no mirror image of
    itself, as in a stride, and is nearer to being one across z than across x, looks along x to where its head is.
    """
    turns = {
        "front": np.eye(3),
        "back": np.diag([-1.0, 1.0, -1.0]),
        "right": np.array([[0.0, 0.0, -1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]]),
        "left": np.array([[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]]),
    }
    if front is not None:
        return turns[front]
    plane = mirror(vertices, faces)
    turn = turns["right" if plane is not None and abs(float(plane.normal[2])) > 0.9 else "front"]
    points = spread(vertices, faces, 2000) @ turn.T
    low, high = points.min(0), points.max(0)
    share = (points - low) / np.maximum(high - low, 1e-12)
    if plane is None and abs(side := float(share[share[:, 1] > 0.75, 0].mean()) - 0.5) > STRIDE:
        off = [
            float(nearest(tree(vertices, faces), Mirror(points.mean(0), n).image(points))[2].mean()) for n in np.eye(3)
        ]
        if off[2] < NEARER * off[0]:
            return turns["right" if side > 0 else "left"]
    if plane is not None and steady(points, 1) >= STANDS and abs(face := faced(vertices @ turn.T, faces)) > FACE:
        return turn if face > 0.0 else turns["back"] @ turn
    if plane is None or high[2] - low[2] < DEEP * (high[1] - low[1]):
        return turn
    head, feet = (float(share[part, 2].mean()) - 0.5 for part in (share[:, 1] > 0.75, share[:, 1] < 0.2))
    return turns["back"] @ turn if head < -HEAD and feet > FEET else turn


def stands(turn: Array) -> str:
    """Which axes of a file a rotation (3, 3) lays upwards and ahead, in words."""
    up, ahead = (f"{'-' if row.sum() < 0 else ''}{'xyz'[int(np.abs(row).argmax())]}" for row in (turn[1], turn[2]))
    return f"{up} of the model is up, {ahead} is its front (--model-up, --model-front)"


def steady(points: Array, axis: int) -> float:
    """How far within what they stand on the middle of points (P, 3) lies, as a share of their height along ``axis``; below 0 beside it."""
    high = points[:, axis]
    tall = max(float(np.ptp(high)), 1e-12)
    off = np.delete(points - points.mean(0), axis, axis=1)
    angles = 2.0 * np.pi * np.arange(WAYS) / WAYS
    feet = off[high < float(high.min()) + RESTS * tall]
    reach = feet[:, :1] * np.cos(angles) + feet[:, 1:] * np.sin(angles)
    return float(reach.max(0).min()) / tall


def _base(vertices: Array, faces: Array, axis: int) -> float:
    """The share of the surface that lies flat at the lower end of ``axis``."""
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    cross = np.cross(b - a, c - a)
    size = np.sqrt((cross**2).sum(1))
    low, high = float(vertices[:, axis].min()), float(vertices[:, axis].max())
    lies = (cross[:, axis] < -0.98 * size) & (np.maximum(np.maximum(a, b), c)[:, axis] < low + 0.01 * (high - low))
    return float(size[lies].sum() / max(size.sum(), 1e-300))


def candidates(vertices: Array, faces: Array, plane: Mirror | None) -> list[int]:
    """Vertices that rounds may begin at: the ends of the longest way, and what lies farthest out on each side; of a surface
    with a mirror those on its plane."""
    used = corners(faces)
    middle = vertices[used].mean(0)
    ways = [*np.eye(3), *-np.eye(3)]
    _, rows = axes(vertices[used])
    ways += [*rows, *-rows]
    on = used
    if plane is not None:
        off = np.abs(plane.off(vertices[used]))
        on = used[off < max(0.6, float(np.quantile(off, 0.02)))]
    found = [int(on[int(((vertices[on] - middle) * way).sum(1).argmax())]) for way in ways]
    d = distances(vertices, faces, np.array([found[0]]))
    first = int(on[int(d[on].argmax())])
    d = distances(vertices, faces, np.array([first]))
    found += [first, int(on[int(d[on].argmax())])]
    return list(dict.fromkeys(found))


def inward(surface: Target, line: Array) -> float:
    """How far the surface along a closed line (K, 3) looks away from the line's middle: 1 on a rod, -1 inside of a cup."""
    points = line[:: max(1, len(line) // 24)]
    face, _, _ = nearest(surface.tree, points)
    off = points - line.mean(0)
    off = off / np.maximum(np.sqrt((off**2).sum(1, keepdims=True)), 1e-9)
    return float((off * surface.normals[face]).sum(1).mean())


def choose(surface: Target, plane: Mirror | None, side: str | None, few: int = 3) -> list[tuple[int, Array]]:
    """At most ``few`` tips, each with a way (V,) from it: the best of one end, the best of two, and the next best.

    A way is the better the nearer rings along it lie to the surface, and the less they leave out. side : the side that the tip
    shall lie on, None: the best wherever it is
    """
    vertices, faces = surface.vertices, surface.faces
    known = about(faces, len(vertices))
    if side is not None:
        used = corners(faces)
        tip = int(used[int((vertices[used] * np.array(SIDES[side])).sum(1).argmax())])
        return [(tip, distances(vertices, faces, np.array([tip]), known))]
    ways = {tip: distances(vertices, faces, np.array([tip]), known) for tip in candidates(vertices, faces, plane)}
    long = max(float(f.max()) for f in ways.values())
    single = sorted((_price(surface, f, tip), tip, tip) for tip, f in ways.items())
    ends = [tip for _, tip, _ in single]
    pairs = [(a, b) for a in ends[:PAIRED] for b in ends if float(ways[a][b]) > APART * long]
    both = {(a, b): between(vertices, faces, ways[a], ways[b]) for a, b in pairs}
    double = sorted((_price(surface, f, a), a, b) for (a, b), f in both.items())
    best = [*single[:1], *double[:1], *sorted([*single[1:], *double[1:]])][:few]
    return [(a, ways[a] if a == b else both[a, b]) for _, a, b in sorted(best)]


def evened(surface: Target, f: Array, tip: int, plane: Mirror | None) -> Array:
    """A way ``f`` (V,) from a vertex ``tip`` in the mirror ``plane``, as long on the one side as on the other: a tip is a corner, and the
    surface has its corners elsewhere left and right, by which all its rounds would lean to one side. As it is of a tip beside the plane."""
    if plane is None or abs(float(plane.off(surface.vertices[tip]))) > BESIDE:
        return f
    face, uv, _ = nearest(surface.tree, plane.image(surface.vertices))
    a, b, c = (f[surface.faces[face, k]] for k in range(3))
    even = 0.5 * (f + a + uv[:, 0] * (b - a) + uv[:, 1] * (c - a))
    even = np.where(np.isfinite(even), even, f)
    # Of a tip beside the plane it is least between that and its image, as far from both: there it begins.
    return np.asarray(even - even.min())


def _price(surface: Target, f: Array, tip: int) -> float:
    """What rounds along ``f`` (V,) from vertex ``tip`` are off, in stitches, and worse by."""
    vertices = surface.vertices
    off, lost = ringed(surface, f, tip)
    # A round that is wide from its first rows on is no tip: the ring lies in a hollow, or on an edge.
    first = lines(vertices, surface.faces, f, 2.0)
    wide = max((girth(line) for line in first), default=0.0) / (4.0 * np.pi)
    # Nor is the inside of a cup one: rounds there would be begun where no hand comes.
    hollow = first and inward(surface, first[0]) < -0.1
    # A part can be stood on its end or laid with its start ahead: one that leans is shown leaning.
    axis = vertices[tip] - vertices[int(f.argmax())]
    leans = 1.0 - max(abs(float(axis[1])), float(axis[2])) / (float(np.sqrt((axis**2).sum())) + 1e-9)
    return off + LOST * lost + WIDE * max(wide - 1.05, 0.0) + LEANING * leans + (HOLLOW if hollow else 0.0)
