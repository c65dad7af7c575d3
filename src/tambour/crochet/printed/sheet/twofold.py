"""Printed patterns, twofold: British stitches with the American ones in brackets behind them, as mills' leaflets have them: ``1dc (sc) in next st``, ``[dc2tog
(sc2tog)] 7 times``; or the other way about."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Final

from tambour.crochet.printed.tokens import Row, Token

_AMERICAN: Final = {
    "dc": "sc",
    "htr": "hdc",
    "tr": "dc",
    "dtr": "tr",
    "dc2tog": "sc2tog",
    "dc3tog": "sc3tog",
    "tr2tog": "dc2tog",
    "ss": "slst",
}
_BRITISH: Final = {us: uk for uk, us in _AMERICAN.items()}
_LEAST: Final = 5  # such brackets in a text


def once(rows: list[Row]) -> list[Row]:
    """``rows`` without the brackets that only say a stitch again as another country calls it."""
    found = {k: _again(row.tokens) for k, row in enumerate(rows) if any(t.word == "(" for t in row.tokens)}
    if sum(len(ranges) for ranges in found.values()) < _LEAST:
        return rows
    made = list(rows)
    for k, ranges in found.items():
        left = set().union(*(range(*one) for one in ranges)) if ranges else set()
        made[k] = replace(rows[k], tokens=[t for n, t in enumerate(rows[k].tokens) if n not in left])
    return made


def _again(tokens: list[Token]) -> list[tuple[int, int]]:
    """Where brackets stand that say the stitch before them again."""
    made = []
    for k in range(1, len(tokens) - 2):
        if tokens[k].word != "(":
            continue
        ends = [t.word for t in tokens[k + 1 : k + 4]]
        close = k + 1 + ends.index(")") if ")" in ends else 0
        inner = tokens[k + 1 : close]
        before = tokens[k - 1]
        if not close or not inner or before.kind not in ("word", "number"):
            continue
        name, other = _bare(before.word), _bare(inner[-1].word)
        numbered = len(inner) == 1 or (
            inner[0].kind == "number" and any(t.value == inner[0].value for t in tokens[max(0, k - 2) : k])
        )
        if numbered and (_AMERICAN.get(name) == other or _BRITISH.get(name) == other):
            made.append((k, close + 1))
    return made


_NUMBERED: Final = re.compile(r"^\d+")


def _bare(word: str) -> str:
    return _NUMBERED.sub("", word)
