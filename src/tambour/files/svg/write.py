"""SVG, written: groups, layers, true size, fixed decimals, and streams that never lie in memory whole."""

from __future__ import annotations

import base64
import io
import math
import re
import zlib
from collections.abc import Iterable, Iterator
from functools import lru_cache
from xml.sax.saxutils import escape, quoteattr

import numpy as np

from tambour.core.check import Array
from tambour.core.drawing import CAPS, JOINS, Drawing, Groups, Placed
from tambour.core.picture import Picture
from tambour.files.sink import Sink
from tambour.files.svg import spell

_HEAD = (
    '<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"'
    ' stroke-linecap="round" stroke-linejoin="round"'
)
_PLAIN = re.compile(r"[\w.:-]*").fullmatch
_BLOCK = 1 << 17
"""Points written by one call: as much memory as the writer takes."""
FAR = 1 << 16
"""Viewers count in single precision, 24 bits: a place is told in whole multiples of this, and the rest of it."""


def write_drawing(value: Drawing | Iterable[Drawing], sink: Sink) -> None:
    """A Drawing, or an iterator of Drawings on one sheet (the first one's), written as they come.

    The pages of a booklet (a tuple) become name-1.svg, name-2.svg, …
    """
    if isinstance(value, tuple):
        for number, page in enumerate(value, 1):
            write_drawing(page, sink.beside(f"{sink.path.stem}-{number}"))
        return
    with sink.stream() as out:
        seen: set[str] = set()
        for k, drawing in enumerate([value] if isinstance(value, Drawing) else value):
            if k == 0:
                out.write(head(drawing).encode())
            out.writelines(body(drawing, seen))
        out.write(b"</svg>\n")


def text(drawing: Drawing) -> str:
    """The SVG of one drawing."""
    return head(drawing) + b"".join(body(drawing, set())).decode() + "</svg>\n"


def number(x: float, decimals: int = 3) -> str:
    """The shortest fixed-point spelling: no exponent, no trailing zeros, no negative zero."""
    spelt = f"{x:.{decimals}f}".rstrip("0").rstrip(".") if decimals else f"{x:.0f}"
    return "0" if spelt in ("-0", "") else spelt


def head(drawing: Drawing) -> str:
    """The root's opening tag, title and ground."""
    x, y = map(number, _corner(drawing).tolist())
    w, h = map(number, drawing.size.tolist())
    mm = [number(s * drawing.unit) for s in drawing.size.tolist()]
    facts = "".join(f" data-{k}={quoteattr(v)}" for k, v in drawing.about.items() if k != "title")
    text = f'{_HEAD} width="{mm[0]}mm" height="{mm[1]}mm" viewBox="{x} {y} {w} {h}"{facts}>\n'
    if "title" in drawing.about:
        text += f"<title>{escape(drawing.about['title'])}</title>\n"
    if drawing.background is not None:
        text += f'<rect x="{x}" y="{y}" width="{w}" height="{h}"{paint("fill", drawing.background)}/>\n'
    return text


def _corner(drawing: Drawing) -> Array:
    """The corner of the sheet as the file has it: the drawing's own, or (0, 0) where that is far off."""
    return np.zeros(2) if abs(drawing.origin).max() >= FAR else drawing.origin


def _moved(x: float, y: float = 0.0) -> str:
    """The transform that moves by (x, y), exact in single precision: far places in two steps."""
    steps = [(FAR * float(int(x / FAR)), FAR * float(int(y / FAR)))]
    steps.append((x - steps[0][0], y - steps[0][1]))
    said = " ".join(f"translate({number(a)} {number(b)})" for a, b in steps if a or b)
    return f' transform="{said}"' if said else ""


def paint(name: str, rgba: Iterable[int]) -> str:
    """The attributes ``fill`` or ``stroke`` with their opacity."""
    r, g, b, a = rgba
    if a == 0:
        return f' {name}="none"'
    opacity = "" if a == 255 else f' {name}-opacity="{number(a / 255)}"'
    return f' {name}="#{r:02x}{g:02x}{b:02x}"{opacity}'


