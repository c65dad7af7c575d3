"""What an SVG shows, held against Skia's own SVG renderer pixel by pixel; and odd values, each told in its words while the rest is drawn."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shapely

from tambour import files
from tambour.core.check import Array
from tambour.core.drawing import Drawing
from tambour.render.flat import picture

HEAD = '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" width="100" height="100" viewBox="0 0 100 100">'
SIDE = 160


def drawn(folder: Path, body: str) -> Drawing:
    path = folder / "a.svg"
    path.write_text(f"{HEAD}{body}</svg>")
    made: Drawing = files.read(path, ("Drawing",))
    return made


def ours(folder: Path, body: str) -> Array:
    rgba = picture(drawn(folder, body), width=SIDE).rgba.astype(float)
    share = rgba[..., 3:] / 255
    return np.asarray(rgba[..., :3] * share + 255 * (1 - share))


def theirs(body: str) -> Array:
    import skia

    dom = skia.SVGDOM.MakeFromStream(skia.MemoryStream(f"{HEAD}{body}</svg>".encode()))
    dom.setContainerSize((100, 100))
    surface = skia.Surface(SIDE, SIDE)
    with surface as canvas:
        canvas.clear(skia.ColorWHITE)
        canvas.scale(SIDE / 100, SIDE / 100)
        dom.render(canvas)
    return np.asarray(surface.toarray(colorType=skia.kRGBA_8888_ColorType)[..., :3].astype(float))


RED_BLUE = '<stop offset="0" stop-color="red"/><stop offset="1" stop-color="blue"/>'
RECT = '<rect x="10" y="20" width="80" height="50" fill="url(#g)"/>'
GRADIENTS = {
    "plain": f'<linearGradient id="g">{RED_BLUE}</linearGradient>',
    "reflected": f'<linearGradient id="g" x1=".2" x2=".4" spreadMethod="reflect">{RED_BLUE}</linearGradient>',
    "repeated": f'<linearGradient id="g" x1="20%" y1="0" x2="50%" y2="50%" spreadMethod="repeat">{RED_BLUE}</linearGradient>',
    "of the sheet": f'<linearGradient id="g" gradientUnits="userSpaceOnUse" x1="10%" y1="20%" x2="60%" y2="50%">{RED_BLUE}</linearGradient>',
    "turned": f'<linearGradient id="g" gradientTransform="rotate(30 .5 .5)">{RED_BLUE}</linearGradient>',
    "faint": '<linearGradient id="g"><stop stop-color="red" stop-opacity="0"/><stop offset="100%" stop-color="blue" stop-opacity=".8"/></linearGradient>',
    "of two stops in one place": '<linearGradient id="g"><stop offset=".5" stop-color="lime"/><stop offset=".5"/></linearGradient>',
    "of no length": f'<linearGradient id="g" x1=".5" x2=".5">{RED_BLUE}</linearGradient>',
    "of one colour": '<linearGradient id="g"><stop stop-color="#a1b2c3"/></linearGradient>',
    "round": f'<radialGradient id="g">{RED_BLUE}</radialGradient>',
    "round and repeated": f'<radialGradient id="g" r=".2" spreadMethod="repeat">{RED_BLUE}</radialGradient>',
    "round of the sheet": '<radialGradient id="g" gradientUnits="userSpaceOnUse" cx="50%" cy="40%" r="30%" gradientTransform="rotate(20) scale(1 .8)">'
    '<stop offset=".2" stop-color="red"/><stop offset="60%" stop-color="lime"/><stop offset="1" stop-color="blue"/></radialGradient>',
    "seen from aside": f'<radialGradient id="g" fx=".3" fy=".4">{RED_BLUE}</radialGradient>',
}


@pytest.mark.parametrize("name", GRADIENTS)
def test_bands_of_gradients_have_the_colours_of_another_program(name: str, tmp_path: Path) -> None:
    """Each band in its middle; between bands both have edges of their own."""
    made, seen, far = drawn(tmp_path, GRADIENTS[name] + RECT), theirs(GRADIENTS[name] + RECT), []
    for m in range(len(made)):
        rings = [made.paths[i] for i in range(int(made.paths.parts[m]), int(made.paths.parts[m + 1]))]
        band = shapely.make_valid(shapely.Polygon(rings[0], rings[1:]))
        x, y = _middle(band, made)
        r, g, b, alpha = made.styles.fill[made.style[m]].astype(float)
        shown = np.array([r, g, b]) * alpha / 255 + 255 - alpha
        far.append(float(np.abs(shown - seen[y, x]).max()))
    assert sum(f > 30 for f in far) <= 0.05 * len(far) and np.mean(far) < 14, np.round(far)


def _middle(band: shapely.Geometry, made: Drawing) -> tuple[int, int]:
    point = shapely.point_on_surface(band)
    return int(point.x / made.size[0] * SIDE), int(point.y / made.size[1] * SIDE)


SAME: dict[str, tuple[str, str]] = {
    "a pattern of the box": (
        '<pattern id="p" width=".25" height="25%"><rect width="8" height="6"/></pattern>',
        '<pattern id="p" patternUnits="userSpaceOnUse" x="10" y="10" width="20" height="15"><rect width="8" height="6"/></pattern>',
    ),
    "what is in it, of the box": (
        '<pattern id="p" width=".25" height=".25" patternContentUnits="objectBoundingBox"><rect width=".1" height=".1"/></pattern>',
        '<pattern id="p" patternUnits="userSpaceOnUse" x="10" y="10" width="20" height="15"><rect width="8" height="6"/></pattern>',
    ),
    "a pattern with a view": (
        '<pattern id="p" width=".25" height=".25" viewBox="0 0 4 3"><rect width="2" height="1"/></pattern>',
        '<pattern id="p" patternUnits="userSpaceOnUse" x="10" y="10" width="20" height="15"><rect width="10" height="5"/></pattern>',
    ),
    "a paint that is not there, and what stands behind it": (
        '<pattern id="none" width="0" height="9"><rect width="9" height="9"/></pattern><g fill="url(#none)"><rect width="7" height="7"/></g><g fill="url(#gone) #123456"><rect width="5" height="5"/></g>',
        '<rect width="5" height="5" fill="#123456"/>',
    ),
    "a gradient that takes all from another": (
        '<linearGradient id="o" x2="0" y2="1"><stop stop-color="red"/><stop offset="1"/></linearGradient><linearGradient id="p" href="#o"/>',
        '<linearGradient id="p" x2="0" y2="1"><stop stop-color="red"/><stop offset="1"/></linearGradient>',
    ),
    "stops that inherit": (
        '<linearGradient id="p" stop-color="red" stop-opacity=".5" color="lime"><stop stop-color="inherit" stop-opacity="inherit"/><stop offset="1" stop-color="currentColor"/></linearGradient>',
        '<linearGradient id="p"><stop stop-color="red" stop-opacity=".5"/><stop offset="1" stop-color="lime"/></linearGradient>',
    ),
    "a round gradient whose focus is beyond its rim": (
        '<radialGradient id="p" fx="2" fy=".5"><stop stop-color="red"/><stop offset="1"/></radialGradient>',
        '<radialGradient id="p" fx=".9995" fy=".5"><stop stop-color="red"/><stop offset="1"/></radialGradient>',
    ),
    "two ways to write a dash": (
        '<path d="M0 5h90" stroke="red" pathLength="9" stroke-dasharray="1"/>',
        '<path d="M0 5h90" stroke="red" stroke-dasharray="10"/>',
    ),
    "a dash that starts nowhere": (
        '<path d="M0 5h90" stroke="red" stroke-dashoffset="x" stroke-dasharray="7"/>',
        '<path d="M0 5h90" stroke="red" stroke-dasharray="7 7"/>',
    ),
    "a colour that is the text's": ('<g color="#0a0b0c" fill="red"><rect width="9" height="9" fill="currentColor"/></g>', '<rect width="9" height="9" fill="#0a0b0c"/>'),
    "all that is put back": ('<g fill="red"><rect width="9" height="9" style="fill:initial"/></g>', '<rect width="9" height="9"/>'),
    "large letters put back": ('<style>g{font-size:40px}</style><g><g style="font-size:initial"><rect width="1em" height="1em"/></g></g>', '<rect width="16" height="16"/>'),
    "what is unset is taken from above": ('<style>rect{fill:red}</style><g fill="lime"><rect width="9" height="9" style="fill:unset"/></g>', '<g style="fill:lime"><rect width="9" height="9" style="fill:inherit"/></g>'),
    "a rule put back": ('<style>rect{opacity:.5}</style><rect width="9" height="9" style="opacity:unset"/>', '<rect width="9" height="9"/>'),
    "a faint group of faint things": (
        '<g opacity=".5"><rect width="9" height="9" fill-opacity=".5"/></g>',
        '<rect width="9" height="9" fill-opacity=".25"/>',
    ),
    "a hidden thing": ('<g visibility="hidden"><path d="M0 0h9" stroke="red"/></g><rect width="9" height="9"/>', '<rect width="9" height="9"/>'),
    "hsl": ('<rect width="9" height="9" fill="hsl(120deg, 100%, 50%)"/>', '<rect width="9" height="9" fill="#0f0"/>'),
    "hsl in turns and words": ('<rect width="9" height="9" fill="hsla(.5turn 100% 50% / 50%)"/>', '<rect width="9" height="9" fill="#00ffff80"/>'),
}  # fmt: skip


@pytest.mark.parametrize("name", SAME)
def test_two_ways_to_say_it_are_one_drawing(name: str, tmp_path: Path) -> None:
    user = '<rect x="10" y="10" width="80" height="60" fill="url(#p)"/>'
    one, other = (drawn(tmp_path, body + (user if 'id="p"' in body else "")) for body in SAME[name])
    assert len(one) == len(other) > 0
    assert np.allclose(one.paths.coords, other.paths.coords, atol=0.03)
    assert np.abs(one.styles.fill[one.style].astype(int) - other.styles.fill[other.style]).max() <= 1
    assert np.abs(one.styles.stroke[one.style].astype(int) - other.styles.stroke[other.style]).max() <= 1


LINE = 'fill="none" stroke="navy" stroke-width="6"'
DRAWN = {
    "dashes of an odd number": f'<path d="M5 20H95" {LINE} stroke-dasharray="12 4 7"/>',
    "dashes round a ring": f'<circle cx="50" cy="50" r="30" {LINE} stroke-dasharray="20 10" stroke-dashoffset="-5"/>',
    "a ring that ends within a dash": f'<rect x="20" y="20" width="50" height="40" {LINE} stroke-dasharray="30 8" stroke-dashoffset="12"/>',
    "dots": f'<path d="M5 50h0M20 50h0" {LINE} stroke-linecap="round"/><path d="M40 50h0" {LINE} stroke-linecap="square"/>',
    "skewed": '<rect x="10" y="10" width="30" height="30" transform="skewX(20) translate(5)" fill="green"/>'
    '<rect x="10" y="50" width="30" height="30" transform="skewY(-20) scale(1.5 1)" fill="red"/>',
    "a strange matrix": '<rect width="20" height="20" transform="matrix(1 .3 -.5 1.2 40 30)" fill="teal"/>',
    "a curve in short": '<path d="M10 50 q10 -40 30 0 t30 0 M10 80 c5 -30 20 -30 25 0 s20 30 25 0" fill="none" stroke="red" stroke-width="3"/>',
    "round corners": '<rect x="10" y="10" width="60" height="30" rx="50" ry="10"/><rect x="10" y="50" width="60" height="30" ry="8"/>',
    "nothing": '<rect x="10" width="0" height="9"/><circle r="0"/><ellipse rx="-3" ry="4"/><line x1="5" x2="5" stroke="red"/><polygon points=""/>',
    "faint groups": '<g opacity=".5"><rect x="10" y="10" width="40" height="40" fill="red"/></g>',
    "evenodd": '<path fill-rule="evenodd" d="M10 10h60v60h-60z M20 20h40v40h-40z M30 30h20v20h-20z"/>',
    "a window": '<svg x="10" y="10" width="40" height="20" viewBox="0 0 10 10" preserveAspectRatio="xMaxYMid meet"><rect width="10" height="10" fill="red"/></svg>'
    '<svg x="10" y="50" width="40" height="20" viewBox="0 0 10 10" preserveAspectRatio="none"><circle cx="5" cy="5" r="5" fill="red"/></svg>',
    "a pattern": '<pattern id="p" patternUnits="userSpaceOnUse" width="16" height="12"><rect width="8" height="6" fill="purple"/></pattern>'
    '<rect x="10" y="10" width="70" height="60" fill="url(#p)"/>',
    "a pattern by another": '<pattern id="q" patternUnits="userSpaceOnUse" width="20" height="20"><circle cx="10" cy="10" r="6"/></pattern>'
    '<pattern id="p" xlink:href="#q" patternTransform="rotate(30)"/><rect x="10" y="10" width="70" height="60" fill="url(#p)"/>',
}


@pytest.mark.parametrize("name", DRAWN)
def test_what_is_drawn_is_what_another_program_draws(name: str, tmp_path: Path) -> None:
    far = np.abs(ours(tmp_path, DRAWN[name]) - theirs(DRAWN[name])).max(axis=-1)
    assert (far > 90).mean() < 0.012, (far > 90).mean()


def where(made: Drawing) -> list[float]:
    """What all of it fills: left, top, right, low, in units of the sheet."""
    at = np.concatenate([made.paths[i] for i in range(len(made.paths))]) / made.size[0] * 100
    return [*at.min(0).round(3).tolist(), *at.max(0).round(3).tolist()]


PLACES: dict[str, tuple[str, list[float]]] = {
    "units of the view": ('<rect x="10vw" y="20vh" width="30vmin" height="10vmax"/>', [10, 20, 40, 30]),
    "ex": ('<g font-size="10"><rect width="4ex" height="1em"/></g>', [0, 0, 20, 10]),
    "a turn about a place of its own": (
        '<rect x="20" y="20" width="20" height="10" style="transform-origin:20px 20px;transform:rotate(90deg)"/>',
        [10, 20, 20, 40],
    ),
    "about the middle of the view": (
        '<rect x="50" y="50" width="20" height="10" transform-origin="center" transform="rotate(180)"/>',
        [30, 40, 50, 50],
    ),
    "about a corner of the view": (
        '<rect x="80" width="20" height="10" transform-origin="top right" transform="scale(.5)"/>',
        [90, 0, 100, 5],
    ),
    "about the right": ('<rect x="80" y="50" width="20" height="10" transform-origin="right" transform="scale(.5)"/>', [90, 50, 100, 55]),
    "CSS's transforms": (
        '<rect width="10" height="10" style="transform:translateX(20px) translateY(5px) scaleX(2) scaleY(3)"/>',
        [20, 5, 40, 35],
    ),
    "larger letters": ('<g font-size="10"><g style="font-size:larger"><rect width="1em" height="1em"/></g></g>', [0, 0, 12, 12]),
    "medium letters": ('<g style="font-size:medium"><rect width="1em" height="1em"/></g>', [0, 0, 16, 16]),
}  # fmt: skip


@pytest.mark.parametrize("name", PLACES)
def test_lengths_and_turns_lie_where_they_are_said_to(name: str, tmp_path: Path) -> None:
    body, wanted = PLACES[name]
    assert where(drawn(tmp_path, body)) == pytest.approx(wanted, abs=0.02)


MARKED = '<marker id="m" {} overflow="visible"><path d="M0 0 L10 5 L0 10z" fill="red"/></marker><path d="M10 50 H50 V80" marker-{}="url(#m)" fill="none" stroke="#000" stroke-width="2"/>'
MARKERS: dict[str, tuple[str, list[float]]] = {
    "at the end, along it": (MARKED.format('orient="auto" refX="10" refY="5" markerWidth="5" markerHeight="5"', "end"), [40, 60, 60, 80]),
    "fitted into its box": (
        MARKED.format('viewBox="0 0 10 10" refX="0" refY="5" markerWidth="5" markerHeight="5" markerUnits="userSpaceOnUse"', "end"),
        [50, 77.5, 55, 82.5],
    ),
    "backwards at the start": (
        MARKED.format('viewBox="0 0 10 10" refX="0" refY="5" markerWidth="5" markerHeight="5" markerUnits="userSpaceOnUse" orient="auto-start-reverse"', "start"),
        [5, 47.5, 10, 52.5],
    ),
    "turned by itself": (
        MARKED.format('viewBox="0 0 10 10" refX="0" refY="5" markerWidth="5" markerHeight="5" markerUnits="userSpaceOnUse" orient="90deg"', "start"),
        [7.5, 50, 12.5, 55],
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", MARKERS)
def test_markers_stand_where_their_lines_lead(name: str, tmp_path: Path) -> None:
    body, wanted = MARKERS[name]
    made = drawn(tmp_path, body)
    fills = made.styles.fill[made.style]
    red = [m for m in range(len(made)) if fills[m].tolist() == [255, 0, 0, 255]]
    at = np.concatenate([made.paths[int(made.paths.parts[m])] for m in red]) / made.size[0] * 100
    assert [*at.min(0), *at.max(0)] == pytest.approx(wanted, abs=0.05)


TOLD: dict[str, str] = {
    '<rect width="9" height="9" fill="var(--ink)"/>': "a colour by var()",
    '<style>a:hover > b::before, rect:first-child + p{fill:red} @media print{rect{fill:lime}}</style>': "a style rule whose selector is not known",
    '<path d="M0 0h9" stroke="red" stroke-dasharray="4 x"/>': "stroke-dasharray: '4 x' means nothing",
    '<path d="M0 0h9" stroke="no-colour"/>': "stroke: 'no-colour' means nothing there",
    '<g opacity=".5" viewBox="1"/><symbol id="s" viewBox="1 2 3"><rect/></symbol><use href="#s"/>': "is not four numbers",
    '<polygon points="0,0 5,5 x"/>': "is no number",
    '<polygon points="0,0 5,5 1e99,0"/>': "is too large",
    '<rect width="5" height="5" transform="skewX()"/>': "no transform",
    '<path d="M0 0 C 1 1"/>': "breaks off in the middle of 'C'",
    '<radialGradient id="g" r="x"><stop/></radialGradient><rect width="9" height="9" fill="url(#g)"/>': "r: ",
    '<linearGradient id="g" gradientTransform="turn(9)"><stop/></linearGradient><rect width="9" height="9" fill="url(#g)"/>': "gradientTransform: ",
    '<linearGradient id="g"><stop offset="x" stop-opacity="much"/></linearGradient><rect width="9" height="9" fill="url(#g)"/>': "offset: 'x' means nothing",
    '<linearGradient id="g"><stop stop-color="no"/></linearGradient><rect width="9" height="9" fill="url(#g)"/>': "no",
    '<rect width="9" height="9" fill="url(#p)"/><pattern id="p" width="x" height="1"><rect width="1" height="1"/></pattern>': "a pattern as paint",
    '<text font-size="9">Ж中</text>': "letters that the shipped font lacks: ",
    '<text font-size="9"><textPath href="#gone">far</textPath></text>': "text on a path that is not there",
    '<path id="w" d="M0 5h5"/><text font-size="9"><textPath href="#w">much too long</textPath></text>': "letters beyond the end of their path",
    '<rect width="9" height="9" style="clip-path:circle(5px)"/>': "clip-path by a shape of CSS",
    '<clipPath id="c"><rect width="3" height="3" clip-path="url(#c)"/></clipPath><rect width="9" height="9" clip-path="url(#c)"/>': "cuts itself",
    '<image width="9" height="9" href="data:image/png;base64,AAAA"/>': "an image that cannot be read",
    '<circle r="1" fill="hsl(x, 1%, 1%)"/>': "hsl",
    '<rect width="1e9mm" height="1"/>': "too large",
}  # fmt: skip


@pytest.mark.parametrize("body", TOLD)
def test_what_means_nothing_is_told_and_the_rest_is_drawn(body: str, tmp_path: Path) -> None:
    made = drawn(tmp_path, '<rect x="50" width="10" height="10"/>' + body)
    said = made.about.get("doubts", "") + made.about.get("ignored", "")
    assert TOLD[body] in said, said
    first: Any = made.paths[0] / made.size[0] * 100
    assert [*first.min(0), *first.max(0)] == pytest.approx([50, 0, 60, 10])
