"""Printed patterns, the vocabulary of one language: its words and phrases found in a line, the longest first."""

from __future__ import annotations

import re
from bisect import insort_right
from collections.abc import Iterable
from copy import copy
from functools import lru_cache
from typing import Any, Final

from tambour.crochet.language.stitches import STITCHES, standard
from tambour.crochet.printed.heads import Head, heads
from tambour.crochet.printed.tokens import Token, rows
from tambour.crochet.printed.wordings.inner import evened
from tambour.crochet.printed.wordings.passes import plain
from tambour.crochet.words.table import TERMS, Heard

_SAME: Final = {"into": "in", "stitches": "stitch", "none": "not"}
_SHORT: Final = 4  # letters of a stitch that a point makes short
_JOINS: Final = frozenset("-.'/")
_YARNS: Final = frozenset(
    (
        "with",
        "to",
        "color",
        "colour",
        "yarn",
        "in",
        "join",
        "attach",
        "add",
        "drop",
        "break",
        "carry",
        ".",
        "using",
        "of",
    )
)
_OF_YARN: Final = (_YARNS - {"."}) | {"cut"}  # before a yarn's letter that means something else elsewhere
_ENDED: Final = frozenset(("=", "-", ":", ",", ".", ";", ")", "and", "or", "for"))  # no article stands before these
_LISTED: Final = frozenset(("=", ":", "-"))  # behind a yarn's letter in a list: "A = red"
_AFTER: Final = frozenset("in into around to of from across along with until".split())  # behind a stitch and its point
_ARTICLES: Final = frozenset(("the", "a", "your"))
_SIGNS: Final = frozenset("xX×*")
_NONE: Final[frozenset[str]] = frozenset()
_LATER: Final = frozenset(
    ("circle", "oval", "half", "triangle", "heart", "square", "height", "pull through", "pull over", "next anchor")
)


