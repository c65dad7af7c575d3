"""Hers: what the designer's own text says besides the rounds: its introduction, its notes, its sentences between rounds."""

from __future__ import annotations

import re
from dataclasses import dataclass, field, replace
from html import unescape
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.language.finishes import Eye, Placed
from tambour.crochet.language.tree import Pattern
from tambour.crochet.page.instructions import by_people
from tambour.crochet.page.ordered import Stretch, paragraph, sentences_between, spans_marked, stretches
from tambour.crochet.words.table import TERMS, Terms

_HEAD: Final = re.compile(r"^[\s#*_=|]*(.*?)[\s*_=:|]*$")
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
        "safety eyes",
        "material",
    ]
)
_NEEDED: Final = frozenset(
    ("supplies", "you will need", "what you need", "material", "notions", "tools", "you'll need", "you’ll need")
)
_TERMS: Final = frozenset(("stitches used", "terms", "legend", "abbreviation"))
_ASSEMBLY: Final = frozenset(
    [
        "assembly",
        "finishing",
        "making up",
        "to make up",
        "assembling",
        "putting it together",
        "to finish",
        "sewing",
        "sewing up",
        "finishing touches",
        "details",
        "face",
        "final assembly",
    ]
)
_TOGETHER: Final = re.compile(r"(?:putting|sewing|stitching|piecing|joining)(?: \w+){0,3} (?:together|up)")
"""How an assembly is headed besides: "Putting Pip together"."""
_BULLET: Final = re.compile(r"^[\s#>*•–~☐-]+(?=\S)")
_SIGN: Final = re.compile(r"\s*[*\[(†‡•+#-]+\s*(?:(?:or|and|to|,)\s*[*\[(†‡•+#-]+\s*)*[\])]?\s*[=:]")
"""A line that says what a sign means: "* or ** = repeat"."""
_POINT: Final = re.compile(r"^\s*[*•–~☐·-]\s*\S")
_SIGNS: Final = "\\s~=_|\u2500-\u27bf\ufe0f\U0001f300-\U0001faff"
_ORNAMENT: Final = re.compile(rf"^[{_SIGNS}]+|[{_SIGNS}]+$")
"""What lines are decorated with: rules, hearts, boxes, flowers."""
_FOOT: Final = re.compile(
    r"^(?!.*\b(?:see|refer|diagrams?|charts?)\b)(?!\W*(?:turn|go|as|cut|use|follow)\b).{0,70}(?:\bpage|\bseite|\bpágina|\bpagina|\bp\.)\s*\d+(?:\s*(?:of|/|von|de|sur|van)\s*\d+)?\W*$",
    re.IGNORECASE,
)
"""The foot of a page, amid the text."""
_REST: Final = re.compile(
    r"^\W*(?:you (?:may|might) also (?:like|love|enjoy)|related (?:posts|patterns)|leave a (?:reply|comment)|\d+ (?:comments?|replies|responses))\W*$",
    re.IGNORECASE | re.MULTILINE,
)
"""What follows on a page of the web is other people's."""
_WARES: Final = re.compile(
    r"\b(?:hooks?|needles?|stuffing|fib(?:er|re)fill|safety eyes|stitch markers?|kapok)\b", re.IGNORECASE
)
"""What lists of materials hold, whatever their heading is."""
_STARRED: Final = re.compile(r"(?<!\w)\*(?=\S)([^*]+?)(?<=\S)\*(?!\w)")
"""What stands between asterisks is printed in italics elsewhere."""
_LINK: Final = re.compile(r"\[([^\]\n]+)\]\([^)\s]*\)")
_ESCAPED: Final = re.compile(r"\\([*_\[\]()#>-])")
_AD: Final = re.compile(
    r"^\W*(?:advertisement|sponsored|ad|cookie settings|jump to (?:the )?(?:recipe|pattern)|print (?:the )?pattern"
    r"|(?:photo|image|picture|foto|imagen)\s*\d*:.*|home\b.{0,60}\b(?:contact|shop|about)(?: me| us)?|.*\baffiliate links?\b.*)\W*$",
    re.IGNORECASE,
)
"""A line of a page of the web that is nobody's sentence."""
_SENTENCE: Final = re.compile(r"(?<=[.!?])\s+(?=[A-ZÀ-Þ\"“(])")
_FROM_SIGN: Final = re.compile(r"\s*\*(?=\w)")
_LETTER: Final = re.compile(r"[^\W\d_]{2}")
_BY: Final = re.compile(
    r"^[ \t#*_]*(?:(?:an? )?(?:amigurumi |crochet )*(?:pattern|design(?:ed)?|written|created|copyright)?[ \t]*(?:and \w+ )?by|designer|design(?=:))[: \t]+"
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
_LENGTH: Final = r"\d+(?:[.,]\d+)?\s*-?\s*(?:cm|inch(?:es)?|in\b|[\"”″])"
_TALL: Final = re.compile(
    rf"(?:(?:about|approx\.?|approximately|around|ca\.?|roughly)\s+)?{_LENGTH}(?:\s*[(/]\s*{_LENGTH}\s*\)?)?\s*(?:tall|high|long|in height)\b"
    rf"|(?<=size )(?:(?:about|approx\.?|approximately|is)\s+)*{_LENGTH}(?:\s*[(/]\s*{_LENGTH}\s*\)?)?",
    re.IGNORECASE,
)
"""What a sentence says of the finished toy's size."""
_MORE_OF: Final = re.compile(
    r"(?:they|it|this|these|those|both|each|make sure|be sure|check|use|leave|stuff|add)\b", re.IGNORECASE
)
"""How a sentence begins that says more of the one before it."""
_SPECIAL: Final = frozenset(
    ("special stitches", "special stitch", "special abbreviations", "stitch guide", "pattern stitches")
)
_WORD: Final = re.compile(r"[^\W_]+")
_BEGUN: Final = ("instructions", "instruction", "directions", "pattern")
_NOTES: Final = ("notes", "note", "pattern notes", "tips")
_MOSTLY: Final = 0.8
"""A sentence of which a step says this share is not said twice."""
_MOST_OF: Final = 0.6
"""A line of which a statement is this share says nothing else."""
_BROKEN: Final = 45
"""A line of so many letters may be one that she broke herself, and goes on in the next."""
_TABLE_HEAD: Final = re.compile(r"^\s*\|(?:\s*[^\W\d]+(?:\s[^\W\d]+)?\s*\|){2,}\s*$")
"""The head of a table of rounds: "| Round | Instructions | Stitches |"."""
_WORDS: Final = 5
"""A line of so many words that ends as a sentence does is one, also below a list."""


_OVER: Final = 4
"""A heading over several parts stands within so many lines above the first of them."""
_NAMES: Final = 3
"""So few words without a point head what stands below them."""


@dataclass
class Hers:
    """A designer's sentences. intro : before the parts; closing : after them, but what puts the parts together.

    materials : her list of them, line by line; terms : her abbreviations and what they mean; designer : "" unsaid
    size : what she says of it in a sentence ("about 25 cm (10") tall"), "" for nothing
    starts : where her parts begin, and which; worked : what of her text lines came of; inside : place of a part among the pattern's →
        (sentence, its place); told : places of those that a step of the assembly tells; headed : her headings (part, words, place)
    finishing : all sentences of the assembly, and their places; listed : her lists of abbreviations and stitches, line by line
    beside : of a sentence that puts something somewhere (from, to) → those behind it in its line that say more of it
    ahead : the same → those that stand before it and behind the one before; assembly : where in her text it begins
    """

    intro: list[str] = field(default_factory=list)
    materials: list[str] = field(default_factory=list)
    terms: dict[str, str] = field(default_factory=dict)
    designer: str = ""
    size: str = ""
    inside: dict[int, list[tuple[str, Span]]] = field(default_factory=dict)
    beside: dict[tuple[int, int], list[str]] = field(default_factory=dict)
    ahead: dict[tuple[int, int], list[str]] = field(default_factory=dict)
    closing: list[str] = field(default_factory=list)
    starts: list[tuple[int, int]] = field(default_factory=list)
    worked: list[Stretch] = field(default_factory=list)
    told: set[tuple[int, int]] = field(default_factory=set)
    headed: list[tuple[int, str, Span]] = field(default_factory=list)
    finishing: list[tuple[str, Span]] = field(default_factory=list)
    listed: list[str] = field(default_factory=list)
    assembly: int = 1 << 60

    def part_at(self, at: int) -> int:
        """The part that a place of the text belongs to."""
        return max(((start, k) for start, k in self.starts if start <= at), default=(0, 0))[1]

    @property
    def sentences(self) -> list[str]:
        """All that is set in her words among the rounds and behind them."""
        among = [words for said in self.inside.values() for words, _ in said]
        among += [words for words, _ in self.finishing]
        among += [" ".join(one.words.split()) for one in self.worked if not one.plain]
        steps = [words for said in (*self.beside.values(), *self.ahead.values()) for words in said]
        return [*among, *self.closing, *steps]


def hers(pattern: Pattern, code: str) -> Hers | None:
    """What the text says in its designer's words; None where it is tambour's own or another language is asked for."""
    text = pattern.text.text
    terms = TERMS.get(pattern.terms)
    if terms is None or pattern.terms != code:
        return None
    if not by_people(pattern):
        return None
    made = Hers()
    assembly = {*_ASSEMBLY, terms.word("assembly").lower()}
    lines = [(m.start(), m.end(), m[0]) for m in re.finditer(r"[^\n]+", text)]
    starts = sorted((at.start, k) for k, s in enumerate(pattern.parts) if not s.twin for at in (s.span, *s.also))
    made.starts = starts
    heads = {text.rfind("\n", 0, a) + 1 for a, _ in starts}
    first = starts[0][0] if starts else 0
    last = starts[-1][0] if starts else len(text)
    assembles = [a for a, _, line in lines if _plain(line) in assembly or _TOGETHER.fullmatch(_plain(line))]
    begun = [a for a, _, line in lines if _plain(line.partition(":")[0]) in assembly]  # "Finishing: Sew the ears on."
    after = made.assembly = min((a for a in (*assembles, *begun) if a > last), default=len(text))
    finishing = {_span(record) for record in pattern.finish}
    worked = [r for r in pattern.finish if isinstance(r, Eye) or (isinstance(r, Placed) and r.through)]
    stepped = [record.span for record in pattern.finish if record not in worked]
    above = _headed_above(lines, first) if starts else first
    _before(made, pattern, terms, [one for one in lines if one[0] < above and one[0] not in heads])
    made.size = " ".join(found[0].split()) if (found := _TALL.search(text[:first])) is not None else ""
    waiting: list[str] = []  # what she says before the next step
    covered = [line.span.start for part in pattern.parts for line in part.lines]
    rest = next((m.start() for m in _REST.finditer(text, max(last, max(covered, default=0)))), len(text))
    made.worked = [
        replace(
            one, words="\n".join(line for line in one.words.split("\n") if not (_AD.match(line) or _FOOT.match(line)))
        )
        for one in stretches(pattern, text.rfind("\n", 0, first) + 1, rest)
    ]
    over = (-1, -1)  # the part that a heading stands over with the sentences below it, and where it begins
    named = {at.start: at for s in pattern.parts for at in (s.span, *s.also)}
    for a, b, _ in _whole([one for one in lines if one[0] < rest], text, heads, finishing):
        if (a < above and a not in heads) or any(junk.match(text[a:b]) for junk in (_TABLE_HEAD, _AD, _FOOT)):
            continue
        if a >= after:
            if a != after or a not in assembles:
                pieces = list(sentences_between(text, a, b, made.worked))
                made.finishing += [one for c, d in pieces for one in _sentences(text, c, d)]
                for c, d in pieces:
                    _closing(made, text, c, d, finishing, {(s.start, s.end) for s in stepped}, waiting)
            continue
        for c, d in sentences_between(text, a, b, made.worked):
            for words, span in _sentences(text, c, d):
                part = max(
                    ((start, k) for start, k in starts if start < span.end), default=starts[0] if starts else (0, 0)
                )[1]
                if any(span.start <= at < span.end for at in named):
                    made.headed.append((part, words, span))
                    continue
                if any(_told(span, step) for step in stepped):
                    made.told.add((span.start, span.end))  # a step of the assembly says it
                if words.isupper() and len(words.split()) <= _NAMES:  # "STARFISH" above its first part
                    over = next(((start, k) for start, k in starts if start >= span.end), over)
                    if any(span.end <= one.span.start < over[0] for one in made.worked):
                        over = (-1, -1)
                part = over[1] if span.end <= over[0] else part
                made.inside.setdefault(part, []).append((words, span))
    made.closing += waiting
    made.intro += _left(made, pattern, [one for one in lines if one[0] < above and one[0] not in heads])
    for said in made.inside.values():
        said.sort(key=lambda one: one[1].start)
    return made


def _headed_above(lines: list[tuple[int, int, str]], first: int) -> int:
    """Where the first part's text begins: at a heading in capitals that stands over it and what follows, "DRESS" over its bodice, behind
    that of the instructions."""
    before = [(a, line.strip()) for a, b, line in lines if b < first]
    for a, line in before[:-_OVER:-1]:
        if _plain(line) in _BEGUN:
            break
        if (
            line.isupper()
            and len(line.split()) <= _NAMES
            and any(_plain(one) in _BEGUN for at, one in before if at < a)
        ):
            return a
    return first


def _before(made: Hers, pattern: Pattern, terms: Terms, lines: list[tuple[int, int, str]]) -> None:
    """Sorts what stands before the parts: who made it, her lists, and her sentences."""
    text = pattern.text.text
    spoken = {key: {s.lower() for s in (terms.word(key), key)} for key in _LISTED}
    title = " ".join(pattern.stated["title"][0].split()).lower() if "title" in pattern.stated else ""
    wares = {said for key in ("yarn", "hook", "eyes") for said in spoken[key]}
    lists, long = _lists(lines), 0
    mode, unended = "", False
    end = -1
    for a, b, line in lines:
        headline = False
        plain, gap, end = _plain(line), "\n" in text[end + 1 : a] if end >= 0 else True, b
        head = re.split(r"\s*[(\[:]|\s+[-–—]\s", plain)[0].strip().removeprefix("uk ").removeprefix("us ")
        by = _BY.match(line) if not made.designer and len(line) < 90 else None
        sentence = line.rstrip().endswith((".", "!", "?")) and len(line.split()) >= _WORDS and not _BULLET.match(line)
        if _ORNAMENT.sub("", plain) == title or not _LETTER.search(plain) or _AD.match(line) or _FOOT.match(line):
            continue
        if by is not None:
            made.designer = " ".join(by["name"].split())
        elif mode == "materials" and head in wares and head != plain:
            made.materials.append(
                _ORNAMENT.sub("", " ".join(_BULLET.sub("", line).split()))
            )  # "Yarn: DK in blue" among them
        elif plain in _BEGUN:
            mode = ""
        elif head in _NOTES:
            mode = ""
            made.intro += [cleaned(line, text)] if plain != head else []
        elif head in _MORE or head.rstrip("s") in _MORE or any(head in said for said in spoken.values()):
            headline = True
            mode = "terms" if head in _TERMS or head in spoken["abbreviations"] else "listed"
            mode = "special" if head in _SPECIAL or head in spoken["special stitches"] else mode
            mode = "materials" if head in _NEEDED or head in spoken["materials"] else mode
        elif not mode and a in lists:
            mode = "materials"
        elif mode and (not (gap and sentence) or (mode == "materials" and _stated(pattern, a, b))):
            if mode == "materials":
                made.materials.append(_ORNAMENT.sub("", " ".join(_BULLET.sub("", line).split())))
        elif not _stated(pattern, a, b):
            mode = ""
            broken = unended and (long >= _BROKEN or line[:1].islower())
            if not gap and made.intro and broken and not _BULLET.match(line):
                made.intro[-1] = cleaned(f"{made.intro[-1].rstrip('.')} {line}", text)  # a line that she broke herself
            else:
                made.intro.append(cleaned(line, text))
            unended = not line.rstrip().endswith((".", "!", "?", ":", ")"))
            long = len(line)
        else:  # what else it says than its gauge or size
            spans = [span for key, (_, span) in pattern.stated.items() if key != "title"]
            said = [
                w for w, at in _sentences(text, a, b) if not any(s.start < at.end and at.start < s.end for s in spans)
            ]
            made.intro += [" ".join(said)] if said else []
        if mode == "terms":
            plain = line.strip() if _SIGN.match(line) else _BULLET.sub("", line)
            words = plain.partition(":")[2] if headline else plain
            made.listed += [" ".join(words.split())] if _WORD.search(words) else []
            several = _SEVERAL.fullmatch(plain.strip())
            made.terms |= (
                {several["said"]: several["meaning"].strip()}
                if several is not None
                else {m["said"]: m["meaning"].strip() for m in _TERM.finditer(plain)}
            )
        elif mode == "special":
            words = line.partition(":")[2] if headline else line
            made.listed += [" ".join(_BULLET.sub("", words).split())] if _WORD.search(words) else []


def _left(made: Hers, pattern: Pattern, lines: list[tuple[int, int, str]]) -> list[str]:
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
    for a, b, line in lines:
        if _plain(line) in known or _AD.match(line) or _FOOT.match(line) or _BY.match(line):
            continue
        found += [
            words
            for words, _ in _sentences(text, a, b)
            if _run(words) not in kept and _run(words.partition(":")[2] or words) not in kept
        ]
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


def _told(span: Span, step: Span) -> bool:
    """Whether a sentence is that of a step, nearly to its last letter."""
    return min(span.end, step.end) - max(span.start, step.start) >= _MOSTLY * (span.end - span.start)


_ENDED: Final = (".", "!", "?", ":", ")", "]", "*", "|")


def _whole(
    lines: list[tuple[int, int, str]], text: str, heads: set[int], said: set[tuple[int, int]]
) -> list[tuple[int, int, str]]:
    """Lines with those that only go on with them, where a sentence was broken at the edge of a page; said : places of sentences that
    were read as one, whatever letter their next line begins with."""
    made: list[tuple[int, int, str]] = []
    for a, b, line in lines:
        before = made[-1] if made else None
        next_ = before is not None and text[before[1] : a] == "\n"
        one = before is not None and any(x < before[1] and a < y for x, y in said)
        goes_on = next_ and (line[:1].islower() or one)
        if before is not None and goes_on and not before[2].rstrip().endswith(_ENDED) and before[0] not in heads:
            made[-1] = (before[0], b, text[before[0] : b])
        else:
            made.append((a, b, line))
    return made


def _closing(
    made: Hers,
    text: str,
    a: int,
    b: int,
    finishing: set[tuple[int, int]],
    steps: set[tuple[int, int]],
    waiting: list[str],
) -> None:
    """The sentences of a line of the assembly that no finishing record tells: they go with the one before them in their line, else
    they wait for the next of the ``steps``."""
    before: tuple[int, int] | None = None
    fresh = True  # nothing of this line waits yet
    for words, span in _sentences(text, a, b):
        mine = next((one for one in finishing if one[0] < span.end and span.start < one[1]), None)
        if mine is not None:
            before, fresh = mine, True
            if waiting and mine in steps:
                made.ahead[mine] = [*made.ahead.get(mine, []), *waiting]
                waiting.clear()
        elif before is not None and _MORE_OF.match(words):
            made.beside.setdefault(before, []).append(words)
        elif fresh:
            waiting.append(words)
            fresh = False
        else:
            waiting[-1] += f" {words}"  # a paragraph of hers


def _plain(line: str) -> str:
    found = _HEAD.match(line)
    return found[1].strip().lower() if found else ""


def cleaned(words: str, text: str = "") -> str:
    """A sentence without what lists and Markdown put about it, and with its point; of a ``text`` that marks what is worked again
    with two asterisks they stay."""
    marked = spans_marked(text or words)
    if _FROM_SIGN.match(words) and words.count("*") == 1 and "from *" in paragraph(words, text):
        return f"*{cleaned(words.lstrip()[1:], text)}"  # "*Ch 3. … Rep from * around."
    if words.lstrip().startswith("|"):  # a row of a table
        words = " – ".join(cell.strip() for cell in words.strip().strip("|").split("|") if cell.strip())
    words = _ESCAPED.sub(r"\1", _LINK.sub(r"\1", unescape(words)))
    if marked:
        words = " ".join(re.sub(r"^[\s#>•–~☐-]+(?=\S)", "", words).split())
    else:
        words = _STARRED.sub(r"\1", " ".join(_BULLET.sub("", words).replace("**", "").split()))
    words = _ORNAMENT.sub("", words).rstrip(",;")
    return words if not words or words[-1] in ".!?:)" or words.isupper() or len(words.split()) < _NAMES else f"{words}."


def _sentences(text: str, a: int, b: int) -> list[tuple[str, Span]]:
    """The sentences of a line, with their places; headings and bare counts are none."""
    made = []
    at = a
    for piece in _SENTENCE.split(text[a:b]):
        begin = text.index(piece, at)
        at = begin + len(piece)
        words = cleaned(piece, text)
        if _LETTER.search(words):
            made.append((words, Span(begin, at)))
    return made


def _stated(pattern: Pattern, a: int, b: int) -> bool:
    """Whether a line says what is told elsewhere, its gauge, its size, and little else: a sentence that tells more stays."""
    said = [span for key, (_, span) in pattern.stated.items() if key != "title" and a <= span.start < b]
    return any(min(span.end, b) - span.start >= _MOST_OF * (b - a) for span in said)


def _span(record: object) -> tuple[int, int]:
    span = getattr(record, "span", Span(0, 0))
    return span.start, span.end
