"""Shades: yarns to choose from, and the choice of those that a picture needs."""

from __future__ import annotations

import csv
import re
from collections.abc import Callable
from dataclasses import dataclass
from io import StringIO

import numpy as np

from tambour import color
from tambour.core.check import Array
from tambour.core.errors import Problem, Span, TambourError, Text
from tambour.core.palette import Palette
from tambour.core.progress import Progress
from tambour.core.rgb import unhexed
from tambour.knit.params import KnitParams
from tambour.knit.picture.resample import LUMA

# Our own shade cards; names say what the colours look like.
CARDS: dict[str, tuple[tuple[str, str], ...]] = {
    "natural": (
        ("fleece", "#f4efe3"),
        ("oatmeal", "#dccfb4"),
        ("fawn", "#b79b77"),
        ("moorit", "#7a5236"),
        ("silver grey", "#b9b6b0"),
        ("steel grey", "#7d7c7a"),
        ("charcoal", "#4a4846"),
        ("black sheep", "#241f1d"),
    ),
    "wool": (
        ("snow", "#f6f4ee"),
        ("cream", "#efe3c4"),
        ("sand", "#d2b98c"),
        ("straw", "#e3c35a"),
        ("mustard", "#c08a1e"),
        ("marmalade", "#d8701f"),
        ("rust", "#9c4421"),
        ("poppy", "#c62828"),
        ("madder", "#8a1f2b"),
        ("plum", "#54213f"),
        ("heather", "#9a7aa6"),
        ("rose", "#d98a9a"),
        ("blush", "#efc9c4"),
        ("ice", "#cfe0e6"),
        ("sky", "#7fb2d3"),
        ("cornflower", "#3f6fb5"),
        ("navy", "#1d2b4f"),
        ("teal", "#1e6b72"),
        ("sea green", "#5fa38d"),
        ("moss", "#7c8a3a"),
        ("bottle", "#1f4a35"),
        ("bark", "#5a4030"),
        ("ash", "#a8a7a2"),
        ("slate", "#5d6670"),
        ("coal", "#26262a"),
    ),
}


@dataclass(frozen=True, slots=True)
class Shade:
    """A yarn: its name, colour (sRGB), and how much there is (None: enough)."""

    name: str
    rgb: tuple[int, int, int]
    metres: float | None = None
    grams: float | None = None


def stash(text: Text) -> list[Shade]:
    """The yarns of a CSV file with the columns name, colour, metres, grams (the last two may be left out or empty).

    Raises TambourError with every line that cannot be read.
    """
    problems: list[Problem] = []
    offset, lines = 0, []
    for line in text.text.split("\n"):
        if line.strip() and not line.lstrip().startswith("#,"):
            lines.append((offset, line))
        offset += len(line) + 1
    if not lines:
        raise TambourError("the stash is empty", hint="wanted lines of name, colour, metres, grams", where=text.name)
    split = ";" if lines[0][1].count(";") > lines[0][1].count(",") else ","
    titles = [t.strip().lower() for t in next(csv.reader(StringIO(lines[0][1]), delimiter=split))]
    alias = {"color": "colour", "meters": "metres", "m": "metres", "g": "grams"}
    titles = [alias.get(t, t) for t in titles]
    if "name" not in titles or "colour" not in titles:
        raise TambourError(
            "the first line must name the columns",
            hint="name, colour, metres, grams",
            span=Span(lines[0][0], lines[0][0] + len(lines[0][1])),
            source=text,
        )
    found: list[Shade] = []
    for start, line in lines[1:]:
        values = [v.strip() for v in next(csv.reader(StringIO(line), delimiter=split))]
        entry = dict(zip(titles, values))
        span = Span(start, start + len(line))

        def amount(what: str, entry: dict[str, str] = entry, span: Span = span) -> float | None:
            given = entry.get(what, "")
            if not given:
                return None
            if not re.fullmatch(r"\d+\.?\d*", given):
                problems.append(Problem(f"{given!r} is not a number of {what}", span=span, source=text))
                return None
            return float(given)

        colour = entry.get("colour", "")
        if not re.fullmatch(r"#[0-9a-fA-F]{6}", colour):
            problems.append(Problem(f"{colour!r} is not a colour", "wanted #rrggbb", span=span, source=text))
            continue
        rgb = bytes.fromhex(colour[1:])
        found.append(Shade(entry.get("name", ""), (rgb[0], rgb[1], rgb[2]), amount("metres"), amount("grams")))
    if len({(s.name, s.rgb) for s in found}) < len(found):
        problems.append(Problem("two lines are the same yarn", "add their amounts up", where=text.name))
    if problems:
        raise TambourError(problems)
    return found


def named(text: str) -> Shade | None:
    """The colour that ``text`` says: #rrggbb, or the name of a shade of a card; None for neither."""
    if re.fullmatch(r"#[0-9a-fA-F]{6}", text.strip()):
        return Shade("", unhexed(text.strip()))
    for card in CARDS.values():
        for name, code in card:
            if name == text.strip().lower():
                return Shade(name, unhexed(code))
    return None


