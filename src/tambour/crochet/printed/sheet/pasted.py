"""Printed patterns, pasted: what becomes of a page's lists and letters on their way through a clipboard: rounds without the numbers that
the page drew, ``- 6 sc in MR (6)``, rounds that share a line, ``(12) - Rnd 10: 6 dec``, names that stand right before a head, ``CapRnd 1:``,
and letters that a machine took for others, ``3 row: (1 ѕс, іnс) х 6``; put as other patterns are."""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import pairwise
from typing import Final

from tambour.crochet.printed.heads import heads
from tambour.crochet.printed.sheet.listings import headed, ranged, relaid
from tambour.crochet.printed.tokens import Row, Token
from tambour.crochet.printed.wordings.reworded import reworded
from tambour.crochet.printed.wordings.vocabulary import Vocabulary
from tambour.crochet.words.numbers import NUMBERS
from tambour.crochet.words.sayings import Sayings

_LIKE: Final = str.maketrans(
    "асеорхуіѕјһԁкАВЕКМНОРСТХІЅЈУοΟυνκΑΒΕΖΗΙΚΜΝΡΤΥΧ", "aceopxyisjhdkABEKMHOPCTXISJYoOuvkABEZHIKMNPTYX"
)
"""Letters of other alphabets that look like ours."""
_FOREIGN: Final = re.compile("[" + "".join(map(chr, _LIKE)) + "]")
_MIXED: Final = re.compile(r"[^\W\d_]+")
_LATIN: Final = re.compile(r"[A-Za-z]")
_RAISED: Final = re.compile(r"(?<=\d)\^\{(st|nd|rd|th)\}|(?<=\d)(?:ˢᵗ|ⁿᵈ|ʳᵈ|ᵗʰ)")
_LOWERED: Final = {"ˢᵗ": "st", "ⁿᵈ": "nd", "ʳᵈ": "rd", "ᵗʰ": "th"}
"""Letters of "1st" that a page sets above its line."""
_NO_WORD: Final = re.compile(r"Â(?![^\W_])")
"""What a page that is read in another encoding has before a blank that does not break."""
_MARKED: Final = re.compile(r"Â (?=[\d(])|(?<=[:;.]) ?Â(?=[\W\d])|(?<=[^\W\d_])Â(?=\s*[(:])")
_GLUED: Final = re.compile(
    r"(?<=[a-zà-þ])(?=(?:R|Rnd|Rnds|Rd|Round|Rounds|Row|Rows)[ ]?\d{1,3}(?:[ ]?[-–][ ]?\d{1,3})?[ ]?[:.)])"
)
"""Where a name ends that a head follows with nothing between: "StemRnd 1:"."""
_RUN: Final = 2  # rounds of a list whose numbers the page drew
_FAR: Final = 4  # lines that may stand between two of them
_AHEAD: Final = 4  # words among which a line's own number stands
_ROUNDED: Final = frozenset("round row".split())
_ENDS: Final = (")", "]", "}")
_SHORT: Final = frozenset(("ch", "sc", "dc", "hdc", "tr", "inc", "dec"))


