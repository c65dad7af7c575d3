"""Yarns: which class of yarn words name, hooks, how large a single crochet is in them, and the phrases that say a gauge."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from typing import Final

from tambour.core.errors import TambourError
from tambour.weights import WEIGHTS as CLASSES

IN_A_STITCH: Final = 8.0
"""Yarn in a single crochet, in stitch widths, once hands have drawn it tight: swatches that makers unravelled and
published (31.4 in of worsted to a square inch at a 5 mm hook; 2.75 in of bulky to a stitch at 6.5 mm) give 8."""

SQUARE: Final = 3.0 / math.pi
"""Height over width of a single crochet where only one of them is known: with it the flat circle lies flat, whose
rounds grow by six stitches: 2π heights are six widths."""

UNDER: Final = (0.95, 0.9)
"""Width and height of a single crochet with the yarn laid under the hook, as shares of one with the yarn over: it is
smaller and tighter; by how much is assumed, a swatch of one's own says it."""

CIRCLE: Final = 5
"""Rounds of the gauge circle; its last has 30 stitches."""


WEIGHTS: Final = {name: weight for name, weight in CLASSES.items() if name != "aran"}
"""Classes of yarn by name; crocheters say aran for worsted."""

_ALIASES: Final = {
    "4-ply": "fingering", "4 ply": "fingering", "sock": "fingering", "super fine": "fingering", "5-ply": "sport",
    "5 ply": "sport", "double knit": "dk", "double knitting": "dk", "light worsted": "dk", "8-ply": "dk", "8 ply": "dk", "aran": "worsted",
    "10-ply": "worsted", "10 ply": "worsted", "medium": "worsted", "super chunky": "super-bulky",
    "super bulky": "super-bulky", "super-bulky": "super-bulky", "chunky": "bulky", "12-ply": "bulky",
}  # fmt: skip

HOOKS: Final = {
    "B": 2.25, "C": 2.75, "D": 3.25, "E": 3.5, "F": 3.75, "G": 4.0, "7": 4.5, "H": 5.0, "I": 5.5, "J": 6.0, "K": 6.5,
    "L": 8.0, "M": 9.0, "N": 10.0, "P": 11.5,
}  # fmt: skip
"""Hooks of the US by letter, mm."""

_NUMBER = r"(\d+(?:[.,]\d+)?)"
_UNITS = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "in": 25.4, "ins": 25.4, "inch": 25.4, "inches": 25.4,
          **dict.fromkeys(("centimeter", "centimeters", "centimetre", "centimetres"), 10.0),
          '"': 25.4, "″": 25.4, "”": 25.4}  # fmt: skip
_LENGTH = re.compile(
    _NUMBER + r"\s*-?\s*(mm|cm|m|inches|inch|ins|in|centimet(?:er|re)s?|\"|″|”)(?![a-z])", re.IGNORECASE
)
_SWATCH = re.compile(
    _NUMBER + r"\s*(?:sc|dc|sts?|stitches|m|p|v)?\b[^\d]{0,40}?(?:[x×*]|and|by|,|&|und|y|et|en)\s*" + _NUMBER
    + r"\s*(?:rows?|rounds?|rnds?|r\b)?", re.IGNORECASE,
)  # fmt: skip
_STITCHES = re.compile(
    _NUMBER + r"\s*(?:sc|hdc|dc|sts?|stitches|single crochets?)\b(?!\s*(?:rows?|rounds?|rnds?)\b)", re.IGNORECASE
)
_ROWS = re.compile(_NUMBER + r"(\s*½)?\s*(?:(?:sc|hdc|dc)\s+)?(?:rows?|rounds?|rnds?|r)\b", re.IGNORECASE)
_AN_INCH = re.compile(r"\b(?:an|one|per|each|every) inch\b", re.IGNORECASE)
_CIRCLE = re.compile(r"\b(?:circle|diameter|across|first)\b|\b(?:rounds?|rnds?)\s*\d", re.IGNORECASE)
_TALL: Final = 1.3  # height over width that no single crochet has: rows of taller stitches
_RAVELLED = re.compile(r"\s*(\d+)\s*[^\d]*?" + _NUMBER + r"\s*(mm|cm|m|inches|inch|in|\")\s*$", re.IGNORECASE)
_GRAMS = r"(?P<grams>(?<![\d.,])\d{2,4}(?:[.,]\d+)?)[ \t]*-?[ \t]*(?:g|gr|grs|gms?|grams?)\b"
_FAR = r"(?P<far>(?<![\d.,])\d{2,4}(?:[.,]\d+)?)[ \t]*-?[ \t]*(?P<unit>m|mtrs?|metres?|meters?|yds?|yards?)\b"
_UP_TO = r"(?:[ \t,;:/=)(|~-]|\b(?:per|each|approx|approximately|about|balls?|skeins?|of|oz|yds?|yards?)\b|\b\d+(?:[.,]\d+)?(?![.,]?\d))*?"
_BALLS = [re.compile(_GRAMS + _UP_TO + _FAR, re.IGNORECASE), re.compile(_FAR + _UP_TO + _GRAMS, re.IGNORECASE)]
_LETTER = re.compile(r"\b([B-P])\s*[-/]\s*\d|\b([B-P])\b(?=\s*(?:hook|size|$|,|\())|size\s+([B-P])\b")


