"""Printed patterns, underside: the many ways to say in which chain a row begins, and that it goes on along the other side, put as one."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from tambour.crochet.printed.tokens import Token

_LEADS: Final = frozenset(
    "turn rotate flip spin crochet hook start continue continuing carry carrying go going move moving work working keep now then on along down around round up the "
    "return returning your and to so that you can back piece it other again yarn over into in not do without turning rotating in-the-round 180 degrees clockwise".split()
)  # fmt: skip
_SIDES: Final = frozenset(
    "other opposite bottom underside under lower free unused remaining backside reverse second".split()
)
_CHAINS: Final = frozenset(
    "chain chains foundation starting beginning initial base original first side loops loop edge".split()
)
_LOOPS: Final = frozenset(("back loops", "front loops", "blo", "flo", "bumps"))
_FREE: Final = frozenset("free unused remaining rem other opposite unworked".split())
SIDES: Final = _SIDES | _LOOPS | _FREE | {"side"}
"""Words of which a line has one where it may go on along the other side of its chain; or it goes back along it."""
_STOPS: Final = (",", ".", ";", ":", "-", "(", "[", "*")
_LONGEST: Final = 22


def plainly_put(tokens: list[Token]) -> list[Token]:
    """``tokens`` with "turn the work and carry on along the bottom of the chain:" as "other side,"."""
    made: list[Token] = []
    tokens = _in_bumps(tokens)
    said = {w for t in tokens for w in (*t.word.split(" "), t.value)}
    sided = not SIDES.isdisjoint(said) or ("back" in said and not said.isdisjoint(("along", "down")))
    foreign = any(_names_side(t) for t in tokens if t.value == "side")
    at, begun = 0, False
    while at < len(tokens):
        before = tokens[at - 1] if at else None
        begun = begun or (before is not None and before.kind == "stitch" and before.value != "ch")
        if (
            at > 1
            and tokens[at].value == "begin"
            and tokens[at - 1].value == "ch"
            and tokens[at - 2].value in ("next", "each", "last")
        ):
            chained = at + 1 < len(tokens) and tokens[at + 1].value == "ch"
            if chained and not (at + 2 < len(tokens) and tokens[at + 2].word == "-"):
                at += 2  # "in next ch of beginning ch"
                continue
        if (end := _link(tokens, at)) > at:
            behind = len(made) > 1 and {made[-1].kind, made[-2].kind} == {"number", "stitch"} and made[-1].value != "ch"
            where = len(made) - 2 if behind else len(made)
            made[where:where] = [*_from_link(tokens, at, end), *_comma(tokens[end - 1], behind)]
            at = end
            continue
        if tokens[at].value == "in" and (end := _in_loops(tokens, at)) > at:
            if not any(t.value == "side" for t in made):
                where = len(made) - 1 - (len(made) > 1 and made[-2].kind == "number")
                made[where:where] = _sided(made[where], made[where])
            made.append(tokens[at])  # "sc in free loops of next 3 ch"
            at = end
            continue
        if tokens[at].value == "same" and (end := _in_first(tokens, at)) > at and any(t.value == "side" for t in made):
            first, last = tokens[at], tokens[end - 1]
            made += [
                Token("key", "last", first.start, first.end, "last"),
                Token("stitch", "ch", last.start, last.end, "ch"),
            ]
            at = end  # "2 sc in same ch as first sc", where both sides end
            continue
        begins = sided and (
            not at or tokens[at - 1].word in _STOPS or tokens[at - 1].value == "and" or tokens[at - 1].kind == "number"
        )
        if begins and begun and (worked := _worked_there(tokens, at)):
            if len(made) > 1 and made[-1].word == "," and made[-2].value == "turn":
                del made[-2:]  # "turn the work, sc 2 on the other side of the chain"
            made += [
                Token("mark", ",", tokens[at].start, tokens[at].start),
                *_sided(tokens[worked[0]], tokens[worked[0]]),
            ]
            made += tokens[worked[0] : worked[1]]
            at = worked[2]
            continue
        end = max(_other(tokens, at, begun), _foreign(tokens, at) if foreign else at) if begins else at
        if end > at:
            first, last = tokens[at], tokens[end - 1]
            made += _sided(first, last)
            at = end + (end < len(tokens) and tokens[end].word in (",", ":", "-"))
            continue
        made.append(tokens[at])
        at += 1
        if _hooked(tokens, at):
            made += [
                Token("key", word, tokens[at - 1].end, tokens[at - 1].end, value)
                for word, value in (("from", "from"), ("hook", "hook"))
            ]
        if _unparted(tokens, at):
            made.append(Token("mark", ",", tokens[at - 1].end, tokens[at - 1].end))
    return made


def _in_bumps(tokens: list[Token]) -> list[Token]:
    """``tokens`` with the bottom loops of a chain that a row begins in, "Turn to bottom loops of ch, sc in 2nd loop from hook", as its bumps: no other side."""
    at = next((k for k, t in enumerate(tokens) if t.value == "side" and t.word == "bottom"), None)
    if at is None or any(t.kind == "stitch" and t.value != "ch" for t in tokens[:at]):
        return tokens
    loops = at + 1 < len(tokens) and tokens[at + 1].word in ("loop", "loops", "lps")
    hook = next((k for k, t in enumerate(tokens) if t.value == "hook"), 0)
    if not loops or hook < at:
        return tokens
    first, last = tokens[at], tokens[at + 1]
    begin = at - 2 if [t.value for t in tokens[max(0, at - 2) : at]] == ["turn", "to"] else at
    led = [Token("key", "in", first.start, first.start, "in")] if begin < at else []
    bumps = Token("key", "bottom loops", first.start, last.end, "bumps", first.glued, first.capital)
    rest = [replace(t, kind="stitch", value="ch") if t.value == "loop" else t for t in tokens[at + 2 :]]
    return [*tokens[:begin], *led, bumps, *rest]


def _worked_there(tokens: list[Token], at: int) -> tuple[int, int, int] | None:
    """Of a clause at ``at`` that works stitches along the other side, "turn work and sc 3 on the other side", where these begin and end, and where it ends."""
    begin = at
    while begin < len(tokens) and (tokens[begin].value == "turn" or tokens[begin].word in _TURNS):
        begin += 1
    kinds = [t.kind for t in tokens[begin : begin + 2]]
    if sorted(kinds) != ["number", "stitch"] or any(t.value == "ch" for t in tokens[begin : begin + 2]):
        return None
    end = next((k for k in range(begin + 2, len(tokens)) if tokens[k].word in (*_STOPS, ")", "]")), len(tokens))
    said = tokens[begin + 2 : end]
    other = any(t.value == "side" for t in said) or {"other", "side"} <= {t.word for t in said}
    plain = all(t.value in ("in", "around", "side", "ch", "foundation") or t.word in _ALONG for t in said)
    return (begin, begin + 2, end) if other and plain else None


_TURNS: Final = frozenset("and then rotate flip spin work piece it the your now".split())
_ALONG: Final = frozenset("along down up across the other opposite side of to on".split())


def _sided(first: Token, last: Token) -> list[Token]:
    """The words "other side," in place of others."""
    side = Token("key", "other side", first.start, last.end, "side", first.glued, first.capital)
    return [side, Token("mark", ",", last.end, last.end)]


def _in_loops(tokens: list[Token], at: int) -> int:
    """Where "in free loops of" ends, said of the chains that a stitch before it goes into; ``at`` for others."""
    if not at or tokens[at - 1].kind != "stitch" or at + _REACH > len(tokens):
        return at
    free, loops = tokens[at + 1], tokens[at + 2]
    if free.word not in _FREE or loops.word not in ("loop", "loops"):
        return at
    return at + 3 if any(t.value == "ch" for t in tokens[at + 3 : at + 3 + _REACH]) else at


def _in_first(tokens: list[Token], at: int) -> int:
    """Where "same ch as first sc" ends; ``at`` for other words."""
    said = tokens[at : at + 5]
    same = len(said) > 4 and said[2].value == "as" and said[4].kind in ("stitch", "key")
    first = same and ((said[3].kind == "ordinal" and said[3].value == 1) or said[3].value in ("begin", "first"))
    return at + 5 if first and said[1].value in ("ch", "stitch", "place") else at


_REACH: Final = 5  # tokens


def _hooked(tokens: list[Token], at: int) -> bool:
    """Whether the words before ``at`` name the chain that a row begins in, and not the hook: "ch 2, sc in 2nd ch (1)"."""
    ends = at == len(tokens) or tokens[at].kind == "mark"
    if not ends or at < _CHAINED or tokens[at - 1].value != "ch" or tokens[at - 2].value not in _HOOKED:
        return False
    before = [t for t in tokens[:at] if t.word not in (",", ".", ";") and t.kind != "filler" and t.value != "and"]
    said = [t.kind if t.value != "ch" else "ch" for t in before]
    tail = ["ordinal", "ch"]
    ways = (["ch", "number", *middle, *tail] for middle in (["stitch", "key"], ["number", "stitch", "key"]))
    return any(said[-len(way) :] == way for way in ways) and before[-3].value == "in"


_CHAINED: Final = 6


def _unparted(tokens: list[Token], at: int) -> bool:
    """Whether stitches follow right behind words for the other side: "on the other side of the chain work sc in next 3 ch"."""
    if not 1 < at < len(tokens) or tokens[at - 1].value != "side" or tokens[at - 2].value not in ("in", "around"):
        return False
    worked = tokens[at].kind == "number" and at + 1 < len(tokens) and tokens[at + 1].kind == "stitch"
    return ((tokens[at].kind == "stitch" and tokens[at].value != "ch") or worked) and (
        at < 3 or tokens[at - 3].word in _STOPS
    )


_HOOKED: Final = range(2, 7)  # which chain from the hook is the first that is worked into


def _link(tokens: list[Token], at: int) -> int:
    """Where words end that say in which chain a row begins: "from the 2nd ch", "beginning in 2nd chain from hook"; ``at`` for others, and
    for those that are plain already."""
    begun = tokens[at].value == "begin"
    end = at + begun
    if end + 2 >= len(tokens) or tokens[end].value not in ("from", "in", "to"):
        return at
    led, end = tokens[end].value, end + 1
    if tokens[end].kind != "ordinal" or tokens[end].value not in _HOOKED or tokens[end + 1].value != "ch":
        return at
    end += 2
    hooked = [t.value for t in tokens[end : end + 2]] == ["from", "hook"]
    end += 2 * hooked
    behind = at > 1 and {tokens[at - 1].kind, tokens[at - 2].kind} == {"number", "stitch"}
    if begun and led == "in" and hooked and not behind:
        return at
    return end if led == "from" or begun else at


def _from_link(tokens: list[Token], at: int, end: int) -> list[Token]:
    """``beginning in 2nd ch from hook`` for those words."""
    k = next(k for k in range(at, end) if tokens[k].kind == "ordinal")
    first, last = tokens[at], tokens[end - 1]

    def key(word: str, value: str, place: Token) -> Token:
        return Token("key", word, place.start, place.end, value)

    hook = [key("from", "from", last), key("hook", "hook", last)]
    return [key("beginning", "begin", first), key("in", "in", first), tokens[k], tokens[k + 1], *hook]


def _comma(last: Token, wanted: bool) -> list[Token]:
    return [Token("mark", ",", last.end, last.end)] if wanted else []


def _names_side(token: Token) -> bool:
    """Whether a word of another language names a side of the chain."""
    english = "side" in token.word or "loop" in token.word or not _SIDES.isdisjoint(token.word.split(" "))
    return token.value == "side" and token.kind == "key" and not english


def _foreign(tokens: list[Token], at: int) -> int:
    """Where a clause of another language ends that names the other side of the chain and works nothing, "continuer de l'autre côté de la chaînette"."""
    end = next(
        (k for k in range(at, len(tokens)) if tokens[k].word in _STOPS or tokens[k].kind == "number"), len(tokens)
    )
    some = tokens[at:end]
    named = any(_names_side(t) for t in some)
    worked = any(t.kind == "stitch" and t.value != "ch" for t in some) or any(t.value in _LOOPS for t in some)
    return end if named and not worked and len(some) <= _LONGEST // 2 else at


def _other(tokens: list[Token], at: int, begun: bool) -> int:
    """Where words end that begin at ``at`` and say that the work goes on along the other side of the chain; ``at`` where they do not.
    ``begun``: stitches stand before them."""
    side = chain = False
    end = at
    while end < len(tokens) and end - at < _LONGEST:
        token = tokens[end]
        words = token.word.split(" ")
        if token.kind == "number" and token.value == 180:
            pass
        elif token.value == 2 and token.kind == "ordinal" and end + 1 < len(tokens) and tokens[end + 1].word == "side":
            side, end = True, end + 1  # "back along the second side of the chain"
        elif token.kind in ("number", "ordinal") or token.word in _STOPS:
            break
        elif token.value == "side":
            side, chain = True, True
        elif token.kind == "stitch":
            if token.value != "ch":
                break
            chain = True
        elif token.kind == "key" and token.value in _LOOPS:
            if not begun or end + 1 == len(tokens) or tokens[end + 1].value not in ("ch", "foundation"):
                return at  # "Working in back loops only"
            side = True  # "…, 3 sc in last ch; working in front loops of chain"
        elif any(w in _SIDES for w in words):
            side = True
            chain = chain or "chain" in words or "ch" in words or "foundation" in words
        elif token.value == "foundation" or any(w in ("chain", "chains", "foundation") for w in words):
            chain = True
        elif not (
            all(w in _LEADS or w in _CHAINS for w in words)
            or (token.kind == "key" and token.value in ("in", "around", "turn", "begin", "loop", "of"))
        ):
            return at
        end += 1
    if end < len(tokens) and tokens[end].kind == "ordinal":
        return at
    said = {w for t in tokens[at:end] for w in t.word.split(" ")}
    if (
        chain
        and begun
        and "back" in said
        and said & {"along", "down"}
        and not any(t.value == "hook" for t in tokens[end : end + 6])
    ):
        return end  # "…, 3 sc in last ch, back along the chain"
    moves = any(
        w
        in (
            "turn",
            "rotate",
            "flip",
            "continue",
            "continuing",
            "carry",
            "go",
            "working",
            "work",
            "keep",
            "spin",
            "back",
            "return",
            "crochet",
        )
        for t in tokens[at:end]
        for w in t.word.split(" ")
    )
    led = tokens[at].word in ("down", "up")  # "down the other side"
    plain = not led and end - at <= 2 and any(t.value == "side" for t in tokens[at:end])
    moves = moves or any(
        t.value == "side" and "chain" in t.word for t in tokens[at:end]
    )  # "in the remaining loops on opposite side of chain"
    if [t.value for t in tokens[at:end]] == ["side", "ch"]:
        return end  # "the underside of the chain:"
    moves = moves or (
        tokens[at].value == "in" and (begun or bool(said & {"loop", "loops"}))
    )  # "working in free loops of beg ch"
    return end if side and chain and (moves or led) and not plain else at
