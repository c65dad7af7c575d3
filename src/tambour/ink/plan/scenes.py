"""Scenes: the scroll as a chain of compositions, each a function of the seed and its number alone.

A hand scroll is read a stretch at a time, from right to left: open water, an approach, the host peak among its guests, a
valley with people in it, a near bank to close. Each scene is one of the three distances of the old books on painting
(Guo Xi, about 1080): *high*, one looks up at a host peak; *deep*, one looks past ridge after ridge into a valley; *level*,
one looks over water to a low shore. No scene is of its neighbour's kind.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any

import numpy as np

from tambour.ink.elements import hills as forms
from tambour.ink.elements.cun import AXE, HEMP, RAIN
from tambour.ink.ground import codes
from tambour.ink.plan.whole import Planned, Rules, place
from tambour.noise import key, stream

SPACING = 2250.0
"""Mean length of a scene."""
JITTER = 700.0
"""A scene's borders lie anywhere within this length about their places: scenes are 1,550 to 2,950 long."""
REACH = SPACING + JITTER
"""How far from the begin of its stretch a scene's wholes may stand."""
HIGH, DEEP, LEVEL = range(3)
FARTHEST, NEAREST = 305.0, 640.0
"""Where the feet of the farthest and the nearest hills stand (y)."""


def distance(rules: Rules, m: int) -> int:
    """Which of the three distances scene ``m`` is: even scenes draw lots, odd ones take what neither neighbour has."""
    chance = stream("ink", rules.seed, rules.edition, "distance", m).random(2)
    if m % 2 == 0:
        return int(3 * chance[0])
    left = [k for k in (HIGH, DEEP, LEVEL) if k not in (distance(rules, m - 1), distance(rules, m + 1))]
    return left[int(len(left) * chance[0])]


def border(rules: Rules, m: int) -> float:
    """Where scene ``m`` begins, on its left."""
    return SPACING * m + JITTER * (float(stream("ink", rules.seed, rules.edition, "border", m).random()) - 0.5)


def families(rules: Rules) -> list[int]:
    """The two families of wrinkles of a scroll."""
    left_out = key("ink", rules.seed, rules.edition, "families") % 3
    return [int(f) for k, f in enumerate((HEMP, AXE, RAIN)) if k != left_out]


BARE = 200.0
"""Units that may lie bare."""


@dataclass(slots=True)
class Stage:
    """A scene being set: where it lies, its stream of chance, and what stands in it so far."""

    rules: Rules
    m: int
    begin: float
    end: float
    chance: np.random.Generator
    family: int
    made: list[Planned] = field(default_factory=list)
    counts: dict[int, int] = field(default_factory=dict)

    def x(self, s: float) -> float:
        """The place that a reader comes to after the part ``s`` of the scene."""
        long = self.end - self.begin
        return self.end - s * long if self.rules.reading == "rtl" else self.begin + s * long

    def u(self, low: float = 0.0, high: float = 1.0) -> float:
        """A number between ``low`` and ``high``."""
        return float(low + (high - low) * self.chance.random())

    def put(
        self,
        kind: int,
        x: float,
        y: float,
        depth: float,
        how: tuple[Any, ...],
        left: float,
        right: float,
        ink: float | None = None,
    ) -> Planned:
        """Stand something."""
        number = self.counts.get(kind, 0)
        self.counts[kind] = number + 1
        p = place(self.rules, kind, self.m, number, x, y, depth, how, left, right, ink)
        self.made.append(p)
        return p

    def hill(
        self,
        x: float,
        near: float,
        height: float,
        width: float,
        form: int,
        lean: float = 0.0,
        wet: float = 0.0,
        misty: float = 0.7,
    ) -> None:
        """A hill at depth ``near`` (0 far … 1 near), with water at its foot by the chance ``wet`` and mist by ``misty``."""
        y = FARTHEST + (NEAREST - FARTHEST) * near
        height *= self.rules.height
        reach = 0.5 * width + 150.0
        wrinkled = int(min(260.0, 40.0 + 0.7 * height))
        ink = 0.14 + 0.84 * near**0.9
        how = (height, width, int(form), lean, self.family, wrinkled, 0.6 + 0.5 * near)
        hill = self.put(codes.HILL, x, y, y, how, reach, reach, ink)
        if self.u() < wet:
            long = 0.5 * width + 180.0
            self.put(
                codes.WATER, x, y, y - 10_000.0, (2.0, long, 7), long + 5.0, long + 5.0, min(0.5, 0.15 + 0.5 * near)
            )
        if self.u() < misty and self.rules.mist > 0.0:
            self.put(codes.MIST, x, y, hill.y + 0.5, (self.rules.mist * (1.15 - 0.6 * near), width), 700.0, 700.0)

    def often(self, count: float) -> int:
        """So many, more or fewer by the density."""
        return int(count * self.rules.density + self.chance.random()) if self.rules.density > 0.0 else 0


