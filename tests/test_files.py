"""Files: what is written can be read by somebody else, and what is broken is refused in one line."""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
import pypdfium2
import pytest
from PIL import Image

from tambour import files
from tambour.core.drawing import Drawing, Groups, Label, Placed, Styles
from tambour.core.errors import TambourError, Text
from tambour.core.paths import Paths
from tambour.core.picture import Picture
from tambour.files.picture import read_picture
from tambour.files.svg import write as svg

HOUSE = Drawing(
    Paths(
        [[1, 1], [9, 1], [9, 9], [1, 9], [1, 1], [3, 3], [3, 6], [6, 6], [3, 3], [0, 0], [10, 1 / 3]],
        [0, 5, 9, 11],
    ),
    [0, 1, 2],
    Styles.of(((200, 80, 80, 255), None, 0), ((255, 255, 255, 128), None, 0), (None, (0, 0, 0, 255), 0.5)),
    [10, 10],
    [0, 1, 0],
    Groups(("a", "b"), ("Ground", "Win & dow"), [-1, 0], [True, False]),
    labels=(Label("6 < 7", 5, 9.5, 1, "middle"),),
    about={"title": "A & B", "seed": "7"},
)
HOLED = Drawing(Paths(HOUSE.paths.coords[:9], [0, 5, 9], [0, 2]), [0], Styles.of(((0, 0, 0, 255), None, 0)), [10, 10])


def test_svg_says_what_the_drawing_holds() -> None:
    text = svg.text(HOUSE)
    assert 'width="10mm" height="10mm" viewBox="0 0 10 10" data-seed="7"' in text
    assert "<title>A &amp; B</title>" in text
    assert text.count("<g ") == text.count("</g>") == 2
    assert '<g id="a" inkscape:groupmode="layer" inkscape:label="Ground">' in text
    assert 'd="M1,1L9,1L9,9L1,9Z" fill="#c85050"' in text
    assert 'fill-opacity="0.502"' in text
    assert "M0,0L10,0.333" in text
    assert "6 &lt; 7" in text
    assert svg.text(HOLED).count("M") == 2


def test_a_stream_of_drawings_is_one_svg(tmp_path: Path) -> None:
    files.write(iter([HOUSE, HOUSE]), tmp_path / "a.svg", "Drawing")
    text = (tmp_path / "a.svg").read_text()
    assert text.count("<svg") == text.count("</svg>") == 1
    assert text.count("<path") == 6
    assert text.count('id="a"') == 1, "an id stands once in a file"


def test_numbers_are_short_and_never_negative_zero() -> None:
    assert [svg.number(x) for x in (0.0, -0.0001, 1.5, 100.0, -2.25, 1 / 3)] == [
        "0",
        "0",
        "1.5",
        "100",
        "-2.25",
        "0.333",
    ]
    assert svg.number(1200.0, 0) == "1200"


def test_pdf_pages_have_their_true_size_and_show_the_drawing(tmp_path: Path) -> None:
    path = tmp_path / "a.pdf"
    files.write((HOUSE, HOLED), path, "Drawing")
    pages = pypdfium2.PdfDocument(path)
    assert len(pages) == 2
    wide = 10 * 72 / 25.4
    assert all(wide <= side < wide + 1 for side in pages[0].get_size()), "whole points, nothing cut off"
    assert "6 < 7" in pages[0].get_textpage().get_text_bounded()
    shown = pages[1].render(scale=4).to_numpy()[..., :3]
    mm = 4 * 72 / 25.4
    middle = shown[int(4.5 * mm), int(3.6 * mm)]
    assert middle.min() > 250, "the hole is open"
    dark = (1 - shown.mean(axis=2) / 255).sum() / mm**2
    assert dark == pytest.approx(64 - 4.5, abs=0.3), "and everything stands at its true size"
    pages.close()
    first = path.read_bytes()
    files.write((HOUSE, HOLED), path, "Drawing")
    assert path.read_bytes() == first, "no dates, no ids of the day"


def test_a_drawing_becomes_the_pixels_it_describes(tmp_path: Path) -> None:
    files.write(HOLED, tmp_path / "a.png")
    made = read_picture(tmp_path / "a.png")
    size = made.rgba.shape[0]
    assert made.rgba.shape == (size, size, 4)
    assert made.pixel == pytest.approx(10 / size, rel=1e-3)
    covered = (made.rgba[..., 3] / 255).mean()
    assert covered == pytest.approx((64 - 4.5) / 100, abs=2e-3)


