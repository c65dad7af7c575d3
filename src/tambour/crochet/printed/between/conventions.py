"""Printed patterns, conventions: sentences that say how all of a text, or of a part, is meant, and work nothing themselves."""

from __future__ import annotations

import re
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.language.tree import Action, Line
from tambour.crochet.printed.between.lines import turning
from tambour.crochet.printed.between.remarks import yarned
from tambour.crochet.printed.cursor import Cursor
from tambour.crochet.printed.parts.looped import LOOPS, MOST, Loops, rule
from tambour.crochet.printed.rounds.doings import works
from tambour.crochet.printed.state import State
from tambour.crochet.printed.tokens import Token

_COURSE: Final = frozenset(
    "spiral spirals continuous continuously joined worked rounds rnds rows seam seamless".split()
)
_BARE: Final = 3  # words of "Work in back loops only", said before the first round

_LED: Final = re.compile(r"(?:^|[.;:!?(]|\n[ \t]*\n)[^.;:!?()]*$")
_TURN: Final = re.compile(r"\bturn(?:s|ed|ing)?\b", re.IGNORECASE)
_CHAIN: Final = re.compile(r"\b(?:chains?|ch)\b|\bch-?[123]\b", re.IGNORECASE)
_ALWAYS: Final = re.compile(
    r"\b(?:each|every|all|always|any)\b|\brows (?:are|end|begin|start)\b|\b(?:after|end of|ends? of|start of|beginning of) (?:a|the|your) rows?\b|\bbetween rows\b",
    re.IGNORECASE,
)
_UNCOUNTED: Final = re.compile(
    r"\b(?:turning (?:chains?|ch)|ch(?:ain)?[ -]?[123]|chains? at the (?:start|beginning|end)[\w ]*)\b[^.;]{0,40}\b(?:not|never|n't|no|isn['’]t|doesn['’]t|aren['’]t)\b[^.;]{0,20}\b(?:count\w*|stitch(?:es)?|sts?)\b",
    re.IGNORECASE,
)
_STRANGE: Final = re.compile(
    r"\b(?:sc|dc|hdc|tr|inc|dec|slst|rows? \d(?! ch\b)|r\d+|repeat|rep|from hook|next|first|skip|last)\b|[4-9]|\d\d",
    re.IGNORECASE,
)
_RULE: Final = 160  # letters of such a sentence


def turned_always(text: str, tokens: list[Token]) -> bool:
    """Whether a sentence, small words and all, only says how rows turn, or that the chains of turning are no stitches: "Ch 1 and turn at the end
    of every row", "the turning chain does not count as a stitch"."""
    led = _LED.search(text, max(0, tokens[0].start - _RULE), tokens[0].start)
    begin = tokens[0].start if led is None else led.start() + (text[led.start()] in ".;:!?(")
    ended = re.compile(r"[.;!?]|\n[ \t]*\n").search(text, tokens[-1].end)
    words = " ".join(text[begin : ended.start() if ended is not None else len(text)].split())
    if len(words) > _RULE or _STRANGE.search(words):
        return False
    rule = _TURN.search(words) and _CHAIN.search(words) and _ALWAYS.search(words) and "row" in words.lower()
    return bool(rule or _UNCOUNTED.search(words))


