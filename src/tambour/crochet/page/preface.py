"""Preface: what a designer's text says before its first part: who made it, her lists, her sentences."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Final

from tambour.crochet.language.tree import Pattern
from tambour.crochet.page.cleaned import AD, BULLET, FOOT, LETTER, ORNAMENT, cleaned, heads, plain_of, sentences, titled
from tambour.crochet.words.table import Terms

if TYPE_CHECKING:
    from tambour.crochet.page.hers import Hers

_LISTED: Final = ("materials", "abbreviations", "gauge", "finished size", "special stitches", "yarn", "hook", "eyes")
_MORE: Final = frozenset(
    [
        "supplies",
        "you will need",
        "what you need",
        "tools",
        "tension",
        "size",
        "measurements",
        "finished measurements",
        "stitches used",
        "abbreviation",
        "you'll need",
        "you’ll need",
        "terms",
        "stitch guide",
        "legend",
        "special stitch",
        "notions",
        "skills",
        "how big",
        "safety eyes",
        "material",
    ]
)
_NEEDED: Final = frozenset(
    ("supplies", "you will need", "what you need", "material", "notions", "tools", "you'll need", "you’ll need")
)
_TERMS: Final = frozenset(
    ("stitches used", "stitches", "terms", "legend", "abbreviation", "symbols", "conventions", "key")
)
_SIGN: Final = re.compile(r"\s*[*\[(†‡•+#-]+\s*(?:(?:or|and|to|,)\s*[*\[(†‡•+#-]+\s*)*[\])]?\s*[=:]")
"""A line that says what a sign means: "* or ** = repeat"."""
_POINT: Final = re.compile(r"^\s*[*•–~☐·-]\s*\S")
_WARES_NAMED: Final = frozenset(("other", "others", "also", "stuffing", "filling", "needle", "notions", "tools"))
"""What points of a list of materials begin with, besides yarn, hook and eyes."""
_WARES: Final = re.compile(
    r"\b(?:hooks?|needles?|stuffing|fib(?:er|re)fill|safety eyes|stitch markers?|kapok)\b", re.IGNORECASE
)
"""What lists of materials hold, whatever their heading is."""
_BY: Final = re.compile(
    r"^[ \t#*_]*(?:(?:an? )?(?:amigurumi |crochet )*(?:pattern|design(?:ed)?|written|created|copyright)?[ \t]*(?:and \w+ )?by|designer|author|design(?=:))[: \t]+"
    r"(?P<name>[A-ZÀ-Þ@][^\n,;|©]{1,50}?)[ \t*_.]*(?:[,;|©].*)?$",
    re.IGNORECASE | re.MULTILINE,
)
"""A line near the top that says who made it: "Amigurumi pattern by Marlow & Hook"."""
_TERM: Final = re.compile(
    r"(?:^|[;|,•\n])[ \t]*(?P<said>[\w./()]{1,10})[ \t]*(?:=|:|[-–](?=\s))[ \t]*(?P<meaning>[^;|\n]{2,70}?)[ \t]*"
    r"(?=[;|\n]|,[ \t]*[\w./()]{1,10}[ \t]*=|$)"
)
_SEVERAL: Final = re.compile(
    r"(?P<said>[A-Z]{1,2}(?:(?:, ?| & |,? and )[A-Z]{1,2})+)[ \t]*=[ \t]*(?P<meaning>[^=;|\n]{2,90})"
)
"""Letters that mean yarns, in one: "A, B, C = color A, B, C"."""
_SPECIAL: Final = frozenset(
    ("special stitches", "special stitch", "special abbreviations", "stitch guide", "pattern stitches")
)
_WORD: Final = re.compile(r"[^\W_]+")
BEGUN: Final = ("instructions", "instruction", "directions", "pattern")
_NOTES: Final = ("notes", "note", "pattern notes", "tips")
_MOST_OF: Final = 0.6
"""A line of which a statement is this share says nothing else."""
_BROKEN: Final = 45
"""A line of so many letters may be one that she broke herself, and goes on in the next."""
_WORDS: Final = 5
"""A line of so many words that ends as a sentence does is one, also below a list."""


def before(made: Hers, pattern: Pattern, terms: Terms, lines: list[tuple[int, int, str]]) -> None:
    """Sorts what stands before the parts: who made it, her lists, and her sentences."""
    text = pattern.text.text
    spoken = {key: {s.lower() for s in (terms.word(key), key)} for key in _LISTED}
    known = {*_MORE, *_NEEDED, *_TERMS, *_SPECIAL, *(said for some in spoken.values() for said in some)}
    title = titled(pattern.stated["title"][0]).lower() if "title" in pattern.stated else ""
    wares = {*_WARES_NAMED, *(said for key in ("yarn", "hook", "eyes") for said in spoken[key])}
    lists, long = _lists(lines), 0
    mode, unended = "", False
    end = -1
    for a, b, line in lines:
        headline = False
        plain, gap, end = plain_of(line), "\n" in text[end + 1 : a] if end >= 0 else True, b
        head = _first_of(
            re.split(r"\s*[(\[:]|\s+[-–—]\s", plain)[0].strip().removeprefix("uk ").removeprefix("us "), known
        )
        by = _BY.match(line) if not made.designer and len(line) < 90 else None
        sentence = line.rstrip().endswith((".", "!", "?")) and len(line.split()) >= _WORDS and not BULLET.match(line)
        if titled(plain) == title or not LETTER.search(plain) or AD.match(line) or FOOT.match(line):
            continue
        if by is not None:
            made.designer = " ".join(by["name"].split())
        elif head in wares and head != plain and (mode == "materials" or _POINT.match(line)):
            made.materials.append(
                ORNAMENT.sub("", " ".join(BULLET.sub("", line).split()))
            )  # "Yarn: DK in blue" among them
        elif plain in BEGUN:
            mode = ""
        elif head in _NOTES:
            mode = ""
            made.intro += [cleaned(line, text)] if plain != head else []
        elif head in known or head.rstrip("s") in _MORE:
            headline = True
            made.headlines.add(a)
            mode = "terms" if head in _TERMS or head in spoken["abbreviations"] else "listed"
            mode = "special" if head in _SPECIAL or head in spoken["special stitches"] else mode
            mode = "materials" if head in _NEEDED or head in spoken["materials"] else mode
        elif not mode and a in lists:
            mode = "materials"
        elif mode and gap and heads(words := cleaned(line, text)):
            mode = ""  # "GOOD TO KNOW"
            made.intro.append(words)
        elif (
            mode == "terms"
            and sentence
            and "=" not in line
            and not _SIGN.match(line)
            and not _TERM.search(BULLET.sub("", line))
        ):
            made.intro.append(cleaned(line, text))  # "Mark the first stitch." among them
            continue
        elif mode and (not (gap and sentence) or (mode == "materials" and _stated(pattern, a, b))):
            if mode == "materials":
                made.materials.append(ORNAMENT.sub("", " ".join(BULLET.sub("", line).split())))
        elif not _stated(pattern, a, b):
            mode = ""
            broken = unended and (long >= _BROKEN or line[:1].islower())
            if not gap and made.intro and broken and not BULLET.match(line):
                made.intro[-1] = cleaned(f"{made.intro[-1].rstrip('.')} {line}", text)  # a line that she broke herself
            else:
                made.intro.append(cleaned(line, text))
            unended = not line.rstrip().endswith((".", "!", "?", ":", ")"))
            long = len(line)
        else:  # what else it says than its gauge or size
            spans = [span for key, (_, span) in pattern.stated.items() if key != "title"]
            said = [
                w for w, at in sentences(text, a, b) if not any(s.start < at.end and at.start < s.end for s in spans)
            ]
            made.intro += [" ".join(said)] if said else []
        if mode == "terms":
            plain = line.strip() if _SIGN.match(line) else BULLET.sub("", line)
            words = plain.partition(":")[2] if headline else plain
            made.listed += [" ".join(words.split())] if _WORD.search(words) else []
            several = _SEVERAL.fullmatch(plain.strip())
            made.terms |= (
                {several["said"]: several["meaning"].strip()}
                if several is not None
                else {m["said"]: m["meaning"].strip() for m in _TERM.finditer(re.sub(r"\s{3,}", "; ", plain))}
            )
        elif mode == "special":
            words = line.partition(":")[2] if headline else line
            made.listed += [" ".join(BULLET.sub("", words).split())] if _WORD.search(words) else []


def _first_of(head: str, known: set[str]) -> str:
    """The first of the lists that a heading names together, "GAUGE AND SIZE"; any other heading as it is."""
    pieces = re.split(r"\s*(?:,|&|\+|/|\band\b)\s*", head)
    return pieces[0] if len(pieces) > 1 and all(piece in known for piece in pieces) else head


def left(made: Hers, pattern: Pattern, lines: list[tuple[int, int, str]]) -> list[str]:
    """The sentences before the parts that none of her lists holds, nor what she states."""
    text, printed = pattern.text.text, ("title", "gauge", "size") if made.materials else tuple(pattern.stated)
    stated = [pattern.stated[key][0] for key in printed if key in pattern.stated]
    kept = _run(" | ".join([*made.intro, *made.materials, *made.listed, *stated, made.designer]))
    known = {
        *_MORE,
        *_NEEDED,
        *_TERMS,
        *_NOTES,
        *_SPECIAL,
        "instructions",
        "pattern",
        "directions",
        "abbreviations",
        "materials",
        "gauge",
    }
    found: list[str] = []
    size = pattern.stated["size"][0] if "size" in pattern.stated else ""
    for a, b, line in lines:
        if plain_of(line) in known or a in made.headlines or AD.match(line) or FOOT.match(line) or _BY.match(line):
            continue
        more = [
            words
            for words, _ in sentences(text, a, b)
            if _run(words) not in kept and _run(words.partition(":")[2] or words) not in kept
        ]
        sized = [words for words in more if size and _run(words).startswith(_run(size).rstrip())]
        made.size = sized[0].rstrip(".") if sized else made.size  # "14 cm high and 10 cm across the cap"
        found += [words for words in more if words not in sized]
    return found


def _run(words: str) -> str:
    """Words alone, each between blanks."""
    return f" {' '.join(_WORD.findall(words.lower()))} "


def _lists(lines: list[tuple[int, int, str]]) -> set[int]:
    """Where headings of lists of materials begin, whatever they say: lines above points that name what is needed."""
    found = set()
    for k, (a, _, line) in enumerate(lines):
        points: list[str] = []
        for _, _, other in lines[k + 1 :]:
            if not _POINT.match(other):
                break
            points.append(other)
        if len(points) > 1 and not _POINT.match(line) and sum(bool(_WARES.search(p)) for p in points) > 1:
            found.add(a)
    return found


def _stated(pattern: Pattern, a: int, b: int) -> bool:
    """Whether a line says what is told elsewhere, its gauge, its size, and little else: a sentence that tells more stays."""
    said = [span for key, (_, span) in pattern.stated.items() if key != "title" and a <= span.start < b]
    return any(min(span.end, b) - span.start >= _MOST_OF * (b - a) for span in said)
