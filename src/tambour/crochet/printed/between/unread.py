"""Printed patterns, unread: which of the sentences that no reading understands are told, since they may instruct."""

from __future__ import annotations

import re
from itertools import pairwise
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.printed.between.opening import founds
from tambour.crochet.printed.between.remarks import remark, yarned
from tambour.crochet.printed.between.stops import starts
from tambour.crochet.printed.state import State
from tambour.crochet.printed.tokens import Token

NOT_UNDERSTOOD: Final = "this looks like instructions, and was not understood"
_AS_ROUNDS: Final = "say it as in the other rounds, or leave it out"
_AS_PLACED: Final = "say which part goes where, with a round and a side, or leave it as it is: the booklet keeps it"
_AS_SAID: Final = "say it in simpler words, or leave it as it is: the booklet keeps it"
_OTHERWISE: Final = frozenset("reverse reversing reversed mirror mirrored mirroring alternate alternating".split())
_CHANGES: Final = frozenset("change changes changing alternate switch".split())


_MORE: Final = re.compile(
    r"\b(?:(?:other|second|2nd) one|one more)\b(?!\s+(?:is|was|thing|time|round|row|step|tip))", re.IGNORECASE
)
_ONCE: Final = re.compile(r"\W*(?:and |then )*(?:once (?:more|again)|one more time|again)\W*", re.IGNORECASE)
_AGAIN: Final = re.compile(
    r"\b(?:switch|change|swap|alternate|changing|switching|swapping) (?:the |your )?(?:yarns?|colou?rs?|threads?)\b"
    r"|\b(?:to|in|with) the (?:first|second|other|main|old|new) (?:yarn|colou?r)\b|\bdivid\w+ (?:the |your )?(?:work|piece|round|body|stitches)\b"
    r"|\bcrochet (?:the |both |these )*(?:\w+ )?(?:opening|edges?|pieces?|sides|halves|layers|hole) (?:together|shut|closed)\b",
    re.IGNORECASE,
)
"""Words that have the work done otherwise, though they name no stitch, number or yarn."""
_BRIEF: Final = 5  # tokens of a colour that stands alone above the first round: "[All in Red]"


def first_round(tokens: list[Token]) -> bool:
    """Whether words begin as a round does whose number stands before its name: "1 row: 6 sc"."""
    numbered = len(tokens) > 3 and tokens[0].kind in ("number", "ordinal")
    return numbered and any(t.kind == "key" and t.value in ("round", "row") for t in tokens[1:4])


def instructs(p: State, tokens: list[Token]) -> bool:
    """Whether a sentence that was not read may instruct: it holds a number, a stitch, a repeat, a reference or a colour."""
    if p.mode in ("materials", "abbreviations") and not (first_round(tokens) and not p.parts):
        return False
    stitches = any(t.kind == "stitch" for t in tokens)
    worked = stitches or any(t.kind == "key" and t.value in ("stitch", "round", "row") for t in tokens)
    numbers = any(
        t.kind in ("number", "ordinal") and (t.word[0].isdigit() or (worked and t.kind == "number" and t.value != 1))
        for t in tokens
    )
    if tokens[0].value == "make" and any(t.kind == "ordinal" for t in tokens[1:4]):
        return bool(p.parts)  # "Make the second leg and do not cut the yarn"
    explains = any(t.word == "=" for t in tokens)
    named = any(a.value in ("round", "row") and b.kind == "number" for a, b in pairwise(tokens))
    rings = any(t.kind == "key" and t.value == "ring" for t in tokens) and numbers
    if not p.parts and not explains and (named or rings) and stitches and p.mode != "notes":
        return True  # "Make the head and body.Rnd 1 - With CC, 6sc in MR"
    if not p.parts and p.heading is None and not explains and (founds(p, near=2) or first_round(tokens)):
        dyed = any(p.palette.name(t.word) for t in tokens if t.kind == "word")
        led = any(t.kind == "key" and t.value in ("in", "with", "begin", "color") for t in tokens)
        return (stitches and numbers) or first_round(tokens) or (dyed and led and len(tokens) <= _BRIEF)
    if not p.parts:  # of what stands below the first part's name; above it is the introduction
        begins = any(
            t.kind == "key" and t.value in ("ring", "loop", "hook", "begin") for t in tokens
        )  # "With B, make a ring"
        told = (worked and numbers) or (yarned(tokens) and not begins)
        return p.heading is not None and p.mode == "" and told
    repeats = any(t.kind == "key" and t.value in ("repeat", "same", "as", "twice") and t.word != "like" for t in tokens)
    if p.parts and otherwise(p, tokens):
        return True
    if len(tokens) <= _BRIEF and _MORE.search(p.source.text.text, tokens[0].start, tokens[-1].end):
        return True
    if p.mode == "notes":
        return stitches and numbers and not p.advised
    places = any(t.kind == "key" and t.value in ("next", "around", "skip", "front loops", "back loops") for t in tokens)
    if stitches or numbers or repeats or places or any(t.word in _OTHERWISE for t in tokens):
        return True
    changes = any(t.kind == "key" and t.value == "color" for t in tokens) and any(
        w in _CHANGES for t in tokens for w in t.word.split()
    )
    return changes or any(p.palette.name(t.word) for t in tokens if t.kind == "word") or yarned(tokens)


def otherwise(p: State, tokens: list[Token]) -> bool:
    """Whether a sentence has the work done otherwise from there on: "Switch yarns", "Divide the work"."""
    text = p.source.text.text
    said = text[starts(text, tokens[0].start) : tokens[-1].end]
    return (_ONCE.fullmatch(said) or _AGAIN.search(said)) is not None


def left_over(p: State, tokens: list[Token]) -> None:
    """A sentence that was not read: told when it may instruct."""
    gauge = p.hinted.get("gauge")
    if gauge is not None and gauge[1].start <= tokens[0].start < gauge[1].end:
        return
    if instructs(p, tokens):
        span = Span(tokens[0].start, tokens[-1].end)
        if remark(p.source.text.text, tokens):
            p.passed.append(span)
            return
        if p.parts and p.mode != "assembly" and any(t.kind == "stitch" for t in tokens):
            p.parts[-1].sure = False
        worked = any(t.kind == "stitch" for t in tokens) and p.mode != "assembly"
        p.tell(NOT_UNDERSTOOD, _AS_ROUNDS if worked else _AS_PLACED if p.mode == "assembly" else _AS_SAID, span)
    elif p.parts:
        p.passed.append(Span(tokens[0].start, tokens[-1].end))
