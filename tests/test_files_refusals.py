"""Every reader's sentence for what it will not take: one small file each; and odd files that are read all the same, with what they come to."""

from __future__ import annotations

import io
import json
import struct
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from tambour import files
from tambour.core.chart import Chart
from tambour.core.drawing import Drawing
from tambour.core.errors import TambourError, Text
from tambour.core.palette import Palette
from tambour.core.thread import COLOR, END, STITCH, Thread, ThreadPlan
from tambour.files.records import same
from tambour.files.text import read_edits
from test_files import HOUSE
from test_files_bounds import docx, odt

KINDS = ("Chart", "Mesh", "Drawing", "ThreadPlan", "Text")


def png(mode: str, size: tuple[int, int], fill: Any = 0, **more: Any) -> bytes:
    out = io.BytesIO()
    Image.new(mode, size, fill).save(out, "PNG", **more)
    return out.getvalue()


def told(text: str) -> bytes:
    from PIL import PngImagePlugin

    note = PngImagePlugin.PngInfo()
    note.add_text("tambour", text)
    return png("P", (4, 4), 0, pnginfo=note)


def indexed(colours: int) -> bytes:
    image = Image.frombytes("P", (16, 16), bytes(range(256)))
    image.putpalette([v for k in range(256) for v in (k % colours, 0, 0)])
    out = io.BytesIO()
    image.save(out, "PNG")
    return out.getvalue()


PLY = b"ply\nformat %s 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n%send_header\n"
REFUSED: dict[str, tuple[bytes, str]] = {
    "wide.png": (png("1", (20_001, 1)), "20001 x 1 stitches are too many"),
    "faint.png": (png("RGBA", (4, 4), (9, 9, 9, 128)), "half-transparent pixels"),
    "told.png": (told('{"format": 1, "palette": [{"rgb": 5}]}'), "its text chunk is damaged"),
    "no.png": (b"\x89PNG\r\n\x1a\n", "this PNG cannot be read"),
    "signs.csv": ((",".join(chr(0x4E00 + k) for k in range(300)) + "\n").encode(), "300 different signs"),
    "deep.json": (b"[" * 100_000, "nested too deep"),
    "list.json": (b"[1]", "not a chart of tambour"),
    "half.stl": (b"solid a\nvertex 0 0 0\nvertex 1 0 0\n", "a triangle is not whole"),
    "cut.stl": (bytes(90), "its length is not what its header says"),
    "mark.vp3": (b"%vsx%" + bytes(900), "VP3"),
    "never.k": (b";!knitout-2\nx-speed 5\n", "knits no stitch"),
    "racked.k": (b";!knitout-2\nrack 1\n", "a racked bed"),
    "rack.k": (b";!knitout-2\nrack\n", '"rack" wants one number'),
    "plate.k": (b";!knitout-2\nknit + f1 1 2\n", "two carriers in one loop"),
    "moved.k": (b";!knitout-2\nxfer f1 b1\n", "is not plain knitting"),
    "empty.html": (b"<p> </p><h2></h2><table><tr><td></td></tr></table>", "this document holds no text"),
    "none.npz": (b"", "not an NPZ"),
    "zero.txt": (b"R1:\0", "holds zero bytes"),
    "nameless": (b"R1: MR(6)", "its name has no suffix"),
    "a.xyz": (b"R1: MR(6)", '".xyz" files cannot be read here'),
}


@pytest.mark.parametrize("name", REFUSED)
def test_it_says_why_in_one_line_with_the_files_name(name: str, tmp_path: Path) -> None:
    raw, words = REFUSED[name]
    (tmp_path / name).write_bytes(raw)
    with pytest.raises(TambourError, match=words) as caught:
        files.read(tmp_path / name, KINDS)
    (problem,) = caught.value.problems
    assert name in str(problem) and "\n" not in problem.message


