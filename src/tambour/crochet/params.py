"""What crochet can be told."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any, ClassVar, Literal

from pydantic import Field, field_validator, model_validator

from tambour.core.errors import TambourError, did_you_mean
from tambour.core.params import Length, Params, edited, file
from tambour.crochet.specimens import SPECIMENS
from tambour.crochet.words.table import TERMS
from tambour.crochet.yarns import WEIGHTS, ball_of, class_of, ravelled

if TYPE_CHECKING:
    Code = str
else:
    Code = Literal[tuple(TERMS)]  # a language is a file of words/

_GAUGE = re.compile(r"\s*(\d{1,3}(?:\.\d+)?)\s*[xX×]\s*(\d{1,3}(?:\.\d+)?)\s*$")


class CrochetParams(Params):
    """Parameters of crochet. Where a pattern's ``@`` parameter can speak, None leaves it the word."""

    groups: ClassVar = {
        "Pattern": "terms size strict check reshape reshape_part target max_stitches specimen",
        "From a model": "stitches height tip model_up model_front plain_ colors",
        "Yarn and gauge": "hand yarn_under yarn ball hook gauge gauge_circle gauge_yarn stitch_width stitch_height",
        "Pictures and pages": "detail material photo page ink large_print title designer",
        "Shape": "stuffing contact solver steps tolerance start link_distance single_loop_force bending",
        "Stuffing": "pressure centroids nodes_per_centroid centroid_force centroid_cap weight_peak weight_width skeleton_force",
        "Contact": "contact_distance contact_near contact_stiffness",
        "One by one": "wait_force wait_steps",
    }
    first: ClassVar = "yarn hook gauge terms size check detail page title designer"
    rare: ClassVar = (
        "edition solver steps tolerance start link_distance single_loop_force bending pressure centroids nodes_per_centroid"
        " centroid_force centroid_cap weight_peak weight_width skeleton_force contact_distance contact_near"
        " contact_stiffness wait_force wait_steps max_stitches"
    )
    when: ClassVar = {
        "stitches": {"height": False},
        "steps": {"solver": ("steps",)},
        "reshape_part": {"reshape": True},
        "tolerance": {"solver": ("settle",)},
        "stuffing": {"solver": ("settle", "steps")},
        "gauge": {"gauge_circle": False},
        "gauge_yarn": {"gauge_circle": False, "gauge": False},
        "stitch_width": {"gauge_circle": False, "gauge": False, "gauge_yarn": False},
        "stitch_height": {"gauge_circle": False, "gauge": False, "gauge_yarn": False},
        "pressure": {"stuffing": ("pressure", None)},
        "skeleton_force": {"stuffing": ("skeleton", None)},
        "nodes_per_centroid": {"stuffing": ("centroid", None), "centroids": False},
        **{
            name: {"stuffing": ("centroid", None)}
            for name in ("centroids", "centroid_force", "centroid_cap", "weight_peak", "weight_width")
        },
        **{name: {"contact": True} for name in ("contact_distance", "contact_near", "contact_stiffness")},
        **{name: {"start": ("one-by-one", None)} for name in ("wait_force", "wait_steps")},
    }

    solver: Literal["settle", "steps", "none"] = "settle"
    """settle: the shape at rest. steps: a number of plain simulation steps. none: first positions only."""
    steps: int = Field(default=1000, ge=0, le=10_000_000)
    """How many steps {--solver} steps takes; with {--start} one-by-one they include the building."""
    tolerance: float | None = Field(default=None, gt=0, le=1)
    """Largest residual force at rest, in stitches; without it, what an error well under 0.1 stitch needs."""
    start: Literal["rounds", "one-by-one"] | None = None
    """First positions: a ring per round, or a node at a time while the others move (@initializer; else rounds)."""
    stuffing: Literal["pressure", "centroid", "skeleton", "none"] | None = None
    """What presses the fabric outwards (else pressure). How much, a pattern says part by part: @stuffing = none|light|firm."""
    contact: bool = True
    """Fabric that is not joined does not pass through itself, nor parts through one another."""
    pose: tuple[str, ...] = edited()
    """How placed parts lean, in place of what the pattern says: "Arm.1 tilt=30 towards=200 across=0"; the edit "pose"."""
    detail: Literal["low", "medium", "high"] = "medium"
    """How finely the yarn is swept in 3-D files and pictures."""
    photo: bool = False
    """The picture as a camera would take it: soft light, more fibres, grain; several times as slow."""

    stitch_width: Length | None = Field(default=None, ge=0.1, le=1000)
    """Width of a single crochet (else 5 mm)."""
    stitch_height: Length | None = Field(default=None, ge=0.1, le=1000)
    """Height of a single crochet; taller stitches are multiples of it (else as its width)."""
    gauge: str | None = None
    """Your gauge, a flat swatch: single crochets x rows in 10 cm, such as 20x20."""
    gauge_circle: Length | None = Field(default=None, gt=0, le=10_000)
    """Your gauge: a flat circle of five rounds (6, 12, … 30), measured across; comes before {--gauge}."""
    gauge_yarn: str | None = None
    """Your gauge: stitches unravelled, and how long their yarn is, such as "20 stitches are 64 cm"."""
    yarn: str | None = None
    """Yarn: lace, fingering, sport, dk, worsted, bulky, super-bulky or jumbo, or its number, 0 to 7."""
    ball: str | None = Field(default=None, max_length=60)
    """Grams and metres of a ball, such as 50 g / 125 m: grams and skeins are reckoned by it; else by the pattern's own words."""
    hook: Length | None = Field(default=None, ge=0.4, le=30)
    """Hook, mm; yarn and hook give the gauge where none is measured."""

    yarn_under: bool = False
    """The yarn is laid under the hook: single crochets show an x instead of a V, in straighter columns, and are smaller."""

    hand: Literal["right", "left"] = "right"
    """The hand that holds the hook: a left hand works the same words to the piece's mirror image, in pictures, places and charts."""

    material: Literal["wool", "cotton", "acrylic", "chenille", "mohair"] = "wool"
    """What the yarn is of, as pictures and 3-D files show it: plies, sheen, thickness and the fibres about it."""

    page: Literal["a4", "letter"] = "a4"
    """Paper of the booklet (.pdf)."""
    ink: Literal["full", "low"] = "full"
    """Ink of the booklet: low has white grounds, a small cover picture, and no pictures of single parts or of the sides."""
    large_print: bool = False
    """The booklet in type 1.4 times as large, in one column."""
    title: str | None = Field(default=None, max_length=200)
    """Title of the booklet (else the pattern's own, else the file's name)."""
    designer: str | None = Field(default=None, max_length=200)
    """Who designed it, for the booklet's cover and foot."""

    stitches: int | None = Field(default=None, ge=40, le=60_000)
    """A model or a profile becomes a pattern of about so many stitches (else a model 2,000, a profile as large as drawn)."""
    height: Length | None = Field(default=None, gt=0, le=5000)
    """A model or a profile becomes a toy of this height, by the gauge; in place of {--stitches}."""
    tip: Literal["top", "bottom", "front", "back", "left", "right"] | None = None
    """The side of a model that its main part is begun at (else where that leaves least out)."""
    model_up: Literal["y", "z", "x"] | None = None
    """The axis of a model that is upwards (else it is found out: y, or z of what stands so)."""
    model_front: Literal["front", "back", "left", "right"] | None = None
    """The side of a model, once it is upright and seen along its z, that is its front (else it is found out: the head of what has one)."""
    plain_: float = Field(default=0.5, ge=0, le=1)
    """Rounds of a model's or a profile's pattern: 0 follow its shape most faithfully, 1 are the easiest to work."""

    colors: int | None = Field(default=None, ge=1, le=24)
    """How many yarns a model's colours become (else as many as they need, six at the most)."""

    check: bool = False
    """Tech edit: every mistake and doubt of the pattern is an error, told with its place; nothing is made."""
    reshape: Any = file(
        "Drawing",
        "Redraw the outline of a part: Head=profile.svg, half its outline in mm, upright; rounds that still fit are kept.",
    )
    reshape_part: str | None = Field(default=None, max_length=200)
    """Which part {--reshape} redraws (as in Head=profile.svg), where the line in the drawing does not bear its name."""
    target: Any = file(
        "Mesh",
        "Compare the plush with this shape (mm, upright): the report's distance, the view compare, a sweep's score.",
    )
    terms: Code | None = None
    """The words of written instructions: US or UK terms, another language, or letters (else the pattern's own, else US)."""
    size: str | None = Field(default=None, max_length=40)
    """Which of several sizes of a printed pattern is made ("S (M, L)"): its name, or its place in the list (else the first)."""
    specimen: str | None = Field(default=None, json_schema_extra={"choices": list(SPECIMENS)})
    """Instead of a pattern: a small piece in one stitch, or all of them (a sheet with their names)."""
    strict: bool = False
    """Stated counts that do not agree with the work, and other doubts, are errors."""
    max_stitches: int = Field(default=200_000, ge=1, le=5_000_000)
    """More stitches than this are an error at the count that asks for them."""

    link_distance: float = Field(default=1.0, ge=0.1, le=10)
    """The seed's d: scales every edge's rest length."""
    pressure: float = Field(default=0.02, ge=0, le=10)
    """Pressure stuffing: its energy is -p · edges · ln V; 0.01 stretches a ball by 3 %, 0.05 by 13 %."""
    centroids: int | None = Field(default=None, ge=0, le=10_000)
    """Centroid stuffing: centroids in each part (@centroids; else by {--nodes-per-centroid})."""
    nodes_per_centroid: int = Field(default=60, ge=1, le=1_000_000)
    """Centroid stuffing: a centroid for every so many nodes."""
    centroid_force: float = Field(default=0.05, ge=0, le=100)
    """Centroid stuffing, the seed's f: strength of the push f · min(1 / r², cap)."""
    centroid_cap: float = Field(default=1000.0, gt=0, le=1e6)
    """Centroid stuffing: the push's cap."""
    weight_peak: float = Field(default=1.0, ge=-10, le=10)
    """Centroid stuffing, the seed's b: the weight is exp(-(ln r - b)² / c²)."""
    weight_width: float = Field(default=1.4, ge=0.01, le=100)
    """Centroid stuffing, the seed's c."""
    skeleton_force: float = Field(default=0.02, ge=0, le=100)
    """Skeleton stuffing: strength of the push f / R · min((R / r)², cap)."""
    single_loop_force: float = Field(default=0.05, ge=0, le=100)
    """How strongly stitches in one loop lean to its side."""
    bending: float = Field(default=0.05, ge=0, le=100)
    """How strongly fabric without stuffing resists bending, against 1 for stretching."""
    contact_distance: float = Field(default=1.2, gt=0, le=5)
    """Fabric pushes fabric that is nearer than this, in stitches."""
    contact_near: float = Field(default=1.0, gt=0, le=5)
    """The same for two stitches with one or two stitches between them."""
    contact_stiffness: float | None = Field(default=None, gt=0, le=100)
    """Strength of contact against 1 for springs (else 1, and 0.2 with the seed's cubic links)."""
    wait_force: float = Field(default=0.03, ge=0, le=100)
    """One by one: the next node comes once the last one's displacement is below this."""
    wait_steps: int = Field(default=100, ge=1, le=1_000_000)
    """One by one: or after so many steps."""

    @model_validator(mode="before")
    @classmethod
    def _redrawn(cls, given: Any) -> Any:
        """``reshape="Head=profile.svg"`` says part and file in one."""
        if isinstance(given, dict) and isinstance(given.get("reshape"), str):
            part, sign, path = given["reshape"].partition("=")
            if sign and part.strip() and not set(part) & set("/\\."):
                return {"reshape_part": part.strip(), **given, "reshape": path}
        return given

    @field_validator("specimen")
    @classmethod
    def _specimen(cls, value: str | None) -> str | None:
        if value is not None and value not in SPECIMENS:
            near = did_you_mean(value, SPECIMENS) or f"there are {', '.join(SPECIMENS)}"
            raise ValueError(f'there is no specimen "{value}"; {near}')
        return value

    @field_validator("gauge")
    @classmethod
    def _gauge(cls, value: str | None) -> str | None:
        if value is not None:
            found = _GAUGE.match(value)
            if not found or float(found[1]) <= 0 or float(found[2]) <= 0:
                raise ValueError("a gauge is single crochets x rows in 10 cm, such as 20x22")
        return value

    @field_validator("gauge_yarn")
    @classmethod
    def _gauge_yarn(cls, value: str | None) -> str | None:
        if value is not None:
            try:
                ravelled(value)
            except TambourError:
                raise ValueError("say how much yarn stitches take, such as: 20 stitches are 64 cm") from None
        return value

    @field_validator("ball")
    @classmethod
    def _ball(cls, value: str | None) -> str | None:
        if value is not None and ball_of(value) is None:
            raise ValueError("say a ball's grams and metres, such as: 50 g / 125 m")
        return value

    @field_validator("yarn", mode="before")
    @classmethod
    def _yarn(cls, value: str | int | None) -> str | None:
        if value is None:
            return None
        found = class_of(str(value))
        if found is None:
            raise ValueError(f"a yarn is {', '.join(WEIGHTS)}, or a number from 0 to 7")
        return found

    @property
    def hold(self) -> str:
        """How the yarn lies on the hook: over or under."""
        return "under" if self.yarn_under else "over"

    def swatch(self) -> tuple[float, float]:
        """Width and height, mm, of a single crochet in the swatch of ``gauge``."""
        found = _GAUGE.match(self.gauge or "")
        return (100.0 / float(found[1]), 100.0 / float(found[2])) if found else (5.0, 5.0)
