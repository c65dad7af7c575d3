"""SVG as programs write it: geometry, style, units, notes; and hostile files."""

from __future__ import annotations

import gzip
import math
import time
from itertools import permutations

import numpy as np
import pytest
import shapely
import svgelements
from hypothesis import example, given, settings
from hypothesis import strategies as st

from tambour import files
from tambour.core.errors import TambourError
from tambour.files.svg import css
from tambour.files.svg.path import PathError, arc, flatten, transform

HEAD = '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" xmlns:inkstitch="http://inkstitch.org/namespace" width="100mm" height="50mm" viewBox="0 0 100 50">'


def read(tmp_path, body, head=HEAD):
    path = tmp_path / "a.svg"
    path.write_text(head + body + "</svg>")
    return files.read(path, ("Drawing",))


def areas(drawing):
    parts = drawing.paths.parts
    return [
        sum(shapely.Polygon(drawing.paths[i]).area for i in range(parts[m], parts[m + 1]) if len(drawing.paths[i]) > 3)
        for m in range(len(drawing))
    ]


def test_shapes_have_their_areas_in_mm(tmp_path):
    made = read(
        tmp_path,
        '<rect x="1" y="2" width="10" height="4"/><circle cx="50" cy="20" r="7"/><ellipse cx="20" cy="20" rx="5" ry="3"/>'
        '<polygon points="0,0 4,0 4,3"/><rect width="10" height="10" rx="2"/><path d="M0 0h6v2h-6z"/>',
    )
    assert np.allclose(areas(made), [40, math.pi * 49, math.pi * 15, 6, 100 - (4 - math.pi) * 4, 12], rtol=5e-3)
    assert np.allclose(made.size, [100, 50])


def test_units_and_viewbox(tmp_path):
    square = '<path d="M0 0h10v10h-10z"/>'
    for head, mm in (
        ('<svg width="100" height="100">', 10 * 25.4 / 96),
        ('<svg width="2in" height="2in" viewBox="0 0 20 20">', 25.4),
        ('<svg viewBox="0 0 96 96">', 10 * 25.4 / 96),
        ('<svg width="10cm" height="5cm" viewBox="0 0 100 100">', 5),
        ('<svg width="10cm" height="5cm" viewBox="0 0 100 100" preserveAspectRatio="xMinYMin slice">', 10),
    ):
        made = read(tmp_path, square, head)
        assert np.isclose(np.ptp(made.paths.coords[:, 0]), mm), head


def test_rem_is_the_size_of_letters_of_the_root(tmp_path):
    """Of attributes, of style and of sheets, whatever size lies between; the root's own is of the initial 16 px."""
    for head, rem in (
        ('<svg width="10in" viewBox="0 0 960 960">', 16),
        ('<svg width="10in" viewBox="0 0 960 960" font-size="32">', 32),
        ('<svg width="10in" viewBox="0 0 960 960" style="font-size: 2rem">', 32),
        ('<svg width="10in" viewBox="0 0 960 960"><style>svg {font-size: 20px} #s {stroke-width: 2rem}</style>', 20),
    ):
        body = '<g font-size="64"><rect id="s" width="3rem" height="1em" y="1REM" fill="none" stroke="red" '
        made = read(tmp_path, body + ("/>" if "#s" in head else 'style="stroke-width:2rem"/>') + "</g>", head)
        low, high = made.paths.coords.min(0) / 25.4 * 96, made.paths.coords.max(0) / 25.4 * 96
        assert np.allclose(high - low, [3 * rem, 64], rtol=1e-6) and np.isclose(low[1], rem), head
        assert np.allclose(made.styles.width[made.style] / 25.4 * 96, 2 * rem), head
    for unit, px in (("rem", 32), ("em", 32)):
        made = read(tmp_path, '<rect width="9" height="9"/>', f'<svg width="10{unit}" height="5{unit}" font-size="32">')
        assert np.allclose(made.size, [10 * px * 25.4 / 96, 5 * px * 25.4 / 96])


