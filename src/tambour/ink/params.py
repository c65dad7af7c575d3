"""What a scroll can be told."""

from __future__ import annotations

import hashlib
from decimal import Decimal
from typing import Any, ClassVar, Literal

from pydantic import Field, field_validator, model_validator

from tambour.core.errors import did_you_mean
from tambour.core.params import Duration, Length, Params, edited, file
from tambour.ink.ground.kinds import SPECIMENS

FARTHEST = 1e12
"""How far from 0 the scroll is addressed: beyond it a coordinate's tenths are lost in a double."""
LONGEST = 2_000_000.0
HELD = 60_000.0
"""Units of the scroll that are held in memory at once (900,000 polygons); streams may be longer."""
LOWEST = 3.0
"""Pixels of height under which a picture shows nothing."""


class Ink(Params):
    """A window of an endless scroll, or one of its elements."""

    groups: ClassVar = {
        "Window": "seed from_ span reading specimen",
        "Landscape": "density height season time mist figures buildings boats birds waterfalls",
        "Sheet": "paper mirrored inscription seal font tall pixels",
        "Painting": "painting steps",
        "Plotter": "plotter page margin crop model nib pens swell heights refill speed budget sheets frame",
    }
    first: ClassVar = "seed from_ span season time mist density plotter"
    rare: ClassVar = "edition steps speed frame model heights"
    widgets: ClassVar = {"inscription": "lines"}
    when: ClassVar = {
        **{
            name: {"specimen": False}
            for name in "from_ span density height reading figures buildings boats birds waterfalls".split()
        },
        "mist": {"specimen": False, "plotter": False},
        **{
            name: {"plotter": True}
            for name in "page margin crop model nib pens swell refill speed budget frame".split()
        },
        "heights": {"plotter": True, "swell": True},
        "mirrored": {"paper": True, "plotter": False},
        **{name: {"plotter": False} for name in ("paper", "tall")},
    }

    seed: str = Field(default="1", max_length=1000)
    """Any text: the same text gives the same scroll."""

    from_: float = Field(default=0.0, ge=-FARTHEST, le=FARTHEST)
    """Where the window begins, in scroll units (the scroll is 700 high and has no ends)."""

    span: float = Field(default=3000.0, ge=1.0, le=LONGEST)
    """How long the window is, in scroll units. With {--plotter} and no word, as long as fills the {--page}."""

    specimen: str | None = Field(default=None, json_schema_extra={"choices": list(SPECIMENS)})
    """One element by itself, or "all" for a sheet of every one with its name."""

    density: float = Field(default=1.0, ge=0.0, le=3.0)
    """How full the scroll is: hills, banks and boats; 1 leaves about three quarters of the paper blank."""

    height: float = Field(default=1.0, ge=0.2, le=2.0)
    """How high the hills are, as a part of their own height."""

    season: Literal["summer", "spring", "autumn", "winter"] = "summer"
    """What the trees wear: summer is plain ink; spring blossoms, autumn colours, winter snows."""

    time: Literal["ink", "dusk", "night"] = "ink"
    """The light: ink on paper, dusk with a low sun, night with the moon."""

    reading: Literal["rtl", "ltr"] = "rtl"
    """How the scroll unrolls: from right to left, as hand scrolls are read, or mirrored in its order."""

    mist: float = Field(default=0.35, ge=0.0, le=1.0)
    """How much mist lies between the hills."""

    figures: bool = True
    """People in the huts and boats."""

    buildings: bool = True
    """Houses, pagodas, pavilions, huts and pylons."""

    boats: bool = True
    """Boats on the open water."""

    birds: bool = True
    """Flocks of birds."""

    waterfalls: bool = True
    """Waterfalls on high hills."""

    paper: bool = True
    """The warm fibrous paper; without it the sheet is plain white."""

    mirrored: bool = False
    """The original's kind of paper: one small sheet of grain, mirrored left and right, above and below."""

    inscription: str = Field(default="", max_length=200)
    """A text written down the upper right of the window."""

    seal: str = ""
    """One to four characters for the red seal under the inscription."""

    font: Any = file("Font", "A .ttf, .otf or .ttc file for the letters of {--inscription} and {--seal}.")

    tall: Length = Field(default=210.0, gt=0.0, le=5000.0)
    """How tall the scroll is when it is printed."""

    pixels: int = Field(default=2400, ge=16, le=60_000)
    """Width of pictures (.png, .jpg, .webp) in pixels."""

    painting: Duration = Field(default=20.0, gt=0.0, le=3600.0)
    """How long the view "painting" takes to paint the window, stroke by stroke."""

    steps: int = Field(default=120, ge=2, le=5000)
    """Steps of the view "painting": frames of a .gif or .png, delays of an .svg."""

    left_out: tuple[str, ...] = edited()
    """The ids of wholes that are left out; the edit "leave"."""

    # ── the plotter ──────────────────────────────────────────────────────────

    plotter: bool = False
    """Lines for a pen plotter instead of the painting: what lies behind removed, layers per pen, sorted."""

    page: str = "a4"
    """The plotter's sheet, landscape: a5, a4, a3, a2, letter, or a size such as 300x200mm."""

    margin: Length = Field(default=10.0, ge=0.0, le=500.0)
    """The sheet's margin."""

    crop: bool = False
    """Fill the sheet and cut what does not fit on it; without, the whole window is fitted on it."""

    model: Literal["v3", "se-a4", "v3-a3", "se-a3", "xlx", "se-a2", "se-a1"] | None = None
    """The AxiDraw that will draw it: a warning is given where it does not reach."""

    nib: Length = Field(default=0.3, ge=0.03, le=5.0)
    """Width of the pen's line; hatching is pitched from it."""

    pens: int = Field(default=1, ge=1, le=8)
    """How many pens, the first the palest: each draws a band of tones on its own layer."""

    swell: int = Field(default=0, ge=0, le=8)
    """To how many heights a brush pen is lowered, a {--nib} broader each, on layers with AxiDraw's codes; 0: one width."""

    heights: str = "50..30"
    """Of a pen that swells: per cent of the way up at which it touches the paper, and at which it is pressed."""

    refill: Length = Field(default=0.0, ge=0.0, le=1e7)
    """How far a pen draws before it is filled again, such as 30m: the plotter waits there. 0: it never runs dry."""

    speed: float = Field(default=55.0, gt=0.0, le=1000.0)
    """Speed of the lowered pen in mm/s; times are reckoned with it."""

    budget: Duration = Field(default=0.0, ge=0.0, le=1e7)
    """The time there is for all sheets, such as 3h or 20min; what matters least is left out. 0: no limit."""

    sheets: str = ""
    """Cut the scroll into sheets that continue line for line, and make these: 0..9, or 3; the 0th begins at {--from}."""

    frame: bool = False
    """A frame about the drawing, on a layer that plotter software shows and does not plot."""

    @field_validator("specimen")
    @classmethod
    def _known(cls, value: str | None) -> str | None:
        if value is not None and value not in SPECIMENS:
            near = did_you_mean(value, SPECIMENS) or f"there are {', '.join(SPECIMENS)}"
            raise ValueError(f'there is no specimen "{value}"; {near}')
        return value

    @field_validator("page")
    @classmethod
    def _paged(cls, value: str) -> str:
        from tambour.ink.ground.pages import page

        page(value)
        return value

    @field_validator("heights")
    @classmethod
    def _lowered(cls, value: str) -> str:
        from tambour.ink.ground.pages import heights

        heights(value)
        return value

    @field_validator("sheets")
    @classmethod
    def _numbered(cls, value: str) -> str:
        from tambour.ink.ground.pages import sheets

        if value:
            sheets(value)
        return value

    @model_validator(mode="after")
    def _plottable(self) -> Ink:
        from tambour.ink.ground.pages import page

        if min(page(self.page)) - 2 * self.margin < 5:
            raise ValueError(f"{{--margin}} {self.margin:g} mm leaves nothing of {{--page}} {self.page}")
        if self.sheets and not self.plotter:
            raise ValueError("{--sheets} are the plotter's: add {--plotter}")
        if self.sheets and self.specimen:
            raise ValueError("a specimen has one sheet: leave {--sheets} out")
        return self

    @field_validator("seal")
    @classmethod
    def _short(cls, value: str) -> str:
        if len(value) > 4:
            raise ValueError("a seal holds at most four characters")
        return value


def exactly(number: float) -> str:
    """A number with all its digits and no exponent: 1234567.25, 3000. Places of a scroll must not lose theirs."""
    return f"{Decimal(repr(number)):f}".removesuffix(".0")


def stem(params: Ink) -> str:
    """The name of files that were asked for by suffix alone: seed, edition and window, in letters any disk takes.

    A seed that had to be changed for that keeps a name of its own by six letters of its digest.
    """
    seed = "".join(c if c.isalnum() or c in "-_." else "_" for c in params.seed)[:60]
    if seed != params.seed or not seed:
        seed += ("-" if seed else "") + hashlib.sha256(params.seed.encode("utf-8", "surrogatepass")).hexdigest()[:6]
    what = params.specimen or f"{exactly(params.from_)}-{exactly(params.span)}"
    if params.plotter:
        what += f"-sheets{params.sheets}" if params.sheets else "-plot"
    return f"ink-{seed}-e{params.edition}-{what}"
