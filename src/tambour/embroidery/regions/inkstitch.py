"""What the attributes of Ink/Stitch's files mean here (its published attribute names; angles counter-clockwise)."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from tambour.core.errors import TambourError

METHODS = {
    "auto_fill": "tatami",
    "legacy_fill": "tatami",
    "contour_fill": "contour",
    "guided_fill": "guided",
    "meander_fill": "meander",
    "circular_fill": "spiral",
    "linear_gradient_fill": "gradient",
    "cross_stitch": "cross",
}
_TRUE = ("true", "1", "yes", "on")


def _number(text: str) -> float:
    return float(text.split()[0])


# attribute → (parameter, reading)
FILL: dict[str, tuple[str, Callable[[str], Any]]] = {
    "angle": ("angle", _number),
    "row_spacing_mm": ("row_spacing", _number),
    "end_row_spacing_mm": ("row_spacing_end", _number),
    "max_stitch_length_mm": ("length", _number),
    "staggers": ("stagger", lambda t: max(1, round(_number(t)))),
    "expand_mm": ("pull", _number),
    "min_stitch_length_mm": ("min_length", _number),
}
SATIN: dict[str, tuple[str, Callable[[str], Any]]] = {
    "zigzag_spacing_mm": ("row_spacing", _number),
    "pull_compensation_mm": ("pull", _number),
    "max_stitch_length_mm": ("split", _number),
    "min_stitch_length_mm": ("min_length", _number),
}
STROKE: dict[str, tuple[str, Callable[[str], Any]]] = {
    "running_stitch_length_mm": ("length", _number),
    "min_stitch_length_mm": ("min_length", _number),
}


def _true(data: Mapping[str, str], name: str) -> bool:
    return data.get(f"inkstitch-{name}", "").strip().lower() in _TRUE


def is_satin(data: Mapping[str, str]) -> bool:
    """Whether the object is a satin column given by its rails."""
    return _true(data, "satin_column")


def flags(data: Mapping[str, str]) -> frozenset[str]:
    """Trims and stops asked for by attribute or by command symbol."""
    return frozenset(
        word for word in ("trim", "stop") if _true(data, f"{word}_after") or f"inkstitch-command-{word}" in data
    )


def overrides(data: Mapping[str, str], name: str) -> dict[str, Any]:
    """Parameters that an object's ``inkstitch-…`` data ask for; TambourError naming the object for unusable values."""
    notes = [key for key in data if key.startswith("inkstitch-") and not key.startswith("inkstitch-command")]
    if not notes:
        return {}
    table = SATIN if is_satin(data) else {**STROKE, **FILL}
    made: dict[str, Any] = {}
    for attribute, (parameter, reading) in table.items():
        text = data.get(f"inkstitch-{attribute}", "").strip()
        if not text:
            continue
        try:
            made[parameter] = reading(text)
        except (ValueError, IndexError):
            raise TambourError(f"inkstitch:{attribute}={text!r} is not a number", where=name) from None
    # What its own program fills with when it says nothing more.
    made.setdefault("angle", 0.0)
    method = data.get("inkstitch-fill_method", "")
    if method in METHODS or any(key.startswith("inkstitch-fill") or key == "inkstitch-auto_fill" for key in notes):
        made["stitch"] = METHODS.get(method, "tatami")
    if is_satin(data):
        made["stitch"] = "satin"
        words = [
            w
            for a, w in (("center_walk", "center"), ("contour", "edge"), ("zigzag", "zigzag"))
            if _true(data, f"{a}_underlay")
        ]
        made["underlay"] = "+".join(words) or "none"
    elif "inkstitch-fill_underlay" in data:
        made["underlay"] = "tatami" if _true(data, "fill_underlay") else "none"
    stroke = data.get("inkstitch-stroke_method", "")
    if stroke == "running_stitch":
        made.setdefault("stitch", "running")
        beans = data.get("inkstitch-bean_stitch_repeats", "").split()
        if beans and beans[0].isdigit() and int(beans[0]) > 0:
            made["stitch"], made["repeats"] = "bean", min(9, 2 * int(beans[0]) + 1)
    elif stroke == "manual_stitch":
        made["stitch"] = "manual"
    elif stroke == "ripple_stitch":
        made["stitch"] = "ripple"
    elif stroke == "zigzag_stitch":
        made["stitch"] = "satin"
    if "inkstitch-ties" in data:
        made["locks"] = data["inkstitch-ties"].strip() not in ("3", "false", "none")
    return made