class Vocabulary:
    """Phrases → what they mean, of the terms ``code``.

    Meanings are pairs: ("stitch", standard name), ("key", concept), ("ordinal", n), ("number", n) or ("filler", None).
    ``basic`` is the stitch that a bare number of stitches means.
    """

    def __init__(self, code: str) -> None:
        self.code = code
        self._first: dict[str, list[tuple[tuple[str, ...], str, Any]]] = {}
        self._second: dict[str, frozenset[str]] = {}  # first words of phrases → words that stand behind them in one
        self._alone: set[str] = set()  # words that are a stitch by themselves
        self._read: dict[tuple[int, int, int], tuple[list[Token], list[Token]]] = {}
        self._heads: dict[tuple[int, int, int], tuple[list[Token], list[tuple[int, Head]]]] = {}
        self._counts: dict[str, bool] = {}
        table = TERMS[code]
        heard = table.heard
        self.labels, self.steps = frozenset((*heard.labels, *heard.steps)), frozenset(heard.steps)
        for key, said in heard.words.items():
            self._add(said, "key", key)
        for n, word in enumerate(heard.ordinals, 1):
            self._add([word], "ordinal", n)
        for n, word in enumerate(heard.numbers, 1):
            self._add([word], "number", n)
        self._add(heard.fillers, "filler", None)
        self._families(heard)
        for name, said in heard.stitches.items():
            self._add(said, "stitch", name)
        for key, spellings in table.words.items():
            if key not in _LATER:
                self._add([s for s in spellings if s not in _SIGNS], "key", _SAME.get(key, key))
        for name, spellings in table.stitches.items():
            self._add(spellings, "stitch", name)

    def _families(self, heard: Heard) -> None:
        """Plain stitches, and the increases and decreases that are said of them."""
        for name, said in heard.kinds.items():
            self._add(said, "stitch", name)
            if name in ("slst", "skip", "ch"):
                continue
            prefix = "" if name == "sc" else name
            for word in said:
                for n in range(2, 6):
                    what = f"{prefix}dec{n if n > 2 else ''}"
                    self._add(
                        [f"{word}{n}tog", f"{word} {n} tog", f"{word}{n} tog", f"{word} {n} together"], "stitch", what
                    )
                self._add([f"{word}tog", f"{word} tog"], "stitch", f"{prefix}dec")
                for inc in heard.increases:
                    self._add([f"{word} {inc}", f"{word}{inc}"], "stitch", f"{prefix}inc")
                    self._add([f"{word} {inc} 3", f"{word}{inc}3"], "stitch", f"{prefix}inc3")
                for dec in heard.decreases:
                    self._add([f"{word} {dec}", f"{word}{dec}"], "stitch", f"{prefix}dec")
        if self.code in ("us", "uk"):
            self._add([f"triple {word}" for word in heard.increases], "stitch", "inc3")
        for said, what in ((heard.increases, "inc"), (heard.decreases, "dec")):
            self._add(said, "stitch", what)
            for n in range(3, 7):
                self._add([f"{word}{n}" for word in said if " " not in word], "stitch", f"{what}{n}")

    def _add(self, spellings: Iterable[str], kind: str, value: Any, new: bool = False) -> None:
        if kind == "stitch" and value not in STITCHES and not new:
            return
        spellings = list(spellings)
        plain = all(one.isascii() and one.islower() and one.replace(" ", "").isalpha() for one in spellings)
        if plain:
            said = [tuple(one.split()) for one in spellings]
        else:
            said = [tuple(t.word for t in row.tokens if t.word not in _JOINS) for row in rows("\n".join(spellings))]
        for words in said:
            if not words:
                continue
            # What comes later is the table's own word, and goes before what people write besides.
            phrases = [p for p in self._first.get(words[0], ()) if p[0] != words]
            insort_right(phrases, (words, kind, value), key=_length)
            self._first[words[0]] = phrases
            if len(words) > 1:
                self._second[words[0]] = self._second.get(words[0], frozenset()) | {words[1]}
            if kind == "stitch" and len(words) == 1:
                self._alone.add(words[0])  # so that a point behind it ends a sentence: "1 sc. Inc." is two

    def define(self, word: str, stitch: str) -> None:
        """A stitch's name that the pattern itself explains."""
        self._add([word], "stitch", stitch, True)
        self._forget(word)

    def mean(self, word: str, key: str) -> None:
        """A word of the trade, a ring or a round, that the pattern itself explains."""
        self._add([word], "key", key)
        self._forget(word)

    def _forget(self, said: str) -> None:
        """Reads anew what has words that mean something else now, by themselves or with a number grown to them."""
        words = {t.word for t in rows(said)[0].tokens}
        self._read = {
            place: known
            for place, known in self._read.items()
            if not any(t.word in words or t.word.rstrip("0123456789") in words for t in known[0])
        }
        self._counts = {}

    def own(self) -> None:
        """Makes the phrases this vocabulary's own; those of another that it was copied from stay as they are."""
        self._first, self._second = dict(self._first), dict(self._second)
        self._alone = set(self._alone)
        self._read, self._heads, self._counts = {}, {}, {}

    def part(self) -> None:
        """Reads "sc inc" and "inc sc" as two stitches, not as an increase of single crochets."""
        for first in self._alone:
            self._first[first] = [
                p
                for p in self._first[first]
                if not (len(p[0]) == 2 and p[2] in ("inc", "dec") and self._alone.issuperset(p[0]))
            ]

    def stitches(self) -> list[str]:
        """The words of one piece that mean a stitch, for suggestions."""
        return [p[0][0] for phrases in self._first.values() for p in phrases if p[1] == "stitch" and len(p[0]) == 1]

    def read(self, tokens: list[Token]) -> list[Token]:
        """``tokens`` with phrases made one token each, of kind "stitch" or "key", and fillers left out."""
        if not tokens:
            return []
        # Lines are looked at more than once, in rows that are made anew.
        place = (tokens[0].start, tokens[-1].end, len(tokens))
        known = self._read.get(place)
        if known is None or known[0] != tokens:
            made = plain(self._phrased(evened(tokens)))
            known = self._read[place] = (list(tokens), made)
        return list(known[1])

    def heads(self, tokens: list[Token]) -> list[tuple[int, Head]]:
        """The heads of the rounds of a line (:func:`heads`); not to be written."""
        if not tokens:
            return []
        read = self.read(tokens)
        place = (tokens[0].start, tokens[-1].end, len(tokens))
        known = self._heads.get(place)  # as those of what was read there last
        if known is None or known[0] is not self._read[place][1]:
            known = self._heads[place] = self._read[place][1], heads(read)
        return known[1]

    def counts(self, word: str) -> bool:
        """Whether a word alone means a round or a row: asked of every word that a number stands behind."""
        known = self._counts.get(word)
        if known is None:
            read = self.read([Token("word", word, 0, len(word))])
            known = len(read) == 1 and read[0].kind == "key" and read[0].value in ("round", "row")
            self._counts[word] = known
        return known

    def _phrased(self, tokens: list[Token]) -> list[Token]:
        made: list[Token] = []
        at, n = 0, len(tokens)
        while at < n:
            token = tokens[at]
            if token.kind in ("number", "ordinal", "mark") and token.word not in self._first:
                made.append(token)
                at += 1
                continue
            if (
                token.word == "both"
                and made
                and made[-1].word in ("through", "thru")
                and tokens[min(at + 1, n - 1)].word == "sides"
            ):
                # "through both sides" of an opening that is pressed flat
                made.append(Token("key", "both sides", token.start, tokens[at + 1].end, "thicknesses", token.glued))
                at += 2
                continue
            found = self._longest(tokens, at)
            if (
                token.word in ("r", "w")
                and token.capital
                and tokens[at - 1].word in _OF_YARN
                and not (at + 1 < n and tokens[at + 1].kind == "number")
            ):
                found = None  # "With R ch 7": the letter of red yarn, and no round
            if token.word in _ARTICLES and found is not None and found[1] == "stitch" and not _letter(tokens, at):
                found = at + 1, "filler", None
            if token.word == "x" and (
                token.kind == "mark" or found is None or (made and made[-1].word in (")", "]", "}", "*"))
            ):
                made.append(Token("mark", "x", token.start, token.end, None, token.glued))
                at += 1
                continue
            if found is None:
                made += self._parted(token)
                at += 1
                continue
            end, kind, value = found
            if kind == "filler":
                listed = not at and token.capital and end < n and tokens[end].word in _LISTED
                if listed or (
                    token.value == "A" and (tokens[at - 1].word in _YARNS or end >= n or tokens[end].word in _ENDED)
                ):
                    made.append(token)
                at = end
                continue
            last = tokens[end - 1]
            word = token.word if end == at + 1 else " ".join(t.word for t in tokens[at:end])
            made.append(Token(kind, word, token.start, last.end, value, token.glued, token.capital))
            # The point of an abbreviation: "rnd. 4", "rep. from"; before a capital it ends the sentence.
            if end + 1 < n and tokens[end].word == "." and tokens[end].glued and kind == "key" and len(token.word) <= 4:
                after = tokens[end + 1]
                if value in ("round", "row"):
                    # "as 3rd rnd. 18 sc.", "rep last rnd. 18 sc."
                    ordinal = len(made) > 1 and (
                        made[-2].kind == "ordinal" or made[-2].value in ("last", "each", "same")
                    )
                    end += (
                        not ordinal
                        and tokens[at - 1].word != "of"  # "for beg of rnd. 1 sc in next ch" are two sentences
                        and not after.glued
                        and (after.kind == "number" or (after.kind == "word" and not after.capital))
                    )
                elif value in ("repeat", "stitch"):
                    end += not after.glued and after.kind == "word" and not after.capital
            if (
                end + 1 < n
                and kind == "stitch"
                and len(last.word) <= _SHORT
                and tokens[end].word == "."
                and tokens[end].glued
            ):
                after = tokens[end + 1]  # "8 sc. in a magic ring; 8 inc. = 16 sc.; *9 sc., 1 dec.*"
                goes_on = (after.kind == "mark" and after.glued and after.word in ",;*:)]") or after.word == "="
                end += goes_on or (not after.glued and not after.capital and after.word in _AFTER)
            at = end
        return made

    def _longest(self, tokens: list[Token], at: int) -> tuple[int, str, Any] | None:
        meanings = self._first.get(tokens[at].word)
        if not meanings:
            return None
        near = [token.word for token in tokens[at + 1 : at + 3]]  # one sign may stand between two words
        if self._second.get(tokens[at].word, _NONE).isdisjoint(near):
            words, kind, value = meanings[-1]  # of which one is a word alone, or none
            return (at + 1, kind, value) if len(words) == 1 else None
        for words, kind, value in meanings:
            if len(words) > 1 and words[1] not in near:
                continue
            end = at + 1
            for word in words[1:]:
                # "sl-st", "sl. st."
                join = end + 1 < len(tokens) and tokens[end].word in _JOINS and tokens[end].glued
                join = join and not (tokens[end].word == "." and tokens[end + 1].capital)  # "Turn. Work 4 sc …"
                if (join and not (tokens[end].word == "." and tokens[at].word in self._alone)) or (
                    end + 1 < len(tokens)
                    and tokens[end].word in _ARTICLES
                    and word != tokens[end].word
                    and tokens[end].value != "A"  # the yarn A
                ):
                    end += 1
                if end >= len(tokens) or tokens[end].word != word:
                    break
                end += 1
            else:
                return end, kind, value
        return None

    def _parted(self, token: Token) -> list[Token]:
        """A word of letters and digits grown together (``sc6``, ``x6``, ``r12``), or one that the stitch table knows."""
        word = token.word
        if token.kind != "word" or len(word) > 20:
            return [token]
        name = standard(word)
        if name in STITCHES and (self.code != "uk" or _of_both(name)):
            return [Token("stitch", word, token.start, token.end, name, token.glued, token.capital)]
        if not word[-1].isdigit():
            return [token]
        head = word.rstrip("0123456789")
        phrase = self._longest([Token("word", head, token.start, token.end)], 0) if head else None
        if phrase is None and len(head) > 1 and head[-1] == "x":
            often = self._longest([Token("word", head[:-1], token.start, token.end)], 0)
            if often is not None and often[1] == "stitch":  # "incx6"
                cross, middle = token.start + len(head) - 1, token.start + len(head)
                return [
                    Token("stitch", head[:-1], token.start, cross, often[2], token.glued, token.capital),
                    Token("mark", "x", cross, middle, None, True),
                    Token("number", word[len(head) :], middle, token.end, int(word[len(head) :]), True),
                ]
        if head == "x" or phrase is not None or head == "r":
            middle = token.start + len(head)
            kind, value = ("mark", None) if head == "x" else (phrase[1], phrase[2]) if phrase else ("key", "round")
            number = Token("number", word[len(head) :], middle, token.end, int(word[len(head) :]), True)
            return [Token(kind, head, token.start, middle, value, token.glued), number]
        return [token]


