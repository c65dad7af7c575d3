"""Looks: how an element of an SVG is drawn: what it inherits, its attributes, the sheets' rules, its ``style``."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace

from tambour.core.check import Array
from tambour.core.drawing import Placed
from tambour.files.svg import css
from tambour.files.svg.path import IDENTITY
from tambour.files.svg.tree import Node
from tambour.files.svg.windows import Window

SIZES = {
    "xx-small": 9.0,
    "x-small": 10.0,
    "small": 13.0,
    "medium": 16.0,
    "large": 18.0,
    "x-large": 24.0,
    "xx-large": 32.0,
}
INITIAL = 16.0  # px: the size of letters when nothing is said
_REM = re.compile(r"(?<![\w.#-])([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)rem\b", re.I)
_FREE = ("inherit", "currentcolor", "initial", "unset")


@dataclass(frozen=True, eq=False, slots=True)
class Look:
    """Where and how an element is drawn.

    matrix : (2, 3) from its units to mm; props : its properties; met : the rules met so far; group : of the drawing
    view : what per cent are of, in its units; window : what of it shows; shown : the opacity of it all
    using : ids of what is being copied, so that nothing copies itself; clip : it cuts others, and has no colours
    veils : pictures (Placed) whose light is a mask: of pictures only
    """

    matrix: Array = field(default_factory=lambda: IDENTITY)
    props: Mapping[str, str] = field(default_factory=dict)
    met: css.Met = css.NOTHING
    group: int = -1
    depth: int = 0
    view: tuple[float, float] = (100.0, 100.0)
    window: Window | None = None
    shown: float = 1.0
    using: frozenset[str] = frozenset()
    clip: bool = False
    veils: tuple[Placed, ...] = ()

    @property
    def visible(self) -> bool:
        """Whether it is not hidden by ``visibility``."""
        return self.props.get("visibility", "visible").strip() not in ("hidden", "collapse")

    @property
    def scale(self) -> float:
        """mm of one of its units, in the mean of all directions."""
        m = self.matrix
        return math.sqrt(abs(float(m[0, 0]) * float(m[1, 1]) - float(m[0, 1]) * float(m[1, 0])))


def properties(
    node: Node, rules: css.Rules, met: css.Met, inherited: Mapping[str, str], doubt: Callable[[str], None]
) -> dict[str, str]:
    """The properties of an element; ``doubt`` is told of a value that means nothing, which counts as not given."""
    props = {k: v for k, v in inherited.items() if k in css.INHERITED or k.startswith("context-")}
    given: list[tuple[str, str]] = [
        (k, v) for k, v in node.attributes.items() if k in css.PRESENTED and k != "transform"
    ]
    plain, important = css.weighed(node.attributes.get("style", ""))
    for more in (rules.declared(met), plain, rules.declared(met, important=True), important):
        given += more.items()
    own: dict[str, str] = {}
    for name, value in given:
        value = value.strip()
        word = value.lower()
        if not value or name not in css.PRESENTED:
            continue
        if word == "inherit" or (word in ("unset", "revert") and name in css.INHERITED):
            own[name] = inherited.get(name, "")
        elif word in ("initial", "unset", "revert"):
            props.pop(name, None)
            own[name] = "medium" if name == "font-size" else ""
        elif _usable(name, value):
            own[name] = value
        else:
            doubt(f"{name}: {value[:40]!r} means nothing there")
    props.update({k: v for k, v in own.items() if v})
    props["font-size"] = repr(_font_size(own.get("font-size", ""), inherited.get("font-size", "16")))
    return props


def _usable(name: str, value: str) -> bool:
    word = value.lower()
    try:
        if name in ("fill", "stroke", "color", "stop-color"):
            if word != "currentcolor" and not word.startswith(("url(", "context-", "var(")):
                css.color(value)
        elif name.endswith("opacity"):
            css.share(value)
        elif name == "stroke-miterlimit":
            return float(value) >= 1
        elif name == "stroke-width":
            return css.length(value, 100.0) >= 0
        elif name == "stroke-dashoffset":
            css.length(value, 100.0)
    except ValueError:
        return False
    return True


def _font_size(text: str, above: str) -> float:
    """A font size in px."""
    size = float(above)
    word = text.strip().lower()
    if word in ("larger", "smaller"):
        return size * 1.2 if word == "larger" else size / 1.2
    if word in SIZES:
        return SIZES[word]
    try:
        return max(1e-3, css.length(text, size, size)) if text else size
    except ValueError:
        return size


def rooted(root: Node, rules: list[css.Rule]) -> tuple[float, list[css.Rule]]:
    """The root's font size in px, and the rules; lengths in ``rem`` of that size are spelled in px, in the tree in place.

    Nobody who reads a length need know the root so.
    """
    its, a = css.Rules(rules), root.attributes
    met = its.meet(css.NOTHING, root.name, a.get("id", ""), frozenset(a.get("class", "").split()), a)
    size = float(properties(root, its, met, {}, lambda said: None)["font-size"])
    if size == INITIAL:
        return size, rules

    def spelled(text: str) -> str:
        return _REM.sub(lambda found: f"{float(found[1]) * size!r}px", text)

    stack = [root]
    while stack:
        node = stack.pop()
        for name, text in node.attributes.items():
            if "rem" in text.lower() and name not in ("id", "class"):
                node.attributes[name] = spelled(text)
        stack += node.children
    a["style"] = f"{a.get('style', '')};font-size:{size!r}px!important"  # its own was of the initial size
    return size, [
        replace(
            rule,
            declares={k: spelled(v) for k, v in rule.declares.items()},
            important={k: spelled(v) for k, v in rule.important.items()},
        )
        for rule in rules
    ]
