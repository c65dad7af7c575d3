"""Every reader has a bound, and says so in place of going on: the bounds made small, each meets a file beyond it; and small files that ask for much."""

from __future__ import annotations

import io
import json
import signal
import struct
import zipfile
import zlib
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tambour import files
from tambour.core.errors import TambourError
from test_files_sink import value

NEST = "<g>" * 9 + '<path d="M0 0h9v9z"/>' + "</g>" * 9
SVG = (
    '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 90 90" width="90mm" height="90mm">'
    f'<g id="a">{NEST}<circle cx="5" cy="5" r="4"/></g><use href="#a"/><use href="#a" x="9"/></svg>'
)
MESHES = [f".{kind}" for kind in ("obj", "ply", "stl", "npz", "glb")]
BOUNDS = [
    *(("", "LARGEST", 10, f"a{suffix}") for suffix in (".obj", ".ply", ".stl", ".k", ".json", ".csv", ".html", ".pdf")),
    *(("", "MOVING", 10, f"a{suffix}") for suffix in (".npz", ".glb")),
    *(("text", "WORDS", 10, f"a{suffix}") for suffix in (".acl", ".txt", ".md")),
    *(("document", "WORDS", 10, f"whole{suffix}") for suffix in (".html", ".docx", ".odt")),
    ("sequence", "MOVING", 10, "a.npz"),
    ("printed_pdf", "SECONDS", 0, "a.pdf"),
    ("printed_pdf", "MEMORY", 10**6, "a.pdf"),
    ("usd", "SECONDS", 0, "a.usda"),
    pytest.param("", "MOVING", 10, "a.usda", marks=pytest.mark.slow),
    pytest.param("usd", "MEMORY", 10**6, "a.usda", marks=pytest.mark.slow),
    ("picture", "LARGEST", 100, "a.png"),
    ("svg.tree", "LARGEST", 100, "a.svg"),
    ("svg.tree", "MOST", 5, "a.svg"),
    ("svg.tree", "DEEPEST", 6, "a.svg"),
    ("svg.read", "POINTS", 8, "a.svg"),
    ("svg.read", "COPIES", 1, "a.svg"),
    ("records", "_LARGEST", 100, "a.dst"),
    ("records", "_LARGEST", 100, "a.pes"),
    ("gltf", "_MOST_NODES", 0, "a.glb"),
    ("gltf", "_MOST_VALUES", 2, "a.glb"),
    ("document", "_MOST", 100, "a.docx"),
    ("document", "_MOST", 100, "a.odt"),
    ("font", "LARGEST", 1000, "a.otf"),
]


def laid(path: Path, root: Path) -> Path:
    """A plain file of the kind, small as such files go."""
    if path.suffix == ".svg":
        path.write_text(SVG)
    elif path.suffix == ".otf":
        path.write_bytes((root / "src/tambour/render/fonts/Inter-Regular.otf").read_bytes())
    elif path.stem == "whole":
        whole(path)
    elif path.suffix in (".docx", ".odt"):
        with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as made:
            made.writestr("word/document.xml" if path.suffix == ".docx" else "content.xml", "<a>" + "x" * 4000 + "</a>")
    else:
        kinds = {
            ".png": "Picture",
            ".csv": "Chart",
            ".json": "Chart",
            **dict.fromkeys(MESHES, "Mesh"),
            ".npz": "Scene",
            ".usda": "Scene",
        }
        kinds |= dict.fromkeys((".acl", ".txt", ".md", ".k", ".html", ".pdf"), "Text")
        kind = kinds.get(path.suffix, "ThreadPlan")
        files.write(value(kind), path, kind)
        if path.suffix == ".k":
            path.write_text(";!knitout-2\ntuck + f1 1\nknit + f1 1\n")
    return path


def whole(path: Path) -> None:
    """A document with a line of text."""
    if path.suffix == ".html":
        path.write_text("<p>Rnd 1: 6 sc in magic ring</p>")
    elif path.suffix == ".docx":
        import docx

        made = docx.Document()
        made.add_paragraph("Rnd 1: 6 sc in magic ring")
        made.save(str(path))
    else:
        odt(path, "<text:p>Rnd 1: 6 sc in magic ring</text:p>")


def odt(path: Path, body: str, picture: int = 0) -> None:
    spaces = "".join(
        f' xmlns:{short}="urn:oasis:names:tc:opendocument:xmlns:{long}:1.0"'
        for short, long in (("office", "office"), ("text", "text"), ("draw", "drawing"))
    )
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as made:
        made.writestr(
            "content.xml",
            f'<office:document-content{spaces} xmlns:xlink="http://www.w3.org/1999/xlink">{body}</office:document-content>',
        )
        made.writestr("Pictures/a.png", bytes(picture))


