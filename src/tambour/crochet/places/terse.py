"""Terse: lists of the assembly that leave their verb out: "Arms: either side at Round 18", "Mouth: black, a little V below the eyes"."""

from __future__ import annotations

import re
from functools import lru_cache
from typing import Final

from tambour.crochet.places import face, lines
from tambour.crochet.places.curt import by_its_edge
from tambour.crochet.places.names import Made, kind_of, one
from tambour.crochet.places.said import VERB, where
from tambour.crochet.words.numbers import QUANTITY

_NUMBERED: Final = r"^\W*(?:\d{1,2}\s*[.)]\s*)?"
_ROUND: Final = r"(?:(?:rounds?|rnds?|rds?|rows?|r)\s?\.?\s*\d|\d+(?:st|nd|rd|th)\s+(?:rounds?|rnds?|rds?|rows?))"
_LED: Final = re.compile(
    rf"{_NUMBERED}(?P<name>(?:[^\W\d_]+[ &+/-]*){{1,4}}?)\s*(?P<mark>[:–—|→]|\s-)(?=\s+\S)", re.IGNORECASE
)
_PLACE: Final = re.compile(
    rf"^(?P<bare>\W*(?P<name>(?:[^\W\d_]+\s+){{1,3}}?))(?P<mark>[(\[]?)(?={_ROUND})", re.IGNORECASE
)
"""A part and the rounds it is sewn to, and no more than a bracket between: "Ears R4-R8", "Ears (R5): 12 sts apart"."""
_HUED: Final = re.compile(r"[)\]]\s*[:–—-]\s*(?:with\s+|colou?r\s+|yarn\s+)?[a-z]\W*$")
"""A part's rounds and the letter of their yarn, which put nothing anywhere."""
_COVERS: Final = re.compile(
    rf"^\W*(?:(?:the|each|every|both|your|one)\s+)*(?P<name>[^\W\d_]+)\s+(?:should\s+|will\s+|must\s+)?"
    rf"(?:cover|span|reach|stretch|run|take up|sit|lie)s?\s+(?:over\s+|from\s+|across\s+|between\s+|at\s+|on\s+|about\s+)?(?={_ROUND})"
)
"""A part and the rounds that it covers: "Each ear covers rounds 4 through 8"."""
_RUNS: Final = re.compile(
    r"^\W*(?:(?:the|these|those|all|both|three|four|five|six|two|\d+|your|then|finally|next|remaining|other)\s+)*(?P<name>(?:[^\W\d_]+\s+){0,2}?[^\W\d_]+)\s+"
    r"(?:should\s+|will\s+|must\s+|can\s+|all\s+|then\s+)*(?:(?:is|are) (?:laid|placed|draped|hung|spread)|run|go|continue|carry on|follow|march|trail|climb|line up|sit|stand|belong|are|is|come|get lined up|form a (?:line|row)|make a (?:line|row))(?:es|s)?\s+"
    r"(?P<place>(?:(?:all (?:the way )?|right |straight |evenly |high |low |well |up |in a (?:straight )?(?:line|row) )*)(?:down|along|up|over|across|on|onto|at|to|from|around|behind|in the middle|next to|below|above|under)\b.*)"
)
"""A part, or a row of it, and where it lies: "The small spikes run down the tail"."""
_GIVE: Final = re.compile(
    r"^\W*(?:(?:and|then|now|finally|also)\s+)*give\s+(?:him|her|it|them|(?:the|your)\s+\w+)\s+(?=(?:an?|two|some|tiny|little|his|her)\b)"
)
"""What a face is given: "Give her a cute little smile"."""
_SIDES: Final = (
    r"(?:(?:upper|lower|cent(?:er|re)|very)\s+)?"
    r"(?:front|back|top|bottom|middle|cent(?:er|re)|sides?|crown|base|rear|belly|tummy|chest|underside|underneath)"
)
_AT: Final = re.compile(
    rf"^\s*(?:(?:high|low|far|well)\s+(?:up\s+|down\s+)?)?(?:{_ROUND}|(?:on|at|to|from|between|over|either|both|each|one|(?:left|right)(?: and (?:the )?(?:left|right))? (?:from|of|side)|(?:just|right|directly|straight) (?:behind|below|above|under|over|at|on|next)|in|into|under|below|behind|beside|above|along|around|across|centred|centered|evenly|spread|spaced|{_SIDES}(?=\s*,|\s*$|\s*\.|\s+(?:middle|top|bottom|front|back|on|of|at)\b)|\d+\s+(?:sts?|stitch\w*|rnds?|rounds?)\s+(?:apart|from|below|above|down|up|either|on|between))\b)"
)
_MANY: Final = re.compile(
    rf"^\s*(?:the\s+)?{QUANTITY}\s+(?:[a-z]+\s+){{0,2}}?(?:on|at|to|onto|around|over|between|along|down|in the middle)\b(?!\s+(?:each|both|either)).*[,;]|^\s*(?:the\s+)?{QUANTITY}\s.*\band\s+(?:the\s+)?(?:{QUANTITY}|rest|others)\b"
)
"""Several of a part, each at a place of its own: "2 small ones on the head, 3 big ones on the back"."""
_EYES: Final = re.compile(
    r"^\W*(?:(?:the|two|2|both|a pair of)\s+)?(?:(?:safety|plastic|toy|black|brown|blue|green|amber|\d+(?:\.\d+)?\s?mm)\s+)*eyes?\s*"
    r"(?:\([^()]{1,20}\)\s*)?[:–—-]?\s+(?=(?:on|at|between|in|over)\b)",
    re.IGNORECASE,
)

