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
    "fr": frozenset("augm aug dim ens rép suiv rg tr m ms mc ml br db b dbr".split()),
    "nl": frozenset("meerd mind herh volg mrd mnd st v t".split()),
    "es": frozenset("aum dism dis rep sig vta pto pt pb mp cad".split()),
}
"""Words that are shortened with a point, which ends no sentence."""
_ORDINAL: Final = {"de": "."}
"""What makes an ordinal of a number, right behind it: "3. Masche"."""
_UP_TO: Final = frozenset(("-", "bis"))
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
    said = (
        *terms.words["stitch"],
        *terms.words["stitches"],
        *terms.stitches["sc"],
        *terms.stitches["ch"],
        *terms.words["round"],
    )
    counted = frozenset(word.lower() for word in said) | {word.lower() for word in terms.words["and"]}
    short = _short(code)
    made = []
    for row in rows:
        tokens = row.tokens
        if tokens:
            tokens = _headed(_french(tokens) if code == "fr" else tokens)
            tokens = _cast(_initialled(tokens, short))
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


def _short(code: str) -> frozenset[str]:
    """The stitches of a language that are two or three letters long."""
    terms = TERMS[code]
    said = [word for kind in (*terms.stitches.values(), *terms.heard.kinds.values()) for word in kind]
    return frozenset(word.lower() for word in said if 1 < len(word) <= _LETTERS and word.isalpha())


_LETTERS: Final = 3


def _initialled(tokens: list[Token], short: frozenset[str]) -> list[Token]:
    """``6 m. s.``, ``f. M.``, ``dB.`` as one short word, with its last point."""
    if not any(t.word == "." and t.glued for t in tokens):
        return tokens
    made: list[Token] = []
    at = 0
    while at < len(tokens):
        letters, end = "", at
        while end < len(tokens) and tokens[end].kind == "word" and len(letters) + len(tokens[end].word) <= _LETTERS:
            letters += tokens[end].word
            point = end + 1 < len(tokens) and tokens[end + 1].word == "." and tokens[end + 1].glued
            end += 1 + point
            if not point or letters in short:
                break
        if letters in short and end - at > 2:
            last = tokens[end - 1]
            stop = last.word == "."
            made.append(replace(tokens[at], word=letters, end=(tokens[end - 2] if stop else last).end))
            made += [last] if stop else []
            at = end
        else:
            made.append(tokens[at])
            at += 1
    return made


_CAST: Final = frozenset("monter montez zet montar monta monte".split())
_CHAINED: Final = 14  # words of a sentence that only chains


def _cast(tokens: list[Token]) -> list[Token]:
    """Sentences that cast a chain on, without the verb: "Zet met rood 7 l op", "Monter 7 m. l."."""
    if not any(t.word in _CAST for t in tokens) or not any(t.kind == "number" for t in tokens):
        return tokens
    made: list[Token] = []
    open_verb = begun = False
    for k, token in enumerate(tokens):
        if token.word in _CAST and any(t.kind == "number" for t in tokens[k : k + _CHAINED]):
            open_verb = token.word == "zet"
            begun = token.capital
            continue
        if open_verb and token.word == "op" and (k + 1 == len(tokens) or tokens[k + 1].kind == "mark"):
            open_verb = False
            continue
        made.append(replace(token, capital=True) if begun else token)
        begun = False
    return made


_JOINED: Final = frozenset("écouler rabattre crocheter prendre fermer tricoter".split())
_CLOSED: Final = frozenset("écoulées écoulés rabattues fermées prises crochetées tricotées piquées rab".split())
_TOGETHER: Final = frozenset(("ens", "ensemble"))


_LOOPED: Final = frozenset(
    word.lower() for key in ("front loops", "back loops") for word in TERMS["fr"].words[key] if " " not in word
)
"""Short words for one loop of a stitch."""


def _french(tokens: list[Token]) -> list[Token]:
    """French lines with "7e au 13e tour" as "7e à 13e tour", "2 m. s. écoulées ens." and "écouler ens. les 2 premières m." as "2 ms ens"."""
    made: list[Token] = []
    tokens = _elided(tokens)
    at = 0
    while at < len(tokens):
        token = tokens[at]
        after = tokens[at + 1] if at + 1 < len(tokens) else None
        numbered = made and made[-1].kind in ("number", "ordinal") and after is not None
        if (
            token.word == "en"
            and after is not None
            and (after.word in _LOOPED or (after.word == "brin" or after.word == "brins"))
        ):
            made.append(replace(token, word="dans"))  # "24 ms en BAR"
        elif token.word == "au" and numbered and after is not None and after.kind in ("number", "ordinal"):
            made.append(replace(token, word="à"))
        elif token.word in _CLOSED and after is not None and after.word in _TOGETHER:
            made += [replace(after, start=token.start)] if made and made[-1].word == "." else [after]
            if len(made) > 1 and made[-2].word == ".":
                del made[-2]  # the point of "2 m. s. écoulées ens."
            at += 1
        elif token.word in _JOINED and after is not None and after.word in _TOGETHER and (said := _drawn(tokens, at)):
            number, end = said
            made += [number, replace(token, word="ms", end=tokens[end - 1].end), replace(after, glued=False)]
            at = end - 1
        else:
            made.append(token)
        at += 1
    return made


def _drawn(tokens: list[Token], at: int) -> tuple[Token, int] | None:
    """The number of stitches that "écouler ens. les 2 premières m. s." draws together, and where its words end."""
    k = at + 2
    while k < len(tokens) and (tokens[k].word in (".", "les", "deux") or tokens[k].kind == "number"):
        number = tokens[k]
        k += 1
        if number.kind == "number":
            while k < len(tokens) and tokens[k].kind == "word" and k < at + 9:
                k += 1
                if tokens[k - 1].word in ("m", "mailles", "ms"):
                    while k + 1 < len(tokens) and tokens[k].word == "." and tokens[k + 1].word == "s":
                        k += 2
                    return number, k
            return None
    return None


def _unbegun(tokens: list[Token]) -> list[Token]:
    """Short lines without a verb that only says that a piece begins in a yarn: ``mit Schwarz anfangen``, ``empezar en rosa``."""
    if len(tokens) > _LINE or not any(t.word in _BEGIN for t in tokens):
        return tokens
    return [t for t in tokens if t.word not in _BEGIN]


def _copied(tokens: list[Token]) -> list[Token]:
    """A heading with its copies as English says them: ``Orejas (2 iguales, crudo)`` as "Orejas (make 2, crudo)", ``BEINE, 4 Stück, …`` as "BEINE - make 4 - …"."""
    if len(tokens) > _LINE or not tokens[0].capital or tokens[0].kind != "word":
        return tokens
    tokens = [t for k, t in enumerate(tokens) if t.word != "er" or tokens[k - 1].word not in _MAKE]  # "maak er 2"
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
        if k and after is not None and after.word in _UP_TO and k + 3 < len(made) and made[k + 3].kind == "ordinal":
            after = made[k + 3]  # "an der 5.–8. Rd"
        elif after is None or after.glued:
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
