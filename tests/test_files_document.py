"""Documents as text: headings, lists, tables and photos in order; columns, running heads and page numbers of PDFs."""

import io
import zipfile
from pathlib import Path

import docx
import pytest
import skia
from PIL import Image

from tambour import files
from tambour.core.errors import TambourError, Text
from tambour.crochet.graph.build import build
from tambour.crochet.printed.choose import read
from tambour.files.document import read_docx, read_html

ROUNDS = ["Rnd 1: 6 sc in magic ring (6)", "Rnd 2: inc x 6 (12)", "Rnd 3: (sc, inc) x 6 (18)"]


def photo():
    out = io.BytesIO()
    Image.new("RGB", (200, 160), (200, 90, 60)).save(out, "PNG")
    return out.getvalue()


def counts(text):
    return [r.count for r in build(read(text)).rounds]


def test_word_documents_in_order(tmp_path):
    made = docx.Document()
    made.add_heading("Ball", 0)
    made.add_paragraph("A small ball.")
    made.add_picture(io.BytesIO(photo()))
    made.add_heading("Body", 1)
    for line in ROUNDS[:2]:
        made.add_paragraph(line)
    table = made.add_table(1, 3)
    for cell, words in zip(table.rows[0].cells, ("Rnd 3", "(sc, inc) x 6", "(18)")):
        cell.text = words
    made.add_paragraph("Weave in the ends", style="List Bullet")
    made.save(tmp_path / "ball.docx")
    text = files.read(tmp_path / "ball.docx", ("Text",))
    lines = [line for line in text.text.split("\n") if line]
    assert lines == [
        "## Ball",
        "A small ball.",
        "## Body",
        *ROUNDS[:2],
        "| Rnd 3 | (sc, inc) x 6 | (18) |",
        "- Weave in the ends",
    ]
    ((at, data),) = text.photos
    assert text.text[:at].rstrip().endswith("ball.") and data == photo()
    assert counts(text) == [6, 12, 18]


def test_a_table_that_only_lays_out_is_lines_and_keeps_its_photos(tmp_path):
    made = docx.Document()
    made.add_heading("Ball", 0)
    left, right = made.add_table(1, 2).rows[0].cells
    left.text, right.text = "Materials\nYarn: A = brown\n3.5 mm hook", "Abbreviations\nsc = single crochet"
    right.paragraphs[-1].add_run().add_picture(io.BytesIO(photo()))
    for line in ("Body", *(f"☐ {line}" for line in ROUNDS)):
        made.add_paragraph(line)
    made.save(tmp_path / "ball.docx")
    text = files.read(tmp_path / "ball.docx", ["Text"])
    assert "Materials\nYarn: A = brown\n3.5 mm hook\nAbbreviations\nsc = single crochet\n" in text.text
    assert len(text.photos) == 1 and counts(text) == [6, 12, 18]


@pytest.mark.parametrize(
    "words",
    [
        "Ball\n\n📌 Body\nRnd 1: 6 sc\u200b in magic ring (6)\nRnd 2: inc x 6 (12)\nRnd 3: (sc, inc) x 6 (18)\n",
        "Ball\n\n\ufeffBody\n✔️ Rnd 1: 6 sc in magic ring (6)\n✔️ Rnd 2: inc\u200d x 6 (12)\n✔️ Rnd 3: (sc, inc) x 6 (18)\n",
        "Ball\n\nBody\nRnd 1 6 sc in magic ring (6)\nRnd 2 inc x 6 (12)\nRnd 3 (sc, inc) x 6 (18)\n",
    ],
)
def test_pictures_and_signs_of_no_width_in_a_pasted_text(words):
    pattern = read(Text(words, "ball.txt"))
    assert not pattern.unread and [r.count for r in build(pattern).rounds] == [6, 12, 18]
    assert [part.name for part in pattern.parts] == ["Body"]


