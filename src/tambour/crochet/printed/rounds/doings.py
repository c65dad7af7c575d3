"""Printed patterns, the doings: what hands do that makes no stitch: markers, stuffing, tails, wraps of yarn, a sheet of felt."""

from __future__ import annotations

import re
from typing import Final

from tambour.crochet.printed.cursor import Cursor
from tambour.crochet.printed.tokens import Token

BETWEEN: Final = frozenset(",;:.-/+!&~|><·")
"""Marks that only stand between clauses."""

# Whatever such a sentence names, it makes no stitch.
_DOING: Final = frozenset(
    ("adjust draw insert keep move place pull refer remove replace see shape slide thread tighten trim").split()
)
# Such a one makes none where it says nothing of how stitches are worked.
_HANDS: Final = frozenset(
    (
        "align apply arrange assemble backstitch block braid brush button catch center centre clip coil colour comb count criss cross "
        "crumple curl cut dab define dip divide drape draw dry embellish fill finger flatten flip fluff fold gather glue grasp hang heat "
        "hide hold imagine iron knot lay line load lock loop make mark match measure melt pad paint pin poke position press push put reshape "
        "roll rub run scatter seam secure separate sew shake shave sketch slide slip smooth snip soak space spray spread sprinkle squeeze "
        "stand steam stick straighten stretch string style tack take tape tease tie tint trace try tuck turn twirl twist unravel untie untwist "
        "wash weave wet whipstitch wiggle wind wire wrap"
    ).split()
)
_MADE: Final = frozenset(
    (
        "bow braid braids bunch copy bundle bundles cord fringe hank hanks knot pom pompom pompoms pompon pompons tassel tassels tuft tufts"
    ).split()
)
_STILL: Final = frozenset(("braiding gluing knotting threading tying winding wrapping").split())
"""What hands go on doing: "Repeat with a strand of D, wrapping around cardboard 24 times"."""
_LEAD: Final = frozenset(
    (
        "again also carefully evenly finally firmly first gently here lightly loosely next now once optional then tightly twice"
    ).split()
)
_TIGHT: Final = frozenset(("close closed final gather last rem remaining secure tight tightly").split())
_BEGUN: Final = frozenset(
    "center centre ring loop mr mc beginning slightly".split()
)  # the other end is drawn tight, or this one not quite
_BEFORE: Final = frozenset("once while when if after before holding starting beginning referring using".split())
_STRANDS: Final = frozenset("strand strands fringe ends".split())  # what hands draw through where no stitch is made
_USED: Final = frozenset(
    "photo photos photograph photographs picture guide diagram template needle marker ends tail tails".split()
)
_SHOWN: Final = frozenset("photo photos photograph photographs picture guide diagram".split())
_LEFT: Final = frozenset(
    "tail tails end ends long opening open gap hole inch inches cm sewing stuffing yarn neck bottom top".split()
)
_PAINTS: Final = frozenset("crayon crayons pencil pencils blush chalk paint rouge".split())
_FILLING: Final = frozenset(("fiberfill", "fibrefill", "polyfill", "filling", "batting"))
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
    if (
        first.word in ("add", "insert", "finish")
        and second is not None
        and (c.key("stuff", ahead=1) or second.word in _FILLING)
    ):
        return True
    if first.kind != "word" or first.word not in _DOING:
        return False
    return not _pulls(first, c.look(1))