_FOUNDING: Final = frozenset(("ring", "circle", "loop", "hook"))
_LETTERED: Final = 3  # lines that begin so
_ROW_LETTERS: Final = frozenset(("r", "p", "rub", "rubles", "ruble"))
_SAYING: Final = frozenset(
    (
        "rounds",
        "rnds",
        "rows",
        "base",
        "marker",
        "second",
        "2nd",
        "/",
        "total",
        "turning",
        "working",
        "sctog",
        "complete",
        "whole",
        "entire",
    )
)
_TIMES: Final = re.compile(r"[x*×]\d*$")
"""What says how often, behind what is repeated."""
_LAST: Final = r"(?= ?[(\[=]| ?[.;]?$)"
_SAYINGS: Final = Sayings(
    (rf"(?<!\S){said}", meant)
    for said, meant in (
        (r"^(sc|hdc|dc) \( (\d+) \) [-,] (\d+|two|three|four|five|six) (?:rounds|rnds|rows)(?: \.)?$", "{1} around for {3} rounds ( {2} )"),
        (r"with (?:a )?base of (\d+)(?!\S)", ", {1}"),
        (rf"(sc|hdc|dc) (?:to|until|till) (?:the |your )?(?:stitch )?marker(?!\S){_LAST}", "{1} in each st to end"),
        (rf"(\d+) (sc|hdc|dc) in(?:to)? (?:the )?(second|2nd) (?:ch|chain)(?!\S){_LAST}", "{1} {2} in {3} ch from hook"),
        (r"(sc2tog|dec|invdec) / (?:sc2tog|dec|invdec|dex)(?!\S)", "{1}"),
        (r"(?:crochet|work) the (?:complete|whole|entire) round in(?:to)? the (front|back) loops? only[ .:,]*", "in {1} loops only ,"),
        (r"sctog closed (\d+)", "{1} sc through both layers"),
        (r"(\d+) turning (?:ch|chain)(?!\S)", "ch {1} , turn"),
        (r"- (?:in )?total \d+ (?:rnds|rounds|rows)$", ""),
        (r"\( (\d+) \) (\d+|two|three|four|five|six) total (?:rnds|rounds|rows)$", "for {2} rounds ( {1} )"),
        (r"^((?:make \w+ , )?(?:with|using|in) (?:\S+ ){1,4}), working in (?:the )?(?:rounds?|rows?)$", "{1}"),
    )
)  # fmt: skip


def ours(text: str) -> str:
    """``text`` with letters that only look like ours as ours, and without what another encoding left in it; every place stays.

    >>> ours("3 rоw: (1 sс, inс) х 6")
    '3 row: (1 sc, inc) x 6'
    """
    if "^{" in text or "ᵗ" in text or "ᵈ" in text:
        text = _RAISED.sub(lambda m: (m[1] or _LOWERED[m[0]]).ljust(len(m[0])), text)
    if text.isascii():
        return text
    if "Â" in text:
        text = _MARKED.sub(lambda m: " " * len(m[0]), text)
        text = _NO_WORD.sub(" ", text)
    if not _FOREIGN.search(text):
        return text
    words = [word for word in _MIXED.findall(text) if not word.isascii()]
    mixed = sum(_mixed(word) for word in words)
    if not mixed:
        return text
    theirs = sum(_LATIN.search(word) is None and not word.translate(_LIKE).isascii() for word in words)
    mostly = mixed > theirs  # no bilingual text, of which words in letters like ours may be the other language's

    def put(line: str) -> str:
        # Of words that are wholly theirs a name stays what she calls herself, where no other word of its line is mixed.
        named = not any(_mixed(word) for word in _MIXED.findall(line))

        def word(found: re.Match[str]) -> str:
            said = found[0].translate(_LIKE)
            alike = _LATIN.search(found[0]) is not None or (mostly and not (named and len(said) > 2))
            return said if alike and said.isascii() else found[0]

        return _MIXED.sub(word, line)

    return "\n".join(map(put, text.split("\n")))


def _mixed(word: str) -> bool:
    """Whether a word has letters of ours and such as only look so."""
    return not word.isascii() and _LATIN.search(word) is not None and _FOREIGN.search(word) is not None


def pasted(text: str, rows: list[Row], vocabulary: Vocabulary, called: str) -> list[Row]:
    """``rows`` as they stood on the page. called : the word for a round."""
    cuts = [found.start() for found in _GLUED.finditer(text)]
    rows = [_opened(row, cuts) for row in rows] if cuts else rows
    rows = [_said(_pointed(row)) for row in rows]
    rows = _lettered(rows) if vocabulary.code in ("us", "uk", "letters") else rows
    rows = _resumed(_sloped(relaid(text, rows, vocabulary, called)))
    rows = [part for row in rows for part in _apart(row, vocabulary)]
    return _relisted(text, rows, vocabulary, called)


