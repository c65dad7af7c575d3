"""Plan: which tiles are made, and of what each is made: a seed, a number, and what else the ink craft can be told."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final

from tambour import files
from tambour.core.errors import Problem, TambourError, did_you_mean
from tambour.run import craft
from tambour.sweep.axes import field
from tambour.sweep.plan import Piece, key
from tambour.work.piece import Job

TILE: Final = 512
"""Scroll units of a tile of pictures; tile k begins at 512 k."""
SMALL: Final = 350
"""Pixels of a small picture's height: half of a tile's."""
PICTURES: Final = (".png", ".jpg", ".jpeg", ".webp")
SHEETS: Final = (".svg", ".hpgl", ".plt", ".pdf")
LAST: Final = 10**9
"""The farthest number of a tile: beyond it tenths of a unit are lost."""
OWN: Final = ("seed", "from_", "span", "pixels", "sheets", "specimen", "inscription", "seal", "font")
"""What is not set by ``--set``: options of their own, or nothing that a tile could have."""


@dataclass(frozen=True, slots=True)
class Tiles:
    """Tiles ``first`` to ``first + count - 1``.

    name : "tile" (pictures and SVG), "sheet" (of a plotter) or "hoop" (of a machine) ; how : the function that makes one
    given : ink's parameters as texts or values, all but the window ; pixels : width of a picture
    """

    name: str
    how: str
    given: Mapping[str, Any]
    first: int
    count: int
    out: Sequence[str]
    pixels: int = TILE

    def piece(self, number: int) -> Piece:
        """Tile ``number``."""
        if self.name == "tile":
            window: dict[str, Any] = {"from_": float(number * TILE), "span": float(TILE), "pixels": self.pixels}
        else:
            window = {"plotter": True, "sheets": str(number)}
        params = craft("ink").params.of({**self.given, **window})
        name = f"{self.name}={number}"
        small = SMALL if self.name == "tile" else 0
        job = Job("ink", params.plain(), [name + kind for kind in self.out], thumb=small, how=self.how)
        return Piece(key(job), name, {self.name: number}, job)

    def pieces(self) -> Iterator[Piece]:
        """Every tile, by its number."""
        for number in range(self.first, self.first + self.count):
            yield self.piece(number)


def tiles(
    seed: str, first: int, count: int, kinds: Sequence[str], sets: Sequence[str] = (), pixels: int = TILE
) -> tuple[Tiles, list[Problem]]:
    """The plan of some tiles, and warnings. TambourError with all that cannot be.

    kinds : suffixes: pictures and ``.svg``; with the parameter ``plotter`` sheets; machine files make hoops
    sets : ink's parameters, ``NAME=VALUE``
    """
    problems: list[Problem] = []
    given: dict[str, Any] = {"seed": seed}
    for text in sets:
        name, equals, value = text.partition("=")
        where = f"{{--set}} {name}"
        try:
            known = field(craft("ink"), name)
        except TambourError as error:
            problems += error.problems
            continue
        if known in OWN:
            problems.append(Problem("is not set so here: tiles have a seed and a number", where=where))
        elif not equals:
            problems.append(Problem("no value is given", "such as season=winter", where=where))
        elif known in given:
            problems.append(Problem("is set twice", where=where))
        else:
            given[known] = value
    if not kinds:
        kinds = (".png",)
    machine = {s for s, kind in files.WRITE if kind == "ThreadPlan"}
    known_kinds = {*PICTURES, *SHEETS, *machine}
    for kind in kinds:
        if kind not in known_kinds:
            hint = did_you_mean(kind, known_kinds) or "there are .png, .svg, .hpgl, .dst and more"
            problems.append(Problem(f'there are no "{kind}" tiles', hint, where=f"-o {kind}"))
    hoops = [k for k in kinds if k in machine]
    if hoops and len(hoops) < len(kinds):
        problems.append(
            Problem(
                "hoops are made by themselves, without pictures",
                "make the pictures by a command of their own",
                where=f"-o {hoops[0]}",
            )
        )
    if not (abs(first) <= LAST and abs(first + count) <= LAST):
        problems.append(Problem(f"tiles are numbered from -{LAST:,} to {LAST:,}", where="{--first}"))
    if problems:
        raise TambourError(problems)
    if hoops:
        if str(given.pop("plotter", "yes")).lower() in ("no", "false", "0", "off"):
            raise TambourError(
                "hoops are sewn along the plotter's lines", hint="leave plotter out", where="{--set} plotter"
            )
        given = {"page": "100x100mm", "margin": "5mm", "nib": "0.4mm", **given}
        made = Tiles("hoop", "tambour.tiles.hoop:make", given, first, count, tuple(kinds))
    else:
        plotted = craft("ink").params.of(given).plotter
        if lost := [k for k in kinds if k in (".hpgl", ".plt", ".pdf") and not plotted]:
            told = "these are a plotter's"
            raise TambourError(told, hint="add --set plotter=yes, or take .png or .svg", where=f"-o {lost[0]}")
        how = "tambour.tiles.sheet:make" if plotted else "tambour.work.piece:make"
        made = Tiles("sheet" if plotted else "tile", how, given, first, count, tuple(kinds), pixels)
    params = made.piece(first).job.params
    full = craft("ink").params.of(dict(params))
    if made.name != "tile" and full.margin < 3:
        raise TambourError("marks of registration stand in the margin", hint="--set margin=5mm", where="{--set} margin")
    return made, full.idle()
