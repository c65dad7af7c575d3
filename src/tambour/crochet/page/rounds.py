"""Rounds: each line of the hook's work in the words of one language: its stitches, its brackets, its count."""

from __future__ import annotations

import re
from collections.abc import Collection
from dataclasses import replace
from typing import Final

from tambour.core.rgb import RGB
from tambour.crochet.graph.built import Done
from tambour.crochet.language.stitches import EDGES, RULES
from tambour.crochet.language.tree import Pattern
from tambour.crochet.page.doubted import her_words
from tambour.crochet.page.wording import Row
from tambour.crochet.page.written import Written
from tambour.crochet.words.phrases import Phrases
from tambour.crochet.words.table import Terms

_PLACES: Final = {"": "stitch", "sp": "space", "ring": "ring", "curl": "curl"}
_INTO_ONE: Final = re.compile(r"(\w*?)inc(\d*)")
_HEADED: Final = re.compile(r"^\W*(?:rounds?|rnds?|rd|r)?\.?\s*\d+\W*\s", re.IGNORECASE)
_NUMBERED: Final = re.compile(r"\b(?:rounds?|rnds?|rows?|rd|r)\.?\s*\d+[^.]*$|^\s*\d+\s*[.:)][^.]*$", re.IGNORECASE)
_COUNTED: Final = re.compile(r"\s*[-–=]*\s*[(\[{]\d+(?:\s*\w+)?[)\]}]\W*$")


def sentence(said: str, end: str = ".") -> str:
    """What is said, as a sentence."""
    return said[:1].upper() + said[1:] + end


def all_of(line: Written) -> list[Done]:
    """Each thing done in a line."""
    return [done for unit, _ in line.pieces for done in unit]


def hues_of(done: list[Done]) -> tuple[RGB, ...]:
    """The colours that things done change to."""
    return tuple(dict.fromkeys((d.numbers[0], d.numbers[1], d.numbers[2]) for d in done if d.what == "color"))


