"""Printed patterns, rendered: what machines leave of weblogs that they put into English out of Russian and its neighbours, "1p: 2in, 6 stb in the
second from the hook loop", "2 sbn, addition - repeat 6 times", "5th row for zpp: knit a row without changes", put as most patterns have it."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Final

from tambour.crochet.printed.tokens import Row
from tambour.crochet.printed.wordings.reworded import reworded, word
from tambour.crochet.printed.wordings.weblogs import HUE
from tambour.crochet.printed.yarns.shades import shade
from tambour.crochet.words.sayings import Sayings

_SIGNS: Final = frozenset("sbn stbn stb cтбн cбн cbn zpp psn ka vp".split())
"""Words by which such a text is known: the short names of stitches and rings, letter by letter."""
_FEW: Final = 3  # of them
_MEANT: Final = {
    "sb": "sc",
    "stb": "sc",
    "stbn": "sc",
    "cтбн": "sc",
    "cбн": "sc",
    "cbn": "sc",
    "cb": "sc",
    "psn": "hdc",
    "addition": "inc",
    "adding": "inc",
    "reduction": "dec",
    "decreasing": "dec",
}
"""Words that mean a stitch in such a text alone."""
_SHAPES: Final = {"p": "inc", "u": "dec", "у": "dec", "п": "inc", "pr": "inc", "ub": "dec"}
"""Letters that do so right behind a number."""
_ROW: Final = r"(?:row|round|rnd)"
_HEAD: Final = r"(?:^|(?<=: )|(?<=\. ))"
_END: Final = r"(?= ?[.;(\[=]| ?$)"
_SAYINGS: Final = Sayings(
    (rf"(?<!\S){said}(?!\S)", meant)
    for said, meant in (
        (r"(\d+) (?:in|vp|v \. p) , (\d+ \w+) in (?:the )?(?:second|2nd) (?:from (?:the )?hook (?:loop|link)|(?:loop|link) from (?:the )?hook)", "{2} in mr"),
        (r"(\d+ (?:sc|sbn)) (?:in |into |a |an |the |bring )*ring amigurumi", "{1} in mr"),
        (r"(?:knit|crochet|work) (?:behind|for) the back wall", "in blo ,"),
        (r"(?:right|pr|inc) in each (?:loop|link|column)", "inc around"),
        (rf"in each (?:loop|link|column) (?:of )?(\d+) (sc|dc|hdc){_END}", "{1} {2} in each st"),
        (rf"(?<=: )in each (?:loop|link|column){_END}", "2 sc in each st"),
        (rf"(?<=: )(?:(?:circle|round|crochet|knit|knitting) )?in a circle{_END}", "sc in each st around"),
        (rf"(?:knit|crochet|work) (?:a|1|one|the|this|\d+) {_ROW}s? without (?:any )?changes?{_END}", "sc in each st around"),
    )
)  # fmt: skip
_ALWAYS: Final = Sayings(
    (rf"(?<!\S){said}(?!\S)", meant)
    for said, meant in (
        (rf"^(\d+(?:st|nd|rd|th) {_ROW}) (?:for|in|behind|over|through) (?:the )?(?:zpp|blo|back (?:half )?loops?(?: only)?) :", "{1} : in blo ,"),
        (rf"^(\d+(?:st|nd|rd|th) {_ROW}) (?:for|in|behind|over|through) (?:the )?(?:ppp|flo|front (?:half )?loops?(?: only)?) :", "{1} : in flo ,"),
        (r"(\d+ (?:ch|chains?)) , in (?:the )?(second|2nd|third|3rd|fourth|4th) (?:loop|link|ch|chain) from (?:the )?hook (?:crochet|work|make|knit)? ?(\d+ (?:sc|hdc|dc))(?= ?[,.;(]| ?$)", "{1} , from {2} ch from hook {3}"),
        (r"in (?:the )?(?:next )?(?:st|stitch|sc) after(?= ?[,;.*(\[)\]]| and\b| ?$)", "in next st"),
        (r"^(?:(?:now |and |then )?at (?:this|that) (?:stage|point|moment|time|step)|here|from here(?: on)?|after (?:this|that)) (?:, )?(?:we |you |i )?(?:will |should |need to |have to |must |can |now )*(change|switch|swap|attach|join|take)", "{1}"),
        (r"(change|switch|changing|switching) (?:the )?(?:threads?|yarns?|colou?rs?|ropes?) (?:on|in|into|for|with)(?= (?:the )?[a-z]{3,}(?: ?[.:,]| ?$))", "{1} to"),
        (r"(change|switch|changing|switching)(?: (?:the )?(?:threads?|yarns?|colou?rs?))? to (?:the )?(?:main|base|basic)(?= ?[.:,]| ?$)", "{1} to mc"),
        (r"(with|in|to|using) (?:the |an |a )?(?:additional|extra|auxiliary) (?:colou?r|yarn|thread)", "{1} cc"),
        (r"^([a-z]{3,}) colou?r(?: [.:])?$", "with {1} color"),
        (r"(?<=: )1 (sc|dc|hdc) in (?:sc|dc|hdc|st)(?= ?[(\[=.]| ?$)", "{1} in each st around"),
        (r"inc ?1 (?:x|\*) ?(\d+)(?= ?[(\[=.,;]| ?$)", "{1} inc"),
        (r"dec ?1 (?:x|\*) ?(\d+)(?= ?[(\[=.,;]| ?$)", "{1} dec"),
        (r"(\d+ (?:inc|dec)) from (?:sc|dc|hdc)", "{1}"),
        (r"note : (?:pm|place (?:a |the )?(?:stitch )?marker) (?:on|in) (?:the )?(?:1st|first) (?:sc|st|stitch)", ""),
        (rf"^((?:row|round|rnd) \d+ :) (?:(?!sc|hdc|dc|tr|blo|flo|front|back|loops?|post|fp|bp|(?:{HUE}) )[a-z]+ ){{1,2}}(?:row|round|rnd) :", "{1}"),
        (r"^(row|round|rnd) \d+ is (the|an?|optional|your|where)", "this {1} is {2}"),
        (r"^(?:necessary|required|needed|used) materials(?: (?:and|&) (?:tools|equipment|supplies))?(?: [:;])?$", "materials :"),
        (r"make (\d+) (inc|dec|increases?|decreases?)(?= ?[=(\[]| ?$)", "{2} {1} sts evenly"),
        (r"(\d+ (?:sc|dc)) around each leg (?:&|and|,) (\d+ (?:sc|dc)) (?:on|along|in) each side of (?:the )?(?:ch|chain)s?", "{1} around first leg , {2} in ch , {1} around second leg , {2} on other side of ch"),
        (r"(?:change|switch|changing|switching) (?:the )?(?:colou?rs? |yarns? |threads? )?to (?:the )?(?:colou?r|yarn) of (?:the |your )?([a-z]+)", "change to {1}"),
        (r"(change|switch|changing|switching) (?:the )?(?:thread|rope)s? to", "{1} to"),
        (r"((?:change|switch)(?: colou?rs?)? to) ([a-z]{3,}) colou?r(?: ,)?(?= (?:\d+ |\( )?(?:sc|sbn|sb|hdc|dc|inc|dec)\b)", "{1} {2} ,"),
        (r"((?:change|switch)(?: colou?rs?)? to [a-z]{3,})(?= \d+ (?:sc|sbn|sb|hdc|dc|inc|dec)\b)", "{1} ,"),
        (r"(?:slst|ss|sl st|sl - st) / (ch|chain) (?:1|one)", "join , {1} 1"),
        (r"(ch \d+ , \d+ sc ,) \[ ([2-5]) (sc|hdc|dc) \](?= ,)", "{1} {2} {3} in last ch"),
        (r"(\d+ \w{2,5}) for (?:the )?(back|front) half loops?", "{1} in {2} loops only"),
    )
)  # fmt: skip
_BEGUN: Final = re.compile(
    r"(?:we |i )?(?:start|begin)(?:ing)? (?:to )?(?:(?:knit|knitting|crochet|crocheting) )?(?:(?:in|with) )?(?:the |an? )?([a-z]{2,}(?: (?!colou?r|yarn)[a-z]{3,})?)( colou?r| yarn)?(?: [.:])?$"
)
_SAYING: Final = frozenset(
    "x * inc1 dec1 from note row round rnd materials / [ start starting we additional extra auxiliary sc dc hdc begin change switch swap attach join take after make leg loops loop half color colour thread yarn hook zpp ppp blo flo back front".split()
)


def rendered(rows: list[Row]) -> list[Row]:
    """``rows`` with such words as most patterns have them."""
    known = sum(t.word in _SIGNS for row in rows for t in row.tokens) >= _FEW
    made: list[Row] = []
    for row in rows:
        if known:
            row = _meant(row)
        if not _SAYING.isdisjoint({t.word for t in row.tokens}):
            tokens = reworded(row.tokens, _ALWAYS)
            row = row if tokens is row.tokens else replace(row, tokens=tokens)
            row = _begun(row)
        made.append(row)
    return made


def _begun(row: Row) -> Row:
    """A line that only says in which yarn a piece begins: "We start knitting in white:", "Start pink:"."""
    found = _BEGUN.match(" ".join([t.word for t in row.tokens]))
    if found is None or not (found[1] in ("cc", "mc", "golden") or shade(found[1]) is not None):
        return row
    end = len(row.tokens) - (row.tokens[-1].word in (":", ".")) - (found[2] is not None)
    hue = row.tokens[end - len(found[1].split()) : end]
    if found[1] == "golden":
        hue = [word("gold", hue[0], hue[-1])]  # by itself it is a yarn's, and only shades others
    return replace(row, tokens=[word("with", row.tokens[0], row.tokens[0]), *hue])


def _meant(row: Row) -> Row:
    """A line of such a text with its stitches by their English names."""
    tokens = [replace(t, word=_MEANT[t.word]) if t.word in _MEANT else t for t in row.tokens]
    tokens = [
        replace(t, word=_SHAPES[t.word]) if k and t.word in _SHAPES and tokens[k - 1].kind == "number" else t
        for k, t in enumerate(tokens)
    ]
    tokens = reworded(tokens, _SAYINGS)
    return replace(row, tokens=tokens)
