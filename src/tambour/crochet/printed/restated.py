"""Restated: a pattern as :mod:`tambour.crochet.page.instructions` prints it, read back by the letter."""

from __future__ import annotations

import re
from dataclasses import dataclass, field, replace
from functools import lru_cache
from typing import Final

from tambour.core.errors import Span, TambourError, Text
from tambour.core.rgb import RGB
from tambour.crochet.language.finishes import Finish
from tambour.crochet.language.items import MOST_IN_CURL, MOST_IN_ONE
from tambour.crochet.language.source import Source
from tambour.crochet.language.stitches import STARTS, STITCHES, STUFFING, UPS, Place, Stitch, into_one
from tambour.crochet.language.tree import Action, Again, Group, Item, Line, Pattern, Section, written
from tambour.crochet.words.phrases import Phrases, stood
from tambour.crochet.words.special import heard
from tambour.crochet.words.table import TERMS, Terms

_COUNT: Final = re.compile(r"\s*\((\d{1,9})\)$")
_SETTING: Final = re.compile(r"@(centroids|initializer|hollow) = ([\w-]+)$")
_NOTE: Final = re.compile(r"\*[^*].*[^*]\*$")
_STATED: Final = re.compile(r"\*\*(.+?):\*\* (.+)$")
_ANEW: Final = ("mr", "goto", "oval", "fsc")
"""Actions with which other work begins, that has numbers of its own."""
_DEEPEST: Final = 24
_CLOSES: Final = "(["
_PLACES: Final[dict[str, Place]] = {"one stitch": "", "one space": "sp", "one ring": "ring", "one curl": "curl"}


class _Unknown(Exception):
    """Something that the printer does not print."""


def restated(text: Text, *, max_stitches: int = 200_000, strict: bool = False) -> Pattern | None:
    """The pattern of a text that is as Tambour prints it, whole; None for any other text.

    Numbers of rounds that do not follow are doubts, and TambourError when ``strict``.
    """
    terms = printed_in(text.text)
    if terms is None:
        return None
    try:
        return _Reader(text, terms, strict).read(max_stitches)
    except _Unknown:
        return None


def printed_in(text: str) -> Terms | None:
    """The terms that a text's heading over its abbreviations names, as it is printed."""
    for terms in TERMS.values() if "## " in text else ():
        if terms.prints(text):
            return terms
    return None


def lettered(text: str, terms: Terms) -> dict[str, RGB]:
    """The colours that a list of materials as it is printed gives letters."""
    plain, made = Phrases(terms, {}, {}), {}
    for line in text.split("\n"):
        if "#" in line and (found := plain.read(line.strip().lstrip("-•* "), ("legend",))):
            made[found[1]["letter"]] = found[1]["hex"]
    return made


@lru_cache(maxsize=16)
def _spelt(code: str) -> dict[str, str]:
    """Spelling → stitch, of a table."""
    return {s.lower(): n for n, spellings in TERMS[code].stitches.items() if n in STITCHES for s in spellings}


@dataclass
class _Draft:
    section: Section
    lines: list[Line] = field(default_factory=list)
    closes: bool = False  # its end is drawn together
    ends: bool = False  # its yarn only ends


