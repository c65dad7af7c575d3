"""Topic: the part that a paragraph of the assembly is about ("Tail: …", "First the belly."), put into those of its sentences that leave it out."""

from __future__ import annotations

import re
from functools import lru_cache
from typing import Final

from tambour.crochet.places import face, lines
from tambour.crochet.places.curt import fuller
from tambour.crochet.places.habits import ROUND, SCATTERED
from tambour.crochet.places.hosts import LIMBS
from tambour.crochet.places.names import Made, kind_of, mentions, one
from tambour.crochet.places.said import VERB, where
from tambour.crochet.words.numbers import QUANTITY

_POINT: Final = r"[\s*•·–—-]*(?:(?:step\s+)?(?:\d{1,2}|[a-z])\s*[.):]\s*)?"
_NAME: Final = r"(?:the\s+|both\s+|two\s+)?((?:[^\W\d_]+[ -]+){0,2}[^\W\d_]+)"
_LABEL: Final = re.compile(rf"{_POINT}{_NAME}\s*(?::|\s[–—-])\s", re.IGNORECASE)
"""What a paragraph begins with: "3) Side fins: …"."""
_NUMBERED: Final = re.compile(rf"[\s*•·]*(?:step\s+)?\d{{1,2}}\s*[.):]\s*{_NAME}\s*\.\s+(?=[A-Z])", re.IGNORECASE)
"""The same behind a number, with a full stop: "3. FINS. Sew one to each side"."""
_JOINT: Final = re.compile(rf"{_POINT}{_NAME}\s+(?P<how>to|onto|on|and)\s+{_NAME}\s*:\s", re.IGNORECASE)
"""A paragraph about two parts that are sewn to each other: "Head to body: …"."""
_JOINING: Final = re.compile(
    rf"{_POINT}(?:joining|attaching|sewing|assembling)\s+{_NAME}\s+(?P<how>to|onto|on|and)\s+{_NAME}\s*:?\s*(?=\n|$)",
    re.IGNORECASE,
)
"""A heading over how two parts are sewn to each other: "JOINING CAP AND GILLS"."""
_THROUGH: Final = re.compile(r"\b(?:through|into)\s+both\s+(?:the\s+)?(?:edges|layers|pieces|rims|parts|loops)\b")
_SET: Final = re.compile(
    r"^\W*(?:then\s+|now\s+|next\s+)?(?:sit|lay|lean|rest|stand|drop|lower)\s+(the\s+\w+)\s+(?=(?:on|onto|over|against|into)\s+the\s+(?!table|floor|ground|desk|lap|shelf|counter)\w)"
)
"""What is set on another part before it is sewn: "Sit the cap on the walls so that their edges meet"."""
_SO: Final = re.compile(r",?\s+so that\b[^.;]*")
_FACING: Final = re.compile(
    r",?\s*\b(?:when|with|while|as)\s+the\s+\w+\s+(?:is\s+|are\s+)?(?:facing|towards|looks? at|faces)\s+you\b"
)
_IT: Final = re.compile(
    r"\b(sew|stitch|pin|attach|place|glue|whip ?stitch)\s+(?:it\b|them\b|one(?=\s+(?:to|on|at)\s+(?:each|either|both)\b)|all\s+(?:three|four|five|six|of\s+them)\b)"
)
_OVER_IT: Final = re.compile(r"\b(on|onto|over|across|along|down)\s+it\b")
"""What a part is drawn on that its paragraph is about: "sew three long stitches lengthwise over it"."""
_JOINS: Final = re.compile(
    r"\b(?:openings?|edges?|match|sew|whip ?stitch|\d+\s+(?:sts|stitches)\s+(?:on|to|with)\s+\d+|stitch(?:es)? (?:to|by)|join|seam|attach|pin)\b"
)
_OPENED: Final = re.compile(
    rf"(?:^|[.!?:]\s+)(?:now|next|then|finally|first(?: of all)?|last(?:ly)?|(?:let's |we )?(?:start|begin|continue|go on|finish) with)\s*,?\s+(?:for\s+)?{_NAME}\s*(?=[.,:!])|(?:^|[.!?:]\s+){_NAME}\s+(?:come(?:s)?\s+)?(?:first|next|last|now|then)\s*[.,!]",
    re.IGNORECASE | re.MULTILINE,
)
"""A sentence that says no more than what comes now: "First the belly."."""
_TAKEN_UP: Final = re.compile(
    rf"(?:^|[.!?]\s+)(?:(?:now|next|then|finally|first|last)\s*,?\s+)?(?:pin|sew|attach|put|place|stitch)\s+{_NAME}\s+(?:on|down|in place)(?:\s+(?:first|next|now|last|then))?\s*[.!]",
    re.IGNORECASE | re.MULTILINE,
)
"""A sentence that says of a part no more than that it is sewn on now: "Pin the tummy on first."."""
_OWN: Final = (
    r"(?:(?:open|closed|flat|wide|wider|narrow|straight|long|short|upper|lower|top|bottom|back|front|cast-on|last|final|sewn|raw|own|inner|outer|flattened)\s+)*"
    r"(?:edges?|ends?|sides?|rims?|tops?|openings?|bases?|seams?|bottoms?)"
)
_EDGE: Final = re.compile(
    rf"\b(?P<verb>sew|stitch|attach|pin|place|position|put|set|fix|whip ?stitch|join|hold|lay|lean|press|tack)(?P<on>\s+on)?\s+(?:only\s+|just\s+)?"
    rf"(?:the|its|their|his|her|each|both)\s+(?:two\s+)?(?P<own>{_OWN})(?:\s+of\s+(?:it|them|(?:the|each|both|your)\s+(?P<of>(?:[a-z]+\s+)?[a-z]+)))?(?=\s+(?:to|onto|on|in|into|at|over|along|against|under|below|above|between|around|across)\b|\s*[,.;]|\s*$)"
)
"""An own edge of what is sewn, in its place: "sew the open end to …", "hold the flat edge of the tail against …"."""
_OWN_ROUND: Final = re.compile(
    rf"\b(?:sew|stitch|attach|pin|join)\s+(?:the\s+)?{ROUND}\s?\.?\s*\d+\s+of\s+(?:it|the\s+(?P<of>(?:[a-z]+\s+)?[a-z]+?))(?=\s+(?:upright\s+|flat\s+)?(?:to|on|onto|over|at)\b)"
)
"""A round of what is sewn, in its place: "Sew Rnd 1 of the stem upright on the middle of the back"."""
_BASES: Final = re.compile(
    rf"^\W*(?:each|the|their|its|both)\s+(?:base|bottom edge|lower edge|open edge|open end)s?\s+(?:sits?|goes|go|lies|lie|runs?|is|are)\s+(?=(?:across|over|between|along)\s+{ROUND}\b)"
)
"""Where the edge of what is sewn comes to lie, told behind it: "Each base sits across Rnds 3 to 6"."""
_SHAPED: Final = r"(?:oval|circle|disc|disk|piece|square|triangle|strip|rectangle|half[- ]ball|dome|cone|pair|two|lot)"
_LAID: Final = re.compile(
    rf"(?:^|(?<=[,;.:]\s)|\band\s+|\bthen\s+)(?:lay|stand|rest|lean|hold|slip|set|hang|let|place|put|pin|sew|position|slide|press)\s+(?P<what>it|them|both|these|the {_SHAPED}s?)(?P<flat>\s+(?:flat|on end|upright|lengthwise|sideways|across))?"
    r"(?=\s+(?:to|onto|on|in|into|at|over|along|against|under|just|right|directly|below|above|between|around|across|beside|close|behind)\b)"
)
"""What is done with "it", or with its shape's name: "lay the oval along the underside"."""
_BARE: Final = re.compile(
    r"^\W*(?P<verb>goes|go|sits|sit|lies|lie|stands|stand|hangs|hang|belongs|belong|covers|cover|is|are|comes|come)\s+"
    rf"(?=(?:low|high|up|flat|lengthwise|crosswise|over|on|at|to|in|between|under|below|above|along|around|behind|beside|just|right|halfway|down|{ROUND})\b)"
)
"""A sentence without the part that it is about: "goes low on the front of the head"."""
_MEETS: Final = re.compile(
    r"\bmatch(?:ing)?\s+(?:up\s+)?(?:the|its|their)\s+(?:\d+\s+)?(?:sts|stitches|opening|edge|rim)\b[^.;]{0,24}?\s+(?:to|with|against)\s+(?:the\s+)(?:\d+\s+)?(?:sts|stitches|opening|edge|rim)\s+"
    r"(?:at|of|on|in|around)\s+(?:the\s+)(?P<on>(?:(?:back |hind |rear |tail |open )?end of (?:the |his |her |its )?)?[a-z]+)"
)
"""Stitches that meet those of another part: "match the 12 sts of Rnd 10 to the 12 sts at the end of the body"."""
_SPANS: Final = re.compile(
    rf"^\W*(?=(?:(?:the|its|their)\s+)?(?:top|bottom|upper|lower|front|back)(?:\s+(?:edge|end|side|corner)s?)?\s+(?:touch|meet|reach|com|start|end|begin|sit|lie)[a-z]*\s[^.;]*\b{ROUND}\s?\.?\s*\d)"
)
"""From where to where a part reaches, which leaves it out: "The top touches the neck seam and the bottom comes down to round 17"."""
_ROUND_IT: Final = re.compile(
    r"^\W*(?:(?:now|then|and)\s+)?(?:sew|whip ?stitch|stitch)\s+(?:all\s+)?(?:the\s+way\s+)?(?:around|round)\b(?!.*\b(?:to|onto|on)\b)[^;]*$"
)
"""How it is sewn where it was put: "Now sew around each leg twice"."""
_HANGS: Final = r"\s+(?:should\s+|must\s+|will\s+)?(?:go(?:es)?|hangs?|sits?|stands?|starts?|begins?|grows?|lies?|rests?|belongs?|comes?)\s+(?:(?:out|lengthwise|crosswise|straight|flat)\s+)?(?=(?:from|on|at|in|over|along|between|below|above|under|beside|directly|just|right)\b)"
_REACHES: Final = re.compile(
    r",?\s*\b(?:and\s+|so\s+(?:that\s+)?)?(?:the|its|his|her|their)\s+(?:[a-z]+\s+)?(?:paws?|feet|foot|toes|legs?|hooves|tips?)\s+(?:stand|rest|sit|lie|reach|touch)(?:s|es)?\s+(?:flat\s+)?(?:on\s+)?the\s+(?:table|ground|floor)\b[^.;]*"
)
"""Limbs that reach what the toy stands on: "and the paws stand flat on the table"."""
_HELD: Final = re.compile(
    r",?\s*\b(?:and\s+)?take\s+(?:a\s+few|some|a\s+couple\s+of|two|three)\s+(?:\w+\s+)?stitches\b[^.;]*"
)
"""What only holds a part where it is."""
_COVERS: Final = re.compile(
    rf"[,;]?\s*\b(?:covering|spanning|reaching over|taking up|stretching over)\s+(?={ROUND}\s?\.?\s*\d)"
)


