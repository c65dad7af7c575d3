"""Printed patterns, wools: yarns called by names that are words for other things, or for nothing, known by what is done with them: "With Vanilla,
ch 10.", "Change to Pumpkin."."""

from __future__ import annotations

import re
from typing import Final

from tambour.core.rgb import RGB
from tambour.crochet.places.names import kind_of, one
from tambour.crochet.printed.tokens import rows
from tambour.crochet.printed.wordings.vocabulary import Vocabulary
from tambour.crochet.printed.yarns.colors import Palette, spare
from tambour.crochet.printed.yarns.shades import dyed, shade

_NAME: Final = r"([A-Z][^\W\d_]{2,}(?: [A-Z][^\W\d_]{2,}){0,2}|[a-z][^\W\d_]{2,})"
_FOUND: Final = r"(?:ch(?:ain)?\b|make|form|begin|start|cast|\d+ sc\b|sc\b|work (?:a|the|\d))"
_STARTS: Final = re.compile(
    rf"(?:^|[.;:!?(]\s+|,\s*|\b(?:and|then|now)\s+)[*•-]?\s*(?:[Ww]ith|[Uu]sing|[Ii]n|(?:[Ss]tart|[Bb]egin|[Ww]ork)(?:ing)? (?:with|in)) (?:the )?{_NAME}(?: yarn)?(?:,\s*(?:and )?|\. |:\s*|\s+(?:and )?)"
    rf"(?={_FOUND})",
    re.MULTILINE,
)
"""A yarn that a piece is begun with."""
_CHANGES: Final = re.compile(
    rf"\b(?i:(?:change|switch|swap)(?: yarns?| colou?rs?| back)? (?:to|into)|(?:continue|carry on|go on|keep going)(?: on)? (?:with|in|using)) (?:the )?{_NAME}(?: yarn)?(?= ?[.,;:)]| ?$| and| for| now)",
    re.MULTILINE,
)
"""A yarn that work goes on in."""
_BEHIND: Final = re.compile(
    rf"\b(?i:ch|chain) \d+ (?:in|with|using) (?:the )?{_NAME}(?: yarn)?(?= ?[.,;:)]| ?$)", re.MULTILINE
)
_LISTED: Final = re.compile(
    r"^[\s•*✔️☐–-]*([A-Z][^\W\d_]+(?: [A-Z]?[^\W\d_]+){0,2})(?: \(([^()\n]{3,20})\))?\s*[,:–-]?\s*(?:approx\w*\.? )?(?:\d+\s?(?:g|balls?|skeins?|oz|yds?|yards?|m|hanks?)\b|(?:a )?(?:small|tiny) amounts?|scraps?|a (?:little|bit))",
    re.MULTILINE,
)
"""A yarn of a list of materials, with how much of it is wanted."""
_LETTERED: Final = re.compile(
    r"(?<![^\W_])(?P<name>(?:[A-Za-z][a-z]+ ){0,2}[A-Za-z][a-z]+) \((?P<letter>[A-Z])\)(?=[^\n]{0,24}?(?:\d ?(?:g|balls?|skeins?|oz|yds?|yards?|m|hanks?)\b|small amount|scrap|a (?:little|bit)))"
)
"""A yarn of a list, with its letter and how much of it is wanted: "Black (B) 80 g   White (W) 30 g"."""
_INITIALS: Final = re.compile(
    r"^[ \t•*-]*(?P<name>(?:[A-Za-z][a-z]+ ){0,2}[A-Za-z][a-z]+)(?: yarn)? \((?P<letter>[A-Z])\)[ \t]*(?:,|$)",
    re.MULTILINE,
)
"""A yarn of a list, with the letter that it begins with and no more: "White (W)"."""
_EQUALS: Final = re.compile(
    r"^[ \t•▪*-]*(?P<letter>[A-Z]{1,2})(?: ?[=:–-] ?|[ \t]+)(?:(?:main|contrast\w*) colou?r,? )?(?P<name>(?:[A-Za-z][a-z]+ ){0,2}[A-Za-z][a-z]+)[ \t]*(?=[(,\d]|scraps?\b|small amount|$)",
    re.MULTILINE,
)
"""A letter and the yarn that it stands for, in a line of a list: "O = orange (50 g)", "MC   main color, oatmeal (rabbit)   70 g", "A blue"."""
_PURPOSES: Final = re.compile(
    r"\b(?i:(?:change|switch|swap)(?: (?:the )?(?:thread|yarn|colou?r))?(?: back)?(?: to)?|(?:start|begin|continue|carry on|go on|work)(?:ing)? (?:with|in)|with|using|use|attach|join)"
    r" (?:the )?([a-z][^\W\d_]{2,}) colou?r(?:ed yarn| yarn)?(?= ?[.,;:)(]| ?$| and\b| for\b| now\b| \d)",
    re.MULTILINE,
)
"""A yarn that is called by what is made of it: "Change to dress color"."""
_OWNERS: Final = re.compile(
    r"\b(?i:change|switch|changing|switching) (?:the )?(?:(?:thread|yarn|colou?r) )?to the (?:colou?r|yarn) of the ([a-z][^\W\d_]{2,})\b"
)
"""And so behind it: "Change the thread to the color of the jacket"."""
_ALONE: Final = re.compile(r"^[ \t]*([A-Z][a-z]{2,}) colou?r[.:]?[ \t]*$", re.MULTILINE)
"""On a line of its own: "Hoof color."."""
_NO_NAME: Final = frozenset(
    """round rnd row right left wrong side yarn color colour main contrast cotton wool acrylic chenille worsted stuffing fiberfill felt floss
    thread hook needle eyes spiral rounds rows magic same other both two double one each all your this that these those another next last
    remaining back front loop loops long short small large embroidery pattern order tail end ends new first second third fourth desired chosen
    preferred any original previous current darker lighter dark light bright contrasting matching different choice opposite established correct assorted solid multi variegated""".split()
)


