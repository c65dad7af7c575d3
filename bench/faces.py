"""Faces: whether a settled toy's face is one: its things in order, none over another, eyes seen, looking ahead; and its seams closed.

All is measured on the built piece as its cover shows it, none on the words that it was told in. placed.py prints it.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from tambour.core.check import Array
from tambour.core.graph import SEWN
from tambour.crochet.finish.features import placed, spots
from tambour.crochet.finish.sound import TOUCH
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Eye, Felt, Hair
from tambour.crochet.page.portrait import stand
from tambour.crochet.piece import Plush
from tambour.crochet.places.names import Made
from tambour.crochet.settle.arrange import clusters
from tambour.geometry.closest import nearest, tree

ABOVE = 0.6
"""By so many stitches one thing of a face may be higher than another that belongs above it."""
AWRY = 25.0
"""A face is awry whose eyes' line is so many degrees off the level, or which looks so much lower or higher, or twice aside."""
FAR = np.arange(0.6, 16.0, 0.5)
"""Where in front of an eye, in stitches, nothing may be."""
BARE = 2.2
"""A seam is open whose stitches are so many stitches apart from those that they are sewn to, in the mean of its worst tenth."""
HID = 0.15
"""A head is sunk of which so much is inside of another part."""
PULLED = 3.0
"""Yarn is seen as a thread across the air where two stitches of one part are so many stitches farther apart than their yarn reaches."""
_SAID = {
    "eyes": r"\b(?:safety|button|bead|embroider\w*|sew|satin|french knot|black|attach|glue|place)\b[^.\n]{0,40}\beyes?\b|\beyes?:",
    "nose": r"\b(?:embroider\w*|satin|sew|stitch)\b[^.\n]{0,40}\b(?:nose|beak|snout|muzzle)\b",
    "mouth": r"\b(?:embroider\w*|satin|back\s?stitch|stitch)\b[^.\n]{0,40}\b(?:mouth|smile)\b",
}
"""Words by which a text says that a face has something."""
_ORDER = (("muzzle", "eyes"), ("nose", "eyes"), ("mouth", "nose"), ("mouth", "eyes"), ("cheeks", "eyes"))
"""The first of two things is not above the second."""


@dataclass(frozen=True, eq=False)
class Thing:
    """One thing of a face: what, where its middle is (3,), where it looks (3,), half its width, and the parts it is on and is."""

    what: str
    at: Array
    looks: Array
    half: float
    on: int
    part: int = -1


def camera(piece: Plush) -> Array:
    """The way (3,) from a piece to who looks at its cover."""
    azimuth, elevation = stand(piece)
    level = math.cos(elevation)
    return np.array([math.sin(azimuth) * level, math.sin(elevation), math.cos(azimuth) * level])


def things(piece: Plush, parts: list[int], kinds: dict[int, Made]) -> list[Thing]:
    """What the faces of a piece hold: embroidered, of glass, of felt, and crocheted."""
    graph, x, known = piece.built.graph, piece.positions, Spots(piece.built)
    located, found = placed(piece.built, x, piece.upright), list[Thing]()
    for record, where in zip(located.records, located.where):
        on = known.parts[spots(record)[0].part]
        if isinstance(record, Hair) or on not in parts:
            continue
        half = record.size / 2.0 if isinstance(record, Eye) else 0.5 * float(np.ptp(where.points, axis=0).max())
        name = "eyes" if isinstance(record, Eye) else "felt" if isinstance(record, Felt) else (record.motif or "stroke")
        name = {"smile": "mouth", "brow": "brows"}.get(name.split()[-1], name.split()[-1])
        found.append(Thing(name, where.points.mean(0), where.normals.mean(0), half, on))
    joined = {} if piece.joining is None else {
        known.parts[f.part]: known.parts[f.spot.part] for f, _ in piece.joining.steps
    }  # fmt: skip
    for k, on in joined.items():
        kind = kinds[k].kind if k in kinds else ""
        what = {"eye": "eyes", "nose": "nose", "beak": "nose", "muzzle": "muzzle", "cheek": "cheeks"}.get(kind)
        if k in parts and what and "head" not in kinds[k].kinds:
            own = x[graph.parts[k].start : graph.parts[k].end]
            out = own.mean(0) - x[graph.parts[on].start : graph.parts[on].end].mean(0)
            out = out / max(float(np.sqrt(out @ out)), 1e-9)
            found.append(Thing(what, own.mean(0), out, 0.5 * float(np.ptp(own, axis=0)[:2].min()), on, k))
    return found