def _style(drawing: Drawing) -> list[str]:
    styles = drawing.styles
    made = []
    columns = (styles.fill, styles.stroke, styles.width, styles.evenodd, styles.cap, styles.join, styles.miter)
    for fill, stroke, width, evenodd, cap, join, miter in zip(*(c.tolist() for c in columns)):
        text = paint("fill", fill)
        if stroke[3] and width > 0:
            text += paint("stroke", stroke) + f' stroke-width="{number(width)}"'
            text += f' stroke-linecap="{CAPS[cap]}"' * (cap > 0) + f' stroke-linejoin="{JOINS[join]}"' * (join > 0)
            text += f' stroke-miterlimit="{number(miter)}"' * (JOINS[join] == "miter" and miter != 4)
        if evenodd and fill[3]:
            text += ' fill-rule="evenodd"'
        made.append(text)
    return made


def body(drawing: Drawing, seen: set[str]) -> Iterator[bytes]:
    """Everything between the root's tags; ``seen`` holds the group ids already used (a second run goes without)."""
    x, y = (_corner(drawing) - drawing.origin).tolist()
    for placed in drawing.images:
        if not placed.glaze:
            yield _image(placed, x, y).encode()
    if x or y:
        yield f"<g{_moved(x, y)}>\n".encode()
    yield from _shapes(drawing, seen)
    if x or y:
        yield b"</g>\n"
    for label in drawing.labels:
        a, b = number(label.x + x), number(label.y + y)
        look = f'font-family="Inter, sans-serif" font-size="{number(label.size)}" text-anchor="{label.anchor}"'
        bold = ' font-weight="bold"' if label.bold else ""
        turn = f' transform="rotate({number(-math.degrees(label.angle))} {a} {b})"' if label.angle else ""
        said = escape(label.text)
        yield f'<text x="{a}" y="{b}" {look}{bold}{turn}{paint("fill", label.color)}>{said}</text>\n'.encode()
    for placed in drawing.images:
        if placed.glaze:
            yield _image(placed, x, y).encode()


@lru_cache(maxsize=4)
def _png(picture: Picture) -> tuple[bytes, str]:
    """A picture as PNG, and that in base 64; kept, because a paper comes again with every file of a batch."""
    from PIL import Image

    raw = io.BytesIO()
    image = Image.fromarray(picture.rgba)
    grey = (picture.rgba[..., 0] == picture.rgba[..., 1]).all() and (picture.rgba[..., 1] == picture.rgba[..., 2]).all()
    (image.convert("LA") if grey else image).save(raw, "PNG")
    return raw.getvalue(), base64.b64encode(raw.getvalue()).decode()