@dataclass(frozen=True, slots=True)
class Gauge:
    """The size of a single crochet and where it comes from.

    width, height : mm; source : a sentence for reports; weight : the class of the yarn, a key of WEIGHTS
    hook : mm; told : what of "gauge", "yarn", "hook" was said rather than taken as usual
    """

    width: float
    height: float
    source: str
    weight: str
    hook: float
    told: tuple[str, ...] = ()

    @property
    def circle(self) -> float:
        """Width, mm, of the flat circle of five rounds."""
        return 2.0 * CIRCLE * 0.5 * (self.height + self.width * SQUARE)


def expected(weight: str, hook: float) -> float:
    """Width, mm, of a single crochet in a yarn with a hook: its class's own at the usual hook, less with a smaller one.

    Yarn keeps its thickness, so that 0.15 of the stitch does not follow the hook: a fit to the Council's middles and to
    the gauge circle of a book of toys, two inches across five rounds at 3.5 mm.
    """
    kind = WEIGHTS[weight]
    return 101.6 / kind.single * (0.15 + 0.85 * hook / kind.hook)


def class_of(words: str) -> str | None:
    """The class of yarn that words name: ``DK``, ``4``, ``#3``, ``aran (medium)``."""
    text = words.lower()
    found = re.fullmatch(r"\s*#?\s*([0-7])\s*", text) or re.search(
        r"(?:weight|category|cyc|size|#)\s*#?\s*([0-7])\b", text
    )
    if found:
        return list(WEIGHTS)[int(found[1])]
    for word in sorted([*_ALIASES, *WEIGHTS], key=len, reverse=True):
        if re.search(rf"(?<![a-z0-9]){re.escape(word)}(?![a-z])", text):
            return _ALIASES.get(word, word)
    return None


def hook_of(words: str) -> float | None:
    """Millimetres of the hook that words name: ``3.5 mm``, ``E/4``, ``size E``."""
    found = re.search(_NUMBER + r"\s*-?\s*mm", words, re.IGNORECASE)
    if found:
        return _float(found[1])
    letter = _LETTER.search(words)
    if letter:
        return HOOKS.get(letter[1] or letter[2] or letter[3])
    plain = re.fullmatch(r"\s*" + _NUMBER + r"\s*", words)
    return _float(plain[1]) if plain and 0.5 <= _float(plain[1]) <= 30 else None


@dataclass(frozen=True, slots=True)
class Ball:
    """A ball of yarn: its grams, and its metres."""

    grams: float
    metres: float

    @property
    def metres_100_g(self) -> float:
        return 100.0 * self.metres / self.grams


def balls_of(words: str) -> list[Ball]:
    """The balls that words tell of by their grams and metres.

    >>> balls_of("Bulky (10.5 oz/300 g; 220 yds/201 m), 50 g = 125 m")
    [Ball(grams=300.0, metres=201.168), Ball(grams=50.0, metres=125.0)]
    """
    found = []
    orders = [made for order in _BALLS if (made := list(order.finditer(words)))]  # grams before metres, or behind them
    for said in min(orders, key=lambda made: made[0].start(), default=[]):
        if not _float(said["grams"]):
            continue
        ball = Ball(_float(said["grams"]), _float(said["far"]) * (0.9144 if said["unit"][0] in "yY" else 1.0))
        if 20.0 <= ball.metres_100_g <= 2000.0:
            found.append(ball)
    return found


def ball_of(words: str) -> Ball | None:
    """The first ball of a pattern's words, if all are as heavy for their length; None where they are not, or none is said."""
    found = balls_of(words)
    weights = [ball.metres_100_g for ball in found]
    return found[0] if found and max(weights) <= 1.1 * min(weights) else None


