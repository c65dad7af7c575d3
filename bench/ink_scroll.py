"""Measure what the scroll is made of, and beside it the original: skylines, densities, scenes, blacks and blanks.

``python bench/ink_scroll.py``; with the original's figures beside it: ``python bench/ink_scroll.py FOLDER``, where FOLDER
holds the index.html of {Shan, Shui}* (GitHub, LingDong-/shan-shui-inf; node draws it, and chromium makes the pictures).
"""

from __future__ import annotations

import hashlib
import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from PIL import Image

from tambour.core.progress import Progress
from tambour.ink.ground.codes import HILL
from tambour.ink.ground.marks import BODY
from tambour.ink.params import Ink
from tambour.ink.plan import scroll
from tambour.ink.plotter import job

SEEDS = ("11", "12", "13", "31")
LONG = 25_600.0
"""Units of each seed's scroll."""
SCREEN = 2627.0
"""Units that a screen of 3000 × 800 pixels shows."""
GLANCE, LOW = 1500.0, 120.0
"""Units that one looks at at once; it is nearly empty where no hill's foot in it carries more than so many."""
CALLS = {
    "hill": "mountain", "range": "distMount", "bank": "flatMount", "rock": "rock", "juniper": "tree01",
    "sapling": "tree02", "fir": "tree03", "pine": "tree04", "cedar": "tree05", "plum": "tree06", "bush": "tree07",
    "reed": "tree08", "hut": "arch01", "house": "arch02", "pagoda": "arch03", "pavilion": "arch04",
    "pylon": "transmissionTower01", "boat": "boat01", "figure": "man", "waterfall": "", "willow": "", "hamlet": "",
    "bridge": "",
}  # fmt: skip
"""Our kinds, and the function of the original that draws each."""


class Count:
    """What was found in scrolls that are ``units`` long together."""

    def __init__(self) -> None:
        self.units = 0.0
        self.kinds: dict[str, float] = {}
        self.hills: list[np.ndarray] = []  # per scroll (H, 4): x, y of the foot, height, mean ink
        self.skylines: list[np.ndarray] = []


def skyline(outline: np.ndarray) -> np.ndarray | None:
    """64 heights of a hill's outline over its breadth, 0 … 1 both ways."""
    outline = outline[np.argsort(outline[:, 0], kind="stable")]
    wide, high = np.ptp(outline[:, 0]), np.ptp(outline[:, 1])
    if len(outline) < 8 or wide <= 0 or high <= 0:
        return None
    x = (outline[:, 0] - outline[0, 0]) / wide
    return np.interp(np.linspace(0, 1, 64), x, (outline[:, 1].max() - outline[:, 1]) / high)


def ours() -> Count:
    found = Count()
    for seed in SEEDS:
        piece = scroll.make(None, Ink(seed=seed, span=LONG), Progress())
        found.units += LONG
        for kind, n in piece.elements.items():
            found.kinds[kind] = found.kinds.get(kind, 0) + n
        rows = []
        for marks in piece.batches():
            ink = (1 - marks.fill[:, 0] / 255) * (marks.fill[:, 1] / 255)
            drawn = (marks.fill[:, 1] > 0) & (marks.fill[:, 0] < 250)
            top = marks.elements.parent.copy()
            for e in range(len(top)):
                top[e] = top[top[e]] if top[e] >= 0 else e
            of = top[marks.element]
            for e in np.flatnonzero(marks.elements.kind == HILL).tolist():
                bodies = np.flatnonzero((marks.element == e) & (marks.kind == BODY))
                outline = marks.spine[marks.spines[bodies[0]] : marks.spines[bodies[0] + 1]][:-1]
                line = skyline(outline)
                if line is not None:
                    found.skylines.append(line)
                mine = drawn & (of == e)
                rows.append((*marks.elements.at[e], np.ptp(outline[:, 1]), ink[mine].mean()))
        found.hills.append(np.array(rows))
    return found