def learned(text: str, palette: Palette, vocabulary: Vocabulary) -> None:
    """Teaches ``palette`` the yarns that a text begins or goes on with, by the colour that their names or its list tell; those that nothing
    tells get one of our choice."""
    lettered = (m for said in (_LETTERED, _INITIALS, _EQUALS) for m in said.finditer(text))
    for m in lettered:
        letter, words = m["letter"].lower(), m["name"].split()
        if m.re is _INITIALS and not any(w[0].lower() == letter for w in words):
            continue
        hue = next((hue for k in range(len(words)) if (hue := _color(" ".join(words[k:]), "")) is not None), None)
        if hue is not None:
            palette.given.setdefault(letter, hue)
            palette.named.setdefault(letter, m["name"])
    shelf = {m[1].lower(): (m[1], m[2] or "") for m in _LISTED.finditer(text)}
    found = [m for pattern in (_STARTS, _CHANGES, _BEHIND) for m in pattern.finditer(text)]
    names = [m[1] for m in sorted(found, key=lambda m: m.start())]
    parts = {name.lower() for name in names if kind_of(one(name.split()[-1].lower()))}
    for name in dict.fromkeys(names):
        low = name.lower()
        plain = low in shelf or name[0].isupper() or dyed(name) is not None
        if plain and (low not in parts or low in shelf):
            _learn(name, shelf.get(low, ("", ""))[1], palette, vocabulary)
    for purpose in dict.fromkeys(m[1] for said in (_PURPOSES, _OWNERS, _ALONE) for m in said.finditer(text)):
        _learn(purpose, "", palette, vocabulary)
    small = text.lower()
    for low, (name, also) in shelf.items():
        if _color(name, also) is not None and re.search(
            rf"(?:[(,–-] ?(?:in )?|\b(?:in|with|using|to|join|attach|add|pick up) ){re.escape(low)}\b", small
        ):
            _learn(name, also, palette, vocabulary)


def _learn(name: str, also: str, palette: Palette, vocabulary: Vocabulary) -> None:
    low = name.lower()
    known = vocabulary.read(rows(low)[0].tokens)
    if palette.name(low) is not None or set(low.split()) & _NO_NAME or any(t.kind != "word" for t in known):
        return
    hue = _color(name, also)
    if hue is None:
        hue = spare(len(palette.told))
        palette.told.append(low)
    palette.given[low] = hue


def _color(name: str, also: str) -> RGB | None:
    """The colour that a name tells, or the word in brackets behind it in a list: "Pumpkin (orange)"."""
    return shade(name) or shade(also) or dyed(name)
