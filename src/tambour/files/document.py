"""Documents as text: .docx, .odt and .html, with their headings, lists, tables and photos in order. Nothing in them is run."""

from __future__ import annotations

import base64
import re
import zipfile
from collections.abc import Iterator
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from tambour.core.errors import TambourError, Text
from tambour.files.text import WORDS

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

_MOST: Final = 200_000_000
"""Bytes that a document may hold unpacked, and those of its pictures, each as often as it is shown."""
_DEEPEST: Final = 250
"""How deep the parts of a document may lie in one another."""
_CODES: Final = re.compile(rb"(?i)(utf|iso|us-ascii|latin|windows|cp|koi8|mac|shift|sjis|euc|gb|big5)[\w-]*")
"""Character sets that pages are written in. Python knows others, which are none, or take the square of a page's length."""
_BLOCKS: Final = frozenset(
    "p div section article main ul ol table tr h1 h2 h3 h4 h5 h6 blockquote pre figure figcaption dl dt dd hr li".split()
)
_SKIPPED: Final = frozenset(
    ["script", "style", "noscript", "template", "nav", "aside", "form", "button", "svg", "iframe", "select", "head"]
)
_TEXT: Final = "{urn:oasis:names:tc:opendocument:xmlns:text:1.0}"
_TABLE: Final = "{urn:oasis:names:tc:opendocument:xmlns:table:1.0}"
_DRAW: Final = "{urn:oasis:names:tc:opendocument:xmlns:drawing:1.0}"
_HREF: Final = "{http://www.w3.org/1999/xlink}href"


_BLANK: Final = re.compile(r"[^\S\n ]")


class Pages:
    """A document's text as it is gathered: lines, and photos (where they stand, their bytes). TambourError where it is too much."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.lines: list[str] = []
        self.photos: list[tuple[int, bytes]] = []
        self._length = self._shown = 0

    def line(self, words: str, before: str = "") -> None:
        """A line; several where the words have breaks of their own. Blanks stay as they are, and a tab is two: columns are set by them,
        that of the rounds' counts among them."""
        for piece in words.split("\n"):
            said = _BLANK.sub(" ", piece.replace("\t", "  ")).rstrip()
            self._add(f"{before}{said.lstrip()}" if said and before else said)

    def heading(self, words: str) -> None:
        """A heading, with air about it."""
        if words.strip():
            self._add("")
            self.line(words, "## ")
            self._add("")

    def row(self, cells: list[str]) -> None:
        """A row of a table."""
        if any("\n" in cell.strip() for cell in cells):  # laid out side by side: each cell is a text of its own
            for cell in cells:
                self.line(cell.strip())
            return
        said = [" ".join(cell.split()) for cell in cells]
        if any(said):
            self._add(f"| {' | '.join(said)} |" if len(said) > 1 else said[0])

    def photo(self, data: bytes) -> None:
        """A photo at this place."""
        if data:
            self.photos.append((self._length, data))
            self._shown += len(data)
            if self._shown > _MOST:
                raise TambourError(f"its pictures take more than {_MOST // 1_000_000} MB", where=str(self.path))

    def _add(self, line: str) -> None:
        if line or (self.lines and self.lines[-1]):
            self.lines.append(line)
            self._length += len(line) + 1
            if self._length > WORDS:
                raise TambourError(f"a text of more than {WORDS // 1_000_000} MB is no pattern", where=str(self.path))

    def text(self) -> Text:
        """All of it; TambourError where there are no words."""
        if not any(self.lines):
            hint = "a photo of a page cannot be read"
            raise TambourError("this document holds no text", hint=hint, where=str(self.path))
        return Text("\n".join(self.lines).rstrip("\n") + "\n", str(self.path), tuple(self.photos))


def read_docx(path: Path) -> Text:
    """A Word document (OOXML)."""
    import docx
    from docx.oxml.ns import qn

    _packed(path).close()
    try:
        document: Any = docx.Document(str(path))
        body = document.element.body
        styles = {style.style_id: style.name or "" for style in document.styles}
        usual = next((s.style_id for s in document.styles if s.type == 1 and s.element.default), "")
    except Exception as error:  # noqa: BLE001 - the library and its parser raise whatever a hostile file makes them raise
        raise TambourError(f"this is no Word document: {error}", where=str(path)) from None
    tracked = _accepted(body)
    pages, numbered = Pages(path), 0

    def photos(part: Any) -> None:
        for blip in part.xpath(".//a:blip/@r:embed"):
            image = document.part.related_parts.get(str(blip))
            pages.photo(getattr(image, "blob", b""))

    for part in body.iterchildren(qn("w:tbl"), qn("w:p")):
        if part.tag == qn("w:tbl"):
            for row in _rows(part):
                pages.row(list(dict.fromkeys(row)))
            photos(part)
            continue
        words = part.text
        style = styles.get(part.style or usual, "")
        listed = style.startswith("List") or bool(part.xpath("./w:pPr/w:numPr"))
        numbered = numbered + 1 if style.startswith("List Number") else 0
        if style.startswith(("Heading", "Title")):
            pages.heading(words)
        elif listed and words.strip():
            pages.line(words, f"{numbered}. " if numbered else "- ")
        else:
            pages.line(words)
        photos(part)
    text = pages.text()
    if not tracked:
        return text
    return replace(text, told=(f"tracked changes, {tracked}: it is read as if all of them were accepted",))


