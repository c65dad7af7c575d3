"""Sixty drawings spelt as Inkscape, Illustrator, Canva and Affinity spell them: every shape is there, with its colour and its area."""

from __future__ import annotations

import itertools
import math
import random
from collections import defaultdict

import numpy as np
import pytest
import shapely
from shapely.affinity import affine_transform

from tambour import files
from tambour.core.progress import Progress
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.plan.make import make
from tambour.geometry.areas import enclosed


def drawing(number):
    """Items (kind, numbers, colour, stroke width, matrix, clip) of drawing ``number``, on a page of 200 x 120 px."""
    draw = random.Random(number)
    made = []
    for k in range(4 + number % 4):
        kind = ("rect", "circle", "ring", "line")[(k + number) % 4]
        x, y, size = 15 + 40 * k % 150, draw.randint(15, 70), draw.randint(12, 28)
        matrix = (1, 0, 0, 1, 0, 0) if k % 3 else (0.8, 0.3, -0.3, 0.8, draw.randint(0, 20), draw.randint(-8, 8))
        clip = (x + 2, y + 2, size - 5, size + 9) if k % 3 == 1 and kind != "line" else None
        made.append(
            (
                kind,
                (x, y, size),
                f"#{draw.randrange(40, 200):02x}{30 * k + 20:02x}{draw.randrange(40, 200):02x}",
                4,
                matrix,
                clip,
            )
        )
    return made


def area_of(kind, x, y, size, wide):
    if kind == "rect":
        return shapely.box(x, y, x + size, y + size / 2)
    if kind == "circle":
        return shapely.Point(x + size / 2, y + size / 2).buffer(size / 2, quad_segs=64)
    if kind == "ring":
        return shapely.box(x, y, x + size, y + size) - shapely.box(x + 5, y + 5, x + size - 5, y + size - 5)
    return shapely.LineString([(x, y), (x + size, y + size)]).buffer(wide / 2, cap_style="flat")


def expected(items):
    """colour → px² that the drawing's fills and strokes have, by shapely alone."""
    made = defaultdict(float)
    for kind, (x, y, size), color, wide, matrix, clip in items:
        area = area_of(kind, x, y, size, wide)
        if clip:
            area = area & shapely.box(clip[0], clip[1], clip[0] + clip[2], clip[1] + clip[3])
        a, b, c, d, e, f = matrix
        made[color] += affine_transform(area, (a, c, b, d, e, f)).area
    return made


def way(kind, x, y, size):
    if kind == "rect":
        return f"M{x} {y}h{size}v{size / 2}h-{size}z"
    if kind == "circle":
        r = size / 2
        return f"M{x},{y + r}a{r},{r} 0 1,0 {size},0a{r},{r} 0 1,0 -{size},0Z"
    if kind == "ring":
        i = size - 10
        return f"M{x},{y}v{size}h{size}v-{size}z M{x + 5},{y + 5}h{i}v{i}h-{i}z"
    return f"M{x} {y}L{x + size} {y + size}"


def _transform(matrix):
    return "" if matrix == (1, 0, 0, 1, 0, 0) else ' transform="matrix({} {} {} {} {} {})"'.format(*matrix)


def inkscape(items):
    defs, body = "", ""
    for k, (kind, (x, y, size), color, wide, matrix, clip) in enumerate(items):
        style = (
            f"fill:none;stroke:{color};stroke-width:{wide}px"
            if kind == "line"
            else f"fill:{color};fill-opacity:1;stroke:none;fill-rule:evenodd"
        )
        if clip:
            defs += f'<clipPath clipPathUnits="userSpaceOnUse" id="clipPath{k}"><rect x="{clip[0]}" y="{clip[1]}" width="{clip[2]}" height="{clip[3]}" id="r{k}"/></clipPath>'
        cut = f' clip-path="url(#clipPath{k})"' if clip else ""
        body += f'<path style="{style};-inkscape-stroke:none" d="{way(kind, x, y, size)}" id="path{k}" inkscape:connector-curvature="0"{cut}{_transform(matrix)}/>'
    return (
        '<?xml version="1.0" encoding="UTF-8" standalone="no"?><svg width="200px" height="120px" viewBox="0 0 200 120" version="1.1" id="svg5" '
        'inkscape:version="1.3 (0e150ed, 2023-07-21)" sodipodi:docname="a.svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" '
        'xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd" xmlns="http://www.w3.org/2000/svg"><sodipodi:namedview id="v" pagecolor="#ffffff">'
        f'<inkscape:grid type="xygrid" id="g"/></sodipodi:namedview><defs id="defs2">{defs}</defs><g inkscape:label="Layer 1" inkscape:groupmode="layer" id="layer1">{body}</g></svg>'
    )