def _shapes(drawing: Drawing, seen: set[str]) -> Iterator[bytes]:
    """All shapes in their groups, a block of points at a time."""
    paths, m = drawing.paths, len(drawing)
    if m == 0:
        return
    heads, head = _heads(drawing, seen)
    coords = paths.coords
    looks, look = _joined([text.encode() for text in _style(drawing)])
    parts = np.arange(m + 1) if paths.parts is None else paths.parts
    ends = paths.offsets[parts]
    if len(drawing.groups.zero):
        zero = drawing.groups.zero[_top(drawing.groups)][drawing.group]
        coords = coords.copy()
        coords[:, 0] -= np.repeat(zero, np.diff(ends))
    decimals, terse = (3, False) if drawing.terse is None else (drawing.terse, True)
    widest = int(np.diff(look).max())
    begin = 0
    out = np.empty(0, np.uint8)
    while begin < m:
        # At least one shape, and as many as keep within a block.
        end = max(begin + 1, min(int(np.searchsorted(ends, ends[begin] + _BLOCK, "right")) - 1, begin + _BLOCK // 8))
        room = spell.bound(
            int(ends[end] - ends[begin]), end - begin, int(head[end] - head[begin]) + (end - begin) * widest
        )
        out = out if len(out) >= room else np.empty(room, np.uint8)
        size = spell.shapes(
            out,
            coords,
            paths.offsets,
            parts,
            begin,
            end,
            drawing.style,
            looks,
            look,
            heads,
            head,
            decimals,
            terse,
            spell.brief(decimals),
        )
        yield out[:size].tobytes()
        begin = end
    yield heads[head[m] :].tobytes()


def _heads(drawing: Drawing, seen: set[str]) -> tuple[Array, Array]:
    """The groups that open and close before each shape, joined, and (M + 1,) where each begins; the last close after."""
    group, groups = drawing.group, drawing.groups
    turns = np.flatnonzero(np.concatenate([[True], group[1:] != group[:-1]]))
    parent = groups.parent.tolist()
    depth: list[int] = []
    for above in parent:
        depth.append(depth[above] + 1 if above >= 0 else 1)
    opened: list[int] = []
    texts: list[bytes] = []
    for g in [*group[turns].tolist(), -1]:
        # Close what is not above g, then open from there down to g.
        wanted: list[int] = []
        above = g
        while above >= 0 and (depth[above] > len(opened) or opened[depth[above] - 1] != above):
            wanted.append(above)
            above = parent[above]
        same = depth[above] if above >= 0 else 0
        text = "</g>\n" * (len(opened) - same)
        del opened[same:]
        for name in reversed(wanted):
            text += _tag(groups, name, seen)
            opened.append(name)
        texts.append(text.encode())
    sizes = np.zeros(len(group), np.int64)
    sizes[turns] = [len(text) for text in texts[:-1]]
    return _joined(texts)[0], np.concatenate([[0], np.cumsum(sizes)])


def _top(groups: Groups) -> Array:
    """(G,) the top group that each lies in."""
    top = np.where(groups.parent < 0, np.arange(len(groups)), groups.parent)
    while (groups.parent[top] >= 0).any():
        top = np.where(groups.parent[top] >= 0, groups.parent[top], top)
    return top


def _joined(texts: list[bytes]) -> tuple[Array, Array]:
    """Texts in one array of bytes, and where each begins."""
    ends = np.concatenate([[0], np.cumsum([len(text) for text in texts])]).astype(np.int64)
    return np.frombuffer(bytearray().join(texts), np.uint8), ends


def _image(placed: Placed, x: float, y: float) -> str:
    """An image moved by (x, y), or a rectangle filled with copies of it, which lie from the drawing's own (0, 0) on."""
    raw, data = _png(placed.picture)
    box = f'x="{number(placed.x + x)}" y="{number(placed.y + y)}"'
    box += f' width="{number(placed.width)}" height="{number(placed.height)}"'
    if placed.repeat is None:
        return f'<image {box} preserveAspectRatio="none" href="data:image/png;base64,{data}"/>\n'
    wide, high = placed.repeat
    size = f'width="{number(wide)}" height="{number(high)}"'
    first = f' x="{number(math.fmod(x, wide))}" y="{number(math.fmod(y, high))}"' if x or y else ""
    name = f"p{zlib.crc32(raw + first.encode()):08x}"
    return (
        f'<pattern id="{name}" patternUnits="userSpaceOnUse"{first} {size}>'
        f'<image {size} preserveAspectRatio="none" href="data:image/png;base64,{data}"/></pattern>\n'
        f'<rect {box} fill="url(#{name})"/>\n'
    )


def _tag(groups: Groups, g: int, seen: set[str]) -> str:
    """What opens a group; its id only where it stands for the first time."""
    name = groups.ids[g]
    text = "" if name in seen else f' id="{name}"' if _PLAIN(name) else f" id={quoteattr(name)}"
    seen.add(name)
    if groups.layer[g]:
        text += ' inkscape:groupmode="layer"'
    if groups.names[g]:
        text += f" inkscape:label={quoteattr(groups.names[g])}"
    if groups.data:
        text += "".join(f" data-{k}={quoteattr(v)}" for k, v in groups.data[g].items())
    if len(groups.zero) and groups.parent[g] < 0:
        text += _moved(float(groups.zero[g]))
    return f"<g{text}>\n"
