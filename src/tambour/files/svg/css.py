"""The style of SVG: style sheets, declarations, colours and lengths, as far as shapes need them."""

from __future__ import annotations

import colorsys
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from tambour.core.rgb import css_colors

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
PX = {"px": 1.0, "": 1.0, "mm": 96 / 25.4, "cm": 960 / 25.4, "in": 96.0, "pt": 96 / 72, "pc": 16.0, "q": 24 / 25.4}
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
    for part in _bare(text).split(";"):
        name, colon, value = part.partition(":")
        if colon:
            found[name.strip().lower()] = re.sub(r"!\s*important$", "", value.strip()).rstrip()
    return found


def _bare(text: str) -> str:
    """The text without its comments; one that is not closed goes to the end."""
    kept, *rest = text.split("/*")
    inside = False
    for piece in rest:
        _, closed, after = piece.partition("*/")
        inside = not closed
        kept += "" if inside else after
    return kept


@dataclass(frozen=True, slots=True)
class Rule:
    """A selector (compounds joined by descendant " " or child ">") and what it declares."""

    compounds: tuple[tuple[str, str, frozenset[str], str], ...]  # (element, id, classes, combinator before)
    weight: tuple[int, int, int]
    declares: Mapping[str, str]


_COMPOUND = re.compile(r"([\w-]+|\*)?((?:[#.][\w-]+)*)")
_BITS = 64  # compounds in a selector


def sheet(text: str) -> list[Rule]:
    """The rules of a style sheet; at-rules and selectors beyond type, class, id, descendant and child are left out."""
    rules: list[Rule] = []
    depth, prelude, body = 0, "", ""
    for piece in re.split(r"([{};])", _bare(text).replace("<!--", "").replace("-->", "")):
        if piece == "{":
            depth += 1
        elif piece == "}":
            if depth == 1 and not prelude.lstrip().startswith("@"):
                declares = declarations(body)
                rules += filter(None, (_selector(one.strip(), declares) for one in prelude.split(",")))
            if depth <= 1:
                prelude = body = ""
            depth = max(0, depth - 1)
        elif depth:
            body += piece if depth == 1 else ""
        elif piece == ";":
            prelude = ""
        else:
            prelude = piece
    return rules


def _selector(text: str, declares: Mapping[str, str]) -> Rule | None:
    compounds: list[tuple[str, str, frozenset[str], str]] = []
    ids = classes = types = 0
    combinator = ""
    for word in text.replace(">", " > ").split():
        if word == ">":
            combinator = ">"
            continue
        found = _COMPOUND.fullmatch(word)
        if not found or len(compounds) == _BITS:
            return None
        name = found[1] or "*"
        marks = re.findall(r"([#.])([\w-]+)", found[2])
        named = [m for k, m in marks if k == "#"]
        classed = frozenset(m for k, m in marks if k == ".")
        compounds.append((name, named[0] if named else "", classed, combinator or " "))
        combinator = ""
        ids, classes, types = ids + len(named), classes + len(classed), types + (name != "*")
    return Rule(tuple(compounds), (ids, classes, types), declares) if compounds else None


@dataclass(frozen=True, slots=True)
class Met:
    """How far the rules were met on the way down to an element: rule → a bit for each of its compounds.

    here : the compound, with all before it, ends at the element; above : at it, or at an ancestor of it
    """

    here: Mapping[int, int]
    above: Mapping[int, int]


NOTHING = Met({}, {})


class Rules:
    """The rules of all sheets of a file, the weaker ones first.

    Every element is held once against the compounds that may fit it; what its ancestors met is remembered, so that no
    selector is tried along many ways.
    """

    def __init__(self, rules: Iterable[Rule] = ()) -> None:
        self.rules = sorted(rules, key=lambda r: r.weight)
        self.by_mark: dict[str, list[tuple[int, int]]] = {}
        for r, rule in enumerate(self.rules):
            for k, (name, named, classed, _) in enumerate(rule.compounds):
                mark = f"#{named}" if named else f".{min(classed)}" if classed else name
                self.by_mark.setdefault(mark, []).append((r, k))

    def meet(self, above: Met, element: str, its_id: str, classes: frozenset[str]) -> Met:
        """What an element meets below one that met ``above``."""
        here: dict[int, int] = {}
        for mark in ("*", element, f"#{its_id}", *(f".{c}" for c in classes)):
            for r, k in self.by_mark.get(mark, ()):
                name, named, classed, combinator = self.rules[r].compounds[k]
                if name not in ("*", element) or (named and named != its_id) or not classed <= classes:
                    continue
                way = above.here if combinator == ">" else above.above
                if k == 0 or way.get(r, 0) >> (k - 1) & 1:
                    here[r] = here.get(r, 0) | 1 << k
        if all(above.above.get(r, 0) | bits == above.above.get(r, 0) for r, bits in here.items()):
            return Met(here, above.above)
        return Met(here, {**above.above, **{r: above.above.get(r, 0) | bits for r, bits in here.items()}})

    def declared(self, met: Met) -> dict[str, str]:
        """What the rules declare that select the element."""
        made: dict[str, str] = {}
        for r in sorted(met.here):
            if met.here[r] >> (len(self.rules[r].compounds) - 1) & 1:
                made.update(self.rules[r].declares)
        return made


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
    if word in css_colors():
        return *css_colors()[word], 255
    raise ValueError(f"{text[:40]!r} is no colour")


def _share(text: str) -> float:
    value = float(text.removesuffix("%")) / 100 if text.endswith("%") else float(text)
    if not abs(value) < 1e6:
        raise ValueError(f"{text!r} is too large")
    return value