def illustrator(items):
    sheet, body = "", ""
    for k, (kind, (x, y, size), color, wide, matrix, clip) in enumerate(items):
        look = (
            f"fill:none;stroke:{color.upper()};stroke-width:{wide};stroke-miterlimit:10;"
            if kind == "line"
            else f"fill-rule:evenodd;clip-rule:evenodd;fill:{color.upper()};"
        )
        sheet += f"\t.st{2 * k}{{{look}}}\n"
        shape = f'<path class="st{2 * k}" d="{way(kind, x, y, size)}"/>'
        if kind == "line":
            shape = f'<line class="st{2 * k}" x1="{x}" y1="{y}" x2="{x + size}" y2="{y + size}"/>'
        if clip:
            sheet += f"\t.st{2 * k + 1}{{clip-path:url(#SVGID_{k}_);}}\n"
            shape = (
                f'<g><defs><rect id="SVGID_{k}B_" x="{clip[0]}" y="{clip[1]}" width="{clip[2]}" height="{clip[3]}"/></defs><clipPath id="SVGID_{k}_">'
                f'<use xlink:href="#SVGID_{k}B_" style="overflow:visible;"/></clipPath><g class="st{2 * k + 1}">{shape}</g></g>'
            )
        body += f"<g{_transform(matrix)}>{shape}</g>"
    return (
        '<?xml version="1.0" encoding="utf-8"?><!-- Generator: Adobe Illustrator 27.0.0, SVG Export Plug-In . SVG Version: 6.00 Build 0)  -->'
        '<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd" [<!ENTITY ns_ai "http://ns.adobe.com/AdobeIllustrator/10.0/">]>'
        '<svg version="1.1" id="Layer_1" xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" xmlns:i="&ns_ai;" x="0px" y="0px" '
        f'width="200px" height="120px" viewBox="0 0 200 120" style="enable-background:new 0 0 200 120;" xml:space="preserve"><style type="text/css">\n{sheet}</style>'
        f'<switch><foreignObject requiredExtensions="&ns_ai;" x="0" y="0" width="1" height="1"/><g i:extraneous="self"><g id="Ebene_x0020_1">{body}</g></g></switch></svg>'
    )


def canva(items):
    defs, body = "", ""
    for k, (kind, (x, y, size), color, wide, matrix, clip) in enumerate(items):
        paint = f'stroke-linecap="butt" transform="matrix(0.75,0,0,0.75,0,0)" fill="none" stroke-linejoin="miter" stroke="{color}" stroke-width="{wide / 0.75}" stroke-opacity="1" stroke-miterlimit="4"'
        line = kind == "line"
        d = way(kind, x / 0.75, y / 0.75, size / 0.75) if line else way(kind, x, y, size)
        shape = (
            f'<path {paint} d="{d}"/>'
            if line
            else f'<path fill="{color}" d="{d}" fill-opacity="1" fill-rule="evenodd"/>'
        )
        if clip:
            x0, y0, w, h = clip
            defs += f'<clipPath id="{k}f0a1b2c3d4"><path d="M {x0} {y0} L {x0 + w} {y0} L {x0 + w} {y0 + h} L {x0} {y0 + h} Z M {x0} {y0} " clip-rule="nonzero"/></clipPath>'
            shape = f'<g clip-path="url(#{k}f0a1b2c3d4)">{shape}</g>'
        body += f"<g{_transform(matrix)}>{shape}</g>"
    return (
        '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" width="200" zoomAndPan="magnify" viewBox="0 0 200 120" height="120" '
        f'preserveAspectRatio="xMidYMid meet" version="1.0"><defs><g/>{defs}</defs>{body}</svg>'
    )


def affinity(items):
    defs, body = "", ""
    for k, (kind, (x, y, size), color, wide, matrix, clip) in enumerate(items):
        rgb = "rgb({},{},{})".format(*bytes.fromhex(color[1:]))
        style = (
            f"fill:none;stroke:{rgb};stroke-width:{wide}px;stroke-linejoin:miter;" if kind == "line" else f"fill:{rgb};"
        )
        shape = f'<path d="{way(kind, x, y, size)}" style="{style}"/>'
        if kind == "rect":
            shape = f'<rect x="{x}" y="{y}" width="{size}" height="{size / 2}" style="{style}"/>'
        if clip:
            defs = f'<clipPath id="_clip{k}"><rect x="{clip[0]}" y="{clip[1]}" width="{clip[2]}" height="{clip[3]}"/></clipPath>'
            shape = f'{defs}<g clip-path="url(#_clip{k})">{shape}</g>'
        body += f"<g{_transform(matrix)}>{shape}</g>"
    return (
        '<?xml version="1.0" encoding="UTF-8" standalone="no"?><!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd">'
        '<svg width="100%" height="100%" viewBox="0 0 200 120" version="1.1" xmlns="http://www.w3.org/2000/svg" xmlns:serif="http://www.serif.com/" xml:space="preserve" '
        f'style="fill-rule:evenodd;clip-rule:evenodd;stroke-miterlimit:1.5;"><g id="Artboard1" serif:id="Artboard 1">{body}</g></svg>'
    )