def original(folder: Path) -> Count:
    found = Count()
    for seed in SEEDS:
        job = {"seed": seed, "windows": [{"from": 0, "span": LONG, "px": 100}]}
        call = ["node", str(Path(__file__).with_name("original.js")), str(folder), json.dumps(job)]
        told = json.loads(subprocess.run(call, check=True, capture_output=True, text=True).stdout.splitlines()[-1])
        found.units += LONG
        for kind, name in CALLS.items():
            found.kinds[kind] = found.kinds.get(kind, 0) + told["calls"].get(name, 0)
        rows = []
        for hill in told["hills"]:
            outline = np.array(hill["outline"]).reshape(-1, 2)
            if len(outline) < 20:
                continue
            outline = outline[:-1]
            line = skyline(outline)
            if line is not None:
                found.skylines.append(line)
            rows.append((hill["x"], hill["y"], np.ptp(outline[:, 1]), hill["ink"]))
        found.hills.append(np.array(rows))
    return found


def alike(lines: list[np.ndarray]) -> tuple[int, float, float]:
    """How many skylines are another's twin (within 1e-4), and how unlike the nearest one is: median and least, RMS."""
    a = np.array(lines)
    square = (a * a).sum(1)
    away = np.sqrt(np.maximum(0, square[:, None] + square - 2 * a @ a.T) / a.shape[1])
    np.fill_diagonal(away, np.inf)
    near = away.min(1)
    return int((near < 1e-4).sum()), float(np.median(near)), float(near.min())


def scenes(found: Count) -> tuple[float, float, float, float]:
    """Tallest hill over the median one (the median of screens), share of glances nearly empty, correlations of a hill's
    nearness with its ink, and with its height."""
    ratio, empty, near, ink, tall = [], [], [], [], []
    for hills in found.hills:
        near += list(hills[:, 1])
        ink += list(hills[:, 3])
        tall += list(hills[:, 2])
        for left in np.arange(0.0, LONG - SCREEN, SCREEN):
            here = hills[(hills[:, 0] >= left) & (hills[:, 0] < left + SCREEN)]
            if len(here) >= 4:
                ratio.append(here[:, 2].max() / np.median(here[:, 2]))
        for left in np.arange(0.0, LONG - GLANCE, GLANCE):
            here = hills[(hills[:, 0] >= left) & (hills[:, 0] < left + GLANCE)]
            empty.append(not (here[:, 2] > LOW).any())
    return (
        float(np.median(ratio)),
        float(np.mean(empty)),
        float(np.corrcoef(near, ink)[0, 1]),
        float(np.corrcoef(near, tall)[0, 1]),
    )


def tones(folder: Path | None) -> tuple[float, float, float]:
    """Of eight windows of 2,627 units at 1,500 pixels, without paper: shares below 30 of 255 and above 250; the darkest
    thousandth."""
    from tambour.render import flat

    pictures = []
    with tempfile.TemporaryDirectory() as room:
        for seed in SEEDS:
            for start in (0.0, 2.0 * SCREEN):
                if folder is None:
                    told = Ink(seed=seed, from_=start, span=SCREEN, paper=False)
                    drawn = flat.picture(scroll.whole(scroll.make(None, told, Progress())), width=1500).rgba
                    pictures.append(drawn[..., :3].mean(2))
                    continue
                job = {"seed": seed, "windows": [{"from": start, "span": SCREEN}]}
                pictures.append(theirs(folder, job, room, 1500, round(1500 * 700 / SCREEN)))
    all_ = np.concatenate([p.ravel() for p in pictures])
    return float((all_ < 30).mean()), float((all_ > 250).mean()), float(np.quantile(all_, 0.001))


