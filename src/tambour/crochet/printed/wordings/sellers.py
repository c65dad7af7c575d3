"""Printed patterns, sellers: how those who sell their own patterns talk in a round, put as most others say it: "six plain rounds", "two in one, every stitch"."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from tambour.crochet.printed.tokens import Row, Token
from tambour.crochet.words.numbers import NUMBER

_MANY: Final = rf"(?:{NUMBER}|an?|another)(?: more)?"
_ROUND: Final = r"(?:rounds?|rnds?|rds?)"
_HEAD: Final = rf"(?:{_ROUND}|rows?|r) \d+(?: (?:-|to|and) \d+)? ?[.:]"
_SC: Final = "sc|dc|hdc|single crochet|double crochet"
_RING: Final = r"(?:magic|adjustable) (?:loop|ring|circle)"
_END: Final = r"(?= ?[.,;(\[=]| ?$)"
_ALL: Final = r"(?:(?:in )?(?:every|each)(?: single)? (?:stitch|st|one|time)|(?:all (?:the )?way )?(?:a)?round)"
_TWO: Final = r"[^,;()\[\]]+ , [^,;()\[\]]+"
_DOES: Final = (
    r"change|changing|switch|swap|turn|join|stuff|fill|fasten|cut|break|place|put|insert|sew|attach|add|mark|pull|close|skip|leave|"
    r"yarn|colou?r|eyes?|inc|dec|increase|decrease|ch|sc|dc|hdc|sl|ss|loops?"
)
_WORD: Final = rf"(?!(?:{_DOES})(?!\S))[^.,;:()\[\]\d\s]+"
_TALK: Final = rf"{_WORD}(?: {_WORD})*"
"""Words that only say why: none of them has hands do anything."""

CHAT: Final = (
    # "Round 2, two in one every time (12)."
    (r"(?<=[.:] )(round|rnd) (\d+) ,(?= (?:\d+ (?:sc|dc|hdc|tr)|[a-z(*]))", "{1} {2} :"),
    # "Row 2: two in one, four times"
    (rf"({_HEAD}) (?:2|two) in (?:1|one) , ({NUMBER} times|twice)", "{1} ( inc ) {2}"),
    # "As with the walls, the start of the rounds is the back": nothing is worked as there
    (r"(?<!same )as (?:with|for|on) (?:the )?[a-z]+ ,(?= (?:the )?(?:(?:start|beginning|first stitch|place where)(?!\S)|$))", ""),
    # "in brown, one dc, two in one, six times"
    (rf"({_HEAD} (?:with|in|using) [a-z]+ ,) ({_TWO}) , ({NUMBER} times|twice){_END}", "{1} ( {2} ) {3}"),
    # "Round 3: one dc, two in one, six times, ss to close"
    (rf"({_HEAD}) ({_TWO}) , ({NUMBER} times|twice) , (ss|sl st|slst|slip stitch)(?= )", "{1} ( {2} ) {3} , {4}"),
    # "leg 1: FO. leg 2: keep going"
    (r"^(leg|foot|arm) (?:1|one) : (?:fo|fasten off|cut)(?: \.| ,)? (?:leg|foot|arm) (?:2|two) : (?:keep going|keep on|go on|carry on|continue|(?:do not|don't) (?:cut|fo|fasten off))(?: the yarn)?", "fasten off {1} 1 . do not cut {1} 2"),
    # "TAIL FLUKES (make 2 lobes in A, joined in Rnd 9)": one part, and no eleven
    (r"\( (?:make|work) (?:2|two) (?:lobes|halves|tips|legs|flukes|ends) in ([a-z]{1,12}) , (?:then |and )?join(?:ed)? (?:in|at|on) (?:rnd|round|row) \d+ \)", "( in {1} )"),
    (r"\( (?:make|work) (?:2|two) (?:lobes|halves|tips|legs|flukes|ends) , (?:then |and )?join(?:ed)? (?:in|at|on) (?:rnd|round|row) \d+ \)", ""),
    # "JOIN - sc in each of the 12 sts of the first lobe"
    (rf"({_HEAD}) (?:join|joining|joining round) -(?= )", "{1}"),
    (r"make (?:the |a )?second(?: (?:one|lobe|leg|fluke))? (?:the same|in the same way|like the first)(?: way)?(?: ,)? but do not (?:fasten off|fo|cut(?: the)?(?: yarn)?)", "make the second one and do not cut the yarn"),
    # "change to white for the sock"
    (r"((?:change|switch|swap)(?: back)? to (?:the )?[a-z]+) for (?:the |her |his |its )?(?!next|last|rounds?|rnds?|rows?|now|this|these|first|rest|all|one|two|three|remain)[a-z]+(?= ?[.;]| ?$)", "{1}"),
    # "make your magic loop and pop 6 dc into it"
    (rf"(?:make|form|start|begin)(?: with)? (?:a|the|your) ({_RING}) and (?:then )?(?:pop|work|put|make|do|crochet) ({NUMBER}) ({_SC}) (?:in|into|inside) (?:it|that)", "{2} {3} in {1}"),
    # "two in one, every stitch", "two in one every time"
    (rf"(?:2|two) in (?:1|one)(?: ,)? {_ALL}{_END}", "inc around"),
    # "six times over, so the walls lean in", "six times again"
    (rf"({NUMBER} times) (?:over|again|altogether|in all|round){_END}", "{1}"),
    (rf"({NUMBER} times) , so {_TALK}(?= ?[.(\[]| ?$)", "{1}"),
    # "a plain round, just to give the crown a bit of a peak", "six plain rounds for the sides of the cap", "five plain rounds in grey"
    (rf"({_HEAD}) {_MANY} plain {_ROUND} (?:in|with) (?:the )?([a-z]+)(?= ?[.(\[=]| ?$)", "{1} with {2} , work even"),
    (rf"({_HEAD}) {_MANY} plain {_ROUND}(?: ?,? (?:just |only )?(?:to|for|and|so) {_TALK})?(?= ?[.,;(\[=]| ?$)", "{1} work even"),
    # "now we turn the corner up the wall: work one dc …"
    (rf"({_HEAD}) (?:now|next|here) (?:we|you|i) (?:turn the corner|{_TALK})(?: {_TALK})? :", "{1}"),
    # "work one dc into the BACK loop only of every stitch"
    (rf"((?:1|one) (?:{_SC})) (?:in|into) (?:the )?(back|front) loops? only of (?:each|every) (?:st|stitch)", "{1} in {2} loop only of each st"),
    # "[13] → the 3 decs = TOES": what a round's stitches become
    (r"(?<=[\])] ): (?:the|these) (?:\d+ )?(?:dec|inc|sc|st)s? (?:=|are|make|form|become) (?:the )?[a-z]+(?: [a-z]+){0,3}(?= ?\.| ?$)", ""),
)  # fmt: skip

_WIDE: Final = 2  # blanks that part the columns of a table
_ROUNDS: Final = frozenset("rnd rnds round rounds rd rds row rows r".split())
_CLOSED: Final = {"(": ")", "[": "]"}


def ranged(row: Row) -> Row:
    """``row`` with the mark that a head lacks whose range stands in a column of its own, "Rnd 9 - 16   sc in each st (48)", and without a
    remark of how many rounds a range is: "R13-18: 36 sc [36] (6 rds)"."""
    first, last = _range(row.tokens)
    if not first < last:
        return row
    tokens = row.tokens
    _, one, _, other, body = tokens[:5]
    if body.kind != "mark" and body.start - other.end >= max(_WIDE, other.start - one.end - 1):
        tokens = [*tokens[:4], Token("mark", ":", other.end, other.end, None, True), *tokens[4:]]
    at = next((k for k in range(4, len(tokens) - 3) if _says(tokens[k : k + 4], last - first + 1)), 0)
    tokens = [*tokens[:at], *tokens[at + 4 :]] if at else tokens
    return row if tokens is row.tokens else replace(row, tokens=tokens)


def _range(tokens: list[Token]) -> tuple[int, int]:
    """The first and the last of the rounds that a head names, "Rnd 9 - 16"; (0, 0) for none."""
    if len(tokens) < 5 or tokens[0].word not in _ROUNDS or tokens[2].word not in ("-", "to"):
        return 0, 0
    a, b = tokens[1].value, tokens[3].value
    return (a, b) if isinstance(a, int) and isinstance(b, int) else (0, 0)


def _says(tokens: list[Token], many: int) -> bool:
    """Whether four tokens say so many rounds, in brackets: "(6 rds)"."""
    opened, number, noun, closed = tokens
    return _CLOSED.get(opened.word) == closed.word and number.value == many and noun.word in _ROUNDS
