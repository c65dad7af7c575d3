"""Mutated SVGs: a design or one clear line, never another exception (issue 5, must show)."""

from __future__ import annotations

import warnings

import numpy as np
import pytest

from night import NIGHT
from tambour import files
from tambour.core.errors import TambourError
from tambour.core.progress import Progress
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.plan.make import make

SEEDS = [
    '<svg xmlns="http://www.w3.org/2000/svg" width="20mm" height="16mm" viewBox="0 0 20 16"><style>.a{fill:#f00}</style><g transform="rotate(5)">'
    '<path class="a" d="M2 2h6v6h-6zM4,4h2v2h-2z" fill-rule="evenodd"/><circle cx="14" cy="5" r="3"/></g><path d="M1 12c4-4 8 4 16 0" stroke="#00f" stroke-width="1.5" fill="none"/></svg>',
    '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" viewBox="0 0 60 40"><defs><g id="s"><rect width="9" height="7" rx="2"/></g></defs>'
    '<use xlink:href="#s" x="2" y="3"/><use href="#s" transform="translate(20,5) scale(1.2)"/><text x="5" y="35" font-size="9">Ab</text></svg>',
    '<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkstitch="http://inkstitch.org/namespace" width="60" height="40"><path id="q" inkstitch:satin_column="true" inkstitch:zigzag_spacing_mm="0.8" '
    'd="M5 5 H45 M5 12 H50 M20 2 V15" stroke="#333" fill="none"/><polygon points="5,20 30,20 20,38" fill="rgb(10,200,30)" data-tambour-angle="30" data-tambour-row-spacing="0.8mm"/></svg>',
]
WORDS = [
    "nan",
    "1e99",
    "-",
    "NaN",
    "1e-9",
    "0",
    "9" * 12,
    "%",
    "url(#q)",
    "M",
    "z",
    "A",
    "<",
    ">",
    "&",
    '"',
    "</g>",
    "<g>",
    "é",
    "\x00",
    "inherit",
    "e",
    ".",
    "#",
    "use",
    "px",
]


def mutated(text, draw):
    for _ in range(int(draw.integers(1, 4))):
        at = int(draw.integers(0, len(text)))
        how = int(draw.integers(0, 9))
        if how == 0:
            text = text[:at] + text[at + int(draw.integers(1, 12)) :]
        elif how == 1:
            text = text[:at] + WORDS[int(draw.integers(0, len(WORDS)))] + text[at:]
        elif how == 2:
            text = text[:at] + chr(int(draw.integers(32, 127))) + text[at + 1 :]
        elif how == 3:
            numbers = [i for i, c in enumerate(text) if c.isdigit()]
            i = numbers[int(draw.integers(0, len(numbers)))] if numbers else 0
            text = text[:i] + WORDS[int(draw.integers(0, 8))] + text[i + 1 :]
        elif how > 4:
            numbers = [i for i, c in enumerate(text) if c.isdigit()]
            i = numbers[int(draw.integers(0, len(numbers)))] if numbers else 0
            text = text[:i] + str(int(draw.integers(0, 10))) + text[i + 1 :]
        else:
            n = int(draw.integers(5, 60))
            text = text[:at] + text[at : at + n] * 2 + text[at + n :]
    return text


@pytest.mark.slow
def test_mutations(tmp_path):
    draw = np.random.Generator(np.random.PCG64(11))
    path = tmp_path / "m.svg"
    made = refused = 0
    count = 2000 if NIGHT else 700
    for k in range(count):
        path.write_text(mutated(SEEDS[k % len(SEEDS)], draw), encoding="utf-8", errors="replace")
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                drawing = files.read(path, ("Drawing",))
                if k % 4 == 0:  # reading is tried on all, sewing on a quarter: it takes longer
                    piece = make(drawing, EmbroideryParams(row_spacing=1.0, width=20.0), Progress())
                    assert len(piece.plan) > 1
            made += 1
        except TambourError as error:
            assert error.problems and all(p.message and "\n" not in p.message for p in error.problems)
            refused += 1
    assert made + refused == count and min(made, refused) > 0.15 * count