@lru_cache(maxsize=256)
def scene(rules: Rules, m: int) -> tuple[Planned, ...]:
    """Everything that stands in scene ``m``."""
    two = families(rules)
    chance = stream("ink", rules.seed, rules.edition, "scene", m)
    stage = Stage(rules, m, border(rules, m), border(rules, m + 1), chance, two[int(2 * chance.random())])
    (_high, _deep, _level)[distance(rules, m)](stage)
    _quiet(stage)
    # What is left out was planned all the same, so that nothing else moves.
    return tuple(p for p in stage.made if rules.boats or p.kind != codes.BOAT)


def _some(stage: Stage, *of: int) -> int:
    return int(of[int(len(of) * stage.chance.random())])


def _guests(stage: Stage, x: float, near: float, height: float, count: int, spread: float) -> None:
    """Hills about a host at ``x``, ``height`` high: lower than it by 1.6 to 2.2 times at the most, and leaning to it."""
    for k in range(count):
        side = 1.0 if k % 2 else -1.0
        off = side * spread * (0.28 + 0.72 * (k + stage.u()) / max(1, count))
        depth = min(0.9, max(0.04, near + stage.u(-0.3, 0.34)))
        tall = height / stage.u(1.6, 2.2) * (1.0 - 0.35 * abs(off) / spread)
        form = _some(stage, forms.CONE, forms.DOME, forms.LEANING, forms.CONE, forms.TWIN, forms.CLIFF)
        wide = tall * stage.u(1.7, 2.4) + 120.0
        stage.hill(x + off, depth, tall, wide, form, -side * stage.u(0.2, 0.8), wet=0.35)


def _high(stage: Stage) -> None:
    """One looks up: a host peak a little past the middle, guests about it, water before and a bank behind."""
    s = stage.u(0.44, 0.6)
    x, near, height = stage.x(s), stage.u(0.36, 0.5), stage.u(310.0, 385.0)
    form = _some(stage, forms.SPIRE, forms.CLIFF, forms.LEANING, forms.TWIN, forms.CONE)
    wide, lean = height * stage.u(1.25, 1.55) + 60.0, stage.u(-0.5, 0.5)
    if stage.rules.density > 0.0:
        stage.hill(x, near, height, wide, form, lean, wet=0.3, misty=1.0)
    _guests(stage, x, near, height, stage.often(11), 640.0)
    for _ in range(stage.often(4)):
        tall = height * stage.u(0.3, 0.46)
        stage.hill(
            x + stage.u(-620.0, 620.0),
            stage.u(0.0, 0.12),
            tall,
            tall * 2.2 + 120.0,
            _some(stage, forms.CONE, forms.SPIRE, forms.RIDGE),
            stage.u(-0.4, 0.4),
        )
    for _ in range(stage.often(5)):
        stage.hill(
            x + stage.u(-560.0, 560.0),
            stage.u(0.66, 0.98),
            stage.u(45.0, 95.0),
            stage.u(300.0, 520.0),
            _some(stage, forms.DOME, forms.RIDGE, forms.CONE),
            stage.u(-0.5, 0.5),
            wet=0.8,
            misty=0.35,
        )
    for _ in range(stage.often(3)):
        tall = stage.u(70.0, 130.0)
        stage.hill(
            stage.x(stage.u(0.14, 0.26)),
            stage.u(0.2, 0.6),
            tall,
            tall * 2.4 + 130.0,
            _some(stage, forms.DOME, forms.LEANING, forms.RIDGE),
            stage.u(-0.6, 0.6),
            wet=0.8,
        )
    _hamlet(stage, s + (0.26 if s < 0.52 else -0.26), 0.8)
    _banks(stage, [stage.u(0.84, 0.97), s + stage.u(-0.16, 0.16)] + [stage.u(0.05, 0.2)] * (stage.u() < 0.5))
    _ranges(stage, 1, 0.0, 0.6)
    _boats(stage, [stage.u(0.02, 0.12)])


