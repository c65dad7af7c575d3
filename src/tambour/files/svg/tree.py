"""SVG's XML, read by expat under guard: no external entities, no bombs, no depth or size that could stop a machine."""

from __future__ import annotations

import gzip
import zlib
from dataclasses import dataclass, field
from pathlib import Path
from xml.parsers import expat

from tambour.core.errors import TambourError

DEEPEST = 200
MOST = 400_000
LARGEST = 200_000_000  # bytes
SPACES = {
    "http://www.w3.org/2000/svg": "",
    "http://www.w3.org/1999/xlink": "xlink:",
    "http://www.inkscape.org/namespaces/inkscape": "inkscape:",
    "http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd": "sodipodi:",
    "http://inkstitch.org/namespace": "inkstitch:",
    "http://www.w3.org/XML/1998/namespace": "xml:",
}


@dataclass(slots=True)
class Node:
    """An element: its name (prefix by its namespace's meaning, "" for SVG's own), attributes, children, text, line."""

    name: str
    attributes: dict[str, str]
    line: int
    children: list[Node] = field(default_factory=list)
    text: str = ""
    tail: str = ""


def parse(path: Path) -> Node:
    """The root element of an SVG file (or gzipped SVG); TambourError with file:line:col for anything else."""
    raw = path.read_bytes()
    if raw[:2] == b"\x1f\x8b":
        try:
            with gzip.open(path) as packed:
                raw = packed.read(LARGEST + 1)
        except (OSError, EOFError, zlib.error):
            raise TambourError(
                "this is not an SVG file (it begins like gzip, and cannot be unpacked)", where=str(path)
            ) from None
    if len(raw) > LARGEST:
        raise TambourError(f"an SVG file of more than {LARGEST // 1_000_000} MB is not read", where=str(path))
    if not raw.strip():
        raise TambourError("the file is empty", where=str(path))
    reader = expat.ParserCreate()
    reader.buffer_text = True
    reader.SetParamEntityParsing(expat.XML_PARAM_ENTITY_PARSING_NEVER)
    root: list[Node] = []
    open_nodes: list[Node] = []
    scopes: list[dict[str, str]] = [{"xml": "http://www.w3.org/XML/1998/namespace"}]
    count = 0

    def stop(message: str, hint: str = "") -> TambourError:
        where = f"{path}:{reader.CurrentLineNumber}:{reader.CurrentColumnNumber + 1}"
        return TambourError(message, hint=hint, where=where)

    def named(name: str, scope: dict[str, str], attribute: bool) -> str:
        prefix, colon, local = name.rpartition(":")
        if not colon and attribute:
            return local
        space = scope.get(prefix)
        if space is None:
            return f"{prefix}:{local}" if colon and prefix != "svg" else local
        return SPACES.get(space, f"{prefix}:" if prefix else "other:") + local

    def begin(name: str, attributes: dict[str, str]) -> None:
        nonlocal count
        count += 1
        if count > MOST:
            raise stop(f"more than {MOST:,} elements", "simplify the drawing")
        if len(open_nodes) >= DEEPEST:
            raise stop(f"elements nested more than {DEEPEST} deep", "ungroup the drawing")
        scope = scopes[-1]
        new = {
            k[6:] if k != "xmlns" else "": v for k, v in attributes.items() if k == "xmlns" or k.startswith("xmlns:")
        }
        if new:
            scope = {**scope, **new}
        scopes.append(scope)
        held = {named(k, scope, True): v for k, v in attributes.items() if not k.startswith("xmlns")}
        node = Node(named(name, scope, False), held, reader.CurrentLineNumber)
        if open_nodes:
            open_nodes[-1].children.append(node)
        else:
            root.append(node)
        open_nodes.append(node)

    def end(name: str) -> None:
        open_nodes.pop()
        scopes.pop()

    def text(data: str) -> None:
        if open_nodes:
            if open_nodes[-1].children:
                open_nodes[-1].children[-1].tail += data
            else:
                open_nodes[-1].text += data

    def entity(name, parameter, value, base, system, public, notation):  # type: ignore[no-untyped-def]
        # Illustrator declares namespaces as entities; anything that could grow or reach outside is refused.
        if parameter or system or public:
            raise stop(f'the entity "{name}" lies outside the file', "external entities are not read")
        if value is not None and ("&" in value or len(value) > 1000):
            raise stop(f'the entity "{name}" is made of others, or very long', "such files are not read")

    reader.StartElementHandler = begin
    reader.EndElementHandler = end
    reader.CharacterDataHandler = text
    reader.EntityDeclHandler = entity
    try:
        reader.Parse(raw, True)
    except expat.ExpatError as error:
        where = f"{path}:{error.lineno}:{error.offset + 1}"
        raise TambourError(f"this is not well-formed XML: {expat.errors.messages[error.code]}", where=where) from None
    except (ValueError, LookupError) as error:
        raise TambourError(f"this cannot be read as XML: {error}", where=str(path)) from None
    if not root or root[0].name != "svg":
        found = f" (its root is <{root[0].name}>)" if root else ""
        raise TambourError(f"this is not an SVG file{found}", where=str(path))
    return root[0]
