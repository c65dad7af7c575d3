"""Draws the pictures of the knitting examples: python examples/knit/pictures.py writes them beside itself."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import skia
from PIL import Image

HERE = Path(__file__).parent
Array = np.ndarray


def canvas(width: int, height: int, color: int = skia.ColorWHITE) -> tuple[Array, skia.Canvas]:
    pixels = np.zeros((height, width, 4), np.uint8)
    surface = skia.Surface.MakeRasterDirect(skia.ImageInfo.MakeN32Premul(width, height), pixels)
    surface.getCanvas().clear(color)
    canvas.keep = surface  # type: ignore[attr-defined]
    return pixels, surface.getCanvas()


def curve(points: list[tuple[float, float]], closed: bool = False) -> skia.Path:
    """A smooth line through points (Catmull and Rom)."""
    p = np.array(points, float)
    ends = (p[-1:], p[:2]) if closed else (2 * p[:1] - p[1:2], 2 * p[-1:] - p[-2:-1])
    q = np.concatenate([ends[0], p, ends[1]])
    path = skia.Path()
    path.moveTo(*q[1])
    for k in range(1, len(q) - 2):
        a, b = q[k] + (q[k + 1] - q[k - 1]) / 6, q[k + 1] - (q[k + 2] - q[k]) / 6
        path.cubicTo(*a, *b, *q[k + 1])
    return path


def sown(motif: Array) -> Array:
    """A motif with lice on its ground, a stitch away from it; left and right, top and bottom meet."""
    y, x = np.indices(motif.shape)
    near = motif.copy()
    for dy, dx in ((0, 1), (0, -1), (1, 0), (-1, 0)):
        near |= np.roll(motif, (dy, dx), (0, 1))
    return motif | (((x + 2 * y) % 4 == 0) & ~near)


def cat() -> None:
    """A line drawing: a cat at the window, the moon, a plant."""
    pixels, c = canvas(900, 1000)
    pen = skia.Paint(Color=skia.ColorBLACK, Style=skia.Paint.kStroke_Style, StrokeWidth=13, AntiAlias=True)
    pen.setStrokeCap(skia.Paint.kRound_Cap)
    pen.setStrokeJoin(skia.Paint.kRound_Join)
    ink = skia.Paint(Color=skia.ColorBLACK, AntiAlias=True)
    for x in (60, 450, 840):
        c.drawLine(x, 50, x, 790, pen)
    for y in (50, 350, 790):
        c.drawLine(60, y, 840, y, pen)
    c.drawLine(20, 840, 880, 840, pen)
    c.drawLine(20, 790, 20, 840, pen)
    c.drawLine(880, 790, 880, 840, pen)
    c.drawPath(curve([(700, 120), (640, 150), (625, 210), (660, 265), (720, 275), (760, 250)]), pen)
    c.drawPath(curve([(700, 120), (685, 170), (705, 225), (760, 250)]), pen)
    for x, y in ((150, 130), (260, 220), (360, 120), (540, 140), (560, 290), (180, 290)):
        c.drawCircle(x, y, 11, ink)
    body = [(330, 790), (292, 700), (300, 600), (340, 520), (370, 470)]
    right = [(570, 790), (606, 700), (598, 600), (556, 520), (530, 470)]
    white = skia.Paint(Color=skia.ColorWHITE, AntiAlias=True)
    outline = [*body, (352, 410), (356, 330), (404, 372), (450, 364), (496, 372), (544, 330), (548, 410), *right[::-1]]
    shape = curve(outline[:5])
    shape = skia.Path()
    shape.moveTo(*outline[0])
    for point in outline[1:]:
        shape.lineTo(*point)
    c.drawPath(shape, white)
    c.drawPath(curve(body), pen)
    c.drawPath(curve(right), pen)
    c.drawPath(curve([(370, 470), (350, 425), (356, 330)]), pen)
    c.drawPath(curve([(530, 470), (550, 425), (544, 330)]), pen)
    c.drawLine(356, 330, 404, 372, pen)
    c.drawLine(544, 330, 496, 372, pen)
    c.drawPath(curve([(404, 372), (450, 364), (496, 372)]), pen)
    c.drawPath(curve([(330, 790), (400, 805), (500, 805), (570, 790)]), pen)
    c.drawPath(curve([(570, 780), (660, 800), (705, 860), (690, 930), (640, 955), (615, 920), (640, 895)]), pen)
    c.drawPath(curve([(400, 560), (395, 660), (410, 770)]), pen)
    c.drawPath(curve([(500, 560), (505, 660), (490, 770)]), pen)
    c.drawRect(skia.Rect.MakeLTRB(110, 690, 230, 784), white)
    pot = skia.Path()
    for k, point in enumerate(((105, 690), (235, 690), (215, 786), (125, 786), (105, 690))):
        (pot.moveTo if k == 0 else pot.lineTo)(*point)
    c.drawPath(pot, pen)
    for tip in ((90, 520), (140, 470), (200, 480), (255, 540)):
        c.drawPath(curve([(170, 690), ((170 + tip[0]) / 2 - 8, 600), tip]), pen)
        c.drawCircle(*tip, 17, ink)
    Image.fromarray(pixels[..., 0]).quantize(8).save(HERE / "cat.png", optimize=True)


def pears() -> None:
    """A photograph-like picture: two pears and a plum on a table, traced with soft light."""
    high, wide = 360, 440
    y, x = np.mgrid[0:high, 0:wide]
    ray = np.stack([(x - wide / 2) / wide * 1.5, (high / 2 - y) / wide * 1.5 - 0.16, np.full(x.shape, -1.6)], axis=-1)
    ray /= np.linalg.norm(ray, axis=-1, keepdims=True)
    eye = np.array([0.0, 1.15, 4.2])

    def blend(a: Array, b: Array, k: float) -> Array:
        h = np.clip(0.5 + 0.5 * (b - a) / k, 0, 1)
        return b * (1 - h) + a * h - k * h * (1 - h)

    def ball(p: Array, at: tuple[float, float, float], r: float) -> Array:
        return np.linalg.norm(p - np.array(at), axis=-1) - r

    def pear(p: Array, at: tuple[float, float], lean: float) -> Array:
        cx, cz = at
        body = ball(p, (cx, 0.52, cz), 0.53)
        neck = ball(p, (cx + lean, 1.18, cz), 0.24)
        stalk = np.maximum(
            np.hypot(p[..., 0] - cx - lean - 0.25 * (p[..., 1] - 1.4), p[..., 2] - cz) - 0.035,
            np.abs(p[..., 1] - 1.5) - 0.17,
        )
        return np.minimum(blend(body, neck, 0.42), stalk)

    def things(p: Array) -> list[Array]:
        return [
            p[..., 1],
            pear(p, (-0.55, 0.0), 0.05),
            pear(p, (0.55, -0.45), -0.16),
            ball(p, (0.35, 0.33, 0.75), 0.33),
        ]

    def nearest(p: Array) -> Array:
        return np.min(things(p), axis=0)

    t = np.full(x.shape, 1.5)
    for _ in range(90):
        t = np.minimum(t + 0.85 * nearest(eye + t[..., None] * ray), 30)
    p = eye + t[..., None] * ray
    what = np.argmin(things(p), axis=0)
    e = 1e-3
    normal = np.stack([nearest(p + e * d) - nearest(p - e * d) for d in np.eye(3)], axis=-1)
    normal /= np.maximum(np.linalg.norm(normal, axis=-1, keepdims=True), 1e-9)
    sun = np.array([-0.62, 0.62, 0.48])
    sun /= np.linalg.norm(sun)
    shade, s = np.ones(x.shape), np.full(x.shape, 0.04)
    for _ in range(40):
        d = nearest(p + 0.02 * normal + s[..., None] * sun)
        shade = np.minimum(shade, np.clip(0.5 + 7 * d / s, 0, 1))
        s = s + np.clip(d, 0.02, 0.3)
    close = np.clip(nearest(p + 0.22 * normal) / 0.22, 0, 1)
    lit = np.clip(normal @ sun, 0, 1) * shade
    glance = np.clip((2 * (normal @ sun)[..., None] * normal - sun) @ np.array([0, 0.25, 0.97]), 0, 1) ** 24 * shade
    base = np.choose(what, [0.62, 0.80, 0.66, 0.20])
    speck = np.random.default_rng(3).random((high, wide))
    base = base * np.where((what > 0) & (what < 3) & (speck > 0.985), 0.7, 1)
    value = (
        base * (0.20 * (0.4 + 0.6 * normal[..., 1]) * close + 0.95 * lit)
        + np.choose(what, [0, 0.25, 0.2, 0.45]) * glance
    )
    wall = 0.03 + 0.05 * np.clip(1 - y / high * 1.2, 0, 1) + 0.03 * np.exp(-(((x / wide - 0.3) / 0.35) ** 2))
    far = np.clip((t - 7) / 4, 0, 1)
    value = value * (1 - far) + wall * far
    grey = np.clip(value, 0, 1) ** (1 / 2.2) * 255
    grey += np.random.default_rng(4).normal(0, 2.0, grey.shape)
    Image.fromarray(np.clip(grey, 0, 255).astype(np.uint8)).save(HERE / "pears.jpg", quality=88)


def fells() -> None:
    """Four colours: an evening over hills and a lake."""
    pixels, c = canvas(600, 420)
    sky = skia.GradientShader.MakeLinear([(0, 0), (0, 260)], [0xFF2C3E6B, 0xFFE9B872, 0xFFF5E3C0])
    c.drawRect(skia.Rect.MakeWH(600, 280), skia.Paint(Shader=sky))
    c.drawCircle(395, 190, 46, skia.Paint(Color=0xFFFBF1D8, AntiAlias=True))
    rng = np.random.default_rng(8)
    for k, (level, rough, color) in enumerate(
        ((205, 62, 0xFFB9836B), (240, 46, 0xFF7C4B52), (268, 30, 0xFF2B3556), (286, 10, 0xFF20243C))
    ):
        px = np.linspace(-10, 610, 63)
        wave = sum(np.sin(px / (150 / f) + rng.random() * 6.3) / f for f in (1, 1.7, 2.9, 5.3, 9.1))
        py = level - rough * 0.5 * wave + rng.normal(0, 1.5, px.shape)
        path = skia.Path()
        path.moveTo(-10, 420)
        for a, b in zip(px, py):
            path.lineTo(float(a), float(b))
        path.lineTo(610, 420)
        c.drawPath(path, skia.Paint(Color=color, AntiAlias=True))
        if k == 2:
            lake = skia.GradientShader.MakeLinear([(0, 290), (0, 420)], [0xFFE3B27A, 0xFF344673])
            c.drawRect(skia.Rect.MakeLTRB(0, 292, 600, 420), skia.Paint(Shader=lake))
    for _ in range(90):
        y = 300 + 110 * rng.random()
        x, w = rng.normal(395, 22 + (y - 300) * 0.5), 8 + 0.16 * (y - 290)
        c.drawLine(x - w, y, x + w, y, skia.Paint(Color=0xD0FBF1D8, StrokeWidth=2.2, AntiAlias=True))
    for x in (40, 66, 88, 520, 548, 575):
        h = 70 + 50 * rng.random()
        for k in range(7):
            w = 5 + 3.4 * k
            path = skia.Path()
            y = 392 - h + k * h / 7.6
            path.moveTo(x, y - 14)
            path.lineTo(x - w, y + 12)
            path.lineTo(x + w, y + 12)
            c.drawPath(path, skia.Paint(Color=0xFF151A2C, AntiAlias=True))
    Image.fromarray(pixels[..., [2, 1, 0]]).save(HERE / "fells.jpg", quality=88)


def pines() -> None:
    """In the round: pines and snow for a hat of 120 stitches, a pixel each; right and left edge meet."""
    high, wide = 40, 120
    grid = np.ones((high, wide), bool)  # True is light
    y = np.arange(high)[:, None]
    for at, top, spread in (
        (8, 8, 8),
        (24, 14, 6),
        (37, 5, 9),
        (55, 16, 5),
        (68, 9, 8),
        (84, 15, 6),
        (98, 6, 9),
        (113, 15, 5),
    ):
        x = (np.arange(wide) - at + wide // 2) % wide - wide // 2
        depth = y - top
        tier = depth % 8
        half = np.where(depth < 24, tier * spread / 8 * (0.55 + 0.2 * (depth // 8)), 0.9)
        grid &= ~((depth >= 0) & (y < 36) & (np.abs(x) <= half))
    grid[36:] = (np.add.outer(np.arange(4), np.arange(wide)) % 2).astype(bool)
    for k in range(30):
        a, b = (k * 37 + 11) % wide, (k * 23) % 24
        if grid[b, a]:
            grid[b, a] = False
    Image.fromarray((grid * 255).astype(np.uint8)).convert("1").save(HERE / "pines.png", optimize=True)


def mitten() -> None:
    """A mitten for its mask: a star over a lattice, with the shape that is knitted (49 stitches, 62 rows)."""
    high, wide = 62, 49
    y, x = np.mgrid[0:high, 0:wide]
    u, v = np.abs(x - 24), np.abs(y - 30)
    near, far = np.minimum(u, v), np.maximum(u, v)
    petal = (near <= 7) & (far <= 18) & (far - near + far * 0.2 <= 12) & ((u + v) % 20 > 1) & (near > 0) & (u != v)
    frame = (u + v == 27) & (far <= 21)
    dark = sown(frame | petal)
    dark[-8:] = (x[-8:] // 2 + y[-8:]) % 2 == 0  # a braid of cuff
    side = np.minimum(x, wide - 1 - x)
    dark |= side == 0
    Image.fromarray(((~dark) * 255).astype(np.uint8)).convert("1").save(HERE / "mitten.png", optimize=True)
    tip = np.clip(18 - y, 0, None)
    kept = side >= tip * 1.12
    Image.fromarray((kept * 255).astype(np.uint8)).convert("1").save(HERE / "mitten-shape.png", optimize=True)


def rose() -> None:
    """A repeat of 24 stitches and 32 rows: an eight-petalled rose between bands."""
    wide, high = 24, 32
    y, x = np.mgrid[0:high, 0:wide]
    u, v = np.abs(x - 12), np.abs(y - 16)
    near, far = np.minimum(u, v), np.maximum(u, v)
    petal = (far <= 9) & (far >= 1) & (near >= 1) & (near <= far) & (far - near <= 5) & (near + far <= 13)
    petal &= near != far
    leaf = (u + v == 13) | ((u + v == 11) & (far >= 10))
    band = ((y % 32 < 3) | (y % 32 > 28)) & ((x + np.abs(y - 0 + 3) % 32) % 4 < 2)
    seeds = ((x % 12 == 0) & (v == 11)) | ((u == 12) & (v <= 1))
    vein = (near == 3) & (far > 3) & ((near + far) % 2 == 0)
    dark = sown((petal & ~vein) | leaf | band | seeds)
    Image.fromarray(((~dark) * 255).astype(np.uint8)).convert("1").save(HERE / "rose.png", optimize=True)


DOG = """
.......###..................
......#####.................
.....#######................
...#########................
.#####.#####...............#
############..............##
############..............##
.###########.............##.
....########.............##.
.....#######............##..
......#####.............##..
......####################..
.....#####################..
.....#####################..
.....#####################..
.....#####################..
......####################..
......####################..
......#########..#########..
......#####........#######..
......#####.........######..
......##.##.........##.###..
......##.##.........##..##..
......##.##.........##..##..
......##.##.........##..##..
.....###.##........###..##..
....####.##.......####.###..
"""
HEART = """
.##...##.
####.####
#########
#########
.#######.
..#####..
...###...
....#....
"""


def dogs() -> None:
    """The front of a small jumper: two dogs and a heart between bands of crosses. One pixel is a stitch."""
    dog, heart = (np.array([[c == "#" for c in line] for line in text.split()]) for text in (DOG, HEART))
    wide, high = 85, 69
    panel = np.zeros((high, wide), bool)
    y, x = np.mgrid[0:high, 0:wide]
    centre = x - wide // 2
    for foot in (0, high - 13):
        v = y - foot - 6
        crosses = ((centre + v) % 8 == 4) | ((centre - v) % 8 == 4) | ((centre % 8 == 0) & (v == 0))
        panel |= ((np.abs(v) <= 4) & crosses) | ((np.abs(v) == 6) & (centre % 4 < 2))
    place = (high - len(dog)) // 2 + 1
    panel[place : place + len(dog), 4 : 4 + dog.shape[1]] = dog[:, ::-1]
    panel[place : place + len(dog), wide - 4 - dog.shape[1] : wide - 4] = dog
    panel[place + 8 : place + 8 + len(heart), wide // 2 - 4 : wide // 2 + 5] = heart
    Image.fromarray(((~panel) * 255).astype(np.uint8)).convert("1").save(HERE / "dogs.png", optimize=True)


YOKE = """
............
.#..........
##.....#....
.#....###...
.....##.##..
#...##...##.
##...##.##..
#.....###...
.......#....
.#..........
##..........
.#....#.....
.....###....
....##.##...
...##.#.##..
..##.###.##.
.##...#...##
##....#....#
#....###....
....##.##...
...##...##..
..##.....##.
...##...##..
....##.##...
#....###....
##....#....#
.##...#...##
..##.###.##.
...##.#.##..
....##.##...
.....###....
.#....#.....
##..........
.#...#...#..
....###.###.
#..##.###.##
##..#..#..#.
#...........
............
#.#.#.#.#.#.
.#.#.#.#.#.#
............
"""


def yoke() -> None:
    """Half a motif of a round yoke, 12 stitches wide, to be mirrored. One pixel is a stitch."""
    dark = np.array([[c == "#" for c in line] for line in YOKE.split()])
    Image.fromarray(((~dark) * 255).astype(np.uint8)).convert("1").save(HERE / "yoke.png", optimize=True)


if __name__ == "__main__":
    for draw in (cat, pears, fells, pines, mitten, rose, dogs, yoke):
        draw()