_ONE_EYE: Final = re.compile(r"\bone eye (?=(?:at|between|on|in|over)\b)")
_ROUND_OF: Final = re.compile(
    r"\b(?:stitches|sts|rounds|rows) (?:are|will be) (?:worked|made|crocheted)\b|\b(?:start|beginning|end) of (?:every|each) (?:rows?|rnds?|rounds?)\b"
)
"""What is said of a round, and puts nothing anywhere: "In the next round, stitches are worked around the opening"."""
_BY_EYES: Final = re.compile(
    r"\b(?:at|in|on|from|near|above|below|beside|under|over) (?:the |each |both |its )*(?:(?:outer|inner) (?:corner|edge|side|end)|eye)"
)
"""Where a face's feature is by the eyes."""
_BARE: Final = re.compile(
    rf"{_NUMBERED}(?P<bare>(?:(?:the|both|one|two|all|four|five|six|eight|and|finally|next|little|small|big|tiny)\s+)*"
    r"(?P<name>(?:[^\W\d_]+\s+){1,3}?))(?=(?:to|on|onto|at|over|either side|each side|both sides|underneath|under|beneath|behind|"
    r"in front|in the (?:front|back)|between|along|in the middle|centred|centered|just|right (?:on|at|under|above|below))\b)"
)
"""A part and its place, without a verb: "Ears to each side of the head at Rd 9, drooping"."""
_WORKS: Final = re.compile(
    r"\b(?:\d*\s*(?:sc|dc|hdc|tr|htr|slst|inc|dec)|sl st|ch|work|crochet|stuff\w*|cut|leave|fasten|turn|join\w*|make[sn]?|yarn|tail of|repeat|rep|"
    r"is|are|was|were|will|can|should|has|have|worked|made|need\w*|begin|start|colou?r)\b"
)
"""Words of what is worked, or told."""
_SORTS: Final = frozenset(
    "front back hind fore left right inner outer upper lower side other first second baby".split()
)
_LONG: Final = 200
_CENTER: Final = re.compile(
    r"\bcent(?:er|re)(?=\s+(?:top|bottom|front|back|of)\b)(?!\s+(?:front|back|top|bottom)?\s*\w+\s+(?:on|over)\b)"
)
"""A place, and no verb: "center top of head"."""