def convention(p: State, tokens: list[Token]) -> bool:
    """Whether a sentence is one of these: chains that count or do not, rounds that are all joined, work that goes on in a
    spiral, how colours are changed, loops that all of a part is worked into. Whether chains count, which loops are meant, and a
    colour that such a sentence names are remembered."""
    tokens = _said(tokens)
    if not tokens or any(t.word == "=" for t in tokens):
        return False
    if turning(tokens):
        return True
    words = {t.word for t in tokens}
    keys = {t.value for t in tokens if t.kind == "key"}
    looped = _looped(tokens)
    if not p.parts and p.heading is None and looped is not None and "round" in keys:
        p.always = looped  # "Every round here is worked in the back loop only"
        return True
    if p.mode in ("materials", "abbreviations"):
        return False
    if "count" in keys and any(t.kind == "stitch" and t.value == "ch" for t in tokens[:3]):
        many = next((t.value for t in tokens[:4] if t.kind == "number"), 0)
        if isinstance(many, int) and many:
            p.source.standing[many] = "not" not in keys
            return True
    first = tokens[0]
    if (
        first.word == "to"
        and len(tokens) > 1
        and (tokens[1].word in ("change", "color", "colour") or tokens[1].value == "color")
    ):
        return True  # "To change color, work to last 2 loops on hook …"
    every = {"each", "all"} & keys or {"all", "every"} & words
    if every and "round" in keys and "join" in keys and not any(t.kind == "number" for t in tokens):
        return True  # "Join all rnds with sl st to first sc"
    plain = not any(works(tokens, k) for k in range(len(tokens))) and not any(
        t.kind == "number" or (t.kind == "ordinal" and t.word[0].isdigit()) for t in tokens
    )
    loop = next((LOOPS[t.value] for t in tokens if t.kind == "key" and t.value in LOOPS), None)
    if loop is not None:
        ahead = p.heading is not None or not p.parts or not p.parts[-1].last  # before the first round of a part
        if plain and looped is None and len(tokens) <= _BARE and ahead and not p.palette.pure:
            looped = Loops(loop)
        return looped is not None and _throughout(p, looped)
    if plain and words & _COURSE and ("round" in keys or "row" in keys or {"spiral", "spirals"} & words):
        said = not {"repeat", "as", "same"} & keys or ("as" in keys and "follows" in words)
    else:
        said = plain and "follows" in words and not keys & {"repeat"}
    if said and not _dyed(p, tokens) and yarned(tokens):
        return False  # "Every other round is worked in B"
    return said


def in_loops(p: State, tokens: list[Token]) -> bool:
    """Remembers what a sentence that begins with rounds' numbers says of their loops, "Rounds 3-5 are worked in BLO"; whether it does."""
    looped = _looped(tokens)
    return looped is not None and _throughout(p, looped)


def _looped(tokens: list[Token]) -> Loops | None:
    """The rule for loops that a sentence says, which works nothing itself."""
    named = any(t.kind == "key" and t.value in LOOPS for t in tokens)
    return rule(tokens) if named and not any(works(tokens, k) for k in range(len(tokens))) else None


def _throughout(p: State, loops: Loops) -> bool:
    """Remembers the loops that the rest of a part is worked into."""
    if p.heading is not None or not p.parts:
        p.early["loops"] = loops
    elif all(n not in loops.which for n in range(p.parts[-1].last + 1, MOST)):
        return False  # of rounds that stand before it
    else:
        p.parts[-1].loops = loops
    return True


def _dyed(p: State, tokens: list[Token]) -> bool:
    """Takes the colour of "With A, create a magic ring, and work in unjoined rounds as follows"; whether one is said."""
    for k, token in enumerate(tokens[:-1]):
        if token.kind == "key" and token.value in ("with", "color", "in"):
            c = Cursor(tokens, k + 1)
            hue = p.palette.color(c) or (p.palette.letter(c, k + 1) if token.value != "in" else None)
            if hue is not None:
                span = Span(tokens[k + 1].start, tokens[k + hue[1]].end)
                p.lead.append(Line((Action("color", span, numbers=hue[0]),), span, False))
                return True
    return False


def _said(tokens: list[Token]) -> list[Token]:
    """A sentence without the dot of a list or "Note:" before it."""
    while tokens and tokens[0].word in ("•", "*", "-"):
        tokens = tokens[1:]
    if len(tokens) > 2 and tokens[0].kind == "key" and tokens[0].value == "notes" and tokens[1].word in (":", "-"):
        return tokens[2:]
    return tokens