def _accepted(body: Any) -> int:
    """Takes Word's tracked changes as accepted, and the frames of forms away that stand about words; how many changes there were."""
    from docx.oxml.ns import qn

    tracked = 0
    for gone in list(body.iter(qn("w:del"), qn("w:moveFrom"))):
        tracked += 1
        gone.getparent().remove(gone)
    for frame in list(body.iter(qn("w:ins"), qn("w:moveTo"), qn("w:sdt"), qn("w:smartTag"), qn("w:customXml"))):
        if frame.getparent() is None:
            continue
        tracked += frame.tag in (qn("w:ins"), qn("w:moveTo"))
        held = frame.find(qn("w:sdtContent")) if frame.tag == qn("w:sdt") else frame
        for child in list(held) if held is not None else []:
            if not str(child.tag).endswith("Pr"):
                frame.addprevious(child)
        frame.getparent().remove(frame)
    return tracked


def _rows(table: Any) -> Iterator[list[str]]:
    """The rows of a Word table as their cells' words; a cell that goes on from the row above says again what stands there."""
    from docx.oxml.ns import qn

    above: list[str] = []
    for row in table.iterchildren(qn("w:tr")):
        said: list[str] = []
        for k, cell in enumerate(row.iterchildren(qn("w:tc"))):
            words = "\n".join(paragraph.text for paragraph in cell.iterchildren(qn("w:p")))
            goes_on = cell.xpath("./w:tcPr/w:vMerge[not(@w:val) or @w:val='continue']")
            said.append(above[k] if goes_on and k < len(above) else words)
        above = said
        yield said


def read_odt(path: Path) -> Text:
    """An OpenDocument text."""
    from xml.etree.ElementTree import ParseError

    from defusedxml.common import DefusedXmlException
    from defusedxml.ElementTree import fromstring

    with _packed(path) as pack:
        try:
            body = fromstring(_unpacked(pack, "content.xml", path))
        except (KeyError, ParseError, DefusedXmlException) as error:
            raise TambourError(f"this is no OpenDocument text: {error}", where=str(path)) from None
        pages = Pages(path)
        pictures = dict.fromkeys(pack.namelist(), b"")

        def photos(node: Element) -> None:
            for image in node.iter(f"{_DRAW}image"):
                name = image.get(_HREF, "")
                if name in pictures:
                    pictures[name] = pictures[name] or _unpacked(pack, name, path)
                    pages.photo(pictures[name])

        def walk(node: Element, before: str) -> None:
            for child in node:
                if child.tag == f"{_TEXT}h":
                    pages.heading(_words(child))
                elif child.tag == f"{_TEXT}p":
                    pages.line(_words(child), before)
                    photos(child)
                elif child.tag == f"{_TABLE}table-row":
                    pages.row(["\n".join(_words(p) for p in cell.iter(f"{_TEXT}p")) for cell in child])
                elif child.tag == f"{_TEXT}list-item":
                    walk(child, "- ")
                else:
                    walk(child, before)

        if _deeper(body):
            raise TambourError("its parts lie too deep in one another", where=str(path))
        walk(body, "")
    return pages.text()


def _deeper(body: Element) -> bool:
    """Whether the parts of a document lie deeper in one another than ``_DEEPEST``."""
    level = [body]
    for _ in range(_DEEPEST):
        level = [child for node in level for child in node]
    return bool(level)


def _words(node: Element) -> str:
    """The words of a paragraph of an OpenDocument text."""
    made = [node.text or ""]
    for child in node:
        if child.tag == f"{_TEXT}line-break":
            made.append("\n")
        elif child.tag in (f"{_TEXT}s", f"{_TEXT}tab"):
            made.append(" ")
        elif child.tag not in (f"{_TEXT}note", f"{_DRAW}frame"):
            made.append(_words(child))
        made.append(child.tail or "")
    return "".join(made)


def _packed(path: Path) -> zipfile.ZipFile:
    """The archive that a document is; TambourError where it is none, or would not fit into memory."""
    try:
        pack = zipfile.ZipFile(path)
    except zipfile.BadZipFile:
        raise TambourError("this document is damaged, or of another kind", where=str(path)) from None
    if sum(entry.file_size for entry in pack.infolist()) > _MOST:
        raise TambourError(f"this document unpacks to more than {_MOST // 1_000_000} MB", where=str(path))
    return pack