_YARN_LED: Final = re.compile(
    rf"^\W*(?:and\s+)?(?:in|with|using)\s+(?:[a-z]+\s+){{0,2}}?[a-z]+,\s*(?P<bare>(?:then\s+)?(?:an?|the|{QUANTITY}|some|several|a few)\s)"
)
"""What is drawn, behind its yarn alone: "In pink, a small triangle nose at the top of the muzzle"."""
_FEATURE: Final = re.compile(
    r"^\W*(?:(?:in|with|using)\s+(?:[a-z]+\s+){0,2}?[a-z]+,\s*)?"
    r"(?P<bare>(?:(?:the|a|an|two|three|four|\d+|short|long|small|little|tiny|big|wide|straight|rounded|upright|black|brown|pink|white|red|rosy|triangle|triangular|oval|heart-shaped)\s+)*"
    r"(?:mouth|nose|nostrils?|cheeks?|(?:eye)?lashes|(?:eye)?brows|smile|whiskers|freckles|blush)\b\s+(?:is |are |go |goes )?"
    r"(?:between|on|at|over|under|below|above|in|with|just|right|either)\b)"
)
"""A face's feature without a verb: "Two short lashes on the outside of each eye"."""


@lru_cache(maxsize=64)
def _words(names: tuple[str, ...]) -> frozenset[str]:
    """The words of parts' names."""
    return frozenset(w for name in names for w in Made(name, 1).words)


def verb_of(text: str, names: list[str]) -> tuple[int, str] | None:
    """Where a verb is left out of a sentence, and which: sewn on what names a part, embroidered what names a motif of a face; None where
    none is wanted. names : of the parts that are known."""
    low = text.lower()
    verb = VERB.search(_CENTER.sub(lambda m: "-" * len(m[0]), low))
    if (eyes := _EYES.match(low)) is not None and not verb:
        return eyes.end() - 1, " placed"
    if not verb and (eye := _ONE_EYE.search(low)) is not None:
        return eye.start(), "place "
    feature = _FEATURE.match(low)
    if feature is not None and not verb and (where(low).says or re.search(r"\beyes?\b", low)):
        return feature.start("bare"), "embroider "
    led = _YARN_LED.match(low) if not verb and len(low) < _LONG and not _WORKS.search(low) else None
    if led is not None and face.motifs(low[led.start("bare") :]):
        return led.start("bare"), "embroider "
    known = _words(tuple(names))
    bare = _BARE.match(low) if len(low) < _LONG and not verb and not _WORKS.search(low) else None
    if bare is not None and where(low).says:
        words = [one(w) for w in bare["name"].split()]
        if all(w in known or kind_of(w) or w in _SORTS for w in words) and words[-1] not in _SORTS:
            return bare.start("bare"), "sew "
    if verb:
        return None
    if (covers := _COVERS.match(low)) is not None and (kind_of(one(covers["name"])) or one(covers["name"]) in known):
        return covers.end("name"), " sewn over"
    if (give := _GIVE.match(low)) is not None and face.motifs(low[give.end() :]):
        return give.end(), "embroider "
    if (runs := _RUNS.match(low)) is not None and len(low) < _LONG and not _WORKS.search(runs["place"]):
        words = [one(w) for w in runs["name"].split()]
        on = [one(w) for w in re.findall(r"[^\W\d_]+", runs["place"])]
        there = where(runs["place"]).says or any(w in known or kind_of(w) for w in on)
        if there and (words[-1] in known or kind_of(words[-1])):
            return runs.end("name"), " sewn"
    led = _LED.match(low)
    placed = _PLACE.match(low) if led is None and len(low) < _LONG and not _WORKS.search(low) else None
    if placed is not None and _HUED.search(low):
        return None  # "Arm (Rounds 5-14): G."
    if placed is not None:
        return _put_there(placed, known)
    if led is None:
        return None
    words = [one(w) for w in re.findall(r"[^\W\d_]+", led["name"])]
    at = led.end("mark")
    if re.match(rf"\s*{_ROUND}", low[at:]) and (
        _WORKS.search(low[at:]) or not (set(words) & known or kind_of(words[-1]) or face.motifs(low[:at]))
    ):
        return None  # "Ears: Rnd 1: 6 sc in magic ring"
    if lines.called(low[at:]) and words[-1] not in known and not _WORKS.search(lines.LINES.sub("", low[at:])):
        return at, " embroider"  # "Forehead: 3 stripes from R5 to R9"
    if words[-1] == "eye" and not {"from", "measure", "count"} & {*led["name"].split()} and _AT.match(low[at:]):
        return at, " place"
    if face.motifs(led["name"]) and not set(words) & known and where(low[at:]).rounds is not None:
        return at, " embroider"  # "Cheeks - pink, R11"
    if face.motifs(led["name"]) and not set(words) & known and _BY_EYES.search(low[at:]):
        return at, " embroider"  # "Lashes - 2 stitches with black at the outer corner"
    if led["mark"].strip() != ":" and not _AT.match(low[at:]):
        return None  # "SNOUT - rose"
    sewn = set(words) & known and _AT.match(low[at:])  # "Cheeks: at the height of R15", of those that were crocheted
    if (face.motifs(led["name"]) and not sewn) or words == ["face"]:
        return at, " embroider"
    if _MANY.match(low[at:]) and not _WORKS.search(low[at:]) and any(w in known or kind_of(w) for w in words):
        return at, " sew"
    part = any(w in known or kind_of(w) for w in words)
    put = " sew at" if re.match(rf"\s*(?:{_ROUND}|{_SIDES}\b)", low[at:]) else " sew"
    return (at, put) if part and _AT.match(low[at:]) else None


