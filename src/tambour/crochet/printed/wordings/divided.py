"""Printed patterns, divided: legs that part from the body they are worked on, in the many words for it, put as most say it: the first over some of its stitches,
"sc in next 12 sts, leave remaining sts unworked", the second over those that are left, "Join yarn in the first skipped stitch"."""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import pairwise
from typing import Final

from tambour.crochet.printed.heads import heads
from tambour.crochet.printed.tokens import Row, Token
from tambour.crochet.printed.wordings.vocabulary import Vocabulary

_LIMB: Final = r"(?:leg|foot|arm|trouser leg|pant leg)"
_FIRST: Final = re.compile(
    rf"(?:\W )*(?:the )?(?:(?:first|1st|left|right|front|back) {_LIMB}|{_LIMB} (?:1|one|a|number 1|n 1))(?: \W)*$"
)
_SECOND: Final = re.compile(
    rf"(?:\W )*(?:the )?(?:(?:second|2nd|other|left|right) {_LIMB}|{_LIMB} (?:2|two|b|number 2|n 2))(?: \W)*$"
)
_DIVIDES: Final = re.compile(
    rf"(?:now )?(?:we(?: will|'ll)? |you(?: will|'ll)? )?(?:now )?(?:divide|split|separate|part)s? (?:\w+ ){{0,4}}?(?:for|into) (?:\w+ )?{_LIMB}s?"
)
_JOINS: Final = re.compile(
    r"(?:(?:with|using) [^,.]{1,30} , )?(?:re)?(?:join|attach|insert|start|begin|pick up|tie on|connect)\b(?=.*\b(?:skipped|unworked|unused|free|left|remaining|remain|rest|other (?:side|half|\d+)|body)\b).*"
)
_ALIKE: Final = re.compile(
    rf"(?:(?:work|make|crochet|complete|finish|repeat|rep|do) )?(?:(?:the )?(?:second|2nd|other|this) {_LIMB} )?(?:(?:as|like|same as|exactly as|just as|in the same way as|the same as|the same way as|to match|just like|exactly like) (?:for |you did for |with |on )?(?:the )?"
    rf"(?:first|1st|other|left|right) (?:{_LIMB}|one)|(?:in )?(?:exactly )?the same(?: way)?|(?:(?:rounds?|rnds?|rows?) )?\d+ - \d+(?: as)?(?: for| of| on| like)* (?:the )?(?:first|1st|second|2nd|other|left|right) {_LIMB})(?: {_LIMB})?$"
)
_CLOSING: Final = re.compile(
    r"(?: [,;])?(?: and| then)* (?:continue|go on|carry on|join|close|connect|sc|dc|sl st|slip st|work|crochet)\b[^.(\[]*?\bfirst\b[^.(\[]*$"
)
"""How the first leg's round is closed, which the stitches that it leaves say already: "and continue in the first of them"."""
_SETS: Final = re.compile(
    rf"(?:count|flatten|fold|mark|find|lay|pinch|bring|we will now work|now work|work only|work each|you will now work|the {_LIMB}s are worked|each {_LIMB} is worked|continue only|leave the remaining)\b.*\b(\d+|half)\b.*"
)
_PLAIN: Final = frozenset(
    "sc dc 1 a one single double crochet in each all every st sts stitch stitches around the next first of round to end of x evenly".split()
)


def divided(rows: list[Row], vocabulary: Vocabulary, plain: str) -> list[Row]:
    """``rows`` with legs that part from a body as most say it; single crochets are called ``plain``."""
    made = [
        one
        for k, row in enumerate(rows)
        for one in (
            [row] if k and rows[k - 1].tokens and rows[k - 1].tokens[-1].word not in _ENDS else _parted(row, vocabulary)
        )
    ]
    for second in range(len(made) - 1, -1, -1):  # from the end, as lines may be put behind it
        if made[second].tokens and _SECOND.match(_words(made[second].tokens)) is not None:
            _second(made, second, vocabulary, plain)
    return made


def _parted(row: Row, vocabulary: Vocabulary) -> list[Row]:
    """A paragraph that begins with the name of a leg as lines: its name, what is said before its rounds, and these."""
    end = next((k for k, t in enumerate(row.tokens) if t.word in (".", ":")), 0)
    if not end or end + 1 == len(row.tokens):
        return [row]
    name = _words(row.tokens[:end])
    if _FIRST.match(name) is None and _SECOND.match(name) is None:
        return [row]
    rest = row.tokens[end + 1 :]
    read = vocabulary.read(rest)
    at = {read[k].start for k, _ in heads(read)}
    begins = sorted({0, len(rest), *(k for k, t in enumerate(rest) if t.start in at)})
    parts = [row.tokens[:end], *(rest[a:b] for a, b in pairwise(begins))]
    return [Row(some, some[0].start, some[-1].end, row.marked if k == 0 else 0) for k, some in enumerate(parts) if some]


