"""Printed patterns, gaps: spaces that are said by what is about them: between stitches, at a corner, in a chain joined to its first; and ends of
rounds that are joined with no word that says so."""

from __future__ import annotations

import re
from functools import lru_cache
from typing import Final

from tambour.crochet.printed.tokens import Token
from tambour.crochet.printed.wordings.reworded import reworded
from tambour.crochet.words.sayings import Sayings

_ST: Final = "sts?|stitch|stitches|sc|hdc|dc|tr"
_SL: Final = "(?:sl st|slip st|slip stitch|ss)"
_SPS: Final = "(?:sps?|spaces?)"
_EACH: Final = rf"in(?:to)? (?:(?:the )?{_SPS} between (?:each|every)(?: (?:2|two))?|(?:each|every) {_SPS} between(?: the)?) ({_ST})"
_END: Final = r"(?: across| to (?:the )?end(?: of (?:the )?row)?)?"

_IN_ROWS: Final = Sayings((
    # between the ten stitches of a row are nine spaces
    (rf"(?<![2-9] sc )(?<![2-9] hdc )(?<![2-9] dc ){_EACH}{_END}(?= [.;:(\[–—-]| ?$| , (?:and )?turn)", "in each {1} to last {1} , skip last {1}"),
))  # fmt: skip
_AROUND: Final = Sayings(((_EACH, "in each {1}"),))
_RINGS: Final = Sayings((
    (
        r"((?:with|using) \w+(?: \w+)? , (?:ch|chain) \d+) [;,.] (?:sl st|slip st|slip stitch|ss) (?:to|in|into) (?:the )?(?:first|1st) (?:ch|chain)(?= [.,;]| ?$)",
        "{1} ; join with sl st to form ring",
    ),
    (rf"(?<!with )(?<!with a ){_SL}(?: (?:in|into|to) (?:the )?(?:first|1st|beg|beginning) (?:ch|chain))? to (?:form|make) (?:a )?(?:ring|circle)", "join with sl st to form ring"),
))  # fmt: skip
# joined with no word that says so: "sl st top beg sc, ch-1, turn"
_JOINED: Final = Sayings((
    (rf"(?<!with )(?<!with a ){_SL}(?: (?:in|into|to))?(?: the)? top(?: of)?(?: the)? (?:beg|beginning|first|1st) ({_ST})(?= [.,;:(]| ?$)", "join with sl st to first {1}"),
))  # fmt: skip
_NO_CHAIN: Final = "".join(
    f"(?<!{w} )"
    for w in "in into of each next beg beginning first turning same last top every corner the to a over around between beg. this that st sts sp".split()
)
# a hyphen that stands for a blank where a chain is worked: "ch-1, turn"
_HYPHENED: Final = Sayings(((rf"{_NO_CHAIN}\bch - (\d+)(?= [,.;:]| ?$)", "ch {1}"),))
_OF: Final = re.compile(rf"\bcorner (?:ch|chain) - (\d+) {_SPS}(?!\S)")
_TO_CORNER: Final = rf"to (?:the )?(?:next )?corner(?: {_SPS})?(?= ,)"


@lru_cache(maxsize=16)
def _corners(size: str) -> Sayings[str]:
    """Corners of so many chains; lines of one text have the same."""
    to_next = (_TO_CORNER, f"to next ch - {size} sp")
    return Sayings((to_next, (rf"in (?:the )?(?:next )?corner {_SPS}(?!\S)", f"in next corner ch - {size} sp")))


def spaced(tokens: list[Token]) -> list[Token]:
    """``tokens`` of a line with such spaces put as the rest is read: by their stitches, by their chains, as a ring."""
    said = {t.word for t in tokens}
    if "between" in said:
        flat = bool({"row", "rows"} & {t.word for t in tokens[:6]})
        tokens = reworded(tokens, _IN_ROWS if flat else _AROUND)
    if "corner" in said:
        sizes = set(_OF.findall(" ".join(t.word for t in tokens)))
        if len(sizes) == 1:  # "*sc in each dc to next corner, 3 sc in corner ch-2 sp"
            tokens = reworded(tokens, _corners(*sizes))
    if "ch" in said or "chain" in said:
        tokens = reworded(tokens, _RINGS)
    if "ch" in said and "-" in said:
        tokens = reworded(tokens, _HYPHENED)
    if "top" in said:
        tokens = reworded(tokens, _JOINED)
    return tokens
