"""Printed patterns, the doings: what hands do that makes no stitch: markers, stuffing, tails, wraps of yarn, a sheet of felt."""

from __future__ import annotations

from typing import Final

from tambour.crochet.printed.cursor import Cursor
from tambour.crochet.printed.tokens import Token

BETWEEN: Final = frozenset(",;:.-/+!&~|><·")
"""Marks that only stand between clauses."""

# Whatever such a sentence names, it makes no stitch.
_DOING: Final = frozenset(
    [
        "pull",
        "tighten",
        "thread",
        "draw",
        "insert",
        "trim",
        "adjust",
        "keep",
        "remove",
        "replace",
        "place",
        "move",
        "slide",
        "see",
        "refer",
        "shape",
    ]
)
# Such a one makes none where it says nothing of how stitches are worked.
_HANDS: Final = frozenset(
    [
        "align",
        "apply",
        "backstitch",
        "block",
        "braid",
        "brush",
        "centre",
        "center",
        "coil",
        "comb",
        "cut",
        "dab",
        "divide",
        "drape",
        "dry",
        "fill",
        "fluff",
        "flatten",
        "fold",
        "gather",
        "glue",
        "grasp",
        "hang",
        "hide",
        "hold",
        "iron",
        "knot",
        "lay",
        "line",
        "load",
        "lock",
        "loop",
        "measure",
        "paint",
        "pad",
        "pin",
        "poke",
        "position",
        "press",
        "push",
        "reshape",
        "roll",
        "rub",
        "secure",
        "separate",
        "shake",
        "slip",
        "smooth",
        "soak",
        "space",
        "spray",
        "spread",
        "squeeze",
        "steam",
        "stretch",
        "tape",
        "tie",
        "tuck",
        "twist",
        "unravel",
        "untwist",
        "untie",
        "wash",
        "weave",
        "wet",
        "whipstitch",
        "wind",
        "wire",
        "wrap",
        "define",
    ]
)
_MADE: Final = frozenset(
    [
        "pompom",
        "pompon",
        "pompoms",
        "pompons",
        "tassel",
        "tassels",
        "fringe",
        "braid",
        "braids",
        "bow",
        "knot",
        "bundle",
        "bundles",
        "cord",
        "pom",
    ]
)
_LEAD: Final = frozenset(
    [
        "then",
        "next",
        "lightly",
        "firmly",
        "gently",
        "carefully",
        "tightly",
        "loosely",
        "finally",
        "now",
        "also",
        "twice",
        "evenly",
    ]
)
_TIGHT: Final = frozenset(
    ["tight", "tightly", "close", "closed", "remaining", "rem", "final", "last", "secure", "gather"]
)
_DONE: Final = ("marker", "stuff", "eyes")
_NOT: Final = ("join", "turn", "stuff", "color", "marker", "begin", "fasten off")
_YARN: Final = frozenset(("break", "carry", "drop", "cut"))


def doing(c: Cursor) -> bool:
    """Whether the sentence at the cursor is something that hands do and that makes no stitch: a marker, stuffing, a tail."""
    first = c.look()
    while first is not None and first.kind == "mark" and first.word in BETWEEN:
        c.at += 1
        first = c.look()
    if first is None:
        return False
    if c.key("marker") and _and_stitches(c):
        return False
    if c.key(*_DONE) or (c.key("not") and c.key(*_NOT, ahead=1)):
        return True
    if c.key("not") and (after := c.look(1)) is not None and after.word in _YARN:
        return True  # "Do not carry or break C"
    lead = 1 + ((second := c.look(1)) is not None and second.word in _LEAD)  # "Begin firmly stuffing head"
    if c.key("begin", "leave", "close") and c.key("stuff", ahead=lead):
        return True
    if first.kind != "word" or first.word not in _DOING:
        return False
    return not _pulls(first, c.look(1))


def by_hand(tokens: list[Token]) -> bool:
    """Whether a sentence between the rounds is such a doing: it begins with what hands do, and works no stitch."""
    at = 0
    while at < len(tokens) and (tokens[at].word in _LEAD or tokens[at].kind == "mark"):
        at += 1
    if at < len(tokens) and _beginning(tokens[at]):  # "Using a strand of D, tie …", "With wrong sides facing, fold …"
        at = next((k + 1 for k in range(at, len(tokens)) if tokens[k].word in (",", ":")), len(tokens))
    headed = next((k for k, t in enumerate(tokens[:5]) if t.word == ":"), 0)
    if at == 0 and headed and headed + 1 < len(tokens) and tokens[0].capital and tokens[headed + 1].kind == "word":
        at = headed + 1  # "Finishing Body: Fold last row in half"
    if at >= len(tokens) or len(tokens) < 2:
        return False
    if any(t.word == "cut" for t in tokens) and not any(works(tokens, k) for k in range(len(tokens))):
        return True  # "White - Cut 2"
    if tokens[at].word in _YARN and not any(t.kind == "key" and t.value == "join" for t in tokens):
        return not any(works(tokens, k) for k in range(at, len(tokens)))  # "Break A"
    first = tokens[at]
    if _pulls(first, tokens[at + 1] if at + 1 < len(tokens) else None):
        return False
    verb = first.word.split(" ")[0]
    crafted = first.kind == "key" and first.value == "make" and any(t.word in _MADE for t in tokens)
    plain = first.kind == "word" or (first.kind == "key" and first.value in ("make", "leave") and first.word != "make")
    if not crafted and not (plain and (verb in _HANDS or verb in _DOING)):
        return False
    return not any(works(tokens, k) for k in range(at, len(tokens)))


def _beginning(token: Token) -> bool:
    return (token.kind == "key" and token.value in ("with", "over", "for", "in", "as")) or token.word in (
        "once",
        "while",
        "when",
        "if",
        "after",
        "before",
        "holding",
    )


def _pulls(first: Token, after: Token | None) -> bool:
    """Whether words begin a stitch: "draw up a loop"."""
    return first.word in ("draw", "pull", "insert") and after is not None and after.word in ("loop", "loops", "hook")


def works(tokens: list[Token], at: int) -> bool:
    """Whether the token at ``at`` is a stitch that is worked, and not one that is only named ("the last sc", "the foundation ch")."""
    token = tokens[at]
    if token.kind != "stitch":
        return False
    before = tokens[at - 1] if at else None
    after = tokens[at + 1] if at + 1 < len(tokens) else None
    named = before is not None and (
        before.kind == "ordinal"
        or before.word in ("loop", "stitch")
        or (
            before.kind == "key"
            and before.value in ("last", "next", "same", "foundation", "each", "begin", "in", "from", "rest")
        )
    )
    placed = after is not None and after.kind == "key" and after.value in ("in", "around", "each", "next", "over")
    return placed or not named


def drawn_tight(tokens: list[Token]) -> bool:
    """Whether a doing draws the last round together."""
    words = {t.word for t in tokens}
    return bool(words & _TIGHT and words & {"pull", "draw", "close", "thread", "cinch", "weave"})


def _and_stitches(c: Cursor) -> bool:
    """Whether stitches stand behind a comma of the sentence at the cursor: "place marker fork, 9 sc"."""
    ahead = 1
    while (token := c.look(ahead)) is not None and not c.mark(".", ";", ahead=ahead):
        after = c.look(ahead + 1)
        if token.word == "," and after is not None and after.kind in ("number", "stitch"):
            return True
        ahead += 1
    return False