class _Reader:
    """Reads one text in one language."""

    def __init__(self, text: Text, terms: Terms, strict: bool) -> None:
        self.text, self.terms = text, terms
        self.source = Source(text, strict)  # for doubts
        self.drafts: list[_Draft] = []
        self.stitches: dict[str, Stitch] = dict(STITCHES)
        self.own: dict[str, Span] = {}
        self.stated: dict[str, tuple[str, Span]] = {}
        self.finish: list[Finish] = []
        self.marks: set[str] = set()
        self.phrases = Phrases(terms, *self._known())
        self.headings = {
            terms.word(key): key
            for key in ("materials", "abbreviations", "special stitches", "instructions", "assembly")
        }
        rounds = "|".join(re.escape(terms.word(key)) for key in ("round", "row"))
        self.round = re.compile(rf"(?:{rounds}) ?(\d{{1,6}})(?:-(\d{{1,6}}))?: ?")

    def _known(self) -> tuple[dict[str, int], dict[str, RGB]]:
        """Parts and the colours' letters, which sentences before them may name."""
        plain = Phrases(self.terms, {}, {})
        copies: dict[str, int] = {}
        for line in self.text.text.split("\n"):
            if line.startswith("## "):
                name, times, _ = self._heading(line[3:].strip(), plain)
                copies[name] = times
        return copies, lettered(self.text.text, self.terms)

    def _heading(self, words: str, phrases: Phrases) -> tuple[str, int, bool]:
        """The name and the copies of a part, and whether the word for a part stands before it."""
        times, mark = 1, words.rfind("(")
        if mark > 0:
            found = phrases.read(words[mark:], ("copies",))
            if found:
                words, times = words[:mark].strip(), found[1]["count"]
        part = f"{self.terms.word('part')}: "
        return words.removeprefix(part), times, words.startswith(part)

    def read(self, max_stitches: int) -> Pattern:
        """The pattern; _Unknown where something is not as it is printed."""
        offset, block = 0, "front"
        for whole in self.text.text.split("\n"):
            line = whole.strip()
            start = offset + len(whole) - len(whole.lstrip())
            offset += len(whole) + 1
            if line:
                block = self._line(line, start, block)
        if not self.drafts:
            raise _Unknown
        if any(not p.warning for p in self.source.problems):
            raise TambourError(self.source.problems)
        return Pattern(
            self.text,
            tuple(replace(d.section, lines=tuple(d.lines), tip_from_fo=d.closes or not d.ends) for d in self.drafts),
            self.stitches,
            self.own,
            tuple(self.source.problems),
            max_stitches,
            tuple(self.finish),
            self.terms.code,
            self.stated,
        )

    def _line(self, line: str, start: int, block: str) -> str:
        """Reads one line; gives the block that the next one is in."""
        span = Span(start, start + len(line))
        if line.startswith("# ") and block == "front" and not self.stated:
            self.stated["title"] = (line[2:], span)
            return block
        if line.startswith("## "):
            return self._block(line[3:], span)
        bullet = line.startswith("- ")
        said, at = (line[2:], start + 2) if bullet else (line, start)
        if block == "part":
            self._part(line, span)
        elif block == "assembly" and bullet:
            self._assembly(said, Span(at, span.end))
        elif block == "special stitches" and bullet:
            stitch = heard(said, self.stitches, self.terms)
            if stitch is None:
                raise _Unknown
            self.stitches[stitch.name] = stitch
            self.own[stitch.name] = Span(at, span.end)
        elif block == "materials" and bullet:
            self._material(said, Span(at, span.end))
        elif found := _STATED.match(line):
            key = {self.terms.word("gauge"): "gauge", self.terms.word("finished size"): "size"}.get(found[1])
            if key is None:
                raise _Unknown
            self.stated[key] = (found[2], span)
        elif block != "abbreviations" or not bullet or " = " not in said:
            raise _Unknown
        return block

    def _block(self, words: str, span: Span) -> str:
        self.source.last_number = None
        for heading, key in self.headings.items():
            if words == heading or (key == "abbreviations" and words.startswith(heading + " (")):
                if key != "instructions":
                    return key
                self.drafts.append(_Draft(Section("", span, ())))
                return "part"
        name, copies, _ = self._heading(words, self.phrases)
        self.drafts.append(_Draft(Section(name, span, (), copies, span if copies > 1 else None)))
        return "part"

    def _material(self, said: str, span: Span) -> None:
        if self.phrases.read(said, ("legend",)):
            return
        head, _, words = said.partition(": ")
        key = next((k for k in ("yarn", "hook", "eyes") if head == self.terms.word(k)), None)
        if head == self.terms.page["stuffing"]:
            return  # it is reckoned anew
        if key is None:
            raise _Unknown
        self.stated[key] = (words, span)

    # -- parts ------------------------------------------------------------------------------------------------------

    def _part(self, line: str, span: Span) -> None:
        draft = self.drafts[-1]
        if found := _SETTING.match(line):
            if found[1] == "centroids" and found[2].isdigit():
                draft.section = replace(draft.section, centroids=int(found[2]))
            elif found[1] == "hollow" and (pair := re.fullmatch(r"(\d{1,6})-(\d{1,6})", found[2])):
                draft.section = replace(draft.section, hollow=(int(pair[1]), int(pair[2])), hollow_span=span)
            elif found[2] in STARTS:
                draft.section = replace(draft.section, initializer=STARTS[found[2]])
            else:
                raise _Unknown
            return
        about = self.phrases.read(
            line, (*(f"up {end}" for end in UPS), "stands", *(f"stuff {a}" for a in (*STUFFING, "factor")))
        )
        if about:
            what, _, amount = about[0].partition(" ")
            if what == "stands":
                draft.section = replace(draft.section, stands=stood(about[1]), stands_span=span)
            elif what == "up":
                draft.section = replace(draft.section, up=amount)
            else:
                factor = about[1]["factor"] if amount == "factor" else STUFFING[amount]
                draft.section = replace(draft.section, stuffing=factor)
            return
        if _NOTE.match(line) and draft.lines:
            note = Span(span.start + 1, span.end - 1)
            draft.lines[-1] = replace(draft.lines[-1], notes=(*draft.lines[-1].notes, note))
            return
        head = self.round.match(line)
        at, end = (head.end() if head else 0), len(line)
        if head is None:
            alone = self._action(line, span)
            if alone is not None:
                if alone.name in _ANEW:
                    self.source.last_number = None
                draft.lines.append(Line((alone,), span, False))
                return
        stated, stated_span = None, None
        if head is None:
            end -= line.endswith(".")
        elif counted := _COUNT.search(line):
            stated = int(counted[1])
            stated_span = Span(span.start + counted.start(1), span.start + counted.end(1))
            end = counted.start()
        again, whole = None, end
        if head is not None:
            begin = max(line.rfind(",", at, end) + 1, at)
            again = self._again(line[begin:end], Span(span.start + begin, span.start + end))
            whole = max(begin - 1, at) if again is not None else end
        items = self._items(line[at:whole], span.start + at, 0) if whole > at else []
        times, number, times_span = 1, None, None
        if head is not None:
            number = int(head[1])
            times_span = Span(span.start + head.start(1), span.start + head.end(2 if head[2] else 1))
            times = int(head[2]) - number + 1 if head[2] else 1
            if times < 1 or (head[2] and times < 2):
                raise _Unknown
            self._follows(number, number + times - 1, times_span)
        elif any(isinstance(i, Action) and i.name in _ANEW for i in items):
            self.source.last_number = None
        draft.lines.append(Line(tuple(items), span, True, times, times_span, number, stated, stated_span, again))

    def _again(self, words: str, span: Span) -> Again | None:
        """Rounds that are written elsewhere; None where the words name none."""
        found = self.phrases.read(words, ("again",))
        if found is None:
            return None
        fields = found[1]
        first, part = fields["first"], fields.get("part", "")
        last = fields.get("last", first)
        draft = next((d for d in self.drafts if d.section.name == part), None) if part else self.drafts[-1]
        lines = written(draft.lines, first, last) if draft is not None else ()
        if not lines:
            raise _Unknown
        return Again(lines, first, last, part, span)

    def _follows(self, first: int, last: int, at: Span) -> None:
        """Doubts a number of a round that does not follow the one before."""
        before, self.source.last_number = self.source.last_number, last
        if before is not None and first not in (1, before + 1):
            said = "is there already" if first <= before else "leaves rounds out"
            hint = f"{before + 1} would follow"
            self.source.doubt(f"round {first} {said}: the one before is {before}", hint, at, True)

    def _assembly(self, said: str, span: Span) -> None:
        record = self.phrases.finishing(said, span)
        if record is not None:
            self.finish.append(record)
            return
        seam = self._action(said, span)
        if seam is None or seam.name != "sew" or not self.drafts:
            raise _Unknown
        self.drafts[-1].lines.append(Line((seam,), span, False))

    def _items(self, words: str, start: int, depth: int) -> list[Item]:
        """Items between commas; brackets keep theirs together."""
        if depth > _DEEPEST:
            raise _Unknown
        made: list[Item] = []
        level = begin = 0
        for k, sign in enumerate([*words, ","]):
            level += (sign in "([") - (sign in ")]")
            if sign == "," and level == 0:
                piece = words[begin:k]
                made.append(self._item(piece.strip(), start + begin + len(piece) - len(piece.lstrip()), depth))
                begin = k + 1
        if level:
            raise _Unknown
        return made

    def _item(self, said: str, start: int, depth: int) -> Item:
        span = Span(start, start + len(said))
        action = self._action(said, span)
        if action is not None:
            return action
        if said[:1] in _CLOSES:
            found = self.phrases.read(said, ("group", *_PLACES))
            if found is None:
                raise _Unknown
            if found[0] != "group":
                return self._together(found[1]["items"], _PLACES[found[0]], span)
            inner, times = found[1]["items"], found[1]["count"]
            number = str(times)
            at = span.start + said.rindex(number)
            if times < 1:
                raise _Unknown
            return Group(tuple(self._items(inner, start + 1, depth + 1)), times, Span(at, at + len(number)))
        return self._stitch(said, span)

    def _together(self, words: str, where: Place, span: Span) -> Action:
        """Stitches worked into one place."""
        inner = [i for i in self._items(words, span.start + 1, _DEEPEST) if isinstance(i, Action)]
        most = MOST_IN_ONE if where != "curl" else MOST_IN_CURL
        if not all(i.name in self.stitches and i.times <= most for i in inner):
            raise _Unknown
        try:
            made = into_one([(self.stitches[i.name], i.times) for i in inner], where)
        except ValueError:
            raise _Unknown from None
        self.stitches.setdefault(made.name, made)
        return Action(made.name, span)

    def _stitch(self, said: str, span: Span) -> Action:
        words = " ".join(said.split())
        name = self._name(words)
        if name is not None:
            return Action(name, span)
        for counted in re.finditer(r"(?<!\d)\d{1,9}(?!\d)", words[:10]):
            if counted.start() == 0:
                name = self._name(words[counted.end() :].strip())
                if name is not None and int(counted[0]) > 0:
                    return Action(name, span, int(counted[0]), Span(span.start, span.start + counted.end()))
        raise _Unknown

    def _name(self, words: str) -> str | None:
        word = words.lower()
        return word if word in self.own else _spelt(self.terms.code).get(word)

    def _action(self, said: str, span: Span) -> Action | None:
        """What is said and is no stitch, by the table's sentences."""
        ends = self.phrases.read(said, ("fasten off",))
        if ends:
            self.drafts[-1].ends = True
            return Action("fo", span)
        found = self.phrases.item(said)
        if found is None:
            return None
        name, numbers, labels = found
        if name == "fo":
            self.drafts[-1].closes = True
        if name == "mark":
            if labels[0] in self.marks:
                raise _Unknown
            self.marks.add(labels[0])
        return Action(name, span, 1, None, numbers, labels)
