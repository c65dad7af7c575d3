"""Printed patterns, spirals: rounds that are called rows, as many weblogs have them: "Row 1: ch 2, 6 sc in 2nd ch from hook", whose stitches all stand in
one chain and which are never turned; put as rounds."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Final

from tambour.crochet.printed.tokens import Row, Token

_ROW: Final = re.compile(r"(?:rows? (\d+)(?: - \d+)?|(\d+)(?:st|nd|rd|th)? rows?)(?: [:.)-])* ")
_ST: Final = "sc|single crochets?|hdc|dc"
_FOUNDS: Final = re.compile(
    rf"(?:ch ?2 ?[.,]? |chain 2 ?[.,]? )?(?:(?:work |make )?(\d+) (?:{_ST})|(?:{_ST}) (\d+)(?: times)?) in(?:to)? (?:the )?(?:2nd|second) (?:ch|chain|loop)(?: from (?:the )?hook)?(?= ?[.(\[=,;-]| ?$)(?! , (?!(?:sl|ss|join)))"
)
_CHAIN: Final = re.compile(r"(?:^|[ .:])(?:ch|chain) ?2(?: \.)?$")
_AROUND: Final = re.compile(r"\baround\b|\bevery (?:st|stitch|sc)\b|\b2 sc in each\b|\binc (?:x|\*|around)|\b6 inc\b")
_TURNED: Final = re.compile(r"\bturn\w*\b|: ch(?:ain)? 1\b")
_RISEN: Final = re.compile(r": (?:ch|chain) ?[23]\b(?!.*\b(?:join|sl|slst|ss)\b)")
_EACH: Final = re.compile(
    r"\bturn(?:ing|ed)?\b.*\b(?:each|every|all|end of)\b.*\brows?\b|\b(?:each|every|all)\b.*\brows?\b.*\bturn"
)
"""What is said once of all rows: "Turn at the end of every row"."""
_LEAST: Final = 3  # stitches in one chain that are a ring
_SURE: Final = 5  # of so many no row is begun
_CALLED: Final = {"row": "round", "rows": "rounds"}


def spirals(rows: list[Row]) -> list[Row]:
    """``rows`` with those called rounds that are."""
    made = list(rows)
    words = [" ".join([t.word for t in row.tokens]) for row in rows]
    heads = [_ROW.match(w) for w in words]
    if any(_EACH.search(w) and "do not turn" not in w and "not turn" not in w for w in words):
        return made
    for k, found in enumerate(heads):
        if found is None or int(found[1] or found[2]) != 1:
            continue
        behind = words[k][found.end() :]
        founds = _FOUNDS.match(behind)
        above = next((w for w in reversed(words[:k]) if w), "")
        if (
            founds is None
            or not ("2 " in behind[:8].replace(",", " ") or _CHAIN.search(above))
            or int(founds[1] or founds[2]) < _LEAST
        ):
            continue
        end = next((n for n in range(k + 1, len(rows)) if (m := heads[n]) and int(m[1] or m[2]) == 1), len(rows))
        run = [n for n in range(k, end) if heads[n]]
        said = " | ".join(words[run[0] : run[-1] + 1])
        sure = int(founds[1] or founds[2]) >= _SURE or _AROUND.search(said)
        risen = any(_RISEN.search(words[n]) for n in run[1:])  # a row's turning chain
        if len(run) < 2 or not sure or risen or _TURNED.search(said):
            continue
        for n in run:
            made[n] = replace(rows[n], tokens=_called(rows[n].tokens))
    return made


def _called(tokens: list[Token]) -> list[Token]:
    """A line whose head says round."""
    k = next(k for k, t in enumerate(tokens) if t.word in _CALLED)
    return [*tokens[:k], replace(tokens[k], word=_CALLED[tokens[k].word]), *tokens[k + 1 :]]
