"""A picture as regions: few colours, smooth outlines, no crumbs."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from tambour.color import from_oklab, oklab
from tambour.core.check import Array
from tambour.core.drawing import Drawing, Groups, Styles
from tambour.core.paths import Paths
from tambour.core.picture import Picture
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.regions.stack import stacked
from tambour.noise import stream

COLORS = 6
WIDTH = 100.0  # mm, when neither the file nor --width says
PIXEL = 0.35  # mm: finer detail than this is no use to a thread
CRUMB = 4.0  # mm²: smaller areas go to their surroundings
THIN = 1.0  # mm: what is thinner is left to its surroundings
BELOW = 3.0  # mm: half the width of what may lie on an area without a hole in it
BEYOND = 6  # pixels that a picture goes on beyond its rim while its areas are smoothed
OVERLAP = 0.15  # mm that areas reach below their neighbours


def traced(picture: Picture, params: EmbroideryParams) -> Drawing:
    """A Drawing in mm of a picture reduced to ``params.colors`` colours (COLORS when not given).

    See-through pixels are cloth; so is a colour that holds most of the picture's rim. Larger areas lie below smaller.
    """
    rgba = picture.rgba
    rows, columns = rgba.shape[:2]
    width, pixel = size_of(picture, params)
    n = max(8, min(columns, round(width / pixel)))
    small = shrunk(rgba, n, max(8, round(rows * n / columns)))
    pixel = width / n
    solid = small[..., 3] > 0.5
    lab = oklab(small[..., :3])
    if not solid.any():
        return _drawing([], pixel, small.shape)
    label, centers = few(lab, solid, params.colors or COLORS, params.seed)
    label = _calm(label, centers, lab, solid)
    rim = np.concatenate([label[0], label[-1], label[:, 0], label[:, -1]])
    common = int(np.bincount(rim[rim >= 0], minlength=1).argmax()) if (rim >= 0).any() else -1
    if common >= 0 and (rim == common).mean() > 0.7 and len(centers) > 1:
        label = np.where(label == common, -1, label)
    label = _crumbs(label, CRUMB / pixel**2)
    colors = from_oklab(centers)
    areas = [k for k in range(len(centers)) if (label == k).any()]
    areas.sort(key=lambda k: -int((label == k).sum()))
    return _drawing([(label == k, tuple(int(c) for c in colors[k])) for k in areas], pixel, small.shape)


def size_of(picture: Picture, params: EmbroideryParams) -> tuple[float, float]:
    """Width in mm of a picture, and of the pixels that are worth looking at."""
    columns = picture.rgba.shape[1]
    width = params.width or (columns * picture.pixel if picture.pixel and columns * picture.pixel < 400 else WIDTH)
    return width, max(PIXEL, width / 500)


def with_images(drawing: Drawing, params: EmbroideryParams) -> Drawing:
    """A drawing whose pictures are traced, each in its place below the shapes."""
    unit, size = drawing.unit, drawing.size
    for placed in reversed(drawing.images):
        if placed.glaze or placed.repeat is not None:
            continue
        scale = 1.0 if params.width is None else params.width / float(size[0] * unit)
        wide = placed.width * unit
        made = traced(placed.picture, params.model_copy(update={"width": wide * scale}))
        # Traced at the size at which it is sewn, and laid where it was.
        coords = (made.paths.coords / scale / unit + np.array([placed.x, placed.y])) if len(made) else None
        if coords is not None:
            below = replace(made, paths=Paths(coords, made.paths.offsets, made.paths.parts), unit=unit, size=size)
            drawing = stacked(below, replace(drawing, images=()), "drawing")
    return replace(drawing, images=())


def shrunk(rgba: Array, columns: int, rows: int) -> Array:
    """(rows, columns, 4) floats in 0…1: the mean of the pixels that fall into each, weighted by their alpha."""
    i = np.linspace(0, rgba.shape[0], rows + 1).astype(int)
    j = np.linspace(0, rgba.shape[1], columns + 1).astype(int)
    i, j = np.minimum(i, rgba.shape[0] - 1), np.minimum(j, rgba.shape[1] - 1)
    value = rgba.astype(np.float64) / 255
    value[..., :3] *= value[..., 3:]
    total = np.add.reduceat(np.add.reduceat(value, i[:-1], 0), j[:-1], 1)
    last_i = np.r_[np.diff(i)[:-1], rgba.shape[0] - i[-2]]
    last_j = np.r_[np.diff(j)[:-1], rgba.shape[1] - j[-2]]
    mean = total / (np.maximum(1, last_i)[:, None, None] * np.maximum(1, last_j)[None, :, None])
    mean[..., :3] /= np.maximum(mean[..., 3:], 1e-9)
    return np.clip(mean, 0, 1)


def few(lab: Array, solid: Array, count: int, seed: str) -> tuple[Array, Array]:
    """k-means in Oklab, begun at colours far from each other: (label (rows, columns), -1 outside; centres (k, 3))."""
    points = lab[solid]
    draw = stream(seed, "trace")
    centers = [points.mean(0)]
    far = ((points - centers[0]) ** 2).sum(1)
    centers = [points[int(far.argmax())]]
    far = ((points - centers[0]) ** 2).sum(1)
    while len(centers) < count and far.max() > 1e-4:
        weight = np.cumsum(far**2)
        centers.append(points[int(np.searchsorted(weight, draw.random() * weight[-1]))])
        far = np.minimum(far, ((points - centers[-1]) ** 2).sum(1))
    middle = np.array(centers)
    for _ in range(20):
        near = ((points[:, None] - middle) ** 2).sum(2).argmin(1)
        moved = np.array([points[near == k].mean(0) if (near == k).any() else middle[k] for k in range(len(middle))])
        if np.allclose(moved, middle, atol=1e-5):
            break
        middle = moved
    label = np.full(solid.shape, -1)
    label[solid] = ((points[:, None] - middle) ** 2).sum(2).argmin(1)
    return label, middle


def _calm(label: Array, centers: Array, lab: Array, solid: Array) -> Array:
    """Each pixel takes the label whose colour fits and that its surroundings share (smoothed costs)."""
    from scipy.ndimage import gaussian_filter

    cost = np.stack([gaussian_filter(np.where(solid, ((lab - c) ** 2).sum(-1), 0), 1.2) for c in centers], -1)
    return np.where(solid, cost.argmin(-1), -1)


def _crumbs(label: Array, least: float) -> Array:
    """Areas of fewer than ``least`` pixels given to what surrounds them."""
    from scipy.ndimage import distance_transform_edt
    from scipy.ndimage import label as parts_of

    lost = np.zeros(label.shape, bool)
    for k in np.unique(label):
        parts, _ = parts_of(label == k)
        size = np.bincount(parts.reshape(-1))
        size[0] = 10**9
        lost |= size[parts] < least
    if not lost.any() or lost.all():
        return label
    _, (i, j) = distance_transform_edt(lost, return_indices=True)
    return np.asarray(label[i, j])


def outlines(mask: Array) -> list[Array]:
    """Closed outlines (n, 2) of a mask's cells in (column, row) corners: areas one way round, holes the other."""
    padded = np.pad(mask, 1)
    after: dict[tuple[int, int], list[tuple[int, int]]] = {}
    # An edge runs with the area on its right (y down): along tops to the right, bottoms to the left.
    for (r, c), (da, db) in (
        ((-1, 0), ((0, 0), (0, 1))),
        ((1, 0), ((1, 1), (1, 0))),
        ((0, 1), ((0, 1), (1, 1))),
        ((0, -1), ((1, 0), (0, 0))),
    ):
        edge = padded[1:-1, 1:-1] & ~padded[1 + r : padded.shape[0] - 1 + r, 1 + c : padded.shape[1] - 1 + c]
        for i, j in zip(*(v.tolist() for v in np.nonzero(edge))):
            after.setdefault((i + da[0], j + da[1]), []).append((i + db[0], j + db[1]))
    found = []
    while after:
        begin = next(iter(after))
        ring = [begin]
        here, came = begin, (0, 0)
        while True:
            ways = after[here]
            # Where two corners touch, turn so that the areas stay apart.
            pick = 0
            if len(ways) > 1:
                turns = [came[0] * (w[1] - here[1]) - came[1] * (w[0] - here[0]) for w in ways]
                pick = int(np.argmin(turns))
            step = ways.pop(pick)
            if not ways:
                del after[here]
            came = (step[0] - here[0], step[1] - here[1])
            here = step
            if here == begin:
                break
            ring.append(here)
        found.append(np.array(ring, np.float64)[:, ::-1])
    return found