def wrong(piece: Plush, parts: list[int], kinds: dict[int, Made]) -> list[str]:
    """All that is wrong with a piece's faces and seams, as words: "what: of what"."""
    graph, x = piece.built.graph, piece.positions
    some = things(piece, parts, kinds)
    toy = clusters(graph)
    found = [*_said(piece, some), *_seams(piece, parts), *_heads(piece, parts, kinds)]
    found += [*_pulled(piece, parts), *_hats(piece, parts, kinds)]
    for label in {int(toy[graph.parts[k].start]) for k in parts}:
        own = [t for t in some if int(toy[graph.parts[t.on].start]) == label]
        bare = [k for k in parts if int(toy[graph.parts[k].start]) == label]
        found += [
            *_order(piece, own),
            *_seen(piece, own, bare),
            *_ahead(piece, own, bare),
            *_over(own, x, graph.stitch_width),
        ]
    return found


def _one_stroke(some: Iterable[Thing]) -> dict[str, list[Thing]]:
    by: dict[str, list[Thing]] = {}
    for t in some:
        by.setdefault(t.what, []).append(t)
    return by


def _order(piece: Plush, own: list[Thing]) -> list[str]:
    """Things of a face that are above what they belong below."""
    by, least = _one_stroke(own), ABOVE * piece.built.graph.stitch_width
    found = []
    for low, high in _ORDER:
        if low in by and high in by:
            a, b = (float(np.mean([t.at[1] for t in by[w]])) for w in (low, high))
            if a > b + least:
                found.append(f"order: {low} above {high}")
    return found


def _seen(piece: Plush, own: list[Thing], parts: list[int]) -> list[str]:
    """Eyes that look at who looks at the toy, and are hidden by something else."""
    graph, x, stitch = piece.built.graph, piece.positions, piece.built.graph.stitch_width
    eyes, way = [t for t in own if t.what == "eyes" and t.part < 0], camera(piece)
    faces = graph.faces[np.isin(graph.part[graph.faces], parts).all(1)]
    if not eyes or not len(faces):
        return []
    near, found, seen = tree(x, faces), list[str](), 0
    for eye in eyes:
        ahead = eye.at + 0.5 * stitch * eye.looks + eye.half * eye.looks + FAR[:, None] * stitch * way
        face, _, far = nearest(near, ahead)
        hit = far < 0.45 * stitch
        if float(eye.looks @ way) > 0.1:
            seen += not hit.any()
            if hit.any():
                by = int(graph.part[faces[face[np.argmax(hit)]][0]])
                found.append(f"hidden: eye by {graph.parts[by].name.split('.')[0]}")
    if len(eyes) == 2 and seen < 2 and not found:
        found.append(f"one-eyed: {seen} of 2 seen")
    return list(dict.fromkeys(found))


def _ahead(piece: Plush, own: list[Thing], parts: list[int]) -> list[str]:
    """Faces awry, looking down, up or aside from the cover."""
    eyes = [t for t in own if t.what == "eyes"]
    if len(eyes) != 2:
        return []
    a, b = eyes
    looks = a.looks + b.looks
    looks, found = looks / max(float(np.sqrt(looks @ looks)), 1e-9), []
    line = a.at - b.at
    wide = float(np.hypot(line[0], line[2]))
    if wide > 1e-9 and math.degrees(math.atan2(abs(float(line[1])), wide)) > AWRY:
        found.append("awry: one eye above the other")
    rise = math.degrees(math.asin(max(-1.0, min(1.0, float(looks[1])))))
    if abs(rise) > 2.0 * AWRY:
        found.append(f"looks: {'up' if rise > 0 else 'down'} by {abs(rise):.0f} degrees")
    way = camera(piece)
    flat = float(looks[[0, 2]] @ way[[0, 2]]) / max(float(np.hypot(*looks[[0, 2]]) * np.hypot(*way[[0, 2]])), 1e-9)
    if flat < math.cos(math.radians(3.0 * AWRY)):
        found.append("looks: away from the cover")
    return found


def _over(own: list[Thing], x: Array, stitch: float) -> list[str]:
    """Things of a face that lie on each other."""
    found = []
    pairs = [("eyes", "nose"), ("eyes", "mouth"), ("mouth", "nose"), ("eyes", "eyes"), ("cheeks", "eyes")]
    for i, a in enumerate(own):
        for b in own[i + 1 :]:
            names = (a.what, b.what)
            if (names in pairs or names[::-1] in pairs) and a.on == b.on and a.part == b.part == -1:
                least = 0.5 * (a.half + b.half) if a.what == b.what == "eyes" else 0.25 * stitch
                if float(np.sqrt(((a.at - b.at) ** 2).sum())) < least:
                    found.append(f"over: {a.what} on {b.what}")
    return list(dict.fromkeys(found))


