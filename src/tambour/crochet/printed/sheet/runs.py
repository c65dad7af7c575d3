"""Printed patterns, runs: rounds that follow each other on one line, as posts and notes have them, each on its own: ``R1 6sc in MR (6) R2 inc (12)``; and
lists of nothing but the stitches of each round: ``6, 12, 18, 24``."""

from __future__ import annotations

import itertools
from typing import Final

from tambour.crochet.printed.heads import heads
from tambour.crochet.printed.tokens import Row, Token
from tambour.crochet.printed.wordings.vocabulary import Vocabulary

_NAMING: Final = frozenset(
    "between and to from as until in over same with next last repeat each even around join".split()
)
"""What words before a round mean that only speak of it."""
_SPEAKING: Final = frozenset(
    "of on at after before through thru like for by under above below along since end row round rnd".split()
)
_ENDED: Final = (")", "]", "}", ".", ",", ";", "!", ":", "|")
_SIGNS: Final = (",", "-", "/", ";", ">")
_LISTED: Final = 4  # numbers of a list of rounds
_MOST: Final = 400  # stitches of a round of such a list
_LOOPS: Final = ("back loops", "front loops")


def parted(text: str, rows: list[Row], vocabulary: Vocabulary) -> list[Row]:
    """``rows`` with lines of several rounds, of which some are seen only by their numbers, as lines of one."""
    made: list[Row] = []
    for row in rows:
        cuts = (
            round_starts(row.tokens, vocabulary)
            if len(row.tokens) > 8 and any(c.isdigit() for t in row.tokens for c in t.word[-1:])
            else []
        )
        seen = {at for at, _ in heads(vocabulary.read(row.tokens), text)} if len(cuts) > 1 else set()
        places = {t.start for k, t in enumerate(vocabulary.read(row.tokens)) if k in seen} if len(cuts) > 1 else set()
        if len(cuts) < 2 or all(row.tokens[k].start in places for k in cuts):
            made.append(row)
            continue
        for a, b in zip(
            [0, *cuts] if cuts[0] else cuts, [*cuts, len(row.tokens)] if cuts[0] else [*cuts[1:], len(row.tokens)]
        ):
            some = row.tokens[a:b]
            if b < len(row.tokens) and some[-1].word == ",":
                some = some[:-1]
            if some:
                made.append(Row(some, some[0].start, some[-1].end, 0))
    return made


def round_starts(tokens: list[Token], vocabulary: Vocabulary) -> list[int]:
    """Where rounds begin in a line whose numbers follow each other."""
    cuts: list[int] = []
    last = k = ended = 0
    while k < len(tokens):
        found = _head(tokens, k, vocabulary)
        if found is None:
            k += 1
            continue
        first, final, end = found
        colon = end < len(tokens) and tokens[end].word == ":"
        begins = not k or (not _speaks(tokens[k - 1], vocabulary) if colon else tokens[k - 1].word in _ENDED)
        begins = begins and (not ended or any(t.kind != "mark" for t in tokens[ended:k]))  # "R4, R6, R8:"
        follows = first == last + 1 if cuts else (first == 1 or not k)
        if begins and (follows or (colon and first > last) or first == 1) and end < len(tokens):
            cuts.append(k)
            last = final
        k = ended = end
    return cuts


def _speaks(token: Token, vocabulary: Vocabulary) -> bool:
    """Whether the word before a round only leads to its name: "between R6 and R7"."""
    if token.kind != "word":
        return token.word in ("-", "&", "/")
    read = vocabulary.read([token])
    return token.word in _SPEAKING or not read or (read[0].kind == "key" and read[0].value in _NAMING)


def _head(tokens: list[Token], k: int, vocabulary: Vocabulary) -> tuple[int, int, int] | None:
    """The first and last number of a round named at ``k``, and where its words begin; None where none is named."""
    found = _named(tokens, k, vocabulary)
    if found is None:
        return None
    first, end = found
    if end + 1 < len(tokens) and (tokens[end].word in ("-", "&", "~", "+", "/") or _ranges(tokens, end, vocabulary)):
        more = _named(tokens, end + 1, vocabulary) or _plain(tokens, end + 1)
        if more is not None and more[0] > first:
            return first, more[0], more[1]
    return first, first, end


def _ranges(tokens: list[Token], end: int, vocabulary: Vocabulary) -> bool:
    """Whether a word stands there that may lead to the last of several rounds: "V7 a V13", "Rnd 3 and 4"."""
    read = vocabulary.read(tokens[end : end + 1]) if tokens[end].kind == "word" else []
    return bool(read) and read[0].kind == "key" and read[0].value in ("to", "and", "in")


def _plain(tokens: list[Token], k: int) -> tuple[int, int] | None:
    number = tokens[k]
    return (number.value, k + 1) if number.kind == "number" and isinstance(number.value, int) else None