_STROKES: Final = re.compile(
    r"\b(?:make|work|sew|take|do|put|add)\s+(?:a|an|one|two|three|\d+)\s+(?:[a-z]+\s+){0,2}?(?:stitch(?:es)?|lines?|strokes?)\b"
)
"""What something is drawn with, whose name stands before the sentence: "Smile: … make one long stitch"."""


_BREAK: Final = re.compile(r"[.!?:][\s\"”)*]*$")
_LINE: Final = 32  # letters of a line that a page's edge breaks, or more
_PAIRS: Final = re.compile(
    r"(?:\bthe\s+|^\W*)(?P<one>front|first|hind|back|rear)\s+(?:two|pair|ones?)\b(?P<a>.*?)[,;]?\s+(?:and\s+)?(?:the\s+)?(?P<two>front|second|hind|back|rear)\s+(?:two|pair|ones?)\b(?P<b>.*)",
    re.DOTALL,
)
"""Four of a part, told as two pairs: "the hind pair between Rd 8 and Rd 15, the front pair between Rd 17 and Rd 24"."""
_OVER_ROUNDS: Final = re.compile(rf"\b{ROUND}\s?\.?\s*(\d+)(?:\s*(?:to|and|-|–)\s*(?:{ROUND}\s?\.?\s*)?(\d+))?")
_AT_NUMBER: Final = re.compile(r"\s*(?:at|in|on|over)\s+(\d+)(?:\s*(?:to|and|-|–)\s*(\d+))?(?=\s*$|\s*[,.;])")
_THEY_GO: Final = re.compile(r"^\W*(?:they|these|both)\s+(?=(?:go|sit|belong|are placed)\b)")
_THEY_APART: Final = re.compile(
    rf"^\W*(?:they|these|the\s+two|both)\s+(?:(?:should|must|will)\s+)?(?:sit|sits|are|be|stand|lie|go|come|end up)\s+(?:about\s+|roughly\s+|set\s+|placed\s+|spaced\s+)?"
    rf"(?=(?:{QUANTITY})\s*(?:sts?|stitch(?:es)?|sc)\s+(?:apart|from each other)\b)|^\W*(?:leave|keep|with)\s+(?:about\s+)?(?=(?:{QUANTITY})\s*(?:sts?|stitch(?:es)?|sc)\s+between\s+(?:them|the\s+two)\b)"
)
"""How far the two of a pair are apart, told behind where they go: "They sit 6 stitches apart"."""


