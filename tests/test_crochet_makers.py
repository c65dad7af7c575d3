"""Patterns as makers write them: forty texts in as many styles, each with its graph; planted mistakes are found."""

import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from tambour.core.errors import TambourError, Text
from tambour.crochet.graph.build import build
from tambour.crochet.graph.built import Built
from tambour.crochet.graph.check import tech_edit
from tambour.crochet.language.finishes import Embroidery, Eye, Placed
from tambour.crochet.language.parse import parse
from tambour.crochet.printed.choose import read

FOLDER = Path(__file__).parent / "data" / "makers"
PATTERNS = sorted(FOLDER.glob("*.txt"))
TEXTS = {path.stem: path.read_text() for path in PATTERNS}


def works(text: str, name: str = "pattern.txt") -> Built:
    return build(read(Text(text, name)))


def findings(text: str) -> list[tuple[int, str]]:
    """Line and sentence of everything that is wrong or doubtful."""
    source = Text(text, "pattern.txt")
    try:
        pattern = read(source)
        found = [*pattern.unread, *tech_edit(build(pattern))]
    except TambourError as error:
        found = list(error.problems)
    return [(source.place(p.span.start)[0] if p.span else 0, p.message) for p in found]


def test_there_are_forty() -> None:
    assert len(PATTERNS) >= 40


@pytest.mark.parametrize("path", PATTERNS, ids=lambda p: p.stem)
def test_each_gives_its_graph_without_a_doubt(path: Path) -> None:
    made, twin = works(path.read_text(), path.name), build(parse(Text(path.with_suffix(".acl").read_text(), path.stem)))
    a, b = made.graph, twin.graph
    assert np.array_equal(a.edges, b.edges)
    assert [a.kinds[k] for k in a.kind] == [b.kinds[k] for k in b.kind]
    assert np.array_equal(a.color, b.color)
    assert [p.end - p.start for p in a.parts] == [p.end - p.start for p in b.parts]
    assert np.allclose(a.rest, b.rest)
    assert not [str(w) for w in made.warnings if not w.message.startswith("approximated")]


def test_the_bear_in_print_is_the_bear() -> None:
    folder = Path(__file__).parent.parent / "examples" / "crochet"
    printed, own = works((folder / "bear.txt").read_text(), "bear.txt"), folder / "bear.acl"
    twin = build(parse(Text(own.read_text(), own.name)))
    assert np.array_equal(printed.graph.edges, twin.graph.edges)
    assert np.array_equal(printed.graph.color, twin.graph.color)
    # In a person's words and by the hand's own numbers they go to the same places, near enough.
    said, drawn = ([r for r in p.pattern.finish if isinstance(r, (Placed, Eye))] for p in (printed, twin))
    key = lambda r: (type(r).__name__, r.part if isinstance(r, Placed) else "", r.spot.stitch or 0.0)  # noqa: E731
    assert len(said) == len(drawn)
    for one, other in zip(sorted(said, key=key), sorted(drawn, key=key)):
        assert (type(one), one.spot.part, one.spot.round) == (type(other), other.spot.part, other.spot.round)
        assert one.spot.stitch == other.spot.stitch or abs(one.spot.stitch - other.spot.stitch) < 1.0
        if isinstance(one, Placed):
            assert one.part == other.part and abs(one.tilt - other.tilt) <= 25.0
    assert {r.motif for r in printed.pattern.finish if isinstance(r, Embroidery)} == {"nose", "smile"}
    assert tech_edit(printed) == []


@pytest.mark.parametrize("name", TEXTS)
def test_no_false_alarm(name: str) -> None:
    assert findings(TEXTS[name]) == []


def _rounds(text: str) -> list[tuple[int, str]]:
    """Lines (their number, the line) of rounds that state a count."""
    head = re.compile(
        r"^\W*(\d+(?:st|nd|rd|th) (?:to|rnd)|(?:R|Rnd|Rd|Rnds|Round|Rounds|Row|Rows)\.? ?\d|\d+[.)-] ?)", re.I
    )
    lines = list(enumerate(text.split("\n"), 1))
    return [(at, line) for at, line in lines if head.match(line) and re.search(r"\d+\D*$", line)]


def mutations() -> Iterator[tuple[str, str, str, int]]:
    """What was planted, the pattern, its text with the mistake in it, and the line it stands on."""
    for name, text in TEXTS.items():
        rounds = _rounds(text)
        lines = text.split("\n")
        for at, line in rounds[1:]:
            last = list(re.finditer(r"\d+", line))[-1]
            wrong = line[: last.start()] + str(int(last[0]) + 1) + line[last.end() :]
            yield "count", name, "\n".join([*lines[: at - 1], wrong, *lines[at:]]), at
        # A round between two others left out. Without the last one of a part it would be another, shorter part.
        heads = {at for at, _ in rounds}
        for at, _ in rounds[2:-1]:
            after = next((k for k in range(at + 1, len(lines) + 1) if lines[k - 1].strip()), 0)
            if after not in heads:
                continue
            yield "missing", name, "\n".join([*lines[: at - 1], *lines[at:]]), at
        for at, line in rounds:
            if at == rounds[-1][0] and not re.search(r"[\[({=–-] ?\d+\D*$", line):
                continue  # without a count, where the last round stops is its own affair
            for one, other in (("inc", "dec"), ("dec", "inc"), ("V", "A"), ("A", "V")):
                swapped = re.sub(rf"\b(\d*){one}\b", rf"\g<1>{other}", line)
                if swapped != line:
                    yield "swapped", name, "\n".join([*lines[: at - 1], swapped, *lines[at:]]), at
    uk = {name: text for name, text in TEXTS.items() if re.search(r"\bhtr\b|dc2tog", text)}
    for name, text in uk.items():
        lines = text.split("\n")
        for at, line in _rounds(text):
            if re.search(r"\bdc\b", line):
                mixed = re.sub(r"\bdc\b", "sc", line)
                yield "terms", name, "\n".join([*lines[: at - 1], mixed, *lines[at:]]), at


PLANTED = list(mutations())


def test_there_are_enough_mistakes() -> None:
    kinds = {kind: sum(k == kind for k, *_ in PLANTED) for kind in ("count", "missing", "swapped", "terms")}
    assert len(PLANTED) >= 100 and min(kinds.values()) >= 5, kinds


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["count", "missing", "swapped", "terms"])
def test_every_planted_mistake_is_found(kind: str) -> None:
    missed = []
    for what, name, text, at in PLANTED:
        if what != kind:
            continue
        found = findings(text)
        # Told at the line itself or, where it shows only later, within the next two rounds.
        if not any(at - 1 <= line <= at + 3 for line, _ in found):
            missed.append((name, text.split("\n")[at - 1], found))
    assert not missed