def _deep(stage: Stage) -> None:
    """One looks in: ridge behind ridge from both sides, the far ones high, and a valley with its people between."""
    s = stage.u(0.42, 0.58)
    valley, sides = stage.x(s), (1.0, -1.0)
    host = 0 if stage.u() < 0.5 else 1
    tall = stage.u(265.0, 335.0)
    for k, side in enumerate(sides if stage.rules.density > 0.0 else ()):
        height = tall if k == host else tall / stage.u(1.6, 2.0)
        x = valley + side * stage.u(400.0, 520.0)
        stage.hill(
            x,
            stage.u(0.42, 0.58),
            height,
            height * 1.5 + 120.0,
            _some(stage, forms.CONE, forms.CLIFF, forms.LEANING, forms.SPIRE),
            -side * stage.u(0.2, 0.7),
            wet=0.3,
            misty=0.9,
        )
    planes = 6
    for k in range(planes):
        near = 0.02 + 0.8 * k / planes
        for side in sides:
            for _ in range(stage.often(1.35)):
                height = (stage.u(120.0, 185.0) if near < 0.2 else stage.u(70.0, 150.0)) * (1.0 if near < 0.7 else 0.6)
                x = valley + side * (130.0 + 640.0 * near**0.7 + stage.u(-90.0, 170.0))
                stage.hill(
                    x,
                    near + stage.u(0.0, 0.1),
                    height,
                    height * stage.u(1.8, 2.6) + 120.0,
                    _some(stage, forms.CONE, forms.DOME, forms.LEANING, forms.RIDGE, forms.TWIN, forms.SPIRE),
                    -side * stage.u(0.1, 0.7),
                    wet=0.3 + 0.4 * near,
                )
    for _ in range(stage.often(2)):
        height = stage.u(150.0, 205.0)
        stage.hill(
            valley + stage.u(-220.0, 220.0),
            0.0,
            height,
            height * 1.9 + 100.0,
            _some(stage, forms.SPIRE, forms.CONE, forms.TWIN),
            stage.u(-0.5, 0.5),
            misty=1.0,
        )
    _hamlet(stage, s, 0.9)
    _banks(stage, [stage.u(0.03, 0.14) if stage.u() < 0.6 else stage.u(0.86, 0.97), s + stage.u(-0.3, 0.3)])
    _ranges(stage, 1, 0.0, 1.0)
    _boats(stage, [stage.u(0.9, 0.98)])


def _level(stage: Stage) -> None:
    """One looks across: wide water, a low far shore, an islet or two, a near bank with great trees, a boat."""
    for _ in range(stage.often(4)):
        tall = stage.u(28.0, 70.0)
        stage.hill(
            stage.x(stage.u(0.3, 1.0)),
            stage.u(0.05, 0.42),
            tall,
            stage.u(320.0, 680.0),
            _some(stage, forms.DOME, forms.RIDGE, forms.CONE),
            stage.u(-0.5, 0.5),
            wet=0.9,
            misty=0.8,
        )
    if stage.u() < 0.6 * min(1.0, stage.rules.density):
        stage.hill(
            stage.x(stage.u(0.62, 0.9)),
            stage.u(0.5, 0.75),
            stage.u(60.0, 110.0),
            stage.u(330.0, 460.0),
            _some(stage, forms.LEANING, forms.DOME, forms.CLIFF),
            stage.u(-0.6, 0.6),
            wet=1.0,
        )
    _banks(stage, [stage.u(0.12, 0.4)] + [stage.u(0.7, 0.95)] * (stage.u() < 0.55))
    if stage.u() < 0.35:
        _hamlet(stage, stage.u(0.66, 0.85), 1.0)
    _ranges(stage, 2 if stage.u() < 0.6 else 3, -12.0, 1.0)
    _boats(stage, [stage.u(0.4, 0.66)] + [stage.u(0.45, 0.7)] * (stage.u() < 0.5))