def _seams(piece: Plush, parts: list[int]) -> list[str]:
    """Parts sewn by bare threads over a gap."""
    graph, x = piece.built.graph, piece.positions
    ties = graph.edges[graph.edge_kind == SEWN]
    if not len(ties):
        return []
    gap = np.sqrt(((x[ties[:, 0]] - x[ties[:, 1]]) ** 2).sum(1)) / graph.stitch_width
    pair, found = np.sort(graph.part[ties], axis=1), []
    for a, b in np.unique(pair, axis=0):
        own = np.sort(gap[(pair == (a, b)).all(1)])
        if a != b and a in parts and b in parts and own[-max(1, len(own) // 10) :].mean() > BARE:
            found.append(f"gap: {graph.parts[b].name} and {graph.parts[a].name} {own[-1]:.1f}")
    return found


def _pulled(piece: Plush, parts: list[int]) -> list[str]:
    """Parts whose own stitches were pulled far apart: a strand laid away from its root, fabric dragged over an edge."""
    graph, x = piece.built.graph, piece.positions
    own = (graph.edge_kind != SEWN) & (graph.part[graph.edges[:, 0]] == graph.part[graph.edges[:, 1]])
    a, b = graph.edges[own].T
    far = (np.sqrt(((x[a] - x[b]) ** 2).sum(1)) - graph.rest[own]) / graph.stitch_width
    torn = np.unique(graph.part[a[far > PULLED]])
    return [f"pulled: {graph.parts[k].name}" for k in torn if k in parts]


def _hats(piece: Plush, parts: list[int], kinds: dict[int, Made]) -> list[str]:
    """Hats of a toy that has a head, and sits neither on it nor over it."""
    graph, x, toy = piece.built.graph, piece.positions, clusters(piece.built.graph)
    found = []
    for k in parts:
        name = kinds[k].name.lower()
        if not re.search(r"\b(?:hat|cap|bonnet|beanie)(?![a-z])", name) or "head" in kinds[k].kinds:
            continue
        heads = [
            j for j in parts if "head" in kinds[j].kinds and toy[graph.parts[j].start] == toy[graph.parts[k].start]
        ]
        if any("head" in kinds[j].kinds for j in parts) and not heads:
            found.append(f"hat: beside, {kinds[k].name}")
        for j in heads[:1]:
            own, head = (x[graph.parts[i].start : graph.parts[i].end] for i in (k, j))
            if own[:, 1].mean() < head[:, 1].mean() or own[:, 1].min() > head[:, 1].max() + graph.stitch_width:
                found.append(f"hat: not on the head, {kinds[k].name}")
    return found


def _heads(piece: Plush, parts: list[int], kinds: dict[int, Made]) -> list[str]:
    """Heads inside of what they are on, or lower than it."""
    graph, x, found = piece.built.graph, piece.positions, []
    faces, stitch = graph.faces[piece.built.shell], graph.stitch_width
    from tambour.geometry.surface import face_normals

    for k in parts:
        if kinds[k].kind != "head" or "body" in kinds[k].kinds:
            continue
        own = x[graph.parts[k].start : graph.parts[k].end]
        for j in parts:
            if j == k or kinds[j].kind not in ("body", "neck"):
                continue
            there = faces[(graph.part[faces] == j).all(1)]
            if not len(there):
                continue
            face, _, far = nearest(tree(x, there), own)
            out = ((own - x[there[face]].mean(1)) * face_normals(x, there)[face]).sum(1)
            inside = float(((out < 0.0) & (far > TOUCH * 0.3 * stitch) & (far < 8.0 * stitch)).mean())
            if inside > HID:
                found.append(f"head: {100 * inside:.0f} % in {kinds[j].name}")
    return found


def _said(piece: Plush, some: list[Thing]) -> list[str]:
    """What the text says that a face has, and it has not."""
    text, have = piece.built.pattern.text.text.lower(), {t.what for t in some}
    have |= {"nose"} if "muzzle" in have else set()
    if "felt" in have or "stroke" in have:
        have |= {"eyes", "nose", "mouth"}
    return [f"missing: {what}" for what, said in _SAID.items() if what not in have and re.search(said, text)]
