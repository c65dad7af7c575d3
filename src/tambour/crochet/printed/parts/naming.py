"""Printed patterns, naming: which part words mean, and the heading that a part stands under, notes between or not."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Sequence
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.places.names import kind_of, one
from tambour.crochet.printed.sheet.notes import Heading, plain_name
from tambour.crochet.words.numbers import NUMBER, number

_SMALL: Final = frozenset(
    (
        "the",
        "a",
        "of",
        "for",
        "as",
        "given",
        "first",
        "1st",
        "one",
        "piece",
        "pattern",
        "instructions",
        "la",
        "le",
        "les",
        "der",
        "die",
        "het",
        "el",
    )
)


def named(names: list[str], words: str) -> int | None:
    """Which of the parts ``words`` mean ("head", "the first leg"): -1 the one under way, None where none is meant."""
    want = [_one(w) for w in words.lower().split() if w not in _SMALL]
    if not want:
        return -1
    said = set(words.lower().split())
    best: tuple[int, int, int] | None = None
    for at, called in enumerate(names):
        name = [_one(w) for w in called.lower().replace("_", " ").split()]
        common = len(set(want) & set(name))
        if common and (common == len(set(want)) or common == len(set(name))):
            ordered = len(
                said & set(called.lower().replace("_", " ").split()) & _SMALL
            )  # "First Leg" is not the second
            rank = (common * 4 - abs(len(name) - common) + 2 * ordered, ordered, at)
            best = rank if best is None else max(best, rank)
    return best[2] if best is not None else None


def over(above: Heading | None, below: Heading) -> str:
    """What a heading names that another follows before any round: "Version 2" over "MUZZLE", "GOLD DOLL" over "head"; "" where the first may
    be a part itself, or the second none."""

    def part(name: str) -> bool:
        return any(kind_of(one(w)) for w in re.findall(r"[^\W\d_]+", name.lower()))

    return above.name if above is not None and not part(above.name) and part(below.name) else ""


def family(above: Heading | None, below: Heading) -> str:
    """What a heading names that stands right over that of the first of its like: "FRONT LEGS" over "First leg"; "" where it names no such."""
    if above is None:
        return ""
    kinds = [{kind_of(one(w)) for w in re.findall(r"[^\W\d_]+", h.name.lower())} - {""} for h in (above, below)]
    ranked = any(w in _RANKED for w in below.name.lower().split())
    return above.name if ranked and len(kinds[0]) == 1 and kinds[0] == kinds[1] else ""


_RANKED: Final = frozenset("first 1st one second 2nd left right".split())


def version(parts: Sequence[tuple[str, str]], name: str, words: str) -> int | None:
    """Which of the parts, each its name and what stands over it, "as given for Version 1" means in the part ``name``: the one of that name
    there, or the only one; None where none is meant."""
    want = _said(words)
    if not want:
        return None
    there = [k for k, (_, above) in enumerate(parts) if above and want <= _said(above)]
    same = [k for k in there if _plain(parts[k][0]) == _plain(name)]
    return same[-1] if same else there[0] if len(there) == 1 else None


def figured(parts: Sequence[tuple[str, str]], words: str) -> int | None:
    """Which of the parts, each its name and what stands over it, "as for boy's legs" means where "BOY" stands over several; None where nothing
    that stands over parts is named."""
    want = _said(words)
    own = [k for k, (_, above) in enumerate(parts) if (mine := _said(above)) and mine < want]
    if not own:
        return None
    rest = " ".join(w for w in words.lower().split() if _one(w) not in _said(parts[own[0]][1]))
    meant = named([re.sub(r"_\d+$", "", parts[k][0]) for k in own], rest)
    return None if meant is None or meant < 0 else own[meant]


def _said(words: str) -> set[str]:
    return {_one(w) for w in words.lower().replace("_", " ").split()} - _SMALL


def _plain(name: str) -> list[str]:
    """The words of a part's name, without the number that tells it from others of that name."""
    return sorted(_one(w) for w in re.sub(r"_\d+$", "", name).lower().replace("_", " ").split())


def _one(word: str) -> str:
    """A word as its singular, roughly, without accents, which capitals leave out: "comme la tête" of TETE."""
    if not word.isascii():
        word = "".join(c for c in unicodedata.normalize("NFD", word) if not unicodedata.combining(c))
    return word[:-1] if word.endswith("s") and len(word) > 3 else word