_EYES: Final = re.compile(
    r"(?<!with the )(?<!below the )(?<!under the )(?<!above the )(?<!beside the )(?<!behind the )(?<!to the )(?<!from the )(?<!between the )(?<!than the )"
    r"(?<!with )(?<!below )(?<!under )(?<!above )(?<!beside )(?<!behind )(?<!to )(?<!from )(?<!between )(?<!than )\beyes\b"
)
"""Eyes that are spoken of, and that nothing is only near."""


def _starts(text: str, begin: int) -> int:
    """Where the paragraph begins that the page's edge broke into lines, the last of which holds ``begin``: a line goes on that ends in mid-sentence."""
    line = text.rfind("\n", 0, begin) + 1
    while line:
        above = text.rfind("\n", 0, line - 1) + 1
        said = text[above : line - 1]
        if len(said.strip()) < _LINE or _BREAK.search(said) or _LABEL.match(text, line):
            break
        line = above
    return line


_SHUT: Final = re.compile(r"\b(?:closed|shut)\b(?! (?:edge|end|side))")
_BEFORE: Final = 160
"""So many letters before a sentence name the limbs that it tells in pairs."""
_SURFACE: Final = re.compile(r"\bsurface[- ](?:sl(?:ip)?[- ]?st(?:itch)?(?:es)?|crochet|chain)\b", re.IGNORECASE)
"""What is crocheted onto the fabric as one embroiders it."""
_ON_FACE: Final = re.compile(
    r"\b(?:smile|mouth|nose|eyes?|(?:eye)?brows?|(?:eye)?lash(?:es)?|cheeks?|whiskers)\b", re.IGNORECASE
)
_FIRST_SEWN: Final = re.compile(r"^\W*(?:sew|attach|stitch|pin)\b[^:.]{0,40}:\s+", re.IGNORECASE)
"""What stands before the first part that is sewn: "Sew onto the red first: chimney halfway up the slope"."""