def _unpacked(pack: zipfile.ZipFile, name: str, path: Path) -> bytes:
    """A file of the archive; KeyError where there is none of the name, TambourError where its bytes are damaged."""
    try:
        return pack.read(name)
    except KeyError:
        raise
    except Exception as error:  # noqa: BLE001 - zip, zlib, a wrong sum, a cipher: Python lets them all through
        raise TambourError(f"this document is damaged ({error})", where=str(path)) from None


def read_html(path: Path) -> Text:
    """A page of the web that was saved: what is read on it; its scripts are left alone, other addresses not visited."""
    raw = path.read_bytes()
    found = re.search(rb"charset=[\"']?([\w-]+)", raw[:2000])
    try:
        text = raw.decode(found[1].decode("ascii") if found and _CODES.fullmatch(found[1]) else "utf-8-sig")
    except (UnicodeDecodeError, LookupError):
        text = raw.decode("cp1252", errors="replace")
    page = _Page(path)
    # A tag that is not closed is looked for to the end of the page, from each that is opened: none is, so far.
    whole = text.rfind(">") + 1
    try:
        page.feed(text[:whole])
        page.close()
    except AssertionError as error:
        raise TambourError(f"this page is damaged: {error}", where=str(path)) from None
    page.handle_data(text[whole:])
    page.end()
    return page.pages.text()


class _Page(HTMLParser):
    """Gathers what stands on a page of HTML."""

    def __init__(self, path: Path) -> None:
        super().__init__(convert_charrefs=True)
        self.path, self.pages = path, Pages(path)
        self.beside: dict[str, bytes] = {}
        self.said: list[str] = []
        self.cells: list[str] | None = None
        self.lists: list[int] = []  # the number that comes next in every list that is open, -1 in one with dots
        self.heading, self.before, self.hidden, self.rough, self.broken = False, "", 0, False, False

    def end(self) -> None:
        """The words so far are a line."""
        words, self.said = "".join(self.said), []
        words = words if self.rough else re.sub(r" *\n *", "\n", words.strip(" "))  # blanks about a break are none
        if self.cells is not None or not words.strip():
            self.said = [words] if self.cells is not None else []
        elif self.heading:
            self.pages.heading(words)
        else:
            self.pages.line(words, self.before)
            self.before, self.broken = "", "\n" in words.strip()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag in _SKIPPED:
            self.hidden += 1
        if tag in _BLOCKS:
            self.end()
        if tag in ("ul", "ol"):
            self.lists.append(1 if tag == "ol" else -1)
        elif tag == "li":
            number = self.lists[-1] if self.lists else -1
            self.before = f"{number}. " if number > 0 else "- "
            if number > 0:
                self.lists[-1] += 1
        elif tag == "br":
            self.said.append("\n")
        elif tag == "tr":
            self.cells = []
        elif tag in ("td", "th") and self.cells is not None:
            self.said = []
        elif tag == "img":
            self.pages.photo(self._image(dict(attrs).get("src") or ""))
        self.heading = tag in ("h1", "h2", "h3", "h4", "h5", "h6") or (self.heading and tag not in _BLOCKS)
        self.rough = self.rough or tag == "pre"

    def handle_endtag(self, tag: str) -> None:
        if tag in _SKIPPED:
            self.hidden = max(0, self.hidden - 1)
        if tag in ("td", "th") and self.cells is not None:
            self.cells.append("".join(self.said))
            self.said = []
        elif tag == "tr" and self.cells is not None:
            self.pages.row(self.cells)
            self.cells, self.said = None, []
        elif tag in _BLOCKS:
            empty = not "".join(self.said).strip()
            self.broken = False
            self.end()
            self.heading = False
            if tag == "p" and (empty or self.broken):
                # A round a paragraph is how pages of the web are typed: air is what is empty, or about several lines.
                self.pages.line("")
        if tag in ("ul", "ol") and self.lists:
            self.lists.pop()
        self.rough = self.rough and tag != "pre"

    def handle_data(self, data: str) -> None:
        if not self.hidden:
            self.said.append(data if self.rough else re.sub(r"[ \t\r\n\f]+", " ", data))

    def _image(self, where: str) -> bytes:
        """A picture that the page holds itself, or that lies beside it."""
        if where.startswith("data:image/") and ";base64," in where[:60]:
            try:
                return base64.b64decode(where.partition(",")[2], validate=False)
            except ValueError:
                return b""
        if where not in self.beside:
            beside, folder = self.path.parent / where, self.path.parent.resolve()
            there = bool(where) and ":" not in where and beside.is_file() and folder in beside.resolve().parents
            self.beside[where] = beside.read_bytes() if there and beside.stat().st_size <= _MOST else b""
        return self.beside[where]