def _put_there(found: re.Match[str], known: frozenset[str]) -> tuple[int, str] | None:
    """The verb before a part that stands straight before its rounds."""
    words = [one(w) for w in found["name"].split()]
    if words[-1] == "eye":
        return found.end("name") - 1, " place at"
    if face.motifs(found["name"]) and not set(words) & known:
        return found.start("name"), "embroider "
    if not all(w in known or kind_of(w) or w in _SORTS for w in words) or words[-1] in _SORTS:
        return None
    return found.end("name") - 1, " sew at"


def spoken(text: str, names: list[str]) -> str:
    """The sentence with its verb."""
    found = verb_of(text, names)
    return text if found is None else text[: found[0]] + found[1] + text[found[0] :]


_REPEATED: Final = re.compile(r"\*|\bas (?:given )?for\b|^\s*(?:rep|repeat|work)\b", re.IGNORECASE)
"""Rounds that are worked again are no place."""


_DRAWS: Final = re.compile(r"\bembroider\w*\b|\bsatin st|\b(?:straight|back|chain) ?st\w*\b")


def under(heading: str, text: str, names: list[str]) -> str:
    """A place that stands under the heading of what is put there ("EARS", and below it "Between R4 and R8"), in one sentence, or what is
    embroidered under its name ("Nose: Embroider a triangle on Rnd 1"); "" for all else."""
    led = f"{heading}: {text}"
    if heading and (full := by_its_edge(led, names)):
        return full  # "LEGS", and "the closed edge at round 8" below it
    drawn = face.motifs(heading.lower()) if len(heading.split()) == 1 and _DRAWS.search(text.lower()) else []
    if drawn and not face.motifs(text.lower()) and not _REPEATED.search(text) and VERB.search(text.lower()):
        return led
    if (
        len(heading.split()) == 1
        and lines.called(text.lower())
        and not VERB.search(text.lower())
        and not _REPEATED.search(text)
    ):
        return f"{heading}: embroider {text}"  # "Forehead", and "3 stripes from R5 to R9" below it
    place = heading and not _REPEATED.search(text) and _AT.match(text.lower()) and verb_of(text, names) is None
    place = place and not _ROUND_OF.search(text.lower())
    return led if place and verb_of(led, names) is not None else ""
