"""Plain text and JSON."""

from __future__ import annotations

import json
import re
from base64 import b64encode
from html import escape
from itertools import groupby
from pathlib import Path
from typing import Any

from tambour.core.errors import TambourError, Text
from tambour.files.sink import Sink

WORDS = 2_000_000
"""Bytes of a text, or characters of a document, above which it is no pattern: the longest books of them hold a third."""

SMALL = 20_000_000
"""Bytes of a report or a list of edits, at the most."""


def read_text(path: Path) -> Text:
    """A text file: UTF-8 (with or without mark), UTF-16 (with one) or, failing that, Windows-1252; any line ends. TambourError above 2 MB."""
    if path.stat().st_size > WORDS:
        raise TambourError(f"a text of more than {WORDS // 1_000_000} MB is no pattern", where=str(path))
    return decoded(path)


def decoded(path: Path) -> Text:
    """A text file of any size."""
    raw = path.read_bytes()
    wide = raw.startswith((b"\xff\xfe", b"\xfe\xff"))  # what Windows calls Unicode
    try:
        text = raw.decode("utf-16" if wide else "utf-8-sig")
    except UnicodeDecodeError:
        text = raw.decode("cp1252", errors="replace")
    if "\0" in text:
        raise TambourError("this is not a text file (it holds zero bytes)", where=str(path))
    return Text(text.replace("\r\n", "\n").replace("\r", "\n"), str(path))


def small(path: str | Path) -> bytes:
    """The bytes of a file of SMALL at the most, or of a pipe; TambourError where it cannot be read, or goes on."""
    try:
        with Path(path).open("rb") as stream:
            raw = stream.read(SMALL + 1)
    except OSError as error:
        raise TambourError(f"cannot be read: {error.strerror or error}", where=str(path)) from None
    if len(raw) > SMALL:
        raise TambourError(f"a file of more than {SMALL // 1_000_000} MB is not read", where=str(path))
    return raw


def read_edits(path: str | Path) -> list[Any]:
    """The edits in a JSON file: a list of them, or what a report has under "edits". TambourError for any other file."""
    raw = small(path)
    try:
        told = json.loads(raw)
        edits = told["edits"] if isinstance(told, dict) else told
        if isinstance(edits, list):
            return edits
    except (ValueError, KeyError, RecursionError):
        pass
    hint = 'such as [{"edit": "stitch", "row": 12, "stitch": 30, "yarn": "CC"}], or a report'
    raise TambourError("this is no list of edits", hint=hint, where=str(path))


def write_text(value: Text, sink: Sink) -> None:
    """UTF-8, line ends as they are."""
    sink.put(value.text.encode())


def write_html(value: Text, sink: Sink) -> None:
    """A page of its own for a text in Markdown: headings, lists and paragraphs; every character of it is text. Its pictures stand below their paragraphs, or beside them."""
    title = escape(next((line.lstrip("# ") for line in value.text.split("\n") if line.strip()), sink.path.stem))
    out = [
        '<!doctype html>\n<html><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">',
        f"<title>{title}</title>",
        "<style>body{max-width:45em;margin:2em auto;padding:0 1em;font:1em/1.5 sans-serif}</style></head><body>",
    ]
    photos = sorted(value.photos, key=lambda photo: photo[0])
    beside = sorted(value.beside, key=lambda one: one[0])
    for block in re.finditer(r"(?:[^\n]*\S[^\n]*(?:\n|$))+", value.text):
        while beside and beside[0][0] < block.end():
            shown = _shown(beside.pop(0)[1]())
            out.append(f'<img style="float:right;clear:right;width:13em;margin:0 0 1em 1em" src="{shown}" alt="">')
        for kind, group in groupby(filter(str.strip, block[0].split("\n")), _kind):
            lines = [escape(line.lstrip("#- ") if kind else line) for line in group]
            if kind == "li":
                out.append("<ul>" + "".join(f"<li>{line}</li>" for line in lines) + "</ul>")
            elif kind:
                out += [f"<{kind}>{line}</{kind}>" for line in lines]
            else:
                out.append("<p>" + "<br>\n".join(lines) + "</p>")
        while photos and photos[0][0] < block.end():
            out.append(f'<p><img style="max-width:100%" src="{_shown(photos.pop(0)[1])}" alt=""></p>')
    sink.put("\n".join([*out, "</body></html>\n"]).encode())


def _shown(photo: bytes) -> str:
    """A picture as an address that holds it."""
    kind = "png" if photo.startswith(b"\x89PNG") else "gif" if photo.startswith(b"GIF") else "jpeg"
    return f"data:image/{kind};base64,{b64encode(photo).decode()}"


def _kind(line: str) -> str:
    found = re.match(r"(#{1,4}) |(- )", line)
    return "" if not found else "li" if found[2] else f"h{len(found[1])}"


def write_json(value: Any, sink: Sink) -> None:
    """JSON with arrays as lists: rows on one line each, so that it can be read and compared."""
    sink.put(dumps(value).encode())


def dumps(value: Any, depth: int = 0) -> str:
    """JSON text: mappings opened line by line, everything inside a list on one line; numpy arrays as lists."""
    if isinstance(value, dict) and depth < 4 and value:
        pad = "  " * (depth + 1)
        inner = ",\n".join(f"{pad}{json.dumps(str(k))}: {dumps(v, depth + 1)}" for k, v in value.items())
        return "{\n" + inner + "\n" + "  " * depth + "}" + ("\n" if depth == 0 else "")
    return json.dumps(value, default=_plain, ensure_ascii=False, allow_nan=False)


def _plain(value: Any) -> Any:
    if hasattr(value, "tolist"):
        return value.tolist()
    raise TypeError(f"a {type(value).__name__} has no JSON form")