def read(path: Path) -> Any:
    if path.suffix == ".otf":
        from tambour.files.font import read_font

        return read_font(path)
    return files.read(
        path, ("Picture", "Drawing", "ThreadPlan", "Mesh", "Chart", "Text") if path.suffix != ".png" else ("Picture",)
    )


@pytest.mark.parametrize(("module", "bound", "small", "name"), BOUNDS)
def test_what_is_beyond_a_readers_bound_is_refused_with_its_place(
    module: str, bound: str, small: int, name: str, root: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    if name.endswith(".usda"):
        pytest.importorskip("pxr")
    path = laid(tmp_path / name, root)
    if path.suffix not in (".docx", ".odt") or path.stem == "whole":  # the others are no documents, but their packing
        read(path)
    monkeypatch.setattr(import_module(f"tambour.files.{module}".rstrip(".")), bound, small)
    with pytest.raises(TambourError) as caught:
        read(path)
    assert str(path) in str(caught.value) and len(caught.value.problems) == 1, str(caught.value)


@pytest.fixture
def soon() -> Iterator[None]:
    """What would take a processor for ever fails in place of it."""

    def late(*_: Any) -> None:
        raise AssertionError("ten seconds of a processor, for a file of some kilobytes")

    before = signal.signal(signal.SIGVTALRM, late)
    signal.setitimer(signal.ITIMER_VIRTUAL, 10)
    yield
    signal.setitimer(signal.ITIMER_VIRTUAL, 0)
    signal.signal(signal.SIGVTALRM, before)


def ply(count: int, lists: bytes) -> bytes:
    head = (
        "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    )
    more = f"element face {count}\nproperty list char int vertex_indices\nend_header\n"
    return (head + more).encode() + bytes(36) + lists


def npz(shape: tuple[int, ...], held: int) -> bytes:
    """An archive whose array claims a shape, and holds so many bytes of zeros, well packed."""
    head, made = io.BytesIO(), io.BytesIO()
    np.lib.format.write_array_header_1_0(head, {"descr": "<f8", "fortran_order": False, "shape": shape})
    with zipfile.ZipFile(made, "w", zipfile.ZIP_DEFLATED) as packed:
        packed.writestr("points.npy", head.getvalue() + bytes(held))
    return made.getvalue()


def pack(count: int) -> bytes:
    """Arrays that all lie over the same bytes."""
    named = {f"a{k}": {"dtype": "f4", "shape": [250_000], "offset": 0} for k in range(count)}
    head = json.dumps({"arrays": named, "facts": {}}).encode()
    head += b" " * (-len(head) % 8)
    return b"TAMBPACK" + struct.pack("<II", 1, len(head)) + head + bytes(1_000_000)


def docx(path: Path, body: str) -> None:
    """A Word document with this body."""
    whole(path)
    with zipfile.ZipFile(path) as packed:
        parts = {name: packed.read(name) for name in packed.namelist()}
    space = 'xmlns:w="http://schemas.openxmlformats.org/wordprocessingml/2006/main"'
    parts["word/document.xml"] = f"<w:document {space}><w:body>{body}</w:body></w:document>".encode()
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as packed:
        for name, raw in parts.items():
            packed.writestr(name, raw)


CELL = "<w:tc><w:tcPr><w:{}/></w:tcPr><w:p><w:r><w:t>6 sc</w:t></w:r></w:p></w:tc>"
TABLE = "<w:tbl><w:tblGrid><w:gridCol/></w:tblGrid>{}</w:tbl>"
MERGED = (
    "<w:tr>" + CELL.format("vMerge w:val='restart'") + "</w:tr>" + 2000 * ("<w:tr>" + CELL.format("vMerge") + "</w:tr>")
)
MUCH: dict[str, tuple[Any, str]] = {
    "groups.obj": ("v 0 0 0\nv 1 0 0\nv 0 1 0\n" + "".join(f"g a{k}\n" for k in range(60_000)) + "f 1 2 3\n", ""),
    "back.ply": (ply(10**9, b"\xff" * 20_000), "a list of -1"),
    "claims.ply": (ply(10**12, b""), "cannot|not a PLY|not whole|buffer"),
    "claims.npz": (npz((10**10, 3), 100), "not an NPZ|more than"),
    "over.pack": (pack(5000), "cut off or damaged"),
    "words.k": (";!knitout-2\n" + "".join(f"word{k} 1\n" for k in range(8_000)), "no operation"),
    "open.html": ("<p>6 sc</p>" + "<a " * 40_000, ""),
    "comments.html": ("<p>6 sc</p>" + "<!--" * 60_000, ""),
    "strange.html": ("<p>6 sc</p><![ <![ >", "damaged"),
    "puny.html": ("<meta charset=punycode><p>" + "a-" + "b" * 90_000, ""),
    "shown.html": ("<p>6 sc</p>" + "<img src='big.png'>" * 2000, "pictures take more"),
    "deep.odt": ("<text:section>" * 5000 + "<text:p>6 sc</text:p>" + "</text:section>" * 5000, "too deep"),
    "spans.odt": ("<text:p>" + "<text:span>" * 5000 + "6 sc" + "</text:span>" * 5000 + "</text:p>", "too deep"),
    "shown.odt": ("<text:p>6 sc<draw:image xlink:href='Pictures/a.png'/></text:p>" * 2000, "pictures take more"),
    "wide.docx": (TABLE.format("<w:tr>" + CELL.format("gridSpan w:val='100000000'") + "</w:tr>"), ""),
    "merged.docx": (TABLE.format(MERGED), ""),
    "deep.docx": ("<w:p>" + "<w:r>" * 5000 + "<w:t>6 sc</w:t>" + "</w:r>" * 5000 + "</w:p>", "no Word document"),
    "paragraphs.docx": ("<w:p><w:r><w:t>6 sc</w:t></w:r></w:p>" * 4000, ""),
}


@pytest.mark.parametrize("name", MUCH)
def test_a_small_file_that_asks_for_much_is_read_or_refused_soon(name: str, tmp_path: Path, soon: None) -> None:
    made, words = MUCH[name]
    path = tmp_path / name
    (tmp_path / "big.png").write_bytes(bytes(200_000))
    if path.suffix == ".odt":
        odt(path, made, 200_000)
    elif path.suffix == ".docx":
        docx(path, made)
    else:
        path.write_bytes(made if isinstance(made, bytes) else made.encode())
    kinds = ("Mesh", "Packed", "Chart", "Text")
    if not words:
        assert files.read(path, kinds) is not None
        return
    with pytest.raises(TambourError, match=words) as caught:
        files.read(path, kinds)
    assert str(path) in str(caught.value)


@pytest.mark.parametrize("at", [0, 40])
def test_a_document_whose_archive_is_damaged_is_refused(at: int, tmp_path: Path) -> None:
    path = tmp_path / "a.odt"
    odt(path, "<text:p>Rnd 1: 6 sc in magic ring</text:p>" * 50)
    raw = bytearray(path.read_bytes())
    raw[at : at + 30] = bytes(30)  # the head of its first file, or what is packed in it
    path.write_bytes(raw)
    with pytest.raises(TambourError, match="damaged"):
        files.read(path, ("Text",))


def test_a_page_whose_character_set_is_none_is_read_as_it_stands(tmp_path: Path) -> None:
    path = tmp_path / "a.html"
    path.write_text("<meta charset=punycode><p>a-b: 6 sc</p>")
    assert files.read(path, ("Text",)).text.strip() == "a-b: 6 sc"


def pdf(path: Path, *objects: bytes) -> None:
    """A PDF of one page whose objects follow the fifth, its typeface."""
    first = (b"<</Type/Catalog/Pages 2 0 R>>", b"<</Type/Pages/Kids[3 0 R]/Count 1>>")
    page = b"<</Type/Page/Parent 2 0 R/MediaBox[0 0 600 800]/Contents 4 0 R/Resources<</Font<</F 5 0 R>>/XObject<</A 6 0 R>>>>>>"
    raw, at = b"%PDF-1.7\n", []
    for number, each in enumerate((*first, page, *objects), 1):
        at.append(len(raw))
        raw += f"{number} 0 obj\n".encode() + each + b"\nendobj\n"
    table = f"xref\n0 {len(at) + 1}\n0000000000 65535 f \n" + "".join(f"{k:010d} 00000 n \n" for k in at)
    path.write_bytes(raw + f"{table}trailer<</Size {len(at) + 1}/Root 1 0 R>>\nstartxref\n{len(raw)}\n%%EOF".encode())


def stream(head: str, data: bytes) -> bytes:
    packed = zlib.compress(data, 9)
    return f"<<{head}/Length {len(packed)}/Filter/FlateDecode>>stream\n".encode() + packed + b"\nendstream"


FONT = b"<</Type/Font/Subtype/Type1/BaseFont/Helvetica>>"
TEXT = b"BT /F 12 Tf 50 700 Td (Rnd 1: 6 sc in magic ring) Tj ET "


def test_a_picture_that_claims_any_size_is_left_out_of_a_pdf(tmp_path: Path) -> None:
    image = "/Type/XObject/Subtype/Image/Width 40000/Height 40000/ColorSpace/DeviceGray/BitsPerComponent 1"
    path = tmp_path / "a.pdf"
    pdf(path, stream("", TEXT + b"q 300 0 0 300 50 100 cm /A Do Q"), FONT, stream(image, bytes(10_000)))
    made = files.read(path, ("Text",))
    assert made.text == "Rnd 1: 6 sc in magic ring\n" and not made.photos


@pytest.mark.slow
def test_forms_within_forms_of_a_pdf_end_at_its_bound(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Ten times ten times … a line of text: nothing but the end of its process ends such a page."""
    monkeypatch.setattr("tambour.files.printed_pdf.MEMORY", 400_000_000)
    forms = [
        stream(
            f"/Type/XObject/Subtype/Form/BBox[0 0 600 800]/Resources<</Font<</F 5 0 R>>/XObject<</A {k + 1} 0 R>>>>",
            b"/A Do " * 10 if k < 13 else TEXT,
        )
        for k in range(6, 14)
    ]
    path = tmp_path / "a.pdf"
    pdf(path, stream("", b"/A Do " * 10), FONT, *forms)
    with pytest.raises(TambourError, match="asks for more than") as caught:
        files.read(path, ("Text",))
    assert str(path) in str(caught.value)


TRIANGLE = 'def Mesh "m" {{\n point3f[] points = [(0, 0, 0), ({}, 0, 0), (0, 1, 0)]\n int[] faceVertexCounts = [{}]\n int[] faceVertexIndices = [0, 1, {}]\n }}\n'


@pytest.mark.parametrize(
    ("far", "counts", "last", "words"),
    [
        ("1", "2000000000", "2", "other corners than it counts"),
        ("1", "-3, 6", "2", "other corners than it counts"),
        ("1", "3", "3", "points that are not there"),
        ("nan", "3", "2", "NaN"),
        ("1", "3", "2", ""),
    ],
)
def test_what_a_usd_file_claims_is_held_against_what_it_has(
    far: str, counts: str, last: str, words: str, tmp_path: Path
) -> None:
    pytest.importorskip("pxr")
    from tambour.files.usd import unpack

    path = tmp_path / "a.usda"
    path.write_text("#usda 1.0\n" + TRIANGLE.format(far, counts, last))
    if not words:
        assert unpack(path, str(tmp_path))["frames"] == 1
        return
    with pytest.raises(TambourError, match=words):
        unpack(path, str(tmp_path))


def test_the_frames_of_a_usd_file_are_bounded_and_of_the_same_points(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip("pxr")
    from tambour.files import usd

    path = tmp_path / "a.usda"
    three, two = "[(0, 0, 0), (1, 0, 0), (0, 1, 0)]", "[(0, 0, 0), (1, 0, 0)]"

    def moving(*frames: str) -> str:
        samples = ",\n".join(f"{k}: {frame}" for k, frame in enumerate(frames))
        still = TRIANGLE.format(1, 3, 2).removesuffix("}\n")
        return f"#usda 1.0\n{still}point3f[] points.timeSamples = {{\n{samples}\n}}\n}}\n"

    path.write_text(moving(three, two))
    with pytest.raises(TambourError, match="not of the same points"):
        usd.unpack(path, str(tmp_path))
    path.write_text(moving(three, three))
    assert usd.unpack(path, str(tmp_path))["frames"] == 2
    monkeypatch.setattr(usd, "MOVING", 100)
    with pytest.raises(TambourError, match="frames take more"):
        usd.unpack(path, str(tmp_path))


@pytest.mark.slow
def test_references_within_references_of_a_usd_file_end_at_its_bound(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Two times two times … a triangle, forty times: composing them is the library's, and never ends."""
    pytest.importorskip("pxr")
    monkeypatch.setattr("tambour.files.usd.SECONDS", 2)
    each = 'def Xform "a{0}" {{\n def "x" (references = </a{1}>) {{}}\n def "y" (references = </a{1}>) {{}}\n }}\n'
    path = tmp_path / "a.usda"
    nodes = "".join(each.format(k, k + 1) for k in range(40))
    path.write_text("#usda 1.0\n" + nodes + TRIANGLE.format(1, 3, 2).replace('"m"', '"a40"'))
    with pytest.raises(TambourError, match="asks for more than") as caught:
        files.read(path, ("Mesh",))
    assert str(path) in str(caught.value)
