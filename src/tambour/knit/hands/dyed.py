"""Dyed: a chart whose yarns take other colours; its stitches stay as they are."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from tambour.core.chart import Chart
from tambour.core.errors import Problem, TambourError, did_you_mean
from tambour.core.palette import Palette
from tambour.core.rgb import hexed
from tambour.knit.hands.working import roles
from tambour.knit.picture.shades import CARDS, named


def dyed(chart: Chart, told: Sequence[tuple[str, str, str]]) -> Chart:
    """The chart with each (yarn, colour, where that was said) done.

    yarn : MC, CC, CC1 …, its number from 1, or its colour as #rrggbb; colour : #rrggbb, or a shade of a card. Raises
    TambourError for what is neither, and for two yarns of one colour.
    """
    rgb, names = chart.palette.rgb.copy(), list(chart.palette.names)
    called = {role.lower(): k for k, role in roles(chart).items()}
    called |= {str(k + 1): k for k in range(len(rgb))} | {hexed(c): k for k, c in enumerate(chart.palette.rgb.tolist())}
    problems = []
    for yarn, colour, where in told:
        found, k = named(colour), called.get(yarn.strip().lower())
        if k is None:
            problems.append(Problem("there is no such yarn", ", ".join(called), where=where))
        if found is None:
            near = did_you_mean(colour.strip().lower(), [name for card in CARDS.values() for name, _ in card])
            problems.append(Problem("there is no such colour", near or "#rrggbb, or a shade of a card", where=where))
        if k is not None and found is not None:
            rgb[k], names[k] = found.rgb, found.name
            if any(hexed(rgb[j].tolist()) == hexed(found.rgb) for j in range(len(rgb)) if j != k):
                problems.append(Problem("another yarn has this colour", "give each its own", where=where))
    if problems:
        raise TambourError(problems)
    return replace(chart, palette=Palette(np.ascontiguousarray(rgb), tuple(names), chart.palette.codes))
