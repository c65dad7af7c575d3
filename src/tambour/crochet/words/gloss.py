"""Gloss: a sentence of the assembly, put into English word by word, its verb first, so that one reading of places serves every language."""

from __future__ import annotations

import re
import unicodedata
from bisect import bisect_right
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Final

from tambour.crochet.words.numbers import NUMBERS
from tambour.crochet.words.table import TERMS

_PIECE: Final = re.compile(r"\d+(?:[.,]\d+)?|[^\W\d_]+['’]?|[^\w\s]")
_SHORT: Final = re.compile(r"(?<=[^\W\d_])\.(?=\s+(?:\d|[^\W\d_]))")
"""The point of a word that is shortened: within a sentence no other stands there."""
_ORDINAL: Final = re.compile(
    r"(\d+)(?:\.(?=\s*(?:[-–—/]|bis|und|u\.|rd|rnd|runde|reihe|r\b|m\b|masche))|(?:er|ère|re|ème|ième|e|è|ste|de|ª|º)\b)"
)
"""Numbers that other languages order by a sign: "17. Rd", "16e tour", "4ª vuelta"."""
_LISTED: Final = re.compile(r"^\W*\d{1,2}\s*[.)]\s")
"""What numbers a sentence of a list."""
_VERBS: Final = ("sew", "sew together", "insert", "embroider", "press flat")
_CUT: Final = (",", ";", ":", ".", "!")
_UNDER: Final = ("so that", "when")
"""What begins a clause that says only why or when."""
_PLACED: Final = re.compile(
    r"\b(?:to the|at|between|over|under|below|above|behind|beside|in front of|in the middle of the|centered|on the|sides?|left|right|apart)\b"
)
_SMALL: Final = frozenset(
    (
        "",
        "and",
        "the",
        "both",
        "two",
        "three",
        "four",
        "five",
        "six",
        "eight",
        "small",
        "each",
        "front",
        "back",
        "upper",
        "lower",
        "left",
        "right",
        "pair",
    )
)
"""What may stand before the noun that a clause begins with."""
_MOST: Final = 700
_MEANT: Final = {
    "btw": "between",
    "btwn": "between",
    "betw": "between",
    "b/w": "between",
    "w/": "with ",
    "w/o": "without ",
    "abt": "about",
}
_CHAT: Final = re.compile(r"(?<![\w/])(?:w/o?(?=\s?\w)|(?:btwn?|betw|b/w|abt)(?=\s))", re.IGNORECASE)


@dataclass(frozen=True)
class Glossed:
    """text : in English, small letters; places : where its pieces stand there, and stood in what was glossed."""

    text: str
    places: tuple[tuple[int, int], ...] = ()

    def at(self, place: int) -> int:
        """Where in the English text that is which stood at ``place``."""
        if not self.places:
            return place
        stood = sorted((was, now) for now, was in self.places)
        return stood[max(0, bisect_right(stood, (place, len(self.text))) - 1)][1]


@dataclass(frozen=True)
class _Word:
    """A piece of the English text, and where what it stands for began."""

    text: str
    at: int


def folded(word: str) -> str:
    """A word in small letters without its accents, as names of parts are kept."""
    plain = unicodedata.normalize("NFKD", word.lower().replace("ß", "ss").replace("œ", "oe").replace("’", "'"))
    return "".join(c for c in plain if not unicodedata.combining(c))


@lru_cache(maxsize=8)
def _phrases(code: str) -> Mapping[str, list[tuple[tuple[str, ...], str]]]:
    """First piece → the phrases that begin with it, the longest first, and the English of each."""
    found: dict[str, list[tuple[tuple[str, ...], str]]] = {}
    for english, spellings in (*TERMS[code].heard.gloss.items(), *TERMS[code].heard.parts.items()):
        for said in spellings:
            pieces = tuple(folded(w) for w in _PIECE.findall(said))
            found.setdefault(pieces[0], []).append((pieces, english))
    for same in found.values():
        same.sort(key=lambda p: -len(p[0]))
    return found


@lru_cache(maxsize=1)
def nouns() -> Mapping[str, str]:
    """What other languages call parts of toys, without accents → the English noun."""
    return {
        folded(said): english.split()[-1]
        for code in TERMS
        for english, spellings in TERMS[code].heard.parts.items()
        for said in spellings
        if re.fullmatch(r"[^\W\d_]{3,}", said)
    }


