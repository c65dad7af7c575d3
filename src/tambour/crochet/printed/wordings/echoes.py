"""Printed patterns, echoes: rounds that are said by other rounds, or by nothing but their number, in the many English words for it, put as most say it:
"work 1st to 3rd rnds of Balloon", "Rounds 1–3 of the Head", "3 plain rounds", "sc in each st for 3 rounds", "[rep Rnd 4] 3 times"."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import replace
from itertools import accumulate, takewhile
from typing import Final

from tambour.crochet.printed.tokens import Row, Token
from tambour.crochet.printed.wordings.reworded import word
from tambour.crochet.words.numbers import NUMBERS, ORDINALS, TEENS

_COUNTS: Final = {**NUMBERS, **TEENS, "once": 1, "twice": 2, "thrice": 3}
_N: Final = rf"(?:\d+|{'|'.join([*NUMBERS, *TEENS])})"
_TH: Final = rf"(?:\d+(?:st|nd|rd|th)|{'|'.join(ORDINALS)})"
_RN: Final = r"(?:rounds?|rnds?|rows?|rds?)"
_TO: Final = r"(?:-|to|through|thru|till|until|&|and|,)"
_SPAN: Final = (
    rf"(?:(?:the )?first (?P<few>{_N}) {_RN}"
    rf"|(?:from )?(?:the )?{_RN} (?P<a>{_N})(?: {_TO} (?:{_RN} )?{_N})*?(?: {_TO} (?:{_RN} )?(?P<b>{_N}))?"
    rf"|(?:the )?(?P<c>{_TH})(?: {_TO} (?P<d>{_TH}))? {_RN})"
)
_NAME: Final = r"(?:the |your |his |her |its )?(?P<name>[^\W\d_]+(?: (?!in |with |using |for |at |to |up |until |till |and |then |but |only |rounds?\b|rnds?\b|rows?\b|r\d)[^\W\d_]+){0,3}?(?: \d)?)"
_STOP: Final = r"(?= [.;(\[,!»=:]| - \d|$)"
_ENDED: Final = r"(?= [.;(\[!»=]| - \d|$)"
_AS: Final = (
    r"(?:of|from|for|as|as for|as in|as on|as given for|as with|as you did for|as you did with|as done for|like|like for|same as|the same as|"
    r"the same as for|same as for|identical to|exactly as|exactly as for|exactly as you did for|just as for|just as you did for|exactly like|"
    r"as described for|as written for|(?:are|is) (?:worked )?(?:the |exactly the |just the )?(?:same )?(?:as|like)(?: for| in| on| those of| that of)?)"
)
_IN: Final = r"(?:(?: ,)?(?: all| but| only| worked)* in (?:the )?(?P<hue>[^\W\d_]{1,12}(?: (?!only)[^\W\d_]{3,12})?)(?: only)?)?"
_YARNED: Final = (
    r"(?: ,)?(?: (?:in|with|using) (?:the )?(?P<hue>[^\W\d_]{1,12}(?: (?!only|yarn)[^\W\d_]{3,12})?)(?: yarn)?)?"
)
_WORK: Final = r"(?:work|make|do|crochet|complete|start|begin|repeat|rep|follow|see|copy|refer to|consult|proceed|continue|cont)(?: with| by working| by making| with working)?"
_EACH: Final = r"(?:(?:1|one|a) )?(?P<st>sc|dc|single crochet|double crochet|single crochets)(?: stitch)?(?: (?:in|into) (?:each|every|all|the)(?: of the)? ?(?:st|sts|stitch|stitches|sc|dc)?| evenly| even)?(?: around| all around| round)?(?: , | )?"
_PLAIN: Final = (
    r"(?:without (?:any )?(?:further |more )?(?:shaping|increas\w+|decreas\w+|inc|incs|dec|change\w*)(?: or (?:decreas\w+|dec))?"
    r"|with no (?:increases?|decreases?|shaping|changes?)|even|evenly|straight|plain|plainly|unchanged)"
)
_GOING: Final = (
    r"(?:then |now |next )?(?:work|crochet|continue|cont|keep going|keep on|go on|carry on|proceed|knit|make|do)?"
)


def _number(said: str | None) -> int:
    return 0 if not said else _COUNTS[said] if said in _COUNTS else ORDINALS.get(said) or int(re.sub(r"\D", "", said))


def _rounds(m: re.Match[str] | Mapping[str, str | None]) -> str:
    """The rounds that a match names, ``rounds 1 - 3``."""
    first = 1 if m["few"] else _number(m["a"] or m["c"])
    last = _number(m["few"]) or _number(m["b"] or m["d"]) or first
    return f"rounds {first} - {last}" if last > first else f"round {first}"


def _of(m: re.Match[str]) -> str:
    """Rounds of another piece, worked here."""
    said, hue = _rounds(m), m.groupdict().get("hue")
    begins = re.match(r"rounds? 1\b", said)
    meant = f"{said} : as {m['name']}" if begins else f"repeat {said} of {m['name']}"
    return f"with {hue} , {meant}" if hue else meant


def _up_to(m: re.Match[str]) -> str:
    return f"rounds 1 - {_number(m['last'])} : as {m['name']}"


def _again(m: re.Match[str]) -> str:
    """A round of the same piece so many times more."""
    said = m.groupdict()
    which, many = said.get("which"), _number(said["n"]) if "n" in said else _number(said["total"]) - 1
    return f"repeat {f'round {_number(which)}' if which else 'last round'} {many} times"


def _even(m: re.Match[str]) -> str:
    return f"next {_number(m['n'])} rounds : even"


_SHAPE: Final = r"(?:inc|incs|increases?|increasing|increased|dec|decs|decreases?|decreasing)"
_WIDER: Final = r"(?:(?:extra|more|additional|less|fewer) \w+|\w+ (?:extra|more|less|fewer)) (?:between|before|after)\b"
_ONCE_MORE: Final = rf"(?:rep|repeat|repeating|as|as for|as in|same as|like)(?: the)? (?:(?:last|previous|prev|same|this) {_RN}|{_RN} {_N}|{_TH} {_RN})\b"
_ON: Final = re.compile(
    rf"^(?:work |then )?{_ONCE_MORE}(?=.*\b(?:\d+|one) {_WIDER})(?=.*(?:\btimes\b|\btwice\b|\bthrice\b|\buntil\b|\btill\b))"
    rf"|^(?:cont|continue|keep)\b(?=.*\b(?:this way|this manner|as before|as set)\b)(?=.*\b{_SHAPE}\b)(?=.*\b\d+ (?:more )?times\b)"
    r"|^(?!.*\b(?:without|no|even|straight|plain)\b)(?:(?:cont|continue|continuing|keep|carry on|go on|proceed|work|rep|repeat)\b(?=.*\b(?:this way|this manner|(?:same way|same manner)\b.*(?:until|till)|as set|as established|in patt\w*|as before|"
    rf"{_SHAPE}|(?:extra|more|additional|less|fewer) \w+ (?:between|before|after))\b)(?=.*(?:until|till|\d+ (?:more |further |additional )?(?:rounds?|rnds?)\b))"
    rf"|{_SHAPE} (?:by )?\d+ (?:sts?|sc|dc|stitches|times)? ?(?:evenly )?(?:spaced )?(?:in|on|per|at)? ?(?:each|every|per) (?:rounds?|rnds?)(?=.*(?:until|till))"
    r"|(?:work )?\w+ (?:more |further |additional )?(?:rounds|rnds)\b(?=.*\b(?:in this way|as set|(?:extra|more|additional) \w+ between)\b))"
)
"""Sentences of rounds that go on as they began: :mod:`tambour.crochet.printed.parts.established` works them."""
_ON_SAID: Final = re.compile(
    rf"^(?:(?:work |worked |are worked )?{_ONCE_MORE}(?=.*\b(?:\d+|one) {_WIDER})|as set|as established|(?:cont\w*|keep\w*)(?: on)?(?: to)? {_SHAPE}|(?:cont\w*) (?:as|in)(?! (?:\w+ ){{0,2}}(?:spirals?|rounds?|rnds?|rows?)\b(?! until))|{_SHAPE} (?:by )?\d+ (?:sts?|sc|dc|stitches|times)? ?(?:evenly )?(?:spaced )?(?:in|on|per) (?:each|every)? ?(?:rounds?|rnds?))"
)
_Rule = tuple[re.Pattern[str], Callable[[re.Match[str]], str]]


def _rules(*rules: tuple[str, Callable[[re.Match[str]], str]]) -> tuple[_Rule, ...]:
    lead = r"(?P<lead>(?:[^\W\d_]+(?: [^\W\d_]+)? : )?(?:(?:with|using|in) [^.:;]{1,24}?(?: ,| :) )?)"
    return tuple((re.compile(f"^{lead}(?:{said})"), meant) for said, meant in rules)


_BEGUN: Final = _rules(  # whole sentences, without the head of a round
    (rf"(?:{_WORK} )?{_SPAN}(?: only)?(?: again)? {_AS} {_NAME}{_IN}{_STOP}", _of),
    (rf"{_WORK} (?:as |as for )?(?P<name>[^\W\d_]+(?: [^\W\d_]+)?) {_SPAN}{_STOP}", _of),
    (
        rf"(?:{_WORK} (?:{_AS} )?|{_AS} )(?:the instructions (?:for|of) )?{_NAME}(?: instructions| pattern)?(?: ,| \()? (?:for |working |work |only )?{_SPAN}(?: only)?(?: \))?{_YARNED}{_ENDED}",
        _of,
    ),
    (rf"{_NAME} {_SPAN}$", _of),
    (
        rf"(?:{_WORK} )?{_AS} {_NAME} (?:(?:up )?to|until|till|as far as)(?: and including)?(?: the)?(?: end of)?(?: the)? (?:{_RN} (?P<last>{_N})|(?P<lastth>{_TH}) {_RN}){_STOP}",
        lambda m: f"rounds 1 - {_number(m['last'] or m['lastth'])} : as {m['name']}",
    ),
    (rf"(?:{_WORK} )?{_AS} {_NAME} for(?: the)?(?: first)? (?P<last>{_N}) {_RN}{_STOP}", _up_to),
    # the same piece
    (
        rf"(?:rep|repeat|work|do|make) {_RN} (?P<which>\d+)(?: again)? for (?:the )?(?:next )?(?P<n>{_N})(?: more)? {_RN}",
        _again,
    ),
    (
        rf"(?:rep|repeat)(?: {_RN} (?P<which>\d+)| (?:the |this )?(?:last|previous|same|this)? ?{_RN}) for a total of (?P<total>{_N}) {_RN}{_STOP}",
        _again,
    ),
    (rf"(?:rep|repeat)(?: this| the same| it| that)? for (?:the )?next (?P<n>{_N}) {_RN}{_STOP}", _again),
    (
        rf"(?:rep|repeat|work|do|make)(?: {_RN} (?P<which>\d+)| (?:the |this )?(?:last|previous|same|this)? ?{_RN})(?: again)? ?,?(?: another| a further| for)? \(? ?(?P<n>{_N}|thrice)(?: more)?(?: times?)?(?: more)?(?: again)?(?: \))?{_STOP}",
        lambda m: _again(m) if re.search(r"\btimes?\b|\bthrice\b", m[0]) else m[0][len(m["lead"]) :],
    ),
    (rf"[\[(] (?:rep|repeat|work) {_RN} (?P<which>\d+) [\])] (?P<n>{_N}) times(?: more)?", _again),
    (
        rf"{_GOING} ?(?:a further |another )?(?P<n>{_N})(?: more| further| additional)? {_RN} (?:like|as|same as) {_RN} (?P<which>\d+){_STOP}",
        _again,
    ),
    (
        rf"{_GOING} ?(?:a further |another )?(?P<n>{_N})(?: more| further| additional)? {_RN} (?:(?:exactly |just )?the same(?: way)?|alike|in the same way|in the same manner|like (?:this|that|it)|likewise){_STOP}",
        _again,
    ),
    (
        rf"(?:cont|continue|keep)?(?: to)? ?(?:rep|repeat|repeating|working) {_RN} (?P<which>\d+) (?:until|till|to|through)(?: you have| there are| you have completed| you have worked| completing)? (?:{_RN} )?(?P<upto>\d+)(?: {_RN})?(?: in total| in all| total| altogether| are done| is done| are complete)?{_STOP}",
        lambda m: f"repeat round {m['which']} until there are {m['upto']} rounds",
    ),
    # rounds without a number
    (
        rf"{_GOING} ?(?:for )?(?:the )?(?:next )?(?:a further |another )?(?P<n>{_N})(?: more| further)? (?:{_PLAIN} {_RN}|{_RN}(?: of)?(?: plain)?(?: in)?(?: rounds of)?(?: plain)? ?(?:sc|dc|single crochet|double crochet)?(?: {_PLAIN})?)(?: (?:on|over) (?:these|those|all|the)(?: \d+)? ?(?:sts?|stitches|sc|dc)?)?(?: for the (?!next)[^\W\d_]+(?: [^\W\d_]+){{0,3}})?{_STOP}",
        lambda m: (
            _even(m)
            if re.search(
                rf"\b{_PLAIN}\b|\b(?:sc|dc|crochet)\b|\b(?:these|those|all)\b", m[0][len(m["lead"]) :].split(" ", 1)[-1]
            )
            else m[0][len(m["lead"]) :]
        ),
    ),
    (
        rf"{_GOING} ?(?:{_PLAIN}|in (?:rounds of )?(?:sc|dc|single crochet|double crochet)|on (?:these|those|the) \d* ?(?:sts?|stitches|sc|dc))(?: {_PLAIN})?(?: ,)? for (?:the )?(?:next )?(?:another )?(?P<n>{_N})(?: more| further)? {_RN}(?: {_PLAIN})?{_STOP}",
        _even,
    ),
    (rf"(?:work |crochet )?{_EACH}for (?:the )?(?:next )?(?P<n>{_N})(?: more)? {_RN}{_STOP}", _even),
    (rf"(?:sc|dc|single crochet|double crochet) (?P<n>{_N})(?: more)? {_RN}(?: {_PLAIN})?{_STOP}", _even),
    (
        rf"(?:for )?(?:the )?next (?P<n>{_N}) {_RN}(?: ,)? (?:work |just |simply )?{_EACH}{_STOP}",
        _even,
    ),
    (rf"for (?:the )?next (?P<n>{_N}) {_RN} :", lambda m: f"next {_number(m['n'])} rounds :"),
    (rf"(?P<n>{_N})(?: more)? (?:rounds|rnds|rows) : (?=(?:1 )?(?:sc|dc)\b)", lambda m: f"next {_number(m['n'])} rounds :"),
)  # fmt: skip
_SAID: Final[tuple[_Rule, ...]] = tuple(  # behind the head of a round
    (re.compile(rf"^(?:{said}){_ENDED}"), meant)
    for said, meant in (
        (rf"(?:see|ditto|= ?|do as|like|work like) {_RN} (?P<which>\d+)", lambda m: f"repeat round {m['which']}"),
        (rf"(?:\d+ )?x {_RN} (?P<which>\d+)|{_N} times {_RN} (?P<which2>\d+)", lambda m: f"repeat round {m['which'] or m['which2']}"),
        (rf"(?:work )?(?:the )?(?:same as|same as for|repeat|rep|as|as for|as in|like|see|ditto)(?: the)? (?:previous|prev|preceding|above|last|one before) ?{_RN}?", lambda _: "repeat last round"),
        (r"(?:exactly |just )?(?:the )?same(?: again| as before| as above)?|ditto|idem|likewise", lambda _: "repeat last round"),
        (rf"(?:are |is )?(?:all |both )?(?:worked |done |made )?(?:nothing , )?(?:just |simply |only )?(?:{_PLAIN}|no (?:increases?|decreases?|change|changes|shaping|inc|dec)|as is|nothing|all sc|all dc)(?: (?:sc|dc)?(?: all)?(?: around)?)?", lambda _: "even"),
        (r"(?:nothing|no change|no changes|no increases?) ?, (?:just |only |simply )?(?:sc|dc|single crochet)(?: around| in each| in all| all around)?", lambda _: "even"),
        (r"(?:a )?(?:simple|plain|normal|regular)(?: round of| rounds of)? (?:sc|dc|single crochet)(?: rounds?| rnds?| around)?", lambda _: "even"),
    )
)  # fmt: skip
_PLAINLY: Final = re.compile(r"(?:work )?\d+ (?:more )?(?:rounds|rnds)(?: more)? even")
"""What is said so already; as a head of rounds it would take in the sentences behind it: "Work 5 rounds even. Join in white and work 3 more"."""
_LIKE: Final = re.compile(
    rf"^(?:see|follow|ditto|identical to|like|=|rep from|repeat from|work as you did for|(?:are|is) (?:worked )?(?:the |exactly the )?same as(?: for| in| on| those of)?) {_NAME}(?= [.;(\[,!»]|$)"
)
_CITED: Final = re.compile(
    rf"^(?:see|refer to|copy|consult|use|follow)(?: the)?(?: instructions (?:for|of))?(?: {_NAME} {_SPAN}| {_SPAN.replace('P<few>', 'P<few2>').replace('P<a>', 'P<a2>').replace('P<b>', 'P<b2>').replace('P<c>', 'P<c2>').replace('P<d>', 'P<d2>')} (?:of|from|for|in) {_NAME.replace('P<name>', 'P<name2>')}){_STOP}"
)
_FROM: Final = re.compile(
    rf"^(?:(?:finish|complete|continue|cont|end|work|proceed) )?(?:as|as for|as in|same as|same as for|like) {_NAME} (?:from|starting (?:at|with|from)|beginning (?:at|with)) {_RN} (?P<begin>{_N})(?: on| onwards?| to (?:the )?end)?{_STOP}"
)
_HEAD: Final = re.compile(
    rf"^(?:{_RN} {_N}(?: (?:-|to|,|and|&|through|thru) (?:{_RN} )?{_N})*|r\d+(?: (?:-|to) r?\d+)?|{_TH}(?: (?:-|to|and) {_TH})? {_RN})(?: :| \)| - (?!\d)| \.| (?=are |is ))* |^\d+(?: - \d+)? [:.)] "
)
_FIRST: Final = re.compile(
    r"=|(?:see|refer|copy|consult|use|finish|complete|follow|ditto|identical|like|rep|repeat|work|as|are|is|do|x|\d+ (?:x|times)|same|exactly|just|the|idem|likewise|all|both|nothing|simply|only|"
    r"without|with|even|evenly|straight|plain|plainly|unchanged|no|a|simple|normal|regular|worked|done|made|cont\w*|keep\w*|inc\w*|dec\w*)\b"
)
"""What the words behind a head begin with that say rounds by others."""
_TRIGGER: Final = frozenset("round rounds rnd rnds row rows rd rds way manner set established".split())
_COPY: Final = re.compile(
    r"^(?:repeat|rep)\b.*\bfor (?:the |your )?(?:second|2nd|other|next(?! \d)|another|third|3rd|remaining)\b"
)
"""Rounds for another of the same, which are no rounds of one called so: "Repeat from Rnd 1 for the second ear"."""
_TITLE: Final = 14  # words and signs of a line that may be a heading
_LETTERS: Final = 2
_LINES: Final = re.compile(r"r\d+")
_ENDS: Final = frozenset((".", ";", "!", "?"))


def echoed(rows: list[Row]) -> list[Row]:
    """``rows`` with such rounds as most say them."""
    names: set[str] = set()
    made: list[Row] = []
    for row in rows:
        words = [t.word for t in row.tokens]
        if not _TRIGGER.isdisjoint(words) or (words and (words[0].isdigit() or _LINES.fullmatch(words[0]))):
            row = _row(row, names)
        elif 0 < len(words) <= _TITLE and row.tokens[0].capital:
            names.update(w for w in takewhile(str.isalpha, words) if len(w) > _LETTERS)
        made.append(row)
    return made


def _row(row: Row, names: set[str]) -> Row:
    made: list[Token] = []
    changed = False
    begin = 0
    depth = 0
    tokens = row.tokens
    for at in range(len(tokens) + 1):
        if at < len(tokens):
            depth += (tokens[at].word in "([{") - (tokens[at].word in ")]}") if tokens[at].kind == "mark" else 0
            if tokens[at].word not in _ENDS or depth > 0:
                continue
        some = _sentence(tokens[begin:at], names)
        changed = changed or some is not None
        made += tokens[begin:at] if some is None else some
        made += tokens[at : at + 1]
        begin = at + 1
    return replace(row, tokens=made) if changed else row


def _sentence(tokens: list[Token], names: set[str]) -> list[Token] | None:
    """The words of a sentence as most say it; None where nothing is to be changed."""
    said = [t.word for t in tokens]
    if not said or (_TRIGGER.isdisjoint(said) and not (said[0].isdigit() or _LINES.fullmatch(said[0]))):
        return None
    words = " ".join(said)
    head = _HEAD.match(words)
    if head is not None and head.end() < len(words):
        rest = words[head.end() :]
        signed = head[0][-2] in ":).-"
        if signed and _FIRST.match(rest) is None:
            return None
        one = _LIKE.match(rest)
        if one is not None and one["name"].split()[-1] in names:
            return _put(tokens, head.end(), head.end() + one.end(), f"as {one['name']}", ":" not in head[0])
        cited = _CITED.match(rest)
        if cited is not None and (cited["name"] or cited["name2"]).split()[-1] in names:
            groups = {k: cited[k] or cited[f"{k}2"] for k in ("few", "a", "b", "c", "d", "name")}
            there = f"as {_rounds(groups)} of {groups['name']}"
            return _put(tokens, head.end(), head.end() + cited.end(), there, ":" not in head[0])
        on = _FROM.match(rest)
        numbers = [int(n) for n in re.findall(r"\d+", head[0])]
        if on is not None and len(numbers) == 2 and numbers[1] > numbers[0] and on["name"].split()[-1] in names:
            first = _number(on["begin"])
            there = f"as rounds {first} - {first + numbers[1] - numbers[0]} of {on['name']}"
            return _put(tokens, head.end(), head.end() + on.end(), there, ":" not in head[0])
        if _ON_SAID.match(rest) is not None:
            return _put(tokens, head.end(), head.end(), "as established ,", ":" not in head[0])
        for rule, meant in _SAID:
            if (found := rule.match(rest)) is not None:
                return _put(tokens, head.end(), head.end() + found.end(), meant(found), ":" not in head[0])
        if signed:
            return None
    if _ON.match(words) is not None and "measure" not in words:
        return _put(tokens, 0, 0, "work as established ,", False)
    for rule, meant in _BEGUN:
        found = rule.match(words)
        if found is None or (found.groupdict().get("name") and found["name"].split()[-1] not in names):
            continue
        if _COPY.search(words) is not None:
            continue
        begin = found.end("lead")
        put = meant(found)
        if put != found[0][begin:] and _PLAINLY.fullmatch(found[0][begin:]) is None:
            return _put(tokens, begin, found.end(), put, False)
    return None


def _put(tokens: list[Token], begin: int, end: int, meant: str, colon: bool) -> list[Token]:
    """``tokens`` with the words from one character of them to another as ``meant``."""
    begins = [0, *accumulate(len(t.word) + 1 for t in tokens)]
    first = next(k for k, at in enumerate(begins) if at >= begin)
    last = next((k for k, at in enumerate(begins) if at >= end), len(tokens))
    a, b = tokens[first], tokens[max(first, last - 1)]
    b = a if end == begin else b
    said = [*([":"] if colon else []), *meant.split()]
    return [*tokens[:first], *(word(one, a, b) for one in said), *tokens[last:]]
