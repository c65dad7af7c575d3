"""Printed patterns, new yarn: the many words for taking another yarn ("cut white, tie on red", "on the last yo switch to red", "from here on use
red", "red for the rest"), put as most say it: "change to red"."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Final

from tambour.crochet.printed.tokens import Row
from tambour.crochet.printed.wordings.edges import placed, spoken
from tambour.crochet.printed.yarns.shades import shade
from tambour.crochet.words.sayings import Sayings

_STOP: Final = r"(?= ?[.!;,()\[\]=|]| - |$)"
_BEGINS: Final = r"(?:^|(?<=[.!;:,(\[|] )|(?<= - )|(?<=and )|(?<=then ))"
_THE: Final = r"(?:the |your |a |new )*"
_NOT: Final = r"(?!(?:for|on|in|at|with|to|into|during|yarn|the|and|last|again|around|from|of|as|by|until|till|now|then|sc|st|sts)\b)"
_COLOR: Final = r"(?:colou?r |yarn |contrast )?"


def _hue(name: str) -> str:
    return rf"{_THE}{_COLOR}(?P<{name}>{_NOT}[a-z]+(?: (?!only\b|alone\b){_NOT}[a-z]+)?|(?:(?<=color )|(?<=colour )|(?<=yarn ))[1-9])(?: yarn| colou?red yarn)?(?: only| alone)?"


def _ends(name: str) -> str:
    """Words for the end of a round, of the one with the number ``name``."""
    which = rf"(?:(?:the |this |each )?(?:last |final )?(?:rounds?|rnds?|rows?)(?: (?P<{name}>\d+))?|(?:the )?(?:last )?(?:st|stitch|sc))"
    last = r"last (?:yarn over|yo|yoh|pull through|pull - through|loop|loops|step|stitch|st|sc)"
    return rf"(?:at|on|in|with|for|to|during) (?:the )?(?:very )?(?:end(?: of {which})?|{last}(?: of {which.replace(name, name + 'l')})?)"


_OLD: Final = rf"(?:drop|leave|cut|cut off|break|break off|fasten off|let go of|end|snip|trim|tie off|finish off|carry) {_THE}(?:[a-z]+(?: (?!and\b|then\b)[a-z]+)?)(?: yarn)? ?(?:[,;&] ?)?(?:and )?(?:then )?"
_TURN_TO: Final = r"(?:chang\w+|switch\w*|swap\w*|go|going|mov\w+ on|return|returning)(?: over| back)?(?: (?:the |your )?(?:yarn|colou?rs?))? (?:to|for)"
_TAKE: Final = (
    r"(?:attach|tie on|tie in|join in|add in|add|bring in|bring back|introduce|pick up|picking up|take up|back to|start using|begin using|now use|"
    r"(?:the )?(?:rest|remainder)(?: of (?:the |this |it )?\w*)? is (?:all )?(?:worked|made|crocheted|done) (?:in|with|using)|"
    r"(?:now )?(?:continue|carry on|go on|proceed|keep going) (?:in|with|using)|now (?:in|with))"
)
_HERE: Final = r"from (?:here|now)(?: on| onwards?)?"
_FOR: Final = r"(?: for (?:the )?(?:next|following) \w+ (?:rounds?|rnds?|rows?)(?= ?[.!;]|$))?"
_TAKEN: Final = (
    rf"{_BEGINS}(?:(?:now|then|and|again) )*(?:(?:(?:{_OLD})?(?:{_TAKE}|{_TURN_TO})|{_OLD}join) {_hue('a')}(?: again)?{_FOR}"
    rf"|colou?r change (?:: |- |to )?{_hue('b')}|(?:chang\w+|switch\w*|new) colou?r [(:-] ?{_hue('c')}(?: [)])?"
    rf"|{_hue('d')} {_HERE}|{_HERE} ?,? (?:(?:use|work in|work with|with|in|using) )?{_hue('e')}){_STOP}"
)
_LAST: Final = (
    rf"{_BEGINS}(?:and )?(?:{_ends('n')} ?,? ?(?:{_OLD})?(?:{_TURN_TO}|join|attach) {_hue('a')}"
    rf"|(?:{_TURN_TO}|join|attach) {_hue('b')} ?,? ?{_ends('m')}"
    rf"|(?:finishing|finish|ending|end|completing|complete|closing) (?:the )?last (?:stitch|st|sc|round|rnd|loop|yo) (?:with|in) {_hue('c')}){_STOP}"
)
_REST: Final = rf"{_BEGINS}(?:and )?(?:the )?(?:remaining|rest of the|other|rest)(?: (?:sts?|stitches|sc))? (?:in|with) {_hue('a')}{_STOP}"
_ROUNDS: Final = rf"^(?P<lead>(?:next|work|crochet|sc) (?P<n>\w+) (?:more )?(?:rounds?|rnds?|rows?)(?: (?:even|plain|straight))?) (?:in|with|using) {_hue('a')}(?P<behind> ?[.:(\[,]|$)"
_YARNS: Final = Sayings(((_LAST, "last"), (_TAKEN, "taken"), (_REST, "rest"), (_ROUNDS, "rounds")))
_NAMED: Final = ("color", "colour", "yarn", "contrast")
_LOOKED: Final = frozenset(
    "end last cut break drop fasten attach tie join add bring introduce pick take back use start begin now continue carry go proceed keep work change changing "
    "switch switching swap swapping color colour from finishing finish ending completing complete remaining rest other next crochet sc return leave".split()
)


def respun(rows: list[Row]) -> list[Row]:
    """``rows`` with such words as most others have them."""
    return [_row(row) if not _LOOKED.isdisjoint({t.word for t in row.tokens}) else row for row in rows]


def _row(row: Row) -> Row:
    words = " ".join([t.word for t in row.tokens])
    k = _YARNS.next(words)
    while k < _YARNS.n:
        (said, kind), at = _YARNS[k], 0
        while (found := said.search(words, at)) is not None:
            row, at = _put(row, kind, found)
            words = " ".join([t.word for t in row.tokens])
        k = _YARNS.next(words, k + 1)
    return row


def _put(row: Row, kind: str, found: re.Match[str]) -> tuple[Row, int]:
    """``row`` with what was found as most say it, and from which of its letters on to look for more."""
    said = found.groupdict()
    name = next(n for n in "abcde" if said.get(n))
    tokens = row.tokens
    c, d = placed(tokens, *found.span(name))
    letter = d == c + 1 and tokens[c].capital and (len(said[name]) == 1 or said[name] in ("mc", "cc"))
    if not (letter or said[name].isdigit() or shade(said[name]) is not None):
        return row, found.end()
    a, b = placed(tokens, *found.span())
    if letter and tokens[a].word == "pick" and a and tokens[a - 1].word == ":":
        return row, found.end()  # "4th rnd: Pick up A." is read as it stands
    first, last = tokens[a], tokens[b - 1]
    yarn = tokens[c - 1 : d] if c and tokens[c - 1].word in _NAMED else tokens[c:d]
    if kind == "rest":
        made = [*spoken("with", first, first), *yarn, *spoken(", sc around", last, last)]
    elif kind == "rounds":
        behind = said["behind"].strip()
        number = placed(tokens, *found.span("n"))[0]
        lead = [*spoken("next", first, first), *tokens[number : number + 1], *spoken("rounds : with", first, first)]
        made = [*lead, *yarn, *spoken("," if behind == ":" else ", even", last, last)]
        made += tokens[b - 1 : b] if behind and behind != ":" else []
    else:
        number_said = next((said[k] for k in ("n", "nl", "m", "ml") if said.get(k)), "")
        ends = f"at end of rnd {number_said}" if number_said else "in last st" if kind == "last" else ""
        made = [*spoken("change to", first, first), *yarn, *spoken(ends, last, last)]
    made[0] = replace(made[0], capital=first.capital)
    tokens = [*tokens[:a], *made, *tokens[b:]]
    return replace(row, tokens=tokens), len(" ".join(t.word for t in [*tokens[: a + len(made)]]))
