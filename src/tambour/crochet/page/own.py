"""A pattern written back in the language's standard terms: numbered rounds, brackets found, counts stated."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Mapping
from types import MappingProxyType
from typing import Any, Final

from tambour.core.errors import Text
from tambour.core.rgb import hexed
from tambour.crochet.graph.build import build
from tambour.crochet.graph.built import Built, Done
from tambour.crochet.language.finishes import Embroidery, Eye, Felt, Finish, Hair, Placed, Spot, Tie
from tambour.crochet.language.stitches import EDGES, RULES, SPELT, STITCHES, STUFFING, Stitch
from tambour.crochet.language.tree import Pattern, Section
from tambour.crochet.page.written import Written, sections
from tambour.crochet.piece import Plush
from tambour.crochet.words.phrases import number
from tambour.crochet.words.special import told
from tambour.crochet.words.table import Terms

# The language's own words, for definitions.
_WORDS: Final = Terms(
    "",
    "tambour's own language",
    {name: (name,) for name in STITCHES},
    {},
    {word: (word,) for word in ("height", "pull through", "pull over", "next anchor")},
    {"several": "{count} {item}"},
    {},
)


def view(piece: Plush) -> Text:
    """The pattern of a piece, written back."""
    return pattern(piece.built)


def pattern(piece: Built | Pattern) -> Text:
    """The text of a pattern, in standard terms; reading it again gives the same graph (but for the spans) and finishing.

    Marks keep their names, definitions their words; comments and what has no effect are left out.
    """
    built = build(piece) if isinstance(piece, Pattern) else piece
    source = built.pattern
    blocks: list[str] = []
    own = _definitions(source)
    if own:
        blocks.append("\n".join(own))
    names = _names([section.name for section in source.parts])
    for section, _, lines in sections(built):
        said = _head(section, names[section.name])
        for line in lines:
            said += [_line(line, names), *(f"# {' '.join(note.split())}" for note in line.notes)]
        if said:
            blocks.append("\n".join(said))
    if source.finish:
        blocks.append("\n".join(finishing(record, names) for record in source.finish))
    return Text("\n\n".join(blocks) + "\n" if blocks else "", source.text.name)


def _definitions(source: Pattern) -> list[str]:
    """The pattern's own stitches: as they were written, or in the language's words when they were printed."""
    if not source.terms:
        return [source.text.text[span.start : span.end].strip() for span in source.own.values()]
    made: list[str] = []
    known: dict[str, Stitch] = {}
    for name in source.own:
        line = told(source.stitches[name], known, _WORDS)
        if line is not None:
            made.append(f"define {line[0]}")
            known[name] = source.stitches[name]
    return made


def _names(parts: list[str]) -> dict[str, str]:
    """Part → its name as the language takes it: words of plain letters and digits."""
    made: dict[str, str] = {}
    for name in parts:
        plain = unicodedata.normalize("NFKD", name).encode("ascii", "ignore").decode()
        said = " ".join(w if w[:1].isalpha() else f"_{w}" for w in re.findall(r"\w+", plain))
        while (said or name) in made.values() and name not in made:
            said += "_"
        made[name] = said or ("part" if name else "")
    return made


def _head(section: Section, name: str) -> list[str]:
    lines = []
    if name:
        lines.append(f"== {name}{f' (make {section.copies})' if section.copies > 1 else ''} ==")
    if section.centroids is not None:
        lines.append(f"@centroids = {section.centroids}")
    if section.stuffing is not None:
        word = next((w for w, amount in STUFFING.items() if amount == section.stuffing), number(section.stuffing))
        lines.append(f"@stuffing = {word}")
    if section.initializer is not None:
        lines.append(f"@initializer = {section.initializer}")
    if section.up is not None:
        lines.append(f"@up = {section.up}")
    if section.stands is not None:
        lines += [f"@{side} = {at[0]:.0f}-{at[1]:.0f}" for side, at in zip(("top", "front"), section.stands)]
    if section.hollow is not None:
        lines.append(f"@hollow = {section.hollow[0]}-{section.hollow[1]}")
    if not section.tip_from_fo:
        lines.append("@tip_from_fo = false")
    return lines


def _line(line: Written, names: Mapping[str, str]) -> str:
    said = []
    for unit, times in line.pieces:
        words = ", ".join(_again(d, names) if d.what == "again" else _said(d) for d in unit)
        said.append(f"[{words}] x {times}" if times > 1 else words)
    text = ", ".join(said) + (f" ({line.count})" if line.count else "")
    if not line.makes:
        return text
    if not line.number:
        return f": {text}"
    last = line.number + line.times - 1
    return f"R{line.number}: {text}" if line.times == 1 else f"R{line.number}-R{last}: {text}"


def _again(done: Done, names: Mapping[str, str]) -> str:
    """Rounds that are written elsewhere."""
    (first, last), part = done.numbers, done.labels[0]
    said = f"as R{first}" if first == last else f"as R{first}-R{last}"
    return f"{said} of {names[part]}" if part else said


def _said(done: Done) -> str:
    name = SPELT.get(done.what, done.what)
    if done.what not in RULES:
        return name if done.times == 1 else f"{done.times} {name}"
    if done.what == "mr":
        return f"MR({done.numbers[0]})"
    if done.what == "tospace":
        return "tospace(half)" if done.numbers[0] else "tospace"
    if done.what == "edge":
        places, which = done.numbers
        return f"edge({EDGES[which]}{f', {places}' if places else ''})"
    if done.what == "attach":
        size = done.numbers[0]
        return f"attach({done.labels[0]}{', merge' if size < 0 else f', {size}' if size else ''})"
    arguments = [*done.labels, *(str(n) for n in done.numbers)]
    return f"{name}({', '.join(arguments)})" if arguments else name


def finishing(record: Finish, names: Mapping[str, str] = MappingProxyType({})) -> str:
    """A finishing record as a line of the language; what is as usual is left out. names : part → its name there."""

    def part(name: str) -> str:
        base, _, copy = name.rpartition(".")
        return f"{names[base]}.{copy}" if name not in names and base in names else names.get(name, name)

    def odd(*names: str) -> list[str]:
        made = []
        for name in names:
            value: Any = getattr(record, name)
            if value != type(record).__dataclass_fields__[name].default:
                made.append(f"{name}={hexed(value) if name == 'color' else number(value)}")
        return made

    def at(spot: Spot) -> list[str]:
        return [f"round={number(spot.round)}", *([] if spot.stitch is None else [f"stitch={number(spot.stitch)}"])]

    def places(spots: tuple[Spot, ...]) -> list[str]:
        return [number(s.round) + ("" if s.stitch is None else f":{number(s.stitch)}") for s in spots]

    match record:
        case Placed():
            what, flat = "place", ["flat"] if record.flat else []
            said = [
                part(record.part),
                part(record.spot.part),
                *at(record.spot),
                *flat,
                *odd("across", "tilt", "towards", "by", "through"),
            ]
        case Tie():
            what, said = "tie", [part(record.spots[0].part), *places(record.spots), f"apart={number(record.apart)}"]
        case Eye():
            what, said = "eye", [part(record.spot.part), *at(record.spot), *odd("size", "color")]
        case Embroidery():
            what = "embroider"
            said = [part(record.spots[0].part), *places(record.spots), *odd("color", "width")]
        case Felt():
            # The height is as the width unless it is said.
            size = [f"width={number(record.width)}", f"height={number(record.height)}"]
            what, said = "felt", [part(record.spot.part), record.shape, *at(record.spot), *size, *odd("turn", "color")]
        case Hair():
            what = "hair"
            said = [part(record.spots[0].part), *places(record.spots), *odd("count", "length", "color")]
    return f"{what}({', '.join(said)})"
