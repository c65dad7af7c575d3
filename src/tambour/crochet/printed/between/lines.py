"""Printed patterns, lines: which of them go on with the one before, since the page ended there, and which of a bare number are rounds."""

from __future__ import annotations

from itertools import pairwise
from typing import Final

from tambour.crochet.printed.between.opening import founding
from tambour.crochet.printed.cursor import OPEN, Cursor
from tambour.crochet.printed.sheet.wrapping import step
from tambour.crochet.printed.state import State
from tambour.crochet.printed.tokens import Row, Token

_NAME: Final = 3  # words of a part's name
_COUNT: Final = 3  # words of a count: "24 sc", "24 sc sts"
_SHORT: Final = 12  # words of a line that only ends the round above it

_LIFTS: Final = 4  # chains that only lift the yarn
_BY_HAND: Final = frozenset(("stuff", "fasten off", "close", "eyes", "marker"))
"""What hands do between rounds, on a line of its own."""
_LISTS: Final = ("*", "-", "–", "•", "·", "●", "▪", "+")
"""Signs of the things of a list."""
_TOLD: Final = 5  # words of a sentence behind an asterisk, more than
_REMARKS: Final = frozenset(("note", "notes", "tip", "hint", "nb"))
"""What a bracket begins with that only tells of the round above."""
_POINTS: Final = frozenset(_LISTS) - {"*", "+"}
"""Those that are no sign of a repeat."""


def wrapped(p: State, row: Row, after: Row) -> bool:
    """Whether a sentence of a long line goes on in the next."""
    if not after.tokens or row.marked or row.tokens[-1].word in (".", ":", "!", "?"):
        return False
    whole = p.source.text.text
    if whole[whole.rfind("\n", 0, after.tokens[0].start) + 1 : after.tokens[0].start].strip() in _LISTS:
        return False  # "* eyes: …" is the next of a list
    if row.tokens[-1].word == "between":
        return True  # "between | Rows 8 and 9" begins no round
    if row.tokens[-1].word in ("and", "the", "to", "of", "in", "with", "for", "as", "from", "embroider", "using"):
        return not p.vocabulary.heads(after.tokens)
    if row.end - row.start < p.long:
        return False
    first = p.source.text.text[after.tokens[0].start]
    if step(whole, after):
        return False
    listed = p.mode == "materials" and first.isdigit()  # "3.5 mm hook" is the next thing of a list
    return ((first.islower() and not p.small) or (first.isdigit() and not listed)) and not p.vocabulary.heads(
        after.tokens
    )


_TURNING: Final = 12  # words of a sentence that says how rows turn


def turning(tokens: list[Token]) -> bool:
    """Whether words only say that every row is turned with so many chains: "ch 1 and turn after each one", "1 turning chain each row"."""
    words = [t for t in tokens if t.kind != "mark"]
    if not 2 < len(words) <= _TURNING or any(t.kind == "stitch" and t.value != "ch" for t in words):
        return False
    turned = any(t.value == "turn" or t.word in ("turn", "turning") for t in words)
    every = any(t.value == "each" for t in words)
    numbers = [t.value for t in words if t.kind == "number"]
    chained = any(t.value == "ch" for t in words)
    return turned and every and chained and len(numbers) <= 1 and all(n in (1, 2, 3) for n in numbers)