def test_a_straight_curve_has_no_box_for_a_gradient(tmp_path):
    """Its rounding is no width: the paint that was meant for such a case is used, or nothing."""
    of_box = '<linearGradient id="g"><stop stop-color="#f00"/></linearGradient>'
    path = '<path d="M 100 20 C 100 40 100 160 100 180" fill="none" stroke="url(#g){}" stroke-width="3"/>'
    head = '<svg viewBox="0 0 200 200">'
    assert len(read(tmp_path, of_box + path.format(""), head)) == 0
    instead = read(tmp_path, of_box + path.format(" #0f0"), head)
    used = np.concatenate([instead.styles.fill[instead.style], instead.styles.stroke[instead.style]])
    assert (used[used[:, 3] > 0][:, :3] == [0, 255, 0]).all() and len(instead) == 1


def test_path_data_in_all_its_forms():
    for data, points in {
        "M1 2 3 4L5,6": [(1, 2), (3, 4), (5, 6)],
        "m1-2.5.5l1 1": [(1, -2.5), (1.5, -2.5 + 1)] if False else None,
        "M0,0h1v1H0Z": [(0, 0), (1, 0), (1, 1), (0, 1)],
        "M0 0l1e1-1": [(0, 0), (10, -1)],
        "M.5.5.7.7": [(0.5, 0.5), (0.7, 0.7)],
    }.items():
        if points is not None:
            assert np.allclose(flatten(data, 0.01)[0][0], points)
    flags = flatten("M0 0a5 5 0 1110 0", 0.01)[0][0]  # flags without spaces
    assert np.allclose(flags[-1], (10, 0))
    smooth = flatten("M0 0C0 5 5 5 5 0S10-5 10 0", 0.001)[0][0]
    assert smooth[:, 1].min() == pytest.approx(-3.75, abs=0.01)
    assert flatten("M0 0Q5 10 10 0T20 0", 0.001)[0][0][:, 1].min() == pytest.approx(-5, abs=0.01)
    for broken in ("L1 1", "M0 0 X", "M0 0 L1", "M0 0 C1 2 3", "M1e999 0 1 1", "5 5", "M0 0 L nan 1"):
        with pytest.raises(PathError):
            flatten(broken, 0.01)


def test_arcs_lie_on_their_ellipse():
    points = np.array([(0.0, 0.0), *arc((0, 0), 5, 3, 30, True, False, (4, 1), 0.001)])
    c, s = math.cos(math.radians(30)), math.sin(math.radians(30))
    turned = points @ np.array([[c, -s], [s, c]])
    scaled = turned / [5, 3]
    a = np.c_[2 * scaled, np.ones(len(scaled))]
    center = np.linalg.lstsq(a, (scaled**2).sum(1), rcond=None)[0]
    assert np.allclose(np.hypot(*(scaled - center[:2]).T), 1, atol=1e-6)


_place = st.integers(-40, 40).map(lambda v: v / 4)
_radius = st.integers(1, 60).map(lambda v: v / 4)


@settings(max_examples=60, deadline=None)
@given(_place, _place, _radius, _radius, st.integers(-180, 180), st.booleans(), st.booleans())
@example(4.0, 1.0, 5.0, 3.0, 30, False, False)
@example(4.0, 1.0, 5.0, 3.0, 30, True, False)
@pytest.mark.slow
def test_arcs_are_those_of_another_program(x, y, rx, ry, turn, large, sweep):
    if math.hypot(x, y) < 0.5:
        return
    points = np.array([(0.0, 0.0), *arc((0.0, 0.0), rx, ry, turn, large, sweep, (x, y), 0.001)])
    data = f"M0 0A{rx} {ry} {turn} {int(large)} {int(sweep)} {x} {y}"
    other = next(s for s in svgelements.Path(data) if isinstance(s, svgelements.Arc))
    exact = np.array([(q.x, q.y) for q in map(other.point, np.linspace(0, 1, 300))])
    wide = np.ptp(exact, axis=0).max()
    ours, theirs = shapely.LineString(points), shapely.LineString(exact)
    assert shapely.hausdorff_distance(ours, theirs) < 0.002 + 2e-4 * wide
    assert np.allclose(points[[0, -1]], exact[[0, -1]], atol=1e-6)