def _drawing(areas: list[Any], pixel: float, shape: tuple[int, ...]) -> Drawing:
    import shapely

    rings: list[Array] = []
    parts: list[int] = [0]
    style: list[int] = []
    colors: list[Any] = []
    ids: list[str] = []
    # The rim is straight: outlines are smoothed and reach over beyond it, and are cut there.
    sheet = shapely.box(0, 0, shape[1] * pixel, shape[0] * pixel)
    raw = [_outlined(mask, pixel) for mask, _ in areas]
    smooth = [_rounded(area) for area in raw]
    # What was too thin for its own colour goes to those beside it.
    lost = shapely.union_all(raw).difference(shapely.union_all(smooth))
    for k, (_, color) in enumerate(areas):
        near = smooth[k].buffer(THIN)
        taken, lost = near.intersection(lost).buffer(0), lost.difference(near)  # areas only: they meet in lines, too
        own, above = smooth[k].union(taken), shapely.union_all([*smooth[k + 1 :], lost])
        # Below what is sewn later it runs on, over holes and slits: fewer ends of rows, and no cloth in between.
        below = own.simplify(0.1).buffer(BELOW, quad_segs=2).buffer(-BELOW, quad_segs=2)
        own = own.union(below.intersection(above)).buffer(THIN / 2, quad_segs=4)
        whole = own.buffer(OVERLAP - THIN / 2, quad_segs=4).simplify(0.1)
        for polygon in shapely.get_parts(whole.intersection(sheet)):
            if polygon.geom_type != "Polygon" or polygon.area < 0.5:
                continue
            rings += [shapely.get_coordinates(r) for r in (polygon.exterior, *polygon.interiors)]
            parts.append(len(rings))
            style.append(k)
            ids.append(f"area-{len(ids) + 1}")
        colors.append(((*color, 255), None, 0.0))
    coords = Paths.of(rings)
    groups = Groups(
        tuple(ids),
        tuple(ids),
        np.full(len(ids), -1),
        np.zeros(len(ids), bool),
        tuple({"tambour-stitch": "tatami"} for _ in ids),
    )
    return Drawing(
        Paths(coords.coords, coords.offsets, np.array(parts)),
        np.array(style, np.int32),
        Styles.of(*colors),
        np.array([shape[1], shape[0]]) * pixel,
        np.arange(len(ids)),
        groups,
    )


