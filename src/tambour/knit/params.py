"""What the knit craft can be told."""

from __future__ import annotations

import re
from typing import Annotated, Any, ClassVar, Literal

from pydantic import BeforeValidator, Field, model_validator

from tambour.core.params import Params, file, length

YARNS = 8
"""The most yarns in a piece that is made here; a chart that is read may hold more (picture/charts.py)."""

PICTURED = (
    "stitches rows crop rotate direction repeat arrange border edge_stitches behind use_within cross_within style tones ground "
    "brightness contrast detail sharpen tone start threshold patches patch_from relax lock weights focus yarns colors card switch "
    "max_switches min_contrast"
).split()
"""What leads from a picture to stitches, and nothing else: a chart that is given has its stitches already."""

Paper = Literal["a4", "a3", "letter"]
"""Papers that charts are printed on; their sizes stand in render/page.py."""


def _limit(value: Any) -> Any:
    text = str(value).strip()
    if re.fullmatch(r"\d+", text):
        if len(text) > 4 or not 1 <= int(text) <= 1000:
            raise ValueError("wanted 1 to 1000 stitches, or a length such as 2.5cm")
        return text
    if not re.search(r"[a-z\"]$", text):
        raise ValueError("wanted a whole number of stitches, or a length such as 2.5cm")
    if not 0 < length(text) <= 10_000:
        raise ValueError("wanted a length above 0 and up to 10 m")
    return text


def _tone(value: Any) -> Any:
    text = str(value).strip()
    if text in ("raw", "reachable"):
        return text
    try:
        amount = float(text)
    except ValueError:
        raise ValueError("wanted raw, reachable, or a number from 0 (raw) to 1 (reachable)") from None
    if not 0 <= amount <= 1:
        raise ValueError("wanted raw, reachable, or a number from 0 (raw) to 1 (reachable)")
    return text


def _distance(value: Any) -> Any:
    text = str(value).strip()
    if not re.search(r"[a-z\"]$", text) or not 250 <= length(text) <= 100_000:
        raise ValueError("wanted a length from 25cm to 100m, such as 2m")
    return text


def _gauge(value: Any) -> Any:
    text = str(value).strip().lower().replace("×", "x")
    found = re.fullmatch(r"(\d+\.?\d*)\s*x\s*(\d+\.?\d*)", text)
    if not found or not all(2 <= float(n) <= 400 for n in found.groups()):
        raise ValueError("wanted stitches x rows in 10 cm, such as 24x32, each from 2 to 400")
    return text


def _box(value: Any) -> Any:
    numbers = re.split(r"[,\s]+", str(value).strip())
    if len(numbers) != 4 or not all(re.fullmatch(r"\d{1,6}", n) for n in numbers) or "0" in numbers[2:]:
        raise ValueError("wanted left,top,width,height in whole pixels, such as 40,0,300,200")
    return ",".join(numbers)


def _repeat(value: Any) -> Any:
    text = str(value).replace(" ", "")
    if text == "auto":
        return text
    found = re.fullmatch(r"(\d{1,5})(?:\+(\d{1,5}))?", text)
    if not found or not 2 <= int(found[1]) <= 20000 or int(found[2] or 0) >= int(found[1]):
        raise ValueError("wanted a number of stitches such as 24, 24+1 for a multiple of 24 plus 1, or auto")
    return text


def _turn(value: Any) -> Any:
    text = str(value).strip()
    if text != "auto":
        try:
            turned = float(text.removesuffix("deg"))
        except ValueError:
            raise ValueError("wanted an angle in degrees, or auto") from None
        if not abs(turned) <= 360:
            raise ValueError("wanted an angle from -360 to 360 degrees, or auto")
    return text


