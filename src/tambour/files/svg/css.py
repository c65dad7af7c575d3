"""The style of SVG: style sheets, declarations, colours and lengths, as far as shapes need them."""

from __future__ import annotations

import colorsys
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

INHERITED = frozenset(
    [
        "fill",
        "fill-opacity",
        "fill-rule",
        "stroke",
        "stroke-width",
        "stroke-opacity",
        "visibility",
        "color",
        "font-size",
        "font-family",
        "font-weight",
        "text-anchor",
        "letter-spacing",
    ]
)
PRESENTED = INHERITED | {"opacity", "display", "stop-color", "stop-opacity", "transform"}
PX = {
    "px": 1.0, "": 1.0, "mm": 96 / 25.4, "cm": 960 / 25.4, "in": 96.0, "pt": 96 / 72, "pc": 16.0, "q": 24 / 25.4,
}  # fmt: skip
_LENGTH = re.compile(r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(px|mm|cm|in|pt|pc|q|em|ex|rem|%)?\s*$", re.I)


def length(text: str, whole: float = 0.0, em: float = 16.0) -> float:
    """A length in px (1/96 in); ``whole`` is what 100% means. ValueError when it is none."""
    found = _LENGTH.match(text)
    if not found:
        raise ValueError(f"{text[:40]!r} is no length")
    value, unit = float(found[1]), (found[2] or "").lower()
    if unit == "%":
        value *= whole / 100
    elif unit in ("em", "rem"):
        value *= em
    elif unit == "ex":
        value *= em / 2
    else:
        value *= PX[unit]
    if not abs(value) < 1e9:
        raise ValueError(f"{text[:40]!r} is too large")
    return value


def declarations(text: str) -> dict[str, str]:
    """``name: value; …`` as a mapping; what is not of that form is left out, as browsers do."""
    found = {}
    for part in re.sub(r"/\*.*?\*/", "", text, flags=re.S).split(";"):
        name, colon, value = part.partition(":")
        if colon:
            found[name.strip().lower()] = re.sub(r"\s*!\s*important\s*$", "", value.strip())
    return found


@dataclass(frozen=True, slots=True)
class Rule:
    """A selector (compounds joined by descendant " " or child ">") and what it declares."""

    compounds: tuple[tuple[str, str, frozenset[str], str], ...]  # (element, id, classes, combinator before)
    weight: tuple[int, int, int]
    declares: Mapping[str, str]


_COMPOUND = re.compile(r"([\w-]+|\*)?((?:[#.][\w-]+)*)$")


def sheet(text: str) -> list[Rule]:
    """The rules of a style sheet; at-rules and selectors beyond type, class, id, descendant and child are left out."""
    text = re.sub(r"/\*.*?\*/|<!--|-->", "", text, flags=re.S)
    text = re.sub(r"@[\w-]+[^{};]*\{(?:[^{}]*\{[^{}]*\})*[^{}]*\}|@[^;{]*;", "", text)
    rules = []
    for selectors, body in re.findall(r"([^{}]+)\{([^{}]*)\}", text):
        declares = declarations(body)
        for selector in selectors.split(","):
            rule = _selector(selector.strip(), declares)
            if rule is not None:
                rules.append(rule)
    return sorted(rules, key=lambda r: r.weight)


def _selector(text: str, declares: Mapping[str, str]) -> Rule | None:
    compounds = []
    ids = classes = types = 0
    combinator = ""
    for word in re.sub(r"\s*>\s*", " > ", text).split():
        if word == ">":
            combinator = ">"
            continue
        found = _COMPOUND.match(word)
        if not found:
            return None
        name = (found[1] or "*").split("|")[-1]
        marks = re.findall(r"([#.])([\w-]+)", found[2])
        named = [m for k, m in marks if k == "#"]
        classed = frozenset(m for k, m in marks if k == ".")
        compounds.append((name, named[0] if named else "", classed, combinator or " "))
        combinator = ""
        ids, classes, types = ids + len(named), classes + len(classed), types + (name != "*")
    return Rule(tuple(compounds), (ids, classes, types), declares) if compounds else None


def matches(rule: Rule, chain: Sequence[tuple[str, str, frozenset[str]]]) -> bool:
    """Whether the last of ``chain`` (element, id, classes from the root down) is selected."""

    def fits(k: int, at: int) -> bool:
        name, named, classed, combinator = rule.compounds[k]
        element, its_id, its_classes = chain[at]
        if name not in ("*", element) or (named and named != its_id) or not classed <= its_classes:
            return False
        if k == 0:
            return True
        if combinator == ">":
            return at > 0 and fits(k - 1, at - 1)
        return any(fits(k - 1, up) for up in range(at - 1, -1, -1))

    return fits(len(rule.compounds) - 1, len(chain) - 1)


def color(text: str) -> tuple[int, int, int, int] | None:
    """RGBA of a CSS colour, None for ``none``; ValueError for what is no colour (``url(…)`` is the caller's)."""
    word = text.strip().lower()
    if word in ("none", "transparent"):
        return None
    found = re.fullmatch(r"#([0-9a-f]{3,8})", word)
    if found:
        digits = found[1]
        if len(digits) in (3, 4):
            digits = "".join(2 * d for d in digits)
        if len(digits) in (6, 8):
            value = bytes.fromhex(digits)
            return value[0], value[1], value[2], value[3] if len(value) > 3 else 255
    found = re.fullmatch(r"(rgb|hsl)a?\(([^)]*)\)", word)
    if found:
        parts = [p for p in re.split(r"[\s,/]+", found[2].strip()) if p]
        if len(parts) in (3, 4):
            alpha = _share(parts[3]) if len(parts) == 4 else 1.0
            if found[1] == "rgb":
                rgb = [_share(p) if p.endswith("%") else float(p) / 255 for p in parts[:3]]
            else:
                hue = float(parts[0].removesuffix("deg")) / 360 % 1
                rgb = list(colorsys.hls_to_rgb(hue, _share(parts[2]), _share(parts[1])))
            r, g, b, a = (round(255 * min(1.0, max(0.0, c))) for c in (*rgb, alpha))
            return r, g, b, a
    from PIL import ImageColor

    if word in ImageColor.colormap:
        r, g, b = ImageColor.getrgb(word)[:3]
        return r, g, b, 255
    raise ValueError(f"{text[:40]!r} is no colour")


def _share(text: str) -> float:
    value = float(text.removesuffix("%")) / 100 if text.endswith("%") else float(text)
    if not abs(value) < 1e6:
        raise ValueError(f"{text!r} is too large")
    return value