def goes_on(p: State, before: list[Token], at: int) -> list[Token] | None:
    """The tokens of line ``at``, which goes on with the round before it; None when it does not."""
    row = p.rows[at]
    if not row.tokens:
        return None
    tokens = p.vocabulary.read(row.tokens)
    if (
        not tokens
        or p.vocabulary.heads(row.tokens)
        or turning(tokens)
        or (p.mode == "assembly" and step(p.source.text.text, row))
    ):
        return None
    if [t.kind for t in tokens] == ["stitch", "mark"] and tokens[1].word == ":":
        return None  # "Sc2tog:", above how it is made
    if [t.value for t in tokens[-3:-2]] == ["make"] and tokens[-2].kind == "number" and tokens[-1].word == ")":
        return None  # "Spike (make 3)" heads a part
    if before[-1].word == "," and _heads_part(p, at):
        return None  # "… until piece measures 7 in.,", "Bib" and "Row 1:" below it
    depth = sum((t.word in OPEN) - (t.word in ")]}>") for t in before if t.kind == "mark")
    last, first = before[-1], tokens[0]
    if depth > 0 or last.word in (",", "+", "&") or (last.kind == "key" and last.value in ("and", "in", "next", "to")):
        return tokens
    if _pointed(p, row) and any(t.kind == "stitch" for t in before):
        return None  # the next point of a list, whose numbers the page drew
    if first.kind == "mark" and first.word in "([" and len(tokens) > 1 and tokens[1].word in _REMARKS:
        return None  # "(Note: …)" below a round is no more of it
    if first.word == "*" and len(tokens) > _TOLD and tokens[1].capital:
        made = tokens[1].value == "make" and tokens[2].kind == "word"  # "*Make sure …"
        if made or tokens[1].kind == "word":
            return None  # "*When I sewed them on …"
    if first.kind == "mark" and first.word in "([{*=":
        hue = p.palette.color(Cursor(tokens), 1) if first.word in "([" else None
        return None if hue is not None and hue[1] == len(tokens) - 2 else tokens  # "(Red)" heads the next rounds
    stays = [t.value for t in tokens[:2]] == ["not", "turn"]  # "Do not turn. Working into opposite side of ch, …"
    told = tokens[3:] if stays else tokens
    if told and told[0].value in ("in", "around", "over", "side", "turn") and _other_side(told) and not _joined(before):
        return tokens  # "Working in rem loops of foundation ch, …" goes on with the first round
    head = p.vocabulary.heads(p.rows[at - 1].tokens) if p.rows[at - 1].tokens else []
    alone = bool(head) and head[0][1].strong and head[0][1].end == len(before) and not row.marked
    if alone and first.value in ("with", "ring", "begin") and any(t.kind == "stitch" for t in tokens):
        return tokens  # "Round 1:", and "With red yarn, ch 20, …" below it
    below = p.rows[at - 1].tokens and not row.marked and not founding(tokens)
    worked = (first.kind == "stitch" and first.value not in ("slst", "ch")) or (
        first.kind == "number" and len(tokens) > 1 and tokens[1].kind == "stitch"
    )
    counted = last.word in (")", "]", "}") or (
        last.value == "stitch" and len(before) > 1 and before[-2].kind == "number"
    )
    counted = counted or (len(before) > 2 and last.kind == "number" and before[-2].word == "=")
    if counted and any(t.kind == "key" and t.value == "fasten off" for t in tokens):
        return None  # "Rnds 8-20: dc. 12 sts", and "1 dc, ss, fasten off" below it
    if below and (worked or (first.kind == "key" and first.value in ("turn", "join") and len(tokens) < _SHORT)):
        return tokens  # the sentences of a round on lines of their own
    if any(t.kind == "key" and t.value in _BY_HAND for t in tokens[:3]) and not any(t.kind == "stitch" for t in tokens):
        return None  # "R13  15X = 15", and "stuff" or "start to stuff here" below it
    led = row.start < first.start and p.source.text.text[row.start].isupper()  # "We cut …", "At this stage, switch …"
    plain = (p.source.text.text[first.start].islower() and not led) or first.kind == "number"
    times = first.value in ("twice", "once") or (
        first.kind == "number" and len(tokens) > 1 and tokens[1].kind == "key" and tokens[1].value == "times"
    )
    if times and last.word in (")", "]", "}"):
        return tokens
    if plain and last.word not in (".", ")", "]", "}") and first.kind in ("stitch", "key", "number"):
        return tokens
    return None


def _pointed(p: State, row: Row) -> bool:
    """Whether a line bears the sign of a point of a list."""
    whole, first = p.source.text.text, row.tokens[0].start
    return whole[whole.rfind("\n", 0, first) + 1 : first].strip() in _POINTS


