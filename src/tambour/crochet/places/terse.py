"""Terse: lists of the assembly that leave their verb out: "Arms: either side at Round 18", "Mouth: black, a little V below the eyes"."""

from __future__ import annotations

import re
from typing import Final

from tambour.crochet.places import face
from tambour.crochet.places.names import Made, kind_of, one
from tambour.crochet.places.said import VERB, where

_NUMBERED: Final = r"^\W*(?:\d{1,2}\s*[.)]\s*)?"
_LED: Final = re.compile(rf"{_NUMBERED}(?P<name>(?:[^\W\d_]+[ &+/-]*){{1,4}}?)\s*(?P<mark>[:–—]|\s-)(?=\s+\S)")
_AT: Final = re.compile(
    r"^\s*(?:on|at|to|between|over|either|both|each|one|in|into|under|below|behind|above|along|around|across|centred|centered|(?:front|back|top|bottom|middle)(?=\s*,|\s+(?:middle|front|back|on|of|at)\b)|\d+\s+(?:sts?|stitch\w*|rnds?|rounds?)\s+(?:apart|from|below|above|down|up|either|on|between))\b"
)
_EYES: Final = re.compile(r"^\W*(?:the\s+)?(?:safety\s+)?eyes?\s+(?=(?:on|at|between|in|over)\b)", re.IGNORECASE)

_BARE: Final = re.compile(
    rf"{_NUMBERED}(?P<bare>(?:(?:the|both|two|all|four|five|six|eight|and|finally|next|little|small|big|tiny)\s+)*"
    r"(?P<name>(?:[^\W\d_]+\s+){1,3}?))(?=(?:to|on|onto|at|over|either side|each side|both sides|underneath|under|beneath|behind|"
    r"in front|between|along|in the middle|centred|centered|just|right (?:on|at|under|above|below))\b)"
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

_FEATURE: Final = re.compile(
    r"^\W*(?P<bare>(?:(?:the|a|an|two|three|four|\d+|short|small|little|tiny|black|brown|pink|white|red|rosy)\s+)*"
    r"(?:mouth|nose|nostrils?|cheeks?|(?:eye)?lashes|(?:eye)?brows|smile|whiskers|freckles|blush)\b\s+(?:is |are |go |goes )?"
    r"(?:between|on|at|over|under|below|above|in|with|just|right|either)\b)"
)
"""A face's feature without a verb: "Two short lashes on the outside of each eye"."""


def verb_of(text: str, names: list[str]) -> tuple[int, str] | None:
    """Where a verb is left out of a sentence, and which: sewn on what names a part, embroidered what names a motif of a face; None where
    none is wanted. names : of the parts that are known."""
    low = text.lower()
    if (eyes := _EYES.match(low)) is not None and not VERB.search(low):
        return eyes.end() - 1, " placed"
    feature = _FEATURE.match(low)
    if feature is not None and not VERB.search(low) and (where(low).says or re.search(r"\beyes?\b", low)):
        return feature.start("bare"), "embroider "
    known = {w for name in names for w in Made(name, 1).words}
    bare = _BARE.match(low) if len(low) < _LONG and not VERB.search(low) and not _WORKS.search(low) else None
    if bare is not None and where(low).says:
        words = [one(w) for w in bare["name"].split()]
        if all(w in known or kind_of(w) or w in _SORTS for w in words) and words[-1] not in _SORTS:
            return bare.start("bare"), "sew "
    led = _LED.match(low)
    if led is None or VERB.search(low):
        return None
    words = [one(w) for w in re.findall(r"[^\W\d_]+", led["name"])]
    at = led.end("mark")
    if words[-1] == "eye" and _AT.match(low[at:]):
        return at, " place"
    if led["mark"].strip() != ":" and not _AT.match(low[at:]):
        return None  # "SNOUT - rose"
    if face.motifs(led["name"]) or words == ["face"]:
        return at, " embroider"
    part = any(w in known or kind_of(w) for w in words)
    return (at, " sew") if part and _AT.match(low[at:]) else None


def spoken(text: str, names: list[str]) -> str:
    """The sentence with its verb."""
    found = verb_of(text, names)
    return text if found is None else text[: found[0]] + found[1] + text[found[0] :]
