"""Definitions: new stitches from the seed's atomic moves and from stitches that are there already."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from tambour.core.errors import Span, did_you_mean
from tambour.crochet.language.source import Source
from tambour.crochet.language.stitches import BASIC, JOIN, MOVES, NEXT, OVER, RULES, THROUGH, Move, Stitch, standard

# A definition may use others before it, but its moves may not grow without end.
_MOST_MOVES = 200


def define(source: Source, tree: Any, span: Span) -> None:
    """A ``definition`` tree; the new stitch becomes known to ``source``, or what is wrong with it."""
    tokens = [t for t in tree.children if hasattr(t, "type")]
    name_token = next(t for t in tokens if t.type == "NAME")
    name, at = standard(name_token), source.span(name_token)
    height = next((float(t) for t in tokens if t.type == "NUMBER"), 0.0)
    if height > 10:
        source.error("a stitch is at most 10 single crochets high", "give a smaller height", at)
        return
    if name in RULES or name in BASIC or name in source.own or name in MOVES:
        source.error(f'"{name_token}" is there already', "give the new stitch its own name", at)
        return
    before = len(source.problems)
    moves = _moves(source, tree.children[-1], name, height)
    if any(not p.warning for p in source.problems[before:]):
        return
    if len(moves) > _MOST_MOVES:
        source.error(f"a stitch of {len(moves)} moves is too long", f"at most {_MOST_MOVES}", at)
        return
    if not any(m.what in (OVER, NEXT, JOIN) for m in moves):
        source.error("this stitch does nothing", "pull over makes it; next anchor goes on", at)
        return
    overs = [i for i, m in enumerate(moves) if m.what in (OVER, JOIN)]
    if any(m.what == THROUGH for m in moves[overs[-1] + 1 if overs else 0 :]):
        source.error("yarn is pulled through and left on the hook", "end with pull over", at)
        return
    source.stitches[name] = Stitch(name, moves)
    source.own[name] = span


def _moves(source: Source, tree: Any, own: str, height: float) -> tuple[Move, ...]:
    made: list[Move] = []
    for child in tree.children:
        if len(made) > _MOST_MOVES:
            break
        if child.data == "group":
            times = 1
            inner: tuple[Move, ...] = ()
            for part in child.children:
                kind = getattr(part, "type", None) or part.data
                if kind == "items":
                    inner = _moves(source, part, own, height)
                elif kind == "before":
                    times, _ = source.number(part.children[0])
                elif kind == "repeats" and part.children[0].type == "AROUND":
                    token = part.children[0]
                    at = source.span(token)
                    source.error("a stitch does not go around", "give the brackets a number", at)
                elif kind == "repeats":
                    many, at = source.number(part.children[1])
                    if times != 1:
                        source.error("two numbers for one pair of brackets", "keep one of the two", at)
                    times = many
            made += inner * min(times, _MOST_MOVES + 1)
            continue
        times, tokens = 1, []
        braces: Any = None
        for part in child.children:
            if getattr(part, "type", "") == "TIMES":
                continue
            if getattr(part, "data", "") == "one":
                braces = part
                continue
            if getattr(part, "type", "") == "AROUND":
                source.error("a stitch does not go around", "give it a number", source.span(part))
            elif part.data in ("before", "after"):
                times, _ = source.number(part.children[0])
            else:
                tokens = part.children
        if braces is not None:
            if any(hasattr(t, "type") for t in braces.children):
                source.error(
                    "a stitch begins no ring and seeks no space",
                    "leave the word before the braces out",
                    source.span(next(t for t in braces.children if hasattr(t, "type"))),
                )
                continue
            made += _moves(source, braces.children[-1], own, height) * min(times, _MOST_MOVES + 1)
            continue
        names = [t for t in tokens if getattr(t, "type", "") == "NAME"]
        at = source.span(names[0], names[-1])
        word = standard(" ".join(names))
        if len(names) != len(tokens):
            source.error("moves take no parentheses", "define name(height 2) sets the height", at)
        elif word in MOVES:
            move = MOVES[word]
            made += [replace(move, kind=own, height=height or 1.0) if move.what == OVER else move] * min(
                times, _MOST_MOVES + 1
            )
        elif word in source.stitches:
            moves = source.stitches[word].moves
            if height:
                moves = tuple(replace(m, height=height) if m.what == OVER else m for m in moves)
            made += moves * min(times, _MOST_MOVES + 1)
        else:
            known = ["pull through", "pull over", "next anchor", "join", *source.stitches]
            hint = did_you_mean(" ".join(names).lower(), known) or "pull through, pull over, next anchor, or a stitch"
            source.error(f'there is no move or stitch "{" ".join(names)}"', hint, at)
    return tuple(made)
