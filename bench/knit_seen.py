"""Knit: how like its picture a chart looks to an eye 1, 2, 4 and 8 m away, by style and method, all in one run.

    python bench/knit_seen.py [--small]

Co-dithering (2025) is our own reference of it for one face, ``codither.py``.

Thirty pictures: those that scikit-image bundles, and the sources of the knitting examples. Charts at 24 x 32 stitches in 10 cm, floats of
at most 4 except where the method has no law. The measure is the correlation of what Mannos and Sakrison's contrast sensitivity (1974) passes
on of the chart and of the picture at chart size, unprepared, in code values (``sight.likenesses``). It is one number beside a blind naming, never in its place.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
from PIL import Image

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "src"))

from tambour import color
from tambour.core.chart import Gauge
from tambour.core.picture import Picture
from tambour.core.progress import Progress
from tambour.knit.params import KnitParams
from tambour.knit.picture import tone, usual
from tambour.knit.picture.resample import resample
from tambour.knit.piece import Piece
from tambour.knit.solve import exact, measure, percept, stages
from tambour.knit.solve.make import make
from tambour.knit.solve.sight import likenesses
from tambour.knit.task import Task

BUNDLED = [
    "horse",
    "text",
    "camera",
    "coins",
    "astronaut",
    "page",
    "coffee",
    "moon",
    "chelsea",
    "clock",
    "rocket",
    "logo",
    "colorwheel",
    "brick",
    "cell",
    "grass",
    "gravel",
    "hubble_deep_field",
    "immunohistochemistry",
    "microaneurysms",
    "retina",
    "stereo_motorcycle",
    "shepp_logan_phantom",
]
OWN = ("cat.png", "pears.jpg", "fells.jpg", "pines.png", "mitten.png", "rose.png", "dogs.png")
SIZES = (80, 60, 120, 200)
METRES = (1.0, 2.0, 4.0, 8.0)
GAUGE = Gauge(24.0, 32.0)


def bundled(name: str) -> np.ndarray:
    """(H, W, 3) uint8 of one of scikit-image's pictures."""
    from skimage import data

    found = getattr(data, name)()
    found = np.asarray(found[0] if isinstance(found, tuple) else found)
    if found.dtype != np.uint8:
        found = np.round(found.astype(float) / max(float(found.max()), 1e-9) * 255).astype(np.uint8)
    return np.ascontiguousarray(np.stack([found] * 3, -1) if found.ndim == 2 else found[..., :3])


def pictures() -> dict[str, np.ndarray]:
    here = Path(__file__).resolve().parent.parent / "examples" / "knit"
    own = {name: np.asarray(Image.open(here / name).convert("RGB")) for name in OWN}
    return {**{name: bundled(name) for name in BUNDLED}, **own}


def ours(**params: object) -> Callable[[np.ndarray, int], np.ndarray]:
    def chart(rgb: np.ndarray, stitches: int) -> np.ndarray:
        rgba = np.dstack([rgb, np.full(rgb.shape[:2], 255, np.uint8)])
        piece = make(Picture(rgba), KnitParams(stitches=stitches, gauge="24x32", max_float="4", **params), Progress())  # type: ignore[arg-type]
        assert piece.figures["violations"] == 0 or piece.params.method in ("none", "gsat")
        if piece.textured is not None:
            # Of pixel art the lone stitches are the designer's own.
            told = measure.facts(piece)
            ALONE.setdefault(str(params) + (", pixel art" if usual.taken(rgb) else ""), []).append(told["alone"])
            BORDERS.setdefault(str(params), []).append(told["borders"])
        return piece.chart.cells

    return chart


def quantised(rgb: np.ndarray, stitches: int) -> np.ndarray:
    """AYAB's two levels: Pillow's quantize of the picture at chart size; no law."""
    rows = max(1, round(stitches * rgb.shape[0] / rgb.shape[1] * 32 / 24))
    image = Image.fromarray(rgb).resize((stitches, rows), Image.Resampling.BOX).quantize(2)
    light = np.array(image.getpalette()[:6]).reshape(2, 3).sum(1).argmax()
    return (np.asarray(image) == light).astype(np.uint8)[::-1]


def free(rgb: np.ndarray, stitches: int) -> np.ndarray:
    """Floyd and Steinberg without any law."""
    rows = max(1, round(stitches * rgb.shape[0] / rgb.shape[1] * 32 / 24))
    return tone.assign(tone.brightness(resample(rgb, rows, stitches)[::-1], "code"), "floyd-steinberg", 0.5)


def peer(cost: str) -> Callable[[np.ndarray, int], np.ndarray]:
    """Co-dithering of one face in two yarns, by the reference beside this script: floats of at most four."""
    import codither

    def chart(rgb: np.ndarray, stitches: int) -> np.ndarray:
        rows = max(1, round(stitches * rgb.shape[0] / rgb.shape[1] * 32 / 24))
        aim = color.linear(tone.brightness(resample(rgb, rows, stitches)[::-1], "code")).astype(np.float32)
        return codither.chart(np.ascontiguousarray(aim), 4, cost == "oklab")

    return chart


