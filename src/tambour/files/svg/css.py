"""The style of SVG: style sheets, declarations, colours and lengths, as far as shapes need them."""

from __future__ import annotations

import colorsys
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from types import MappingProxyType

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
        "clip-rule",
        "stroke-linecap",
        "stroke-linejoin",
        "stroke-miterlimit",
        "stroke-dasharray",
        "stroke-dashoffset",
        "paint-order",
        "marker-start",
        "marker-mid",
        "marker-end",
    ]
)
PRESENTED = INHERITED | frozenset(
    [
        "opacity",
        "display",
        "stop-color",
        "stop-opacity",
        "transform",
        "transform-origin",
        "clip-path",
        "mask",
        "mask-type",
        "filter",
        "overflow",
        "vector-effect",
        "mix-blend-mode",
    ]
)
PX = {"px": 1.0, "": 1.0, "mm": 96 / 25.4, "cm": 960 / 25.4, "in": 96.0, "pt": 96 / 72, "pc": 16.0, "q": 24 / 25.4}
_LENGTH = re.compile(
    r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(px|mm|cm|in|pt|pc|q|em|ex|ch|rem|vw|vh|vmin|vmax|%)?\s*$", re.I
)


def length(text: str, whole: float = 0.0, em: float = 16.0, view: tuple[float, float] = (100.0, 100.0)) -> float:
    """A length in px (1/96 in); ``whole`` is what 100% means, ``view`` what vw and vh do. ValueError when it is none."""
    found = _LENGTH.match(text)
    if not found:
        raise ValueError(f"{text[:40]!r} is no length")
    value, unit = float(found[1]), (found[2] or "").lower()
    if unit == "%":
        value *= whole / 100
    elif unit == "em":
        value *= em
    elif unit == "rem":
        value *= 16.0
    elif unit in ("ex", "ch"):
        value *= em / 2
    elif unit[:1] == "v":
        value *= {"vw": view[0], "vh": view[1], "vmin": min(view), "vmax": max(view)}[unit] / 100
    else:
        value *= PX[unit]
    if not abs(value) < 1e9:
        raise ValueError(f"{text[:40]!r} is too large")
    return value


def declarations(text: str) -> dict[str, str]:
    """``name: value; …`` as a mapping; what is not of that form is left out, as browsers do."""
    plain, important = weighed(text)
    return {**plain, **important}


def weighed(text: str) -> tuple[dict[str, str], dict[str, str]]:
    """The declarations of a text: the plain ones, and those marked ``!important``."""
    found: tuple[dict[str, str], dict[str, str]] = ({}, {})
    for part in _bare(text).split(";"):
        name, colon, value = part.partition(":")
        if colon:
            bare = re.sub(r"!\s*important$", "", value.strip()).rstrip()
            where = found[bare != value.strip()]
            if name.strip().lower() == "marker":
                where.update({f"marker-{k}": bare for k in ("start", "mid", "end")})
            else:
                where[name.strip().lower()] = bare
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


Test = tuple[str, str, str]  # of an attribute: its name, how it is compared ("" for being there), with what


@dataclass(frozen=True, slots=True)
class Compound:
    """What one element must be: its name ("*" for any), id, classes, attributes; ``before`` joins it to what stands before."""

    name: str
    id: str
    classes: frozenset[str]
    tests: tuple[Test, ...]
    before: str

    def fits(self, element: str, its_id: str, classes: frozenset[str], attributes: Mapping[str, str]) -> bool:
        """Whether an element is so."""
        return (
            self.name in ("*", element)
            and self.id in ("", its_id)
            and self.classes <= classes
            and all(name in attributes and _COMPARE[how](attributes[name], value) for name, how, value in self.tests)
        )


_COMPARE: dict[str, Callable[[str, str], bool]] = {
    "": lambda has, value: True,
    "=": lambda has, value: has == value,
    "~=": lambda has, value: value in has.split(),
    "|=": lambda has, value: has == value or has.startswith(f"{value}-"),
    "^=": lambda has, value: value != "" and has.startswith(value),
    "$=": lambda has, value: value != "" and has.endswith(value),
    "*=": lambda has, value: value != "" and value in has,
}


@dataclass(frozen=True, slots=True)
class Rule:
    """A selector (compounds joined by descendant " " or child ">") and what it declares."""

    compounds: tuple[Compound, ...]
    weight: tuple[int, int, int]
    declares: Mapping[str, str]
    important: Mapping[str, str]


_COMPOUND = re.compile(r"([\w-]+|\*)?((?:[#.][\w-]+|\[[^\]]*\])*)")
_MARK = re.compile(r"([#.])([\w-]+)|\[\s*([\w:-]+)\s*(?:([~|^$*]?=)\s*(?:\"([^\"]*)\"|'([^']*)'|([^\]]*?))\s*)?\]")
_BITS = 64  # compounds in a selector


