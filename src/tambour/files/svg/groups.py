"""Groups: the elements of an SVG that have a name or notes of their own, and Ink/Stitch's commands tied to them."""

from __future__ import annotations

import re
from collections.abc import Mapping

import numpy as np

from tambour.core.drawing import Groups
from tambour.files.svg.tree import Node


class Noted:
    """The groups met so far, in the order of the walk; an id met again gets a number behind it."""

    def __init__(self) -> None:
        self.ids: list[str] = []
        self.names: list[str] = []
        self.parent: list[int] = []
        self.layer: list[bool] = []
        self.data: list[dict[str, str]] = []
        self.known: dict[str, int] = {}  # id → how often it was met
        self.symbols: dict[str, tuple[str, float, float]] = {}  # id of a command's use → name, place
        self.links: list[tuple[str, str]] = []

    def __len__(self) -> int:
        return len(self.ids)

    def enter(self, node: Node, group: int, more: Mapping[str, str] | None = None) -> int:
        """The group of an element below ``group``: a new one when it has a name or notes of its own, or ``more`` of them."""
        a = node.attributes
        data = {k[5:]: v for k, v in a.items() if k.startswith("data-")}
        data.update({k.replace(":", "-"): v for k, v in a.items() if k.startswith("inkstitch:")})
        marker = re.search(r"#inkstitch-([a-z]+(?:-[a-z]+)*)-marker", a.get("style", "") + a.get("marker-start", ""))
        if marker:
            data["inkstitch-marker"] = marker[1]
        data.update(more or {})
        label = a.get("inkscape:label", "")
        layer = a.get("inkscape:groupmode") == "layer"
        if not (data or label or layer or "id" in a):
            return group
        name = a.get("id", f"{node.name}-{len(self.ids) + 1}")
        unique, n = name, self.known.get(name, 0)
        while unique in self.known:
            n += 1
            unique = f"{name}-{n}"
        self.known[name] = max(n, 1)
        self.known.setdefault(unique, 1)
        self.ids.append(unique)
        self.names.append(label)
        self.parent.append(group)
        self.layer.append(layer)
        self.data.append(data)
        return len(self.ids) - 1

    def kept(self) -> tuple[int, dict[str, int]]:
        """What :meth:`back` goes back to."""
        return len(self.ids), dict(self.known)

    def back(self, to: tuple[int, dict[str, int]]) -> None:
        """Forget the groups met since."""
        size, self.known = to
        for table in (self.ids, self.names, self.parent, self.layer, self.data):
            del table[size:]

    def commands(self) -> None:
        """Put Ink/Stitch's command symbols on the groups of the objects they are tied to."""
        index = {name: k for k, name in enumerate(self.ids)}
        tied = set()
        for a, b in self.links:
            for use, thing in ((a, b), (b, a)):
                if use in self.symbols and thing in index:
                    name, x, y = self.symbols[use]
                    self.data[index[thing]][f"inkstitch-command-{name}"] = f"{x:.6f} {y:.6f}"
                    tied.add(use)
        for use, (name, x, y) in self.symbols.items():
            if use not in tied and self.data:
                self.data[0].setdefault(f"inkstitch-command-{name}", f"{x:.6f} {y:.6f}")

    def table(self) -> Groups:
        """All of them, as a Drawing has them."""
        layer = np.array(self.layer, np.bool_)
        return Groups(tuple(self.ids), tuple(self.names), np.array(self.parent, np.int32), layer, tuple(self.data))
