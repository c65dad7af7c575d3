"""What an embroidery can be told; every field but the files can also stand on a region as ``data-tambour-…``."""

from __future__ import annotations

import math
import re
from contextlib import suppress
from typing import Annotated, Any, ClassVar, Literal

from pydantic import BeforeValidator, Field, field_validator, model_validator

from tambour.core.params import Degrees, Length, Params, Unit, file, length
from tambour.embroidery.fabric import FABRICS, MOST, Fabric, calibrated
from tambour.embroidery.machines import MACHINES

Stitch = Literal[
    "tatami",
    "contour",
    "spiral",
    "radial",
    "guided",
    "flow",
    "meander",
    "ripple",
    "gradient",
    "cross",
    "satin",
    "running",
    "bean",
    "motif",
    "manual",
]
UNDERLAYS = ("auto", "none", "center", "edge", "zigzag", "tatami")


def thread_width(value: Any) -> Any:
    """A thread's width in mm from a length or a weight: ``40wt`` covers 0.4 mm, others as the root of their weight."""
    found = re.fullmatch(r"\s*(\d+\.?\d*)\s*wt\s*", value) if isinstance(value, str) else None
    if found and float(found[1]) > 0:
        return 0.4 * math.sqrt(40 / float(found[1]))
    return length(value)


Thread = Annotated[float, BeforeValidator(thread_width), Field(ge=0.01, le=5), Unit("mm")]


