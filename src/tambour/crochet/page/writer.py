"""Writer: a pattern, as worked, in the words of one language: its rounds, its abbreviations, its own stitches."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from functools import cached_property
from pathlib import PurePath
from typing import Final

from tambour.color import families, family
from tambour.core.errors import Span, TambourError
from tambour.core.graph import TIP
from tambour.core.rgb import RGB, hexed
from tambour.crochet.graph.built import Built, Done
from tambour.crochet.language.finishes import Embroidery, Hair, Placed, Spot
from tambour.crochet.language.stitches import RULES, STITCHES, STUFFING, Stitch
from tambour.crochet.language.tree import Action, Section
from tambour.crochet.page.cleaned import titled
from tambour.crochet.page.legs import legs
from tambour.crochet.page.plain import fills, reach
from tambour.crochet.page.rounds import Rounds, all_of, hues_of, sentence
from tambour.crochet.page.wording import PartText, Row, Words
from tambour.crochet.page.written import Written, sections
from tambour.crochet.printed.yarns.colors import yarns_named
from tambour.crochet.printed.yarns.shades import spoken
from tambour.crochet.words.phrases import Phrases
from tambour.crochet.words.special import told
from tambour.crochet.words.table import Terms

_LETTERS: Final = "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
_TERMS_SAID: Final = re.compile(r"\s*\((?:US|UK|American|British)\b[^)]*\)", re.IGNORECASE)
_AT_END: Final = re.compile(
    r"(\d+) [a-z ]{1,20} (?:at|after) (?:the )?end of [\w ]*(?:rnd|round|row)s?\.?", re.IGNORECASE
)
"""A count of several rounds: "24 sc at end of 3rd rnd"."""
_CLOSED: Final = 8
"""A part whose last rounds have so few stitches is closed by them."""
_EDGED: Final = " edging"
_HEADS_ROUND: Final = re.compile(
    r"(?:rounds?|rnds?|rows?|r)\b\.?\s*\d|\d+(?:st|nd|rd|th)?\s+(?:rounds?|rnds?|rows?)\b", re.IGNORECASE
)
_SHORT_HEAD: Final = re.compile(r"[A-ZÀ-Þ][^\W\d]*(?:[ /&'’-]+[^\W\d]+){0,5}")
"""A heading: a few words, no number, no point."""
_STATED: Final = {"yarn": "yarn", "hook": "hook", "eyes": "eyes"}


def _sews(line: Written) -> bool:
    return not line.makes and all(d.what == "sew" for unit, _ in line.pieces for d in unit)


def _takes_color(written: list[Written]) -> bool:
    """Whether a part says the colour that it begins with."""
    for done in (d for line in written for unit, _ in line.pieces for d in unit):
        if done.what == "color":
            return True
        if done.what not in RULES or done.what in ("mr", "oval", "fsc"):
            return False
    return True  # it makes nothing


def _lettered(text: str) -> dict[RGB, str]:
    """The letters that a designer's list gives her yarns, by their colours."""
    found = ((hue, re.search(r"\((\w{1,3})\)$", name)) for hue, name in yarns_named(text).items())
    return {hue: letter[1] for hue, letter in found if letter is not None}


def _hers_first(hues: Mapping[str, RGB], text: str) -> dict[str, RGB]:
    """The words for colours with those that the text has before the others: what she calls skin is not flesh here."""
    low = text.lower()
    hers = sorted((w for w in hues if re.search(rf"\b{re.escape(w.lower())}\b", low)), key=len, reverse=True)
    return {w: hues[w] for w in dict.fromkeys([*hers, *hues])}