_mark = st.sampled_from("ab")
_compound = st.tuples(st.sampled_from(["*", "g", "rect"]), st.sampled_from(["", "i", "j"]), st.frozensets(_mark))
_selector = st.lists(st.tuples(_compound, st.sampled_from(" >")), min_size=1, max_size=5)
_chain = st.lists(
    st.tuples(st.sampled_from(["g", "rect"]), st.sampled_from(["", "i", "j"]), st.frozensets(_mark)),
    min_size=1,
    max_size=7,
)


def _selects(selector, chain):
    """Whether a selector fits the last of a chain of elements, by its definition."""
    (name, named, classed), joined = selector[-1]
    element, its_id, classes = chain[-1]
    if name not in ("*", element) or named not in ("", its_id) or not classed <= classes:
        return False
    if len(selector) == 1:
        return True
    ends = range(1, len(chain)) if joined == " " else range(max(1, len(chain) - 1), len(chain))
    return any(_selects(selector[:-1], chain[:end]) for end in ends)


@settings(max_examples=200, deadline=None)
@given(st.lists(_selector, min_size=1, max_size=4), _chain)
@example(  # a grandparent is no parent
    [[(("g", "", frozenset()), " "), (("rect", "", frozenset()), ">")]],
    [("g", "", frozenset()), ("rect", "", frozenset()), ("rect", "", frozenset())],
)
@pytest.mark.slow
def test_selectors_select_what_they_say(selectors, chain):
    def spelt(selector):
        text = ""
        for k, ((name, named, classed), joined) in enumerate(selector):
            text += (
                (joined if k else "") + name + "".join("." + c for c in sorted(classed)) + ("#" + named) * bool(named)
            )
        return text

    rules = css.Rules(css.sheet("".join(f"{spelt(s)}{{p{k}: 1}}" for k, s in enumerate(selectors))))
    met = css.NOTHING
    for element in chain:
        met = rules.meet(met, *element)
    assert set(rules.declared(met)) == {f"p{k}" for k, s in enumerate(selectors) if _selects(s, chain)}


@pytest.mark.parametrize(
    "body",
    [
        "<style>q g g g g g g g g rect{fill:red}</style>" + "<g>" * 150 + "<rect width='9' height='9'/>" + "</g>" * 150,
        "<style>" + "a" * 400_000 + "</style><rect width='9' height='9'/>",
        "<style>" + "@a{" * 60_000 + "</style><rect width='9' height='9'/>",
        "<rect style='" + "/* " * 200_000 + "' width='9' height='9'/>",
        "<rect id='a' width='9' height='9'/>" * 20_000,
    ],
    ids=["many ways", "no rule", "open rules", "open comment", "one id"],
)
@pytest.mark.slow
def test_small_files_do_not_stop_the_machine(tmp_path, body):
    begin = time.process_time()
    assert len(read(tmp_path, body)) >= 1
    assert time.process_time() - begin < 12  # a second or two; without memory, half a minute to hours


def test_transforms_are_done_from_right_to_left(tmp_path):
    m = transform("translate(10,5) rotate(90) scale(2)")
    assert np.allclose(m @ [1, 0, 1], [10, 7])
    made = read(tmp_path, '<g transform="translate(10 0)"><rect width="2" height="1" transform="scale(3)"/></g>')
    assert np.allclose(made.paths.coords.min(0), [10, 0]) and np.allclose(made.paths.coords.max(0), [16, 3])