def _opened(row: Row, cuts: list[int]) -> Row:
    """``row`` with a word that ends in a head as two."""
    here = {cut for cut in cuts if row.start < cut < row.end}
    if not here:
        return row
    made: list[Token] = []
    for token in row.tokens:
        cut = next((cut for cut in here if token.start < cut < token.end), 0)
        if not cut:
            made.append(token)
            continue
        k = cut - token.start
        made += [
            replace(token, word=token.word[:k], end=cut, value=None),
            replace(token, word=token.word[k:], start=cut, value=None, glued=True, capital=True),
        ]
    return replace(row, tokens=made)


def _pointed(row: Row) -> Row:
    """``row`` without the point of a short word that a number follows: "Ch. 5"."""
    tokens = row.tokens
    k = next(
        (
            k
            for k in range(len(tokens) - 2)
            if tokens[k].word in _SHORT
            and tokens[k + 1].word == "."
            and tokens[k + 1].glued
            and tokens[k + 2].kind == "number"
            and not tokens[k + 2].glued
            and (
                tokens[k].capital if not k else tokens[k - 1].kind == "mark"
            )  # no "first | sc. 32 sc", broken by the page
            and not (k and tokens[k].capital and tokens[k - 1].word == ".")
        ),
        None,
    )
    return row if k is None else replace(row, tokens=[*tokens[: k + 1], *tokens[k + 2 :]])


def _said(row: Row) -> Row:
    """``row`` with what blogs say in words of their own as most others do."""
    tokens = _barred(row.tokens)
    words = {t.word for t in tokens}
    if not words.isdisjoint(_SAYING):
        tokens = reworded(tokens, _SAYINGS)
    if "or" in words and (at := _unclosed(tokens)):
        tokens = tokens[:at]
    return row if tokens is row.tokens else replace(row, tokens=tokens)


def _barred(tokens: list[Token]) -> list[Token]:
    """``tokens`` with bars around what is repeated as brackets: "|inc, sc| x6"."""
    bars = [k for k, t in enumerate(tokens) if t.word == "|"]
    if len(bars) < 2 or len(bars) % 2:
        return tokens
    pairs = list(zip(bars[::2], bars[1::2], strict=True))
    if not all(b + 1 < len(tokens) and _TIMES.match(tokens[b + 1].word) for _, b in pairs):
        return tokens
    made = list(tokens)
    for a, b in pairs:
        made[a], made[b] = replace(tokens[a], word="("), replace(tokens[b], word=")")
    return made


def _unclosed(tokens: list[Token]) -> int:
    """Where a bracket opens that says another way and is never closed: "6 sc in 2nd ch (or 6 sc in magic ring"; 0 for none."""
    for k in range(len(tokens) - 1, 1, -1):
        if tokens[k].word in _ENDS:
            return 0
        if tokens[k].word == "(":
            founds = any(t.word in _FOUNDING for t in tokens[k:])  # other work behind a bracket that lacks is told
            return k if k + 1 < len(tokens) and tokens[k + 1].word == "or" and founds else 0
    return 0


def _lettered(rows: list[Row]) -> list[Row]:
    """``rows`` of a text that a machine put into English out of one that has a letter for its rows and another for its loops: "1r. 6 sc",
    "2p. 6 inc (12p)", "8 rubles-14 rubles 20 sc"."""
    found = {k: ends for k, row in enumerate(rows) if (ends := _by_letter(row.tokens)) is not None}
    if len(found) < _LETTERED or not _follow([numbers for numbers, _ in found.values()]):
        return rows
    made = list(rows)
    for k, (numbers, end) in found.items():
        tokens = rows[k].tokens
        at = tokens[0].start
        rest = [
            t
            for n, t in enumerate(tokens)
            if n >= end and not (t.word == "p" and tokens[n - 1].kind == "number" and t.glued)
        ]
        head = [Token("word", "row", at, at, capital=True), *numbers, Token("mark", ":", at, at, None, True)]
        made[k] = replace(rows[k], tokens=[*head, *rest])
    return made