def by_hand(tokens: list[Token]) -> bool:
    """Whether a sentence between the rounds is such a doing: it begins with what hands do, and works no stitch."""
    at = _verb_at(tokens)
    if at >= len(tokens) or len(tokens) < 2:
        return False
    first, after = tokens[at], tokens[at + 1] if at + 1 < len(tokens) else None
    words = {t.word for t in tokens}
    if _goes_back(tokens[at:]):
        return True
    verb = "slip" if first.word == "slip" and after is not None and after.kind in ("word", "number") else ""
    if any(works(tokens, k) for k in range(at + bool(verb), len(tokens))):
        return False
    if first.value == "ch" and "secure" in words:
        return True  # "Chain one to secure the loop, and remove ring from finger": how the ring is made
    if first.value == "repeat" and words & _STILL:
        return not any((t.kind == "key" and t.value in ("round", "row", "ring")) or t.word == "*" for t in tokens)
    if words & _SHOWN and tokens[0].word in ("refer", "referring", "follow", "following"):
        return True
    if "cut" in words or (first.word in _YARN and not any(t.kind == "key" and t.value == "join" for t in tokens)):
        return True  # "White - Cut 2", "Break A"
    if _pulls(first, after) and not words & _STRANDS:
        return False
    if first.kind == "word":
        verb = verb or first.word.split(" ")[0]
        return verb in _HANDS or verb in _DOING or (verb in ("attach", "add") and bool(words & _MADE))
    if verb or (first.kind == "key" and first.value == "leave"):
        return "unworked" not in words  # "leave remaining 3 sts unworked, turn—4 sc" is of the row
    if first.kind != "key" or after is None:
        return False
    if first.value == "count" and first.word == "count":
        return at == 0
    if first.value == "make":
        rings = any(t.kind == "key" and t.value in ("ring", "loop") and t.word != "mc" for t in tokens)
        return not rings and (first.word != "make" or bool(words & _MADE))
    if first.value in ("loop", "space") and (first.capital or at):
        # "Loop yarn between 2 sts", "Space eyes 8 ins apart", "loop two lengths of wire around sts"
        thing = tokens[at + 2] if after.kind == "number" and at + 2 < len(tokens) else after
        return thing.kind == "word" or thing.value in ("eyes", "yarn")
    if first.value == "with" and at == 0:
        marks = any(t.kind == "key" and t.value == "marker" for t in tokens)
        return first.word == "use" and (marks or bool(words & _USED))  # "Use photograph as a guide"
    return first.value == "color" and bool(words & _PAINTS)


def _verb_at(tokens: list[Token]) -> int:
    """Where a sentence comes to what is done: "Using a strand of D, | tie …", "With E, beginning at fold, | sew …", "Finishing Body: | Fold …"."""
    at = 0
    while at < len(tokens):
        if tokens[at].word in _LEAD or tokens[at].kind == "mark":
            at += 1
            continue
        comma = next((k + 1 for k in range(at, len(tokens)) if tokens[k].word in (",", ":")), 0)
        if not comma or not _beginning(tokens[at]):
            break
        at = comma
    headed = next((k for k, t in enumerate(tokens[:5]) if t.word == ":"), 0)
    named = at == 0 and headed and headed + 1 < len(tokens) and tokens[0].capital and tokens[headed + 1].kind == "word"
    return headed + 1 if named else at


def _beginning(token: Token) -> bool:
    """Whether a clause before the comma only says with what, where, when or why."""
    return (
        token.kind == "key" and token.value in ("with", "over", "for", "in", "as", "begin", "to", "from", "between")
    ) or token.word in _BEFORE


def _pulls(first: Token, after: Token | None) -> bool:
    """Whether words begin a stitch: "draw up a loop"."""
    return first.word in ("draw", "pull", "insert") and after is not None and after.word in ("loop", "loops", "hook")


def _goes_back(tokens: list[Token]) -> bool:
    """Whether the hook only goes back into a loop that was left: "Insert hook back into dropped loop"."""
    begins = tokens[0].word in ("insert", "place", "put", "slip", "return")
    back = any(t.word in ("back", "dropped") for t in tokens[1:5])
    return begins and back and not any(t.word in ("yo", "yoh", "draw", "pull") or t.value == "next" for t in tokens[1:])


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
            after is not None and after.word in ("stitch", "stitches", "sts") and before.kind != "number"
        )  # "the hdc sts"
        or (
            before.kind == "key"
            and before.value in ("last", "next", "same", "foundation", "each", "begin", "in", "from", "rest")
        )
    )
    prior = tokens[at - 2] if at > 1 else None
    if token.value == "ch" and before is not None and before.value == "side" and not (after and after.kind == "number"):
        return False  # "worked around both sides of a chain"
    if before is not None and before.value in ("in", "each") and before.kind == "key":
        return False  # "knot fringe into each sc around"
    if before is not None and before.value in ("row", "round") and prior is not None and prior.kind == "word":
        return False  # "matching rows of sc"
    if token.value == "ch" and any(t.word == "secure" for t in tokens[at + 1 : at + 5]):
        return False
    if token.word == "slip" and after is not None and after.kind == "word":
        return False  # "slip the wraps off your fingers"
    if token.word in ("fur", "double") and (before is None or before.kind != "number") and not _sts(after):
        return False  # "the fur around the eyes", "a double layer"
    placed = after is not None and after.kind == "key" and after.value in ("in", "around", "each", "next", "over")
    return placed or not named