def sheet(text: str, leave: Callable[[str], None] = lambda what: None) -> list[Rule]:
    """The rules of a style sheet; ``leave`` is told of selectors beyond type, class, id, attribute, descendant, child."""
    rules: list[Rule] = []
    depth, prelude, body = 0, "", ""
    for piece in re.split(r"([{};])", _bare(text).replace("<!--", "").replace("-->", "")):
        if piece == "{":
            depth += 1
        elif piece == "}":
            if depth == 1 and not prelude.lstrip().startswith("@"):
                declares = weighed(body)
                for one in prelude.split(","):
                    rule = _selector(one.strip(), declares)
                    if rule is not None:
                        rules.append(rule)
                    elif one.strip():
                        leave("a style rule whose selector is not known")
            if depth <= 1:
                prelude = body = ""
            depth = max(0, depth - 1)
        elif depth:
            body += (";" if piece == ";" else piece) if depth == 1 else ""
        elif piece == ";":
            prelude = ""
        else:
            prelude = piece
    return rules


def _selector(text: str, declares: tuple[Mapping[str, str], Mapping[str, str]]) -> Rule | None:
    compounds: list[Compound] = []
    ids = classes = types = 0
    combinator = ""
    for word in re.findall(r"(?:\[[^\]]*\]|[^\s\[])+", re.sub(r">(?![^\[]*\])", " > ", text)):
        if word == ">":
            combinator = ">"
            continue
        found = _COMPOUND.fullmatch(word)
        if not found or len(compounds) == _BITS:
            return None
        name = found[1] or "*"
        marks = list(_MARK.finditer(found[2]))
        if "".join(m[0] for m in marks) != found[2]:
            return None
        named = [m[2] for m in marks if m[1] == "#"]
        classed = frozenset(m[2] for m in marks if m[1] == ".")
        tests = tuple((m[3], m[4] or "", m[5] or m[6] or m[7] or "") for m in marks if m[3])
        compounds.append(Compound(name, named[0] if named else "", classed, tests, combinator or " "))
        combinator = ""
        ids, classes, types = ids + len(named), classes + len(classed) + len(tests), types + (name != "*")
    return Rule(tuple(compounds), (ids, classes, types), *declares) if compounds else None


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
            for k, it in enumerate(rule.compounds):
                mark = f"#{it.id}" if it.id else f".{min(it.classes)}" if it.classes else it.name
                self.by_mark.setdefault(mark, []).append((r, k))

    def meet(
        self,
        above: Met,
        element: str,
        its_id: str,
        classes: frozenset[str],
        attributes: Mapping[str, str] = MappingProxyType({}),
    ) -> Met:
        """What an element meets below one that met ``above``."""
        here: dict[int, int] = {}
        for mark in ("*", element, f"#{its_id}", *(f".{c}" for c in classes)):
            for r, k in self.by_mark.get(mark, ()):
                compound = self.rules[r].compounds[k]
                if not compound.fits(element, its_id, classes, attributes):
                    continue
                way = above.here if compound.before == ">" else above.above
                if k == 0 or way.get(r, 0) >> (k - 1) & 1:
                    here[r] = here.get(r, 0) | 1 << k
        if all(above.above.get(r, 0) | bits == above.above.get(r, 0) for r, bits in here.items()):
            return Met(here, above.above)
        return Met(here, {**above.above, **{r: above.above.get(r, 0) | bits for r, bits in here.items()}})

    def declared(self, met: Met, important: bool = False) -> dict[str, str]:
        """What the rules declare that select the element, plainly or as important."""
        made: dict[str, str] = {}
        for r in sorted(met.here):
            if met.here[r] >> (len(self.rules[r].compounds) - 1) & 1:
                made.update(self.rules[r].important if important else self.rules[r].declares)
        return made


def color(text: str) -> tuple[int, int, int, int] | None:
    """RGBA of a CSS colour, None for ``none``; ValueError for what is no colour (``url(…)`` is the caller's)."""
    word = re.sub(r"(?<=\S)\s+(icc-color|device-\w+)\(.*$", "", text.strip().lower())
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
            alpha = share(parts[3]) if len(parts) == 4 else 1.0
            if found[1] == "rgb":
                rgb = [share(p) if p.endswith("%") else float(p) / 255 for p in parts[:3]]
            else:
                hue = _degrees(parts[0]) / 360 % 1
                light, full = (min(1.0, max(0.0, share(p))) for p in (parts[2], parts[1]))
                rgb = list(colorsys.hls_to_rgb(hue, light, full))
            r, g, b, a = (round(255 * min(1.0, max(0.0, c))) for c in (*rgb, alpha))
            return r, g, b, a
    if word in css_colors():
        return *css_colors()[word], 255
    raise ValueError(f"{text[:40]!r} is no colour")


def _degrees(text: str) -> float:
    """An angle in degrees: 120, 120deg, 2.1rad, .5turn, 100grad."""
    found = re.fullmatch(r"([-+\d.]+(?:e[-+]?\d+)?)(deg|rad|turn|grad)?", text)
    if not found:
        raise ValueError(f"{text!r} is no angle")
    return float(found[1]) * {"rad": 57.29577951308232, "turn": 360.0, "grad": 0.9}.get(found[2] or "", 1.0)


def share(text: str) -> float:
    """A number or per cent, such as an opacity."""
    text = text.strip()
    value = float(text.removesuffix("%")) / 100 if text.endswith("%") else float(text)
    if not abs(value) < 1e6:
        raise ValueError(f"{text!r} is too large")
    return value
