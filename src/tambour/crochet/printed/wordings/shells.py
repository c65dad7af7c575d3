"""Printed patterns, shells: groups of stitches that a text gives a name, "Shell = 5 dc in same st", "V-st = (dc, ch 1, dc) in next st", put where the
name stands: "shell in next V-st" as "(5 dc) in next ch-1 sp"."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import accumulate
from typing import Final

from tambour.crochet.printed.tokens import Row, Token
from tambour.crochet.printed.wordings.reworded import between, word

_LOOKED_AT: Final = 150  # lines that may say what a name means
_KIND: Final = r"(?:sc|hdc|dc|tr|dtr|htr)"
_ITEM: Final = rf"(?:(?:\d+ )?{_KIND}|(?:ch|chain)(?: -)? \d+(?: (?:sp|space))?|\d+ (?:chs?|chains?))"
_ITEMS: Final = rf"{_ITEM}(?: (?:, and|,|and|\.) {_ITEM}){{0,8}}"
_NAME: Final = r"(?:(?:beginning|beg|corner|small|large|single|double) )?(?:\w+ )?(?:shells?|v(?: -)?(?= (?:st|stitch)\b)|vst|fan|fans|block|group|petal|scallop)(?: (?:- )?(?:st|stitch))?"
_PLACE: Final = r"(?:the )?(?:same|next|one|indicated|designated|specified|given|each|st|stitch|sp|space|1)\b"
_MEANS: Final = re.compile(
    rf"^(?:\W+ )?(?:special (?:stitch|stitches|sts?|abbreviations?) (?:-|:) )?(?P<name>{_NAME})(?: [(\[] (?P<short>[\w -]+?) [)\]])?(?: (?:=|:|-) (?P<long>{_NAME}))? (?:=|:|-|\() (?:= )?(?:work |make )?(?:[(\[] )?(?P<items>{_ITEMS})(?: [)\]])? (?:all )?(?:in|into) {_PLACE}"
)
_MADE: Final = re.compile(
    rf"(?:[(\[] )?(?P<items>{_ITEMS})(?: [)\]])? (?:all )?in (?:the )?(?:next|same|first|last|each) [\w -]{{2,24}}? [(-] (?P<name>{_NAME}) (?:made|completed|complete|formed)\b"
)
_ONE: Final = re.compile(rf"(\d+)? ?(?:({_KIND})|(?:ch|chain)(?: -)? (\d+))")
_CENTER: Final = r"(?:(?:center|centre|middle) (?:dc|hdc|tr|sc|st|stitch|ch sp|ch - \d+ (?:sp|space)) of )|(?:ch - \d+ (?:sp|space) of )"
_AT: Final = (
    r"(?: (?:in|into|over) (?:the )?(?P<center>"
    + _CENTER
    + r")?(?P<each>each |next |last |first |same )?(?P<below>{names})s?(?![\w])(?: (?P<around>around|across))?)"
)


@dataclass(frozen=True)
class _Shell:
    """A group: its ``items`` as words; its chains in the middle (0: none); how many stitches it is."""

    items: str
    chains: int
    many: int


def shelled(rows: list[Row]) -> list[Row]:
    """``rows`` with the names of such groups as what they mean."""
    known = dict(_known(rows[:_LOOKED_AT]))
    if not known:
        return rows
    names = "|".join(re.escape(n) for n in sorted(known, key=len, reverse=True))
    said = re.compile(
        rf"(?<![\w-])(?P<name>{names})s?(?! (?:=|made|completed|complete|formed))(?![\w])"
        + _AT.replace("{names}", names)
        + "?"
    )
    return [row if not row.tokens or _explains(row) else _put(row, said, known) for row in rows]


def means(row: Row) -> bool:
    """Whether a line does no more than say what such a name means: "Special stitch - Shell: work 5 dc in same st"."""
    return (
        bool(row.tokens)
        and not _LED.isdisjoint(t.word for t in row.tokens)
        and _explains(row)
        and sum(t.word == "." for t in row.tokens[:-1]) == 0
    )


def _words(row: Row) -> str:
    return " ".join(t.word for t in row.tokens)


def _explains(row: Row) -> bool:
    return any(t.word in ("=", ":", "-", "(") for t in row.tokens[:5]) and _MEANS.match(_words(row)) is not None


def _known(rows: list[Row]) -> Iterator[tuple[str, _Shell]]:
    """Every name that the lines explain, with what it means; the first meaning of a name stands."""
    seen: set[str] = set()
    for row in rows:
        signs = any(t.word in ("made", "=", ":", "-", "completed", "complete", "formed") for t in row.tokens)
        words = _words(row) if signs and any(t.word in _LED for t in row.tokens) else ""
        said = [_MEANS.match(sentence) for sentence in re.split(r" \. (?=[^\d\W])", words)] if words else []
        for found in filter(None, (*said, *_MADE.finditer(words))):
            groups = found.groupdict()
            for name in filter(None, (groups["name"], groups.get("short"), groups.get("long"))):
                shell = _shell(found["items"])
                name = name.strip().removesuffix("s") if len(name) > 3 else name.strip()
                if name not in seen and shell is not None and name not in ("sc", "dc", "hdc", "tr", "ch"):
                    seen.add(name)
                    yield name, shell


_LED: Final = frozenset("shell shells v vst fan fans block group petal scallop".split())


def _shell(items: str) -> _Shell | None:
    """What its items are; None for a single stitch."""
    many = chains = 0
    made = []
    for one in re.split(r" (?:, and|,|and|\.) ", items):
        found = _ONE.match(one)
        if found is None:
            return None
        if found[3]:
            chains = int(found[3])
            made.append(f"ch {chains}")
        else:
            many += int(found[1] or 1)
            made.append(f"{found[1] or 1} {found[2]}")
    return _Shell(" , ".join(made), chains, many) if many > 1 else None


def _put(row: Row, said: re.Pattern[str], known: dict[str, _Shell]) -> Row:
    tokens, words = row.tokens, _words(row)
    begins = [0, *accumulate(len(t.word) + 1 for t in tokens)]
    made: list[Token] = []
    done = 0
    for found in said.finditer(words):
        first, last = between(begins, *found.span())
        before = tokens[first - 1] if first > 0 else None
        after = tokens[last].word if last < len(tokens) else ""
        if first < done or (before is not None and (before.kind == "number" or before.word in _SPOKEN)):
            continue  # "19 shells" counts them
        if after in ("(", "[", "x") or (before is None and after in ("", ":", "-")) or tokens[0].word in _SEWN:
            continue  # "Petals (make 3)", "Sew petals in place"
        made += tokens[done:first]
        made += [word(w, tokens[first], tokens[last - 1]) for w in _meant(found, known).split()]
        done = last
    return row if not done else replace(row, tokens=[*made, *tokens[done:]])


_SEWN: Final = frozenset("sew attach pin tack place stuff make fold position arrange stitch whip".split())
_SPOKEN: Final = frozenset("of each every the a skip between from".split())


def _meant(found: re.Match[str], known: dict[str, _Shell]) -> str:
    """What a name means, in the place that stands behind it."""
    shell = known[found["name"]]
    group = f"( {shell.items} )"
    if found["below"] is None:
        return group
    below = known[found["below"]]
    each = (found["each"] or "next ").strip()
    if below.chains:
        return f"{group} in {each} ch - {below.chains} sp" + (" around" if found["around"] else "")
    side = (below.many - 1) // 2
    other = below.many - 1 - side
    one = " , ".join(
        filter(
            None,
            (f"skip next {side} sts" if side else "", f"{group} in next st", f"skip next {other} sts" if other else ""),
        )
    )
    return f"* {one} ; repeat from * {found['around'] or 'around'}" if each == "each" else one
