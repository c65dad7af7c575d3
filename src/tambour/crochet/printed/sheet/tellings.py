"""Printed patterns, tellings: the words by which people tell rounds without writing them, and where a sentence has some."""

from __future__ import annotations

import re
from typing import Final

from tambour.crochet.words.sayings import Sayings

_SC: Final = r"(?:single crochets?|double crochets?|singles?|doubles?|sc|dc|stitches|sts?|plain|plain stitches)"
_RINGS: Final = r"(?:magic |adjustable |sliding |starting )?(?:ring|loop|circle)"
_PLACE: Final = r"(?:each|every|all)(?: single)?(?: (?:one|sts?|stitch|stitches|\d+))?(?: of (?:them|these|those))?(?: around| round)?"
_INC: Final = (
    rf"increases?|incs?|2 (?:{_SC} )?(?:in|into|in to) (?:the )?(?:next|following)(?: one| st| stitch)?|2 (?:in|into) 1"
)
DEC: Final = r"decreases?|decs?|2 together|2 - together|2tog|(?:sc|dc)2tog"
_TIMES: Final = (
    r"(?:(?: ,)?(?: and)?(?: (?:repeat(?:ed|ing)?|do|doing)(?: (?:that|this|it))?)?"
    r" (?:(?P<times>\d+) times(?: over| again| in all| round)?|(?P<twice>twice)|times (?P<by>\d+)|(?P<all>all the way (?:round|around|about|along)|all round|all around|around|round|to the end)))?"
)


def _whole(said: str) -> str:
    """An expression that begins and ends where words do."""
    return rf"(?<!\S)(?:{said})(?!\S)"


_RING: Final = _whole(
    rf"(?P<ring>\d+)(?: {_SC})?(?: just)? (?:in|into|inside|through) (?:(?:a|the|your|to the) )?{_RINGS}(?: \w+)?|{_RINGS} (?:of|with) (?P<of>\d+)(?: {_SC})?"
)
_DOUBLE: Final = _whole(
    rf"2 (?:{_SC} )?(?:in|into|in to) {_PLACE}|(?:an )?increase (?:in|into) {_PLACE}|doubl(?:e|ing) (?:every|each|all|them|it)(?: sts?| stitch| stitches| up)?"
)
_SHAPE: Final = _whole(
    rf"(?<!round )(?<!rounds )(?<!rnd )(?<!row )(?P<plain>\d+)(?: {_SC})*(?:(?: (?:,|and|then|plus|followed by|-))+|(?<=[a-z])(?= (?:an?|1) )) (?:(?:work|do|make|put) )?(?:(?:an?|1) )?(?P<what>{_INC}|{DEC})(?! over){_TIMES}"
    rf"|(?P<between>\d+)(?: {_SC})? between (?:the )?(?P<these>increases|decreases)"
)
_MORE: Final = _whole(r"(?:then|and then|and|,) (?P<plain>\d+)(?= \( \d+ \))")
_SPENT: Final = _whole(
    rf"(?:nothing but )?2 - togethers|2 together (?:all the way )?(?:round|around)|(?:decrease|dec) (?:all )?(?:the way )?(?:round|around)|decrease (?:in|into) {_PLACE}"
)
_EVEN: Final = _whole(
    r"(?P<many>\d+|an?|another|once)(?: more)?(?: last)? (?:rounds?|rows?|around|round)(?: (?P<loops>in (?:the )?(?:back|front) loops?(?: only)?))?(?P<even> (?:plain|even|straight|without (?:any )?\w+))?"
    r"|(?P<number>\d+)(?: more)? (?:plain|even|straight) (?:rounds?|rows?)"
    rf"|(?:(?:even|straight|plain)(?: ,)? ?)?(?:even|straight|plain|(?:\d+ )?(?:just )?{_SC} (?:in|into) {_PLACE}|(?:just )?{_SC} (?:around|round|across|back|along))(?: ,)?(?: for)? (?P<for>\d+) (?:rounds?|rows?)"
    rf"|(?P<plainly>1 {_SC} (?:in|into) {_PLACE}|(?:just )?(?:single crochet|sc|double crochet|dc) (?:in |into )?(?:around|round|across|back|{_PLACE}))(?! chain)"
)
_ROW: Final = _whole(
    rf"(?:going back|back|starting|start|beginning|begin|return\w*)(?: along (?:the )?chain)?(?: ,)?(?: (?:starting|start|beginning|begin))? (?:in|into|from|with) (?:the )?(?:second|2nd|third|3rd|fourth|4th)(?: (?:chain|ch|one))?(?: from (?:the )?hook)?(?: ,| and)*(?: (?:work|do|make))?(?: (?P<in>\d+))?(?: {_SC})(?: (?:in|into) (?:each|every|all)(?: of the)?(?: \d+)?(?: chains?| chs?| st| stitch| one)?| all along| along| across| to the end)+"
)
_ROWS: Final = _whole(
    rf"(?:{_SC} ?(?:, ?)?(?:(?:and )?turn ?)?(?:, ?)?(?:and )?)?(?:do (?:this|that|so)|repeat(?: this| that)?|work(?: like this)?|go on|carry on|keep going|continue)(?: like (?:this|that))? until (?:there are|you have|i had|you've got|it is) (?P<rows>\d+) rows(?: altogether| in all| in total| long)?"
)
_CURLED: Final = _whole(
    rf"(?P<each>\d+)? ?{_SC} (?:in|into) (?:each|every) (?:chain|ch|one)(?: of them)?(?: going)? back(?: along(?: the chain)?)?(?: from the (?:second|2nd)(?: one| chain| ch)?)?"
)
_TOGETHER: Final = _whole(
    r"(?:single crochet|sc|double crochet|dc) (?:them|both|the two|the pieces|the edges)(?: \w+){0,2} together(?: all around| all round| around)?"
)
_EDGES: Final = _whole(
    rf"(?P<way>decrease|increase)(?: over| in| on)? (?:the )?first(?: 2)?(?: {_SC})?(?: ,| and)* (?:{_SC} )?(?:over |in |into )?(?:the )?(?:next )?(?P<middle>\d+)(?: {_SC})?(?: ,| and)* (?:decrease|increase)(?: over| in| on)? (?:the )?last(?: 2)?(?: {_SC})?"
    rf"|(?:the )?same(?: again)? with (?P<same>\d+)(?: {_SC})? in the middle"
)
LABEL: Final = re.compile(
    r"(?<!\S)(?P<kind>rounds?|rnds?|rows?) (?P<from>\d+)(?: ,? ?(?P<sign>to|and|through|till|-|,) (?P<to>\d+)(?: and (?P<last>\d+))?)?(?!\S)"
)
COUNT: Final = re.compile(
    r"\( (?P<bracket>\d+)(?: \w+)? \)"
    r"|(?:is|are|'s|that's|there's|have|has|make|makes|made|gives?|us|you|leaves?|leaving|to|at|for|get|keeping|still|so|got|remain|be|it|count|with) (?P<said>\d+)(?! ?(?:rounds?|times|together|in|between|inch|cm|mm|single|double|sc|dc|plain|more|rows|,? and an?))"
    r"|[,.;] (?P<alone>\d+)(?: stitches| sts)?(?: every time| each (?:time|round)| again)?(?= [.,;!]|$)"
    r"|^ ?(?P<first>\d+)(?: stitches| sts)?(?= [.,;!]|$)"
)


