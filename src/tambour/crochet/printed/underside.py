"""Printed patterns, underside: the many ways to say that a round goes on along the other side of its chain, put as one."""

from __future__ import annotations

from typing import Final

from tambour.crochet.printed.tokens import Token

_LEADS: Final = frozenset(
    "turn rotate flip spin continue continuing carry carrying go going move moving work working keep now then on along down around round up the "
    "your and to so that you can back piece it other again yarn over into in not do without turning rotating in-the-round 180 degrees clockwise".split()
)  # fmt: skip
_SIDES: Final = frozenset("other opposite bottom underside under lower free unused remaining back backside reverse second".split())
_CHAINS: Final = frozenset("chain chains foundation starting beginning initial base original first side loops loop edge".split())
_STOPS: Final = (",", ".", ";", ":", "-", "(", "[", "*")
_LONGEST: Final = 22


def plainly_put(tokens: list[Token]) -> list[Token]:
    """``tokens`` with "turn the work and carry on along the bottom of the chain:" as "other side,"."""
    made: list[Token] = []
    at = 0
    while at < len(tokens):
        begins = not at or tokens[at - 1].word in _STOPS or tokens[at - 1].value == "and" or tokens[at - 1].kind == "number"
        end = _other(tokens, at) if begins else at
        if end > at:
            first, last = tokens[at], tokens[end - 1]
            made += [
                Token("key", "other side", first.start, last.end, "side", first.glued, first.capital),
                Token("mark", ",", last.end, last.end),
            ]
            at = end + (end < len(tokens) and tokens[end].word in (",", ":", "-"))
            continue
        made.append(tokens[at])
        at += 1
    return made


def _other(tokens: list[Token], at: int) -> int:
    """Where words end that begin at ``at`` and say that the work goes on along the other side of the chain; ``at`` where they do not."""
    side = chain = False
    end = at
    while end < len(tokens) and end - at < _LONGEST:
        token = tokens[end]
        words = token.word.split(" ")
        if token.kind == "number" and token.value == 180:
            pass
        elif token.kind in ("number", "ordinal") or token.word in _STOPS:
            break
        elif token.value == "side":
            side, chain = True, True
        elif token.kind == "stitch":
            if token.value != "ch":
                break
            chain = True
        elif any(w in _SIDES for w in words):
            side = True
            chain = chain or any(w in _CHAINS and w != "back" for w in words)
        elif token.value == "foundation" or any(w in ("chain", "chains", "foundation") for w in words):
            chain = True
        elif not (all(w in _LEADS or w in _CHAINS for w in words) or token.kind == "key" and token.value in ("in", "around", "turn", "begin", "loop", "of")):
            return at
        end += 1
    if end < len(tokens) and tokens[end].kind == "ordinal":
        return at
    moves = any(w in ("turn", "rotate", "flip", "continue", "continuing", "carry", "go", "working", "work", "keep", "spin") for t in tokens[at:end] for w in t.word.split(" "))
    plain = end - at <= 2 and any(t.value == "side" for t in tokens[at:end])
    return end if side and chain and moves and not plain else at