def _sts(token: Token | None) -> bool:
    return token is not None and token.word in ("st", "stitch", "stitches", "sts")


def until_stitches(tokens: list[Token]) -> int:
    """Where such a doing ends since stitches are worked behind it, "Do not turn, | sc in next 12 sts"; 0 where they are in its first clause."""
    worked = next((k for k in range(len(tokens)) if _placed(tokens, k)), None)
    if worked is None:
        return len(tokens)
    parted = (k for k in range(1, worked) if tokens[k].word in (",", ":", "then") or tokens[k].value == "and")
    return next(parted, 0)


def _placed(tokens: list[Token], at: int) -> bool:
    """Whether a stitch that is worked stands at ``at``, with where it is worked, "sc in next", "sc around", or by itself, ", 12 sc"."""
    after = tokens[at + 1] if at + 1 < len(tokens) else None
    said = after is not None and after.kind == "key" and after.value in ("in", "around", "each", "next")
    alone = at > 1 and tokens[at - 1].kind == "number" and tokens[at - 2].word in (",", ":")
    said = said or (alone and (after is None or after.kind == "mark"))
    return said and tokens[at].value not in ("slst", "ch") and works(tokens, at)


def closed_flat(tokens: list[Token]) -> bool:
    """Whether a doing closes an edge flat, layer on layer: "flatten, and close with 4 sc through both layers"."""
    words = {t.word for t in tokens}
    return bool(words & {"layers", "thicknesses"} and words & {"both", "two"}) or bool(
        words & {"flatten", "flattened"} and words & {"sew", "close", "closed", "shut"}
    )


def drawn_tight(tokens: list[Token]) -> bool:
    """Whether a doing draws the last round together."""
    words = {t.word for t in tokens}
    return not (closed_flat(tokens) or words & _BEGUN) and bool(
        words & _TIGHT and words & {"pull", "draw", "close", "thread", "cinch", "weave"}
    )


def gathered_shut(words: str) -> bool:
    """Whether a sentence of English draws the last round together by its tail: "Thread tail through sts of last rnd and pull tight to close"."""
    led = words.rstrip().endswith(":")  # what closes it stands behind
    return not led and _GATHERS.search(words) is not None and _ELSEWHERE.search(words) is None


_SHUT: Final = r"(?:tight|tightly|closed?|shut|gather|cinch(?:ed)?)"
_GATHERS: Final = re.compile(
    rf"\b(?:weave|weaving|thread|run|pull|draw)\b[^.;]{{0,60}}\b(?:tail|end|yarn|needle|thread|it|through)\b[^.;]{{0,60}}\b{_SHUT}\b"
    rf"|^(?:and |then )?(?:pull|draw|gather|cinch)\b[^.;,]{{0,40}}\b{_SHUT}\b|\b(?:gather|cinch|draw|pull) (?:up|the top|the opening)\b[^.;]{{0,30}}\b(?:{_SHUT}|fasten|securely)\b"
    r"|\bsew\b[^.;]{0,30}\b(?:closed|shut)$|\bclose (?:up )?(?:the |remaining |top |small |this )*(?:hole|opening|gap|end|top)\b",
    re.IGNORECASE,
)
_ELSEWHERE: Final = re.compile(
    r"\b(?:not|don['’]t|open|slightly|leaving a|to (?:form|cause|shape|make)|flat|flatten(?:ed)?|flattening|fold|folded|half|layers|thicknesses|seam|crotch|cent(?:er|re)|ring|loop|beginning|first|"
    r"start(?:ing)?|foundation|to (?:the )?(?:body|head|face|other)|head|body|legs?|arms?|together|both|between|at|round \d|rnd \d|rounds|side|sides|edges?|colou?rs?|chang\w+|glue|lid|in (?:the |all )?(?:loose )?ends)\b",
    re.IGNORECASE,
)


def _and_stitches(c: Cursor) -> bool:
    """Whether stitches stand behind a comma of the sentence at the cursor: "place marker fork, 9 sc"."""
    ahead = 1
    while (token := c.look(ahead)) is not None and not c.mark(".", ";", ahead=ahead):
        after = c.look(ahead + 1)
        if token.word == "," and after is not None and after.kind in ("number", "stitch"):
            return True
        ahead += 1
    return False