def test_style_comes_from_sheet_attribute_and_inheritance(tmp_path):
    made = read(
        tmp_path,
        "<style>.a{fill:#f00} g > rect{stroke:blue} #x{fill:rgb(0,50%,0)!important}</style>"
        '<g fill="yellow" stroke-width="2"><rect class="a" width="1" height="1"/><rect id="x" class="a" width="1" height="1"/>'
        '<rect style="fill:hsl(240,100%,50%);stroke:none" width="1" height="1"/><rect width="1" height="1" opacity=".5"/></g>'
        '<rect fill="none" width="1" height="1"/><rect display="none" width="1" height="1"/>',
    )
    styles = made.styles.fill[made.style].tolist()
    # What is translucent shows no fill below its stroke: two shapes.
    assert styles == [[255, 0, 0, 255], [0, 128, 0, 255], [0, 0, 255, 255], [255, 255, 0, 128], [0, 0, 0, 0]]
    assert made.styles.stroke[made.style][0].tolist() == [0, 0, 255, 255]
    assert made.styles.width[made.style][0] == 2


def test_the_weightier_rule_wins_wherever_it_stands(tmp_path):
    rules = ["rect{fill:#000001}", ".a{fill:#000002}", ".a.b{fill:#000003}", "#x{fill:#000004}"]
    for order in permutations(rules):
        shown = "".join(order)
        made = read(tmp_path, f"<style>{shown}</style>" + "".join(f"<rect {a} width='1' height='1'/>" for a in _MARKED))
        assert made.styles.fill[made.style, 2].tolist() == [1, 2, 3, 4], shown


_MARKED = ["", "class='a'", "class='a b'", "class='a b' id='x'"]


def test_equal_ids_become_unlike_ones(tmp_path):
    box = "<rect id='{}' width='1' height='1'/>"
    made = read(tmp_path, "".join(box.format(k) for k in ("a", "a", "a-2", "a", "b")))
    assert made.groups is not None and made.groups.ids == ("a", "a-2", "a-2-2", "a-3", "b")


def test_use_symbol_and_nested_svg(tmp_path):
    made = read(
        tmp_path,
        '<defs><rect id="r" width="2" height="2"/><symbol id="s" viewBox="0 0 10 10"><circle cx="5" cy="5" r="5"/></symbol></defs>'
        '<use href="#r" x="20" y="3"/><use xlink:href="#s" x="40" width="20" height="20"/>'
        '<svg x="70" width="10" height="10" viewBox="0 0 1 1"><rect width="1" height="1"/></svg>',
    )
    boxes = [made.paths[i].min(0).round(3).tolist() + made.paths[i].max(0).round(3).tolist() for i in range(len(made))]
    assert np.allclose(boxes, [[20, 3, 22, 5], [40, 0, 60, 20], [70, 0, 80, 10]], atol=0.05)


def test_text_becomes_outlines_in_the_shipped_face(tmp_path):
    made = read(
        tmp_path,
        '<text x="50" y="40" font-size="20" text-anchor="middle" font-family="Comic Sans">H<tspan font-size="10">i</tspan></text>',
    )
    low, high = made.paths.coords.min(0), made.paths.coords.max(0)
    assert abs((low[0] + high[0]) / 2 - 50) < 8 and 12 < high[1] - low[1] < 16 and abs(high[1] - 40) < 0.1
    assert "Comic Sans" in made.about["ignored"]


def test_notes_of_elements_and_commands(tmp_path):
    made = read(
        tmp_path,
        '<g inkscape:label="Layer 1" inkscape:groupmode="layer" id="l"><path id="p" data-tambour-angle="45" inkstitch:row_spacing_mm="0.5" '
        'd="M0 0h10v10z"/></g><use id="u" xlink:href="#inkstitch_trim" x="3" y="4"/>'
        '<path inkscape:connection-start="#u" inkscape:connection-end="#p" d="M0 0 1 1"/>',
    )
    k = made.groups.ids.index("p")
    assert made.groups.data[k] == {
        "tambour-angle": "45",
        "inkstitch-row_spacing_mm": "0.5",
        "inkstitch-command-trim": "3.000000 4.000000",
    }
    assert made.groups.layer[made.groups.ids.index("l")] and len(made) == 1