def candidates(picture: Array, params: KnitParams) -> list[Shade]:
    """The yarns to choose from: those named, the shade card, the stash, or else colours of the picture's own."""
    if params.colors:
        return [Shade("", unhexed(c)) for c in params.colors]
    if params.stash is not None:
        return stash(params.stash)
    if params.card != "none":
        return [Shade(n, unhexed(c)) for n, c in CARDS[params.card]]
    flat = few(picture, params.count)
    return flat if len(flat) == params.count else own(picture)


SHARE, ENOUGH, NEAR = (
    0.01,
    0.6,
    0.08,
)  # of flat art: the least share of a colour, of all of them; what counts as one (Oklab)


def few(picture: Array, count: int) -> list[Shade]:
    """The ``count`` colours that flat art is made of, the commonest first; fewer, or none, where it is not.

    A colour counts that is exactly the same in 1 % of the stitches and more, unless it is near one already taken (two
    near reds are one yarn to a knitter), or but the soft edge between two others, a stitch wide wherever it stands.
    """
    whole, place, number = np.unique(picture.reshape(-1, 3), axis=0, return_inverse=True, return_counts=True)
    broad = solid(place.reshape(picture.shape[:2]), len(whole))
    order = np.argsort(-number, kind="stable")
    order = order[number[order] >= SHARE * number.sum()]
    if number[order].sum() < ENOUGH * number.sum():
        return []
    taken: list[int] = []
    lab = color.oklab(whole)
    for k in order.tolist():
        if not broad[k] and between(whole[k], whole[order]):
            continue
        if len(taken) < count and all(np.linalg.norm(lab[k] - lab[j]) >= NEAR for j in taken):
            taken.append(k)
    return [Shade("", (int(r), int(g), int(b))) for r, g, b in whole[taken]]


def solid(place: Array, count: int) -> Array:
    """(count,) bool: which of the numbers in ``place`` (R, C) fill a square of two by two somewhere."""
    a = place[:-1, :-1]
    square = (a == place[1:, :-1]) & (a == place[:-1, 1:]) & (a == place[1:, 1:])
    return np.bincount(a[square], minlength=count) > 0


def between(colour: Array, others: Array) -> bool:
    """Whether a colour (3,) uint8 is a mixture of two of the others (N, 3)."""
    v, o = colour.astype(float), others.astype(float)
    for i in range(len(o)):
        way = o - o[i]
        size = np.maximum((way**2).sum(1), 1e-9)
        share = ((v - o[i]) * way).sum(1) / size
        off = np.linalg.norm(o[i] + share[:, None] * way - v, axis=1)
        if ((off < 12) & (share > 0.08) & (share < 0.92)).any():
            return True
    return False


def own(picture: Array) -> list[Shade]:
    """Twelve means of the picture's colours, and the same pushed away from their middle, so that mixtures reach them."""
    pixels = sample(picture).reshape(-1, 3)
    means = clusters(pixels, 12)
    middle = pixels.mean(0)
    pushed = np.concatenate([middle + k * (means - middle) for k in (1.0, 1.3, 1.7)])
    rgb = np.unique(np.round(np.clip(pushed, 0, 1) * 255).astype(np.uint8), axis=0)
    return [Shade("", (int(c[0]), int(c[1]), int(c[2]))) for c in rgb]


def sample(picture: Array) -> Array:
    """(≤ 64, ≤ 64, 3) float64 in 0…1: the picture at a glance, its rows kept rows."""
    from PIL import Image

    rows, stitches = picture.shape[:2]
    small = Image.fromarray(np.ascontiguousarray(picture)).resize(
        (min(64, stitches), min(64, rows)), Image.Resampling.BOX
    )
    return np.asarray(small, np.float64) / 255


def clusters(pixels: Array, count: int) -> Array:
    """(count, 3) means (Lloyd's iteration), begun at even steps along the brightness order: no chance in it."""
    order = np.argsort(pixels @ LUMA.astype(float), kind="stable")
    means = pixels[order[np.linspace(0, len(pixels) - 1, count).astype(int)]]
    for _ in range(20):
        nearest = ((pixels[:, None] - means[None]) ** 2).sum(2).argmin(1)
        means = np.stack([pixels[nearest == k].mean(0) if (nearest == k).any() else means[k] for k in range(count)])
    return means


def contrast(a: tuple[int, int, int], b: tuple[int, int, int]) -> float:
    """Contrast of luminance of two colours, 1 to 21 (WCAG 2)."""
    la, lb = sorted((float(color.luminance(np.array(a, np.uint8))), float(color.luminance(np.array(b, np.uint8)))))
    return (lb + 0.05) / (la + 0.05)


