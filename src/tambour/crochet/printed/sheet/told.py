"""Printed patterns, told: rounds as people tell them, in sentences without heads, "then three plain and two in the next, thirty", or as they are typed up from
a film: "Round four, two single crochets and an increase, six times, so we are at 24"."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from itertools import accumulate
from typing import Final

from tambour.crochet.printed.sheet.meanwhile import meanwhile
from tambour.crochet.printed.sheet.tellings import COUNT, DEC, LABEL, events
from tambour.crochet.printed.tokens import Row, Token
from tambour.crochet.words.numbers import NUMBERS

_HEADED: Final = re.compile(
    r"^(?:[^\w\s]+ )*(?:(?:rnds?|rounds?|rd|r|rows?)(?: [.#])? ?\d+(?: (?:-|–|to|and|&|,|~) (?:r ?)?\d+)*|\d+(?:st|nd|rd|th)?(?: (?:-|–|to|and) \d+(?:st|nd|rd|th)?)? (?:rnds?|rounds?|rows?)?)(?P<behind>.*)$"
)
_WRITTEN: Final = re.compile(
    r"(?:rnds?|rounds?|rows?) (?:\d+ (?:(?:-|to|and) \d+ )?)?[:.=]|\br\d{1,3} (?:- \d{1,3} )?:"
)  # wherever in a line they stand
_STITCHES: Final = frozenset("sc dc hdc htr tr ch inc dec sl ss slst blo flo mr in repeat fold with as".split())


def _head(tokens: list[Token]) -> bool:
    """Whether a line is a round that is written, with its number first, where talk goes on in small letters: "Round one, we're putting …"."""
    found = _HEADED.match(_words(tokens[:9]))
    if (
        found is None
        or not found["behind"].split()
        or not any(t.kind in ("number", "ordinal") or t.word[-1:].isdigit() for t in tokens[:3])
    ):
        return False
    at = len(_words(tokens[:9])[: found.start("behind")].split())
    after = tokens[at] if at < len(tokens) else None
    if after is None or (after.kind == "mark" and after.word != ","):
        return True
    return after.kind == "number" or after.capital or after.word in _STITCHES


_FEW: Final = 5  # told rounds of a text, at least
_KEPT: Final = re.compile(r"\b(?:fasten|stuff|stuffing|fill|leave|cut|close|eyes?|sew|change|embroider)\b")
_CHANGES: Final = re.compile(r"^(?:change|changing|switch|switching|swap|swapping|go|going)\b")
_WEAK: Final = frozenset("now still then again start".split())
_CHAIN: Final = re.compile(r"(?<!\S)chain \d+(?!\S)")
_YARN: Final = re.compile(r"^(?:now |still |then |again |start )?(?:with|in) (?:the )?[a-z]+(?: [a-z]+)?(?: again)? ,")
_STAMP: Final = re.compile(r"^[\[(]? ?\d{1,2} : \d\d(?: : \d\d)? ?[\])]? ?")
_LISTED: Final = 3  # lines of a film's chapters
_NAME: Final = 4  # words of a heading within its paragraph


@dataclass
class _Round:
    """One told round, or several alike: its words, where they stand, and the numbers that a label gives it."""

    body: str
    at: tuple[int, int]
    many: int = 1
    numbers: tuple[int, int] | None = None
    count: int | None = None
    row: bool = False


@dataclass
class _Telling:
    """What is known while a text is told: the number of the last round, its stitches, and how the last shaping was meant."""

    last: int = 0
    edge: float = 0
    shape: str = ""
    flat: bool = False
    heading: tuple[Token, ...] = ()


def told(rows: list[Row]) -> list[Row]:
    """``rows`` with told rounds as lines of rounds, where a text tells more of them than it writes."""
    rows = _unstamped(rows)
    headed = [bool(row.tokens and _head(row.tokens)) for row in rows]
    found = sum(
        len(events(_words(s)))
        for row, written in zip(rows, headed, strict=True)
        if row.tokens and not written
        for s in _sentences(_counted(row.tokens))
    )
    written = sum(len(_WRITTEN.findall(_words(row.tokens))) for row in rows if row.tokens)
    if found < _FEW or max(sum(headed), written) >= found:
        return rows
    labelled = sum(1 for row in rows if row.tokens and LABEL.search(_words(_counted(row.tokens)))) >= _FEW
    made: list[Row] = []
    telling = _Telling()
    for row in rows:
        lines = _told(row, telling, labelled) if row.tokens else [row]
        if len(lines) > 1 or (lines and lines[0] is not row):
            _entitle(made, telling)
            _copied(made, lines, row)
        made += lines
    return made


_TITLE: Final = 8  # words of a heading
_ALIKE: Final = re.compile(
    r" ?[,(-]? ?(?:make |crochet )?(?P<many>\d+)(?: pieces| alike| the same| of them| of these)*(?: alike)? ?\)?$"
)
_NEEDED: Final = re.compile(
    r"\b(?:need|make|made|want|do|work|crochet|crocheted)(?: about)? (?P<many>\d+)(?: of (?:them|these|those)| little ones| big ones| small ones|(?: all)? alike)"
)


def _entitle(made: list[Row], telling: _Telling) -> None:
    """Marks the line over a told part as its heading, with its copies as others say them: "The wings (two alike)"."""
    at = next((k for k in range(len(made) - 1, -1, -1) if made[k].tokens), None)
    if (
        at is None
        or len(made[at].tokens) > _TITLE
        or not made[at].tokens[0].capital
        or made[at].tokens[-1].word in (".", ":", ",")
    ):
        return
    if any(made[k].tokens for k in range(max(0, at - 1), at)):
        return
    tokens = _counted(made[at].tokens)
    telling.heading = tuple(t for t in tokens if t.kind == "word" and t.word not in ("the", "a"))[-2:]
    found = _ALIKE.search(_words(tokens))
    if found is not None and found.start():
        begins = [0, *accumulate(len(t.word) + 1 for t in tokens)]
        first, _ = _place(begins, found.start() + (_words(tokens)[found.start()] == " "), len(_words(tokens)))
        tokens = [*tokens[:first], *_make(found["many"], tokens[-1])]
    if all(t.kind in ("word", "number", "mark") for t in tokens) and tokens:
        made[at] = Row(tokens, made[at].start, made[at].end, max(made[at].marked, 1))


def _make(many: str, at: Token) -> list[Token]:
    return [_token(w, at.end, at.end) for w in ("(", "make", many, ")")]


def _copied(made: list[Row], lines: list[Row], row: Row) -> None:
    """Adds the copies that a paragraph says to the heading over it: "We need two of these."."""
    said = _NEEDED.search(_words(_counted(row.tokens)))
    named = [r for r in (*made[-2:], *lines[:1]) if r.tokens and r.marked]
    if said is None or not named or any(t.word in ("make", "x") for t in named[-1].tokens):
        return
    named[-1].tokens.extend(_make(said["many"], named[-1].tokens[-1]))


def _unstamped(rows: list[Row]) -> list[Row]:
    """Lines of a film without the times at their beginnings; its list of chapters is none of the text."""
    stamped = [bool(row.tokens and _timed(row.tokens)) for row in rows]
    if sum(stamped) < _LISTED:
        return rows
    made = []
    for k, row in enumerate(rows):
        if not stamped[k]:
            made.append(row)
            continue
        bare = row.tokens[0].kind == "number"
        beside = bare and any(
            stamped[n] and rows[n].tokens[0].kind == "number" for n in (k - 1, k + 1) if 0 <= n < len(rows)
        )
        end = len(_STAMP.match(_words(row.tokens[:8]))[0].split())  # type: ignore[index]
        made.append(replace(row, tokens=[] if beside else row.tokens[end:]))
    return made


def _timed(tokens: list[Token]) -> bool:
    """Whether a line begins with a time, written without blanks and with no stitch behind it: "17:20 the head", but "17: 20sc" is a round."""
    begun = next((k for k, t in enumerate(tokens) if t.kind == "number"), 0)
    if not _STAMP.match(_words(tokens[:8])) or len(tokens) < begun + 3:
        return False
    hour, colon, minute = tokens[begun : begun + 3]
    behind = tokens[begun + 3] if len(tokens) > begun + 3 else None
    counted = behind is not None and behind.start == minute.end and behind.word in _STITCHES
    return hour.end == colon.start and colon.end == minute.start and not counted


def _words(tokens: list[Token]) -> str:
    return " ".join(t.word for t in tokens)


def _counted(tokens: list[Token]) -> list[Token]:
    """Words with small numbers as numbers."""
    return [
        Token("number", str(NUMBERS[t.word]), t.start, t.end, NUMBERS[t.word], t.glued, t.capital)
        if t.word in NUMBERS
        else t
        for t in tokens
    ]


def _sentences(tokens: list[Token]) -> list[list[Token]]:
    made: list[list[Token]] = [[]]
    for token in tokens:
        made[-1].append(token)
        if token.word in (".", "!", "?", "…") and made[-1]:
            made.append([])
    return [s for s in made if s]


def _told(row: Row, telling: _Telling, labelled: bool) -> list[Row]:
    """A line as its told rounds, and what else its sentences say on lines of their own."""
    sentences = _sentences(_counted(row.tokens))
    made: list[Row] = []
    any_told = False
    if len(sentences) > 1 and _names(sentences[0]) and any(events(_words(s)) for s in sentences[1:]):
        made.append(Row(sentences[0][:-1], sentences[0][0].start, sentences[0][-1].end, 1))
        telling.heading = tuple(t for t in sentences[0][:-1] if t.word not in ("the", "a"))
        sentences = sentences[1:]
    label: tuple[int, int] | None = None
    flat = False
    loops = ""
    began = False
    for some in sentences:
        words = _words(some)
        tellings = events(words)
        pending = LABEL.search(words)
        if "back loop" in words:
            loops = "blo"
        elif "front loop" in words:
            loops = "flo"
        elif "both loops" in words:
            loops = ""
        if not tellings:
            if pending is not None and labelled:
                label, flat = _numbers(pending), pending["kind"].startswith("row")
                rest = some
            else:
                if (count := _alone(words)) is not None and made and any_told:
                    _state(made, count)
                    continue
                if _NEEDED.search(words) and len(some) <= _SHORT:
                    continue  # the heading has these copies
                rest = some
            if not (labelled and pending is not None):
                made.append(Row(rest, rest[0].start, rest[-1].end, row.marked if not made else 0))
            continue
        any_told = True
        begins = [0, *accumulate(len(t.word) + 1 for t in some)]
        lead = words[: tellings[0][0]]
        if (chain := _CHAIN.search(lead)) is not None and tellings[0][2] == "row":
            first, last = _place(begins, *chain.span())
            made.append(
                Row(
                    [*some[first : last + 1], _token(".", some[last].end, some[last].end)],
                    some[first].start,
                    some[last].end,
                )
            )
        elif _YARN.match(lead):
            end = next(k for k, t in enumerate(some) if t.word == ",")
            yarn = [t for t in some[:end] if t.word not in _WEAK]
            made.append(Row([*yarn, _token(".", some[end].start, some[end].start)], some[0].start, some[end].end))
        done, before, again = 0, len(made), False
        for n, (a, b, kind, said) in enumerate(tellings):
            stop = tellings[n + 1][0] if n + 1 < len(tellings) else len(words)
            inside = next(iter(LABEL.finditer(words[done:a])), None)
            if inside is not None:
                label, flat = _numbers(inside), inside["kind"].startswith("row")
            if labelled and label is None and telling.last and kind != "ring" and kind != "row":
                done, again = b, True
                continue  # said once more: "So that's two in each"
            one = _round(kind, said, telling, words[done:b])
            if one is None:
                continue
            lead = (
                words[done:a]
                if n == 0 and len(made) == before and not _YARN.match(words) and not _CHAIN.search(words[:a])
                else ""
            )
            ahead, along = _beside(some, begins, (0, len(lead)) if lead else (0, 0))
            late, behind = _beside(some, begins, (b, stop)) if n + 1 < len(tellings) else ([], [])
            tail = _KEPT.search(words[b:]) if n + 1 == len(tellings) else None
            if n + 1 == len(tellings) and tail is None:
                late, behind = _beside(some, begins, (b, len(words)))
            if loops and kind != "ring" and one.body[:3] not in ("blo", "flo"):
                one.body = f"{loops} , {one.body}"
                loops = ""
            one.row = one.row or flat or telling.flat
            many = label[1] - label[0] + 1 if label is not None else 1
            if labelled and label is not None and label[0] > telling.last + 1:
                telling.last = label[0] - 1
            if kind == "ring" and began:
                made += _second(some, words[:a], words[b:], telling)
            began = began or kind in ("ring", "row")
            one.many = max(one.many, many)
            one.count = _count(words[b:stop], telling.edge)
            first, last = _place(begins, a, b)
            made += [*ahead, *late, *_line(one, telling, some[first], some[last]), *along, *behind]
            if kind == "joined":
                made.append(Row(some, some[0].start, some[-1].end))  # what it is joined to is told
            label = None
            done = b
        if len(made) == before and (pending is not None or not again):
            made.append(Row(some, some[0].start, some[-1].end))
        rest_words = words[done:]
        if _KEPT.search(rest_words):
            first, _ = _place(begins, done, len(words))
            rest = some[first:]
            if (hued := _beside(some, begins, (done, len(words)))) and any(
                _CHANGES.search(_words(r.tokens)) for r in hued[1]
            ):
                made[-1:] = [*hued[0], *made[-1:], *hued[1]]
                continue
            while rest and (rest[0].kind in ("mark", "number") or rest[0].word in ("and", "then", "so", "leaving")):
                rest = rest[1:]
            if len(rest) > 1:
                made.append(Row(rest, rest[0].start, rest[-1].end))
    return made if any_told else [row]


def _beside(some: list[Token], begins: list[int], at: tuple[int, int]) -> tuple[list[Row], list[Row]]:
    """What stands between two characters of a told sentence besides rounds, to come before and behind the round there."""
    first = next((k for k, begin in enumerate(begins) if begin >= at[0]), len(some))
    last = next((k for k, begin in enumerate(begins) if begin >= at[1]), len(some))
    return meanwhile(some[first:last])


def _names(some: list[Token]) -> bool:
    """Whether a sentence is only a name: "The cap.", "SPOTS"."""
    words = [t for t in some if t.kind == "word"]
    return (
        0 < len(words) <= _NAME
        and some[0].capital
        and len(words) == len(some) - 1
        and some[0].word in ("the", "a", "an")
    )


def _numbers(found: re.Match[str]) -> tuple[int, int]:
    first = int(found["from"])
    last = int(found["last"] or found["to"] or first)
    return (first, last) if last >= first else (first, first)


def _round(kind: str, said: re.Match[str], telling: _Telling, words: str) -> _Round | None:
    """A round of a kind; None where nothing says on what it is worked."""
    at = said.span()
    found = said.groupdict()
    if kind == "ring":
        many = int(found["ring"] or found["of"])
        telling.last, telling.edge, telling.shape, telling.flat = 0, many, "", False
        return _Round(f"{many} sc in mr", at) if 2 < many < 40 else None
    if kind == "rows":
        many = int(found["rows"]) - telling.last
        return _Round("sc across", at, many, row=True) if telling.last and many > 0 else None
    if kind == "row":
        telling.last, telling.edge, telling.flat = 0, 0, True
        each = "2 sc" if "2" in (found.get("in"), found.get("each")) else "1 sc"
        return _Round(f"{each} in 2nd ch from hook and {each} in each ch across", at, row=True)
    if not telling.last:
        return None
    if kind == "edges":
        way = {"decrease": "dec", "increase": "inc"}.get(found["way"] or "", telling.shape)
        telling.shape = way
        middle = int(found["middle"] or found["same"])
        telling.edge = middle + (2 if way == "dec" else 4)
        return _Round(f"{way} , {middle} sc , {way}", at)
    if kind == "double":
        telling.edge *= 2
        return _Round("2 sc in each st around", at)
    if kind == "joined":
        return _Round("sc around", at)
    if kind == "spent":
        telling.edge /= 2
        return _Round("dec around", at)
    if kind in ("shape", "more"):
        many = int(found.get("plain") or found.get("between") or 0)
        what = found.get("what") or found.get("these") or ""
        shape = ("dec" if re.fullmatch(DEC, what) or what == "decreases" else "inc") if what else telling.shape
        if not shape:
            return None
        telling.shape = shape
        telling.edge *= (many + 2) / (many + 1) if shape == "inc" else (many + 1) / (many + 2)
        times = found.get("times") or found.get("by") or ("2" if found.get("twice") else "")
        body = f"( {many} sc , {shape} )" if many else shape
        return _Round(f"{body} x {times}" if times else f"{body} around", at)
    many_said = found["many"] or found["number"] or found["for"] or "1"
    many = int(many_said) if many_said.isdigit() else 1
    loops = found["loops"] or ""
    body = "sc around"
    if "back" in loops:
        body = "blo , sc around"
    elif "front" in loops:
        body = "flo , sc around"
    return _Round(body, at, many)


def _count(words: str, edge: float) -> int | None:
    """The stitches that words behind a round say it has: what it makes, where they say more than one number."""
    found = [int(next(g for g in one.groups() if g)) for one in COUNT.finditer(words)]
    bracket = [int(one["bracket"]) for one in COUNT.finditer(words) if one["bracket"]]
    if bracket:
        return bracket[0]
    return (
        round(edge)
        if round(edge) in found
        else found[0]
        if len(found) == 1 and abs(found[0] - edge) <= edge / 4
        else None
    )


_SHORT: Final = 9  # words of "We need two of these."
_SIZES: Final = re.compile(r"\b(big|bigger|small|smaller|little|large|larger|tiny|medium|second|other)\b")


def _second(some: list[Token], lead: str, behind: str, telling: _Telling) -> list[Row]:
    """The heading of a further piece that a paragraph tells: "For the small ones it's only one round, seven in the ring"."""
    size = _SIZES.search(lead)
    if size is None or not telling.heading:
        return []
    at = next((k for k, t in enumerate(some) if t.word == size[1]), len(some))
    name = some[at : at + 2]  # "small ones", "big spot"
    if len(name) < 2 or name[1].kind != "word":
        return []
    said = re.search(rf"(\d+) (?:\w+ )?{size[1]} ones?", lead) or re.search(r"(?:need|made?) (\d+) of", behind)
    copies = _make(said[1], name[1]) if said is not None else []
    return [Row([replace(name[0], capital=True), name[1], *copies], name[0].start, name[1].end, 1)]


def _alone(words: str) -> int | None:
    """The count of a sentence that says nothing else: "Forty-two.", "Still twenty-four."."""
    found = _SAID.fullmatch(words)
    return int(found[1]) if found is not None else None


_SAID: Final = re.compile(
    r"(?:(?:still|so|that's|now|count them|count up|count|you|we|i|should|'ll|will|have|no|sorry|wait|mean|it's|is|,|–|-|\d+(?= (?:[,…] )?(?:no|sorry|wait)\b)|…) )*(\d+)(?: stitches| sts)?(?: every time)? ?[.!…]?"
)


def _state(made: list[Row], count: int) -> None:
    """Adds a count to the round that was told last, where it has none."""
    row = made[-1]
    if not any(t.word == ":" for t in row.tokens[:6]) or row.tokens[-1].word != ".":
        return
    end = -4 if row.tokens[-2].word == ")" and row.tokens[-4].word == "(" else -1
    at = row.tokens[-1].end
    row.tokens[end:] = [_token(w, at, at) for w in ("(", str(count), ")", ".")]


def _place(begins: list[int], a: int, b: int) -> tuple[int, int]:
    first = next((k for k, at in enumerate(begins) if at >= a), len(begins) - 2)
    last = next((k for k, at in enumerate(begins) if at >= b), len(begins) - 1) - 1
    return min(first, len(begins) - 2), max(min(last, len(begins) - 2), 0)


def _line(one: _Round, telling: _Telling, first: Token, last: Token) -> list[Row]:
    """The line of a told round."""
    begin, end = telling.last + 1, telling.last + one.many
    telling.last = end
    head = f"{'row' if one.row else 'round'} {begin}" + (f" - {end}" if end > begin else "") + " :"
    tail = f" ( {one.count} )" if one.count is not None else ""
    tokens = [_token(word, first.start, last.end) for word in f"{head} {one.body}{tail} .".split()]
    tokens[0] = replace(tokens[0], capital=True)
    return [Row(tokens, first.start, last.end)]


def _token(word: str, start: int, end: int) -> Token:
    number = word.isdigit()
    ordinal = word == "2nd"
    kind = "ordinal" if ordinal else "number" if number else "word" if word[0].isalnum() else "mark"
    return Token(kind, word, start, end, 2 if ordinal else int(word) if number else None)
