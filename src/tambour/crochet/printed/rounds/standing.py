"""Printed patterns, standing: chains that count as a stitch, or as a stitch and a space, and those that only lift the yarn."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from tambour.crochet.graph.hook import LIFT
from tambour.crochet.language.stitches import STANDING
from tambour.crochet.language.tree import Action, Item
from tambour.crochet.printed.cursor import Cursor
from tambour.crochet.printed.rounds.counts import makes
from tambour.crochet.printed.rounds.reader import Reader
from tambour.crochet.printed.tokens import Token

CHAINS_OF: Final = {int(name[2]): name for name in STANDING if name[2] != "1"}
_COUNTED: Final = {int(name[2]): name for name in STANDING}
"""So many chains → what they count as, where a text says so: also one, for a single crochet."""

_CLAUSE: Final = 14  # tokens


def passed_over(c: Cursor) -> bool | None:
    """Goes past "(3 skipped ch count as first dc)" and gives whether they count; None, the cursor unmoved, where that is not said."""
    end = next((k for k in range(c.at, min(c.at + 12, len(c.tokens))) if c.tokens[k].word in (")", "]")), c.at)
    said = [t.value for t in c.tokens[c.at : end] if t.kind == "key"]
    if not c.mark("(", "[") or "count" not in said:
        return None
    c.at = end + 1
    return "not" not in said


def stood(r: Reader, found: list[Item]) -> bool:
    """Takes chains at a round's beginning that the first stitch is skipped for as that stitch, where all others are worked: "Ch 2,
    skip first sc, hdc in each sc around"; whether they are."""
    last, c = found[-1], r.c
    said = c.tokens[c.at : next((k for k in range(c.at + 1, len(c.tokens)) if c.tokens[k].word in (".", ";")), None)]
    if not any(t.kind == "key" and t.value == "each" for t in said[:8]):
        return False
    if not (isinstance(last, Action) and last.name == "ch" and last.times in CHAINS_OF) or any(map(makes, found)):
        return False
    found[-1] = Action(CHAINS_OF[last.times], last.span)
    return True


def turned(r: Reader, found: list[Item], turn: Action) -> None:
    """Adds a turn, before the chains just read where a row rises by them, "Ch 3, turn, skip first dc": it turns, and then they lift it."""
    last = found[-1] if found else None
    lifts = isinstance(last, Action) and (stands(last) or (last.name == "ch" and last.times <= LIFT))
    ahead = r.c.tokens[r.c.at :]
    worked_in = any(t.kind == "key" and t.value == "hook" for t in ahead[:_CLAUSE])
    rises = lifts and not worked_in and r.edge is not None and any(t.kind == "stitch" for t in ahead)
    rises = rises and not any(map(makes, found[:-1]))
    found.insert(len(found) - rises, turn)


def standing_last(found: list[Item]) -> bool:
    """Whether items end with chains that count as a stitch, or as a stitch and chains."""
    last = found[-1]
    more = isinstance(last, Action) and last.name == "ch" and len(found) > 1
    return stands(last) or (more and stands(found[-2]))


def stands(item: Item) -> bool:
    """Whether an item is chains that count as a stitch."""
    return isinstance(item, Action) and item.name in STANDING


def spaced(r: Reader, found: list[Item], number: Token | None, token: Token) -> bool:
    """Takes so many chains for a stitch and a space, where the text says it of all of them."""
    many = number.value if number is not None and isinstance(number.value, int) else 0
    space = r.spaced.get(many, 0)
    name = _COUNTED.get(many - space)
    if not space or name is None or r.c.mark("(", "["):
        return False
    found += [Action(name, token.span), Action("ch", token.span, space)]
    return True


def slipped_back(found: list[Item]) -> bool:
    """Takes the last of slip stitches at a row's beginning back, since a stitch goes into the same place; whether there is one."""
    at = len(found) - 1
    while at >= 0 and isinstance(found[at], Action) and found[at].name in ("ch", "flo", "blo", "color"):  # type: ignore[union-attr]
        at -= 1
    last = found[at] if 0 <= at < len(found) - 1 else None
    if not isinstance(last, Action) or last.name != "slst" or any(map(makes, found)):
        return False
    found[at : at + 1] = [replace(last, times=last.times - 1)] if last.times > 1 else []
    return True


def may_stand(r: Reader, number: Token | None) -> bool:
    """Whether so many chains may count as a stitch, and nothing says that they do not."""
    c = r.c
    if number is None or number.value not in CHAINS_OF or c.look() is None:
        return False
    said = c.tokens[c.at : c.at + 8]
    if r.edge is None and any(t.value == "hook" for t in c.tokens[c.at : c.at + 14]):
        return False  # "ch 4, 15 dc in 4th ch from hook": what the piece begins with
    return not (c.mark("(", "[") and any(t.kind == "key" and t.value in ("not", "count") for t in said))


def topped(r: Reader, chains: int) -> bool:
    """Whether the round under way is joined to the top of the ``chains`` that it begins with, which are a stitch then: "join with sl st in
    top of beginning ch"."""
    founds = any(t.value in ("join", "slst") for t in r.c.tokens[r.c.at : r.c.at + 3])  # "ch 4, join"
    return r.edge is not None and not founds and to_top(r, (chains,))


def to_top(r: Reader, chains: tuple[int, ...]) -> bool:
    """Whether what is read is joined to the top of its beginning chains, of so many where their number is said."""
    tokens = r.c.tokens
    top = next((k for k in range(r.c.at, len(tokens)) if tokens[k].word == "top"), None)
    if top is None or not any(t.value in ("join", "slst") for t in tokens[max(r.c.at, top - 8) : top]):
        return False
    chain = next(
        (k for k in range(top + 1, min(top + 5, len(tokens))) if tokens[k].value in ("ch", "foundation")), None
    )
    if chain is None:
        return False
    said = [t for t in tokens[chain + 1 : chain + 3] if t.word != "-"][:1]  # "ch 3", "ch-3"
    return not said or said[0].kind != "number" or said[0].value in chains


def standing(found: list[Item]) -> None:
    """Chains at the end of ``found`` that count as a stitch become it."""
    last = found[-1] if found else None
    if isinstance(last, Action) and last.name == "ch":
        name = next((s for s, kind in STANDING.items() if s.startswith(f"ch{last.times}")), None)
        if name is not None:
            found[-1] = Action(name, last.span)