class EmbroideryParams(Params):
    """Parameters of the embroidery craft."""

    groups: ClassVar = {
        "Stitches": "stitch angle row_spacing row_spacing_end length min_length stagger jitter seed motif motif_size repeats",
        "Satin and lines": "satin_from line_below split rim border blend jagged",
        "Fabric": "fabric pull pull_percent push test_card measured underlay knockdown",
        "Thread": "thread travel locks trim catalogue",
        "Design": "width hoop order colors style keep_hidden text font text_size text_arc applique baste",
        "Cloth": "cloth ground frames ends theta place place_at place_offset place_rotate place_scale place_group",
        "Machine": "machine pes jef_trims check",
    }
    first: ClassVar = "fabric stitch angle row_spacing width hoop text colors cloth"
    rare: ClassVar = "edition min_length stagger jitter seed jagged theta ends place_group jef_trims"
    widgets: ClassVar = {"ground": "color"}
    when: ClassVar = {
        "font": {"text": True},
        "text_size": {"text": True},
        "text_arc": {"text": True},
        "place_at": {"place": ("point",)},
        "place_group": {"cloth": True},
    }

    stitch: Stitch | None = None
    """How areas and lines are stitched (by how wide each limb is: satin, tatami, or a line)."""

    angle: Degrees | None = Field(default=None, ge=-360, le=360)
    """Direction of the rows, counter-clockwise from +x (when not given: tatami by each shape, the others along +x)."""

    row_spacing: Length = Field(default=0.4, gt=0.02, le=50)
    """Distance between rows, and between the stitches of a satin column."""

    row_spacing_end: Length | None = Field(default=None, gt=0.02, le=50)
    """Distance between the last rows of a gradient (three times the first when not given)."""

    length: Length = Field(default=3.0, ge=0.3, le=12)
    """Longest stitch of fills and running lines."""

    min_length: Length = Field(default=0.3, ge=0, le=3)
    """Stitches shorter than this are joined with the next."""

    stagger: int = Field(default=8, ge=1, le=32)
    """Rows after which the needle points of a tatami fill repeat."""

    thread: Thread = 0.4
    """Width that a thread covers, as a length or a weight (40wt is 0.4 mm)."""

    jitter: Length = Field(default=0.0, ge=0, le=3)
    """Ends of rows move along their row by up to this much, needle points in a row too."""

    seed: str = Field(default="tambour", max_length=1000)
    """Any text: other seeds, other jitter and other meanders."""

    underlay: str = "auto"
    """What lies below: auto, none, or words joined by + (center, edge, zigzag, tatami)."""

    fabric: Fabric = "cotton"
    """The cloth it is sewn on: sets {--pull}, {--push}, and what else it wants, where they are not given."""

    pull: Length = Field(default=FABRICS["cotton"]["pull"], ge=-MOST, le=MOST)
    """Rows and satin stitches are longer by this much at each end, against the cloth's drawing in."""

    pull_percent: float = Field(default=0.0, ge=0, le=30)
    """Satin is wider by this share of its width too (both sides together; with {--pull} at most 1 mm on each side)."""

    push: Length = Field(default=FABRICS["cotton"]["push"], ge=0, le=MOST)
    """Ends of columns and outer rows of fills stay back by this much, against the cloth's being pushed out there."""

    test_card: bool = False
    """Without a drawing: a card to sew on one's cloth and measure, with no pull and no push unless they are given."""

    measured: str | None = Field(default=None, max_length=400)
    """Widths of the test card's columns as they were sewn, such as 2=1.7,6=5.4: {--pull} and its per cent from them."""

    split: Length = Field(default=7.0, ge=1, le=12)
    """Satin stitches longer than this are split."""

    line_below: Length = Field(default=0.8, ge=0, le=12)
    """Limbs of satin areas that are narrower than this are a line, sewn there and back."""

    blend: str | None = None
    """A second colour for fills of rows, such as #f4a261: it grows along the rows' way as the first thins out."""

    rim: bool = True
    """Fills of rows get a run along their rim, below the rows: the steps of rows show thread there and no cloth."""

    border: Length = Field(default=0.0, ge=0, le=12)
    """Fills get a satin border of this width along their edges, inside them, in the same thread."""

    jagged: Length = Field(default=0.0, ge=0, le=10)
    """Satin ends draw back by up to this much, at random, for a feathered edge."""

    satin_from: Length = Field(default=1.0, ge=0, le=50)
    """Lines of this width and more are stitched as satin columns, thinner ones as running stitch."""

    motif: Literal["zigzag", "wave", "diamond", "cross", "e", "leaf", "star"] = "diamond"
    """The figure that motif stitch repeats along a line; e is the E-stitch of blankets and patches, its prongs half of {--motif-size} long."""

    motif_size: Length = Field(default=4.0, ge=0.5, le=100)
    """Length of one figure of motif stitch, one cell of cross stitch (half of it), and the lanes of a meander."""

    repeats: int = Field(default=3, ge=1, le=9)
    """How often each stitch of a bean line is sewn (odd)."""

    applique: bool = False
    """Areas become patches: placement line, stop, tack-down, stop, satin cover."""

    knockdown: bool = False
    """A thin fill below everything, to press down a pile."""

    baste: bool = False
    """A basting box first, round the whole design."""

    travel: Literal["hidden", "outline"] = "hidden"
    """Where a fill's thread goes between rows: below rows that come later, or along the outline."""

    locks: bool = True
    """Small stitches that tie each thread's start and end."""

    trim: Length = Field(default=2.0, ge=0, le=1000)
    """Thread is cut before jumps longer than this."""

    order: Literal["auto", "file"] = "auto"
    """Order of regions: fewest colour changes and short ways, keeping what lies on top; or as in the file."""

    width: Length | None = Field(default=None, gt=0, le=5000)
    """Width of the design (as the file says, when not given)."""

    hoop: str | None = None
    """The hoop's field, such as 100x100 (mm), or Brother's 4x4, 5x7, 6x10: the design must fit."""

    machine: str | None = None
    """The machine, such as brother-pe800: the design must fit its largest field, and its needles are counted."""

    check: bool = False
    """What is doubtful to sew (crowded needle points, short stitches, too many threads) is an error, not a warning."""

    colors: int | None = Field(default=None, ge=2, le=24)
    """Colours that a picture (6 when not given) or a drawing (all it has) is reduced to."""

    style: Literal["flat", "scan"] = "flat"
    """How a picture is sewn: as areas of {--colors} flat colours, or as a scan: lines to and fro, closer where it is darker, in
    one black thread or {--colors} of them (to 5)."""

    keep_hidden: bool = False
    """What lies below other shapes is sewn too, and equal neighbours stay apart."""

    text: str | None = Field(default=None, max_length=500)
    """Letters to embroider, instead of a drawing or below it."""

    font: Any = file(
        "Font",
        "The letters of {--text}: a .ttf or .otf file, the font.json of a font for Ink/Stitch, or columns, a face of satin strokes.",
        ("columns",),
    )

    text_arc: Length | None = Field(default=None, ge=-5000, le=5000)
    """{--text} stands on a circle of this radius round the drawing's middle; below 0 it hangs in it (straight when not given)."""

    text_size: Length = Field(default=15.0, gt=1, le=500)
    """Height of capital letters."""

    # What follows is for thread in space: cut at cloth faces, ends, binding, cloths, frames.

    ends: Literal["exact", "bleed"] = "exact"
    """Round ends of threads: needle holes on the outline, or outside it by half the turn."""

    theta: Degrees = Field(default=60.0, gt=0, le=90)
    """Angle at which a thread dives into the cloth."""

    cloth: Any = file("Mesh", "The cloth: a name or a mesh file, which may move.", ("flat", "wave", "flag", "drape"))

    place: Literal["projector", "point", "uv"] = "projector"
    """How the design comes onto the cloth: thrown along its mean normal, against the normal at a point, or by its uv."""

    place_at: str | None = None
    """For {--place} point: the place on the cloth, as X,Y,Z in mm."""

    place_offset: str = "0,0"
    """Moves the design on the cloth, right and down, as X,Y in mm."""

    place_rotate: Degrees = Field(default=0.0, ge=-360, le=360)
    """Turns the design on the cloth, counter-clockwise."""

    place_scale: float = Field(default=1.0, gt=0, le=1000)
    """Size of the design on the cloth; thread keeps its width."""

    place_group: str | None = None
    """Only faces of this group (material, object) of the cloth take thread."""

    frames: int | None = Field(default=None, ge=1, le=10_000)
    """Frames of a built-in cloth (1 when not given), or so many of the file's, evenly chosen."""

    ground: str = "#ece7dc"
    """Colour of the cloth in pictures and in space."""

    catalogue: Literal["brother", "janome", "husqvarna", "viking"] | None = None
    """Take the nearest threads of this maker; the report and the worksheet give their numbers."""

    pes: Literal["1", "6"] = "1"
    """Version of PES files: 1 is read by every machine, 6 also carries the threads' own colours."""

    jef_trims: bool = False
    """Write trims into JEF files (as three jumps, which some machines cut at and others sew)."""

    @model_validator(mode="before")
    @classmethod
    def _of_fabric(cls, values: Any) -> Any:
        """What the fabric sets, and what a measured card sets, where it is not given itself."""
        if not isinstance(values, dict):
            return values
        fabric, card = values.get("fabric"), values.get("measured")
        known = FABRICS.get(fabric, {}) if isinstance(fabric, str) else {}
        if values.get("test_card"):
            known = {**known, "pull": 0.0, "push": 0.0}
        if isinstance(card, str):
            with suppress(ValueError):  # told of the field itself
                known = {**known, **calibrated(card)}
        return {**known, **values}

    @field_validator("text_arc")
    @classmethod
    def _arc(cls, value: float | None) -> float | None:
        if value is not None and abs(value) < 1:
            raise ValueError("a circle of less than 1 mm takes no letters")
        return value

    @field_validator("underlay")
    @classmethod
    def _underlay(cls, value: str) -> str:
        words = [w for w in re.split(r"[+,\s]+", value.strip().lower()) if w]
        strange = [w for w in words if w not in UNDERLAYS]
        if strange or not words or (len(words) > 1 and {"auto", "none"} & set(words)):
            raise ValueError(f"{value!r} is not one of auto, none, or center, edge, zigzag, tatami joined by +")
        return "+".join(words)

    @field_validator("measured")
    @classmethod
    def _measured(cls, value: str | None) -> str | None:
        if value is not None:
            calibrated(value)
        return value

    @field_validator("place_offset")
    @classmethod
    def _offset(cls, value: str) -> str:
        numbers(value, 2)
        return value

    @field_validator("place_at")
    @classmethod
    def _at(cls, value: str | None) -> str | None:
        if value is not None:
            numbers(value, 3)
        return value

    @field_validator("blend")
    @classmethod
    def _blend(cls, value: str | None) -> str | None:
        return None if value is None else cls._ground(value)

    @field_validator("ground")
    @classmethod
    def _ground(cls, value: str) -> str:
        if not re.fullmatch(r"#[0-9a-fA-F]{6}", value.strip()):
            raise ValueError(f"{value!r} is not a colour such as #ece7dc")
        return value.strip().lower()

    @field_validator("machine")
    @classmethod
    def _machine(cls, value: str | None) -> str | None:
        if value is not None and value.strip().lower() not in MACHINES:
            raise ValueError(f"{value!r} is not one of {', '.join(MACHINES)}; give {{--hoop}} for another")
        return value and value.strip().lower()

    @field_validator("hoop")
    @classmethod
    def _hoop(cls, value: str | None) -> str | None:
        if value is not None:
            hoop_size(value)
        return value