def _by_letter(tokens: list[Token]) -> tuple[list[Token], int] | None:
    """The numbers of such a line's rows, with the dash between them, and where its words begin."""
    k = 0
    numbers: list[Token] = []
    if ranged([*tokens[:3], Token("mark", ":", 0, 0), Token("mark", ":", 0, 0)], 0):
        numbers, k = tokens[:2], 2  # "8-12p"
    while k + 2 < len(tokens) and tokens[k].kind == "number" and tokens[k + 1].word in _ROW_LETTERS:
        if len(tokens[k + 1].word) == 1 and not tokens[k + 1].glued:
            return None
        numbers.append(tokens[k])
        k += 2
        k += k < len(tokens) and tokens[k].word == "."
        if len(numbers) == 1 and k < len(tokens) and tokens[k].word == "-":  # "8p-12p"
            numbers.append(tokens[k])
            k += 1
            continue
        k += k < len(tokens) and tokens[k].word == ":"
        return (numbers, k) if k < len(tokens) and tokens[k].word != "," else None
    return None


def _follow(found: list[list[Token]]) -> bool:
    """Whether numbers of rows begin at 1 and most follow the ones before: "3r, 3p, 6 sc" is a row of colours."""
    ends = [(numbers[0].value, numbers[-1].value) for numbers in found]
    after = sum(begin in (1, last + 1) for (_, last), (begin, _) in pairwise(ends))
    return any(begin == 1 for begin, _ in ends) and 2 * after >= len(ends) - 1


def _sloped(rows: list[Row]) -> list[Row]:
    """``rows`` with "rnd 7/12:" as "rnd 7-12:" where round 13 comes next."""
    made = list(rows)
    for k, row in enumerate(rows):
        at = next((n for n in range(1, min(3, len(row.tokens) - 2)) if row.tokens[n].word == "/"), 0)
        if not at or row.tokens[at + 2].word not in (":", ".", ")"):
            continue
        first, last = row.tokens[at - 1].value, row.tokens[at + 1].value
        if not isinstance(first, int) or not isinstance(last, int) or last < first + 2:
            continue
        after = next((line.tokens for line in rows[k + 1 : k + 4] if line.tokens), [])
        if any(t.kind == "number" and t.value == last + 1 for t in after[:2]):
            dash = replace(row.tokens[at], word="-")
            made[k] = replace(row, tokens=[*row.tokens[:at], dash, *row.tokens[at + 1 :]])
    return made


def _resumed(rows: list[Row]) -> list[Row]:
    """``rows`` with the numbers of a list that a page counted item by item, and its writer by rounds: "6.", "7-12.", "7." as 6, 7-12 and 13."""
    made = list(rows)
    item = last = 0
    for k, row in enumerate(rows):
        tokens = row.tokens
        if len(tokens) < 4 or tokens[0].kind != "number" or not isinstance(tokens[0].value, int):
            continue
        first = tokens[0].value
        if ranged(tokens, 0):
            last = int(tokens[2].value) if first == last + 1 else 0
        elif tokens[1].word == "." and tokens[1].glued and not tokens[2].glued:
            follows = first == item + 1 and 0 < item < last
            item, last = first, last + 1 if follows or first == last + 1 else first
            if last > item and follows:
                made[k] = replace(row, tokens=[replace(tokens[0], word=str(last), value=last), *tokens[1:]])
    return made