@pytest.mark.parametrize(
    ("number", "program"), list(itertools.product(range(15), (inkscape, illustrator, canva, affinity)))
)
def test_an_export_loses_no_shape(tmp_path, number, program):
    items = drawing(number)
    path = tmp_path / "a.svg"
    path.write_text(program(items))
    made = files.read(path, ("Drawing",))
    px = (25.4 / 96) ** 2
    found = defaultdict(float)
    for m, style in enumerate(made.style.tolist()):
        lines = [made.paths[i] for i in range(int(made.paths.parts[m]), int(made.paths.parts[m + 1]))]
        fill, stroke = made.styles.fill[style], made.styles.stroke[style]
        if fill[3]:
            found["#" + bytes(fill[:3].tolist()).hex()] += enclosed(lines, bool(made.styles.evenodd[style])).area / px
        if stroke[3]:
            length = sum(float(np.hypot(*np.diff(line, axis=0).T).sum()) for line in lines)
            found["#" + bytes(stroke[:3].tolist()).hex()] += length * float(made.styles.width[style]) / px
    wanted = {c: a for c, a in expected(items).items() if a > 1e-9}
    assert set(found) == set(wanted)
    for color, area in wanted.items():
        assert math.isclose(found[color], area, rel_tol=0.01), color
    left_out = made.about.get("ignored", "").replace("foreignObject", "").strip(", ")
    assert not left_out and "doubts" not in made.about


@pytest.mark.parametrize("program", [inkscape, illustrator, canva, affinity])
def test_exports_are_sewn(tmp_path, program):
    for number in (2, 7):
        items = drawing(number)
        path = tmp_path / "a.svg"
        path.write_text(program(items))
        piece = make(files.read(path, ("Drawing",)), EmbroideryParams(width=100.0), Progress())
        threads = {"#" + bytes(t.rgb).hex() for t in piece.plan.threads}
        assert threads == {c for c, a in expected(items).items() if a > 1}


def test_a_span_in_another_typeface_is_told(tmp_path):
    (tmp_path / "a.svg").write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" width="90" height="40"><text x="2" y="30" style="font-family:sans-serif">'
        '<tspan style="font-family:Oxanium">Club</tspan><tspan> and</tspan></text></svg>'
    )
    assert files.read(tmp_path / "a.svg", ("Drawing",)).about["ignored"] == "the font Oxanium (Inter is used)"


def test_canva_cuts_its_pictures_by_clips_and_by_pictures_in_masks(tmp_path):
    """Its transparent pictures are two: the colours, and behind filters in a mask the light that lets them through."""
    import base64
    import io

    from PIL import Image

    def png(array):
        held = io.BytesIO()
        Image.fromarray(array).save(held, "PNG")
        return f"data:image/png;base64,{base64.b64encode(held.getvalue()).decode()}"

    red = np.zeros((40, 60, 3), np.uint8)
    red[..., 0] = 200
    light = np.zeros((40, 60, 3), np.uint8)
    light[10:30, 15:45] = 255
    place = 'x="0" y="0" width="60" height="40" preserveAspectRatio="xMidYMid meet"'
    (tmp_path / "a.svg").write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" width="120" height="80" viewBox="0 0 120 80"><defs>'
        '<filter id="f"><feColorMatrix values="0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 0.2126 0.7152 0.0722 0 0"/></filter>'
        '<clipPath id="c"><path d="M0 0H60V80H0Z"/></clipPath>'
        f'<mask id="m"><g filter="url(#f)"><g filter="url(#f)" transform="scale(2)"><image {place} xlink:href="{png(light)}"/></g></g></mask></defs>'
        f'<g clip-path="url(#c)"><g mask="url(#m)"><g transform="scale(2)"><image {place} xlink:href="{png(red)}"/></g></g></g></svg>'
    )
    made = files.read(tmp_path / "a.svg", ("Drawing",))
    (picture,) = made.images
    expected = np.zeros((40, 60), bool)
    expected[10:30, 15:30] = True  # the mask's light, left of the clip's edge
    assert ((picture.picture.rgba[..., 3] > 127) == expected).all() and not made.about.get("ignored")
    piece = make(made, EmbroideryParams(width=60), Progress())
    assert sum(r.color[0] > 150 and max(r.color[1:]) < 60 for r in piece.regions) >= 1


def test_shapes_in_a_mask_that_is_a_picture_are_whole_and_it_is_told(tmp_path):
    (tmp_path / "a.svg").write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" width="40" height="40"><mask id="m"><image width="9" height="9" href="data:image/png;base64,'
        'iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8z8BQDwAEhQGAhKmMIQAAAABJRU5ErkJggg=="/></mask>'
        '<rect width="30" height="30" mask="url(#m)"/></svg>'
    )
    made = files.read(tmp_path / "a.svg", ("Drawing",))
    assert len(made.paths) == 1 and made.about["ignored"] == "a mask that is a picture"


def test_a_mask_with_a_filter_hides_nothing_and_is_told(tmp_path):
    """Canva makes things translucent so: a black rectangle whose opacity a filter turns into light."""
    (tmp_path / "a.svg").write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" width="40" height="40"><filter id="f"/><mask id="m"><g filter="url(#f)">'
        '<rect width="40" height="40" fill-opacity=".7"/></g></mask><rect width="30" height="30" mask="url(#m)"/></svg>'
    )
    made = files.read(tmp_path / "a.svg", ("Drawing",))
    assert len(made.paths) == 1 and made.about["ignored"] == "a mask with a filter"
