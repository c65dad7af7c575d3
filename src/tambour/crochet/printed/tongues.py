"""Printed patterns, tongues: signs that other languages write in ways of their own, put as English does: ``3. Masche``, ``2 M zus.``, ``R1.-``."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from tambour.crochet.printed.tokens import Row, Token
from tambour.crochet.words.table import TERMS

_POINTED: Final = {
    "de": frozenset(
        "verd zus abn zun wdh jew nächst folg rd rde m fm stb lm km hstb abm ausl überspr str reih".split()
    ),
    "fr": frozenset("augm aug dim ens rép suiv rg tr m ms mc ml br".split()),
    "nl": frozenset("meerd mind herh volg mrd mnd st v t".split()),
    "es": frozenset("aum dism dis rep sig vta pto pt pb mp cad".split()),
}
"""Words that are shortened with a point, which ends no sentence."""
_ORDINAL: Final = {"de": "."}
"""What makes an ordinal of a number, right behind it: "3. Masche"."""
_BEGIN: Final = frozenset("beginnen anfangen starten empezar comenzar empezando commencer".split())
_COPIES: Final = frozenset("x × iguales stück stk stuks mal fois keer veces piezas pièces pz".split())
_MAKE: Final = frozenset("tejer hacer faire réaliser haken haak maak häkeln anfertigen".split())
_AGAIN: Final = frozenset("wdh wiederholen wiederholt".split())
_TIMES: Final = frozenset("x × mal".split())
_LINE: Final = 18  # words of a heading's line
_MOST: Final = 60
_AB: Final = "AB"  # in capitals a decrease, where "ab" is "from"


def put(text: str, rows: list[Row], code: str) -> list[Row]:
    """Lines with their ordinals, shortened words and heads as English has them; those of English as they are."""
    if code in ("us", "uk", "letters"):
        return rows
    terms = TERMS[code]
    said = (*terms.words["stitch"], *terms.words["stitches"], *terms.stitches["sc"], *terms.words["round"])
    counted = frozenset(word.lower() for word in said) | {word.lower() for word in terms.words["and"]}
    made = []
    for row in rows:
        tokens = row.tokens
        if tokens:
            tokens = _headed(_elided(tokens) if code == "fr" else tokens)
            tokens = _copied(_unbegun(tokens))
            tokens = _ordinals(tokens, _ORDINAL.get(code, ""), counted)
            tokens = _shortened(text, tokens, code)
        made.append(row if tokens is row.tokens else Row(tokens, row.start, row.end, row.marked))
    return made


def _elided(tokens: list[Token]) -> list[Token]:
    """French words without the article that has grown to them: ``l'anneau``, ``d'écart``."""
    made = []
    for token in tokens:
        head, sign, word = token.word.partition("'")
        grown = sign and len(head) == 1 and head in "ldnjsc" and word not in ("air", "")
        made.append(replace(token, word=word, start=token.start + 2) if grown else token)
    return made


def _unbegun(tokens: list[Token]) -> list[Token]:
    """Short lines without a verb that only says that a piece begins in a yarn: ``mit Schwarz anfangen``, ``empezar en rosa``."""
    if len(tokens) > _LINE or not any(t.word in _BEGIN for t in tokens):
        return tokens
    return [t for t in tokens if t.word not in _BEGIN]


def _copied(tokens: list[Token]) -> list[Token]:
    """A heading with its copies as English says them: ``Orejas (2 iguales, crudo)`` as "Orejas (make 2, crudo)", ``BEINE, 4 Stück, …`` as "BEINE - make 4 - …"."""
    if len(tokens) > _LINE or not tokens[0].capital or tokens[0].kind != "word":
        return tokens
    first = next((k for k, t in enumerate(tokens) if t.kind in ("number", "mark") and t.word not in ("&", "/")), 0)
    if tokens[first].word not in ("(", ",", "-"):
        return tokens  # a round: "V3: [1 pb, 1 aum] x 6"
    for k in range(first, len(tokens)):
        number = tokens[k]
        if not first or number.kind != "number" or not isinstance(number.value, int) or not 1 < number.value <= _MOST:
            continue
        begin, end = k, k + 1
        if end < len(tokens) and tokens[end].word in _COPIES:
            end += 1
        elif tokens[k - 1].word in _COPIES or tokens[k - 1].word in _MAKE:
            begin -= 1
            begin -= begin > first and tokens[begin - 1].word == "en"
        else:
            continue
        make = Token("key", "make", number.start, number.start, "make")
        inside = any(t.word == "(" for t in tokens[first:begin]) and not any(t.word == ")" for t in tokens[first:begin])
        if inside and tokens[-1].word in (")", ":"):
            rest = [t for t in (*tokens[first + 1 : begin], *tokens[end:]) if t.word != ")"]
            while rest and rest[0].kind == "mark":
                rest.pop(0)
            while rest and rest[-1].kind == "mark":
                rest.pop()
            comma = [Token("mark", ",", number.end, number.end)] if rest else []
            return [*tokens[: first + 1], make, number, *comma, *rest, tokens[-1]]
        if not inside and tokens[begin - 1].kind == "mark":
            return [
                *tokens[: begin - 1],
                Token("mark", "-", make.start, make.start),
                make,
                number,
                *_dashed(tokens[end:]),
            ]
    return tokens


def _dashed(rest: list[Token]) -> list[Token]:
    return [replace(rest[0], word="-"), *rest[1:]] if rest and rest[0].word == "," else rest


def _headed(tokens: list[Token]) -> list[Token]:
    """``R1.- 6 pb``, ``3.- …``: the point and the dash of a head as a colon."""
    for k in range(1, min(5, len(tokens) - 1)):
        point, dash = tokens[k], tokens[k + 1]
        ranged = k + 2 < len(tokens) and tokens[k + 2].glued and not tokens[0].word[0].isalpha()  # "4.-6. Rd"
        if point.word == "." and dash.word == "-" and dash.glued and tokens[k - 1].word[-1].isdigit() and not ranged:
            return [*tokens[:k], Token("mark", ":", point.start, dash.end, None, point.glued), *tokens[k + 2 :]]
    return tokens


def _ordinals(tokens: list[Token], sign: str, counted: frozenset[str]) -> list[Token]:
    """Numbers with the language's sign of an ordinal right behind them, before a stitch, a round or another such, as ordinals."""
    if not sign:
        return tokens
    made = list(tokens)
    for k in range(len(made) - 2, -1, -1):
        number, behind = made[k], made[k + 1]
        if number.kind != "number" or behind.word != sign or not behind.glued or not isinstance(number.value, int):
            continue
        after = made[k + 2] if k + 2 < len(made) else None
        if after is None or after.glued:
            continue
        if after.kind == "ordinal" or after.word in counted:
            made[k : k + 2] = [
                Token("ordinal", number.word + sign, number.start, behind.end, number.value, number.glued)
            ]
    return made


def _shortened(text: str, tokens: list[Token], code: str) -> list[Token]:
    """Tokens without the points of shortened words, but where a sentence ends with one."""
    pointed = _POINTED.get(code, frozenset())
    made: list[Token] = []
    for k, token in enumerate(tokens):
        if code == "nl" and token.word == "m" and [t.word for t in made[-2:]] == ["t", "/"]:
            made[-2:] = [Token("word", "tot", made[-2].start, token.end)]  # "t3 t/m t5"
            continue
        if token.word == "." and token.glued and k and tokens[k - 1].word in pointed:
            after = tokens[k + 1] if k + 1 < len(tokens) else None
            if after is None or not after.capital or after.word in pointed or after.kind == "number":
                continue
        if token.word in _AGAIN and len(made) > 1 and made[-1].word in _TIMES and made[-2].kind == "number":
            continue  # "3x wdh."
        if code == "de" and token.word == "ab" and text[token.start : token.end] == _AB:
            token = replace(token, word="abn")
        made.append(token)
    return made
