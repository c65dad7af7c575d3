"""Printed patterns, inner: what is said within a round behind the stitches that it is said of, put where the reading has it: loops ("6 sc
[FLO]", "(sc, inc) x 9 in BLO"), rests ("until 2 sts remain", "sc in the rest"), stitches spread evenly, several kinds in one stitch."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from tambour.crochet.printed.tokens import Token

LOOPS: Final = frozenset(("back loops", "front loops", "both loops"))
_OPEN: Final = frozenset("([{")
_ENDS: Final = frozenset((",", ".", ";", ":", "(", "[", ")", "]", "="))
_UNTIL: Final = frozenset(("until", "till"))
_REST: Final = frozenset(("rest", "rest of", "remainder"))
LEFT_OVER: Final = _UNTIL | _REST | {"with"}
_LEFT: Final = frozenset(("remain", "remains", "remaining", "rem", "left", "are", "is", "unworked"))
_EVENLY: Final = frozenset("evenly spaced apart around across in this the round rnd row".split())
_SHAPED: Final = frozenset("inc incs increase increases increasing dec decs decrease decreases decreasing".split())
_MAKING: Final = frozenset("work make making working with".split())
_UNITS: Final = frozenset("st sts stitch stitches sc times time x more".split())
_PLAIN: Final = frozenset(("sc", "hdc", "dc", "tr", "slst"))


def looped(tokens: list[Token]) -> list[Token]:
    """Words as read, with loops as most patterns say them."""
    return _postposed(_fronted(tokens)) if any(t.kind == "key" and t.value in LOOPS for t in tokens) else tokens


def _key(at: Token, word: str, value: str) -> Token:
    return Token("key", word, at.start, at.end, value)


def _fronted(tokens: list[Token]) -> list[Token]:
    """``6 FLO sc`` and, behind other stitches, ``(FLO) 6 sc`` as "6 sc FLO"; ``6 sc [FLO]`` without its bracket."""
    made: list[Token] = []
    at = 0
    while at < len(tokens):
        token = tokens[at]
        after = tokens[at + 1 : at + 5]
        looped = token.kind == "key" and token.value in LOOPS
        if looped and made and made[-1].kind == "number" and after and after[0].kind == "stitch":
            made += [after[0], token]
            at += 2
            continue
        said = [t.value or t.word for t in after[:3]]
        led = looped and made and made[-1].value == "in" and (len(made) == 1 or made[-2].kind == "mark")
        if led and said == ["each", "stitch", ","]:
            made.append(token)  # "in the back loop of each stitch, sc around"
            at += 3
            continue
        if token.word == "again" and made and made[-1].value in LOOPS:
            at += 1
            continue
        if (
            token.value == "as"
            and after
            and after[0].word in ("usual", "normal")
            and any(t.value in LOOPS for t in made)
        ):
            made += [_key(token, "in", "in"), _key(token, "both loops", "both loops")]
            at += 2
            continue
        if looped and made and made[-1].value == "in" and sorted(t.kind for t in after[:2]) == ["number", "stitch"]:
            made += [token, Token("mark", ":", token.end, token.end)]  # "in BLO sc 9", "in both loops 6 sc"
            at += 1
            continue
        inside = token.word in _OPEN and len(after) > 1 and after[0].value in LOOPS and after[1].word in (")", "]", "}")
        if inside and made and (made[-1].kind != "mark" or made[-1].word in (")", "]")):
            made.append(after[0])
            at += 3
            continue
        worked = any(t.kind == "stitch" for t in made) and made[-1].word in (",", ";")
        if inside and worked and len(after) > 2:
            counted = after[2].kind == "number" and len(after) > 3
            if after[2 + counted].kind == "stitch":
                made += [*after[2 : 3 + counted], after[0]]
                at += 4 + counted
                continue
        made.append(token)
        at += 1
    return made


def _postposed(tokens: list[Token]) -> list[Token]:
    """Loops that end a clause, right behind its stitch, ``sc in next 9 sts in BLO``; where it is a repeat, before it."""
    made: list[Token] = []
    for k, token in enumerate(tokens):
        made.append(token)
        ends = k + 1 == len(tokens) or tokens[k + 1].word in _ENDS
        if token.kind != "key" or token.value not in LOOPS or not ends:
            continue
        cut = len(made) - 1
        while cut and (made[cut - 1].value == "in" or (made[cut - 1].value == "each" and made[cut - 1].word == "all")):
            cut -= 1
        cut -= cut > 1 and made[cut - 1].word == "," and made[cut - 2].value == "times"
        before = made[cut - 1] if cut else None
        if before is None or (before.kind == "mark" and before.word not in (")", "]")):
            continue
        if before.value in ("stitch", "around", "end"):
            begin = next((n for n in range(cut - 1, -1, -1) if made[n].word in _ENDS), -1) + 1
            stitches = [n for n in range(begin, cut) if made[n].kind == "stitch"]
            if len(stitches) == 1 and not any(t.value in LOOPS for t in made[begin:cut]):
                at = stitches[0] + 1
                if at < cut:  # else the stitches stand right before it
                    grown = [_key(token, "in", "in")] if made[at].value in ("next", "each", "first", "last") else []
                    made = [*made[:at], *grown, token, *made[at:cut]]
        elif (opens := _repeat(made, cut)) is not None and not any(t.value in LOOPS for t in made[opens:cut]):
            inner = [[t, token] if t.kind == "stitch" else [t] for t in made[opens:cut]]
            made = [*made[:opens], *(t for some in inner for t in some)]
    return made


def _repeat(tokens: list[Token], end: int) -> int | None:
    """Where the bracket opens whose repeat ends before ``end``: "(sc, inc) x 9"; None where none does."""
    at = end - 1
    at -= tokens[at].value in ("times", "around")
    at -= at > 0 and tokens[at].kind == "number"
    at -= at > 0 and tokens[at].word == "x"
    if not 0 < at < end - 1 or tokens[at].word not in (")", "]"):
        return None
    depth = 0
    for k in range(at, -1, -1):
        depth += (tokens[k].word in (")", "]")) - (tokens[k].word in _OPEN)
        if not depth:
            return k
    return None


def anywhere(tokens: list[Token]) -> list[Token]:
    """``join B in 13th sc of previous round`` as "join B in any st": a round that begins elsewhere goes all around too."""
    for k in range(2, len(tokens) - 3):
        at, named = tokens[k], tokens[k + 1]
        if (
            at.kind != "ordinal"
            or tokens[k - 1].value != "in"
            or not (named.kind == "stitch" or named.value == "stitch")
        ):
            continue
        below = [t.value or t.word for t in tokens[k + 2 : k + 5] if t.value != "from" and t.word != "of"][:2]
        led = tokens[max(0, k - 8) : k - 1]
        joined = any(t.value == "join" or t.word in ("draw", "attach") for t in led)
        if joined and below[:1] in (["previous"], ["last"]) and below[1:] == ["round"]:
            end = next(n for n in range(k + 2, k + 5) if tokens[n].value == "round") + 1
            some = [Token("word", "any", at.start, at.end), _key(named, "st", "stitch")]
            return [*tokens[:k], *some, *tokens[end:]]
    return tokens


def counted(tokens: list[Token]) -> list[Token]:
    """``— 24 sts Stuff the head`` with the point that its count lacks."""
    for k in range(1, len(tokens) - 3):
        if tokens[k].word == "-" and tokens[k + 1].kind == "number" and tokens[k + 2].value in ("stitch", "sc"):
            after = tokens[k + 3]
            if (
                after.capital
                and after.kind in ("key", "word")
                and len(after.word) > 1
                and tokens[k - 1].word in (".", "around", ")")
            ):
                point = Token("mark", ".", after.start, after.start)
                return [*tokens[: k + 3], point, *tokens[k + 3 :]]
    return tokens


def nth(tokens: list[Token]) -> list[Token]:
    """``sc in every 3rd st`` as "(2 skip, sc) repeat around"."""
    for k, token in enumerate(tokens[:-3]):
        said = tokens[k + 1 : k + 6]
        if token.value not in _PLAIN or token.kind != "stitch" or [t.value for t in said[:2]] != ["in", "each"]:
            continue
        if (
            len(said) < 4
            or said[2].kind != "ordinal"
            or said[2].value < 2
            or said[3].value not in ("stitch", token.value)
        ):
            continue
        end = k + 5 + (len(said) > 4 and said[4].value == "around")
        begin = k - (k > 0 and tokens[k - 1].kind == "number" and tokens[k - 1].value == 1)
        if end < len(tokens) and tokens[end].word not in _ENDS:
            continue
        place = replace(token, word="", end=tokens[end - 1].end)
        skipped = [
            replace(place, kind="mark", word="(", value=None),
            replace(place, kind="number", word=str(said[2].value - 1), value=said[2].value - 1),
            replace(place, kind="stitch", word="skip", value="skip"),
            replace(place, kind="mark", word=",", value=None),
        ]
        around = [
            replace(place, kind="mark", word=")", value=None),
            _key(place, "repeat", "repeat"),
            _key(place, "around", "around"),
        ]
        return [*tokens[:begin], *skipped, token, *around, *tokens[end:]]
    return tokens


def named(tokens: list[Token]) -> list[Token]:
    """``(white) 6 sc, (red) 6 sc`` without its brackets."""
    found = [
        k
        for k, t in enumerate(tokens[:-4])
        if t.word == "("
        and tokens[k + 1].kind == "word"
        and tokens[k + 2].word == ")"
        and tokens[k + 3].kind == "number"
        and tokens[k + 4].kind == "stitch"
        and (not k or tokens[k - 1].word in (",", ":", ";"))
    ]
    drop = {n for k in found for n in (k, k + 2)} if len(found) > 1 else set()
    return [t for k, t in enumerate(tokens) if k not in drop] if drop else tokens


def together(tokens: list[Token]) -> list[Token]:
    """``1 sc and 1 hdc in next st`` with brackets about both."""
    for k in range(len(tokens) - 6):
        some = tokens[k : k + 8]
        kinds = [t.kind for t in some[:5]]
        both = kinds == ["number", "stitch", "key", "number", "stitch"] and some[2].value == "and"
        few = both and {some[0].value, some[3].value} <= {1, 2, 3} and {some[1].value, some[4].value} <= _PLAIN
        one = few and [t.value for t in some[5:8]] in (["in", "next", "stitch"], ["in", "same", "stitch"])
        if one and (not k or tokens[k - 1].word in _ENDS):
            opens, closes = (Token("mark", sign, t.start, t.start) for sign, t in (("(", some[0]), (")", some[5])))
            comma = Token("mark", ",", some[2].start, some[2].end)
            return [*tokens[:k], opens, *some[:2], comma, *some[3:5], closes, *together(tokens[k + 5 :])]
    return tokens


def rests(tokens: list[Token]) -> list[Token]:
    """``until 2 sts remain`` as "to last 2 sts", ``sc in the rest`` as "sc to end", ``with 2 sc in last st`` as it is said of an end."""
    if not any(t.word in LEFT_OVER for t in tokens):
        return tokens
    made: list[Token] = []
    at = 0
    while at < len(tokens):
        token, before = tokens[at], made[-1] if made else None
        if token.word in _UNTIL and before is not None and (past := _until(tokens, at, made)):
            number = next(t for t in tokens[at:past] if t.kind == "number")
            made += [_key(token, "to", "to"), _key(token, "last", "last"), number, _key(token, "sts", "stitch")]
            at = past
            continue
        if token.word in _REST and before is not None:
            led = before.value in ("in", "for") and len(made) > 1
            past = at + 1
            past += past < len(tokens) and tokens[past].word in ("of", "the")
            past += past < len(tokens) and tokens[past].value in ("round", "row")
            stands = past == len(tokens) or tokens[past].word in _ENDS
            if made[-1 - led].kind == "stitch" and stands:
                made[len(made) - led :] = [_key(token, "around", "around")]
                at = past
                continue
        if token.value == "with" and before is not None and before.word == "," and _last(tokens, at + 1):
            token = Token("word", "ending", token.start, token.end)
        made.append(token)
        at += 1
    return made


def _until(tokens: list[Token], at: int, made: list[Token]) -> int:
    """Where words end that say how many stitches stitches go up to, "until (there are) 2 sts (left)", before others; 0 where they do not."""
    begin = next((k for k in range(len(made) - 1, -1, -1) if made[k].word in (",", ".", ";", ":")), -1) + 1
    goes = made[-1].kind == "stitch" or made[-1].value in ("stitch", "around") or made[-1].word in (")", "]")
    down = any(t.kind == "stitch" and ("dec" in str(t.value) or "inc" in str(t.value)) for t in made[begin:])
    if not goes or (down and made[-1].word not in (")", "]")) or any(t.value == "repeat" for t in made[begin:]):
        return 0
    end = at + 1
    last = False
    while end < len(tokens) and (
        tokens[end].word in ("there", "are", "is", "the", "only") or tokens[end].value == "last"
    ):
        last = last or tokens[end].value == "last"
        end += 1
    if end + 1 >= len(tokens) or tokens[end].kind != "number" or tokens[end + 1].value not in ("stitch", "sc"):
        return 0
    end += 2
    left = end
    while end < len(tokens) and tokens[end].word in _LEFT:
        end += 1
    more = end < len(tokens) and tokens[end].word in (",", ";", ".") and end + 1 < len(tokens)
    return end if (last or end > left) and more and any(t.kind == "stitch" for t in tokens[end : end + 4]) else 0


def _last(tokens: list[Token], at: int) -> bool:
    """Whether stitches into the last of a round are said at ``at``: "2 sc in the last st"."""
    at += at < len(tokens) and tokens[at].kind == "number"
    rest = [t.value for t in tokens[at : at + 3]]
    return len(rest) == 3 and tokens[at].kind == "stitch" and rest[1:] == ["in", "last"]


def evened(tokens: list[Token]) -> list[Token]:
    """Words of a text, with "increase 6 sts evenly" as "1 sc in each around, increase 6", since elsewhere "evenly" says no more."""
    at = next((k for k, t in enumerate(tokens) if t.word == "evenly"), 0)
    if not at:
        return tokens
    begin = next((k for k in range(at - 1, -1, -1) if tokens[k].word in (":", ".", ",", ";")), -1) + 1
    led = next((k for k in range(at - 1, begin - 1, -1) if tokens[k].word in _MAKING), begin - 1)
    said = [t for t in tokens[led + 1 : at] if t.word != "spaced"]
    shapes = [t for t in said if t.word in _SHAPED]
    numbers = [t for t in said if t.kind == "number"]
    end = at + 1
    if not shapes and at + 2 < len(tokens) and tokens[at + 1].word in _SHAPED and tokens[at + 2].kind == "number":
        past = (
            at + 3 + (at + 3 < len(tokens) and tokens[at + 3].word in _UNITS)
        )  # "sc around evenly decreasing 6 times"
        comma = Token("mark", ",", tokens[at].start, tokens[at].start)
        return [*tokens[:at], comma, *tokens[at + 1 : at + 3], *tokens[past:]]
    alone = all(t in (*shapes, *numbers) or t.word in _UNITS for t in said)
    if len(shapes) != 1 or len(numbers) != 1 or not alone:
        return tokens
    while end < len(tokens) and tokens[end].word in _EVENLY:
        end += 1
    if end + 1 < len(tokens) and tokens[end].word == "(" and tokens[end + 1].word in ("every", "each"):
        end = next((k + 1 for k in range(end, len(tokens)) if tokens[k].word == ")"), end)
    if led > begin:  # "sc around with 6 increases spaced evenly"
        return [
            *tokens[:led],
            Token("mark", ",", tokens[led].start, tokens[led].start),
            shapes[0],
            numbers[0],
            *tokens[end:],
        ]
    listed = begin > 1 and tokens[begin - 1].word == "," and tokens[begin - 2].kind == "word"  # no "R4: dec 6 evenly"
    if listed and (begin == 2 or tokens[begin - 3].word in (":", ".", ",")):
        around = Token(
            "key", "~", tokens[begin - 1].start, tokens[begin - 1].start, "around"
        )  # "sc, decreasing 6 sts evenly"
        return [*tokens[: begin - 1], around, tokens[begin - 1], shapes[0], numbers[0], *tokens[end:]]
    made = [*tokens[:begin], shapes[0], numbers[0], *tokens[end:]]
    numbered = (
        1 < begin <= 3 and tokens[begin - 1].word == "." and tokens[begin - 2].kind == "number"
    )  # "4. Dec 2 evenly"
    if begin == 0 or numbered or tokens[begin - 1].word == ":" or not any(t.kind != "mark" for t in tokens[:begin]):
        place = tokens[begin]
        made[begin:begin] = [
            Token("stitch", "~", place.start, place.start, "sc"),
            Token("key", "~", place.start, place.start, "around"),
            Token("mark", ",", place.start, place.start),
        ]
    return made
