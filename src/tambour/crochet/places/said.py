"""Said: what a sentence of the assembly says of a place, in words and numbers; clause by clause."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Final

from tambour.crochet.places.habits import ROUND, plainly
from tambour.crochet.words.numbers import QUANTITY, quantity

VERB: Final = re.compile(
    r"\b(?:sew|sewn|sewing|pop(?:ped)?|snap(?:ped)?|attach(?:ed|ing)?|(?<!one )(?<!\d )(?<!a )(?<!diagonal )(?<!each )(?<!every )(?<!next )stitch(?!es)(?:ed|ing)?|pin(?:ned)?|position(?:ed)?|place[ds]?|placing|join|"
    r"fix|glue|fasten(?! off)|secure|insert(?:ed)?|add|put|embroider(?:ed)?|tack|whipstitch|backstitch|cent(?:er|re)(?! of\b)|"
    r"(?:fit|press|lock|click|screw|clip|poke|stick|pull|thread|affix|install|apply)(?= (?:\w+ ){0,4}eyes?\b)|set|hot-?glue|work|(?<!bow )(?<!bow-)(?<!neck )tie|mount|push|make|create(?= (?:\w+ ){0,2}(?:nostrils?|mouth|nose|smile|eyes|eyebrows?|cheeks?|whiskers)\b)|draw|applique|go(?:es)?(?= (?:one on|either|each|both|beside|on|onto|at|to|in|into|over|under|between|behind|above|below|just|right|next|underneath|beneath|around|near|opposite|about|directly|centred|centered|slightly|halfway|(?:\d+|two|three|four|five) (?:rounds?|rnds?|rows?|st))\b)|scatter|arrange|distribute|seam(?= (?:the )?[a-z]+ (?:to|onto))|hand-?sew|slip ?st|(?:(?:thread|button)[- ])?joint(?= (?:the|both|each|on)\b)|button(?= (?:the|both|each|on)\b))\b"
)
"""Words that put something somewhere."""
OF_PLACE: Final = re.compile(
    r"\b(?:of|on|onto|to|into|at|below|above|beneath|under|over|beside|between|around|near|from|behind|inside|where|along|across)"
    r" (?:the|both|each|her|his|its|that) (?:\w+ )?$"
)
"""Words before what a place is beside."""
_SIDES: Final = frozenset("top bottom front back sides left right upper lower middle neck tip forehead".split())
_ST: Final = r"(?:stitches|stitch|sts?|sc|dc|spaces?|loops?|x(?! ?\d))"
_NO_END: Final = (
    "eyes?|muzzle|snout|nose|mouth|ears?|arms?|legs?|beak|tail|wings?|brim|last|first|sts?|stitch|rounds?|rnds?|rows?"
)
_LENGTH: Final = r"(\d+(?:[.,]\d+)?(?:\s*[½¼¾⅓⅛⅜⅝⅞]|[- ]\d/\d)?|[½¼¾⅓⅛⅜⅝⅞])\s*-?(mm|cm|inch(?:es)?|in\b|\"|”|″|'')"
_ROUNDS: Final = re.compile(
    rf"(between|over|from|on|at|along|in|around|across|near|by)?\s*(?:the\s+)?\b{ROUND}\s?\.?\s*(\d+)(?:st|nd|rd|th)?"
    rf"(?:\s*(-|–|—|to|and|&|through|thru|/)\s*(?:the\s+)?(?:{ROUND}\s?\.?\s*)?(\d+))?"
)
_ORDINAL: Final = re.compile(
    rf"(between|over|from|on|at|along|in|around|across|near|by)?\s*(?:the\s+)?\b(\d+)(?:st|nd|rd|th)"
    rf"(?:\s*(?:{ROUND})?\s*(-|–|to|and|&|through)\s*(?:the\s+)?(\d+)(?:st|nd|rd|th))?\s+{ROUND}\b"
)
_NUMBER_FIRST: Final = re.compile(
    r"\b(between|from|on|at|in|of|along) (?:the )?(?:level of (?:the )?)?(\d+)(?:\s*(-|–|to|and|till|until)\s*(\d+))? (?:row|round|rnd)\b"
    r"(?! (?:below|above|under|over|apart|from|down|up|high|higher|lower|wide|away|further)\b)"
)
"""Rounds whose number stands before them, as translators have it: "between 10 and 11 row", "at the level of 13 row"."""
_RANGE_FIRST: Final = re.compile(
    r"\b(between|from|on|at|over|along) (?:the )?(?:level of (?:the )?)?(\d+)\s*(-|–|to|and|till|until)\s*(\d+) (?:rows|rounds|rnds)\b"
    r"(?! (?:below|above|under|over|apart|from|down|up|high|higher|lower|wide|away|further)\b)"
)
"""The same of two, "between 10 and 11 rows", "on 20-22 rows": of one it is a number of them, "along 3 rounds"."""
_APART: Final = re.compile(
    rf"({QUANTITY})(?:\s*(?:-|–|to|or)\s*({QUANTITY}))?\s*{_ST}\s+(?:apart|from each other|(?:wide )?between|(?:in )?between|"
    rf"visible between|left between)"
)
_SPACE: Final = re.compile(rf"\b(?:interspace|space|gap)\s+of\s+(?:about\s+|approx\w*\.?\s+)?({QUANTITY})\s*{_ST}\b")
LONG: Final = re.compile(rf"{_LENGTH}[- ]*long\b")
_APART_MM: Final = re.compile(rf"{_LENGTH}(?:\s*[\[(][^\])]*[\])])?\s+(?:apart|between|from each other)")
_WIDE: Final = re.compile(
    rf"({QUANTITY})\s*{_ST}\s*(?:wide|long|across|in width)|(?:across|over)\s+(?:the\s+)?(?:\w+\s+)?({QUANTITY})\s*{_ST}"
)
_ASIDE: Final = re.compile(
    rf"({QUANTITY})\s*{_ST}\s+(?:to the )?(left|right) of (?:the )?(?:very )?(?:middle|cent(?:er|re))(?: of the front| front)?\b"
)
_TWO: Final = re.compile(
    r"\b(?:between|in|into|at|on|and|&|,)\s+(?:the\s+)?(?:st|sts|stitch|stitches)\s*(?:no\.?|number|#)?\s*(\d+)\b(?:\s*(?:and|&|/|-)\s*(\d+)\b(?!\s*(?:st|(?:and|&)\s*\d)))?"
)
"""The stitches of two things: "the left eye between stitches 15 and 16, the right one between stitches 22 and 23"."""
_EACH: Final = re.compile(rf"\b{ROUND}\s?\.?\s*(\d+)((?:\s*(?:,|and|&)+\s*(?:{ROUND}\s?\.?\s*)?\d+(?!\s*(?:st|sc)))+)")
"""Several rounds, one for each: "at rounds 7, 11 and 15"."""
_STACKED: Final = re.compile(
    r"\bone (?:above|below|under|over|beneath) the other\b|\b(?:down|up) (?:the |her |his |its )?(?:\w+ ){0,2}(?:front|cent(?:er|re)|middle|belly|tummy|chest)\b"
    r"|\bin a (?:vertical |straight )?(?:line|row|column) (?:down|up|along)\b|\bvertical(?:ly)?\b|\bin a (?:vertical|column)\b"
)
_STITCH: Final = re.compile(r"\b(?:st|stitch)\s*(?:no\.?|number|#)?\s*(\d+(?:\.\d+)?)\b")
_BESIDE: Final = r"(eyes?|muzzle|snout|nose|mouth|ears?|arms?|legs?|neck|beak|cheeks?|horns?|wings?|fins?|tail|belly|hat|head|brim|smile|door|stem|stalk|bun|flower|rosette)"
_AWAY: Final = re.compile(
    rf"(?:({QUANTITY})\s+(?:{ROUND}|{_ST}|spaces?)\s+)?(?:just |directly |right |slightly )?"
    rf"(below|beneath|under|underneath|down from|above|over|up from|beside|next to|in between|between|in line with|"
    rf"level with|at the level of|on either side of|on both sides of|at (?:the )?sides? of|in front of|behind|back from|"
    rf"against|around|near|close to|alongside)\s+(?:the |both |your |its |each |two |safety |bottom of (?:the )?|top of (?:the )?)*{_BESIDE}\b"
)
_FROM_END: Final = re.compile(
    rf"(?:({QUANTITY})\s+{ROUND}|{_LENGTH}|\b(?:just|right|directly|immediately|straight))\s+(?:(?:down|up|away|in|counted|measured)\s+)*"
    rf"(?:(?:below|beneath|under|underneath|from)\s+(?:the\s+)?(?:very\s+)?(top|crown|neck|head|magic ring|starting ring|beginning|nose|snout|tip of the nose)"
    rf"|(?:above|from)\s+(?:the\s+)?(?:very\s+)?(bottom|base|lower edge|underside))\b"
    rf"(?! of (?:the )?(?:{_NO_END})\b)(?:\s+(?:edge|seam|opening))?(?:\s+of\s+(?:the\s+|its\s+)?(?:head|body|neck))?"
)
"""A height counted from an end of what a part is put on: "4 rounds below the top of the head", "2 cm from the bottom"."""
_EDGE_AT: Final = re.compile(r"\b(?:top edge of it at|lower edge on) round \d+")
"""Where an edge of what is sewn lies says no side of what it is sewn to."""
_FACED: Final = (
    r"opposite (?:side )?(?:from |of |to )?(?:the )?(?:face|eyes?|muzzle|snout|nose|beak|bill|mouth|front|belly|tummy)"
)
_WHERE: Final[dict[str, str]] = {
    "top": r"\b(?:tops?|crown|upper part|very top|highest)\b(?! of (?:the )?(?:legs?|arms?|ears?|thighs?|snout|muzzle|beak|nose|face|tail|wings?|fins?|feet|last|first|sts?))",
    "bottom": r"\b(?:bottom|base|underside|beneath the body|under the body|underneath|lower edge|belly side)\b",
    "front": r"\b(?:front|facing forwards?|forehead|face side|chest)\b(?! (?:loops?|post|legs?|paws?|feet|flippers?|hooves|fins?))",
    "back": rf"\b(?:{_FACED}|back|rear|backside|behind(?! (?:rounds?|rnds?|the \w+ rnd|(?:the |each |both |its |his |her )?eyes?\b)))\b(?! (?:loops?|post|st|stitch|legs?|paws?|feet|and forth|hooves|fins?))",
    "sides": rf"\b(?:sides|either side|each side|both sides|(?!{_FACED})opposite sides?|on the sides?|to the side|each other side|one side|side of)\b",
    "left": r"\bleft\b(?! (?:open|over|long|for))",
    "right": r"\bright\b(?! (?:sides? (?:facing|out|together|of (?:the )?(?:work|fabric))|below|above|under|next|sides|on|at|in|over|behind|between|beside|near|against))",
    "upper": r"\b(?:upper|shoulders?|high(?:er)?)\b",
    "lower": r"\b(?:lower|hips?|waist|low)\b",
    "middle": r"\b(?:middle|cent(?:er|re)(?:ed|d)?|midline|halfway)\b",
    "neck": r"\b(?:neck|chin)\b",
    "forehead": r"\bforehead\b",
    "tip": r"\b(?:tip|narrow end|pointed end|far end)\b|\b(?:to|on|onto|at) (?:the )?ends? of (?:the |each |one |an? |left |right )*"
    r"(?:arms?|legs?|tails?|horns?|antennae?|trunks?|sleeves?)\b",
    "outwards": r"\b(?:outwards?|out to the sides?|sticking out|to the sides)\b",
    "inwards": r"\binwards?\b",
    "upwards": r"\b(?:upwards?|standing up|stand(?:s|ing)? up|pointing up|upright|point(?:s)? up)\b",
    "downwards": r"\b(?:downwards?|hang(?:s|ing)?(?: down)?|pointing down|point(?:s)? down|facing down|floppy|droop\w*)\b",
    "forwards": r"\b(?:forwards?|facing ahead|toes? (?:facing|pointing) (?:forwards?|front))\b",
    "backwards": r"\b(?:backwards?|swept back|leaning back)\b",
    "flat": r"\b(?:flat|flatten(?:ed)?|pinch(?:ed|ing)?|folded|fold|press(?:ed)? flat|sewn closed)\b",
    "slightly": r"\b(?:slightly|slight)\b",
    "sitting": r"\bsit(?:s|ting)?\b",
    "standing": r"\bstand(?:s|ing)?\b(?! up)",
}
_COMPILED: Final = {name: re.compile(pattern) for name, pattern in _WHERE.items()}
_DOING: Final = re.compile(
    r"(?<!\bwith),?\s(?:cinching|stuffing|using|working|making|being|adding|curving|pulling|tucking|gathering|noting|taking|stretching)\b"
    r"(?:(?! (?:between|over|apart|rounds?|rnds?)\b)[^,;])*"
)
"""What hands do meanwhile, which says no place."""
_SHOWN: Final = re.compile(
    r"\b(?:as (?:shown|pictured|seen|desired|you like|in (?:the )?(?:photo|picture|image))|photo\w*|pictures?|images?|in place|"
    r"where you like|wherever|desired)\b"
)
_ANGLE: Final = re.compile(r"(\d{1,3})\s*(?:°|degrees?)|\bat an angle\b|\bangled\b|\bdiagonal\w*\b")
_SIZE: Final = re.compile(r"(\d+(?:[.,]\d+)?)\s*-?\s*mm\b")
_NO_SIZE: Final = (
    r"(?!\s*[\])]?\s*(?:apart|down|up|from|above|below|long|wide|high|tall|tail|away|between|across|deep|of|in\b))"
)
_SMALL_CM: Final = re.compile(rf"(?<![\d.,])([0-2](?:[.,]\d+)?)\s*cm\b{_NO_SIZE}")
_INCHES: Final = re.compile(
    rf"(?<!\d)(?<!\d )(?:(\d)[/⁄](\d{{1,2}})|([¼½¾⅛⅜⅝⅞]))\s*(?:[\"”]|-?inch(?:es)?\b)(?:\s*[\[(][^()\[\]]{{1,9}}[\])])?{_NO_SIZE}"
)
_VULGAR: Final = {"½": 0.5, "¼": 0.25, "¾": 0.75, "⅓": 1 / 3, "⅛": 0.125, "⅜": 0.375, "⅝": 0.625, "⅞": 0.875}


@dataclass(frozen=True)
class Where:
    """A place as it was said.

    rounds : (first, last, whether between them); stitch : its number; aside : stitches to the toy's left of the middle of
    the front, negative to its right; apart : stitches, apart_mm : or mm
    wide : stitches that a thing is wide; words : of :data:`_WHERE` that were said
    beside : (relation, thing, so many rounds or stitches away or None); angle : degrees of leaning, None unsaid
    shown : a picture is meant to say it; through : it is crocheted in by so many stitches
    end : (from which end, so many rounds or None, so many mm or None) its height is counted; pair : the stitches of two
    each : the round of each of several, or of each pair of them; stacked : they stand one above the other
    """

    rounds: tuple[float, float, bool] | None = None
    stitch: float | None = None
    aside: float | None = None
    apart: float | None = None
    apart_mm: float | None = None
    wide: float | None = None
    words: frozenset[str] = frozenset()
    beside: tuple[tuple[str, str, float | None], ...] = ()
    angle: float | None = None
    shown: bool = False
    text: str = field(default="", compare=False)
    through: int = 0
    end: tuple[str, float | None, float | None] | None = None
    pair: tuple[float, float] | None = None
    each: tuple[float, ...] = ()
    stacked: bool = False

    @property
    def says(self) -> bool:
        """Whether it says anything of a place."""
        return bool(self.rounds or self.beside or self.end or self.words & _SIDES)


@lru_cache(maxsize=256)
def where(text: str) -> Where:
    """What ``text`` (in small letters) says of a place."""
    rounds = None
    text = plainly(text)
    text = _NUMBER_FIRST.sub(lambda m: f"{m[1]} row {m[2]}" + (f" {m[3]} {m[4]}" if m[4] else ""), text)
    text = _RANGE_FIRST.sub(r"\1 rows \2 \3 \4", text)
    text = _DOING.sub("", text)
    text = re.sub(r"\b(?:on|at|to|towards?) the outsides? of (?:the |each |both )", "beside the ", text)
    text = re.sub(r"\b(?:approx(?:imately)?\.?|about|around(?= \d)|roughly)\s+", "", text)
    both = [m for m in (_ROUNDS.search(text), _ORDINAL.search(text)) if m is not None]
    found = min(both, key=lambda m: m.start(), default=None)
    if found:
        first, last = float(found[2]), float(found[4] or found[2])
        rounds = (first, last, found[1] == "between" and found[4] is not None)
    several = _EACH.search(text)
    each = () if several is None else tuple(float(n) for n in (several[1], *re.findall(r"\d+", several[2])))
    ranged = several is not None and re.search(r"\b(?:between|from|over)\s+(?:the\s+)?$", text[: several.start()])
    each = () if ranged or list(each) != sorted(set(each)) or (len(each) == 2 and each[1] == each[0] + 1) else each
    end = None
    if rounds is None and (far := _FROM_END.search(text)) is not None:
        named = "all" if far[4] == "top" and far[0].endswith("top") else far[4] or far[5]
        end = (named, quantity(far[1]) if far[1] else None, length(far[2], far[3]) if far[2] else None)
        text = text[: far.start()] + text[far.end() :]
    two = _TWO.findall(text)
    pair = (_mean(two[0]), _mean(two[1])) if len(two) == 2 else None
    apart = _APART.search(text)
    between = apart is not None and "between" in apart[0]
    steps = None if apart is None else max(quantity(apart[1]), quantity(apart[2] or apart[1])) + between
    if steps is None and (space := _SPACE.search(text)) is not None:
        steps = quantity(space[1]) + 1
    mm = _APART_MM.search(text)
    aside = _ASIDE.search(text)
    text = _ASIDE.sub("", text)
    wide, stitch, angle = _WIDE.search(text), _STITCH.search(text), _ANGLE.search(text)
    own = _EDGE_AT.sub("", text)
    beside = tuple(
        (m[2], m[3].rstrip("s") if m[3] not in ("eyes",) else "eye", quantity(m[1]) if m[1] else None)
        for m in _AWAY.finditer(text)
    )
    return Where(
        rounds,
        float(stitch[1])
        if (stitch and found is None) or (stitch and not re.search(r"(?:st|stitch)\s+\d+\s*(?:rnd|round)", text))
        else None,
        None if aside is None else quantity(aside[1]) * (1.0 if aside[2] == "left" else -1.0),
        steps,
        length(mm[1], mm[2]) if mm and apart is None else None,
        quantity(wide[1] or wide[2]) if wide else None,
        frozenset(name for name, pattern in _COMPILED.items() if pattern.search(own)),
        beside,
        None if angle is None else float(angle[1]) if angle[1] else 30.0,
        bool(_SHOWN.search(text)),
        text,
        end=end,
        pair=pair,
        each=each,
        stacked=bool(_STACKED.search(text)),
    )


def _mean(numbers: tuple[str, str]) -> float:
    """A stitch, or the gap between two."""
    return float(numbers[0]) if not numbers[1] else 0.5 * (float(numbers[0]) + float(numbers[1]))


def length(words: str, unit: str) -> float:
    """A length in mm: ``1½``, ``1 1/2``, ``4,5`` in mm, cm or inches."""
    total = 0.0
    for piece in re.findall(r"\d+/\d+|\d+(?:[.,]\d+)?|[½¼¾⅓⅛⅜⅝⅞]", words):
        a, _, b = piece.partition("/")
        total += _VULGAR[piece] if piece in _VULGAR else float(a) / float(b) if b else float(piece.replace(",", "."))
    return total * {"mm": 1.0, "cm": 10.0}.get(unit, 25.4)


def size(text: str) -> float | None:
    """A size in mm that is said ("8 mm safety eyes", "1/4" [6 mm] eyes", "7/8" safety eyes")."""
    if found := _SIZE.search(text):
        return float(found[1].replace(",", "."))
    if found := _SMALL_CM.search(text):
        return 10.0 * float(found[1].replace(",", "."))
    found = _INCHES.search(text)
    if found is None:
        return None
    inches = _VULGAR[found[3]] if found[3] else int(found[1]) / int(found[2])
    return round(2.0 * 25.4 * inches) / 2.0  # as they are sold


_AND: Final = re.compile(r"(?:,\s*(?:and\s+)?(?:then\s+)?|;\s*|\.\s+|\s+and\s+(?:then\s+)?|\s+then\s+)(?=\w+)")


def clauses(text: str) -> list[tuple[int, int]]:
    """Where the clauses of a sentence stand that put something somewhere: one for each such verb."""
    cuts = [0]
    for m in _AND.finditer(text):
        verb = VERB.match(text, m.end())
        if verb and VERB.search(text, cuts[-1], m.start()):
            cuts.append(m.end())
    return list(zip(cuts, [*cuts[1:], len(text)]))