class Writer:
    """Writes one pattern in one language."""

    def __init__(self, built: Built, terms: Terms, exact: bool) -> None:
        self.exact = exact
        self.built, self.terms, self.pattern = built, terms, built.pattern
        self.sections = list(sections(built, inside=not exact))
        copies = {s.name: s.copies for s in self.pattern.parts if s.name}
        self.hues = {} if exact else _hers_first(spoken(terms.code), self.pattern.text.text)
        self.phrases = Phrases(terms, copies, self._legend(), self.hues)
        self.own = {n for n in self.pattern.own if n in self.pattern.stitches}
        self.rounds = Rounds(self.pattern, self.phrases, terms, self.own, exact)
        self.begins = self._begins()

    def _begins(self) -> list[tuple[int, ...] | None]:
        """The colour that every copy of a part begins with, for each part of the text; None where it is not one, or undyed."""
        found: list[set[tuple[int, ...] | None]] = [set() for _ in self.pattern.parts]
        color: tuple[int, ...] | None = None
        for done in self.built.log:
            if done.what == "color":
                color = done.numbers
            elif done.what == "part":
                found[done.numbers[0]].add(color)
        return [next(iter(hues)) if len(hues) == 1 else None for hues in found]

    def _legend(self) -> dict[str, RGB]:
        """The yarn's colours that have no plain name, by letter, in the order in which they are taken up."""
        plain = Phrases(self.terms, {}, {}, self.hues)
        hues: dict[tuple[int, ...], None] = {}
        for done in self.built.log:
            if done.what == "color":
                hues[done.numbers] = None
        for record in self.pattern.finish:
            if (
                isinstance(record, (Embroidery, Hair))
                and record.color != type(record).__dataclass_fields__["color"].default
            ):
                hues[record.color] = None
        hers = {hue: letter for letter, hue in reversed(list(self.pattern.letters.items()))}
        letters = {} if self.exact else hers | _lettered(self.pattern.text.text)
        free = (x for n in range(len(hues) + 1) for x in (f"{c}{n + 1 if n else ''}" for c in _LETTERS))
        made: dict[str, RGB] = {}
        for hue in hues:
            red, green, blue = hue
            if plain.shade(hue).startswith("#"):
                own = letters.get((red, green, blue), "")
                letter = own if own and own not in made else next(x for x in free if x not in letters.values())
                made[letter] = (red, green, blue)
        return made

    @cached_property
    def _hung(self) -> list[Placed]:
        """What hangs from the loops of a round, where people are written for."""
        return [] if self.exact else [r for r in self.pattern.finish if isinstance(r, Placed) and r.around]

    def words(self) -> Words:
        """All of it."""
        seams: list[str] = []
        parts = []
        for k, (section, part, written) in enumerate(self.sections):
            if section.twin and not self.exact:
                continue  # the rounds of another colour are the same
            while k == len(self.sections) - 1 and written and _sews(written[-1]):
                seams[:0] = [row.words for row in self.rounds.alone(written.pop(), True)]
            index = self.built.parts[part].section
            split = None if self.exact else legs(self.pattern, section, written)
            if split is None:
                parts.append(self._section(section, part, index, written, self.begins[index]))
                continue
            head, body, at = split
            for (name, copies), lines, span in ((head[:2], head[2], (0, at)), (body[:2], body[2], (at, 1 << 60))):
                made = self._section(section, part, index, lines, self.begins[index] if copies > 1 else None)
                many = self.phrases.say("copies", count=copies) if copies > 1 else ""
                parts.append(replace(made, name=name, copies=many, span=span, part=part if copies == 1 else -1))
        if not self.exact:
            from tambour.crochet.page.placed import Spoken

            after = [r for r in self.pattern.finish if not (isinstance(r, Placed) and r.through)]
            finish = Spoken(self.built, self.terms)(after)
        else:
            finish = [sentence(self.phrases.finish(record)) for record in self.pattern.finish]
        special = self._special()
        materials = [f"{self.terms.word(key)}: {said}" for key in _STATED if (said := self._stated(key))]
        hues = list(self.phrases.legend.values())
        names = [family(h) for h in hues] if self.exact else families(hues)
        colors = [
            (x, self.terms.colors[name][0], h, self._legend_line(x, name, h))
            for (x, h), name in zip(self.phrases.legend.items(), names)
        ]
        return Words(
            self.terms,
            self.terms.sentences["terms"],
            self._title(),
            tuple(materials),
            tuple(colors),
            self._stated("gauge"),
            self._stated("size"),
            self._abbreviations(),
            tuple((said, meaning) for said, _, meaning in (line.partition(" = ") for line in special)),
            tuple(parts),
            tuple(seams),
            tuple(finish),
            self.hues,
        )

    # -- before the parts -------------------------------------------------------------------------------------------

    def _stated(self, key: str) -> str:
        return " ".join(self.pattern.stated[key][0].split()) if key in self.pattern.stated else ""

    def _title(self) -> str:
        title = titled(self.pattern.stated.get("title", ("",))[0]) or PurePath(self.pattern.text.name).stem.replace(
            "_", " "
        )
        title = _TERMS_SAID.sub("", title)
        return "" if title.strip("<> ") in ("", "text", "stdin") else title[:1].upper() + title[1:]

    def _legend_line(self, letter: str, name: str, hue: RGB) -> str:
        said = self.phrases.say("legend", letter=letter, name=self.terms.colors[name][0], hex=hexed(hue))
        return sentence(said, "")

    def _abbreviations(self) -> tuple[tuple[str, str], ...]:
        meaning, word = self.terms.meaning, self.terms.word
        listed = []
        order = ("round", "row", "front loops", "back loops", *STITCHES)
        for key in sorted(self.rounds.used, key=order.index):
            said = word(key)
            if key in meaning and said.lower() != meaning[key].lower():
                listed.append((said, meaning[key]))
        return tuple(listed)

    def _special(self) -> tuple[str, ...]:
        """The pattern's own stitches that are used, and what each is made of."""
        made = {d.what for d in self.built.log}
        made |= {n for what in made if what in self.pattern.stitches for n, _ in self.pattern.stitches[what].inner}
        needed = made & self.own
        lines: list[str] = []
        known: dict[str, Stitch] = {}
        order = [name for name in self.pattern.own if name in self.own]
        said: dict[str, tuple[str, list[str]]] = {}
        for name in order:
            stitch = self.pattern.stitches[name]
            line = told(stitch, known, self.terms)
            if line is not None:
                said[name] = line
                known[name] = stitch
        for name in reversed(order):
            if name in needed and name in said:
                needed |= {n for n in said[name][1] if n in self.own}
        for name in order:
            if name in needed and name not in said:
                hint = "name it with moves and stitches only"
                raise TambourError(f'the stitch "{name}" cannot be explained', hint=hint, where="{--terms}")
            if name in needed and any(
                self.terms.word(key).lower() == name for key in self.rounds.used if key in STITCHES
            ):
                hint = f"give it another name; {self.terms.name} use this one"
                raise TambourError(f'the stitch "{name}" means two things', hint=hint, where="{--terms}")
            if name in needed:
                lines.append(said[name][0])
                self.rounds.used.update(dict.fromkeys(n for n in said[name][1] if n not in self.own))
        return tuple(lines)

    # -- parts ------------------------------------------------------------------------------------------------------

    def _section(
        self, section: Section, part: int, index: int, written: list[Written], color: tuple[int, ...] | None
    ) -> PartText:
        lines: list[Row] = []
        if section.up is not None:
            lines.append(Row("", sentence(self.phrases.say(f"up {section.up}"))))
        if section.stands is not None:
            top, front = (Spot(section.name, *at) for at in section.stands)
            lines.append(Row("", sentence(self.phrases.say("stands", spot=top, far=front))))
        settings = [
            f"@{key} = {value}"
            for key, value in (
                ("centroids", section.centroids),
                ("initializer", section.initializer),
                ("hollow", section.hollow and "{}-{}".format(*section.hollow)),
            )
            if value is not None
        ]
        g = self.built.graph
        here = g.parts[part]
        closing = bool((g.peculiarity[here.start : here.end] == TIP).any())
        stuffing = self._stuffing(section, part)
        worked = {d.what for line in written for unit, _ in line.pieces for d in unit}
        kind = "row" if "turn" in worked and not worked & {"mr", "join", "oval"} else "round"
        self.rounds.begun = False
        if color is not None and not _takes_color(written):
            done = Done("color", 1, color)
            lines.append(Row("", sentence(self.rounds.done(done, closing)), colors=hues_of([done])))
        closes = closing or (bool(written) and 0 < min(line.count or 99 for line in written[-2:]) <= _CLOSED)
        reached = reach([(line.count, line.makes) for line in written]) if closes and not self.exact else -1
        hung = next((r for r in self._hung if r.part == section.name), None)
        if hung is not None:  # the chain that it stands on is that round's loops
            at = next(k for k, line in enumerate(written) if any(d.what == "ch" for d in all_of(line)))
            lines += [row for line in written[:at] for row in self.rounds.alone(line, closing)]
            onto = hung.spot.part.replace(".", " ")
            join = self.terms.page["hung on"].format(n=f"{hung.spot.round:g}", part=onto)
            lines, written = [*lines, Row("", sentence(join))], written[at + 1 :]
        for k, line in enumerate(written):
            if not self.exact and self.rounds.closes(line):
                said = [Row("", sentence(self.rounds.items(line, closing)))]
            else:
                said = (
                    self.rounds.alone(line, closing) if not line.number else [self.rounds.numbered(line, kind, closing)]
                )
            said = [replace(row, span=line.line.span) for row in said] if line.line is not None else said
            if stuffing and any(d.what == "fo" for unit, _ in line.pieces for d in unit):
                lines, stuffing = [*lines, *(Row("", words) for words in stuffing)], []
            if stuffing and k == reached:
                lines, stuffing = [*lines, *said, *(Row("", words) for words in stuffing)], []
                said = []
            place = line.line.span if line.line is not None else None
            lines += [*said, *(Row("", f"*{note}*", span=place) for note in self._notes(line))]
        name = self._heading(section.name, section.span) if section.name else self.terms.word("instructions")
        copies = self.phrases.say("copies", count=section.copies) if section.copies > 1 else ""
        if section.heading and not self.exact:
            name, copies = self._heading(section.heading, section.span), self._hued(index)
            lines = lines[1:]  # every copy begins with its own colour
        return PartText(name, copies, (*lines, *(Row("", words) for words in stuffing)), tuple(settings), part, index)

    def _notes(self, line: Written) -> list[str]:
        """What is noted with a round, for people in sentences: one for each note, or a clause of the one before it."""
        notes = [" ".join(note.split()).strip("*") for note in line.notes]
        if self.exact or not notes:
            return notes
        made = ""
        for note in notes:
            if (counted := _AT_END.fullmatch(note)) is not None and int(counted[1]) == line.count:
                continue  # it stands in brackets behind the round
            goes_on = made and note[:1].islower()
            made += f", {note}" if goes_on else f"{'. ' if made else ''}{note[:1].upper()}{note[1:]}"
        return [made if made.endswith((".", "!", "?", ")")) else f"{made}."] if made else []

    def _hued(self, index: int) -> str:
        """How many copies of a part are made in which colours."""
        parts = self.pattern.parts
        end = next((k for k in range(index + 1, len(parts)) if not parts[k].twin), len(parts))
        listed, total = [], sum(p.copies for p in parts[index:end])
        for p in parts[index:end]:
            hue = next(i.numbers for i in p.lines[0].items if isinstance(i, Action))
            listed.append(f"{p.copies} {self.phrases.shade(hue)}")
        return self.phrases.say("copies", count=total).replace(")", f": {', '.join(listed)})")

    def _heading(self, name: str, span: Span) -> str:
        """A part's name, as she heads it; with the word for a part before it, where it could be taken for another heading."""
        if not self.exact:  # "Head & Body" is called Head Body by those that look for it
            name = re.sub(r"^part_(?=\d+[a-z])", "", name)
            name = re.sub(r"_(?=\d+(?:st|nd|rd|th)\b)", " ", name)  # "2nd to 8th Tentacles"
            called = [
                w for w in re.sub(r"_\d+$", "", name).split() if w.lower() != "and"
            ]  # the third of three bodies is a Body
            ordinal = re.search(r"_(\d+)$", name)
            words = r"\s*(?:&|\+|/|-|'|’|and|\s)\s*".join(map(re.escape, called))
            if ordinal is not None:  # "Strip 1" and "Strip 2", but the third of three bodies is a Body
                words += rf"(?:\s*#?{ordinal[1]}\b)?"
            hers = re.search(words, self.pattern.text.text[span.start : span.end], re.IGNORECASE)
            name = hers[0] if hers is not None else name
            number = re.fullmatch(r"part_(\d+)", name)
            name = f"{self.terms.word('part').capitalize()} {number[1]}" if number is not None else name
            name = self._over(name, span) or name
        taken = {s.lower() for spellings in self.terms.words.values() for s in spellings}
        part = self.terms.word("part")
        if self.exact and (name.lower() in taken or name.lower().startswith(part.lower())):
            return f"{part}: {name}"
        return name

    def _over(self, name: str, span: Span) -> str:
        """What she heads a part with whose name is ours: an edging, a part with a number; "" where she heads it with nothing short."""
        text = self.pattern.text.text
        own = " ".join(text[span.start : span.end].split())
        if name.endswith(_EDGED):
            found = own
        elif name == f"{self.terms.word('part').capitalize()} {name.rpartition(' ')[2]}" and _HEADS_ROUND.match(own):
            found = text[: span.start].rstrip().rpartition("\n")[2].strip(" *_#:=~")
        else:
            return ""
        return found if _SHORT_HEAD.fullmatch(found) and _EDGED.strip() not in found.lower() else ""

    def _stuffing(self, section: Section, part: int) -> list[str]:
        if section.stuffing is None and not self.exact and fills(self.built, part):
            return [sentence(self.phrases.say("stuff medium"))]
        if section.stuffing is None or (section.guessed and not self.exact):
            return []
        amount = next((w for w, factor in STUFFING.items() if factor == section.stuffing), None)
        if amount is not None:
            return [sentence(self.phrases.say(f"stuff {amount}"))]
        return [sentence(self.phrases.say("stuff factor", factor=section.stuffing))]
