"""Printed patterns, sellers: how those who sell their own patterns talk in a round, put as most others say it: "six plain rounds", "two in one, every stitch"."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from tambour.crochet.printed.tokens import Row, Token
from tambour.crochet.words.numbers import NUMBER

_MANY: Final = rf"(?:{NUMBER}|an?|another)(?: more)?"
_ROUND: Final = r"(?:rounds?|rnds?|rds?)"
_HEAD: Final = rf"(?:{_ROUND}|r) \d+(?: (?:-|to|and) \d+)? ?[.:]"
_SC: Final = "sc|dc|hdc|single crochet|double crochet"
_RING: Final = r"(?:magic|adjustable) (?:loop|ring|circle)"
_END: Final = r"(?= ?[.,;(\[=]| ?$)"
_ALL: Final = r"(?:(?:in )?(?:every|each) (?:stitch|st|one|time)|(?:all (?:the )?way )?(?:a)?round|every single (?:stitch|time|one))"

CHAT: Final = (
    # "Round 2, two in one every time (12)."
    (r"(?<=[.:] )(round|rnd) (\d+) ,(?= (?:\d+ (?:sc|dc|hdc|tr)|[a-z(*]))", "{1} {2} :"),
    # "Row 2: two in one, four times"
    (rf"({_HEAD.replace(_ROUND, '(?:rounds?|rnds?|rds?|rows?)')}) (?:2|two) in (?:1|one) , ({NUMBER} times|twice)", "{1} ( inc ) {2}"),
    # "As with the walls, the start of the rounds is the back": nothing is worked as there
    (r"(?<!same )as (?:with|for|on) (?:the )?[a-z]+ ,(?= (?:the )?(?:(?:start|beginning|first stitch|place where)(?!\S)|$))", ""),
    (r"(?<!\w )(?:bor|begin of round|beg of rnd) = ", "rounds begin "),
    # "in brown, one dc, two in one, six times"
    (rf"({_HEAD} (?:with|in|using) [a-z]+ ,) ([^,;()\[\]]+ , [^,;()\[\]]+) , ({NUMBER} times|twice)(?= ?[.,;(\[=]| ?$)", "{1} ( {2} ) {3}"),
    # "Round 3: one dc, two in one, six times, ss to close"
    (rf"({_HEAD}) ([^,;()\[\]]+ , [^,;()\[\]]+) , ({NUMBER} times|twice) , (ss|sl st|slst|slip stitch)(?= )", "{1} ( {2} ) {3} , {4}"),
    # "leg 1: FO. leg 2: keep going", "with leg 2: 3 sc more to reach the inside of the leg"
    (r"^(leg|foot|arm) (?:1|one) : (?:fo|fasten off|cut)(?: \.| ,)? (?:leg|foot|arm) (?:2|two) : (?:keep going|keep on|go on|carry on|continue|(?:do not|don't) (?:cut|fo|fasten off))(?: the yarn)?", "fasten off {1} 1 . do not cut {1} 2"),
    (rf"^(?:with|on|from) (leg|foot|arm) (?:2|two) : (?:work )?({NUMBER}) (?:more )?({_SC})(?: more)?(?= to | ?[.,]| ?$)", "on the second {1} , {3} {2} more"),
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
    (rf"(2|two) in (?:1|one)(?: ,)? {_ALL}{_END}", "inc around"),
    # "six times over, so the walls lean in", "six times again", "six times. Phew."
    (rf"({NUMBER} times) (?:over|again|altogether|in all|round){_END}", "{1}"),
    (rf"({NUMBER} times) , so (?:that )?[^.,;:()\[\]\d]+(?= ?[.(\[]| ?$)", "{1}"),
    # "a plain round, just to give the crown a bit of a peak", "six plain rounds for the sides of the cap", "five plain rounds in grey"
    (rf"({_HEAD}) {_MANY} plain {_ROUND}(?: (?:in|with) (?:the )?([a-z]+))(?= ?[.(\[=]| ?$)", "{1} with {2} , work even"),
    (rf"({_HEAD}) {_MANY} plain {_ROUND}(?: ?,? (?:just )?(?:to|for|and|so)(?!\S)[^.;:()\[\]\d]*)?(?= ?[.,;(\[=]| ?$)", "{1} work even"),
    # "now we turn the corner up the wall: work one dc …"
    (rf"({_HEAD}) (?:now|next|here|this is where) (?:we|you|i)? ?[^.;:()\[\]\d]*:(?= )", "{1}"),
    # "work one dc into the BACK loop only of every stitch"
    (rf"((?:1|one) (?:{_SC})) (?:in|into) (?:the )?(back|front) loops? only of (?:each|every) (?:st|stitch)", "{1} in {2} loop only of each st"),
    # "(2 rnds) (48 sts)", "[36] (6 rds)", "(48) [8 rounds]"
    (rf"[(\[] \d+ {_ROUND} [)\]](?= ?[(\[=])", ""),
    (rf"(?<=[\])] )[(\[] \d+ {_ROUND} [)\]](?= ?\.?$)", ""),
    # "[13] → the 3 decs = TOES": what a round's stitches become
    (r"(?<=[\])] ): (?:the|these) (?:\d+ )?(?:dec|inc|sc|st)s? (?:=|are|make|form|become) (?:the )?[a-z]+(?: [a-z]+){0,3}(?= ?\.| ?$)", ""),
)  # fmt: skip

_WIDE: Final = 2  # blanks that part the columns of a table
_ROUNDS: Final = frozenset("rnd rnds round rounds rd rds row rows r".split())


def ranged(row: Row) -> Row:
    """``row`` with the mark that a head lacks whose range stands in a column of its own: "Rnd 9 - 16   sc in each st (48)"."""
    if len(row.tokens) < 5:
        return row
    name, first, dash, last, body = row.tokens[:5]
    if (
        name.word not in _ROUNDS
        or first.kind != "number"
        or dash.word != "-"
        or last.kind != "number"
        or body.kind == "mark"
        or body.start - last.end < _WIDE
        or last.start - first.end > body.start - last.end + 1
        or not (isinstance(first.value, int) and isinstance(last.value, int) and first.value < last.value)
    ):
        return row
    mark = Token("mark", ":", last.end, last.end, None, True)
    return replace(row, tokens=[*row.tokens[:4], mark, *row.tokens[4:]])