def test_tracked_changes_are_read_as_accepted_and_told(tmp_path):
    from docx.oxml import parse_xml
    from docx.oxml.ns import nsdecls

    made = docx.Document()
    for line in ("Ball", *ROUNDS[:1]):
        made.add_paragraph(line)
    run = "<w:r><w:t xml:space='preserve'>{}</w:t></w:r>"
    rounds = (
        run.format("Rnd 2: ")
        + f"<w:ins w:id='1'>{run.format('2 sc in each sc around ')}</w:ins>"
        + "<w:del w:id='2'><w:r><w:delText>3 sc in each sc around </w:delText></w:r></w:del>"
        + f"<w:moveFrom w:id='3'>{run.format('6 times')}</w:moveFrom>"
        + f"<w:sdt><w:sdtPr/><w:sdtContent>{run.format('(12)')}</w:sdtContent></w:sdt>"
    )
    made.element.body.insert(2, parse_xml(f"<w:p {nsdecls('w')}>{rounds}</w:p>"))
    framed = f"<w:sdt {nsdecls('w')}><w:sdtContent><w:p>{run.format('Rnd 3: (sc, inc) x 6 (18)')}</w:p></w:sdtContent></w:sdt>"
    made.element.body.insert(3, parse_xml(framed))
    made.save(tmp_path / "ball.docx")
    text = files.read(tmp_path / "ball.docx", ("Text",))
    assert counts(text) == [6, 12, 18] and text.told == (
        "tracked changes, 3: it is read as if all of them were accepted",
    )
    assert text.told[0] in [p.message for p in read(text).warnings]
    made.element.body.remove(made.element.body[2])
    made.save(tmp_path / "ball.docx")
    assert files.read(tmp_path / "ball.docx", ("Text",)).told == ()


def test_opendocument_texts(tmp_path):
    spaces = ' xmlns:office="urn:oasis:names:tc:opendocument:xmlns:office:1.0"'
    spaces += ' xmlns:text="urn:oasis:names:tc:opendocument:xmlns:text:1.0"'
    body = "<text:h>Ball</text:h>" + "".join(f"<text:p>{line}</text:p>" for line in ROUNDS)
    body += "<text:list><text:list-item><text:p>Stuff<text:s/>it</text:p></text:list-item></text:list>"
    head = f'<?xml version="1.0"?><office:document-content{spaces}><office:body><office:text>'
    with zipfile.ZipFile(tmp_path / "ball.odt", "w") as pack:
        pack.writestr("content.xml", f"{head}{body}</office:text></office:body></office:document-content>")
    text = files.read(tmp_path / "ball.odt", ("Text",))
    assert [line for line in text.text.split("\n") if line] == ["## Ball", *ROUNDS, "- Stuff it"]
    assert counts(text) == [6, 12, 18]


def test_entities_of_an_opendocument_text_are_refused(tmp_path):
    bomb = '<?xml version="1.0"?><!DOCTYPE a [<!ENTITY b "c">]><a>&b;</a>'
    with zipfile.ZipFile(tmp_path / "bomb.odt", "w") as pack:
        pack.writestr("content.xml", bomb)
    with pytest.raises(TambourError, match="no OpenDocument"):
        files.read(tmp_path / "bomb.odt", ("Text",))


def test_saved_pages_of_the_web(tmp_path):
    rows = "".join(f"<tr><td>{a}</td><td>{b}</td></tr>" for a, b in (line.split(": ") for line in ROUNDS))
    (tmp_path / "one.png").write_bytes(photo())
    page = "<html><head><title>t</title><script>var Rnd = 4;</script></head><body><nav>Menu</nav><h2>Ball</h2>"
    page += f'<p>It is<br>small &amp; red.</p><img src="one.png"><img src="../two.png"><table>{rows}</table><ol><li>one<li>two</ol>'
    (tmp_path / "ball.html").write_text(page)
    text = files.read(tmp_path / "ball.html", ("Text",))
    assert [line for line in text.text.split("\n") if line] == [
        "## Ball",
        "It is",
        "small & red.",
        *(f"| {line.replace(': ', ' | ')} |" for line in ROUNDS),
        "1. one",
        "2. two",
    ]
    assert [data for _, data in text.photos] == [photo()]
    assert counts(text) == [6, 12, 18]


def write_pdf(path, pages):
    stream = skia.FILEWStream(str(path))
    with skia.PDF.MakeDocument(stream) as made:
        for words in pages:
            with made.page(400, 600) as canvas:
                for x, y, size, line in words:
                    canvas.drawString(line, x, y, skia.Font(skia.Typeface(""), size), skia.Paint())
    stream.flush()