def nameless_is(names: list[str], sentences: list[str]) -> tuple[str, int]:
    """What the first part is that no heading names, and how often it is made: limbs that sentences sew on and that are no
    other part, where the others are a toy; else its body."""
    if not names:
        return "piece", 1
    kinds = {kind_of(_one(w)) for name in names for w in re.findall(r"[^\W\d_]+", name.lower())}
    if kinds & {"head", "body"}:
        for sentence in sentences:
            for limb in re.finditer(
                r"\b(?:sew|attach|place|position|pin)\s+(?:the\s+)?(?:(?:front|back|hind)\s+)?(legs|arms|wings)\b",
                sentence.lower(),
            ):
                if kind_of(_one(limb[1])) not in kinds:
                    both = re.search(r"\bfront\b.*\b(?:back|hind|rear)\b", " ".join(sentences).lower(), re.DOTALL)
                    return limb[1].capitalize(), 4 if limb[1] == "legs" and both else 2
        if "head" not in kinds and _HEAD_SEWN.search(" ".join(sentences).lower()):
            return "Head", 1
    return ("piece" if "body" in {name.lower() for name in names} else "Body"), 1


_HEAD_SEWN: Final = re.compile(r"\b(?:sew|attach|join)\s+(?:the\s+)?head\s+(?:on)?to\b|\bto (?:the )?head\b")
_FAR: Final = 900
"""Characters above a part's first round in which its heading may stand."""
_TITLE: Final = re.compile(
    r"(?:^|(?<=[.!?]\s)|(?<=[.!?]\s\s))[#*•\s]*"
    r"(?P<name>[A-ZÀ-Þa-z][\w'’&/-]*(?:[ \t][\w'’&/-]+){0,4}?)[ \t]*"
    r"(?P<make>[(\[](?:make|work)\b[^)\]\n]{0,80}[)\]])?[ \t]*"
    r"(?P<end>[:.]?[*\s]*$|(?=[(\[](?:[Mm]ake|MAKE|[Ss]ee|Beg|beg|[Ww]ork|[A-Z]{3}))|[:.]?[ \t]+(?=See\b|With\b|Begin|Beg\b))",
    re.MULTILINE,
)
_SAID: Final = (
    "note notes row rows rnd rnds round rounds instructions begin beg beginning shape divide join joining joined end "
    "continue cont work working fasten stuff sew attach make with using see diagram gauge special abbreviation "
    "abbreviations finishing assembly repeat place change color colour materials size measurements turn insert next "
    "step skip stitch hook yarn thread embroider safety video here and or if now"
)
_NO_PART: Final = frozenset(_SAID.split())
"""Words that no heading of a part has."""


def heading_above(text: str, low: int, high: int) -> Heading | None:
    """The heading that the work at ``high`` stands under, at or behind ``low``, though notes or a ring stand between.

    A line of a few words that name a part, or capitals at the beginning of a sentence ("FACE See diagram on page 4.");
    the last before ``high``.
    """
    low = max(low, high - _FAR)
    begun = list(re.finditer(r"^(?:INSTRUCTIONS|DIRECTIONS|PATTERN)\b.*$", text[low:high], re.MULTILINE))
    low += begun[-1].end() if begun else 0
    capitals = bool(low)
    title = len(text) - len(text.lstrip())
    low = max(low, text.find("\n", title) % (len(text) + 1))
    for found in reversed(list(_TITLE.finditer(text[low:high]))):
        words = [one(w) for w in re.findall(r"[^\W\d_]+", found["name"].lower())]
        if not words or words[0] == "by" or set(words) & _NO_PART or not any(len(w) > 2 for w in words):
            continue
        kinds = [kind_of(w) for w in words]
        starts = not text[text.rfind("\n", 0, low + found.start("name")) + 1 : low + found.start("name")].strip(
            "#*• \t"
        )
        if not ((capitals and found["name"].isupper()) or (kinds[-1] and starts)):
            continue
        name = plain_name(found["name"])
        if name:
            at = low + found.start("name")
            return Heading(name, Span(at, at + len(found["name"])), _made(found["make"]), None, True, True)
    return None