def test_placed_pictures_lie_under_the_shapes(tmp_path: Path) -> None:
    red = Picture(np.full((2, 2, 4), [255, 0, 0, 255], np.uint8))
    drawing = Drawing(Paths.of([]), [], Styles.of(), [4, 4], images=(Placed(red, 1, 1, 2, 2),))
    files.write(drawing, tmp_path / "a.png")
    rgba = read_picture(tmp_path / "a.png").rgba
    assert tuple(rgba[rgba.shape[0] // 2, rgba.shape[1] // 2]) == (255, 0, 0, 255)
    assert rgba[2, 2, 3] == 0
    assert "data:image/png;base64," in svg.text(drawing)


@pytest.mark.parametrize("suffix", [".png", ".webp", ".tif", ".bmp", ".jpg"])
def test_pictures_come_back(tmp_path: Path, suffix: str) -> None:
    rgba = np.zeros((5, 7, 4), np.uint8)
    rgba[..., 3] = 255
    rgba[:, 3:, 0] = 200
    files.write(Picture(rgba), tmp_path / f"a{suffix}")
    back = read_picture(tmp_path / f"a{suffix}").rgba
    assert back.shape == rgba.shape
    assert np.abs(back.astype(int) - rgba).max() <= (60 if suffix == ".jpg" else 0)


def test_the_orientation_tag_is_honoured(tmp_path: Path) -> None:
    image = Image.new("RGB", (6, 3))
    image.putpixel((0, 0), (255, 0, 0))
    exif = Image.Exif()
    exif[0x0112] = 6  # the camera was turned: rotate by 90 degrees clockwise
    image.save(tmp_path / "a.png", exif=exif)
    made = read_picture(tmp_path / "a.png").rgba
    assert made.shape[:2] == (6, 3)
    assert tuple(made[0, 2]) == (255, 0, 0, 255)


def test_sixteen_bits_become_eight(tmp_path: Path) -> None:
    Image.fromarray(np.array([[0, 65535, 32768]], np.uint16)).save(tmp_path / "a.png")
    assert read_picture(tmp_path / "a.png").rgba[0, :, 0].tolist() == [0, 255, 128]


def test_broken_pictures_are_one_line(tmp_path: Path) -> None:
    raw = io.BytesIO()
    Image.new("RGB", (64, 64), "red").save(raw, "PNG")
    whole = raw.getvalue()
    for k, data in enumerate([b"", b"hello", whole[:60], whole[:100] + b"\0" * 40, b"GIF89a" + b"\xff" * 30]):
        path = tmp_path / f"{k}.png"
        path.write_bytes(data)
        with pytest.raises(TambourError) as caught:
            files.read(path, ("Picture",))
        assert str(path) in str(caught.value)
        assert str(caught.value).count("\n") == 0


def test_missing_and_unknown_files_say_what_to_do(tmp_path: Path) -> None:
    (tmp_path / "frog.acl").write_text("R1: MR(6)")
    with pytest.raises(TambourError, match=r'no such file\n {2}did you mean "frog.acl"'):
        files.read(tmp_path / "forg.acl", ("Text",))
    with pytest.raises(TambourError, match=r"cannot be read here\n {2}these can: .*acl"):
        files.read(tmp_path / "frog.xyz", ("Text",))
    with pytest.raises(TambourError, match="folder"):
        (tmp_path / "dir.acl").mkdir()
        files.read(tmp_path / "dir.acl", ("Text",))
    with pytest.raises(TambourError, match="zero bytes"):
        (tmp_path / "b.acl").write_bytes(b"a\0b")
        files.read(tmp_path / "b.acl", ("Text",))
    with pytest.raises(TambourError, match="cannot be written"):
        files.write(HOUSE, tmp_path / "a.xyz")


def test_texts_are_read_whatever_their_ends_and_marks(tmp_path: Path) -> None:
    path = tmp_path / "a.txt"
    path.write_bytes("\ufeffeins\r\nzwei\rdrei ä".encode())
    assert files.read(path, ("Text",)) == Text("eins\nzwei\ndrei ä", str(path))
    path.write_bytes(b"caf\xe9")
    assert files.read(path, ("Text",)).text == "café"
    for order in ("utf-16-le", "utf-16-be"):
        path.write_bytes("\ufeffeins\r\nzwei ä".encode(order))
        assert files.read(path, ("Text",)).text == "eins\nzwei ä"
        path.write_bytes("\ufeffeins".encode(order) + b"\0")  # cut within a letter
        with pytest.raises(TambourError, match="zero bytes"):
            files.read(path, ("Text",))


def test_every_table_entry_exists() -> None:
    for name in [*files.WRITE.values(), *(n for kinds in files.READ.values() for n in kinds.values())]:
        assert callable(files._load(name)), name


def test_a_phones_pictures_are_read_upright(root: Path, tmp_path: Path) -> None:
    from PIL import Image

    pytest.importorskip("pi_heif")
    photo = files.read(root / "tests" / "data" / "phone.heic", ("Picture",))  # made lying, 64 x 48, with tag 6
    assert photo.rgba.shape == (64, 48, 4)
    top, bottom = photo.rgba[12, 20, :3].astype(int), photo.rgba[52, 20, :3].astype(int)
    assert top[0] > top[2] + 80 and bottom[2] > bottom[0] + 80
    Image.fromarray(photo.rgba[..., :3]).save(tmp_path / "a.avif")
    assert np.abs(files.read(tmp_path / "a.avif", ("Picture",)).rgba.astype(int) - photo.rgba).mean() < 8