BOMB = '<?xml version="1.0"?><!DOCTYPE svg [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;&a;"><!ENTITY c "&b;&b;&b;&b;">]><svg xmlns="http://www.w3.org/2000/svg"><text>&c;</text></svg>'


@pytest.mark.parametrize(
    ("text", "word"),
    [
        ("", "empty"),
        ("hello", "well-formed"),
        ("<svg", "well-formed"),
        ("<html></html>", "not an SVG"),
        (BOMB, "entity"),
        ('<!DOCTYPE svg [<!ENTITY x SYSTEM "file:///etc/passwd">]><svg>&x;</svg>', "outside the file"),
        ("<svg>" + "<g>" * 5000 + "</g>" * 5000 + "</svg>", "nested"),
    ],
)
def test_hostile_files_get_one_clear_word(tmp_path, text, word):
    path = tmp_path / "h.svg"
    path.write_text(text)
    with pytest.raises(TambourError) as error:
        files.read(path, ("Drawing",))
    assert word in str(error.value)


@pytest.mark.parametrize(
    ("bad", "word"),
    [
        ('<path d="M0 0 L 5"/>', "breaks off"),
        ('<path d="M0 0 L nan 5"/>', "no path command"),
        ('<path d="M0 0 A 5 5 0 2 0 9 9"/>', "flag"),
        ('<g id="a"><use href="#a"/></g>', "itself"),
        ('<use href="#none"/>', "not there"),
        ('<rect width="1e30" height="1"/>', "large"),
        ('<rect width="5" height="5" transform="scale(1e200) scale(1e200)"/>', "large"),
        ('<rect width="x" height="1"/>', "no length"),
        ('<circle r="1" fill="blurple"/>', "blurple"),
        ('<polyline points="0,0 4,0 4"/>', "pairs"),
        ('<circle r="1" transform="turn(4)"/>', "transform"),
        ('<svg viewBox="0 0 0 0" width="1" height="1"/>', "no area"),
        ('<circle r="1" opacity="half"/>', "opacity"),
    ],
)
def test_one_bad_value_never_refuses_the_rest_and_is_told_with_its_line(tmp_path, bad, word):
    made = read(tmp_path, f'\n<rect x="50" width="10" height="10"/>\n{bad}')
    assert np.allclose(areas(made)[0], 100)
    assert made.about["doubts"].startswith("line 3: ") and word in made.about["doubts"]


def test_what_comes_before_a_fault_of_a_path_is_drawn(tmp_path):
    made = read(tmp_path, '<path d="M0 0h10v10h-10z M20 0 h4 v oops"/>')
    assert np.isclose(areas(made)[0], 100)


@pytest.mark.parametrize(
    ("defs", "how", "left"),
    [
        ('<clipPath id="c"><rect width="5" height="10"/></clipPath>', 'clip-path="url(#c)"', 50),
        ('<clipPath id="c" clipPathUnits="objectBoundingBox"><rect width=".3" height="1"/></clipPath>', 'clip-path="url(#c)"', 30),
        ('<clipPath id="c"><rect width="5" height="10"/><rect width="10" height="2"/></clipPath>', 'style="clip-path:url(#c)"', 60),
        ('<mask id="c" maskUnits="userSpaceOnUse" x="0" y="0" width="99" height="99"><rect width="5" height="10" fill="white"/><rect width="5" height="2"/></mask>', 'mask="url(#c)"', 40),
    ],
)  # fmt: skip
def test_clips_and_masks_cut(tmp_path, defs, how, left):
    for body in (f'<rect width="10" height="10" {how}/>', f'<g {how}><rect width="10" height="10"/></g>'):
        assert sum(areas(read(tmp_path, defs + body))) == pytest.approx(left)


def test_a_faint_mask_lets_colours_through_by_as_much(tmp_path):
    made = read(
        tmp_path,
        '<mask id="m"><rect width="10" height="10" fill="#fff" opacity=".5"/></mask><rect width="10" height="10" mask="url(#m)"/>',
    )
    assert made.styles.fill[made.style, 3].tolist() == [128]