def pair_costs(picture: Array, rgb: Array, low: float) -> Array:
    """(rows, K, K) float64: squared distance of each row of a small picture to the mixtures of each pair of yarns.

    picture : (rows, n, 3) in 0…1; rgb : (K, 3) in 0…1; low : the least share that either yarn of a pair has.
    """
    count = len(rgb)
    out = np.full((len(picture), count, count), np.inf)
    for a in range(count):
        for b in range(count):
            if a == b:
                continue
            way = rgb[b] - rgb[a]
            size = float(way @ way)
            if size < 1e-9:
                continue
            share = np.clip((picture - rgb[a]) @ way / size, low, 1 - low)
            out[:, a, b] = ((picture - rgb[a] - share[..., None] * way) ** 2).sum((1, 2))
    return out


def choose(costs: Array, count: int) -> list[int]:
    """``count`` yarns out of K whose best pair in each row, (rows, K, K) ``costs``, comes to least: greedy, then swaps."""
    total = costs.shape[1]

    def cost(chosen: list[int]) -> float:
        return float(costs[:, chosen][:, :, chosen].min((1, 2)).sum())

    sums = costs.sum(0)
    chosen = [int(k) for k in np.unravel_index(int(sums.argmin()), sums.shape)]
    while len(chosen) < count:
        rest = [k for k in range(total) if k not in chosen]
        chosen.append(min(rest, key=lambda k: cost([*chosen, k])))
    return swapped(chosen, total, cost)


def swapped(chosen: list[int], total: int, cost: Callable[[list[int]], float]) -> list[int]:
    """``chosen`` out of 0 … total - 1, one exchanged for another as long as that costs less."""
    best, better = cost(chosen), True
    while better:
        better = False
        for place in range(len(chosen)):
            for k in range(total):
                other = [*chosen[:place], k, *chosen[place + 1 :]]
                if k not in chosen and (price := cost(other)) < best * (1 - 1e-9):
                    chosen, best, better = other, price, True
    return chosen


def dark_to_light(shades: list[Shade]) -> Palette:
    """The palette of some yarns, the darkest first."""
    order = sorted(shades, key=lambda s: (float(np.array(s.rgb) @ LUMA), s.name))
    return Palette(np.array([s.rgb for s in order], np.uint8), tuple(s.name for s in order))


def palette_of(picture: Array, params: KnitParams, progress: Progress) -> Palette:
    """The yarns of the piece, dark to light, as the picture needs them.

    picture : (R, C, 3) uint8. Raises TambourError when there are too few to choose from, or no pair with the contrast
    that --min-contrast asks for; warns of pairs without it among colours that were named one by one.
    """
    shades = candidates(picture, params)
    if len(shades) < params.count:
        raise TambourError(
            f"{params.count} yarns are wanted, there are {len(shades)} to choose from",
            where="{--stash}" if params.stash is not None else "{--yarns}",
        )
    if len(shades) > params.count:
        rgb = np.array([s.rgb for s in shades]) / 255
        small = sample(picture)
        if params.count == 2:
            # Two yarns show brightness alone: compare with the greys that the picture is between them.
            small = small @ LUMA.astype(float)[:, None] * np.ones(3)
            rgb = rgb @ LUMA.astype(float)[:, None] * np.ones(3)
        costs = pair_costs(small, rgb, 0.0 if params.count == 2 else 0.1)
        for a, first in enumerate(shades):
            for b, second in enumerate(shades):
                if contrast(first.rgb, second.rgb) < params.min_contrast:
                    costs[:, a, b] = np.inf
        costs = np.where(np.isinf(costs), 1e9, costs)
        if costs.sum(0).min() >= 1e9:
            raise TambourError(
                f"no two of the {len(shades)} yarns have a contrast of {params.min_contrast:g}",
                where="{--min-contrast}",
            )
        shades = [shades[k] for k in choose(costs, params.count)]
    if params.count == 2 and contrast(shades[0].rgb, shades[1].rgb) < params.min_contrast:
        progress.warn(
            f"the two yarns have a contrast of {contrast(shades[0].rgb, shades[1].rgb):.2f}, the picture will be faint",
            where="{--min-contrast}",
        )
    return dark_to_light(shades)


def warn_of_shortage(palette: Palette, needs: list[tuple[int, float]], params: KnitParams, progress: Progress) -> None:
    """Warn of each yarn of the stash that is shorter than the piece ``needs``: (palette entry, metres)."""
    if params.stash is None:
        return
    held = {(s.name, s.rgb): s.metres for s in stash(params.stash)}
    for k, metres in needs:
        rgb = palette.rgb[k]
        name = palette.names[k]
        have = held.get((name, (int(rgb[0]), int(rgb[1]), int(rgb[2]))))
        if have is not None and have < metres:
            progress.warn(
                f"{name} will run out: about {metres:.0f} m are needed, there are {have:g} m", where="{--stash}"
            )