def english(text: str, code: str) -> Glossed:
    """A sentence of the assembly in English; one that is in English, or in a language without a gloss, as it is."""
    if len(text) > _MOST:
        return Glossed(text)
    if not TERMS[code].heard.gloss:
        return _spelt(text)
    ordered = _ORDINAL.sub(lambda m: f"{m[1]}\0".ljust(len(m[0])), _SHORT.sub(" ", _LISTED.sub(_blank, text.lower())))
    made: list[str] = []
    places: list[tuple[int, int]] = []
    for clause in _clauses(_words(ordered, code)):
        for word in clause:
            if not word.text:
                continue
            if made and word.text not in _CUT:
                made.append(" ")
            places.append((sum(map(len, made)), word.at))
            made.append(word.text)
    return Glossed("".join(made), tuple(places))


def _spelt(text: str) -> Glossed:
    """A sentence in English with what chats shorten written out: "eyes btw R5 & R6", "sew on w/ black"."""
    made: list[str] = []
    places: list[tuple[int, int]] = []
    at = 0
    for found in _CHAT.finditer(text):
        places.append((sum(map(len, made)), at))
        made.append(text[at : found.start()])
        places.append((sum(map(len, made)), found.start()))
        made.append(_MEANT[found[0].lower()])
        at = found.end()
    if not at:
        return Glossed(text)
    places.append((sum(map(len, made)), at))
    return Glossed("".join((*made, text[at:])), tuple(places))


def _blank(found: re.Match[str]) -> str:
    return " " * len(found[0])


def _words(text: str, code: str) -> list[_Word]:
    """The pieces of a sentence in English, in the order in which they were said."""
    pieces = [(m.start(), folded(m[0])) for m in re.finditer(r"\d+\0|" + _PIECE.pattern, text)]
    pieces = _rounds(pieces, code)
    phrases, counts = _phrases(code), _counts(code)
    made: list[_Word] = []
    at = 0
    while at < len(pieces):
        start, piece = pieces[at]
        first = "@" if piece[0] == "@" else "#" if piece[0].isdigit() else piece
        known = [*phrases.get(first, ()), *(phrases.get("#", ()) if piece in counts else ())]
        found = next((f for f in known if _stands(f[0], pieces, at, counts)), None)
        if found is None:
            made.append(_Word(_plain(piece), start))
            at += 1
            continue
        said = found[1]
        for (_, value), sign in zip(pieces[at:], found[0]):
            if sign in ("#", "@"):
                said = said.replace(sign, _plain(counts.get(value, value)), 1)
        made.append(_Word(said, start))
        at += len(found[0])
    return made


@lru_cache(maxsize=8)
def _counts(code: str) -> Mapping[str, str]:
    """Numbers in words → in English."""
    return {folded(s): e for e in NUMBERS for s in TERMS[code].heard.gloss.get(e, ())}


def _plain(piece: str) -> str:
    """A piece that is no phrase: a number in order, a round, a word."""
    if piece.endswith("\0"):
        return f"{piece[:-1]}th"
    return f"round {piece[1:]}" if piece[0] == "@" else piece


_JOINS: Final = {"-": "to", "–": "to", "—": "to", "/": "and", "&": "and", "t / m": "to", "tot en met": "to"}