_PUTS: Final = re.compile(
    r"\b(?:sew|sewn|attach\w*|join\w*|embroider\w*|place|stuff\w*|fasten|pin|glue|insert|between|leav\w*|cut|long|thread|end|tie off)\b",
    re.IGNORECASE,
)
_NEARER: Final = 1  # lines above a first round
_MANY: Final = 8  # copies that a sentence says by the way


def spoken_of(text: str, low: int, high: int) -> Heading | None:
    """The heading that a sentence right above the work at ``high`` is, since it names one kind of part: "And what would a cat be without paws?",
    "Four little paws come next"."""
    begin = text.rfind("\n", 0, high) + 1
    lines = [m for m in re.finditer(r"[^\n]+", text[low:begin]) if m[0].strip()][-_NEARER:]
    for line in reversed(lines):
        words = [w for w in re.finditer(r"[^\W\d_]+", line[0]) if kind_of(one(w[0].lower()))]
        if len({one(w[0].lower()) for w in words}) != 1 or _PUTS.search(line[0]):
            continue
        said = {number(w) for w in re.findall(rf"\b({NUMBER})\b", line[0].lower())}
        many = said.pop() if len(said) == 1 else 1
        noun, at = words[0][0], low + line.start()
        plural = one(noun.lower()) != noun.lower()
        span = Span(at + len(line[0]) - len(line[0].lstrip()), at + len(line[0].rstrip()))
        copies = many if plural and 1 < many <= _MANY else 1
        return Heading(noun.capitalize(), span, copies, span if copies > 1 else None, True, True)
    return None


_EACH_SIDE: Final = re.compile(
    r"[\s:]*[(\[]?\s*make\s+(?:1|one)\s+(?:on|for|at)\s+(?:each|either)\s+side", re.IGNORECASE
)
_TWO: Final = frozenset(("ear", "arm", "leg", "eye", "wing", "foot", "fin", "horn", "cheek"))
"""Kinds of parts of which a toy has two."""


def made_of(text: str, heading: Heading) -> tuple[int, bool]:
    """How many of a part its heading asks for, and whether that is a guess: "(Make 1 with B and 1 with C)" are two, and so
    are "EARS" of which nothing is said."""
    end = heading.span.end
    bracket = re.match(r"[\s:]*[(\[]\s*make\b([^)\]\n,;.]*)", text[end : end + 120], re.IGNORECASE)
    if heading.copies <= 1 and _EACH_SIDE.match(text, end):
        return 2, False
    if heading.copies > 1 or heading.copies_span is not None or bracket:
        return max(heading.copies, _made(re.split(r"\bfor\b", bracket[1])[0]) if bracket else 1), False
    last = (re.findall(r"[^\W\d_]+", heading.name.lower()) or [""])[-1]
    two = (
        bool(text[: heading.span.start].strip())  # a title is none
        and kind_of(one(last)) in _TWO
        and one(last) not in ("pant", "trouser")
        and one(last) != last
        and not set(heading.name.lower().split()) & {*_NO_PART, "and", "&"}
    )
    return (2, True) if two else (1, False)


def _made(words: str | None) -> int:
    """How many "(make 2)", "(make 1 with B and 1 with C)", "(make 2, one in each colour)" are."""
    words = re.sub(r"(?i)\b(?:colou?r|yarn|shade|size|page|diagram|chart|figure|no\.?)\s*#?\d+\b", " ", words or "")
    words = re.sub(
        rf"(?i)\b({NUMBER})\s*(?:-|–|to|or)\s*(?:{NUMBER})(?=\s*$|\s+(?:of|in|with|pieces)\b)", r"\1", words
    )  # "make 5 to 7"
    said = re.findall(rf"\b({NUMBER})\b(?!\s*(?:mm|st|sts|rnds?|rounds?)\b)", words.lower())
    numbers = [number(w) for w in said]
    # "make 6: 2 each with A, B and C", "make 3 – 1 per rocket", "make 2, 1 in A, 1 in B": the first is the whole.
    parted = re.search(r"^\D*\w+\s*[:–—-]|\b(?:each|per)\b", words or "")
    alike = re.search(r"^\D*\d+\s+(?:in|with|of)\b", words) is not None  # "make 2 in A and 2 in B" are four
    whole = numbers and (parted or (numbers[0] == sum(numbers[1:]) > 1 and not alike))
    many = numbers[0] if whole else sum(numbers)
    return many if 1 <= many <= 100 else 1
