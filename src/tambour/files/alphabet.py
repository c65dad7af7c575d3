"""Alphabets: the fonts of Ink/Stitch, read: ``font.json`` and the SVG files beside it, a layer for each letter."""

from __future__ import annotations

import json
import unicodedata
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from tambour.core.drawing import Drawing, Groups
from tambour.core.errors import TambourError
from tambour.core.font import Alphabet
from tambour.core.paths import Paths
from tambour.files.svg.path import apply
from tambour.files.svg.read import MM, Reader
from tambour.files.svg.tree import Node, parse

LARGEST = 20_000_000
LAYER = "GlyphLayer-"
VARIANTS = {"ltr": "→", "rtl": "←", "ttb": "↓", "btt": "↑"}
"""A variant's file, and how old fonts call it."""


def read_alphabet(path: Path) -> Alphabet:
    """The font whose ``font.json`` this is, in its usual direction, lengths in mm.

    Raises TambourError for a file that is none, and when the letters' SVG is missing or holds no letter.
    """
    if path.stat().st_size > LARGEST:
        raise TambourError(f"a font.json of more than {LARGEST // 1_000_000} MB is not read", where=str(path))
    try:
        told = json.loads(path.read_text("utf-8"))
        if not isinstance(told, dict):
            raise ValueError
        number = {k: float(told[k]) for k in ("leading", "horiz_adv_x_space", "min_scale", "max_scale") if k in told}
        usual = None if told.get("horiz_adv_x_default") is None else float(told["horiz_adv_x_default"]) * MM
        advance = {str(k): float(v) * MM for k, v in told.get("horiz_adv_x", {}).items()}
        kerning = {str(k): float(v) * MM for k, v in told.get("kerning_pairs", {}).items()}
        variant = str(told.get("default_variant", "ltr"))
    except (ValueError, TypeError, AttributeError):
        raise TambourError("this is no font.json of Ink/Stitch", where=str(path)) from None
    letters: dict[str, Drawing] = {}
    for sheet in _sheets(path.parent, variant):
        letters.update(_letters(sheet))
    if not letters:
        raise TambourError(
            "this font has no letters beside its font.json",
            hint=f"{variant}.svg with layers {LAYER}A, {LAYER}B, … is wanted",
            where=str(path),
        )
    tall = [_height(letters[c]) for c in "HEXIZANTLKMRB" if c in letters]
    tall = tall or [_height(d) for c, d in letters.items() if len(c) == 1 and c.isalnum()] or [10.0]
    capital = float(np.median(tall[:3]))
    return Alphabet(
        letters,
        advance,
        usual,
        number.get("horiz_adv_x_space", 20.0) * MM,
        kerning,
        capital if capital > 0.1 else 10.0,
        number.get("leading", 100.0) * MM,
        (number.get("min_scale", 0.0), number.get("max_scale", float("inf"))),
        str(told.get("name", path.parent.name)),
    )


def _sheets(folder: Path, variant: str) -> list[Path]:
    """The SVG files of a variant: one, or a folder of them."""
    for name in (variant, VARIANTS.get(variant, variant)):
        if (folder / f"{name}.svg").is_file():
            return [folder / f"{name}.svg"]
        if (folder / name).is_dir():
            return sorted((folder / name).glob("*.svg"))
    return []


def _letters(sheet: Path) -> dict[str, Drawing]:
    """Every letter of one SVG file, moved so that its baseline is y 0."""
    root = parse(sheet)
    layers: list[tuple[str, Node]] = []
    _find(root, layers)
    reader = Reader(sheet)
    guide = next(
        (n for n in _all(root) if n.name.endswith("guide") and n.attributes.get("inkscape:label") == "baseline"), None
    )
    base = 0.0
    if guide is not None:
        matrix, _, view = reader.viewport(root)
        up = float(guide.attributes.get("position", "0,0").split(",")[1])
        base = float(apply(matrix, np.array([[0.0, view[1] - up]]))[0, 1])
    whole = reader.drawing(root)
    by_name = {name: k for k, name in enumerate(whole.groups.names)}
    made = {}
    for name, node in layers:
        k = by_name.get(node.attributes.get("inkscape:label", ""))
        letter = None if k is None else part(whole, k, base)
        if letter is not None and ("." not in name or len(name) == 1):
            made[unicodedata.normalize("NFC", name)] = letter
    return made


def _all(node: Node) -> list[Node]:
    return [node, *(n for child in node.children for n in _all(child))]


def _find(node: Node, layers: list[tuple[str, Node]]) -> None:
    """Collect the letters' layers, and let them be seen: editors leave them hidden."""
    label = node.attributes.get("inkscape:label", "")
    if label.startswith(LAYER):
        node.attributes.pop("display", None)
        style = node.attributes.get("style", "")
        node.attributes["style"] = ";".join(w for w in style.split(";") if w.split(":")[0].strip() != "display")
        layers.append((label[len(LAYER) :], node))
    for child in node.children:
        _find(child, layers)


def part(whole: Drawing, group: int, base: float) -> Drawing | None:
    """What a Drawing holds in one of its groups, its baseline moved to y 0; None for nothing."""
    parent = whole.groups.parent
    within = np.zeros(len(parent), bool)
    for k in range(len(parent)):  # a parent stands before its children
        within[k] = k == group or (parent[k] >= 0 and within[parent[k]])
    mine = np.flatnonzero((whole.group >= 0) & within[np.maximum(whole.group, 0)])
    if not len(mine):
        return None
    parts = np.arange(len(whole.paths) + 1) if whole.paths.parts is None else whole.paths.parts
    lines: list[Any] = []
    ends = [0]
    for m in mine.tolist():
        lines += [whole.paths[i] - np.array([0.0, base]) for i in range(int(parts[m]), int(parts[m + 1]))]
        ends.append(len(lines))
    kept = np.flatnonzero(within)
    number = {int(k): n for n, k in enumerate(kept)}
    data = whole.groups.data or tuple({} for _ in parent)
    groups = Groups(
        tuple(whole.groups.ids[k] for k in kept),
        tuple(whole.groups.names[k] for k in kept),
        np.array([number.get(int(parent[k]), -1) for k in kept], np.int32),
        np.zeros(len(kept), bool),
        tuple(_lifted(data[k], base) for k in kept),
    )
    paths = Paths.of(lines)
    return replace(
        whole,
        paths=Paths(paths.coords, paths.offsets, np.array(ends)),
        style=whole.style[mine],
        group=np.array([number[int(g)] for g in whole.group[mine]], np.int32),
        groups=groups,
        images=(),
        about={},
    )


def _lifted(data: Any, base: float) -> dict[str, str]:
    """A group's data; places of Ink/Stitch's commands moved with their letter."""
    made = dict(data)
    for key, value in data.items():
        if key.startswith("inkstitch-command"):
            x, y = (float(v) for v in value.split())
            made[key] = f"{x:.6f} {y - base:.6f}"
    return made


def _height(letter: Drawing) -> float:
    return -float(letter.paths.coords[:, 1].min())