def _apart(row: Row, vocabulary: Vocabulary) -> list[Row]:
    """The rounds of a line of which one is seen by its number alone: "6 sc (6) 3-5. 6 sc (6)", "9-15. 48 sc (48) - Rnd 16: 42 sc (42)"."""
    tokens = row.tokens
    if len(tokens) < 6:
        return [row]
    cuts: list[tuple[int, int]] = []
    for k in range(2, len(tokens) - 3):
        if tokens[k - 1].word not in _ENDS or tokens[k - 2].kind not in ("number", "word"):
            continue
        dashed = tokens[k].word == "-" and not tokens[k].glued
        if dashed and _named(tokens, k + 1, vocabulary):
            cuts.append((k, k + 1))
        elif not dashed and ranged(tokens, k) and _works(tokens[k + 4], vocabulary):
            cuts.append((k, k))
    if not cuts:
        return [row]
    begins = [0, *(begin for _, begin in cuts)]
    ends = [*(end for end, _ in cuts), len(tokens)]
    parts = [tokens[a:b] for a, b in zip(begins, ends, strict=True)]
    return [Row(some, some[0].start, some[-1].end, row.marked if not n else 0) for n, some in enumerate(parts) if some]


def _works(token: Token, vocabulary: Vocabulary) -> bool:
    """Whether a round's words may begin so: "5-6. Then close" are none."""
    if token.kind != "word":
        return token.kind == "number" or token.word in ("(", "[", "*")
    found = vocabulary.read([token])
    return bool(found) and found[0].kind in ("stitch", "key")


def _named(tokens: list[Token], k: int, vocabulary: Vocabulary) -> bool:
    """Whether "Rnd 16:" stands there."""
    found = vocabulary.read(tokens[k : k + 2])
    said = len(found) == 2 and found[0].kind == "key" and found[0].value in _ROUNDED and found[1].kind == "number"
    return said and k + 2 < len(tokens) and tokens[k + 2].word == ":"


_AGAIN: Final = frozenset(("repeat", "rep", "again"))


def _relisted(text: str, rows: list[Row], vocabulary: Vocabulary, called: str) -> list[Row]:
    """``rows`` with the rounds of lists numbered that bear none, each list from the one that founds a piece on."""
    if not any(_closes(row.tokens) for row in rows):
        return rows
    made = list(rows)
    k = 0
    while k < len(rows):
        begun = _ringed(rows[k].tokens)
        if not begun and not (_bare(rows[k], vocabulary) and _founds(rows[k], vocabulary)):
            k += 1
            continue
        run, n, at, far = [(k, 1)], _many(rows[k].tokens), k + 1, 0
        counted = int(not begun)
        while at < len(rows) and far <= _FAR:
            row = rows[at]
            if not row.tokens:
                at += 1
                continue
            span = _span(row.tokens)
            if span is not None and span[0] == n + 1 and run[-1][0] < at:
                n, far = span[1], 0
                at += 1
                continue
            if found := heads(vocabulary.read(row.tokens), text):
                place, head = found[0]
                if place or head.numbers[:1] != (n + 1,):
                    break
                n, far = head.numbers[-1], 0  # one that bears its number among those that bear none
                at += 1
                continue
            bare = _bare(row, vocabulary)
            if (bare and _founds(row, vocabulary)) or _ringed(row.tokens):
                break
            counted += bare
            bare = bare or _even(row.tokens)
            if not bare and any(t.word in _AGAIN for t in row.tokens):
                break  # "Repeat the last round 3 times": what follows goes on from there, by the reader's own count
            if bare:
                run.append((at, n + 1))
                n, far = n + _many(row.tokens), 0
            else:
                far += 1
            at += 1
        own = all(_bears(rows[line].tokens, number) for line, number in run)
        own = own or all(
            _bears(rows[line].tokens, number - 1) for line, number in run[1:]
        )  # a ring, "Step 1", "Step 2"
        if len(run) >= _RUN and counted >= _RUN and not own:
            for line, number in run:
                made[line] = headed(rows[line], number, called)
        k = max(at, k + 1)
    return made