def numbers(text: str, count: int) -> tuple[float, ...]:
    """``count`` lengths in mm of a text such as ``10,-2.5`` or ``1cm,0``; ValueError when they are not."""
    parts = [p for p in re.split(r"[,;\s]+", text.strip()) if p]
    try:
        made = tuple(float(length(p)) for p in parts)
    except ValueError:
        made = ()
    if len(made) != count or not all(abs(n) <= 100_000 for n in made):
        raise ValueError(f"{text!r} is not {count} lengths such as {','.join(['10', '-2.5', '0'][:count])}")
    return made


NAMED = {
    ("4", "4"): (100.0, 100.0),
    ("5", "7"): (130.0, 180.0),
    ("6", "10"): (160.0, 260.0),
    ("8", "8"): (200.0, 200.0),
}
"""The true fields, mm, of hoops that are called by inches."""


def hoop_size(text: str) -> tuple[float, float]:
    """Width and height in mm of a hoop such as ``100x100`` or ``5x7in``; ValueError when it is none.

    ``4x4``, ``5x7``, ``6x10`` and ``8x8`` without a unit, or in inches, are names: the fields that Brother gives them.
    """
    found = re.fullmatch(r"\s*(\d+\.?\d*)\s*[x×*]\s*(\d+\.?\d*)\s*(mm|cm|in)?\s*", text.lower())
    if not found or float(found[1]) <= 0 or float(found[2]) <= 0:
        raise ValueError(f"{text!r} is not a hoop such as 100x100 (mm)")
    named = NAMED.get((found[1], found[2]))
    if named is not None and found[3] in (None, "in"):
        return named
    unit = {"in": 25.4, "cm": 10.0}.get(found[3] or "mm", 1.0)
    if max(float(found[1]), float(found[2])) * unit > 5000:
        raise ValueError(f"{text!r}: a hoop is at most 5 m wide and high")
    return float(found[1]) * unit, float(found[2]) * unit
