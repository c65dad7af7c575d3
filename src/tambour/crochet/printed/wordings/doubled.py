"""Printed patterns, doubled: increases and decreases in other words, translations' and beginners' ("double every 4th st", "crochet every 3rd and
4th st together", "work the next two stitches together"), as what is put in their place."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from tambour.crochet.printed.tokens import Row
from tambour.crochet.printed.wordings.reworded import reworded
from tambour.crochet.words.numbers import NUMBER
from tambour.crochet.words.sayings import Sayings

_NTH: Final = r"\d+(?:st|nd|rd|th)|second|third|fourth|fifth|sixth|seventh|eighth|ninth|tenth"
_ST: Final = r"(?:sts?|stitch|stitches|m|sc|loops?)(?: \.(?= (?:[(\[=-]|together\b|tog\b|each\b|is\b|are\b)))?"
_SC: Final = r"(?:sc|single crochets?|single crochet stitch|single crochet stitches)"
_TWO: Final = r"(?:2|two)"
_VERB: Final = r"(?:(?:always |then |now |just )?(?:crochet|work|knit|sc|single crochet)(?: together)?)"
_GOES: Final = (
    r"(?: \.)?(?: (?:each|always|all the time|around|all around|(?:all )?(?:the )?way (?:a)?round|all round))"
)
_TRIGGERS: Final = frozenset(
    "together double doubled doubling every each after times twice like across along way x * inc mr mc magic".split()
    + [f"x{n}" for n in range(2, 40)]
)
"""Words one of which stands in whatever these concern."""
_SAYINGS: Final = Sayings(
    (rf"(?<!\S){said}(?!\S)", meant)
    for said, meant in (
        (rf"(?:double|doubling) (?:up )?(?:every|each) ({_NTH}) {_ST}", "inc every {1} st"),
        (rf"(?:every|each) ({_NTH}) {_ST} (?:is |are |will be |should be |to be )?(?:doubled|increased)", "inc every {1} st"),
        (rf"in(?:to)? (?:every|each) ({_NTH}) {_ST} (?:work |crochet |make )?{_TWO} {_SC}", "inc every {1} st"),
        (rf"(?:work |crochet |make )?{_TWO} {_SC} in(?:to)? (?:every|each) ({_NTH}) {_ST}", "inc every {1} st"),
        (rf"inc (?:1|one) in (?:every|each) ({_NTH}) {_ST}", "inc every {1} st"),
        (rf"(?:double|doubling) (?:each|every|all)(?: of)?(?: the)? {_ST}", "inc in each st"),
        (rf"(?:double|doubling) (?:1|one|the next|next|the) {_ST}", "inc"),
        (rf"(?:{_VERB} )?(?:every|each|the) ({_NTH}) (?:and|\+|&) ({_NTH}) {_ST} (?:together|tog)", "dec every {1} and {2} st"),
        (rf"{_VERB} together (?:every|each|the) ({_NTH}) (?:and|\+|&) ({_NTH}) {_ST}", "dec every {1} and {2} st"),
        (rf"(?:crochet|work|knit) together (?:every|each|the) ({_NTH}) (?:and|\+|&) ({_NTH}) {_ST}", "dec every {1} and {2} st"),
        (rf"{_VERB} (?:the )?(?:next )?{_TWO} {_ST} (?:together|tog) \( [^\W\d]\w* \)", "dec"),  # "single crochet 2 stitches together (sc2tog)"
        (rf"(?:{_VERB} )?(?:every|each) {_TWO} {_ST} (?:together|tog)", "dec around"),
        (rf"(?:crochet|work|knit) together (?:every|each) {_TWO} {_ST}", "dec around"),
        (rf"(?:{_VERB} )?(?:the )?(?:next )?{_TWO}(?: {_ST})? (?:together|tog){_GOES}", "dec around"),
        (rf"(?:always|crochet|work|knit|sc|single crochet)(?: crochet| work| knit)? (?:the )?(?:next )?{_TWO} {_ST} (?:together|tog)", "dec"),
        (rf"(?:crochet|work|sc|single crochet) (?:the )?(?:next )?{_TWO} together", "dec"),
        (rf"(, (?:then |and )?){_TWO} together(?= ?[,;.(\[]| ?$)", "{1} dec"),
        (r"in(?:to)? the (?:stitch|st|one) after(?: that| this)?(?= ?[,;.(\[)\]]| and\b| ?$)", "in next st"),
        (r"(\w+) times over", "{1} times"),
        (r"(repeat(?: this| that)? \w+ times) in (?:all|total)", "{1}"),
        (r"(?:go|going|carry on|keep going) around like (?:that|this)", "repeat around"),
        (r"(sc|hdc) (?:across|along) (\d+)(?: sts?| stitches)?(?= to close| closed| shut)", "{2} {1}"),
        # notes of one's own
        (r"(\d+ sc) (mr|mc|magic ring|magic circle)(?= ?[(\[.;=-]| ?$)", "{1} in {2}"),
        (r"(sc(?: in each(?: st| sc| stitch)?)?(?: around| round| all around| all| even))(?: ,)? (?:x|\*) ?(\d+)(?: rounds?| rnds?| rows?)?(?= ?[(\[.;=-]| ?$)", "{1} , {2} rounds"),
        (r"(sc(?: in each(?: st| sc| stitch)?)?(?: around| round| all around| all| even))(?: ,)? (\d+) ?(?:x|\*)(?= ?[(\[.;=-]| ?$)", "{1} , {2} rounds"),
        (r"sc (?:x|\*) ?(\d+) (?:rounds?|rnds?|rows?)(?= ?[(\[.;=-]| ?$)", "sc around , {1} rounds"),
        (r"^(sc) (\d+) (x|\*) ?(\d+)(?= ?[(\[.;=-]| ?$)", "{2} {1} x {4}"),
        (r"(?:, )?(?:all )?the way (?:a)?round(?= ?[\[(.;!]| ?$)", "around"),
        (r"(?:,|-) twice(?= ?[(\[.;=]| ?$)", ", 2 times"),
        (rf"; do (?:this|that|it|so) ({NUMBER}) times", ", {1} times"),
        (rf"- ({NUMBER}) times(?= ?[(\[.;=]| ?$)", ", {1} times"),
    )
)  # fmt: skip


def doubled(rows: list[Row]) -> list[Row]:
    """``rows`` with such words as increases, decreases and how often."""
    return [row if _TRIGGERS.isdisjoint([t.word for t in row.tokens]) else _row(row) for row in rows]


def _row(row: Row) -> Row:
    tokens = reworded(row.tokens, _SAYINGS)
    return row if tokens is row.tokens else replace(row, tokens=tokens)
