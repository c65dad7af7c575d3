"""Gauge: which gauge a piece has, by its options, else by what its pattern states, else as usual."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Final

from tambour.crochet.yarns import (
    CIRCLE,
    SQUARE,
    UNDER,
    WEIGHTS,
    Gauge,
    class_of,
    expected,
    hook_of,
    ravelled,
    swatch_of,
)

if TYPE_CHECKING:
    from tambour.core.errors import Span
    from tambour.crochet.params import CrochetParams


FAR: Final = 1.7
"""So many times smaller or larger than usual, a hook is doubted: lace is worked up to one and a half times as loosely."""


def gauge(params: CrochetParams, stated: Mapping[str, tuple[str, Span]]) -> Gauge:
    """The gauge of a piece: by the options, else by what the pattern states, else 5 mm.

    Of the options a measured circle comes before a swatch, a swatch before unravelled yarn, that before the stitch's
    own size, and all of them before what yarn and hook let expect. An option always comes before the pattern's words.
    """
    said = {key: words for key, (words, _) in stated.items()}
    weight, hook = class_of(params.yarn or ""), params.hook
    told = tuple(n for n, v in (("yarn", weight), ("hook", hook)) if v)
    own_weight, own_hook = class_of(said.get("yarn", "")), hook_of(said.get("hook", ""))
    swatch = swatch_of(said["gauge"]) if "gauge" in said else None
    size: tuple[float, float] | None = None
    if params.gauge_circle is not None:
        size = params.gauge_circle * math.pi / (6 * CIRCLE), params.gauge_circle / (2 * CIRCLE)
        source = f"a flat circle of five rounds, {params.gauge_circle / 10:g} cm across (--gauge-circle)"
    elif params.gauge is not None:
        size = params.swatch()
        source = f"a flat swatch, {params.gauge} in 10 cm (--gauge)"
    elif params.gauge_yarn is not None:
        width = ravelled(params.gauge_yarn)
        size = width, width * SQUARE
        source = (
            f"unravelled yarn, {params.gauge_yarn}: a stitch is an eighth as wide as its yarn is long (--gauge-yarn)"
        )
    elif params.stitch_width is not None or params.stitch_height is not None:
        size = (
            params.stitch_width or params.stitch_height or 5.0,
            params.stitch_height or params.stitch_width or 5.0,
        )
        source = "the stitch's own size (--stitch-width, --stitch-height)"
    elif not told and swatch is not None:
        size = swatch
        source = f"the gauge that the pattern states: {' '.join(said['gauge'].split())}"
    if size is not None:
        told = (*told, "gauge")
    told = (*told, *(n for n, v in (("yarn", own_weight), ("hook", own_hook)) if v and n not in told))
    weight, hook = weight or own_weight, hook or own_hook
    if size is None and (weight or hook):
        weight = weight or _nearest_hook(hook or 3.5)
        hook = hook or WEIGHTS[weight].amigurumi
        width = expected(weight, hook)
        size = width, width * SQUARE
        if params.yarn_under:
            size = size[0] * UNDER[0], size[1] * UNDER[1]
        source = f"expected of {WEIGHTS[weight].name} yarn worked tightly with a {hook:g} mm hook; swatch to be sure"
    elif size is None:
        size, source = (5.0, 5.0), "5 × 5 mm to a stitch, for want of a gauge; --gauge, --yarn and --hook say more"
        if params.yarn_under:
            size, source = (
                (5.0 * UNDER[0], 5.0 * UNDER[1]),
                "4.75 × 4.5 mm to a stitch with the yarn under the hook, for want of a gauge",
            )
    weight = weight or _nearest_width(size[0])
    return Gauge(size[0], size[1], source, weight, hook or WEIGHTS[weight].amigurumi, told)


def odd_hook(known: Gauge) -> tuple[str, str] | None:
    """What is doubtful in a hook and a yarn that were both named, and what to do: no hand works them together. None where it can."""
    usual = WEIGHTS[known.weight]
    if not {"hook", "yarn"} <= set(known.told) or usual.amigurumi / FAR <= known.hook <= usual.hook * FAR:
        return None
    said = f"a hook of {known.hook:g} mm is far from those that {usual.name} yarn is worked with, {usual.amigurumi:g} to {usual.hook:g} mm"
    return said, "check {--hook} and {--yarn}, or what the pattern says of them"


def _nearest_hook(hook: float) -> str:
    return min(WEIGHTS, key=lambda k: abs(math.log(WEIGHTS[k].amigurumi / hook)))


def _nearest_width(width: float) -> str:
    return min(WEIGHTS, key=lambda k: abs(math.log(expected(k, WEIGHTS[k].amigurumi) / width)))