def told_whole(text: str, begin: int, words: str, names: list[str], within: str = "") -> str:
    """A sentence of the assembly, at ``begin`` of a text, with the verb or the part that it leaves out; as it is where it leaves out none.

    names : of the parts that are known; within : the one that the sentence stands in
    """
    lead = _FIRST_SEWN.match(words)
    if lead is not None and not mentions(lead[0].lower(), [Made(n, 1) for n in names]):
        rest = words[lead.end() :]
        if (full := fuller(rest, names)) != rest:
            return full
    drawn = _SURFACE.sub("embroider", words)
    if drawn != words and _ON_FACE.search(drawn):
        return drawn
    full = fuller(words, names)
    return full if full != words else about(text, begin, words, tuple(names), within)


def about(text: str, begin: int, words: str, names: tuple[str, ...], within: str = "") -> str:
    """A sentence, at ``begin`` of a text, with the part that its paragraph is about where it leaves it out, or the one ``within`` whose rounds it
    stands right behind; as it is otherwise."""
    line = _starts(text, begin)
    block = text.rfind("\n\n", 0, begin) + 2 if "\n\n" in text[:begin] else 0
    two = _JOINING.match(text, block)
    if two is not None and (one_ := _part(two[1], names)) and (other := _part(two[3], names)):
        part, host = _onto(one_, other, two["how"], (other, one_))
        joined = begin <= two.end() or _THROUGH.search(words.lower())
        if part and (joined or (_JOINS.search(words.lower()) and not _says_itself(words, (part, host), names))):
            return f"sew the {_called(part)} to the {_called(host)}"
    if (they := _THEY_GO.match(words.lower())) is not None and _of_eyes(text[line:begin].lower(), names):
        return f"the eyes {words[they.end() :]}"
    if (far := _THEY_APART.match(words.lower())) is not None and (pair := _last_pair(text[line:begin].lower(), names)):
        return f"sew the {pair} {words[far.end() :]}"
    words = SCATTERED.sub(r"\1", _FACING.sub("", words))
    if (set_ := _SET.match(words.lower())) is not None:
        where_to, _, rest = _SO.sub("", words[set_.end() :]).partition(",")
        others = mentions(rest.lower(), [Made(n, 1) for n in names])  # ", attic window over door", is what is seen then
        return f"place {set_[1]} {where_to}" + ("" if others or not rest else f",{rest}")
    two = _JOINT.match(text, line)
    if two is not None and two.start(1) <= begin and (one_ := _part(two[1], names)) and (other := _part(two[3], names)):
        part, host = _onto(one_, other, two["how"], (one_, other))
        own = words[max(0, two.end() - begin) :]
        if not part or not _JOINS.search(words.lower()) or _says_itself(own, (part, host), names):
            return own
        return f"sew the {_called(part)} to the {_called(host)}"
    label = _LABEL.match(text, line)
    drawn = label is not None and label.end() <= begin + 1 and " " not in label[1] and face.motifs(label[1].lower())
    if (
        label is not None
        and drawn
        and not _part(label[1], names)
        and (made := _STROKES.search(words.lower())) is not None
    ):
        return f"{words[: made.start()]}embroider a {label[1].lower()}{words[made.end() :]}"
    name = topic(text, begin, names) or _of_pairs(text, begin, words, names)
    shuts = _SHUT.search(words.lower())  # "Sew the end of the tail closed at the 2nd rnd"
    if (
        not name
        and not shuts
        and within in names
        and _EDGE.search(words.lower())
        and lines.behind_rounds(text, begin, 2)
    ):
        name = within  # "Stuff, and sew the open end to the side of the roof"
    if not name:
        return words
    led = text[begin : label.end()] if label is not None and label.end() > begin else ""
    own = words[len(led) :] if led and words.startswith(led) else words
    carries = carried(name, own, names)
    return words if carries is own else carries