ALONE: dict[str, list[float]] = {}
BORDERS: dict[str, list[float]] = {}
METHODS: dict[str, Callable[[np.ndarray, int], np.ndarray]] = {
    "auto": ours(),
    "graphic": ours(style="graphic"),
    "graphic, ground stripe": ours(style="graphic", ground="stripe"),
    "texture": ours(style="texture"),
    "tonal": ours(style="tonal"),
    "tonal, seen from 2 m": ours(style="tonal", seen_from="2m"),
    "graphic, 2 tones": ours(style="graphic", tones=2),
    "graphic, 2 tones, ground stripe": ours(style="graphic", tones=2, ground="stripe"),
    "graphic, caught": ours(style="graphic", floats="caught"),
    "graphic, 2 tones, caught": ours(style="graphic", tones=2, floats="caught"),
    "perceptual (the default before)": ours(method="perceptual"),
    "exact after threshold": ours(method="exact", start="threshold", tone="raw"),
    "exact after Floyd-Steinberg": ours(method="exact", start="floyd-steinberg", tone="raw"),
    "GSAT after Floyd-Steinberg (2013)": ours(method="gsat", start="floyd-steinberg", tone="raw"),
    "Floyd-Steinberg, no law": free,
    "AYAB's two levels, no law": quantised,
    "co-dithering, oklab cost": peer("oklab"),
    "co-dithering, linear cost": peer("linear"),
}


def filtered(error: np.ndarray, eye: percept.Eye) -> np.ndarray:
    """What the energy of ``eye`` makes of an error (R, C): the energy is the sum of the product of both."""
    from scipy.ndimage import correlate1d

    out = np.zeros_like(error)
    for across, down in zip(eye.across.astype(float), eye.down.astype(float)):
        along = correlate1d(error, np.r_[across[:0:-1], across], axis=1, mode="constant")
        out += correlate1d(along, np.r_[down[:0:-1], down], axis=0, mode="constant")
    return out


def least(eye: percept.Eye) -> float:
    """The least eigenvalue of the energy: no picture has less energy than so much of its squares."""
    tall, wide = eye.down.shape[1] - 1, eye.across.shape[1] - 1
    kernel = np.zeros((256, 256))
    for across, down in zip(eye.across.astype(float), eye.down.astype(float)):
        kernel[: 2 * tall + 1, : 2 * wide + 1] += np.outer(np.r_[down[:0:-1], down], np.r_[across[:0:-1], across])
    return float(np.fft.fft2(np.roll(kernel, (-tall, -wide), (0, 1))).real.min())


def bound(piece: Piece, steps: int = 60) -> float:
    """dB by which a tonal chart's energy is above one that no lawful chart can be below.

    Frank and Wolfe over the convex hulls of lawful rows. As a stitch is 0 or 1 its square is itself: so much of the energy
    as is sure to be convex (``least``) is taken as that line instead, which is the same for charts and higher between them.
    """
    task = piece.state.task
    eye = stages.sight_of(task.limit, piece.params)
    aim, b = task.tone.astype(float), piece.state.cells.astype(float)
    sure = 0.999 * max(0.0, least(eye))

    def energy(x: np.ndarray) -> float:
        e = x - aim
        return float((e * filtered(e, eye)).sum() + sure * (x * (1 - 2 * aim) + aim**2 - e**2).sum())

    ours_, best = energy(b), 0.0
    for _ in range(steps):
        slope = 2 * (filtered(b - aim, eye) - sure * (b - aim)) + sure * (1 - 2 * aim)
        weights = np.abs(slope)
        price = (weights / weights.max() * 1e4).astype(np.float32)
        corner = exact.solve(Task(task.tone, (slope < 0).astype(np.uint8), task.limit, weights=price)).astype(float)
        way = corner - b
        gap = -float((slope * way).sum())
        best = max(best, energy(b) - gap)
        b += way * min(1.0, gap / (2 * float((way * (filtered(way, eye) - sure * way)).sum())))
    return float(10 * np.log10(ours_ / best))


def main(small: bool) -> None:
    found = pictures()
    print(f"{len(found)} pictures, floats up to 4 where there is a law; mean correlation at {METRES} m")
    for stitches in SIZES[:1] if small else SIZES:
        print(f"\n{stitches} stitches")
        for name, method in METHODS.items():
            rows = []
            for rgb in found.values():
                cells = method(rgb, stitches)
                seen = tone.brightness(resample(rgb, *cells.shape)[::-1], "code")
                rows.append(likenesses(cells, seen, GAUGE, METRES))
            print(f"{name:36}" + " ".join(f"{v:5.2f}" for v in np.mean(rows, axis=0)), flush=True)
    print("\ntonal, 80 stitches: energy above the bound, dB")
    for name in ("camera", "coffee", "chelsea", "astronaut", "horse", "coins"):
        rgba = np.dstack([found[name], np.full(found[name].shape[:2], 255, np.uint8)])
        asked = KnitParams(stitches=80, gauge="24x32", max_float="4", style="tonal")
        print(f"{name:12} {bound(make(Picture(rgba), asked, Progress())):5.2f}")
    print("\nstitches alone in their colour outside declared textures, percent: mean, worst")
    for name, alone in ALONE.items():
        print(f"{name:60} {np.mean(alone):5.2f} {np.max(alone):5.2f}")
    print("\nstitches at a border between two regions that kept their colour, percent: mean, least")
    for name, kept in BORDERS.items():
        print(f"{name:60} {np.mean(kept):5.2f} {np.min(kept):5.2f}")


if __name__ == "__main__":
    main("--small" in sys.argv[1:])
