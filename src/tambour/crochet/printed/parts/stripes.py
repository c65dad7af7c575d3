"""Printed patterns, stripes: plans of colour that a sentence says by rounds ("A 2 rounds; B 1 round", "alternating A and B every 2 rows"),
laid over the rounds that they are said of."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from typing import Final

from tambour.core.errors import Span
from tambour.core.rgb import RGB
from tambour.crochet.language.tree import Action, Line
from tambour.crochet.printed.cursor import Cursor
from tambour.crochet.printed.parts.part import Draft
from tambour.crochet.printed.rounds.items import works
from tambour.crochet.printed.tokens import Token, rows
from tambour.crochet.printed.yarns.colors import Palette

_MOST: Final = 500  # rounds that are parted by their colours
_UNIT: Final = r"(?:rnds?|rounds?|rows?|rds?)\b\.?"
_N: Final = r"(\d{1,2}|one|two|three|four|five|six)"
_YARN: Final = r"\b((?:colou?r\s+)?(?:MC|CC|C[A-F1-9]|[A-Z]\b|[1-9]\b)|(?!(?:work\w*|next|last|for|rep|repeat|every|first|of|with|then|and|in|the|following|pattern|more|alternat\w*|strip\w*|order|sequence)\b)[a-z]{3,12}(?:\s(?!for\b|and\b|then\b|throughout\b|until\b|till\b|alternat)[a-z]{3,12})?)"
_HOLD: Final = r"(?:(?:in|with|of|using|each)\s+)?"
_ITEM: Final = rf"(?:{_N}\s+{_UNIT}\s*{_HOLD}{_YARN}|{_YARN}\s*[:=–-]?\s+(?:for\s+)?{_N}\s+{_UNIT}|[Ww]ith\s+{_YARN},?\s+(?:work\s+)?{_N}\s+{_UNIT})"
_AND: Final = r"\s*(?:[,;.&]|\band\b|\bthen\b)[\s,;]*(?:and\s+|then\s+|\*\s*)?"
_LEAD: Final = r"(?:(?:working|work|worked|in|alternat\w+|the|following|this|as\s+follows|stripes?|striped|striping|pat|pattern|sequence|order|of)[\s:,–-]*)*"
_LISTED: Final = re.compile(rf"{_LEAD}\*?\s*{_ITEM}(?:{_AND}{_ITEM})+")
_ONE: Final = re.compile(_ITEM)
_LIST: Final = rf"{_YARN}(?:\s*,\s*{_YARN})*(?:\s*,?\s*(?:and|&|with)\s+|\s*,\s*){_YARN}"
_EVERY: Final = rf"(?:every|each|after\s+every|after\s+each|at\s+(?:the\s+)?end\s+of\s+(?:every|each))\s+(?:(other|alternate|2nd|second)\s+|{_N}\s+)?{_UNIT}"
_BETWEEN: Final = re.compile(
    rf"[Aa]lternat(?:e|es|ing)\s+(?:between\s+)?(?:colou?rs\s+)?{_LIST}(?:,?\s+{_EVERY})?", re.DOTALL
)
_CHANGED: Final = re.compile(
    rf"(?:and\s+)?(?:continu(?:e|ing)\s+to\s+)?(?:[Cc]hang\w+|[Aa]lternat\w+|[Ss]witch\w*)\s+(?:yarns?\s+)?(?:colou?rs?\s+)?{_EVERY}(?:,?\s+alternating\s+(?:between\s+)?{_LIST})?",
    re.DOTALL,
)
_PER: Final = re.compile(
    rf"(?:keeping\s+(?:with|to)\s+|in\s+|continu\w+\s+)?(?:the\s+)?(?:strip\w+\s+(?:pattern|sequence)\s*)?\(?{_N}\s+{_UNIT}\s+(?:per|of\s+each|in\s+each|each)\s+colou?r\)?",
    re.DOTALL,
)
_BLOCKS: Final = re.compile(
    rf"chang\w+\s+colou?rs?\s+every\s+{_N}\s+{_UNIT}\s+until\s+(?:there\s+are\s+|you\s+have\s+)?{_N}\s+(?:blocks|stripes|squares|bands|sections)"
)
_AFTER: Final = re.compile(rf"\s*[:(,–-]*\s*(?:in\s+(?:the|this)\s+(?:order|sequence)\W*)?({_LIST})(?:\s*\))?(?=\W|$)")
_NUMBERED: Final = rf"{_UNIT}\s*(\d+)(?:\s*([-–]|to|through|and|&)\s*(\d+))?"
_DYED: Final = re.compile(
    rf"(?:{_NUMBERED}\s+(?:(?:is|are)\s+)?(?:worked\s+)?(?:in|with|using)\s+{_YARN}|{_YARN}\s+(?:for|on|in)\s+{_NUMBERED})(?=\W|$)",
    re.IGNORECASE,
)
_ODDS: Final = re.compile(
    rf"(?:(?:and|all|the)\s+)*\b(odd|even)(?:[- ]numbered)?\s+(?:{_UNIT}|ones)\s*(?:(?:is|are)\s+)?(?:worked\s+)?(?:(?:in|with|using)\s+)?{_YARN}(?=\W|$)",
    re.IGNORECASE,
)
_BEFORE: Final = re.compile(r"(?:[(,;.]\s*)?(?:\b(?:work(?:ing)?|using|with|in|and|all|the)\s+)*$", re.IGNORECASE)
_TO: Final = re.compile(rf"\b(?:chang\w+\s+to|with)\s+{_YARN}")
_HINT: Final = re.compile(
    r"alternat|strip|chang|switch|per\s+colou?r|each\s+colou?r|\d\s+r(?:n?d|ow|ound)|r(?:n?d|ow|ound)s?\s*\d.*r(?:n?d|ow|ound)s?\s*\d|\bodd\b.*\beven\b|\beven\b.*\bodd\b",
    re.IGNORECASE | re.DOTALL,
)
_WORDS: Final = {"one": 1, "two": 2, "three": 3, "four": 4, "five": 5, "six": 6}


@dataclass(frozen=True)
class Plan:
    """Colours by rounds: each for so many, again and again; ``begun``: rounds of the first that are worked already."""

    runs: tuple[tuple[RGB, int], ...]
    begun: int = 0

    def hue(self, at: int) -> RGB:
        """The colour of round ``at``, from 0."""
        at = (at + self.begun) % sum(n for _, n in self.runs)
        for hue, many in self.runs:
            if at < many:
                return hue
            at -= many
        return self.runs[-1][0]


_LEADS: Final = re.compile(
    r"(?:,?\s*(?:(?:chang|alternat|switch)\w*\s+colou?rs?\s+(?:every|each)\s+(?:round|rnd|row)|in\s+(?:this|the\s+following)\s+order|(?:in\s+)?(?:the\s+)?colou?rs|in\s+(?:the\s+)?(?:following\s+)?strip(?:es?|ing)(?:\s+(?:pattern|sequence))?))?\s*[:(,.;–—-]*\s*$"
)
_COUNTED: Final = re.compile(r"\s*[(\[]\d+[^()\[\]]{0,20}[)\]]\s*\.?\s*$")
_PART: Final = re.compile(
    rf"(?:(?:{_UNIT}|[Rr])\s*(?P<a>\d+)(?:\s*[-–]\s*(?P<b>\d+))?|(?P<n>\d{{1,2}}|one|two|three|four|five|six)(?:\s+{_UNIT})?)?\s*[:=]?\s*(?:in\s+|of\s+)?(?P<hue>[a-z]+(?:\s[a-z]+)?)",
    re.IGNORECASE,
)


def _ordered(words: str, palette: Palette, many: int) -> tuple[Plan, tuple[int, int]] | None:
    """The plan of a round of several that ends with their yarns, one after the other: "Rnds 4-6: sc around (18): red, white, red"."""
    ends = len(_COUNTED.sub("", words).rstrip(" .)\n"))
    last = max(words.rfind(sign, 0, ends) for sign in ":(.;") + 1
    within = words.rfind(" in ", last, ends) + 4  # "Rnds 4-6: sc around in red, white, red"
    for begin in (last, words.find(",", words.find(":") + 1, ends) + 1, within if within > 4 else 0):
        runs = []
        for said in re.split(r"\s*(?:,|/|\band\b|\bthen\b)\s*", words[begin:ends].strip() if begin else ""):
            found = _PART.fullmatch(said)
            hue = _hue(found["hue"], palette) if found is not None else None
            if found is None or hue is None:
                break
            runs.append((hue, int(found["b"]) - int(found["a"]) + 1 if found["b"] else _number(found["n"]) or 1))
        else:
            if len(runs) > 1 and sum(n for _, n in runs) == many:
                lead = _LEADS.search(words[:begin])
                start = begin - 4 if begin == within else lead.start() if lead is not None else begin
                return Plan(tuple(runs)), (start, ends + ("(" in words[start:begin] and words[ends : ends + 1] == ")"))
    return None


_FIRST: Final = re.compile(
    r"(?:(?:go|going|carry|continue|continuing|work|keep)\w*(?: on| going)?(?: in)?(?: the)? same way\s*[,:–-]\s*)?((?:\d{1,2}\s+[a-z]+(?:\s[a-z]+)?\s*,\s*)+(?:and\s+)?\d{1,2}\s+[a-z]+(?:\s[a-z]+)?)\s*:",
    re.IGNORECASE,
)
"""The yarns of several rounds before what is worked: "11-20. Go on the same way, 2 white, 2 red, …: sc around"."""


def _led(words: str, palette: Palette, many: int) -> tuple[Plan, tuple[int, int]] | None:
    """The plan of a round of several that begins with how many of them are of which yarn."""
    found = _FIRST.search(words)
    runs: list[tuple[RGB, int]] = []
    for said in re.split(r"\s*(?:,|\band\b)\s*", found[1]) if found is not None else []:
        part = _PART.fullmatch(said)
        hue = _hue(part["hue"], palette) if part is not None and part["n"] else None
        if part is None or hue is None:
            return None
        runs.append((hue, _number(part["n"])))
    if found is None or len(runs) < 2 or sum(n for _, n in runs) != many:
        return None
    return Plan(tuple(runs)), found.span()


def _by_number(words: str, palette: Palette, first: int, many: int) -> tuple[Plan, tuple[int, int]] | None:
    """The plan of rounds whose words name a yarn for each by its number, "(Rnds 3 and 4 in B, Rnds 5 and 6 in C)", or for odd and even ones."""
    hues: dict[int, RGB | None] = {}
    found = list(_DYED.finditer(words))
    for m in found:
        a, sign, b, yarn = (m[1], m[2], m[3], m[4]) if m[4] else (m[6], m[7], m[8], m[5])
        low, high = int(a), int(b or a)
        span = (low, high) if sign in ("and", "&") else range(low, high + 1)
        hues |= dict.fromkeys(span, _hue(yarn, palette))
    if not found and len(found := list(_ODDS.finditer(words))) == 2:
        kinds = {m[1].lower(): _hue(m[2], palette) for m in found}
        hues = {n: kinds.get("odd" if n % 2 else "even") for n in range(first, first + many)}
    plan = [hues.get(n) for n in range(first, first + many)]
    runs = [(hue, 1) for hue in plan if hue is not None]
    if not found or len(runs) < many or len(hues) != many:
        return None
    lead = _BEFORE.search(words[: found[0].start()])
    begin, end = lead.start() if lead is not None else found[0].start(), found[-1].end()
    return Plan(tuple(runs)), (begin, end + (words[begin] == "(" and words[end : end + 1] == ")"))


def _odds(words: str, palette: Palette, worked: list[Line]) -> tuple[Plan, tuple[int, int]] | None:
    """The plan of a sentence that names a yarn for odd rounds and one for even ones, from the next round on."""
    found = list(_ODDS.finditer(words))
    last = next((line for line in reversed(worked) if line.number is not None), None)
    kinds = {m[1].lower(): _hue(m[2], palette) for m in found}
    if len(found) != 2 or last is None or last.number is None or None in kinds.values() or len(kinds) < 2:
        return None
    odd = (last.number + last.times) % 2
    runs = [(kinds[kind], 1) for kind in (("odd", "even") if odd else ("even", "odd"))]
    return Plan(tuple((hue, n) for hue, n in runs if hue is not None)), (found[0].start(), found[-1].end())


_ONWARD: Final = re.compile(
    rf"^\W*(?:in\s+)?(?:the\s+same\s+)?stripes?\b[^.;:\d]*\b(?:begin|start)\w*\s+(?:with|in)\s+{_YARN}(?=\W|$)",
    re.IGNORECASE,
)
"""Stripes as those of a part before: "Stripes, begin with cream"."""
_AGAIN: Final = re.compile(
    r",\s*(?:every|each)\s+(?:round|rnd|row)\s+(?:in\s+)?(?:the\s+)?other\s+colou?r", re.IGNORECASE
)
"""What a round says once more that is striped already."""


def onward(words: str, palette: Palette, plans: list[Plan]) -> tuple[Plan, tuple[int, int]] | None:
    """The stripes of an earlier part, begun with the yarn that a sentence names; ``plans`` : those of the text so far."""
    found = _ONWARD.match(words)
    hue = _hue(found[1], palette) if found is not None else None
    plan = next((p for p in reversed(plans) if hue in [one for one, _ in p.runs]), None)
    if found is None or plan is None:
        return None
    at = next(k for k, (one, _) in enumerate(plan.runs) if one == hue)
    return Plan((*plan.runs[at:], *plan.runs[:at])), found.span()


def unsaid(words: str, tokens: list[Token], start: int) -> list[Token]:
    """``tokens`` of a striped round, whose words begin at ``start``, without "every round the other colour"."""
    found = _AGAIN.search(words)
    return tokens if found is None else without(tokens, Span(start + found.start(), start + found.end()))


def planned(
    words: str, palette: Palette, worked: list[Line], many: int = 1, first: int = 0
) -> tuple[Plan, tuple[int, int]] | None:
    """The plan that ``words`` of so many rounds say, the ``first`` of which is numbered so, and from which letter to which they say it; None
    where they say none.

    worked : the rounds of the part so far, whose yarns "changing colour every row" goes on with
    """
    if many > 1 and (ordered := _ordered(words, palette, many) or _led(words, palette, many)) is not None:
        return ordered
    if not _HINT.search(words):
        return None
    if many == 1 and not first and (odds := _odds(words, palette, worked)) is not None:
        return odds
    if many > 1 and first and (by_number := _by_number(words, palette, first, many)) is not None:
        return by_number
    if (found := _CHANGED.search(words)) is not None and (after := _AFTER.match(words, found.end())) is not None:
        hues = _hues(after[1], palette)
        if hues is not None and len(hues) > 1:
            every = _many(found[1], found[2])
            return Plan(tuple((hue, every) for hue in hues)), (found.start(), after.end())
    if (found := _CHANGED.search(words)) is not None and (runs := _changed(found, palette, worked)):
        return Plan(runs, phase(runs, worked)), found.span()
    if (found := _BETWEEN.search(words)) is not None:
        hues = _hues(found[0], palette)
        every = _many(found[len(found.groups()) - 1], found[len(found.groups())])
        if hues is not None and len(hues) > 1:
            return Plan(tuple((hue, every) for hue in hues)), found.span()
    if (found := _LISTED.search(words)) is not None:
        items = [_item(m, palette) for m in _ONE.finditer(found[0])]
        known = [i for i in items if i is not None]
        if len(known) > 1 and len(known) == len(items):
            return Plan(tuple(known)), found.span()
    if (found := _PER.search(words)) is not None:
        used = _used(worked)
        many = _number(found[1])
        if len(used) > 1 and many:
            runs = tuple((hue, many) for hue in used)
            return Plan(runs, phase(runs, worked)), found.span()
    return None


def blocks(words: str, palette: Palette, worked: list[Line]) -> tuple[Plan, int, tuple[int, int]] | None:
    """The plan of "…, change colors every 8 rows until there are 8 blocks", how many rows that makes in all, and which letters say it; the
    yarns are the one at hand and those that the words before name."""
    found = _BLOCKS.search(words)
    if found is None:
        return None
    high, many = _number(found[1]), _number(found[2])
    named = [_hue(m[1], palette) for m in _TO.finditer(words[: found.start()])]
    hues = list(dict.fromkeys([*_used(worked)[-1:], *(h for h in named if h is not None)]))
    if len(hues) < 2:
        hues = _used(worked)
    if not high or not many or len(hues) < 2:
        return None
    runs = tuple((hue, high) for hue in hues)
    return Plan(runs, phase(runs, worked)), high * many, found.span()


def without(tokens: list[Token], place: Span) -> list[Token]:
    """``tokens`` but those that stand at ``place``."""
    return [t for t in tokens if t.end <= place.start or t.start >= place.end]


def lay(draft: Draft, known: set[int], plan: Plan, place: Span, onward: bool) -> None:
    """Lays ``plan`` over the lines of ``draft`` that are not ``known`` by their identity; a plan that goes ``onward`` ends where a round
    says a yarn of its own."""
    new = [line for line in draft.lines if id(line) not in known]
    own = [
        hue for line in new if line.span.start >= place.start for hue in _colors(line)
    ]  # a chain above may name the first
    if not any(line.in_round for line in new) or (onward and own):
        draft.plan = None if new else draft.plan
        return
    draft.lines = [line for line in draft.lines if id(line) in known] + striped(new, plan, place)
    if onward:
        done = plan.begun + sum(line.times for line in new if line.in_round)
        draft.plan = replace(plan, begun=done), place


def striped(lines: list[Line], plan: Plan, span: Span) -> list[Line]:
    """``lines`` with their rounds in the colours of ``plan``, each change of colour on a line before its round."""
    made: list[Line] = []
    at, hue = 0, None
    period = sum(n for _, n in plan.runs)
    for line in lines:
        if not line.in_round or line.times > _MOST:
            made.append(line)
            continue
        every = list(line.rounds()) if line.again is not None else [line]
        for one in every:
            done = 0
            while done < one.times:
                now = plan.hue(at)
                many = 1
                while done + many < one.times and plan.hue(at + many) == now:
                    many += 1
                goes_on = at == 0 and plan.begun % period and now == plan.hue(-1)
                if now != hue and not goes_on:
                    made.append(Line((Action("color", span, numbers=now),), span, False))
                hue = now
                number = None if one.number is None else one.number + done
                last = done + many == one.times
                made.append(
                    replace(
                        one,
                        times=many,
                        times_span=one.times_span if many > 1 else None,
                        number=number,
                        stated=one.stated if last else None,
                        notes=one.notes if last else (),
                    )
                )
                done, at = done + many, at + many
    return made


def _changed(found: re.Match[str], palette: Palette, worked: list[Line]) -> tuple[tuple[RGB, int], ...]:
    """The runs of "changing colour every other row": of the yarns it names, else of those worked last."""
    many = _many(found[1], found[2])
    named = found[0].lower().find("alternating", 5)
    hues = _hues(found[0][named:], palette) if named > 0 else None
    hues = hues or _used(worked)
    return tuple((hue, many) for hue in hues) if len(hues) > 1 else ()


def _many(other: str | None, number: str | None) -> int:
    return 2 if other else _number(number) or 1


def _number(word: str | None) -> int:
    return 0 if word is None else int(word) if word.isdigit() else _WORDS.get(word, 0)


def _hues(words: str, palette: Palette) -> list[RGB] | None:
    """The yarns of a list, "A, B and C"; None where one is not known."""
    body = re.sub(r"^[Aa]lternat\w+\s+(?:between\s+)?(?:colou?rs\s+)?", "", words.strip())
    body = re.split(r",?\s+(?:every|each|after|at)\b", body)[0]
    found = [_hue(one, palette) for one in re.split(r"\s*(?:,|\band\b|&|\bwith\b)\s*", body) if one.strip()]
    return None if any(h is None for h in found) else [h for h in found if h is not None]


def _hue(words: str, palette: Palette) -> RGB | None:
    """The yarn of a letter or a name."""
    c = Cursor(rows(words.strip())[0].tokens)
    if not c.tokens:
        return None
    found = palette.color(c, 0) or palette.letter(c, 0)
    return found[0] if found is not None and found[1] == len(c.tokens) else None


def run(line: str, palette: Palette) -> tuple[RGB, int] | None:
    """The run that a line of a list says, "With D – 2 rnds"; None for another line."""
    found = _ONE.fullmatch(re.sub(r"^[ \t*•]*(?:[Ww]ith|[Ii]n|[Uu]sing)?[ \t]+|[\s.;,*]+$", "", f" {line}"))
    return None if found is None else _item(found, palette)


def _item(found: re.Match[str], palette: Palette) -> tuple[RGB, int] | None:
    """One run of a list: "2 rounds in B", "A 2 rounds", "With C, work 1 row"."""
    number, yarn = next((n, y) for n, y in ((found[1], found[2]), (found[4], found[3]), (found[6], found[5])) if n)
    hue = _hue(yarn, palette)
    many = _number(number)
    return None if hue is None or not many else (hue, many)


def _used(worked: list[Line]) -> list[RGB]:
    """The yarns of the last stripes: from the second but last change of colour on, the first of them next."""
    hues = [i.numbers for line in worked for i in _colors(line)]
    recent: list[RGB] = []
    for hue in reversed(hues):
        if hue in recent:
            break
        recent.insert(0, (hue[0], hue[1], hue[2]))
    return recent


def _colors(line: Line) -> list[Action]:
    return [i for one in line.rounds() for i in one.items if isinstance(i, Action) and i.name == "color"]


def phase(runs: tuple[tuple[RGB, int], ...], worked: list[Line]) -> int:
    """Rounds of the plan that are worked already: those in the last yarn, behind all the runs before it."""
    done = 0
    hue: tuple[int, ...] | None = None
    for line in worked:
        colors = [i for i in line.items if isinstance(i, Action) and i.name == "color"]
        if colors:
            # A colour behind its stitches is for the next round.
            behind = not any(map(works, line.items[line.items.index(colors[-1]) :]))
            done = 0 if behind or not line.in_round else line.times
            hue = colors[-1].numbers
        elif line.in_round:
            done += line.times
    before = 0
    for one, many in runs:
        if one == hue:
            return before + min(done, many)
        before += many
    return 0
