"""SVG, written: groups, layers, true size, fixed decimals, and streams that never lie in memory whole."""

from __future__ import annotations

import base64
import io
import math
import zlib
from collections.abc import Iterable, Iterator
from pathlib import Path
from xml.sax.saxutils import escape, quoteattr

from tambour.core.drawing import Drawing, Placed

_HEAD = '<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"'


def write_drawing(value: Drawing | Iterable[Drawing], path: Path) -> None:
    """A Drawing, or an iterator of Drawings on one sheet (the first one's), written as they come.

    The pages of a booklet (a tuple) become name-1.svg, name-2.svg, …
    """
    if isinstance(value, tuple):
        for number, page in enumerate(value, 1):
            write_drawing(page, path.with_name(f"{path.stem}-{number}{path.suffix}"))
        return
    with path.open("w", encoding="utf-8", newline="\n", buffering=1 << 20) as out:
        seen: set[str] = set()
        for k, drawing in enumerate([value] if isinstance(value, Drawing) else value):
            if k == 0:
                out.writelines(_head(drawing))
            out.writelines(body(drawing, seen))
        out.write("</svg>\n")


def text(drawing: Drawing) -> str:
    """The SVG of one drawing."""
    return "".join([*_head(drawing), *body(drawing, set()), "</svg>\n"])


def number(x: float, decimals: int = 3) -> str:
    """The shortest fixed-point spelling: no exponent, no trailing zeros, no negative zero."""
    spelt = f"{x:.{decimals}f}".rstrip("0").rstrip(".") if decimals else f"{x:.0f}"
    return "0" if spelt in ("-0", "") else spelt


def _head(drawing: Drawing) -> Iterator[str]:
    x, y = map(number, drawing.origin.tolist())
    w, h = map(number, drawing.size.tolist())
    mm = [number(s * drawing.unit) for s in drawing.size.tolist()]
    facts = "".join(f" data-{k}={quoteattr(v)}" for k, v in drawing.about.items() if k != "title")
    yield f'{_HEAD} width="{mm[0]}mm" height="{mm[1]}mm" viewBox="{x} {y} {w} {h}"{facts}>\n'
    if "title" in drawing.about:
        yield f"<title>{escape(drawing.about['title'])}</title>\n"
    if drawing.background is not None:
        yield f'<rect x="{x}" y="{y}" width="{w}" height="{h}"{paint("fill", drawing.background)}/>\n'


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
    for fill, stroke, width, evenodd in zip(
        styles.fill.tolist(), styles.stroke.tolist(), styles.width.tolist(), styles.evenodd.tolist()
    ):
        text = paint("fill", fill)
        if stroke[3] and width > 0:
            text += paint("stroke", stroke) + f' stroke-width="{number(width)}"'
            text += ' stroke-linecap="round" stroke-linejoin="round"'
        if evenodd and fill[3]:
            text += ' fill-rule="evenodd"'
        made.append(text)
    return made


def body(drawing: Drawing, seen: set[str]) -> Iterator[str]:
    """Everything between the root's tags; ``seen`` holds the group ids already used (a second run goes without)."""
    for placed in drawing.images:
        if not placed.glaze:
            yield _image(placed)
    styles = _style(drawing)
    opened: list[int] = []
    chains = [_chain(drawing, g) for g in range(len(drawing.groups))]
    group = drawing.group.tolist()
    ways = _ways(drawing)
    for shape, style in enumerate(drawing.style.tolist()):
        wanted = chains[group[shape]] if group[shape] >= 0 else []
        yield from _switch(drawing, opened, wanted, seen)
        yield f'<path d="{next(ways)}"{styles[style]}/>\n'
    yield from _switch(drawing, opened, [], seen)
    for label in drawing.labels:
        at = f'x="{number(label.x)}" y="{number(label.y)}"'
        look = f'font-family="Inter, sans-serif" font-size="{number(label.size)}" text-anchor="{label.anchor}"'
        bold = ' font-weight="bold"' if label.bold else ""
        turn = (
            f' transform="rotate({number(-math.degrees(label.angle))} {number(label.x)} {number(label.y)})"'
            if label.angle
            else ""
        )
        yield f"<text {at} {look}{bold}{turn}{paint('fill', label.color)}>{escape(label.text)}</text>\n"
    for placed in drawing.images:
        if placed.glaze:
            yield _image(placed)


def _image(placed: Placed) -> str:
    """An image, or a rectangle filled with copies of it."""
    from PIL import Image

    raw = io.BytesIO()
    Image.fromarray(placed.picture.rgba).save(raw, "PNG", optimize=True)
    data = base64.b64encode(raw.getvalue()).decode()
    box = f'x="{number(placed.x)}" y="{number(placed.y)}"'
    box += f' width="{number(placed.width)}" height="{number(placed.height)}"'
    if placed.repeat is None:
        return f'<image {box} preserveAspectRatio="none" href="data:image/png;base64,{data}"/>\n'
    size = f'width="{number(placed.repeat[0])}" height="{number(placed.repeat[1])}"'
    name = f"p{zlib.crc32(raw.getvalue()):08x}"
    return (
        f'<pattern id="{name}" patternUnits="userSpaceOnUse" {size}>'
        f'<image {size} preserveAspectRatio="none" href="data:image/png;base64,{data}"/></pattern>\n'
        f'<rect {box} fill="url(#{name})"/>\n'
    )


def _chain(drawing: Drawing, group: int) -> list[int]:
    chain: list[int] = []
    while group >= 0:
        chain.insert(0, group)
        group = int(drawing.groups.parent[group])
    return chain


def _switch(drawing: Drawing, opened: list[int], wanted: list[int], seen: set[str]) -> Iterator[str]:
    """Close and open groups until ``wanted`` are open."""
    same = 0
    while same < min(len(opened), len(wanted)) and opened[same] == wanted[same]:
        same += 1
    while len(opened) > same:
        opened.pop()
        yield "</g>\n"
    groups = drawing.groups
    for g in wanted[same:]:
        name = groups.ids[g]
        text = "" if name in seen else f" id={quoteattr(name)}"
        seen.add(name)
        if groups.layer[g]:
            text += ' inkscape:groupmode="layer"'
        if groups.names[g]:
            text += f" inkscape:label={quoteattr(groups.names[g])}"
        if groups.data:
            text += "".join(f" data-{k}={quoteattr(v)}" for k, v in groups.data[g].items())
        yield f"<g{text}>\n"
        opened.append(g)


def _ways(drawing: Drawing) -> Iterator[str]:
    """The path data of every shape: M x,y L …, Z for rings."""
    paths = drawing.paths
    coords = paths.coords.tolist()
    ends = paths.offsets.tolist()
    parts = list(range(len(ends))) if paths.parts is None else paths.parts.tolist()
    for m in range(len(parts) - 1):
        text = ""
        for i in range(parts[m], parts[m + 1]):
            ring = coords[ends[i] : ends[i + 1]]
            closed = len(ring) > 2 and ring[0] == ring[-1]
            spelt = [f"{number(x)},{number(y)}" for x, y in (ring[:-1] if closed else ring)]
            if spelt:
                text += "M" + "L".join(spelt) + ("Z" if closed else "")
        yield text