def _onto(one_: str, other: str, how: str, else_: tuple[str, str]) -> tuple[str, str]:
    """Which of two parts is sewn to which; of a list of limbs, "Arms and legs", none to the other."""
    if how.lower() != "and":
        return one_, other
    limbs = [Made(name, 1).kind in LIMBS for name in (one_, other)]
    return ("", "") if all(limbs) else (one_, other) if limbs[0] else (other, one_) if limbs[1] else else_


def _says_itself(words: str, two: tuple[str, str], names: tuple[str, ...]) -> bool:
    """Whether a sentence about two parts says itself what goes where: it names both, or a third, or a round."""
    said = {p.name for m in mentions(words.lower(), [Made(name, 1) for name in names]) for p, _ in m.copies}
    return bool(said - {*two}) or said >= {*two} or where(words.lower()).rounds is not None


def _of_eyes(low: str, names: tuple[str, ...]) -> bool:
    """Whether "they" are the eyes: what was spoken of last, and not only by the way, "in line with the eyes"."""
    eyes = [m.start() for m in _EYES.finditer(low)]
    others = [m.start for m in mentions(low, [Made(name, 1) for name in names]) if low[m.start : m.end].endswith("s")]
    return bool(eyes) and eyes[-1] > max(others, default=-1)


def _last_pair(low: str, names: tuple[str, ...]) -> str:
    """What was spoken of last as several, by the name of its part; "" where nothing was, or eyes were spoken of since."""
    said = [m for m in mentions(low, [Made(name, 2) for name in names]) if low[m.start : m.end].endswith(("s", "feet"))]
    eyes = [m.start() for m in _EYES.finditer(low)]
    if not said or len({p for p, _ in said[-1].copies}) != 1 or (eyes and eyes[-1] > said[-1].start):
        return ""
    return _called(said[-1].copies[0][0].name)


def _rounds_of(pairs: re.Match[str] | None) -> list[re.Match[str] | None]:
    """The rounds of each of two pairs; of the second the number alone may be said, "the front two at round 12, the back two at 4"."""
    if pairs is None or "third" in pairs["b"] or (first := _OVER_ROUNDS.search(pairs["a"])) is None:
        return [None]
    return [first, _OVER_ROUNDS.search(pairs["b"]) or _AT_NUMBER.match(pairs["b"])]


def _of_pairs(text: str, begin: int, words: str, names: tuple[str, ...]) -> str:
    """The limbs of which a sentence tells two pairs: those that it, or the one before it, names; "" of all else."""
    pairs = _PAIRS.search(words.lower())
    if pairs is None or not all(_rounds_of(pairs)):
        return ""
    said = (
        text[max(text.rfind("\n", 0, begin) + 1, begin - _BEFORE) : begin].lower() + words.lower()[: pairs.start("b")]
    )
    named = [m for m in mentions(said, [Made(name, 4) for name in names]) if m.copies[0][0].kind in LIMBS]
    return named[-1].copies[0][0].name if named else ""