def _letter(tokens: list[Token], at: int) -> bool:
    """Whether an article is the letter of a stitch, as a text may have it: "(3X, A, 3X)", "R8: A, 4X", and no "A small dish."."""
    before, after = tokens[at - 1] if at else None, tokens[at + 1] if at + 1 < len(tokens) else None
    listed = before is None or before.kind == "number" or before.word in ("(", "[", "*", ",", ":", "|", "/", "=", "x")
    return listed and (after is None or after.kind != "word" or after.word in ("in", "x"))


def _length(phrase: tuple[tuple[str, ...], str, Any]) -> int:
    return -len(phrase[0])


def _of_both(name: str) -> bool:
    """Whether a stitch has one name on both sides of the Atlantic."""
    return not any(kind in name for kind in ("sc", "dc", "tr"))


_BESIDE: Final = re.compile(
    r"(?:[(\[*:–-] *|\b[rR]\d+ +|\d[.)] *)(?:(?:sc|single crochet) (inc|dec)|(inc|dec) (?:sc|single crochet)) *[)\]*]? *(?:[x×*] *(\d+)|(\d+) *(?:x|times)) *[(\[=] *(\d+)",
    re.IGNORECASE,
)
"""A repeat of a single crochet and a shaping that nothing parts, how often, and its count: "(sc inc) x 6 (18)"."""
_ALONE: Final = re.compile(r"(?<![a-z] )\b(?:\d+ ?inc\b|inc ?[x×*] ?\d)", re.IGNORECASE)
_GROWN: Final = re.compile(r"(?<!\d )(?<!\d)\bsc inc\b(?! in(?:to)?\b)", re.IGNORECASE)
_BEHIND: Final = re.compile(
    r"[(\[*] *(?:(\d+) *)?sc *(?:in next(?: \d+)?(?: sts?| sc)? *)?, *(?:1 )?(?:sc (inc|dec)) *[)\]*] *(?:[x×*] *(\d+)|(\d+) *(?:x|times)) *[(\[=] *(\d+)",
    re.IGNORECASE,
)
"""The same behind others, which a comma parts: "(2 sc, sc inc) x 6 (24)"."""
_PLACED: Final = re.compile(r"\b(?:sc inc|inc sc) in(?:to)? (?:each|every|next|first|last|the|all)\b", re.IGNORECASE)
"""One that has a place is one: "sc inc in each st around"."""


def stand_beside(text: str) -> bool:
    """Whether a text writes a single crochet and an increase beside each other as "sc inc": its counts say so, or, where none does, that its
    increases are "inc" alone elsewhere."""
    two = one = 0
    for said in _BESIDE.finditer(text):
        often, count = int(said[3] or said[4]), int(said[5])
        plain = 2 if (said[1] or said[2]).lower() == "inc" else 1
        two += count == often * (plain + 1)
        one += count == often * plain
    for said in _BEHIND.finditer(text):
        often, count, before = int(said[3] or said[4]), int(said[5]), int(said[1] or 1)
        plain = 2 if said[2].lower() == "inc" else 1
        two += count == often * (before + plain + 1)
        one += count == often * (before + plain)
    one += not two and bool(_PLACED.search(text))
    return two > one or (two == one == 0 and bool(_ALONE.search(text) and _GROWN.search(text)))


@lru_cache(maxsize=16)
def _shared(code: str) -> Vocabulary:
    return Vocabulary(code)


def vocabulary(code: str) -> Vocabulary:
    """The vocabulary of the terms ``code``, to which a pattern may add its own words."""
    made = copy(_shared(code))
    made.own()
    return made