def _smooth(ring: Array) -> Array:
    """A pixel outline without its stairs: corners cut twice, then averaged over its neighbours."""
    for _ in range(2):
        after = np.roll(ring, -1, 0)
        ring = np.stack([0.75 * ring + 0.25 * after, 0.25 * ring + 0.75 * after], 1).reshape(-1, 2)
    for _ in range(3):
        ring = 0.25 * np.roll(ring, 1, 0) + 0.5 * ring + 0.25 * np.roll(ring, -1, 0)
    return ring


def _outlined(mask: Array, pixel: float) -> Any:
    """The area (shapely, mm) of a mask, without stairs."""
    import shapely

    made = [(_smooth(r) - BEYOND) * pixel for r in outlines(np.pad(mask, BEYOND, "edge"))]
    outer = shapely.union_all([shapely.Polygon(r).buffer(0) for r in made if _area(r) > 0])
    holes = shapely.union_all([shapely.Polygon(r).buffer(0) for r in made if _area(r) <= 0])
    return outer.difference(holes).simplify(0.05)


def _rounded(area: Any) -> Any:
    """An area without what is thinner than ``THIN`` and with no bend tighter than half of that: outlines to sew along."""
    half = THIN / 2
    return area.buffer(-half, quad_segs=4).buffer(2 * half, quad_segs=4).buffer(-half, quad_segs=4)


def _area(ring: Array) -> float:
    x, y = ring.T
    return 0.5 * float((x * np.roll(y, -1) - np.roll(x, -1) * y).sum())