class Rounds:
    """Writes lines of the hook's work.

    own : names of the pattern's own stitches; exact : by the letter, so that it reads again as it was
    used : what of it a list of abbreviations explains; begun : the part under way has its first stitches
    """

    def __init__(self, pattern: Pattern, phrases: Phrases, terms: Terms, own: Collection[str], exact: bool) -> None:
        self.pattern, self.phrases, self.terms, self.own, self.exact = pattern, phrases, terms, own, exact
        self.used: dict[str, None] = {}
        self.begun = False

    def alone(self, line: Written, closing: bool) -> list[Row]:
        """Lines outside rounds: a sentence each, but stitches in a row stay together."""
        if line.makes:
            return [Row("", sentence(self.items(line, closing)), colors=hues_of(all_of(line)))]
        alone = [d for unit, times in line.pieces for _ in range(times) for d in unit if not self._inner(d)]
        return [Row("", sentence(self.done(d, closing)), colors=hues_of([d])) for d in alone]

    def numbered(self, line: Written, kind: str, closing: bool) -> Row:
        """A line that is a round, or several equal ones."""
        self.used[kind] = None
        word = self.terms.word(kind)
        first, last = line.number, line.number + line.times - 1
        number = f"{first}" if line.times == 1 else f"{first}-{last}"
        head = word + number if len(word) == 1 else f"{word} {number}"
        words, count, doubt = self.items(line, closing), line.count, ""
        if kind == "row" and not self.exact and line.pieces[-1][0][0].what == "again":
            words = re.sub(rf"\b{re.escape(self.terms.word('round'))}\b", word, words)
        if line.said and not self.exact:  # her count stays hers, with the doubt beside it where there is one
            doubt, count = f"[{self.terms.page['makes'].format(n=line.wrong)}]" if line.wrong else "", line.said
        return Row(head, words, count, last, hues_of(all_of(line)), times=line.times, doubt=doubt)

    def items(self, line: Written, closing: bool) -> str:
        """The stitches of a line, brackets found."""
        if not self.exact and (hers := self._joining(line) or self._hers(line)):
            return hers
        first = line.pieces[0][0][0] if line.pieces else None
        if not self.exact and len(line.pieces) > 1 and first is not None and first.what == "fold" and not first.labels:
            rest = replace(line, pieces=line.pieces[1:] if len(line.pieces[0][0]) == 1 else line.pieces)
            return f"{self.items(rest, closing)} {self.phrases.say('fold')}"  # as people say it
        said = []
        last = line.pieces[-1][0][-1] if line.pieces else None
        idle = (
            last if not self.exact and last is not None and last.what == "bl" else None
        )  # the next line begins in both
        for unit, times in line.pieces:
            unit = tuple(d for d in unit if d is not idle and not self._inner(d))
            if not unit:
                continue
            words = ", ".join(self.done(d, closing) for d in unit)
            said.append(words if times == 1 else self.phrases.say("group", items=words, count=times))
        return ", ".join(said)

    def _inner(self, done: Done) -> bool:
        """Whether a mark is of the reading alone, and none that a maker puts."""
        if self.exact or done.what != "mark" or self.terms.code != self.pattern.terms:
            return False  # in another language rounds that join are told by their marks
        return done.labels[0].lower() not in self.pattern.text.text.lower()

    def done(self, done: Done, closing: bool) -> str:
        """One thing done; of ``closing`` parts, the end is gathered."""
        say = self.phrases.say
        self.begun = self.begun or done.what not in RULES or done.what in ("mr", "oval", "fsc")
        match done.what:
            case "mr":
                self.used["sc"] = None
                return say("ring", count=done.numbers[0])
            case "color":
                return say("color" if self.begun else "use color", color=done.numbers)
            case "bl":
                return say("both loops")
            case "flo" | "blo":
                key = "front loops" if done.what == "flo" else "back loops"
                self.used[key] = None
                return say(key)
            case "mark" | "goto":
                return say(done.what, label=done.labels[0])
            case "attach":
                size = done.numbers[0]
                if size > 0:
                    self.used["ch"] = None
                    return say("attach chain", label=done.labels[0], count=size)
                return say("attach merge" if size < 0 else "attach over", label=done.labels[0])
            case "sew":
                return say("sew", one=done.labels[0], other=done.labels[1])
            case "fo":
                return say("close" if closing else "fasten off")
            case "turn" | "join":
                return say(done.what)
            case "gap":
                return say("gap", count=done.numbers[0])
            case "again":
                first, last = done.numbers
                return say("again", first=first, last=None if first == last else last, part=done.labels[0] or None)
            case "oval":
                self.used["ch"] = None
                return say("oval", count=done.numbers[0], next=done.numbers[1])
            case "tospace":
                return say("to space half" if done.numbers[0] else "to space")
            case "edge":
                places, which = done.numbers
                return say(f"edge {EDGES[which]}", count=places or None)
            case "fsc":
                self.used["sc"] = None
                return say("foundation", count=done.numbers[0])
            case "fold":
                return say("fold to", label=done.labels[0]) if done.labels else say("fold")
        assert done.what not in RULES, done.what
        return self._stitch(done)

    def closes(self, line: Written) -> bool:
        """Whether a line closes an end, and is no round in her words."""
        fold = next((d.span for d in all_of(line) if d.what == "fold" and d.span is not None), None)
        if fold is None or not self.pattern.terms:
            return False
        text = self.pattern.text.text
        return _NUMBERED.search(text[text.rfind("\n", 0, fold.start) + 1 : fold.start]) is None

    def _joining(self, line: Written) -> str:
        """Her own words of a round that joins two pieces, which markers tell badly; "" where it is none, or in another language."""
        done = next((d for unit, _ in line.pieces for d in unit if d.what == "attach" and d.span is not None), None)
        if done is None or done.span is None or self.terms.code != self.pattern.terms:
            return ""
        words = " ".join(self.pattern.text.text[done.span.start : done.span.end].split())
        found = _HEADED.match(words)
        return _COUNTED.sub("", words[found.end() :] if found else words).strip()

    def _hers(self, line: Written) -> str:
        """Her own words of a round that was not understood as she says it; "" where it was, or in another language."""
        if not line.hers or line.line is None or self.terms.code != self.pattern.terms:
            return ""
        return her_words(self.pattern, line.line, self.terms, line.said or line.count)

    def _stitch(self, done: Done) -> str:
        if done.labels:  # the part that it goes through as well
            items = self._stitch(replace(done, labels=()))
            return self.terms.page["worked in"].format(items=items, part=done.labels[0])
        stitch = self.pattern.stitches[done.what]
        if stitch.inner:
            into = stitch.inner
            found = (
                _INTO_ONE.fullmatch(into[0][0])
                if stitch.where == "ring" and len(into) == 1 and not self.exact
                else None
            )
            if found is not None:  # a ring is one place, but nobody calls its stitches an increase
                into = ((found[1] or "sc", int(found[2] or 2) * into[0][1]),)
                if into[0][0] == "sc" and done.times == 1:
                    return self.done(Done("mr", 1, (into[0][1],)), False)
            inner = ", ".join(self._stitch(Done(name, times)) for name, times in into)
            said = self.phrases.say(f"one {_PLACES[stitch.where]}", items=inner)
            return said if done.times == 1 else self.phrases.say("group", items=said, count=done.times)
        if done.what in self.own:
            word = done.what
        else:
            self.used[done.what] = None
            word = self.terms.word(done.what)
        return word if done.times == 1 else self.phrases.say("several", count=done.times, item=word)
