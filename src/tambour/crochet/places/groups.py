"""Groups: a sentence that puts several groups of copies, each somewhere else, as one clause for each; and what is handled, or done again, before it is sewn."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Final

from tambour.crochet.places.assembling import AGAIN
from tambour.crochet.places.habits import ROUND
from tambour.crochet.places.names import SIDED, Made, Mention, mentions
from tambour.crochet.places.ranked import ranked
from tambour.crochet.places.said import VERB
from tambour.crochet.words.numbers import QUANTITY, quantity

_PLACE: Final = (
    r"(?:(?:spread |placed |spaced |set |arranged )?evenly|spread|scattered|in (?:the|a|front)|(?:right |just |directly )?(?:on|at|to|onto|over|between|"
    r"around|down|along|below|above|under|behind|near|across|up))\b"
)
_GROUP: Final = re.compile(
    r"\s*(?:(?:and|then|with|place|put|sew|scatter|spread|arrange)\s+)*(?:the\s+)?(?:(?P<rest>rest|others|remaining ones|remainder|other ones)(?:\s+of\s+(?:them|the\s+\w+))?"
    rf"|(?:(?:last|other|first|remaining|next|final)\s+)*(?P<many>{QUANTITY})\b(?:\s+(?:last|other|more|remaining|of\s+(?:them|these|the)))*)"
    rf"(?P<noun>(?:\s+(?!(?:on|at|to|in|of)\b)[a-z]+){{0,3}}?)\s+(?P<place>{_PLACE}.*)$"
)
"""So many of a part, and where: "the three big spikes down the back of the body"."""
_CUT: Final = re.compile(r"\s*(?:[,;]\s*(?:and\s+|then\s+)*|\s+and\s+(?:then\s+)?)")
_NO_CUT: Final = re.compile(r"\b(?:between|rounds?|rnds?|rds?|rows?|r|and)\s*\.?\s*\d+$")
"""Before an "and" that joins two rounds."""
_COUNTS: Final = re.compile(r"\s*(?:st|sc|rnd|round|row|cm|mm|inch|time|side|stitch|loop|space|strand)")
"""What is counted that is no part."""
_LINE: Final = re.compile(
    r"\bin (?:a )?(?:straight |vertical )?(?:row|line)(?: (?:down|along|up) (?:the )?(?:\w+ )?(?:middle|cent(?:er|re)))?"
)
_ON_TRUNK: Final = re.compile(
    r"^(?:\w+\s+)?(?:on|at|to|onto|over|down|along)\s+(?:the|its|his|her)\s+(?:back|belly|tummy|chest|hips?|waist)\b"
)
"""A place that is one of the body, where a head is another part."""
_LEAST: Final = 2
HANDLED: Final = re.compile(
    r"^\W*(?:the\s+|both\s+)*(?:[a-z]+\s+){0,2}?[a-z]+\s*(?:[:–—→]|\s-)\s*(?=(?:do not|don'?t|no|un|lightly|firmly|stuff|fold|flatten|gather|press|pinch|"
    r"squash|squeeze|fill|close|leave|pin|weight|shape|bend|not)\b)"
)
"""What is done with a part that stands before a mark, ere it is sewn: "Wings: flatten, sew to the sides"."""
BEFORE: Final = re.compile(
    r"\bbefore\s+(?:you\s+)?(?:sew|attach|stitch|pin)(?:ing)?\s+(?:them|it|these)\b(?=\s+(?:to|on|onto|at|over|between))"
)
"""What is sewn after it was handled: "Press the wings flat before sewing them to the sides"."""
ALIKE: Final = re.compile(
    r"\b(?:in|by|using) (?:exactly )?(?:the|a) (?:same|similar) (?:way|manner|method)\b|\blikewise\b|\bsimilarly\b"
)
BY_IT: Final = re.compile(r"\b(beside|next to|behind|close to|below|above|under) (?:it|this)\b")
ONE_OTHER: Final = re.compile(
    r"\bone ((?:\w+ ){0,2}?\w+?)s? ((?:at|on|in|between|over|to|near|above|below)\b[^,;:.]*?),? (?:and )?the other (?:one )?([^,;:.]*)"
)
"""Two of a kind, each with a place of its own: "one big spot at the top, the other between R7 and R11"."""
BOTH: Final = re.compile(r"\bboth\b[^,;:.]*")
"""What is said of the two of them behind their places: "both pointing up"."""
_BARE: Final = re.compile(
    rf"\b(?:nose|mouth|smile)\s+(?:(?:is|goes|about|approx\.?)\s+)*{QUANTITY}\s+{ROUND}\s+(?:below|under|beneath|down)(?=\s*(?:[.,;]|$|and\b|using\b|with\b))"
)
"""A place below nothing that is named: "locate the nose 1 rnd below and embroider it"."""
_EYES: Final = re.compile(r"\beyes\b")


def paired(mention: Mention, sides: bool) -> Mention:
    """Of several parts that one word names, on both sides of something those that are made twice: "The windows left and right of the door" are
    no attic window."""
    twice = tuple(c for c in mention.copies if c[0].copies == 2)
    single = any(c[0].copies == 1 for c in mention.copies)
    return replace(mention, copies=twice) if sides and twice and single else mention


def below_eyes(low: str, put: list[str]) -> str:
    """A nose so many rounds "below" is that far below the eyes that were spoken of just before it. put : what was drawn so far."""
    found = _BARE.search(low)
    if found is None or not (_EYES.search(low[: found.start()]) or _EYES.search(put[-1] if put else "")):
        return low
    return f"{low[: found.end()]} the eyes{low[found.end() :]}"


def grouped(low: str, parts: list[Made]) -> str:
    """A sentence (in small letters) with a verb and what it puts for each of its groups; as it is, where it has not two.

    "Sew the 5 spots on the cap: one at the very top and four between rounds 6 and 9"
    """
    if (each := ranked(low, parts)) != low:
        return each
    verb = VERB.search(low)
    if verb is None or not any(p.copies > 1 for p in parts):
        return low
    begin = _first(low, verb.end())
    if begin is None:
        return low
    pieces = _pieces(low[begin:].rstrip(" ."))
    found = [_GROUP.match(piece) for piece in pieces]
    groups = [m for m in found if m is not None]
    if len(groups) < _LEAST or len(groups) < len(pieces):
        return low
    led = mentions(low[:begin], parts)
    lead = led[0] if led else None
    host = next((m for m in led[1:] if m.copies[0][0].single), None)
    row = _LINE.search(low[:begin])
    led_to = host
    trunk = any(p.single and p.kind == "body" for p in parts)
    said: list[tuple[Made, int | None, str]] = []
    for m in groups:
        own = _meant(m["noun"], lead, parts)
        if own is None or (m["many"] and _COUNTS.match(m["noun"])):
            return low
        place = m["place"]
        if not mentions(place, [p for p in parts if p != own]):
            # "one on the head and two on the back": of the body, and not of that head
            before = host is not None and host is not led_to and host.copies[0][0].kind == "head"
            on = "body" if before and trunk and _ON_TRUNK.search(place) else host.word if host is not None else ""
            place += f" on the {on}" if on else ""
        else:
            host = next((h for h in mentions(place, [p for p in parts if p != own]) if h.copies[0][0].single), host)
        said.append((own, None if m["rest"] else int(quantity(m["many"])), place + (f", {row[0]}" if row else "")))
        lead = lead or next(iter(mentions(own.name.lower(), [own])), None)
    if any(sum(n or 0 for q, n, _ in said if q == p) > p.copies for p, _, _ in said):
        return low
    lines: list[str] = []
    for part, many, place in said:
        if many is None:
            many = part.copies - sum(n or 0 for p, n, _ in said if p == part)
        if many < 1 or part.copies < _LEAST:
            return low
        lines.append(f"sew {many} {part.name.lower().replace('_', ' ')} {place}")
    return ", and ".join(lines)


def _first(low: str, at: int) -> int | None:
    """Where the first group begins: straight behind the verb, or behind the first mark."""
    marks = [at + m.end() for m in re.finditer(r":|[–—]|\s-(?=\s)", low[at:])]
    begins = [*marks, at, *(at + m.end() for m in re.finditer(r"[;,]", low[at:]))]
    return next((k for k in begins if _GROUP.match(low[k:])), None)


def _pieces(text: str) -> list[str]:
    """The groups of a list, cut where the next begins with a number and a place follows it."""
    cuts = [0]
    for m in _CUT.finditer(text):
        if not _NO_CUT.search(text[: m.start()]) and _GROUP.match(text[m.end() :]):
            cuts.append(m.start())
    return [
        _CUT.sub("", text[a:b], count=1) if _CUT.match(text[a:b]) else text[a:b]
        for a, b in zip(cuts, [*cuts[1:], len(text)])
    ]


def _meant(noun: str, lead: Mention | None, parts: list[Made]) -> Made | None:
    """The part of a group: the one that it names, else with "small ones" the one of that sort, else the one that the sentence is about."""
    noun = re.sub(r"\bones?\b", lead.word if lead is not None else "", noun).strip()
    named = mentions(noun, parts)
    if named and len({p for p, _ in named[0].copies}) == 1:
        return named[0].copies[0][0]
    every = [] if lead is None else list(dict.fromkeys(p for p, _ in lead.copies))
    if noun and every:
        every = [p for p in every if set(noun.split()) & set(p.words) - {lead.word if lead else ""}]
    return every[0] if len(every) == 1 else None


def again(low: str, onto: str, sides: bool) -> str:
    """What is done once more for another part, said in full. onto : what the part before it was sewn to; sides : to its sides."""
    found = AGAIN.match(low)
    if found is None:
        return low
    side = "sides of the " if sides else ""
    return f"sew the {found['what']} to the {side}{onto.lower().replace('_', ' ')} {found['rest']}"


def apart(copies: list[tuple[Made, int]]) -> list[list[tuple[Made, int]]]:
    """Copies by what they are: every part for itself, but the left and the right one of a pair together."""
    groups: dict[str, list[tuple[Made, int]]] = {}
    for part, k in copies:
        sided = part.copies == 1 and SIDED & set(part.words)
        key = " ".join(w for w in part.words if w not in SIDED) if sided else part.name
        groups.setdefault(key, []).append((part, k))
    return list(groups.values())


def of_each(mention: Mention, copies: list[tuple[Made, int]]) -> tuple[Made, int]:
    """What is meant by a part that is named as a place: its first copy, or each (0) where as many are sewn to them."""
    part, k = mention.copies[0]
    own = [c for c in copies if c[0] == copies[0][0]]
    return (part, 0) if len(mention.copies) > 1 and len(own) % part.copies == 0 else (part, k)