def test_gradients_become_bands_whose_colours_are_theirs(tmp_path):
    made = read(
        tmp_path,
        '<linearGradient id="g" gradientTransform="rotate(90)"><stop stop-color="#000"/><stop offset="1" stop-color="#fff"/></linearGradient>'
        '<rect width="10" height="20" fill="url(#g)"/>',
    )
    assert 5 <= len(made) <= 12 and sum(areas(made)) == pytest.approx(200, rel=1e-6)
    ends = [made.paths[int(made.paths.parts[m])][:, 1].mean() for m in range(len(made))]
    shown = made.styles.fill[made.style, 0].astype(float)
    assert np.abs(shown - 255 * np.array(ends) / 20).max() < 20  # each band is what the gradient is in its middle
    assert "gradients" in made.about["ignored"]
    flat = read(
        tmp_path,
        '<radialGradient id="g"><stop stop-color="#102030"/></radialGradient><rect width="9" height="9" fill="url(#g)"/>',
    )
    assert flat.styles.fill[flat.style].tolist() == [[16, 32, 48, 255]]


def test_dashes_markers_ends_and_paint_order(tmp_path):
    line = '<path d="M0 10h20" fill="none" stroke="red" stroke-width="2" '
    made = read(tmp_path, line + 'stroke-dasharray="4 2" stroke-dashoffset="1"/>')
    ends = sorted(tuple(np.round(made.paths[i][:, 0], 6)) for i in range(len(made.paths)))
    assert ends == [(0.0, 3.0), (5.0, 9.0), (11.0, 15.0), (17.0, 20.0)]
    made = read(tmp_path, line + 'stroke-linecap="square" stroke-linejoin="bevel"/>')
    assert made.styles.cap.tolist() == [2] and made.styles.join.tolist() == [2]
    marker = '<marker id="m" refX="1" refY="1" markerWidth="2" markerHeight="2" orient="auto"><rect width="2" height="2"/></marker>'
    made = read(tmp_path, marker + line + 'marker-end="url(#m)"/>')
    low, high = made.paths[1].min(0), made.paths[1].max(0)
    assert np.allclose([*low, *high], [18, 8, 22, 12])
    made = read(tmp_path, '<rect width="9" height="9" stroke="red" fill="blue" paint-order="stroke"/>')
    assert made.styles.stroke[made.style, 0].tolist() == [255, 0] and made.styles.fill[made.style, 2].tolist() == [
        0,
        255,
    ]


def test_a_stroke_that_is_skewed_is_an_area(tmp_path):
    made = read(tmp_path, '<path d="M0 1h10" stroke="red" stroke-width="2" transform="scale(1 4)"/>')
    assert areas(made) == pytest.approx([80])


def test_pictures_inside_lie_in_their_place(tmp_path):
    import base64
    import io

    from PIL import Image

    out = io.BytesIO()
    Image.new("RGB", (4, 2), (200, 10, 10)).save(out, "PNG")
    data = base64.b64encode(out.getvalue()).decode()
    made = read(tmp_path, f'<image x="10" y="5" width="20" height="20" href="data:image/png;base64,{data}"/>')
    (held,) = made.images
    assert (held.x, held.y, held.width, held.height) == pytest.approx((10, 10, 20, 10))
    assert held.picture.rgba.shape == (2, 4, 4)
    told = read(tmp_path, f'<image width="9" height="9" transform="rotate(3)" href="data:image/png;base64,{data}"/>')
    assert not told.images and "turned" in told.about["ignored"]


def test_attribute_selectors_and_importance(tmp_path):
    sheet = '<style>rect[class~="b"]{fill:#010101} [data-x]{fill:#020202!important} rect{fill:#030303}</style>'
    made = read(
        tmp_path,
        sheet
        + "".join(f'<rect {a} width="1" height="1"/>' for a in ('class="a b"', 'data-x="1" style="fill:red"', "")),
    )
    assert made.styles.fill[made.style, 0].tolist() == [1, 2, 3]


