"""Printed patterns, looped: sentences that say into which loops rounds are worked, all of them or some: "every round in BLO", "Rounds 3-5 are
worked in back loops only", "stitches in every other round are worked in front loops only"."""

from __future__ import annotations

import re
from collections.abc import Container
from dataclasses import dataclass
from typing import Final

from tambour.crochet.printed.tokens import Token
from tambour.crochet.words.numbers import NUMBER, number

FLO: Final = "flo"
BLO: Final = "blo"
LOOPS: Final = {"front loops": FLO, "back loops": BLO}
WHICH: Final = (
    "every other round is worked into one loop, and which of them is not said: those of even numbers are taken"
)
MOST: Final = 1000  # rounds
_WHOLE: Final = re.compile(r"\b(?:all|every|each|throughout|rest|remaining|rem|entire|whole|unless)\b")
_ROUNDS: Final = r"(?:round|row)s?"
_OTHER: Final = re.compile(
    rf"\b(?:(?:every|each) (?:other|second|2nd|alternate)|other|alternate|alternating)(?: [a-z]+)? {_ROUNDS}"
)
_EVEN: Final = re.compile(rf"\b(even|odd)(?:[ -]?number(?:ed)?)? {_ROUNDS}")
_LIST: Final = re.compile(
    rf"\b{_ROUNDS} ({NUMBER}(?: ?(?:,|-|–|—|and|to|through|thru|&|,? and) ?(?:{_ROUNDS} )?{NUMBER})*)"
)
_ON: Final = re.compile(
    rf"\b(from|with|at|after) (?:and including )?(?:the )?{_ROUNDS} ({NUMBER})(?! ?(?:to|through|thru|-|–|—) )"
)
_UPTO: Final = re.compile(rf"\b(?:until|till|up to|^to|before) (?:and including )?(?:the )?{_ROUNDS} ({NUMBER})")
_OF: Final = re.compile(rf"(?<!stitches )(?<!sts )\bof (?:the )?{_ROUNDS} \d|\bjoin\b")
"""Loops that a round left, which something else is worked into."""
_SAID: Final = re.compile(r"\b(?:are|is|work|worked|working|made|make|crochet|crocheted|done|unless)\b")
_SO: Final = frozenset(("it", "this", "that", "which", "so", "these", "gives", "makes"))
"""Words that say what comes of it."""
_WORKED: Final = re.compile(r"\b(?:work|worked|working|made|make|crochet|crocheted|done)\b")
_ONWARD: Final = re.compile(r"\b(?:on|onwards?|start|starting|begin|beginning|forward|after)\b")


@dataclass(frozen=True, slots=True)
class Loops:
    """``loop`` ("flo", "blo") is that which rounds ``which`` are worked into; ``own``: the text does not say of which it begins,
    so the rounds that name a loop themselves are meant where there are some."""

    loop: str
    which: Container[int] = range(MOST)
    own: bool = False


def rule(tokens: list[Token]) -> Loops | None:
    """What a sentence says of loops for rounds other than its own; None where it does not, or where the rounds are not named."""
    while tokens and tokens[-1].word in (".", "!"):
        tokens = tokens[:-1]
    comma = next((k for k, t in enumerate(tokens[:-1]) if t.word == "," and tokens[k + 1].word in _SO), len(tokens))
    tokens = tokens[:comma]  # "From row 2 everything BLO, it gives the stripes"
    keyed = [t for t in tokens if t.kind == "key" and t.value in LOOPS]
    if len(keyed) != 1:
        return None
    words = " ".join(str(t.value) if t.kind == "key" and t.value != "even" else t.word for t in tokens).lower()
    if _OF.search(words) or {":", "."} & set(words.split()) or not (keyed[0] is tokens[-1] or _SAID.search(words)):
        return None
    behind = tokens[tokens.index(keyed[0]) + 1 :][:1]
    if behind and behind[0].value in ("round", "row") and not _WORKED.search(words):
        return None  # "The front loops of Round 8 are waiting for you": those that are left, and nothing is said of how it is worked
    loop = LOOPS[keyed[0].value]
    if _OTHER.search(words):
        return Loops(loop, range(2, MOST, 2), True)
    if (said := _EVEN.search(words)) is not None:
        return Loops(loop, range(2 if said[1] == "even" else 1, MOST, 2))
    if (said := _ON.search(words)) is not None and (said[1] in ("from", "after") or _ONWARD.search(words)):
        return Loops(loop, range(number(said[2]) + (said[1] == "after"), MOST))
    if (said := _UPTO.search(words)) is not None:
        return Loops(loop, range(number(said[1]) + ("before" not in said[0])))
    if (said := _LIST.search(words)) is not None:
        return Loops(loop, _listed(said[1]))
    if re.search(r"\d", words) or not _WHOLE.search(words):
        return None
    return Loops(loop)


def _listed(words: str) -> frozenset[int]:
    """The numbers of "3-5, 7 and 9"."""
    made: set[int] = set()
    last, through = 0, False
    for word in re.findall(rf"{NUMBER}|-|–|—|\bto\b|\bthrough\b|\bthru\b", words):
        if not re.fullmatch(NUMBER, word):
            through = True
            continue
        one = min(number(word), MOST)
        made |= set(range(last + 1 if through else one, one + 1))
        last, through = one, False
    return frozenset(made)