def test_a_folder_is_no_source(tmp_path: Path) -> None:
    with pytest.raises(TambourError, match="this is a folder"):
        files.read(tmp_path, KINDS)


@pytest.mark.parametrize("name", ["a.png", "a.txt", "a.dst", "a.obj"])
def test_a_file_that_is_not_for_us_is_told(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / name).write_bytes(b"")
    monkeypatch.setattr("os.access", lambda *_: False)
    with pytest.raises(TambourError, match=rf"{name}: cannot be read: Permission denied"):
        files.read(tmp_path / name, (*KINDS, "Picture"))


def test_a_name_that_no_disk_can_hold_is_told() -> None:
    for name in ("9" * 400, "9" * 400 + ".txt"):
        with pytest.raises(TambourError, match="cannot be read: File name too long"):
            files.read(name, KINDS)


def test_a_folder_that_is_not_for_us_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def no(path: Path) -> bool:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(Path, "exists", no)
    with pytest.raises(TambourError, match=r"a\.txt: cannot be read: Permission denied"):
        files.read(tmp_path / "a.txt", KINDS)


def chart(colours: int, blank: bool) -> Chart:
    cells = np.arange(colours, dtype=np.uint8)[:, None].repeat(2, axis=1)
    rgb = np.stack([np.arange(colours)] * 3, axis=1).astype(np.uint8)
    mask = np.zeros(cells.shape, np.bool_)
    mask[0, 0] = blank
    return Chart(cells, Palette(rgb), no_stitch=mask if blank else None)


def plan(command: list[int], far: float = 1.0, threads: int = 1) -> ThreadPlan:
    n = len(command)
    xy = np.stack([np.linspace(0, far, n), np.zeros(n)], axis=1)
    which = np.cumsum(np.array(command) == COLOR).astype(np.int16)
    return ThreadPlan(xy, np.array(command, np.uint8), which, tuple(Thread((k, 0, 0)) for k in range(threads)))


UNWRITTEN: dict[str, tuple[Callable[[], Any], str]] = {
    "full.png": (lambda: chart(256, True), "256 colours and cells without stitch"),
    "sea.dst": (lambda: plan([STITCH, STITCH, END], 9000.0), "larger than 4 m"),
    "none.pes": (lambda: plan([COLOR, END], threads=2), "holds no stitch"),
    "hoop.jef": (lambda: plan([STITCH] * 900 + [END], 900.0), "the largest hoop of a JEF file"),
    "many.pes": (lambda: plan([STITCH, COLOR] * 300 + [STITCH, END], threads=301), "hold"),
    "long.hpgl": (lambda: Drawing(HOUSE.paths, HOUSE.style, HOUSE.styles, [900, 20]), "larger than HPGL can address"),
    "long.pdf": (lambda: Drawing(HOUSE.paths, HOUSE.style, HOUSE.styles, [90_000, 20]), "too long for PDF"),
}


@pytest.mark.parametrize("name", UNWRITTEN)
def test_what_a_format_cannot_hold_is_told_and_nothing_is_left(name: str, tmp_path: Path) -> None:
    value, words = UNWRITTEN[name]
    with pytest.raises(TambourError, match=words):
        files.write(value(), tmp_path / name)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("form", ["ascii", "binary_little_endian", "binary_big_endian"])
def test_polygons_with_more_beside_them_are_fans(form: str, tmp_path: Path) -> None:
    """A list of another name, a number before and one behind: four corners are two triangles."""
    lists = b"property uchar flag\nproperty list uchar int vertex_indices\nproperty list uchar short spare\nproperty float area\n"
    head = PLY.replace(b"vertex 3", b"vertex 4") % (form.encode(), lists)
    points = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0)]
    if form == "ascii":
        body = "".join(f"{x} {y} {z}\n" for x, y, z in points).encode() + b"7 4 0 1 2 3 2 8 9 4.0\n"
    else:
        order = "<" if "little" in form else ">"
        body = b"".join(struct.pack(order + "3f", *p) for p in points)
        body += struct.pack(order + "BB4iB2hf", 7, 4, 0, 1, 2, 3, 2, 8, 9, 4.0)
    (tmp_path / "a.ply").write_bytes(head + body)
    made = files.read(tmp_path / "a.ply", ("Mesh",))
    assert made.faces.tolist() == [[0, 1, 2], [0, 2, 3]] and np.allclose(made.vertices, points)