def swatch_of(words: str) -> tuple[float, float] | None:
    """Width and height, mm, that a stated gauge gives: ``20 sc x 22 rows = 10 cm``, ``26 sts = 4"; 22 rounds = 4"``,
    ``first 5 rounds = 5 cm across``; None where it is not understood. Rounds are of a circle only where that is said."""
    words = _AN_INCH.sub("1 inch", words)
    found = [(m.start(), _float(m[1]) * _UNITS[m[2].lower()]) for m in _LENGTH.finditer(words)]
    lengths = [length for _, length in found]
    if not lengths:
        return None
    stitches, rows = _STITCHES.search(words), _ROWS.search(words)

    def size(said: re.Match[str] | None) -> float:
        """Of one of those that ``said`` counts, by the length that stands behind it; 0 where none is counted."""
        if said is None:
            return 0.0
        count = _float(said[1]) + (0.5 if said is rows and said[2] else 0.0)
        behind = next((length for at, length in found if at >= said.end()), lengths[0])
        return behind / count if count > 0 else 0.0

    width, height = size(stitches), size(rows)
    if width and height:
        return width, height if height < _TALL * width else width * SQUARE
    swatch = _SWATCH.search(_LENGTH.sub(" ", words))
    if swatch and not (rows and _CIRCLE.search(words)):
        across, up = _float(swatch[1]), _float(swatch[2])
        if across > 0 and up > 0:
            return lengths[0] / across, lengths[0] / up
    if not stitches and _CIRCLE.search(words):
        rounds = re.search(
            r"(?:rounds?|rnds?)\s*(?:1\s*(?:-|–|to)\s*)?(\d+)|(\d+)\s*(?:rounds?|rnds?)", words, re.IGNORECASE
        )
        count = int(rounds[1] or rounds[2]) if rounds else CIRCLE
        return (lengths[-1] * math.pi / (6 * count), lengths[-1] / (2 * count)) if 1 <= count <= 100 else None
    if width:
        return width, width * SQUARE
    return (height / SQUARE, height) if height else None


_SWATCHES: Final = (25.4, 50.8, 101.6, 25.0, 50.0, 100.0, 152.4, 150.0)
"""Lengths, mm, over which people count their stitches."""
_PLAUSIBLE: Final = (1.5, 25.0)  # mm of a stitch


def tells_gauge(words: str) -> bool:
    """Whether a sentence tells a gauge, in whatever words: so many stitches, and rows, in a length that swatches have, or so many rounds
    across: "I get 5 stitches and 5.5 rows to an inch", "10 cm are 18 stitches", "Rounds 1-5 of the head measure 5 cm in diameter"."""
    words = _AN_INCH.sub("1 inch", words)
    size = swatch_of(words)
    if size is None or _NO_GAUGE.search(words):
        return False
    lengths = [_float(m[1]) * _UNITS[m[2].lower()] for m in _LENGTH.finditer(words)]
    counted = _STITCHES.search(words) is not None
    said = re.search(r"\b(?:gauge|tension|swatch)\b", words, re.IGNORECASE) is not None
    across = _ACROSS.search(words) is not None and re.search(r"\b(?:rounds?|rnds?)\b", words, re.IGNORECASE) is not None
    square = counted and any(abs(n - one) < 0.6 for n in lengths for one in _SWATCHES)
    rows = re.search(r"\b(?:rounds?|rnds?|rows?)\b", words, re.IGNORECASE) is not None
    both = counted and rows and "=" in words and len(lengths) > 0 and all(20.0 <= n <= 160.0 for n in lengths)
    return (square or both or across or (said and counted)) and all(_PLAUSIBLE[0] <= n <= _PLAUSIBLE[1] for n in size)


_NO_GAUGE: Final = re.compile(
    r"\b(?:tail|end|leav\w*|apart|long|length|yarn for|ring|ch|chain|inc|dec)\b", re.IGNORECASE
)
_ACROSS: Final = re.compile(r"\b(?:across|diameter|wide|circle)\b", re.IGNORECASE)


def ravelled(words: str) -> float:
    """Width, mm, of a single crochet from ``20 stitches are 64 cm``: the yarn of 20 unravelled stitches.

    Raises TambourError when it is not said so.
    """
    found = _RAVELLED.match(words)
    if not found or int(found[1]) < 1 or _float(found[2]) <= 0:
        raise TambourError(
            f'"{words}" does not say how much yarn stitches take', hint="such as: 20 stitches are 64 cm",
            where="{--gauge-yarn}",
        )  # fmt: skip
    return _float(found[2]) * _UNITS[found[3].lower()] / int(found[1]) / IN_A_STITCH


def _float(text: str) -> float:
    return float(text.replace(",", "."))