def _banks(stage: Stage, places: list[float]) -> None:
    """Near banks, each one to three tongues of ground; on one of a scene a hut may stand."""
    willing = 0.4
    for s in places:
        if stage.u() >= stage.rules.density:
            continue
        x = stage.x(s)
        hutted = 1.0 if stage.u() < willing else 0.0
        willing = 0.0 if hutted else willing
        for j in range(1 + int(stage.u(0.0, 2.2))):
            wide, y = stage.u(600.0, 950.0), 700.0 - 46.0 * j
            at, reach = x + stage.u(-260.0, 260.0) * (j > 0), 0.5 * wide + 300.0
            how = (100.0, wide, stage.u(0.5, 0.7), hutted if j == 0 else 0.0)
            stage.put(codes.BANK, at, y, y, how, reach, reach, 0.76 if j == 0 else 0.64)


def _hamlet(stage: Stage, s: float, chance: float) -> None:
    """A village at the water's edge, with a path, its people, and often a bridge to it."""
    if stage.u() >= chance * min(1.0, stage.rules.density):
        return
    x, y = stage.x(min(0.94, max(0.06, s))), stage.u(548.0, 600.0)
    wide = stage.u(300.0, 430.0)
    reach = 0.5 * wide + 260.0
    stage.put(codes.HAMLET, x, y, y + 4.0, (wide, 3 + int(stage.u(0.0, 3.0))), reach, reach, 0.74)
    if stage.u() < 0.6:
        side = 1.0 if stage.u() < 0.5 else -1.0
        long = stage.u(80.0, 130.0)
        at = x + side * (0.5 * wide + 0.42 * long)
        stage.put(codes.BRIDGE, at, y + 2.0, y + 5.0, (long, side, float(stage.rules.boats)), 200.0, 200.0, 0.74)


def _ranges(stage: Stage, count: int, lower: float, chance: float) -> None:
    """Distant ranges, near to far: the farther the higher and paler, so that two or three lie one behind the other."""
    for j, (shift, height, pale) in enumerate(((0.0, 150.0, 0.06), (-16.0, 175.0, 0.3), (-30.0, 200.0, 0.52))[:count]):
        if j or stage.u() < chance:
            long = stage.u(1000.0, 1900.0)
            x, y = stage.begin + stage.u(-0.1, 0.75) * (stage.end - stage.begin), 288.0 + shift - stage.u(0.0, 26.0)
            stage.put(codes.RANGE, x - 300.0, y - lower, y, (height * stage.u(0.75, 1.1), long, pale), 5.0, long + 5.0)


def _quiet(stage: Stage) -> None:
    """Where nothing would meet the eye for a third of a screen: ripples, and a low far shore, so that blank is water."""
    span, rtl = stage.end - stage.begin, stage.rules.reading == "rtl"
    rooms = []
    for p in stage.made:
        if p.kind not in (codes.RANGE, codes.BIRDS) and (room := p.room):
            left, right = room[0] - stage.begin, room[2] - stage.begin
            rooms.append((span - right, span - left) if rtl else (left, right))  # from where the reader begins
    at, end = -0.4 * BARE, span + 0.4 * BARE
    for first, last in [*sorted(rooms), (end, end)]:
        while first - at > BARE:
            s = min(1.0, max(0.0, (at + stage.u(0.35, 0.65) * min(first - at, 1.6 * BARE)) / span))
            if stage.u() < stage.rules.density:
                y, long = 340.0 + 150.0 * stage.u(), stage.u(130.0, 240.0)
                stage.put(codes.WATER, stage.x(s), y, y - 10_000.0, (1.6, long, 3), long + 5.0, long + 5.0, 0.16)
                near, tall, wide = stage.u(0.0, 0.16), stage.u(24.0, 56.0), stage.u(260.0, 420.0)
                form = _some(stage, forms.DOME, forms.RIDGE)
                stage.hill(stage.x(s), near, tall, wide, form, wet=0.6, misty=0.5)
            at += 1.4 * BARE
        at = max(at, last)


def _boats(stage: Stage, places: list[float]) -> None:
    """Boats on open water: a fisherman, or a ferry that crosses."""
    for s in places:
        near = stage.u()
        y = 380.0 + 270.0 * near
        if stage.u() < 0.85 * min(1.0, stage.rules.density):
            right = 1.0 if stage.u() < 0.5 else -1.0
            stage.put(codes.BOAT, stage.x(s), y, y, (120.0, y / 800.0, right), 150.0, 150.0, 0.45 + 0.4 * near)