def theirs(folder: Path, job: dict[str, object], room: str, px: int, high: int) -> np.ndarray:
    """A window of the original as greys, drawn by node and chromium."""
    svg, png = f"{room}/a.svg", f"{room}/a.png"
    script = str(Path(__file__).with_name("original.js"))
    told = json.dumps(job | {"windows": [w | {"px": px, "out": svg} for w in job["windows"]]})  # type: ignore[attr-defined]
    subprocess.run(["node", script, str(folder), told], check=True, stdout=subprocess.DEVNULL)
    browser = ["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars"]
    browser += [f"--user-data-dir={room}/user", f"--window-size={px},{high}", f"--screenshot={png}", f"file://{svg}"]
    subprocess.run(browser, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return np.asarray(Image.open(png).convert("L"), float)


def bare(folder: Path | None, many: int) -> float:
    """Of windows of 300 units drawn by hash, the share of which less than 0.3 % is darker than 200."""
    from tambour.render import flat

    count = 0
    with tempfile.TemporaryDirectory() as room:
        for k in range(many):
            h = hashlib.sha256(f"near blank {k}".encode()).digest()
            seed, at = (
                str(int.from_bytes(h[:3], "little") % 9000 + 100),
                float(int.from_bytes(h[3:6], "little") % 20000),
            )
            if folder is None:
                told = Ink(seed=seed, from_=at, span=300.0, paper=False)
                grey = flat.picture(scroll.whole(scroll.make(None, told, Progress())), width=150).rgba[..., :3].mean(2)
            else:
                grey = theirs(folder, {"seed": seed, "windows": [{"from": at, "span": 300}]}, room, 150, 350)
            count += (grey < 200).mean() < 0.003
    return count / many


def plotted() -> None:
    """How long a plotter takes for twenty windows drawn by hash, one pen of 0.3 mm, every fifth on A3, else on A4."""
    minutes = []
    for k in range(20):
        h = hashlib.sha256(f"tambour plotter blind {k}".encode()).digest()
        told = Ink(
            seed=str(int.from_bytes(h[:3], "little") % 9000 + 100),
            from_=float(int.from_bytes(h[3:5], "little") % 4000),
            span=(800.0, 1000.0, 1300.0)[h[5] % 3],
            plotter=True,
            page="a3" if k % 5 == 4 else "a4",
        )
        minutes.append(job.facts(job.make(None, told, Progress()))["minutes"])
    a4 = [m for k, m in enumerate(minutes) if k % 5 != 4]
    print(
        f"plotter, minutes: {min(minutes):.1f} to {max(minutes):.1f}, median {np.median(minutes):.1f}; A4 at most {max(a4):.1f}"
    )


def main() -> None:
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else None
    if folder is not None and not shutil.which("node"):
        sys.exit("the original is drawn by node, which is not here")
    counts = [ours(), *([original(folder)] if folder else [])]
    print(
        f"{len(SEEDS)} seeds × {LONG:,.0f} units; ours"
        + (", the original, and how many times as many" if folder else "")
    )
    for kind in CALLS:
        each = [count.kinds.get(kind, 0) * 1000 / count.units for count in counts]
        times = f"{each[0] / each[1]:8.2f}" if len(each) > 1 and each[1] else ""
        print(f"{kind:>12} per 1,000 units" + "".join(f"{e:9.2f}" for e in each) + times)
    plotted()
    twins = [(len(c.skylines), *alike(c.skylines)) for c in counts]
    for k, what in enumerate(
        ("skylines", "twins among them", "unlike the nearest, median", "unlike the nearest, least")
    ):
        print(f"{what:>28}" + "".join(f"{t[k]:10.4g}" for t in twins))
    told = [scenes(c) for c in counts]
    names = (
        "tallest / median hill of a screen",
        "1,500 units nearly empty, share",
        "nearness and ink, r",
        "nearness and height, r",
    )
    for k, what in enumerate(names):
        print(f"{what:>34}" + "".join(f"{t[k]:9.3f}" for t in told))
    if folder is None or shutil.which("chromium"):
        seen = [tones(None), *([tones(folder)] if folder else [])]
        for k, what in enumerate(("below 30 of 255", "above 250 (blank)", "darkest thousandth")):
            print(f"{what:>34}" + "".join(f"{t[k]:9.4f}" for t in seen))
        shares = [bare(None, 120), *([bare(folder, 40)] if folder else [])]
        print(f"{'300 units all but bare':>34}" + "".join(f"{share:9.3f}" for share in shares))


if __name__ == "__main__":
    main()