Limit = Annotated[str, BeforeValidator(_limit)]
Tone = Annotated[str, BeforeValidator(_tone)]
Distance = Annotated[str, BeforeValidator(_distance)]
Ratio = Annotated[str, BeforeValidator(_gauge)]
Box = Annotated[str, BeforeValidator(_box)]
Repeat = Annotated[str, BeforeValidator(_repeat)]
Turn = Annotated[str, BeforeValidator(_turn)]


class KnitParams(Params):
    """Parameters of the knit craft."""

    groups: ClassVar = {
        "Size": "stitches rows gauge crop rotate direction repeat arrange border edge_stitches round steek edges edge_run shape gusset",
        "Look": "technique back behind use_within cross_within style tones ground use seen_from floats",
        "Tones": "brightness contrast detail sharpen tone light",
        "First version": "start threshold patches patch_from",
        "Floats": "max_float soft catch relax lock weights focus method keep sweeps tidy",
        "Search": "seed walk_sample walk_stop walk_gain walk_steps check",
        "Yarns": "yarns colors yarn card stash switch max_switches min_contrast yarn_weight skein_metres skein_grams",
        "Pages": "title page large_cells cells swatch",
        "Machine": "machine punch_card mirror_card",
    }
    first: ClassVar = "stitches gauge technique max_float yarns colors title page"
    rare: ClassVar = "edition walk_sample walk_stop walk_gain walk_steps sweeps tidy patch_from edge_run light"
    widgets: ClassVar = {"colors": "color", "crop": "box", "patch_from": "box"}
    when: ClassVar = {
        "threshold": {"start": ("threshold", "floyd-steinberg", "atkinson", None)},
        "patches": {"start": ("patches",)},
        "patch_from": {"start": ("patches",), "patches": ("marked",)},
        "edge_run": {"edges": ("free",)},
        "gusset": {"shape": ("mitten",)},
        "keep": {"method": ("perceptual", None)},
        "sweeps": {"method": ("perceptual", None)},
        "tidy": {"method": ("exact", None)},
        **{
            name: {"method": ("random-walk", "hybrid")}
            for name in ("walk_sample", "walk_stop", "walk_gain", "walk_steps")
        },
        **{name: {"yarns": (None, *range(3, YARNS + 1))} for name in ("switch", "max_switches")},
        **{name: {"technique": ("auto", "jacquard")} for name in ("back", "behind", "use_within", "cross_within")},
    }

    # --- from the picture to stitches
    stitches: int | None = Field(default=None, ge=1, le=20000)
    """Stitches in a row. Without it charts and pixel art have a stitch for each pixel, other pictures the width that is usual for
    {--use}: 80 for the front of a garment (33 cm at 24 stitches in 10 cm)."""
    rows: int | None = Field(default=None, ge=1, le=20000)
    """Rows; without it they follow from the picture's shape and the gauge."""
    gauge: Ratio | None = Field(default=None, json_schema_extra={"metavar": "STSxROWS"})
    """Stitches x rows in 10 cm, such as 24x32: keeps proportions true in wool. Without it stitches count as square."""
    crop: Box | None = Field(default=None, json_schema_extra={"metavar": "X,Y,W,H"})
    """Part of the picture to use: left, top, width, height in its upright pixels."""
    rotate: Turn = Field(default="0", json_schema_extra={"metavar": "DEGREES|auto"})
    """Turn the picture counter-clockwise; auto finds the angle that lines its strokes up with the stitches."""
    direction: Literal["horizontal", "vertical"] = "horizontal"
    """Knitting direction: vertical knits the picture sideways (rows of knitting run down it)."""
    technique: Literal["auto", "stranded", "intarsia", "jacquard"] = "auto"
    """Stranded: two yarns in a row, the idle one floats behind. Intarsia: any yarns in a row, each area from a bobbin of
    its own. Jacquard: any yarns in a row on a double bed, which hides them in the back. Auto: intarsia for a picture in
    several colours, unless something is asked for that only stranded knitting has; else stranded."""
    back: Literal["birdseye", "stripes"] = "birdseye"
    """Jacquard: what the back bed knits: the yarns by turns (birdseye), or a whole row of each (stripes)."""
    behind: Any = file("Picture", "Jacquard: a second picture, for the back of the same cloth, seen from behind.")
    use_within: int | None = Field(default=None, ge=2, le=17)
    """Two pictures: in so many stitches of a row, both faces counted by turns, every yarn is used. Without it four more than
    there are yarns."""
    cross_within: int = Field(default=24, ge=4, le=1000)
    """Two pictures: in so many stitches of a row, both faces counted, some yarn is used on both, and holds them together."""
    style: Literal["auto", "graphic", "texture", "tonal", "plain"] = "auto"
    """Graphic: areas with clean borders. Texture: four tones of knit textures. Tonal: tones by single stitches, for large
    pieces. Plain: no preparation. Auto chooses by picture and size, and says why."""
    tones: int | None = Field(default=None, ge=2, le=4)
    """Graphic and texture: how many tones the picture is cut into; without it two or three, and four for texture."""
    ground: Literal["auto", "lice", "diagonal", "brick", "stripe"] = "auto"
    """Graphic and texture: how the stitches that hold floats stand in plain areas. Auto: lice in the largest, and in each
    other what none of its neighbours has."""
    use: Literal["garment", "mitten", "child", "blanket"] = "garment"
    """What it is for: sets {--max-float} (shorter for mittens and children), {--seen-from} (a blanket from 4 m) and {--stitches}."""
    seen_from: Distance | None = Field(default=None, json_schema_extra={"metavar": "LENGTH"})
    """How far away one looks from, such as 2m: chooses the style, and weighs what the eye sees from there."""
    brightness: float = Field(default=0.0, ge=-1, le=1)
    """Added to every tone."""
    contrast: float = Field(default=1.0, ge=0, le=10)
    """Factor on the distance of every tone from middle grey."""
    detail: float = Field(default=0.0, ge=0, le=4)
    """Keep local detail while tones are compressed: how much of the fine layer is given back and more."""
    sharpen: float = Field(default=0.0, ge=0, le=4)
    """Enhance edges at the scale of stitches."""
    tone: Tone | None = Field(default=None, json_schema_extra={"metavar": "raw|reachable|0…1"})
    """How far tones are compressed into what lawful rows can show, 1/(f+1) to f/(f+1): raw for tonal, reachable for plain."""
    light: Literal["code", "linear"] | None = None
    """What tone means: linear light, as yarns mix seen from afar (tonal), or sRGB code values, as in the 2013 paper (plain)."""

    # --- the start assignment
    start: Literal["threshold", "ordered", "floyd-steinberg", "atkinson", "patches"] | None = None
    """First black and white version; without it, threshold for a line drawing and floyd-steinberg for a photograph."""
    threshold: float = Field(default=0.5, ge=0, le=1)
    """The tone above which a stitch is light: of threshold, and of the error-diffusing starts."""
    patches: Literal["ready", "noise", "marked"] = "ready"
    """Texture patches of {--start} patches: ready-made, made from noise, or taken from {--patch-from}."""
    patch_from: Box | None = Field(default=None, json_schema_extra={"metavar": "X,Y,W,H"})
    """Stitches (left, top, width, height) whose texture is repeated elsewhere at the same brightness."""

    # --- the constraint
    floats: Literal["short", "caught"] = "short"
    """Short: no run of one colour is longer than {--max-float}. Caught: the picture stays as it is, and the floats are caught."""
    max_float: Limit | None = Field(default=None, json_schema_extra={"metavar": "N|LENGTH"})
    """Longest float: stitches, or a length with {--gauge}. Without it by use: 2.5cm, at most 7; 5 on a machine; 3 for mittens."""
    edges: Literal["anchored", "free"] = "anchored"
    """Anchored: both yarns reach both edges. Free: the first and the last run of a row may be longer."""
    edge_run: int | None = Field(default=None, ge=1, le=20000)
    """Longest first or last run with free edges; without it, any length."""
    round: bool = False
    """Knitted in the round: rows close upon themselves. A {--shape} that is worn is, but on a machine."""
    repeat: Repeat | None = Field(default=None, json_schema_extra={"metavar": "N[+K]|auto"})
    """The motif is N stitches wide and repeats; the chart is a multiple of N, plus K. 24 fits a punch card. Auto finds the
    repeat of a picture taken stitch for stitch."""
    arrange: Literal["plain", "mirror", "half-drop", "turn"] = "plain"
    """Set the motif beside itself: mirrored, dropped by half its rows, or turned by half a turn. Two make the repeat."""
    border: int = Field(default=0, ge=0, le=200)
    """A frame of so many stitches in a check of both yarns."""
    steek: int = Field(default=0, ge=0, le=20)
    """In the round: so many stitches more, in a check of both yarns, about the beginning of the round: it is cut open there."""
    gusset: int | None = Field(default=None, ge=0, le=41)
    """Mitten: stitches of the thumb's gusset at its widest, beside the hand's; without it a fifth of the round, 0 for none."""
    edge_stitches: int = Field(default=0, ge=0, le=50)
    """Stitches at either end of each row knitted in the dark yarn."""
    shape: Any = file(
        "Picture",
        "Where there are stitches: yoke, hat (decreases in every repeat) or mitten, or a mask whose dark cells are not knitted.",
        ("yoke", "hat", "mitten"),
    )
    relax: Any = file("Picture", "Mask: light cells are free of the limit; their long floats are listed for catching.")
    lock: Any = file("Picture", "Mask: light cells keep their start assignment.")
    weights: Any = file("Picture", "Grey picture: the lighter, the more a flip costs there.")
    focus: Literal["none", "saliency", "faces"] = "none"
    """Weights found in the picture itself: what stands out, or faces (needs scikit-image)."""
    soft: float | None = Field(default=None, gt=0, le=1000)
    """Soft limit: each stitch by which a run is too long costs so many flips, instead of being forbidden."""

    # --- solving
    method: (
        Literal["none", "random-walk", "min-conflict", "gsat", "hybrid", "texture", "exact", "diffused", "perceptual"]
        | None
    ) = None
    """How the start assignment is made lawful; the five after none are those of the 2013 paper; diffused is row by row,
    quick. Without it by style: exact, or perceptual for tonal and plain."""
    keep: float = Field(default=0.0, ge=0, le=10)
    """Perceptual: cost of a flip, from 0 (best tone) to 1 and more (fewest flips)."""
    sweeps: int | None = Field(default=None, ge=1, le=100)
    """Perceptual: at most so many times over all rows. Two give nearly all that eight do, in a third of the time."""
    tidy: float = Field(default=3.0, ge=0, le=10)
    """Exact: what a flip in line with others costs more, in flips. 0 makes the fewest flips; 1 breaks up most lines.
    Where {--ground} lays the flips it has no part."""
    seed: str = Field(default="knit", max_length=1000)
    """Any text: the random choices of the paper's methods, and of ties."""
    walk_sample: int = Field(default=100, ge=1, le=1_000_000)
    """Random walk: stitches looked at in a step, n."""
    walk_stop: int = Field(default=20, ge=0, le=1_000_000)
    """Random walk: stop when fewer than q of them are in conflict."""
    walk_gain: int = Field(default=4, ge=1, le=10_000)
    """Random walk: flip only when so many conflicts fewer remain, m."""
    walk_steps: int | None = Field(default=None, ge=0, le=100_000_000)
    """Random walk: the most steps; without it, enough to look at each stitch about four times."""
    check: bool = False
    """Report on an existing chart, one pixel per stitch, and change nothing."""

    # --- yarns
    yarns: int | None = Field(default=None, ge=2, le=YARNS)
    """Yarns in the whole piece. Without it as many as there are {--colors}, or 2 stranded; intarsia and jacquard take what the
    picture has: the colours of flat art, 5 and 4 for a photograph."""
    colors: tuple[str, ...] = ()
    """A yarn's colour as #rrggbb; give one for each yarn. Without them black and white where two show greys, else the picture's own."""
    card: Literal["none", "wool", "natural"] = "none"
    """Choose the yarns from a shade card."""
    stash: Any = file("Text", "Choose the yarns from a CSV file: name, colour, metres, grams.")
    yarn: tuple[str, ...] = Field(default=(), json_schema_extra={"metavar": "COLOUR=YARN"})
    """Another colour for a yarn of the chart, such as #aa3322=MC or poppy=2; the stitches stay as they are."""
    switch: float = Field(default=1.0, ge=0, le=1000)
    """More than two yarns: cost of changing the pair from one row to the next."""
    max_switches: int | None = Field(default=None, ge=0, le=20_000)
    """More than two yarns: the most changes of pair."""
    min_contrast: float = Field(default=1.5, ge=1, le=21)
    """Least contrast of luminance (WCAG, 1 to 21) of two yarns that share a row; below it there is a warning."""

    # --- making and seeing
    title: str = Field(default="", max_length=80)
    """What the pattern is called, on its pages."""
    page: Paper = "a4"
    """Paper of the printed pattern."""
    large_cells: bool = False
    """Draw the chart with large cells, on more pages."""
    cells: Literal["both", "colour", "symbol"] = "both"
    """How stitches are drawn: signs on colours, colours alone, or signs alone (saves ink)."""
    catch: int | None = Field(default=None, ge=1, le=1000)
    """Longest float that is left free behind; longer ones are listed for catching. Without it, the limit itself."""
    swatch: bool = False
    """Put a swatch into the printed pattern: the most typical part, the worst floats, and a card to measure them."""
    yarn_weight: Literal["lace", "fingering", "sport", "dk", "worsted", "aran", "bulky", "super-bulky", "jumbo"] = "dk"
    """Weight of the yarn: metres per gram, and the gauge where none is given."""
    skein_metres: float | None = Field(default=None, ge=0.1, le=100_000)
    """Metres in a skein; without it, by the weight."""
    skein_grams: float = Field(default=50.0, ge=0.1, le=10_000)
    """Grams in a skein."""
    machine: (
        Literal[
            "kh910-ayab",
            "kh930-ayab",
            "kh940-ayab",
            "kh950-ayab",
            "kh270-ayab",
            "kh930-disk",
            "kh940-disk",
            "brother-card",
            "silver-reed-card",
            "kniterate",
            "swgn2",
            "swg091n2",
        ]
        | None
    ) = None
    """Knitting machine: its limits are checked, and -o name.card.pdf tells how to set it up."""
    punch_card: Literal["brother", "silver-reed"] = "brother"
    """Make of the punch card's reader: where its row numbers stand."""
    mirror_card: bool = True
    """Punch the card mirrored, as the purl side shows it, which faces the knitter."""

    @model_validator(mode="before")
    @classmethod
    def _worn(cls, given: Any) -> Any:
        """A hat, a yoke and a mitten close upon themselves, where nothing said of them is flat."""
        if not isinstance(given, dict) or "round" in given:
            return given
        if not isinstance(shape := given.get("shape"), str) or shape not in cls.words("shape"):
            return given
        flat = given.get("technique", "auto") not in ("auto", "stranded") or given.get("edges") == "free"
        return given if flat or given.get("machine") or given.get("edge_stitches") else {**given, "round": True}

    @model_validator(mode="after")
    def _agree(self) -> KnitParams:
        if self.max_float and re.search(r"[a-z\"]$", self.max_float) and self.gauge is None:
            raise ValueError("{--max-float} as a length needs {--gauge}")
        if self.round and self.edges == "free":
            raise ValueError("{--round} has no edges to be {--edges} free")
        if self.repeat and (self.border or self.edge_stitches):
            raise ValueError("{--repeat} does not go with {--border} or {--edge-stitches}")
        if self.repeat and self.edges == "free":
            raise ValueError("{--repeat} closes upon itself: it does not go with {--edges} free")
        if self.steek and not self.round:
            raise ValueError("{--steek} is cut open: it needs {--round}")
        if self.steek and (self.repeat or self.shape is not None):
            raise ValueError("{--steek} does not go with {--repeat} and {--shape}")
        if self.round and self.edge_stitches:
            raise ValueError("{--round} has no edges for {--edge-stitches}")
        if self.behind is not None and self.technique not in ("auto", "jacquard"):
            raise ValueError(f"{{--behind}} is for {{--technique}} jacquard, not for {self.technique}")
        if self.behind is not None and (self.repeat or self.shape is not None or self.border or self.edge_stitches):
            raise ValueError("{--behind} does not go with {--repeat}, {--shape}, {--border} and {--edge-stitches}")
        if self.technique not in ("auto", "stranded"):
            self._of_areas()
        for color in self.colors:
            if not re.fullmatch(r"#[0-9a-fA-F]{6}", color):
                once = "; each yarn by a {--colors} of its own" if "," in color else ""
                raise ValueError(f"{{--colors}}: wanted #rrggbb (got {color!r}){once}")
        if len(self.colors) == 1:
            raise ValueError("{--colors}: at least two yarns are wanted")
        if self.colors and self.yarns and len(self.colors) != self.yarns:
            raise ValueError(f"{{--yarns}} {self.yarns} needs as many {{--colors}} (got {len(self.colors)})")
        if len({color.lower() for color in self.colors}) < len(self.colors):
            raise ValueError("{--colors}: two are the same")
        for told in self.yarn:
            if not re.fullmatch(r"[^=]{1,40}=[^=]{1,40}", told):
                raise ValueError(f"{{--yarn}}: wanted a colour and a yarn, such as #aa3322=MC (got {told!r})")
        if self.arrange != "plain" and (self.border or self.edge_stitches or self.relax or self.lock or self.weights):
            raise ValueError(
                "{--arrange} does not go with {--border}, {--edge-stitches} and masks other than {--shape}"
            )
        if isinstance(self.shape, str) and self.shape in self.words("shape") and (self.border or self.edge_stitches):
            raise ValueError(f"{{--shape}} {self.shape} does not go with {{--border}} and {{--edge-stitches}}")
        if self.patches == "marked" and self.patch_from is None:
            raise ValueError("{--patches} marked needs {--patch-from}")
        return self

    def _of_areas(self) -> None:
        """What only stranded knitting has."""
        name = self.technique
        if self.round:
            raise ValueError(f"{{--technique}} {name} is knitted flat: leave {{--round}} out")
        given = ("start", "method", "soft", "tone", "relax", "border", "edge_stitches", "max_switches")
        for field in given:
            if getattr(self, field):
                raise ValueError(f"{{--{field.replace('_', '-')}}} is for {{--technique}} stranded, not for {name}")
        for field, usual in (("floats", "short"), ("edges", "anchored")):
            if getattr(self, field) != usual:
                raise ValueError(f"{{--{field}}} is for {{--technique}} stranded: {name} has no floats")
        if self.style in ("texture", "plain") or (self.style == "tonal" and name == "intarsia"):
            raise ValueError(f"{{--style}} {self.style} does not go with {{--technique}} {name}: graphic does")

    @property
    def count(self) -> int:
        """Yarns in the piece, where nothing is left to the picture."""
        return self.yarns or len(self.colors) or 2

    @property
    def end_needles(self) -> bool:
        """The machine knits the outermost stitches of every row in its second feeder (Brother's KC I)."""
        brother = self.machine is not None and self.machine.startswith(("kh", "brother"))
        return brother and self.edges == "anchored" and self.technique in ("auto", "stranded") and self.repeat is None