def _second(rows: list[Row], second: int, vocabulary: Vocabulary, plain: str) -> None:
    """Puts the two legs whose second has its heading there, where it is joined to stitches that the first left."""
    first = next((k for k in range(second - 1, -1, -1) if rows[k].tokens and _opens(rows[k].tokens)), None)
    near = [k for k in range(second + 1, min(second + 4, len(rows))) if rows[k].tokens]
    joins = next((k for k in near if _joined(rows[k].tokens)), None)
    if joins is None and near and _on_free(rows[near[0]].tokens, vocabulary):
        joins, place = near[0], rows[near[0]].tokens[0]  # "Rnd 9: sc in the 12 unworked sts": the yarn is joined there
        rows.insert(joins, Row(_put("join yarn in the skipped stitches .", place, place), place.start, place.end))
    if first is None or joins is None:
        return
    worked = [k for k in range(first, second) if rows[k].tokens and heads(vocabulary.read(rows[k].tokens))]
    if not worked or not any(rows[k].tokens and heads(vocabulary.read(rows[k].tokens)) for k in range(first)):
        return
    begin = worked[0]
    count = _stated(rows[begin].tokens)
    if not count:
        return
    opened = [t for k in range(first, begin + 1) if rows[k].tokens for t in vocabulary.read(rows[k].tokens)]
    if any(t.kind == "key" and t.value in ("ring", "hook") and not _closed(opened, k) for k, t in enumerate(opened)):
        return  # legs of their own, which a body joins
    for k in range(first, begin):  # "Count 12 stitches and join the 12th with the first": the round says it
        if _SETS.match(_words(rows[k].tokens)) is not None:
            rows[k] = replace(rows[k], tokens=[])
    rows[begin] = replace(rows[begin], tokens=_leaving(rows[begin].tokens, count, plain))
    _join(rows, joins, rows[begin:second], count, vocabulary, plain)


def _closed(tokens: list[Token], at: int) -> bool:
    """Whether a ring is what stitches are closed to: "which closes the leg to a ring"."""
    return any(t.word in _CLOSES for t in tokens[max(0, at - 6) : at])


_CLOSES: Final = frozenset(
    ("close", "closes", "closing", "form", "forms", "forming", "makes", "into", "join", "joining")
)


def _opens(tokens: list[Token]) -> bool:
    words = _words(tokens)
    return _FIRST.match(words) is not None or _DIVIDES.search(words) is not None


def _joined(tokens: list[Token]) -> bool:
    return any(_JOINS.match(_words(said)) is not None for said in _sentences(tokens))


def _on_free(tokens: list[Token], vocabulary: Vocabulary) -> bool:
    """Whether a round is worked into the stitches that were left."""
    free = any(t.word in ("unworked", "skipped", "unused", "free") for t in tokens)
    return (
        free
        and bool(heads(vocabulary.read(tokens)))
        and not any(t.word in ("loop", "loops", "leave", "leaving") for t in tokens)
    )


def _leaving(tokens: list[Token], count: int, plain: str) -> list[Token]:
    """The first round of the first leg with the stitches that it leaves: "sc around (12)", "12 sc, then sc in the first (12)"."""
    colon = next((k for k, t in enumerate(tokens) if t.word in (":", ")", "-") and k), None)
    if colon is None:
        return tokens
    head, body = tokens[: colon + 1], tokens[colon + 1 :]
    end = next((k for k in range(len(body) - 1, 0, -1) if body[k].word in ("(", "[", "=", "-", "{")), len(body))
    said, stated = body[:end], body[end:]
    leaves = any(t.word in ("skip", "leave", "leaving", "skipping", "unworked", "miss") for t in said)
    found = _CLOSING.search(_words(said))
    kept = len(_words(said)[: found.start()].split()) if found is not None else len(said)
    said = said[:kept]
    if leaves or not said:
        return [*head, *said, *stated]
    if any(t.word not in _PLAIN and t.kind != "mark" and t.value != count for t in said):
        return tokens
    a, b = said[0], said[-1]
    return [*head, *_put(f"{count} {plain} , leave remaining sts unworked", a, b), *stated]