def _heads_part(p: State, at: int) -> bool:
    """Whether line ``at`` is no more than a name with a capital, over a first round."""
    words, below = p.rows[at].tokens, p.rows[at + 1].tokens if at + 1 < len(p.rows) else []
    if not 0 < len(words) <= _NAME or any(t.kind != "word" for t in words) or not words[0].capital:
        return False
    found = p.vocabulary.heads(below)
    return bool(found) and found[0][0] == 0 and found[0][1].numbers[:1] == (1,)


def _other_side(tokens: list[Token]) -> bool:
    """Whether the first clause of a line speaks of the other side of the foundation chain."""
    end = next((k for k, t in enumerate(tokens) if t.word in (",", ".", ";", ":")), len(tokens))
    return any(t.kind == "key" and t.value == "side" for t in tokens[:end])


def _joined(before: list[Token]) -> bool:
    """Whether a round that did not begin in a chain from the hook, or that is joined, stands before."""
    keys = [t.value for k, t in enumerate(before) if t.kind == "key" and not (k and before[k - 1].value == "not")]
    begun = next((k for k, t in enumerate(before) if t.kind == "stitch"), len(before))
    near = [*before[max(0, begun - 1) : begun], *before[begun + 1 : begun + 2]]
    chained = before[begun : begun + 1] and before[begun].value == "ch"  # "ch 20, sl st in next 3 ch, …"
    chained = chained and any(t.kind == "number" and t.value > _LIFTS for t in near)
    side = any(t.kind == "key" and t.value == "side" for t in before)
    return not ("hook" in keys or chained) or "join" in keys or side


def stop_between(p: State, before: list[Token], at: int) -> list[Token]:
    """The point that lacks where a round's line ends with its count, "(11)" or "- 24 sc", and line ``at`` begins a sentence; else nothing."""
    if not p.rows[at].tokens[0].capital:
        return []
    begin = max((k for k, t in enumerate(before) if t.word in (*OPEN, "-", "=")), default=-1)
    said = [t for t in before[begin + 1 :] if t.word not in (")", "]", "}")]
    closed = begin >= 0 and (before[begin].word not in OPEN or before[-1].word in (")", "]", "}"))
    count = closed and 0 < len(said) <= _COUNT and said[0].kind == "number"
    if not count or not all(t.kind == "stitch" or t.value == "stitch" for t in said[1:]):
        return []
    return [Token("mark", ".", before[-1].end, before[-1].end)]


_SEWN: Final = frozenset(("sew", "pin", "whipstitch", "whip", "embroider", "glue"))
"""What begins no round, whatever its number."""


def _counts(tokens: list[Token], k: int) -> bool:
    """Whether a bracket at ``k`` holds a count of the stitches that stand before it."""
    one, two, three = tokens[k : k + 3]
    stitches = any(t.kind == "stitch" for t in tokens[:k])
    return one.word in ("(", "[") and two.kind == "number" and three.word in (")", "]") and stitches


def rounds(tokens: list[Token], assembly: bool = False) -> bool:
    """Whether the text after a bare number is a round's. assembly : it stands where parts are put together, whose numbered steps are
    sentences unless they found a piece."""
    counted = next((k for k in range(1, len(tokens) - 2) if _counts(tokens, k)), None)
    # What stands behind its count is said by the way: "24 sc (24) - add the eyes here".
    words, whole = ([t for t in some if t.kind != "mark"] for some in (tokens[:counted], tokens))
    if words and words[0].word in _SEWN:
        return False  # "3. Sew the first spike to the head, 2 sc from the eyes"
    known = sum(t.kind in ("stitch", "number", "ordinal", "key") for t in words)
    ringed = any(
        {a.value, b.kind} == {"ring", "number"} or {b.value, a.kind} == {"ring", "number"} for a, b in pairwise(whole)
    )
    if assembly and not ringed and not founding(tokens):
        return False
    return (ringed or any(t.kind == "stitch" for t in words)) and known * 3 >= len(words) * 2