def test_a_picture_of_an_indexed_palette_is_a_chart_in_its_own_order(tmp_path: Path) -> None:
    """Two entries of one colour are one yarn."""
    image = Image.frombytes("P", (2, 2), bytes([3, 1, 2, 3]))
    image.putpalette([0, 0, 0, 200, 0, 0, 200, 0, 0, 255, 255, 255])
    image.save(tmp_path / "a.png")
    made = files.read(tmp_path / "a.png", ("Chart",))
    assert made.palette.rgb.tolist() == [[200, 0, 0], [255, 255, 255]]
    assert made.cells.tolist() == [[0, 1], [1, 0]]


def test_a_text_chunk_of_another_program_is_left_alone(tmp_path: Path) -> None:
    (tmp_path / "a.png").write_bytes(told("not json"))
    assert files.read(tmp_path / "a.png", ("Chart",)).shape == (4, 4)


def test_a_csv_of_broken_colours_has_signs(tmp_path: Path) -> None:
    (tmp_path / "a.csv").write_text("#12345g,#aabbcc\n#aabbcc,#12345g\n")
    made = files.read(tmp_path / "a.csv", ("Chart",))
    assert sorted(made.palette.names) == ["#12345g", "#aabbcc"]


def test_colours_of_a_profile_are_taken_as_it_says(tmp_path: Path) -> None:
    from PIL import ImageCms

    swapped = ImageCms.ImageCmsProfile(ImageCms.createProfile("sRGB")).tobytes()
    for name, profile in (("plain", swapped), ("broken", b"no profile at all")):
        Image.new("RGB", (2, 2), (200, 30, 40)).save(tmp_path / f"{name}.png", icc_profile=profile)
        made = files.read(tmp_path / f"{name}.png", ("Picture",))
        assert np.abs(made.rgba[0, 0, :3].astype(int) - [200, 30, 40]).max() <= 1, name


def test_pages_become_numbered_pictures(tmp_path: Path) -> None:
    files.write([HOUSE, HOUSE], tmp_path / "a.png", "Drawing")
    assert sorted(p.name for p in tmp_path.iterdir()) == ["a-1.png", "a-2.png"]


def test_a_chart_with_a_back_leaves_its_front(tmp_path: Path) -> None:
    cells = np.array([[0, 1], [1, 0]], np.uint8)
    two = Chart(
        cells,
        Palette(np.array([[0, 0, 0], [255, 255, 255]], np.uint8)),
        technique="jacquard",
        backing="picture",
        behind=1 - cells,
    )
    files.write(two, tmp_path / "a.png")
    back = files.read(tmp_path / "a.png", ("Chart",))
    assert np.array_equal(back.cells, cells) and back.behind is None and back.backing == "birdseye"


def test_documents_keep_breaks_tables_and_leave_notes(tmp_path: Path) -> None:
    table = "<table:table-row xmlns:table='urn:oasis:names:tc:opendocument:xmlns:table:1.0'>{}</table:table-row>"
    cell = "<table:table-cell><text:p>{}</text:p></table:table-cell>"
    body = "<text:p>Rnd 1:<text:tab/>6<text:s/>sc<text:line-break/>Rnd 2<text:note>no</text:note>: 6 inc<draw:image xlink:href='gone.png'/></text:p>"
    odt(
        tmp_path / "a.odt",
        body + table.format(cell.format("Rnd 3") + cell.format("12 sc")) + table.format(cell.format("")),
    )
    text = files.read(tmp_path / "a.odt", ("Text",)).text
    assert text.split("\n") == ["Rnd 1: 6 sc", "Rnd 2: 6 inc", "| Rnd 3 | 12 sc |", ""]