def _join(rows: list[Row], joins: int, leg: list[Row], count: int, vocabulary: Vocabulary, plain: str) -> None:
    """Puts how the second leg begins, and its rounds where they are those of the first, ``leg``."""
    sentences = _sentences(rows[joins].tokens)
    at = next(k for k, said in enumerate(sentences) if _JOINS.match(_words(said)) is not None)
    said = sentences[at]
    if heads(vocabulary.read(said)):
        return
    hue = (
        said[1:2]
        if len(said) > 1 and said[1].kind == "word" and said[1].word not in _YARN
        else _put("yarn", said[0], said[0])
    )
    verb = said[: 2 + (len(said) > 2 and said[1].word == "the")]  # what is read is the words "Attach yarn"
    begun = [*_put("join", verb[0], verb[0]), *hue, *_put("in the first skipped stitch .", verb[0], verb[-1])]
    rest = [t for other in sentences[at + 1 :] for t in (*other, *_put(".", other[-1], other[-1]))]
    alike = next((k for k in range(joins, min(joins + 3, len(rows))) if _alike(rows[k], said)), None)
    if alike is None:
        below = next((k for k in range(joins + 1, len(rows)) if rows[k].tokens), len(rows))
        if below < len(rows) and heads(vocabulary.read(rows[below].tokens)):
            rows[below] = replace(rows[below], tokens=_first_of(rows[below].tokens, count, plain))
        rows[joins] = replace(rows[joins], tokens=[*begun, *rest])
        return
    rows[joins] = Row(begun, verb[0].start, verb[-1].end)
    b = (said if alike == joins else rows[alike].tokens)[-1]
    begins = _number(rows[alike], vocabulary)
    if begins > _number(leg[0], vocabulary):  # "Rnd 9: … Rnds 10-13: as for the first leg"
        own = next(k for k in range(joins + 1, alike + 1) if rows[k].tokens)
        rows[own] = replace(rows[own], tokens=_first_of(rows[own].tokens, count, plain))
        begun_at = next((k for k, row in enumerate(leg) if _number(row, vocabulary) >= begins), 0)
        leg = leg[begun_at:]
    else:
        leg = [replace(leg[0], tokens=_first_of(leg[0].tokens, count, plain)), *leg[1:]]
    again = [[replace(t, start=b.start, end=b.end) for t in row.tokens] for row in leg if row.tokens]
    copied = [Row(tokens, b.start, b.end) for tokens in again]
    rows[alike : alike + 1] = [rows[joins], *copied] if alike == joins else copied


_ENDS: Final = frozenset((".", ")", "]", ":", "!"))
_LEAVES: Final = frozenset(
    "leave leaving remaining rem rest skip skipping unworked work on to over only with round rnd body skipped unused free".split()
)
_YARN: Final = frozenset("yarn the a your in to at on with new thread".split())


def _alike(row: Row, join: list[Token]) -> bool:
    """Whether a line says that its leg is worked as the other one was."""
    for said in _sentences(row.tokens):
        words = _words(said)
        if said == join:
            words = next((w for w in re.split(r" (?:and|,|then) ", words)[1:] if _ALIKE.search(w)), "")
        if words and (found := _ALIKE.search(words)) is not None and found.end() == len(words):
            return True
    return False


def _first_of(tokens: list[Token], count: int, plain: str) -> list[Token]:
    """The first round of the second leg on the stitches that are left: "sc around (12)" as "sc in the 12 skipped sts (12)"."""
    colon = next((k for k, t in enumerate(tokens) if t.word in (":", ")", "-") and k), None)
    if colon is None:
        return tokens
    head, body = tokens[: colon + 1], tokens[colon + 1 :]
    end = next((k for k in range(len(body) - 1, 0, -1) if body[k].word in ("(", "[", "=", "-", "{")), len(body))
    said, stated = body[:end], body[end:]
    if not said or any(
        t.word not in _PLAIN and t.word not in _LEAVES and t.kind != "mark" and t.value != count for t in said
    ):
        return tokens
    return [*head, *_put(f"{plain} in the {count} skipped sts", said[0], said[-1]), *stated]


def _number(row: Row, vocabulary: Vocabulary) -> int:
    """The number of the round that a line begins with; 0 for none."""
    found = heads(vocabulary.read(row.tokens)) if row.tokens else []
    return found[0][1].numbers[0] if found and found[0][1].numbers else 0


def _stated(tokens: list[Token]) -> int:
    """The count that a round's line ends with; 0 for none."""
    numbers = [t.value for t in tokens if t.kind == "number" and isinstance(t.value, int)]
    return (
        int(numbers[-1])
        if len(numbers) > 1 and tokens[-1].word in (")", "]", "}", ".", "sts", "st", "sc", "stitches")
        else 0
    )


def _sentences(tokens: list[Token]) -> list[list[Token]]:
    made: list[list[Token]] = [[]]
    for token in tokens:
        if token.word == ".":
            made.append([])
        else:
            made[-1].append(token)
    return [said for said in made if said]


def _words(tokens: list[Token]) -> str:
    return " ".join(t.word for t in tokens)


def _put(words: str, first: Token, last: Token) -> list[Token]:
    """Tokens of ``words``, which stand where those from ``first`` to ``last`` did."""
    made = []
    for word in words.split():
        kind = "number" if word.isdigit() else "word" if word[0].isalpha() else "mark"
        made.append(Token(kind, word, first.start, last.end, int(word) if kind == "number" else None))
    return made