def test_text_follows_a_path_with_kerning(tmp_path):
    way = '<defs><path id="w" d="M0 40h90"/></defs>'
    made = read(tmp_path, way + '<text font-size="10"><textPath href="#w" startOffset="20">AV</textPath></text>')
    plain = read(tmp_path, '<text font-size="10" x="20" y="40">AV</text>')
    assert np.allclose(made.paths.coords, plain.paths.coords, atol=0.2)
    from tambour.geometry.glyphs import kerned
    from tambour.render.type import font_bytes

    assert kerned(font_bytes(False), "A", "V") < -0.01 and kerned(font_bytes(False), "H", "H") == 0


def test_entities_of_illustrator_and_packed_files_are_read(tmp_path):
    text = '<!DOCTYPE svg [<!ENTITY ns_svg "http://www.w3.org/2000/svg">]><svg xmlns="&ns_svg;" width="10mm" height="10mm" viewBox="0 0 10 10"><rect width="5" height="5"/></svg>'
    (tmp_path / "a.svgz").write_bytes(gzip.compress(text.encode()))
    assert np.allclose(areas(files.read(tmp_path / "a.svgz", ("Drawing",))), [25])


def test_what_is_left_out_is_named(tmp_path):
    made = read(
        tmp_path,
        '<script>x()</script><image href="http://x/y.png"/><use href="other.svg#a"/><rect width="1" height="1" clip-path="url(#c)"/>',
    )
    assert "script" in made.about["ignored"] and "an image outside the file" in made.about["ignored"]
    assert "clip-path: url(#c) is not there" in made.about["doubts"]


@pytest.mark.slow
def test_many_copies_stop_soon(tmp_path):
    body = '<defs><g id="g0"><rect width="1" height="1"/></g>'
    body += (
        "".join(f'<g id="g{k}">' + f'<use href="#g{k - 1}"/>' * 10 + "</g>" for k in range(1, 9))
        + '</defs><use href="#g8"/>'
    )
    begin = time.process_time()
    with pytest.raises(TambourError):
        read(tmp_path, body)
    assert time.process_time() - begin < 20


@pytest.mark.slow
@pytest.mark.parametrize(
    "body",
    [
        "".join(
            f'<pattern id="p{k}" patternUnits="userSpaceOnUse" width="{4.0**-k}" height="{4.0**-k}">'
            f'<rect width="{4.0**-k}" height="{4.0**-k}" fill="url(#p{k + 1})"/></pattern>'
            for k in range(9)
        )
        + '<rect width="19" height="19" fill="url(#p0)"/>',
        '<mask id="m">'
        + '<rect width="9" height="9"/>' * 40
        + "</mask>"
        + '<rect width="9" height="9" mask="url(#m)"/>' * 30_000,
    ],
    ids=["tiles in tiles", "masks"],
)
def test_what_is_drawn_again_and_again_is_refused(tmp_path, body):
    begin = time.process_time()
    with pytest.raises(TambourError, match="copies"):
        read(tmp_path, body)
    assert time.process_time() - begin < 60


def test_a_drawing_survives_writing_and_reading(tmp_path):
    made = read(
        tmp_path,
        '<path id="p" fill-rule="evenodd" d="M0 0h10v10h-10z M2 2h3v3h-3z" data-note="x"/><path d="M0 20 l10 5" stroke="red" fill="none"/>',
    )
    files.write(made, tmp_path / "b.svg")
    again = files.read(tmp_path / "b.svg", ("Drawing",))
    assert np.allclose(again.paths.coords, made.paths.coords, atol=2e-3)
    assert again.paths.parts.tolist() == made.paths.parts.tolist()
    assert again.styles.evenodd[again.style].tolist() == made.styles.evenodd[made.style].tolist()
    assert again.groups.data[again.groups.ids.index("p")] == {"note": "x"}