def topic(text: str, begin: int, names: tuple[str, ...]) -> str:
    """The part of ``names`` that the paragraph at ``begin`` of a text is about there; "" where it says none."""
    line = _starts(text, begin)
    said = ""
    label = _LABEL.match(text, line) or _NUMBERED.match(text, line)
    if label is not None and label.start(1) <= begin:
        said = label[1]
    for m in _OPENED.finditer(text, line, begin):
        said = (m[1] or m[2]) if _part(m[1] or m[2], names) else said
    for m in _TAKEN_UP.finditer(text, line, begin):
        said = m[1] if _part(m[1], names) else said
    return _part(said, names) if said else ""


@lru_cache(maxsize=512)
def _part(said: str, names: tuple[str, ...]) -> str:
    """The one part that a label names whole."""
    low = said.lower()
    words = [one(w) for w in re.findall(r"[^\W\d_]+", low)]
    made = [Made(name, 1) for name in names]
    found = mentions(low, made)
    of = {p.name for m in found for p, _ in m.copies}
    known = {w for p in made for w in p.words}
    if len(of) != 1 or not all(w in known or kind_of(w) or w in ("the", "two", "both") for w in words):
        return ""
    return of.pop()


def carried(name: str, text: str, names: tuple[str, ...]) -> str:
    """A sentence of a paragraph about the part ``name``, which may leave it out, with it; as it is where it names it."""
    low = text.lower()
    part = Made(name, 1)
    called = _called(name)
    made = low
    pairs = _PAIRS.search(made)
    rounds = _rounds_of(pairs)
    if pairs is not None and all(rounds):
        some = [f"over rounds {m[1]} to {m[2] or m[1]}" for m in rounds if m is not None]
        made = f"sew the {pairs['one']} {called} {some[0]}, and sew the {pairs['two']} {called} {some[1]}"
    elif (first := _OWN_ROUND.search(made)) is not None and _part(first["of"] or "", names) in ("", name):
        made = f"{made[: first.start()]}sew the {called}{made[first.end() :]}"
    elif (base := _BASES.match(made)) is not None:
        made = f"sew the {called} {made[base.end() :]}"
    elif (edge := _EDGE.search(made)) is not None and _own(edge, part, made, names):
        made = f"{made[: edge.start()]}sew the {called}{made[edge.end() :]}"
    elif (laid := _LAID.search(made)) is not None:
        made = f"{made[: laid.start()]}sew the {called}{laid['flat'] or ''}{made[laid.end() :]}"
    elif (meets := _MEETS.search(made)) is not None:
        made = f"sew the {called} to the {meets['on']}{made[meets.end() :]}"
    elif (spans := _SPANS.match(made)) is not None:
        made = f"sew the {called} with {made[spans.end() :]}"
    elif _ROUND_IT.match(made):
        made = f"sew the {called}"
    elif (bare := _BARE.match(made)) is not None:
        made = f"sew the {called} {made[bare.end() :]}"
    elif (drawn := _OVER_IT.search(made)) is not None and face.motifs(made):
        made = f"{made[: drawn.start()]}{drawn[1]} the {called}{made[drawn.end() :]}"
    elif (it := _IT.search(made)) is not None and not mentions(
        made[: it.start()], [Made(n, 1) for n in names if n != name]
    ):
        made = f"{made[: it.start()]}{it[1]} the {called}{made[it.end() :]}"
    else:
        noun = part.words[-1] if part.words else ""
        hangs = (
            re.match(rf"^\W*(?:(?:the|these|each)\s+)?(?:they|it|these|{re.escape(noun)}s?)?{_HANGS}", made)
            if noun
            else None
        )
        if hangs is not None:
            made = f"sew the {called} {made[hangs.end() :]}"
    if made is low:
        return text
    made = _COVERS.sub(" over ", made)
    return _HELD.sub("", _REACHES.sub(", pointing straight down", made))


def _called(name: str) -> str:
    """A part's name in a sentence."""
    return " ".join(re.findall(r"[^\W\d_]+", name.lower()))


def _own(edge: re.Match[str], part: Made, low: str, names: tuple[str, ...]) -> bool:
    """Whether the edge that a sentence begins with is one of the part itself, and another part follows that it is sewn to."""
    of = edge["of"]
    if of and _part(of, names) not in ("", part.name):
        return False  # of another part
    return VERB.search(low[edge.start() : edge.end()]) is not None or edge["verb"] in ("hold", "lay", "lean", "press")