def test_pdfs_with_columns_heads_and_page_numbers(tmp_path):
    left = ["Materials for this small ball are", "yarn, a hook of 3 mm and fibre.", "It is quite easy to make it."]
    right = ["The notes stand on this side,", "right beside the other lines,", "and they are read after them."]
    pages = []
    for k in range(3):
        page = [(30, 25, 8, "Ball by Anna"), (190, 590, 8, f"{k + 1}")]
        if k == 0:
            page += [(30, 70, 20, "Ball")]
            page += [(30, 120 + 14 * i, 10, line) for i, line in enumerate(left)]
            page += [(220, 120 + 14 * i, 10, line) for i, line in enumerate(right)]
        elif k == 1:
            cells = (
                ("Rnd 1", "6 sc in magic ring", "(6)"),
                ("Rnd 2", "inc x 6", "(12)"),
                ("Rnd 3", "(sc, inc) x 6", "(18)"),
            )
            page += [(x, 100 + 16 * i, 10, w) for i, row in enumerate(cells) for x, w in zip((30, 90, 300), row)]
        else:
            page += [(30, 100, 10, "Weave in the ends.")]
        pages.append(page)
    write_pdf(tmp_path / "ball.pdf", pages)
    text = files.read(tmp_path / "ball.pdf", ("Text",))
    lines = [line for line in text.text.split("\n") if line]
    assert lines == [
        "## Ball",
        *left,
        *right,
        "Rnd 1 6 sc in magic ring (6)",
        "Rnd 2 inc x 6 (12)",
        "Rnd 3 (sc, inc) x 6 (18)",
        "Weave in the ends.",
    ]


def test_a_scan_is_refused_in_one_line(tmp_path):
    Image.new("RGB", (600, 800), "white").save(tmp_path / "scan.pdf")
    with pytest.raises(TambourError, match="pages of this PDF are pictures") as told:
        files.read(tmp_path / "scan.pdf", ("Text",))
    assert len(told.value.problems) == 1
    (tmp_path / "not.docx").write_text("no archive")
    with pytest.raises(TambourError, match="damaged, or of another kind"):
        files.read(tmp_path / "not.docx", ("Text",))


def test_a_text_with_its_picture_becomes_a_page_and_pages_of_pdf(tmp_path):
    lines = [
        "✓ Rnd 1: 6 sc in MR (6)",
        "  It is <small>. " + "Very much so, and on it goes. " * 8,
        "      ? a doubt",
        "",
        *["  row"] * 60,
    ]
    text = Text("\n".join(lines), "ball.txt", ((30, photo()),))
    files.write(text, tmp_path / "ball.html")
    files.write(text, tmp_path / "ball.pdf")
    page = (tmp_path / "ball.html").read_text()
    assert "&lt;small&gt;" in page and page.count("data:image/") == 1
    back = files.read(tmp_path / "ball.pdf", ("Text",)).text
    plain = [one.replace("✓", " ").replace("?", " ").split() for one in (back, text.text)]
    assert plain[0] == plain[1]


COLUMNS = (
    "YARN    #1 Rost 40 g",
    "        #2 Creme 5 g",
    "Kopf (Rost)",
    "Rd 1: 6 fM in den Magischen Ring  6",
    "Rd 2: 6x Zun  12",
    "",
    "Ohren (2x)",
    "Rd 1: 4 fM  4",
)


def test_a_count_stays_in_its_column_and_a_paragraph_is_a_line(tmp_path: Path) -> None:
    """Blogs have a round a paragraph, and a count behind hard blanks or a tab: neither may become air or one blank."""
    wanted = "\n".join(COLUMNS) + "\n"
    page = tmp_path / "page.html"
    hard = [line.replace("  ", "\u00a0\u00a0") or "\u00a0" for line in COLUMNS]
    page.write_text("".join(f"<p>{line}</p>\n" for line in hard), "utf-8")
    assert read_html(page).text == wanted
    for gap in ("  ", "\t"):
        paper = docx.Document()
        for line in COLUMNS:
            paper.add_paragraph(line.replace("  ", gap))
        paper.save(str(tmp_path / "page.docx"))
        assert read_docx(tmp_path / "page.docx").text == wanted
    # A paragraph of several lines is a block of its own.
    page.write_text("<p>Kopf<br>Rd 1: 6 fM</p><p>Ohren</p>", "utf-8")
    assert read_html(page).text == "Kopf\nRd 1: 6 fM\n\nOhren\n"