_TELLINGS: Final = Sayings(
    (
        (_RING, "ring"),
        (_ROW, "row"),
        (_CURLED, "row"),
        (_ROWS, "rows"),
        (_EDGES, "edges"),
        (_SHAPE, "shape"),
        (_DOUBLE, "double"),
        (_SPENT, "spent"),
        (_TOGETHER, "joined"),
        (_EVEN, "even"),
        (_MORE, "more"),
    )
)


def events(words: str) -> list[tuple[int, int, str, re.Match[str]]]:
    """The rounds that a sentence tells, in their order: where they stand, and of which kind each is."""
    found: list[tuple[int, int, str, re.Match[str]]] = []
    k = _TELLINGS.next(words)
    while k < _TELLINGS.n:
        said, kind = _TELLINGS[k]
        k = _TELLINGS.next(words, k + 1)
        for one in said.finditer(words):
            a, b = one.span()
            if any(a < d and c < b for c, d, _, _ in found):
                continue
            if kind == "even" and not _is_even(one, words):
                continue
            if kind == "more" and not any(k == "shape" for _, _, k, _ in found):
                continue
            found.append((a, b, kind, one))
    found.sort(key=lambda e: e[0])
    made: list[tuple[int, int, str, re.Match[str]]] = []
    for event in found:
        before = made[-1] if made else None
        between = words[before[1] : event[0]].strip(" ,and") if before is not None else "-"
        if (
            before is not None
            and not between
            and before[2] == event[2] == "shape"
            and before[3]["plain"] == event[3]["plain"]
        ):
            made[-1] = (before[0], event[1], "shape", event[3])  # "one and an increase, one and an increase, all round"
            continue
        plain = (
            before is not None and before[2] == event[2] == "even" and _JOINED.fullmatch(words[before[1] : event[0]])
        )
        if before is not None and plain and not (before[3]["plainly"] is None and event[3]["plainly"] is None):
            kept = before if before[3]["plainly"] is None else event
            made[-1] = (
                before[0],
                event[1],
                "even",
                kept[3],
            )  # "8 rounds without increases, one single crochet in each"
            continue
        made.append(event)
    return made


_JOINED: Final = re.compile(r" ?(?:[,:] ?)?(?:(?:so|that is|just|with|of) ?){0,2}")


def _is_even(one: re.Match[str], words: str) -> bool:
    """Whether words that may tell plain rounds do: a round that is only spoken of does not."""
    found = one.groupdict()
    if found["many"] is not None:
        return bool(found["even"] or found["loops"])
    return True