def test_a_document_that_is_locked_or_none_is_told(tmp_path: Path) -> None:
    with zipfile.ZipFile(tmp_path / "a.odt", "w") as pack:
        pack.writestr("other.xml", "<a/>")
    with pytest.raises(TambourError, match=r"a\.odt: this is no OpenDocument text"):
        files.read(tmp_path / "a.odt", ("Text",))
    docx(tmp_path / "a.docx", "<w:p/>")
    with pytest.raises(TambourError, match=r"a\.docx: this document holds no text"):
        files.read(tmp_path / "a.docx", ("Text",))


def test_pages_of_old_encodings_and_broken_pictures_are_read(tmp_path: Path) -> None:
    page = "<meta charset=nowhere-1><p>Größe: 6 fM</p><img src='data:image/png;base64,=='><img src='data:image/png;base64,A'>"
    (tmp_path / "a.html").write_bytes(page.encode("cp1252"))
    made = files.read(tmp_path / "a.html", ("Text",))
    assert made.text.strip() == "Größe: 6 fM" and not made.photos


def test_lists_and_headings_of_a_text_are_those_of_the_page(tmp_path: Path) -> None:
    files.write(Text("# Bear\n\n- <b>one</b>\n- two\nand a line\n"), tmp_path / "a.html")
    page = (tmp_path / "a.html").read_text()
    assert "<h1>Bear</h1>" in page and "<ul><li>&lt;b&gt;one&lt;/b&gt;</li><li>two</li></ul>" in page


@pytest.mark.parametrize("text", ["5", '{"craft": "knit"}', "[1", '{"edits": 5}', "[" * 100_000])
def test_what_is_no_list_of_edits_is_told(text: str, tmp_path: Path) -> None:
    (tmp_path / "e.json").write_text(text)
    with pytest.raises(TambourError, match=r"e\.json: this is no list of edits"):
        read_edits(tmp_path / "e.json")
    (tmp_path / "e.json").write_text(json.dumps({"edits": [{"edit": "x"}]}))
    assert read_edits(tmp_path / "e.json") == [{"edit": "x"}]


def test_a_list_of_edits_that_never_ends_or_cannot_be_read_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with pytest.raises(TambourError, match=r"none\.json: cannot be read: No such file"):
        read_edits(tmp_path / "none.json")
    monkeypatch.setattr("tambour.files.text.SMALL", 1000)
    with pytest.raises(TambourError, match="/dev/zero: a file of more than"):
        read_edits("/dev/zero")


def test_what_has_no_json_form_is_a_fault_of_ours(tmp_path: Path) -> None:
    with pytest.raises(TypeError, match="a Text has no JSON form"):
        files.write({"a": Text("b")}, tmp_path / "a.json")
    assert not list(tmp_path.iterdir())


def test_two_designs_are_the_same_or_it_is_said_in_which() -> None:
    xy, changes, cut = np.array([[0, 0], [9, 0]]), np.array([0, 1]), np.array([False, True])
    assert same((xy, changes, cut), (xy, changes, cut)) == ""
    assert same((xy, changes, cut), (xy[:1], changes[:1], cut[:1])) == "2 stitches became 1"
    assert same((xy, changes, cut), (xy + np.array([0, 4]), changes, cut)) == "stitches moved by up to 0.4 mm"
    assert same((xy, changes, cut), (xy, changes * 0, cut)) == "the colour changes are not where they were"
    assert same((xy, changes, cut), (xy, changes, ~cut)) == "1 trims were lost"
    assert same((xy, changes, ~cut | True), (xy, changes, cut | True)) == "", "a cut more is no difference"