def _rounds(pieces: list[tuple[int, str]], code: str) -> list[tuple[int, str]]:
    """Pieces with the rounds that they name in one each: "la v11 y la 12" as two, "der 16. und 17. Rd" as two."""
    table = TERMS[code].heard.gloss
    named, articles = set(table.get("round", ())), {folded(w) for w in table.get("", ()) if len(w) < 4}
    joins = {folded(w): e for e in ("and", "to") for w in table.get(e, ())} | _JOINS
    made: list[tuple[int, str]] = []
    at = 0

    def past(k: int, known: set[str]) -> int:
        return k + 1 if k < len(pieces) and pieces[k][1] in known else k

    def joined(k: int) -> tuple[int, str]:
        """Behind what joins two rounds at a place, and how."""
        for n in (3, 1):
            word = " ".join(p for _, p in pieces[k : k + n])
            if word in joins:
                return k + n, joins[word]
        return k, ""

    def number(k: int, sign: str = "") -> bool:
        return k < len(pieces) and pieces[k][1][0].isdigit() and pieces[k][1].endswith(sign)

    while at < len(pieces):
        head = past(at, articles)
        found: list[tuple[int, str]] = []
        k = past(head, named)
        if k > head and number(k):  # "Rd 5 bis 9", "la v11 y la 12"
            found = [(pieces[at][0], f"@{pieces[k][1].rstrip(chr(0))}")]
            k += 1
            more, how = joined(k)
            after = past(past(more, articles), named)
            if how and number(after):
                found += [(pieces[k][0], how), (pieces[after][0], f"@{pieces[after][1].rstrip(chr(0))}")]
                k = after + 1
        elif number(head, "\0"):  # "der 16. und 17. Rd", "le 3e et le 5e tour"
            found, k = [(pieces[at][0], f"@{pieces[head][1][:-1]}")], head + 1
            k = past(k, named)
            more, how = joined(k)
            after = past(more, articles)
            ordered = k > head + 1
            if how and number(after, "\0"):
                found += [(pieces[k][0], how), (pieces[after][0], f"@{pieces[after][1][:-1]}")]
                k = past(after + 1, named)
                ordered = ordered or k > after + 1
            found = found if ordered else []
        if found:
            made += found
            at = k
        else:
            made.append(pieces[at])
            at += 1
    return made


def _stands(phrase: tuple[str, ...], pieces: list[tuple[int, str]], at: int, counts: Mapping[str, str]) -> bool:
    """Whether a phrase stands at a place; "#" any number, "@" any round."""
    here = [piece for _, piece in pieces[at : at + len(phrase)]]
    return len(here) == len(phrase) and all(
        said == piece or (said == "#" and (piece[0].isdigit() or piece in counts)) or (said == "@" and piece[0] == "@")
        for said, piece in zip(phrase, here)
    )


def _clauses(words: list[_Word]) -> list[list[_Word]]:
    """The clauses, each with its verb first; one without a verb that names a part and a place gets one."""
    pieces: list[list[_Word]] = [[]]
    for k, word in enumerate(words):
        verbs = [w.text for w in pieces[-1] if w.text in _VERBS]
        later = any(w.text in _VERBS for w in _until(words[k + 1 :]))
        if word.text in _CUT or (word.text == "and" and verbs and later):
            pieces.append([word])
        else:
            pieces[-1].append(word)
    made: list[list[_Word]] = []
    waiting: list[_Word] = []
    for k, piece in enumerate(pieces):
        piece = [*waiting, *piece]
        waiting = []
        last = k + 1 == len(pieces)
        verb = any(w.text in _VERBS for w in piece)
        if not verb and not last and not _PLACED.search(_text(piece)) and any(w.text in _VERBS for w in pieces[k + 1]):
            waiting = piece  # "Augen, Nase und Mund aufsticken"
            continue
        made.append(_turned(piece))
    return made


def _until(words: list[_Word]) -> list[_Word]:
    end = next((k for k, w in enumerate(words) if w.text in _CUT), len(words))
    return words[:end]


def _text(words: list[_Word]) -> str:
    return " ".join(w.text for w in words if w.text)


def _turned(piece: list[_Word]) -> list[_Word]:
    """A clause with its verb before what it is about."""
    lead = next((k for k, w in enumerate(piece) if w.text not in (*_CUT, "and", "")), len(piece))
    head, body = piece[:lead], piece[lead:]
    if not body:
        return piece
    if body[0].text in _UNDER:
        return [*head, *(w for w in body if w.text not in _VERBS)]
    at = next((k for k, w in enumerate(body) if w.text in _VERBS), None)
    if at is not None:
        drawn = [k for k, w in enumerate(body) if w.text == "embroider"]
        at = drawn[0] if drawn else at
        rest = [w for w in body if w.text not in _VERBS]
        return [*head, body[at], *rest]
    noun = next((w for w in body if w.text not in _SMALL), None)
    if noun is None or noun.text.split()[-1] not in set(nouns().values()) or not _PLACED.search(_text(body)):
        return piece
    return [*head, _Word("sew", body[0].at), *body]
