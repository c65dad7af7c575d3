"""Phrases: the sentences of a table of terms, filled and read back by one template.

A template is plain words with ``{fields}``; ``[…]`` is said only where its field is not the usual value. ``{flat}`` and
``{front}`` are empty: their bracket alone says them. Reading does not mind case, spaces, or the point at the end.
"""

from __future__ import annotations

import dataclasses
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from decimal import Decimal
from functools import cached_property, lru_cache
from typing import Any, Final

from tambour.core.errors import Span
from tambour.core.rgb import RGB, colored, hexed
from tambour.crochet.language.finishes import SHAPES, Embroidery, Eye, Felt, Finish, Hair, Placed, Spot, Tie
from tambour.crochet.language.stitches import EDGES
from tambour.crochet.words.table import SENTENCES, Terms

ITEMS: Final[dict[str, tuple[str, tuple[int, ...]]]] = {
    "ring": ("mr", ()),
    "color": ("color", ()),
    "use color": ("color", ()),
    "both loops": ("bl", ()),
    "front loops": ("flo", ()),
    "back loops": ("blo", ()),
    "mark": ("mark", ()),
    "goto": ("goto", ()),
    "attach chain": ("attach", ()),
    "attach over": ("attach", (0,)),
    "attach merge": ("attach", (-1,)),
    "turn": ("turn", ()),
    "join": ("join", ()),
    "close": ("fo", ()),
    "sew": ("sew", ()),
    "oval": ("oval", ()),
    "foundation": ("fsc", ()),
    "fold": ("fold", ()),
    "fold to": ("fold", ()),
    "to space": ("tospace", (0,)),
    "to space half": ("tospace", (1,)),
    **{f"edge {which}": ("edge", (k,)) for k, which in enumerate(EDGES)},
    "gap": ("gap", ()),
}
"""Sentence → the action that it says, and the numbers that it implies."""

LEANS: Final = (15, 30, 45, 60, 75)
"""How far a part leans, in degrees, of those that there are words for."""
TURN: Final = 45
"""How far a part is turned about itself has words in steps of so many degrees."""
CLOCK: Final = 15
"""The way that it leans towards has them for half the hours of a clock: eight words, and between these the hour."""
WAYS: Final = ("ways", "ways on top", "ways underneath")
"""Where the eight ways are said: on the sides of a toy, on top of it and underneath; the first of each is up, the clock's 12."""

_NOWHERE: Final = Span(0, 0)
_FINISH: Final = ("place", "place said", "tie", "eye", "embroider", "felt", "hair")
_SILENT: Final = ("flat", "front")
_PLACED: Final = {"onto": "onto", "spot": "spot", "flat": "flat", "lean": "tilt", "way": "towards", "about": "across"}
"""What a person says of a part sewn on → what it is of the record; where it is in words comes to nothing: its spot says it."""
_NUMBER = r"-?\d{1,9}(?:\.\d+)?"
_LABEL = r"[A-Za-z0-9_]+(?:\.\d+)?"
_PIECES = re.compile(r"\{(\w+)\}|\[([^\]]*)\](?!\s*[x*])|([^{\[]+|\[)")


def stood(fields: Mapping[str, Any]) -> tuple[tuple[float, float], tuple[float, float]] | None:
    """What a sentence of how a part stands says of its top and of its front; None where it names no stitches."""
    (top, one), (front, other) = fields["spot"], fields["far"]
    return None if one is None or other is None else ((top, one), (front, other))


@lru_cache(maxsize=512)
def _pieces(template: str) -> tuple[tuple[str, str], ...]:
    """("field", name), ("maybe", inner template) and ("words", text)."""
    made = []
    for field, maybe, words in _PIECES.findall(template):
        made.append(("field", field) if field else ("maybe", maybe) if maybe else ("words", words))
    return tuple(made)


@lru_cache(maxsize=512)
def _fixed(template: str) -> tuple[str, ...]:
    """The words that every sentence of a template has, the longest first."""
    words = [w.lower() for what, text in _pieces(template) if what == "words" for w in text.split()]
    return tuple(sorted(words, key=len, reverse=True))


@lru_cache(maxsize=256)
def _compiled(said: str) -> re.Pattern[str]:
    """An expression; most are the same in every text."""
    return re.compile(said, re.IGNORECASE)


def number(value: float) -> str:
    """A number as it is read back, without an exponent."""
    return str(int(value)) if value == int(value) else format(Decimal(repr(float(value))), "f")


