"""Finish: what is done to worked parts: sewn on at a place, pulled in, eyes, embroidery, felt, hair; and the lines that say it."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, Final

from tambour.core.errors import Span, did_you_mean
from tambour.core.rgb import RGB
from tambour.crochet.language.source import Source


@dataclass(frozen=True, slots=True)
class Spot:
    """A place on a part, by round and stitch.

    part : its name, with ``.2`` for the second copy
    round : its number; 14.5 is between rounds 14 and 15; 0 the magic ring
    stitch : from the round's first stitch, which is 1; 0 is the round's beginning, at the back; None the middle of the front
    """

    part: str
    round: float
    stitch: float | None
    span: Span = field(default=Span(0, 0), compare=False)


@dataclass(frozen=True, slots=True)
class Placed:
    """A part sewn on by its open end (or, closed, by the round ``by``), all round, its middle at ``spot``.

    flat : its end is pinched together before it is sewn, so it stands as a line
    across : which way that line (or the part's front) lies: degrees from level, counter-clockwise from outside
    tilt : how far it leans from straight out, degrees; towards: where to, degrees counter-clockwise from up, from outside
        (up is that of the toy as it stands; on a part that leans it leans with the part)
    by : the round of the part that is sewn, None for its last
    through : it is not sewn, but held to the work while that round is worked, and so many stitches of it go through both; with no
        stitch in its spot, it is worked on all of that round's stitches itself, as a skirt is, and hangs
    points : where it points on the toy as it stands (x to its left, y up, z ahead), whatever way the settled fabric looks; None: as tilt says
    to : where its other end is sewn, on the same part: it arches from the one to the other, as a handle does; None: that end is free
    """

    part: str
    spot: Spot
    flat: bool = False
    across: float = 0.0
    tilt: float = 0.0
    towards: float = 0.0
    by: float | None = None
    through: int = 0
    span: Span = field(default=Span(0, 0), compare=False)
    points: tuple[float, float, float] | None = field(default=None, compare=False)
    to: Spot | None = field(default=None, compare=False)

    @property
    def around(self) -> bool:
        """Whether it is worked on a whole round, and hangs from it."""
        return self.through > 0 and self.spot.stitch is None


@dataclass(frozen=True, slots=True)
class Eye:
    """A safety eye: a half-ball ``size`` mm across."""

    spot: Spot
    size: float = 9.0
    color: RGB = (24, 22, 22)
    span: Span = field(default=Span(0, 0), compare=False)


@dataclass(frozen=True, slots=True)
class Embroidery:
    """Straight stitches from spot to spot in yarn ``width`` mm thick; a single spot is a knot (a dot). Curves by more spots.

    motif : what they make, where a text called it by its name ("smile"); "" unsaid
    """

    spots: tuple[Spot, ...]
    color: RGB = (40, 30, 26)
    width: float = 2.0
    span: Span = field(default=Span(0, 0), compare=False)
    motif: str = field(default="", compare=False)


@dataclass(frozen=True, slots=True)
class Felt:
    """A piece of felt, ``width`` by ``height`` mm, laid on the fabric; ``turn`` degrees counter-clockwise from outside."""

    spot: Spot
    shape: str = "circle"
    width: float = 15.0
    height: float = 15.0
    turn: float = 0.0
    color: RGB = (240, 236, 228)
    span: Span = field(default=Span(0, 0), compare=False)


@dataclass(frozen=True, slots=True)
class Hair:
    """Strands of yarn cut ``length`` mm long, folded in half and knotted in by the fold, from the first spot to the last,
    ``count`` of them evenly; about a single spot as a tuft."""

    spots: tuple[Spot, ...]
    count: int = 12
    length: float = 60.0
    color: RGB = (92, 58, 30)
    span: Span = field(default=Span(0, 0), compare=False)


@dataclass(frozen=True, slots=True)
class Tie:
    """A thread led through the stuffed part from one spot to another, pulled until they are ``apart`` mm apart, and knotted:
    what makers call needle sculpting. It holds the stitch at each spot and the one after it."""

    spots: tuple[Spot, ...]
    apart: float
    span: Span = field(default=Span(0, 0), compare=False)


Finish = Placed | Tie | Eye | Embroidery | Felt | Hair


def spots_of(finish: Finish) -> tuple[Spot, ...]:
    """The spots of a record, those on the part that it is done to."""
    return finish.spots if isinstance(finish, (Tie, Embroidery, Hair)) else (finish.spot,)


GUESSED: Final = "guessed where these go"
"""How a doubt begins that tells of parts put where such parts usually are."""
MEANT: Final = "the materials have one such colour"
"""How the doubt begins that tells which yarn a shorter name means."""
UNSEEN: Final = "this is kept as written, and the pictures do without it"
"""What is told of things that hands do and that one would see."""
ASIDE: Final = "no sentence places these, so they stand beside it"
"""How the doubt of parts begins that are put nowhere: clothes, and what has no name."""

SHAPES: Final = ("circle", "oval", "half", "triangle", "heart", "square")
"""Shapes of felt."""

# Word → the record, its usage, and its named arguments → (field, smallest, largest).
_DEGREES = (-360.0, 360.0)
_SPOT = {"round": (0.0, 100_000.0), "stitch": (0.0, 100_000.0)}
KINDS: Final[dict[str, tuple[str, dict[str, tuple[float, float]]]]] = {
    "place": (
        "place(Ear.1, Head, round=14.5, stitch=8, tilt=20, towards=90, flat)",
        {
            **_SPOT,
            "across": _DEGREES,
            "tilt": (-90.0, 90.0),
            "towards": _DEGREES,
            "by": (0.0, 100_000.0),
            "through": (0.0, 10_000.0),
        },
    ),
    "tie": ("tie(Body, 12:5, 14:20, apart=24)", {"apart": (0.0, 10_000.0)}),
    "eye": ("eye(Head, round=14.5, stitch=20, size=9, color=black)", {**_SPOT, "size": (1.0, 100.0)}),
    "embroider": ("embroider(Head, 20.5:18, 21:20, 20.5:22, color=black, width=2)", {"width": (0.1, 30.0)}),
    "felt": (
        "felt(Head, oval, round=20, stitch=21, width=24, height=18, turn=0, color=white)",
        {**_SPOT, "width": (1.0, 1000.0), "height": (1.0, 1000.0), "turn": _DEGREES},
    ),
    "hair": (
        "hair(Head, 30:1, 30:18, count=12, length=60, color=brown)",
        {"count": (1.0, 10_000.0), "length": (1.0, 2000.0)},
    ),
}

PLAIN: Final = ("place", "tie")
"""What has no colour of its own."""

_LINE = re.compile(rf"[ \t]*({'|'.join(KINDS)})[ \t]*\((.*)\)[ \t]*,?[ \t]*$", re.IGNORECASE)
_COLOR = re.compile(r"#[0-9A-Fa-f]{3}(?:[0-9A-Fa-f]{3})?$|[A-Za-z]+$")
_NUMBER = re.compile(r"-?\d{1,9}(?:\.\d+)?$")
_AT = re.compile(r"(\d{1,6}(?:\.\d+)?)(?::(\d{1,6}(?:\.\d+)?))?$")


def is_finish(line: str) -> bool:
    """Whether a line of the language says how a part is finished."""
    return _LINE.match(line) is not None


def read_finish(source: Source, line: str, span: Span) -> Finish | None:
    """The record that ``line`` says; what is wrong is told to ``source``. Names of parts are checked by :func:`check_names`."""
    found = _LINE.match(line)
    assert found is not None
    word, before = found[1].lower(), len(source.problems)
    usage, ranges = KINDS[word]
    plain: list[tuple[str, Span]] = []
    named: dict[str, tuple[str, Span]] = {}
    offset = source.offset + found.start(2)
    for piece in found[2].split(","):
        text, at = piece.strip(), offset + len(piece) - len(piece.lstrip())
        place = Span(at, at + max(len(text), 1))
        offset += len(piece) + 1
        key, equals, value = (s.strip() for s in text.partition("="))
        if not text:
            source.error("an argument is empty", f"write {usage}", place)
        elif not equals:
            plain.append((text, place))
        elif key.lower() in named:
            source.error(f'"{key}" is given twice', "keep one of the two", place)
        elif key.lower() in ranges or (key.lower() == "color" and word not in PLAIN):
            named[key.lower()] = (value, place)
        else:
            known = [*ranges, *(["color"] if word not in PLAIN else [])]
            source.error(f'"{key}" is nothing that {word} takes', did_you_mean(key, known) or f"write {usage}", place)
    values: dict[str, Any] = {}
    for key, (value, place) in named.items():
        if key == "color":
            shade = _shade(value)
            if shade is None:
                source.error(f'there is no colour "{value}"', "a name such as black, or #rrggbb", place)
            values[key] = shade
        elif not _NUMBER.match(value) or not ranges[key][0] <= float(value) <= ranges[key][1]:
            low, high = ranges[key]
            source.error(f'"{value}" does not fit {key}', f"a number from {low:g} to {high:g}", place)
        else:
            values[key] = float(value)
    made = _READ[word](source, plain, values, usage, span)
    return made if not any(not p.warning for p in source.problems[before:]) else None


def _shade(value: str) -> RGB | None:
    from PIL import ImageColor

    if not _COLOR.match(value):
        return None
    try:
        return ImageColor.getrgb(value)[:3]
    except ValueError:
        return None


def _spot(part: str, values: dict[str, Any], span: Span) -> Spot:
    return Spot(part, values.pop("round"), values.pop("stitch", None), span)


def _needs(
    source: Source, plain: list[tuple[str, Span]], values: dict[str, Any], few: int, many: int, usage: str, span: Span
) -> bool:
    if len(plain) < few or len(plain) > many:
        where = plain[many][1] if len(plain) > many else span
        source.error("too few arguments" if len(plain) < few else "too many arguments", f"write {usage}", where)
        return False
    if "round" not in values:
        source.error("the round is missing", f"write {usage}", span)
        return False
    return True


def _place(
    source: Source, plain: list[tuple[str, Span]], values: dict[str, Any], usage: str, span: Span
) -> Finish | None:
    flat = [at for text, at in plain[2:] if text.lower() == "flat"]
    plain = plain[:2] + [(text, at) for text, at in plain[2:] if text.lower() != "flat"]
    if not _needs(source, plain, values, 2, 2, usage, span):
        return None
    values["through"] = int(values.get("through", 0))
    return Placed(plain[0][0], _spot(plain[1][0], values, plain[1][1]), flat=bool(flat), span=span, **values)


def _eye(
    source: Source, plain: list[tuple[str, Span]], values: dict[str, Any], usage: str, span: Span
) -> Finish | None:
    if not _needs(source, plain, values, 1, 1, usage, span):
        return None
    return Eye(_spot(plain[0][0], values, plain[0][1]), span=span, **values)


def _felt(
    source: Source, plain: list[tuple[str, Span]], values: dict[str, Any], usage: str, span: Span
) -> Finish | None:
    if not _needs(source, plain, values, 1, 2, usage, span):
        return None
    shape = plain[1][0].lower() if len(plain) == 2 else "circle"
    if shape not in SHAPES:
        hint = did_you_mean(shape, SHAPES) or f"one of {', '.join(SHAPES)}"
        source.error(f'felt is not cut as "{shape}"', hint, plain[1][1])
    values.setdefault("height", values.get("width", 15.0))
    return Felt(_spot(plain[0][0], values, plain[0][1]), shape, span=span, **values)


def _spots(source: Source, plain: list[tuple[str, Span]], usage: str, span: Span) -> tuple[Spot, ...]:
    spots = []
    for text, at in plain[1:]:
        found = _AT.match(text)
        if found:
            spots.append(Spot(plain[0][0], float(found[1]), float(found[2]) if found[2] else None, at))
        else:
            source.error(f'"{text}" is no place', "round:stitch, such as 20.5:18", at)
    if len(plain) < 2:
        source.error("the places are missing", f"write {usage}", span)
    return tuple(spots)


def _tie(
    source: Source, plain: list[tuple[str, Span]], values: dict[str, Any], usage: str, span: Span
) -> Finish | None:
    spots = _spots(source, plain, usage, span)
    if len(plain) > 1 and (len(plain) != 3 or "apart" not in values):
        source.error("a thread goes from one place to another, and is pulled to a length", f"write {usage}", span)
        return None
    if any(spot.stitch is None for spot in spots):
        source.error("a thread needs its stitch at both ends", f"write {usage}", span)
        return None
    return Tie(spots, span=span, **values) if len(spots) == 2 else None


def _embroider(
    source: Source, plain: list[tuple[str, Span]], values: dict[str, Any], usage: str, span: Span
) -> Finish | None:
    return Embroidery(_spots(source, plain, usage, span), span=span, **values)


def _hair(
    source: Source, plain: list[tuple[str, Span]], values: dict[str, Any], usage: str, span: Span
) -> Finish | None:
    values["count"] = int(values.get("count", 12))
    return Hair(_spots(source, plain, usage, span), span=span, **values)


_READ: Final[dict[str, Callable[..., Finish | None]]] = {
    "place": _place,
    "tie": _tie,
    "eye": _eye,
    "embroider": _embroider,
    "felt": _felt,
    "hair": _hair,
}


def parts_of(finish: Finish) -> list[tuple[str, Span]]:
    """The names of the parts that a record speaks of, each with its place in the text."""
    named = [(s.part, s.span) for s in spots_of(finish)]
    return [(finish.part, finish.span), *named] if isinstance(finish, Placed) else named


def check_names(source: Source, copies: dict[str, int], finishes: list[Finish]) -> None:
    """Tells ``source`` of parts that are not there. copies : the name of every part → how often it is made."""

    def there(name: str) -> bool:
        whole, _, number = name.rpartition(".")
        numbered = re.fullmatch(r"[1-9]\d{0,8}", number) and int(number) <= copies.get(whole, 0)
        return bool((name and name in copies) or numbered)

    for finish in finishes:
        for name, at in parts_of(finish):
            if not there(name):
                known = [f"{n}.{k}" for n, many in copies.items() for k in range(1, min(many, 9) + 1)] + [
                    n for n in copies if n
                ]
                hint = did_you_mean(name, known) or f"parts are {', '.join(n for n in copies if n)}"
                source.error(f'there is no part "{name}"', hint, at)
            elif copies.get(name, 1) > 1:
                source.error(f'"{name}" is made {copies[name]} times', f"{name}.1 is the first", at)
        if isinstance(finish, Placed) and finish.part.removesuffix(".1") == finish.spot.part.removesuffix(".1"):
            source.error("a part is not sewn to itself", "name another part", finish.span)
