"""The page to sell: everything is there as real text, nothing is cut, nothing lies over something else."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

import numpy as np
import pypdfium2
import pytest

from tambour.core.drawing import Drawing
from tambour.core.errors import Text
from tambour.core.picture import Picture
from tambour.core.progress import Progress
from tambour.crochet.graph.spots import Spots
from tambour.crochet.maker.materials import DENSITY, materials
from tambour.crochet.page.album import Album
from tambour.crochet.page.booklet import pages
from tambour.crochet.page.flow import Atom, Chunk, Frame, flow, together
from tambour.crochet.page.instructions import words
from tambour.crochet.page.pictures import steps
from tambour.crochet.page.type import width_of, wrap
from tambour.crochet.params import CrochetParams
from tambour.crochet.piece import Plush
from tambour.crochet.plush import make
from tambour.crochet.words.table import TERMS
from tambour.crochet.yarns import WEIGHTS
from tambour.files import write
from tambour.render.page import Page

TOY = """\
color(#e4572e)
== Body ==
R1: MR(6) (6)
R2: 6 inc (12)
R3: [sc, inc] x 6 (18)
R4-R6: 18 sc (18)
color(#17838f)
R7: [sc, dec] x 6 (12)
R8: 6 dec (6)
FO
== Ear (make 2) ==
@stuffing = none
R1: MR(5) (5)
R2: 5 inc (10)
place(Ear.1, Body, round=5, stitch=4, flat)
place(Ear.2, Body, round=5, stitch=13, flat)
eye(Body, round=4, stitch=8, size=4)
"""


@cache
def toy(**given: object) -> Plush:
    return make(Text(TOY, "toy.acl"), CrochetParams(detail="low", **given), Progress())  # type: ignore[arg-type]


@cache
def booklet(**given: object) -> tuple[Drawing, ...]:
    return pages(toy(**given))


def said(drawings: tuple[Drawing, ...]) -> str:
    return "\n".join(label.text for page in drawings for label in page.labels)


@pytest.mark.slow
def test_the_booklet_says_everything() -> None:
    text = said(booklet(designer="Anna Weaver", title="A small toy"))
    for wanted in (
        *("A small toy", "Anna Weaver", "Materials", "Finished size", "Gauge", "Abbreviations", "Assembly", "Care"),
        *("Rnd 4-6", "18 sc", "(18)", "Ear (make 2)", "1 safety eye, 4 mm, black", "3.5 mm", "worsted weight (4)"),
        *(
            "Step 1: Ear",
            "Now, while fingers still reach inside: insert",
            "single crochet",
            "polyester fiberfill",
        ),
    ):
        assert wanted in text, wanted
    # Abbreviations that are used and no others.
    assert "decrease: 2 sc worked together" in text and "half double" not in text and "chain" not in text
    rounds = [f"Rnd {n}" for n in ("1", "2", "3", "4-6", "7", "8")]
    assert all(text.count(f"{label}\n") >= 1 for label in rounds)


@pytest.mark.slow
def test_the_file_holds_real_text_the_same_bytes_and_no_date(tmp_path: Path) -> None:
    drawings = booklet(designer="Anna Weaver", title="A small toy")
    for name in ("one.pdf", "two.pdf"):
        write(drawings, tmp_path / name, "Drawing")
    data = (tmp_path / "one.pdf").read_bytes()
    assert data == (tmp_path / "two.pdf").read_bytes()
    assert b"CreationDate" not in data and b"ModDate" not in data
    file = pypdfium2.PdfDocument(tmp_path / "one.pdf")
    assert (file.get_metadata_dict()["Title"], file.get_metadata_dict()["Author"]) == ("A small toy", "Anna Weaver")
    assert len(file) == len(drawings)
    text = "\n".join(page.get_textpage().get_text_range() for page in file)
    for wanted in ("A small toy", "Anna Weaver", "6 sc in magic ring", "[sc, dec] x 6", "Abbreviations"):
        assert wanted in text, wanted
    assert len(data) < 3_000_000


@pytest.mark.parametrize("page, size", [("a4", (210.0, 297.0)), ("letter", (215.9, 279.4))])
def test_nothing_leaves_the_paper_or_lies_over_other_words(
    page: str, size: tuple[float, float], monkeypatch: pytest.MonkeyPatch
) -> None:
    nothing = Picture(np.full((2, 3, 4), 255, np.uint8))
    monkeypatch.setattr("tambour.crochet.page.booklet.whole", lambda *_: nothing)
    for name in ("parts.of_parts", "assembly.of_step", "assembly.from_side"):
        monkeypatch.setattr(f"tambour.crochet.page.{name}", lambda *_: nothing)
    for drawing in booklet(page=page, title="A title that is so long that it hardly fits " * 3):
        assert tuple(drawing.size) == size
        boxes = []
        for label in drawing.labels:
            wide = width_of(label.text, label.size, label.bold)
            left = label.x - {"start": 0.0, "middle": 0.5, "end": 1.0}[label.anchor] * wide
            boxes.append((left, label.y - 0.72 * label.size, left + wide, label.y, label.text))
            assert left > 5.0 and left + wide < size[0] - 5.0, label.text
            assert 5.0 < label.y < size[1] - 5.0, label.text
        for placed in drawing.images:
            assert placed.x >= 0 and placed.x + placed.width <= size[0] + 1e-6
            assert placed.y >= 0 and placed.y + placed.height <= size[1] + 1e-6
        # The numbers of a chart may be crowded; lines of text may not.
        read = [box for box in boxes if box[3] - box[1] > 1.8]
        for k, one in enumerate(read):
            for other in read[:k]:
                apart = one[0] >= other[2] or other[0] >= one[2] or one[1] >= other[3] or other[1] >= one[3]
                assert apart, (one[4], other[4])


@pytest.mark.parametrize("code", sorted(TERMS))
def test_every_language_has_every_word_and_fills_it(code: str) -> None:
    assert set(TERMS["us"].page) <= set(TERMS[code].page)
    for key, sentence in TERMS["us"].page.items():
        assert set(re.findall(r"{(\w+)}", sentence)) >= set(re.findall(r"{(\w+)}", TERMS[code].page[key])), key
    found = words(toy().built, code)
    assert [block.title.split(" (")[0] for block in found.blocks] == ["Body", "Ear"]
    assert [row.count for row in found.blocks[0].lines if row.label] == [6, 12, 18, 18, 12, 6]
    assert len(found.seams) + len(found.finish) == 3 and found.abbreviations


def test_steps_add_part_after_part() -> None:
    found = steps(toy())
    assert [(step.parts, step.fresh, len(step.finishes)) for step in found] == [
        ((1, 2, 3), (2, 3), 1),  # its eye was put in while the body was open
        ((1, 2, 3), (), 1),
    ]
    seams = "".join(f"== p{k} ==\n: MR(6)\n: 6 inc, mark(m{k})\n" for k in range(3))
    sewn = make(Text(seams + "sew(m0, m1)\n"), CrochetParams(solver="none"), Progress())
    assert [(step.parts, step.fresh) for step in steps(sewn)] == [((0, 2, 1), (1,))]


def test_materials_add_up() -> None:
    piece = toy()
    found = materials(piece)
    assert found["hook_mm"] == 3.5 and found["notions"] == ["needle", "marker", "scissors"]
    assert [y["color"] for y in found["yarn"]] == ["#e4572e", "#17838f"]
    kind = WEIGHTS[piece.gauge.weight]
    for yarn in found["yarn"]:
        assert yarn["yards"] == pytest.approx(yarn["metres"] / 0.9144, abs=0.1)
        assert yarn["grams"] == pytest.approx(yarn["metres"] / kind.metres * 100, abs=0.1)
        assert yarn["skeins"] == 1
    litres = piece.shape.volume[1] * 5.0**3 / 1e6
    assert found["stuffing"]["litres"] == pytest.approx(litres, abs=0.01)
    assert found["stuffing"]["grams"] == pytest.approx(litres * 65.0, abs=0.1)
    assert dict(DENSITY)[1.0] == 65.0


def test_threads_through_the_stuffing_are_yarn_that_is_bought() -> None:
    body = "== Body ==\nR1: MR(6)\nR2: 6 inc\nR3: 12 sc\nR4: 6 dec\nFO\n"
    found = [
        materials(make(Text(body + more), CrochetParams(solver="none"), Progress()))["yarn"][0]["metres"]
        for more in ("", "tie(Body, 2:1, 3:7, apart=450)\n")
    ]
    assert found[1] - found[0] == pytest.approx(1.1 * (2 * 0.45 + 0.1), abs=0.1)


@pytest.mark.parametrize(
    ("words", "option", "metres"),
    [
        ("Bulky yarn (10.5 oz/300 g; 220 yds/201 m), white", None, 201.168 / 3),
        ("Cotton, 125 m per 50 g ball", None, 250.0),
        ("A (4 oz/113g), 212 yd; B 50 g/125 m", None, None),  # as typical: one is half as heavy again
        ("A (4 oz/113g), 212 yd; B 50 g/125 m", "100 g / 90 m", 90.0),
        ("22 g of stuffing, 6 mm eyes", None, None),
    ],
)
def test_yarn_is_weighed_by_its_own_ball(words: str, option: str | None, metres: float | None) -> None:
    text = f"Yarn: {words}\n\nRnd 1: 6 sc in magic ring. [6]\nRnd 2: inc around. [12]\n"
    found = materials(make(Text(text, "ball.txt"), CrochetParams(solver="none", ball=option), Progress()))
    kind = found["weight"]
    assert (kind["from"] == "ball") == (metres is not None)
    if metres is not None:
        assert kind["metres_100_g"] == pytest.approx(metres, abs=0.05)
        assert found["yarn"][0]["grams"] == pytest.approx(found["yarn"][0]["metres"] / metres * 100, abs=0.1)


def test_a_ball_is_said_by_grams_and_metres() -> None:
    with pytest.raises(ValueError, match="50 g / 125 m"):
        CrochetParams(ball="large")


def test_lines_are_as_wide_as_they_may_be_and_no_wider() -> None:
    text = "the quick brown fox jumps over the lazy dog " * 4
    for room in (20.0, 35.0, 80.0):
        lines = wrap(text, 3.0, room)
        assert " ".join(lines).split() == text.split()
        assert all(width_of(line, 3.0) <= room for line in lines)
    assert "".join(wrap("x" * 200, 3.0, 30.0)) == "x" * 200
    assert wrap("", 3.0, 30.0) == []


def test_headings_stay_with_rounds_and_columns_are_even() -> None:
    drawn: list[tuple[int, float, str]] = []
    sheets: list[Page] = []

    def page() -> Page:
        sheets.append(Page(100, 100))
        return sheets[-1]

    def atom(name: str, height: float) -> Atom:
        return Atom(height, lambda sheet, x, y: drawn.append((sheets.index(sheet), x, name)))

    chunks: list[Chunk] = []
    for part in range(7):
        rows = [atom(f"{part}.{k}", 4.0) for k in range(3 + 5 * part)]
        chunks += together([atom(f"head {part}", 8.0)], rows, f"part {part}")
    flow(chunks, Frame((0.0, 50.0), 45.0, 10.0, 90.0), page, "continued")
    assert len(drawn) == sum(1 + 3 + 5 * part for part in range(7))
    place = {name: (sheet, x) for sheet, x, name in drawn}
    for part in range(7):
        assert place[f"head {part}"] == place[f"{part}.0"] == place[f"{part}.2"]
        last = 3 + 5 * part - 1
        assert len({place[f"{part}.{k}"] for k in range(max(0, last - 3), last + 1)}) == 1
    ends = [label.text for sheet in sheets for label in sheet.labels]
    assert ends and all(text.endswith(", continued") for text in ends)
    counts = [sum(1 for s, x, _ in drawn if s == len(sheets) - 1 and x == left) for left in (0.0, 50.0)]
    assert abs(counts[0] - counts[1]) <= 6


@pytest.mark.slow
def test_pictures_hold_the_toy() -> None:
    cover = booklet(title="A small toy", designer="Anna Weaver")[0].images[0].picture.rgba
    assert cover.shape[1] > 1500  # 200 dots an inch over the page
    edge, middle = cover[[0, -1]].reshape(-1, 4)[:, :3].astype(int), cover[len(cover) // 2, cover.shape[1] // 2]
    assert (abs(edge - np.array((241, 240, 238))) <= 4).all()
    assert abs(middle[:3].astype(int) - 240).max() > 60


@pytest.mark.slow
def test_a_light_that_parts_came_into_one_by_one_is_that_in_which_they_came_together() -> None:
    piece = toy()
    kept = Album(piece)
    orders = [([1], ()), ([1, 2], ()), ([1, 2], kept.face), (kept.all, kept.face), ([1], kept.face), (kept.all, ())]
    seen = set()
    for parts, face in orders:
        lights, anew = kept.light(parts, face, 0.4), Album(piece).light(parts, face, 0.4)
        np.testing.assert_array_equal(lights.depth, anew.depth)
        np.testing.assert_array_equal(lights.direction, anew.direction)
        seen.add(lights.depth.tobytes())
    assert len(seen) == len(orders)


HERS = """Whale

BODY
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (17)
Rnd 4: (2 sc, inc) x 6 (24)
Rnds 5-10: sc around (24)
Rnd 11: (2 sc, dec) x 6 (18)
Rnd 12: (sc, dec) x 6 (12)
Rnd 13: dec x 6 (6)
Stuff firmly. Fasten off and close.

TAIL
Rnd 1: 6 sc in MR (6)
Rnds 2-7: sc around (6)
Fasten off.

Assembly
Put 8 mm safety eyes between rounds 6 and 7, 8 stitches apart. Sew tail to body.
"""


def _photo(shade: int) -> bytes:
    from io import BytesIO

    from PIL import Image

    data = BytesIO()
    Image.new("RGB", (300, 400), (shade, 10, 10)).save(data, "PNG")
    return data.getvalue()


@cache
def hers(**given: object) -> Plush:
    photos = ((7, _photo(200)), (HERS.index("TAIL") + 5, _photo(100)), (HERS.index("TAIL") + 6, b"no picture"))
    return make(Text(HERS, "whale.txt", photos), CrochetParams(detail="low", **given), Progress())  # type: ignore[arg-type]


def test_eyes_and_stuffing_stand_where_hands_still_reach_and_her_count_stays_hers() -> None:
    """In the written pattern: before the last rounds are drawn together; her count with the doubt beside it."""
    from tambour.crochet.page.instructions import plain

    lines = plain(hers()).text.splitlines()
    eyes, stuff, last = (
        next(k for k, line in enumerate(lines) if word in line)
        for word in ("› Now, while fingers still reach", "› Begin to stuff", "Rnd 13")
    )
    assert eyes < last and stuff < last
    hers_ = [
        lines.index(words)
        for words in ("Stuff firmly.", "- Put 8 mm safety eyes between rounds 6 and 7, 8 stitches apart.")
    ]
    assert last < hers_[0] < hers_[1]  # where she says them
    assert "Rnd 3: (sc, inc) x 6 [as written it makes 18] (17)" in lines


def test_a_count_without_its_slip_stitches_is_no_doubt() -> None:
    """Shaped rows end their own way: 14 single crochets and a slip stitch are "14 sc", in the check and in print."""
    from tambour.crochet.page.instructions import plain

    said = (
        "Bib\n\nABBREVIATIONS\nsc = single crochet\n\nINSTRUCTIONS\nCh 21.\n"
        "Row 1: Sc in 2nd ch from hook and in each ch across, turn—20 sc.\n"
        "Row 2: Ch 1, skip first sc, slip st in next sc, sc2tog, sc in each sc across to last 4 sc, sc2tog, turn; "
        "leave last 2 sts unworked—14 sc.\nFasten off.\n"
    )
    piece = make(Text(said, "bib.txt"), CrochetParams(detail="low"), Progress())
    assert not [p for p in piece.built.warnings if p.message.startswith("the pattern says")]
    row = next(line for line in plain(piece).text.splitlines() if line.startswith("Row 2"))
    assert row.endswith("unworked (14)")


def test_a_step_is_seen_from_where_its_part_is_not_hidden() -> None:
    """A ball's tail is behind it, a snout before it; the camera goes where the part is, and stays for what it sees already."""
    from tambour.crochet.page.angle import VIEW, angle, called

    ball = "== Ball ==\n: MR(6)\n: 6 inc\n: [sc, inc] x 6\n: [2 sc, inc] x 6\n6: 24 sc\n: [2 sc, dec] x 6\n: [sc, dec] x 6\nFO\n"
    text = ball + "== Knob ==\n: MR(6)\n3: 6 sc\n" + "place(Knob, Ball, round=7, stitch={})\n"

    def placed(stitch: float) -> Plush:
        return make(Text(text.format(f"{stitch:.2f}")), CrochetParams(detail="low"), Progress())

    middle = 1.0 + Spots(placed(1).built).front(6)
    snout, tail = placed(middle), placed((middle + 11.0) % 24.0 + 1.0)
    assert angle(snout, [0, 1], [1]) == VIEW
    assert called(angle(tail, [0, 1], [1])) == "back" and called(VIEW) == ""
    assert angle(tail, [0, 1], [0, 1]) == VIEW


def test_the_page_speaks_of_what_the_piece_has_in_the_spelling_of_its_designer() -> None:
    from tambour.crochet.page.book import Book
    from tambour.crochet.page.care import care
    from tambour.crochet.page.plain import as_she_writes

    assert "plastic" in " ".join(care(Book(toy())))
    house = "With {} yarn.\n\nWALL\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\n\nDOOR\nRnd 1: 6 sc in MR (6)\n\nSew the door to the wall.\n"
    book = Book(make(Text(house.format("grey"), "house.txt"), CrochetParams(solver="none"), Progress()))
    assert "eyes" not in " ".join(care(book)) and "every part" in " ".join(care(book))
    assert "full colour" in book.own["new"] and book.said.color((140, 140, 142))[1] == "grey"
    assert as_she_writes(TERMS["us"], "gray, not grey") is as_she_writes(TERMS["us"], "red") is TERMS["us"]
    assert as_she_writes(TERMS["fr"], "grey") is TERMS["fr"]


def test_charts_number_rows_as_the_text_does_and_explain_every_sign() -> None:
    """The chain of a part is round 0, whatever number the part before ended with."""
    from tambour.crochet.page.diagram import _light, _patch, plates, symbols

    text = "STEM\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnd 3: in BLO, (sc, dec) x 4 (8)\n\nDOOR\nch 6.\nRow 1: sc in 2nd ch from hook, sc across, turn (5)\nRows 2-3: ch 1, sc across, turn (5)\n"
    built = make(Text(text, "house.txt"), CrochetParams(solver="none"), Progress()).built
    assert [r.number for r in built.rounds if r.part == 1] == [0, 1, 2, 3]
    (_, _, stem), (_, rows, door) = plates(built)
    assert rows and [label.text for label in door.labels] == ["1", "2", "3"]
    assert [label.text for label in stem.labels] == ["1", "2", "3"]
    assert {"sc", "inc", "dec", "ring", "back loops"} <= {name for name, _ in symbols(built)}
    for rgb in ((140, 140, 140), (255, 255, 255), (200, 40, 40), (0, 0, 0)):
        patch, pen = _light(_patch(rgb)), (_light((40, 38, 36)), _light((250, 248, 244)))
        assert max((max(patch, p) + 0.05) / (min(patch, p) + 0.05) for p in pen) >= 6.0


def test_a_text_file_holds_no_markdown() -> None:
    from tambour.crochet.page.instructions import plain
    from tambour.crochet.page.plain import unmarked

    text = plain(hers()).text
    assert not re.search(r"^#|\*\*|^\*\S| $", text, re.MULTILINE)
    assert re.search(r"^TAIL\n----$", text, re.MULTILINE)
    assert unmarked("## A  \n*say it*\n**Gauge:** 3  ") == "A\n-\nsay it\nGauge: 3\n"


@pytest.mark.slow
def test_her_photo_leads_the_cover_and_ours_says_that_it_is_computed() -> None:
    cover, *inside = pages(hers())
    assert any(label.text == "computed from this pattern" for label in cover.labels)
    first = cover.images[0]
    assert tuple(first.picture.rgba[0, 0, :3]) == (200, 10, 10) and first.width == 210.0
    assert cover.images[1].width < 0.3 * first.width
    shown = [tuple(i.picture.rgba[0, 0, :3]) for sheet in inside for i in sheet.images]
    assert shown.count((100, 10, 10)) == 1  # the other stands with its part, and what is no picture nowhere


@pytest.mark.slow
def test_little_ink_has_white_grounds_and_large_print_the_same_paper() -> None:
    full, low, large = booklet(), booklet(ink="low"), booklet(large_print=True)
    assert {tuple(sheet.size) for sheet in (*full, *low, *large)} == {(210.0, 297.0)}
    assert tuple(low[0].images[0].picture.rgba[0, 0, :3]) == (255, 255, 255)

    def printed(sheets: tuple[Drawing, ...]) -> float:
        return sum(i.width * i.height for sheet in sheets for i in sheet.images)

    assert printed(low) < 0.4 * printed(full)
    sizes = [max(sheet.labels, key=lambda label: label.size).size for sheet in (full[0], large[0])]
    assert sizes[1] > 1.2 * sizes[0]
    words_of = [sorted(" ".join(label.text for s in sheets for label in s.labels).split()) for sheets in (full, large)]
    assert set(words_of[0]) - set(words_of[1]) <= {"continued", *(w for w in words_of[0] if not w.isalpha())}


MARKED = """\
== Body ==
color(#6fa83f)
R1: MR(6) (6)
R2: 6 inc (12)
R3: 12 sc (12)
R4: sc, mark(br), 3 sc, mark(bu), 3 sc, mark(bl), 3 sc, mark(bd), 2 sc (12)
R5: 6 dec (6)
FO
== Arm (make 2) ==
color(#dbe5a6)
R1: MR(6) (6)
R2: 6 sc (6)
R3: sc, mark(ar), sc, mark(au), 2 sc, mark(al), sc, mark(ad), sc (6)
sew(ar.1, br)
sew(au.1, bu)
sew(al.1, bl)
"""


def test_what_is_sewn_by_marks_is_a_sentence_for_every_part() -> None:
    from tambour.crochet.page.assembly import _sentences
    from tambour.crochet.page.book import Book

    piece = make(Text(MARKED, "toy.acl"), CrochetParams(solver="none"), Progress())
    found = steps(piece)
    said = [line for lines in _sentences(Book(piece), found) for line in lines]
    assert said == ["Sew Arm 1 to Body, marker to marker: ar to br, au to bu, al to bl."]


def test_stuffing_has_its_moment_though_nobody_says_it_and_two_greens_have_two_names() -> None:
    said = words(make(Text(MARKED, "toy.acl"), CrochetParams(solver="none"), Progress()).built, exact=False)
    body, arm = ([row.words for row in part.lines] for part in said.parts)
    assert body.index("Stuff.") < next(k for k, row in enumerate(body) if "fasten off" in row)
    assert "Stuff." not in arm  # it ends as wide as it is: an open tube
    assert [name for _, name, _, _ in said.colors] == ["green", "ivory"]