@dataclass(frozen=True)
class Phrases:
    """The sentences of ``terms`` for one pattern.

    copies : the name of every part → how often it is made; empty while the parts are not known: any words then are a name
    legend : letter → the colour that the pattern calls so
    hues : what words for colours mean where people wrote them; empty where they are those of tambour's own language
    shelf : a word → the yarn that the list of a text calls so, which is meant before all; None for no such list
    """

    terms: Terms
    copies: Mapping[str, int]
    legend: Mapping[str, RGB]
    hues: Mapping[str, RGB] = dataclasses.field(default_factory=dict)
    shelf: Callable[[str], RGB | None] | None = None

    # -- names and colours ----------------------------------------------------------------------------------------

    @cached_property
    def _spoken(self) -> dict[str, str]:
        """Part → what it is called: ``Ear.1`` is ``Ear 1`` unless another part has that name."""
        made = {}
        for name, n in self.copies.items():
            made[name] = name
            for k in range(1, n + 1):
                plain = f"{name} {k}"
                made[f"{name}.{k}"] = f"{name}.{k}" if n == 1 or plain in self.copies else plain
        return made

    @cached_property
    def _parts(self) -> dict[str, str]:
        return {said.lower(): name for name, said in self._spoken.items()}

    @cached_property
    def _shades(self) -> dict[RGB, str]:
        made = {hue: self.say("shade", letter=letter) for letter, hue in self.legend.items()}
        for css, spellings in self.terms.colors.items():
            made[self.hues.get(spellings[0].lower()) or colored(css)] = spellings[0]
        for word, hue in self.hues.items():
            made.setdefault(hue, word)
        return made

    def shade(self, color: tuple[int, ...]) -> str:
        """A colour: its name, else its letter in the legend, else ``#rrggbb``."""
        red, green, blue = color
        return self._shades.get((red, green, blue)) or hexed(color)

    def color(self, words: str) -> RGB | None:
        """The colour that ``words`` say; None where they say none."""
        said = " ".join(words.split()).lower()
        if self.shelf is not None and (yarn := self.shelf(said)) is not None:
            return yarn
        for hue, spoken in self._shades.items():
            if said == spoken.lower():
                return hue
        if said in self.hues:
            return self.hues[said]
        for css, spellings in self.terms.colors.items():
            if said in (s.lower() for s in spellings):
                return colored(css)
        try:
            return colored(said)
        except ValueError:
            return None

    # -- saying ---------------------------------------------------------------------------------------------------

    def say(self, key: str, **fields: Any) -> str:
        """The sentence ``key``. A field that is None leaves out the brackets it stands in."""

        def filled(template: str) -> str | None:
            made = []
            for what, words in _pieces(template):
                if what == "maybe":
                    made.append(filled(words) or "")
                elif what == "words":
                    made.append(words)
                elif fields[words] is None:
                    return None
                else:
                    made.append(self._value(words, fields[words]))
            return "".join(made)

        said = filled(self.terms.sentences[key])
        assert said is not None, key
        return said

    def _value(self, field: str, value: Any) -> str:
        if field in _SILENT:
            return ""
        if field == "color":
            return self.shade(value)
        if field == "shape":
            return self.terms.word(value)
        if field in ("part", "onto"):
            return self._spoken.get(value, value)
        if field in ("spot", "far"):
            return self._at(value)
        if field == "spots":
            return "; ".join(map(self._at, value))
        return number(value) if isinstance(value, (int, float)) else str(value)

    def _at(self, spot: Spot) -> str:
        front = True if spot.stitch is None else None
        whole = int(spot.round)
        if spot.round - whole == 0.5:
            return self.say("at between", round=whole, next=whole + 1, stitch=spot.stitch, front=front)
        return self.say("at round", round=spot.round, stitch=spot.stitch, front=front)

    def finish(self, record: Finish) -> str:
        """The sentence of a finishing record."""

        def odd(name: str) -> Any:
            value = getattr(record, name)
            usual = type(record).__dataclass_fields__[name].default
            return None if value == usual else value

        match record:
            case Placed():
                clauses = {name: odd(name) for name in ("flat", "across", "tilt", "towards", "by", "through")}
                return self.say("place", part=record.part, onto=record.spot.part, spot=record.spot, **clauses)
            case Tie():
                one, far = record.spots
                return self.say("tie", part=one.part, spot=one, far=far, apart=record.apart)
            case Eye():
                return self.say("eye", part=record.spot.part, spot=record.spot, size=record.size, color=odd("color"))
            case Embroidery():
                spots, part = record.spots, record.spots[0].part
                return self.say("embroider", part=part, spots=spots, color=odd("color"), width=odd("width"))
            case Felt():
                return self.say(
                    "felt",
                    part=record.spot.part,
                    spot=record.spot,
                    shape=record.shape,
                    width=record.width,
                    height=record.height,
                    turn=odd("turn"),
                    color=odd("color"),
                )
            case Hair():
                spots, part = record.spots, record.spots[0].part
                return self.say(
                    "hair", part=part, spots=spots, count=record.count, length=record.length, color=odd("color")
                )

    def sewn(self, record: Placed, where: str, ways: str) -> str | None:
        """The sentence of a part sewn on as a person says it, who is told ``where`` in words too; None where its angles have none.

        ways : of WAYS, those of where it is sewn
        """
        turns = self._listed("turns")
        if (
            record.by is not None
            or record.through
            or record.towards % CLOCK
            or record.across % TURN
            or record.tilt not in (0, *LEANS)
        ):
            return None
        return self.say(
            "place said",
            part=record.part,
            onto=record.spot.part,
            where=where,
            spot=record.spot,
            flat=True if record.flat else None,
            lean=self._listed("leans")[LEANS.index(int(record.tilt))] if record.tilt else None,
            way=self._way(int(record.towards % 360), ways),
            about=turns[int(record.across % 360) // TURN - 1] if record.across % 360 else None,
        )

    def _way(self, towards: int, ways: str) -> str:
        """The words for a way, in whole degrees to the left of up, on a side of a toy that has the words ``ways`` (of WAYS)."""
        eight = self._listed(ways)
        if towards % TURN == 0:
            return eight[towards // TURN]
        hour, half = divmod(360 - towards, 30)
        return self.terms.page["clock"].format(hour=f"{hour or 12}:{2 * half:02d}", up=eight[0])

    def _listed(self, key: str) -> list[str]:
        """What a table lists between commas."""
        return [said.strip() for said in self.terms.page[key].split(",")]

    # -- reading --------------------------------------------------------------------------------------------------

    def read(self, text: str, keys: Iterable[str] = tuple(SENTENCES)) -> tuple[str, dict[str, Any]] | None:
        """Which sentence ``text`` is, whole, and its fields (those left out are not there); None for none of ``keys``."""
        said = text.strip().rstrip(".").rstrip()
        small = said.lower()
        for key, fixed in self._needed(tuple(keys)):
            if (fixed and fixed[0] not in small) or not all(word in small for word in fixed):
                continue  # most sentences are none of these
            found = self._compiled(key).fullmatch(said)
            if not found:
                continue
            fields = {f: self._heard(f, words) for f, words in found.groupdict().items() if words is not None}
            if all(value is not None for value in fields.values()):
                return key, fields
        return None

    def item(self, text: str) -> tuple[str, tuple[int, ...], tuple[str, ...]] | None:
        """The action (name, numbers, labels) that a piece of a round, or a line, says; None where it says none."""
        found = self.read(text, ITEMS)
        if found is None:
            return None
        key, fields = found
        name, numbers = ITEMS[key]
        labels = tuple(fields[f] for f in ("label", "one", "other") if f in fields)
        if key == "ring":
            numbers = (fields["count"], 0)
        elif name == "color":
            numbers = fields["color"]
        elif key == "oval":
            numbers = (fields["count"], fields["next"])
        elif name == "edge":
            numbers = (fields.get("count", 0), *numbers)
        elif "count" in fields:
            numbers = (fields["count"],)
        return name, numbers, labels

    def finishing(self, text: str, span: Span = _NOWHERE) -> Finish | None:
        """The record that ``text`` says; None where it is no finishing sentence as :meth:`finish` makes them."""
        found = self.read(text, _FINISH)
        if found is None:
            return None
        key, fields = found
        part = fields.pop("part")
        if key == "place said":
            key, fields = "place", {of: fields[name] for name, of in _PLACED.items() if name in fields}

        def spot(at: tuple[float, float | None], where: str = part) -> Spot:
            return Spot(where, *at, span)

        if key == "place":
            return Placed(part, spot(fields.pop("spot"), fields.pop("onto")), span=span, **fields)
        if key == "tie":
            return Tie((spot(fields.pop("spot")), spot(fields.pop("far"))), span=span, **fields)
        if key in ("eye", "felt"):
            return {"eye": Eye, "felt": Felt}[key](spot(fields.pop("spot")), span=span, **fields)
        spots = tuple(spot(at) for at in fields.pop("spots"))
        return {"embroider": Embroidery, "hair": Hair}[key](spots, span=span, **fields)

    def _needed(self, keys: tuple[str, ...]) -> list[tuple[str, tuple[str, ...]]]:
        """Keys, each with the words that every sentence of its has: asked of every sentence of a text."""
        found = self._asked.get(keys)
        if found is None:
            found = self._asked[keys] = [(key, _fixed(self.terms.sentences[key])) for key in keys]
        return found

    @cached_property
    def _asked(self) -> dict[tuple[str, ...], list[tuple[str, tuple[str, ...]]]]:
        return {}

    @cached_property
    def _patterns(self) -> dict[str, re.Pattern[str]]:
        return {}

    def _compiled(self, key: str) -> re.Pattern[str]:
        found = self._patterns.get(key)
        if found is None:
            found = self._patterns[key] = _compiled(self._regex(self.terms.sentences[key], True))
        return found

    def _regex(self, template: str, named: bool) -> str:
        made = []
        for what, words in _pieces(template):
            if what == "maybe":
                made.append(f"(?:{self._regex(words, named)})?")
            elif what == "words":
                made.append(r"\s+".join(re.escape(w) for w in re.split(r"\s+", words)))
            else:
                made.append(f"(?P<{words}>{self._field(words)})" if named else f"(?:{self._field(words)})")
        return "".join(made)

    def _field(self, field: str) -> str:
        words = self.terms.words
        if field in _SILENT:
            return ""
        if field in ("part", "onto"):
            known = sorted(self._parts, key=len, reverse=True)
            return "|".join(map(re.escape, known)) if known else r"[^,.:;()]+?(?:\.\d+)?"
        if field == "color":
            said = [s for spellings in self.terms.colors.values() for s in spellings]
            shade = self._regex(self.terms.sentences["shade"], False)
            return "|".join([r"#[0-9a-f]{6}\b", r"#[0-9a-f]{3}\b", shade, *map(re.escape, said)])
        if field == "shape":
            return "|".join(re.escape(s) for shape in SHAPES for s in words[shape])
        if field in ("spot", "far", "spots"):
            spot = "|".join(self._regex(self.terms.sentences[k], False) for k in ("at between", "at round"))
            return rf"(?:{spot})(?:\s*;\s*(?:{spot}))*" if field == "spots" else spot
        if field in ("label", "one", "other"):
            return _LABEL
        if field == "letter":
            return r"[A-Z]\d*"
        if field == "hex":
            return r"#[0-9a-f]{6}"
        if field in ("count", "next", "first", "last", "through"):
            return r"\d{1,9}"
        if field in ("name", "item", "items", "where"):
            return ".+?"
        if field in ("lean", "way", "about"):
            return "|".join(map(re.escape, sorted(self._angles(field), key=len, reverse=True)))
        return _NUMBER

    def _angles(self, field: str) -> dict[str, float]:
        """The words for how far a part leans, where to, or how far it is turned → degrees."""
        if field == "lean":
            return {said.lower(): float(a) for said, a in zip(self._listed("leans"), LEANS)}
        if field == "about":
            return {said.lower(): float(TURN * (k + 1)) for k, said in enumerate(self._listed("turns"))}
        return {self._way(w, ways).lower(): float(w) for ways in WAYS for w in range(0, 360, CLOCK)}

    def _heard(self, field: str, words: str) -> Any:
        if field in _SILENT:
            return True
        if field in ("part", "onto"):
            return self._parts.get(words.lower(), words)
        if field in ("color", "hex"):
            return self.color(words)
        if field == "shape":
            return next(s for s in SHAPES if words.lower() in (w.lower() for w in self.terms.words[s]))
        if field in ("spot", "far"):
            return self._place(words)
        if field == "spots":
            return [self._place(piece) for piece in words.split(";")]
        if field in ("lean", "way", "about"):
            return self._angles(field)[" ".join(words.lower().split())]
        if field in ("label", "one", "other", "letter", "name", "item", "items", "where"):
            return words.upper() if field == "letter" else words
        return int(words) if field in ("count", "next", "first", "last", "through") else float(words)

    def _place(self, words: str) -> tuple[float, float | None]:
        found = self.read(words, ("at between", "at round"))
        assert found is not None  # it was matched by the same templates
        fields = found[1]
        middle = (fields["round"] + fields["next"]) / 2 if "next" in fields else fields["round"]
        return middle, fields.get("stitch")
