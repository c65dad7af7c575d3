"""What crochet can be told."""

from __future__ import annotations

import re
from typing import Literal

from pydantic import Field, field_validator

from tambour.core.params import Length, Params

_GAUGE = re.compile(r"\s*(\d+(?:\.\d+)?)\s*[xX×]\s*(\d+(?:\.\d+)?)\s*$")


ACROSS = 9.4
"""Square stitches across a flat circle of five rounds, as it settles: 30 stitches round its edge."""


class CrochetParams(Params):
    """Parameters of crochet. Where a pattern's ``@`` parameter can speak, None leaves it the word."""

    solver: Literal["settle", "steps", "none"] = "settle"
    """settle: the shape at rest. steps: a number of plain simulation steps. none: first positions only."""
    steps: int = Field(default=1000, ge=0, le=10_000_000)
    """How many steps --solver steps takes; with --start one-by-one they include the building."""
    tolerance: float | None = Field(default=None, gt=0)
    """Largest residual force at rest, in stitches; without it, what an error well under 0.1 stitch needs."""
    start: Literal["rounds", "one-by-one"] | None = None
    """First positions: a ring per round, or a node at a time while the others move (@initializer; else rounds)."""
    stuffing: Literal["pressure", "centroid", "skeleton", "none"] | None = None
    """What presses the fabric outwards (else pressure). How much, a pattern says part by part: @stuffing = none|light|firm."""
    contact: bool = True
    """Fabric that is not joined does not pass through itself, nor parts through one another."""
    pose: tuple[str, ...] = ()
    """How a placed part leans, in place of what the pattern says: "Arm.1 tilt=30 towards=200 across=0"."""
    detail: Literal["low", "medium", "high"] = "medium"
    """How finely the yarn is swept in 3-D files and pictures."""
    photo: bool = False
    """Path-trace the picture with mitsuba: slow, soft light; needs the extra photo."""

    stitch_width: Length = Field(default=5.0, ge=0.1, le=1000)
    """Width of a single crochet."""
    stitch_height: Length = Field(default=5.0, ge=0.1, le=1000)
    """Height of a single crochet; taller stitches are multiples of it."""
    gauge: str | None = None
    """Single crochets x rows in 10 cm, such as 20x20; overrides width and height."""
    gauge_circle: Length | None = Field(default=None, gt=0)
    """Your own gauge: a flat circle of five rounds (6, 12, … 30), measured across; overrides width and height."""

    check: bool = False
    """Tech edit: every mistake and doubt of the pattern is an error, told with its place; nothing is made."""
    strict: bool = False
    """Stated counts that do not agree with the work, and other doubts, are errors."""
    max_stitches: int = Field(default=200_000, ge=1)
    """More stitches than this are an error at the count that asks for them."""

    link_distance: float = Field(default=1.0, ge=0.1, le=10)
    """The seed's d: scales every edge's rest length."""
    pressure: float = Field(default=0.02, ge=0, le=10)
    """Pressure stuffing: its energy is -p · edges · ln V; 0.01 stretches a ball by 3 %, 0.05 by 13 %."""
    centroids: int | None = Field(default=None, ge=0)
    """Centroid stuffing: centroids in each part (@centroids; else by --nodes-per-centroid)."""
    nodes_per_centroid: int = Field(default=60, ge=1)
    """Centroid stuffing: a centroid for every so many nodes."""
    centroid_force: float = Field(default=0.05, ge=0)
    """Centroid stuffing, the seed's f: strength of the push f · min(1 / r², cap)."""
    centroid_cap: float = Field(default=1000.0, gt=0)
    """Centroid stuffing: the push's cap."""
    weight_peak: float = 1.0
    """Centroid stuffing, the seed's b: the weight is exp(-(ln r - b)² / c²)."""
    weight_width: float = Field(default=1.4, gt=0)
    """Centroid stuffing, the seed's c."""
    skeleton_force: float = Field(default=0.02, ge=0)
    """Skeleton stuffing: strength of the push f / R · min((R / r)², cap)."""
    single_loop_force: float = Field(default=0.05, ge=0)
    """How strongly stitches in one loop lean to its side."""
    bending: float = Field(default=0.05, ge=0)
    """How strongly fabric without stuffing resists bending, against 1 for stretching."""
    contact_distance: float = Field(default=1.2, gt=0)
    """Fabric pushes fabric that is nearer than this, in stitches."""
    contact_near: float = Field(default=1.0, gt=0)
    """The same for two stitches with one or two stitches between them."""
    contact_stiffness: float | None = Field(default=None, gt=0)
    """Strength of contact against 1 for springs (else 1, and 0.2 with the seed's cubic links)."""
    wait_force: float = Field(default=0.03, ge=0)
    """One by one: the next node comes once the last one's displacement is below this."""
    wait_steps: int = Field(default=100, ge=1)
    """One by one: or after so many steps."""

    @field_validator("gauge")
    @classmethod
    def _gauge(cls, value: str | None) -> str | None:
        if value is not None:
            found = _GAUGE.match(value)
            if not found or float(found[1]) <= 0 or float(found[2]) <= 0:
                raise ValueError("a gauge is single crochets x rows in 10 cm, such as 20x22")
        return value

    def stitch(self) -> tuple[float, float]:
        """Width and height of a single crochet in mm, by the gauge that was given."""
        if self.gauge_circle is not None:
            return self.gauge_circle / ACROSS, self.gauge_circle / ACROSS
        found = _GAUGE.match(self.gauge) if self.gauge else None
        if found:
            return 100.0 / float(found[1]), 100.0 / float(found[2])
        return self.stitch_width, self.stitch_height