_FOR: Final = ("for", "around")
_STITCHES: Final = frozenset(("st", "sts", "stitch", "stitches", "sc"))
_RING_ALONE: Final = re.compile(
    r"(?:make |work )?\d+ (?:sc|hdc|dc) (?:in|into) (?:a |an |the )?(?:magic |adjustable )?(?:ring|circle|loop|mr|mc)(?: \.)?"
)
_EVEN: Final = re.compile(
    r"(?:sc|hdc|dc|inc|dec|(?:1 )?(?:sc|hdc|dc) in each(?: st| stitch)?)(?: around| even| in each(?: st| stitch)?(?: around)?)?"
    r"(?:(?: for)? \w+ (?:rounds|rnds|rows))?(?: \.)?"
)


def _ringed(tokens: list[Token]) -> bool:
    """Whether a line is a first round in a ring that says no count: "6 sc in magic ring"."""
    return len(tokens) < _PLAINLY and _RING_ALONE.fullmatch(" ".join([t.word for t in tokens])) is not None


def _even(tokens: list[Token]) -> bool:
    """Whether a line is a round that says no count and goes all around: "Sc around", "sc around for 3 rounds"."""
    return 1 < len(tokens) < _PLAINLY and _EVEN.fullmatch(" ".join([t.word for t in tokens])) is not None


_PLAINLY: Final = 9  # words of a round of one kind of stitch


def _many(tokens: list[Token]) -> int:
    """How many rounds a line is: 2 of "sc around for 2 rounds (9)"."""
    words = [t.word for t in tokens]
    at = next((k for k, w in enumerate(words[:-2]) if w in _FOR and words[k + 2] in ("rounds", "rnds", "rows")), -1)
    said = words[at + 1] if at >= 0 else "one"
    return int(said) if said.isdigit() else NUMBERS.get(said, 1)


def _bears(tokens: list[Token], number: int) -> bool:
    """Whether a line begins with ``number`` in a way of its own: "#3 inc", "Circle 3: inc", "R-3: inc"."""
    said = str(number)
    return any(t.word == said or (t.kind == "word" and t.word.endswith(said)) for t in tokens[:_AHEAD])


def _span(tokens: list[Token]) -> tuple[int, int] | None:
    """The rounds that a line's own number names, "7-18. 48 sc"; None where it names none."""
    if len(tokens) > 4 and ranged(tokens, 0):
        return int(tokens[0].value), int(tokens[2].value)
    return None


def _closes(tokens: list[Token]) -> bool:
    """Whether a line ends in its count: "(18)", "[18 sc]", "= 18"."""
    tokens = tokens[:-1] if tokens and tokens[-1].word in (".", ",", ";") else tokens
    if len(tokens) < 4:
        return False
    if tokens[-1].word in _ENDS:
        inner = tokens[-3:-1]
        return (inner[1].kind == "number" and inner[0].word in ("(", "[", "{")) or (
            inner[0].kind == "number" and len(tokens) > 4 and tokens[-4].word in ("(", "[", "{")
        )
    if tokens[-1].word in _STITCHES and tokens[-2].kind == "number" and tokens[-3].word == "-":
        return len(tokens) > 4 and not tokens[-3].glued  # "*2 sc, inc* three times - 12 sts"
    tokens = tokens[:-1] if tokens[-1].word in _SHORT and tokens[-3].word == "=" else tokens
    return tokens[-1].kind == "number" and tokens[-2].word == "="


def _bare(row: Row, vocabulary: Vocabulary) -> bool:
    """Whether a line is a round's words and its count, and says no number of its own."""
    tokens = row.tokens
    if not _closes(tokens):
        return False
    said = vocabulary.read(tokens)
    if heads(said) or any(t.word in ("=", ":") for t in said[:2]):
        return False
    known = sum(t.kind in ("stitch", "number", "key", "mark", "ordinal", "filler") for t in said)
    return any(t.kind == "stitch" for t in said[:-2]) and 4 * known >= 3 * len(said)


def _founds(row: Row, vocabulary: Vocabulary) -> bool:
    """Whether a line begins a piece: in a ring, or with a chain."""
    said = vocabulary.read(row.tokens)
    return any(t.value in ("ring", "hook") for t in said) or said[0].value == "ch"