def _named(tokens: list[Token], k: int, vocabulary: Vocabulary) -> tuple[int, int] | None:
    """The number of a round said at ``k``, "R5", "Rnd 5", "Round #5", and where what follows begins."""
    token = tokens[k]
    if token.kind != "word":
        return None
    letters = token.word.rstrip("0123456789")
    if letters != token.word:
        if not letters or (letters != "r" and not vocabulary.counts(letters)):
            return None
        return int(token.word[len(letters) :][:6]), k + 1
    if len(token.word) > 7 or k + 1 >= len(tokens):
        return None
    at = k + 1 + (tokens[k + 1].word in (".", "#"))
    found = _plain(tokens, at) if at < len(tokens) else None
    return found if found is not None and vocabulary.counts(token.word) else None


def listed(rows: list[Row], vocabulary: Vocabulary) -> list[Row]:
    """``rows`` with lists of nothing but stitches as the rounds that they mean: increases and decreases that nothing places are spread."""
    made: list[Row] = []
    k, any_listed = 0, False
    while k < len(rows):
        chained = bool(made) and any(t.word in ("ch", "chain") for t in made[-1].tokens)
        run, end = _column(rows, k, vocabulary)
        if not run:
            run, end = _list(rows[k].tokens, vocabulary), k + 1
        headed = bool(made) and bool(made[-1].tokens) and made[-1].tokens[0].kind == "word"
        if not run or (len(run) < _LISTED and not (any_listed and headed)):
            made.append(rows[k])
            k += 1
            continue
        any_listed = True
        last = 0
        for n, (number, more) in enumerate(run, 1):
            made.append(_rounds(number, more, n, last, chained))
            last = int(number.value)
        k = end
    return made


def _column(rows: list[Row], at: int, vocabulary: Vocabulary) -> tuple[list[tuple[Token, list[Token]]], int]:
    """Lines of a number each."""
    run = []
    while at < len(rows) and (one := _alone(rows[at].tokens, vocabulary)) is not None:
        run.append(one)
        at += 1
    return (run if run and _grows(run) else []), at


def _alone(tokens: list[Token], vocabulary: Vocabulary) -> tuple[Token, list[Token]] | None:
    """A number that is all of a line, or of a part of a list, but for loops: "24 BLO"."""
    if not 0 < len(tokens) <= 4 or tokens[0].kind != "number" or not isinstance(tokens[0].value, int):
        return None
    more = vocabulary.read(tokens[1:])
    if any(not (t.kind == "key" and t.value in (*_LOOPS, "stitch", "in", "ring")) and t.value != "sc" for t in more):
        return None
    return (
        (tokens[0], [t for t in tokens[1:] if any(m.value in _LOOPS and m.start <= t.start < m.end for m in more)])
        if 2 < tokens[0].value < _MOST
        else None
    )


def _list(tokens: list[Token], vocabulary: Vocabulary) -> list[tuple[Token, list[Token]]]:
    """A line of numbers with signs between them."""
    sign = tokens[1].word if len(tokens) > 2 and tokens[0].kind == "number" else ""
    if sign not in _SIGNS:
        return []
    parts: list[list[Token]] = [[]]
    for token in tokens:
        if token.word == sign:
            parts.append([])
        else:
            parts[-1].append(token)
    found = [_alone(part, vocabulary) for part in parts]
    run = [one for one in found if one is not None]
    return run if len(run) == len(parts) and _grows(run) else []


def _grows(run: list[tuple[Token, list[Token]]]) -> bool:
    """Whether numbers may be the stitches of rounds: none is more than double the one before, and some are worked even or by equal steps."""
    counts = [int(number.value) for number, _ in run]
    fits = all(b <= 2 * a and 2 * b >= a for a, b in itertools.pairwise(counts))
    return fits and counts[0] <= 60 and (len(counts) < 2 or any(b != a + 1 for a, b in itertools.pairwise(counts)))


def _rounds(number: Token, more: list[Token], n: int, last: int, chained: bool) -> Row:
    """The round of one number of a list."""
    at, count = number.start, int(number.value)

    def word(said: str, kind: str = "word") -> Token:
        value = int(said) if said.isdigit() else None
        return Token("number" if said.isdigit() else kind, said, at, number.end, value)

    said = ["row" if chained else "round", str(n), ":"]
    if not last:
        body = [str(count), "sc", *(["around"] if chained else ["in", "mr"])]
    elif count == last:
        body = ["sc", "around"]
    elif count == 2 * last:
        body = ["inc", "around"]
    else:
        body = ["sc", "around", ",", "increasing" if count > last else "decreasing", str(abs(count - last)), "sts"]
    made = [word(w, "mark" if not w.isalnum() else "word") for w in said]
    made += [
        *more,
        *([word(",", "mark")] if more else []),
        *(word(w, "mark" if not w.isalnum() else "word") for w in body),
    ]
    if last:
        made += [word("(", "mark"), word(str(count)), word(")", "mark")]
    return Row(made, number.start, more[-1].end if more else number.end)
