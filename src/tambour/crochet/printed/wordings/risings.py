"""Printed patterns, risings: the many ways to say what the chains count for that lift a row, that it ends in those of the row before, and in which
chain a first row begins, put as most say it: "ch 3 (= 1st dc)", "skip first dc, dc in each dc across and in top of turning ch", "skip 1 ch, 8 sc"."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from typing import Final

from tambour.crochet.printed.tokens import Row
from tambour.crochet.printed.wordings.edges import placed, spoken
from tambour.crochet.words.sayings import Sayings

_CH: Final = r"(?P<ch>(?:ch|chain) [1-5]|[1-5] (?:ch|chs|chain|chains)|ch[1-5])"
_TALL: Final = r"(?:sc|hdc|dc|tr|st|stitch|sts|stitches)"
_TURNING: Final = r"(?:(?:turning|beg|beginning|starting|first|lifting) (?:ch|chain)(?: ?- ?\d)?|tch|t - ch|(?:beg )?(?:ch|chain) - ?\d|\d - (?:ch|chain)|ch \d|\d (?:ch|chain)|ch\d)"
_TOP: Final = rf"(?:in|into|on) (?:the )?(?:top|(?:last|top|3rd|third|2nd|second|4th|fourth) (?:ch|chain)|top (?:ch|chain))(?: of)?(?: the| previous| last)* {_TURNING}(?: (?:of|from) (?:the )?(?:previous|last) row)?"
_EACH: Final = rf"(?P<each>(?:in|into) (?:each|every)(?: of the)?(?: rem| remaining| other)? {_TALL}(?: across| along| around| to (?:the )?end(?: of (?:the )?row)?| to (?:the )?last st)?)"
_COUNTED: Final = r"(?P<counted> \( ?counts?[^()]*\))"
_HEAD: Final = r"(?P<head>(?:rows?|rnds?|rounds?|r) ?1 ?(?:\([^()]*\) ?)?[:.)-] )"
_SKIP: Final = r"(?:skip|miss|sk|skipping|missing) (?:the )?(?:(?P<n>1|first|1st|one|2|3|two|three)|first (?P<m>2|3|two|three)) (?:ch|chs|chain|chains)(?: from (?:the )?hook)? ?[,;.]?"
_NTH: Final = {"2": "3rd", "two": "3rd", "3": "4th", "three": "4th"}


def _first(m: re.Match[str]) -> str:
    nth = _NTH.get(m.groupdict().get("n") or m.groupdict().get("m") or "", "2nd")
    return f"{m['head']}beginning in {nth} ch from hook ,"


def _ended(m: re.Match[str]) -> str:
    return re.sub(r" to (?:the )?last st$", " across", m["each"])


_RULES: Final = Sayings[Callable[[re.Match[str]], str]](
    (rf"(?<!\S)(?:{said})", meant)
    for said, meant in (
        (
            rf"{_CH} (?P<b>\( )?(?:=|as|for|in place of|instead of|stands for|makes|is) (?:the |a |your )?(?:1st |first |1 )?(?P<st>sc|hdc|dc|tr)(?(b) \))(?= ?[,.;:])",
            lambda m: f"{m['ch']} ( counts as {m['st']} )",
        ),
        (
            rf"{_CH} - (?:does not|doesn't|doesn’t|do not|not) count\w*(?: as (?:a |the )?(?:first )?\w+)? (?:-|,)",
            lambda m: f"{m['ch']} ( does not count as a st ) ,",
        ),
        (
            rf"{_CH}{_COUNTED} ?[,.;] (?:skip|miss|sk) (?:(?:1|one|a|this) (?:st|stitch|sc|hdc|dc|tr)|(?:the )?(?:st|stitch) at (?:the )?base)",
            lambda m: f"{m['ch']}{m['counted']} , skip first st",
        ),
        (
            rf"{_CH}{_COUNTED} ?[,.;] (?:starting|beginning|start|begin) (?:in|with|from|at) (?:the )?(?:2nd|second) {_TALL}",
            lambda m: f"{m['ch']}{m['counted']} , skip first st",
        ),
        (rf"(?:in|into) (?:the )?(?:2nd|second) {_TALL} and (?:in |into )?(?=each)", lambda _: "in next st and in "),
        (
            rf"{_EACH} ?(?:, |; |\. )?(?:and |then )?(?:(?:ending|end|finish|finishing) (?:with |in )?)?(?:(?:1|one|a) )?(?:{_TALL} )?{_TOP}",
            _ended,
        ),
        (
            rf"(?P<each>(?:in|into) (?:each|every) {_TALL}(?: across)?) to (?:the )?{_TURNING} ?, (?:(?:1|one|a) )?(?:{_TALL} )?{_TOP}",
            lambda m: m["each"] if m["each"].endswith("across") else f"{m['each']} across",
        ),
        (rf"(?:,? ?)incl(?:uding)?(?: \.)? (?:the )?(?:top of )?(?:the )?{_TURNING}(?= ?[,.;(\[]|$)", lambda _: ""),
        (rf"{_HEAD}{_SKIP}", _first),
        (r"(?P<n>2nd|second) (?:st|stitch) (?=from (?:the |your )?hook)", lambda m: f"{m['n']} ch"),
        (
            r"(?P<b>beginning|starting) with (?:the )?(?=(?:2nd|second|3rd|third) (?:ch|chain)\b)",
            lambda m: f"{m['b']} in",
        ),
        (
            rf"{_HEAD}(?:in (?:the )?)?(?P<n>2nd|second|3rd|third) (?:ch|chain)(?: from (?:the )?hook)?:? ?,? (?:(?:1|one) )?(?P<st>sc|hdc|dc)(?= ?,)",
            lambda m: f"{m['head']}{m['st']} in {m['n']} ch from hook",
        ),
        (
            rf"{_HEAD}(?P<some>(?:(?:1|one) )?(?:sc|hdc|dc)) (?:in|into) (?:the )?(?P<n>2nd|second|3rd|third) (?:ch|chain)(?= ?,)",
            lambda m: f"{m['head']}{m['some']} in {m['n']} ch from hook",
        ),
        (
            rf"{_HEAD}(?:work|working|crochet) (?:all )?around (?:both sides of )?(?:the )?(?:foundation )?chain ?[:,]",
            lambda m: m["head"],
        ),
        (
            r"(?:along|on|across) (?:the )?back (?:side )?of (?:the )?(?:ch|chain)\b ?,?",
            lambda _: "on other side of chain ,",
        ),
        (r"(?P<in>in|into) (?:the )?end ch(?:ain)?\b", lambda m: f"{m['in']} last ch"),
        (
            rf"{_HEAD}(?P<some>\d+ (?:sc|hdc|dc)|(?:sc|hdc|dc) \d+) (?:back )?(?:along|across|down|over|up) (?:the |your )?(?:foundation |starting )?(?:ch|chain)(?: ?, (?:starting|beginning|start|begin) (?:in|from|with|at) (?:the )?(?:2nd|second) (?:ch|chain|st|stitch)(?: from (?:the )?hook)?)?",
            lambda m: f"{m['head']}beginning in 2nd ch from hook , {m['some']}",
        ),
    )
)
_LOOKED: Final = frozenset("ch chain chains ch1 ch2 ch3 ch4 ch5 tch chs".split())


def counting(rows: list[Row]) -> list[Row]:
    """``rows`` with such words as most others have them."""
    return [_row(row) if any(t.word in _LOOKED for t in row.tokens) else row for row in rows]


def _row(row: Row) -> Row:
    words = " ".join([t.word for t in row.tokens])
    k = _RULES.next(words)
    while k < _RULES.n:
        said, meant = _RULES[k]
        at = 0
        while (found := said.search(words, at)) is not None:
            put = meant(found)
            a, b = placed(row.tokens, *found.span())
            # What stays as it is keeps its own tokens, and so its places.
            same = 0
            new, old = put.split(), [t.word for t in row.tokens[a:b]]
            while same < min(len(new), len(old)) and new[same] == old[same]:
                same += 1
            first = row.tokens[min(a + same, b - 1)]
            made = [*row.tokens[a : a + same], *spoken(" ".join(new[same:]), first, row.tokens[b - 1])]
            if made and not same:
                made[0] = replace(made[0], capital=first.capital)
            row = replace(row, tokens=[*row.tokens[:a], *made, *row.tokens[b:]])
            at = found.start() + max(1, len(put))
            words = " ".join([t.word for t in row.tokens])
        k = _RULES.next(words, k + 1)
    return row
