"""Ovals, rings of any stitches, chain spaces, both layers, general increases and decreases: meshes that close."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tambour.core.errors import TambourError, Text
from tambour.core.graph import JOIN, LAID, THROUGH, YARN
from tambour.core.progress import Progress
from tambour.crochet.language.stitches import STITCHES, into_one, standard
from tambour.crochet.page.own import pattern
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make
from test_crochet_build import closed, made, problems

EXAMPLES = Path(__file__).parent.parent / "examples" / "crochet"

CLOSED = {
    "an oval, three in its ends": ": oval(8), 6 sc, inc3, 5 sc, inc (16)\n: 16 sc\n: 8 dec\n: 4 dec\nFO",
    "an oval whose last chain is left out": ": oval(8), inc, 5 sc, {4 sc}, 5 sc (16)\n: 16 sc\n: 8 dec\nFO",
    "an oval in joined rounds": ": oval(10, 4), 6 dc, {6 dc}, 5 dc, dcinc, join (19)\n: ch, 19 sc, join (19)\n"
    ": 9 dec, sc\n: 5 dec\nFO",
    "through both layers": ": MR(6)\n: 6 inc\n3: 12 sc\n: fold, 6 sc\nFO",
    "slip stitches through both": ": MR(6)\n: 6 inc\n3: 12 sc\n: fold, 6 slst\nFO",
    "an odd opening": ": MR(6)\n: 6 inc\n: 11 sc, inc (13)\n: fold, ch, [sc] around\nFO",
    "all kinds through both": ": MR(6)\n: 6 inc\n: 12 sc\n: fold, dec, inc, 2 ch, hdc, sk, sc\nFO",
    "a part of the opening": ": MR(6)\n: 6 inc\n: 12 sc\n: fold, 3 sc\n: 2 sc, dec, 2 sc\nFO",
    "two pieces": ": MR(6)\n: 6 inc\n: [sc, inc] x 6\nmark(a)\n: MR(6, b)\n: 6 inc\n: [sc, inc] x 6\n: fold(a), 18 sc",
    "chain spaces": ": MR{[3 dc, 2 ch] x 4}, join\n: [sp{3 dc, 2 ch, 3 dc}, ch] around, join\n: [sp{2 sc}] around\n"
    ": [dec] around\n: [dec] around\nFO",
    "a mesh": ": MR(6)\n: 6 inc\n: [sc, 2 ch, 2 sk] x 4\n: [sp{sc, ch, sc}] around\n: [dec] around\nFO",
    "corners and picots": ": MR(6)\n: 6 inc\n: [{sc, 2 ch, sc}, 2 sc] x 4\n: [2 sc, picot] x 12\n: 12 dec\n: 6 dec\nFO",
    "bumps": ": MR(6)\n: 6 inc\n: [sc, bobble] x 6\n: [fpdc, bpdc] x 6\n: [dec4] x 3\nFO",
}


@pytest.mark.parametrize("text", CLOSED.values(), ids=CLOSED)
def test_it_is_closed_and_one_sided(text):
    built = made(text)
    assert closed(built.graph.faces[built.shell]) == (2, 0)
    assert not [w for w in built.warnings if not w.message.startswith("approximated")]


@pytest.mark.parametrize("text", CLOSED.values(), ids=CLOSED)
def test_written_back_it_is_the_same(text):
    built = made(text)
    again = made(pattern(built).text)
    for field in ("edges", "faces", "rest", "kind", "parent"):
        assert np.array_equal(getattr(again.graph, field), getattr(built.graph, field)), field
    assert [(r.first, r.last, r.count) for r in again.rounds] == [(r.first, r.last, r.count) for r in built.rounds]


def test_an_oval_goes_round_its_chain():
    built = made("R1: oval(8), 6 sc, inc3, 5 sc, inc (16)\nR2: 16 sc\n", stitch=(4.0, 6.0))
    graph = built.graph
    assert not built.warnings
    assert [(r.number, r.first, r.last, r.count, r.below) for r in built.rounds] == [
        (0, 0, 7, 7, -1),
        (1, 8, 23, 16, 0),
        (2, 24, 39, 16, 1),
    ]
    assert graph.parent[8:24].tolist() == [6, 5, 4, 3, 2, 1, 0, 0, 0, 1, 2, 3, 4, 5, 6, 6]
    lengths = {tuple(e): (k, r) for e, k, r in zip(graph.edges.tolist(), graph.edge_kind, graph.rest)}
    assert lengths[1, 0] == (YARN, 4.0) and lengths[8, 6] == (THROUGH, 6.0) and lengths[7, 6] == (YARN, 6.0)
    # One rim: the last round's edge, and the step of its spiral.
    assert closed(graph.faces)[1] == 17


def test_an_oval_needs_room():
    assert problems(": oval(2)")[0][1] == "oval"
    assert problems(": oval(8, 1)")[0][1] == "1"
    assert problems(": oval(none)")[0][1] == "none"


def test_both_layers_meet():
    graph = made(": MR(6)\n: 6 inc\n: fold, 6 sc\nFO", stitch=(4.0, 6.0)).graph
    laid = graph.edges[graph.edge_kind == LAID]
    assert sorted(map(tuple, laid.tolist())) == [
        (18 - k, 7 + k) for k in reversed(range(5))
    ]  # 12 and 13 are neighbours anyway
    assert (graph.rest[graph.edge_kind == LAID] == 2.0).all()
    assert [graph.anchors[a:b].tolist() for a, b in zip(graph.anchor_offsets[19:-1], graph.anchor_offsets[20:])] == [
        [18 - k, 7 + k] for k in range(6)
    ]
    assert graph.parent[19:25].tolist() == list(range(7, 13))


def test_only_rounds_are_folded():
    assert problems(": 8 ch, turn\n: 7 sc\n: fold, 3 sc")[0][1] == "fold"
    assert problems(": MR(6)\n: fold, 4 sc")[0] == ("there is no stitch left to work into", "sc")


def test_spaces():
    built = made(": MR{[3 dc, 2 ch] x 4}, join (20)\n: [sp{3 dc, 2 ch, 3 dc}, ch] around, join (36)\n")
    graph = built.graph
    assert not built.warnings and [r.count for r in built.rounds] == [20, 36]
    # Eight nodes share two chains: three posts on the first, three on the second.
    assert graph.parent[21:29].tolist() == [4, 4, 4, -1, -1, 5, 5, 5]
    assert (graph.edge_kind == JOIN).sum() == 2
    assert problems(": MR(6)\n: sp{sc}")[0] == ("there is no chain space left in this round", "sp{sc}")


def test_chains_at_the_end_of_a_line_are_of_its_round():
    built = made(": MR(6)\n: 6 inc\n: [sc, sk, ch] x 6 (12)\n: [sp{2 sc}] around (12)\n")
    assert [(r.count, r.whole) for r in built.rounds] == [(6, True), (12, True), (12, True), (12, True)]


def test_a_chain_that_is_joined_is_an_open_ring():
    for text in (": ch(12)\n2: 12 sc", ": ch(12), join\n: ch, 12 sc, join"):
        built = made(text)
        faces, loose = closed(built.graph.faces)
        assert faces == 0 and loose > 23  # a band: two rims
        assert built.rounds[0].number == 0 and built.rounds[0].count == 12


def test_a_foundation_row():
    one, other = made(": fsc(10)\n: turn, ch, 10 sc"), made(": 11 ch, turn, 10 sc\n: turn, ch, 10 sc")
    assert np.array_equal(one.graph.edges, other.graph.edges) and np.array_equal(one.graph.faces, other.graph.faces)


@pytest.mark.parametrize(
    "words, name",
    [
        ("sc4tog", "dec4"),
        ("dc5tog", "dcdec5"),
        ("inc 5", "inc5"),
        ("hdc inc4", "hdcinc4"),
        ("fpdc2tog", "fpdcdec"),
        ("dtr", "dtr"),
        ("Bobble", "bobble"),
        ("cluster4", "cl4"),
        ("bobble5", "bobble"),
        ("rev sc", "crab"),
        ("extended sc", "esc"),
    ],
)
def test_names(words, name):
    assert standard(words) == name and name in STITCHES


def test_groups_have_one_name():
    sc, dc, ch = STITCHES["sc"], STITCHES["dc"], STITCHES["ch"]
    assert into_one([(dc, 5)]).name == "dcinc5" and into_one([(sc, 1), (sc, 1)]).name == "inc"
    corner = into_one([(sc, 1), (ch, 2), (sc, 1)])
    assert (corner.name, corner.makes, corner.takes, corner.inner) == (
        "{sc, 2 ch, sc}",
        4,
        1,
        (("sc", 1), ("ch", 2), ("sc", 1)),
    )
    assert into_one([(dc, 3)], "sp").name == "sp{3 dc}"
    low = into_one([(STITCHES["slst"], 1), (sc, 1)])  # a slip stitch stands as a low one among others in a place
    assert (low.makes, low.takes) == (2, 1)
    for wrong in ([(ch, 2)], [(STITCHES["dec"], 1)], []):
        with pytest.raises(ValueError):
            into_one(wrong)


def test_several_stitches_in_one():
    graph = made(": MR(6)\n: {5 dc}, sc, dcinc5, 3 sc\n").graph
    assert np.bincount(graph.parent[7:], minlength=7)[1:].tolist() == [5, 1, 5, 1, 1, 1]


def test_what_is_approximated_is_said_once():
    built = made(": MR(6)\n: 6 inc\n: [fpdc, bpdc] x 6\n: [bobble, crab] x 6\n")
    assert [w.message for w in built.warnings] == [f"approximated: {k}" for k in ("fpdc", "bpdc", "bobble", "crab")]


@pytest.mark.parametrize(
    "text, message",
    [
        (": MR(6)\n: {dec}", "dec does not fit in one place"),
        (": MR(6)\n: {color(red), sc}", "only stitches stand in braces"),
        (": MR(6)\n: {2 ch}", "nothing is worked into it"),
        (": MR(6)\n: {sc, 99 dc}", "more than 64 stitches in one place"),
        (": MR{3 dc} x 2", "a ring is not repeated"),
        (": MR{ch}", "nothing is worked into it"),
    ],
)
def test_what_does_not_fit_in_one_place(text, message):
    assert problems(text)[0][0] == message


def settled(text):
    built = made(text)
    piece = make(Text(text), CrochetParams(), Progress())
    assert np.isfinite(piece.positions).all() and np.isfinite(piece.yarn.paths.coords).all()
    return built, piece


def test_an_oval_settles_long():
    built, piece = settled(": oval(12), 10 sc, inc3, 9 sc, inc\n3: 24 sc\n: 12 dec\n: 6 dec\nFO")
    assert piece.shape.settled
    x = piece.positions[built.rounds[1].first : built.rounds[2].last + 1]
    wide, long = sorted(np.linalg.eigvalsh(np.cov(x.T)))[1:]
    assert long > 3 * wide  # variances: nearly twice as long as wide


def test_layers_lie_on_each_other():
    built, piece = settled("@stuffing = light\n: MR(6)\n: [inc] around\n: [sc, inc] around\n3: 18 sc\n: fold, 9 sc")
    graph, x = built.graph, piece.positions / 5.0
    assert piece.shape.settled and (piece.shape.volume > 30).all()
    laid = graph.edges[graph.edge_kind == LAID]
    assert (np.linalg.norm(x[laid[:, 0]] - x[laid[:, 1]], axis=1) < 1.0).all()
    row = x[-9:] - x[-9:].mean(0)
    spread = np.linalg.svd(row)[1]
    assert spread[0] > 3 * spread[1]  # the closing row is a line


def test_a_square_of_chain_spaces_is_flat_and_square():
    _, piece = settled((EXAMPLES / "granny.acl").read_text())
    size = np.ptp(piece.positions, axis=0)
    assert size[1] < 1e-9 and piece.shape.settled
    corners = np.sort(np.sqrt(((piece.positions[-68:] - piece.positions[0]) ** 2).sum(1)))
    assert corners[-4:].min() > 1.2 * corners[:8].mean()  # four corners, farther out than the sides


def test_bumps_and_loops_stand_out_of_the_fabric():
    text = "@stuffing = none\n: 12 ch, turn\n2: 11 sc, turn, ch\n: 5 sc, {}, 5 sc, turn, ch\n2: 11 sc, turn, ch\n"
    wide = {}
    for kind in ("sc", "bobble", "loopst"):
        piece = make(Text(text.format(kind)), CrochetParams(), Progress())
        wide[kind] = np.ptp(piece.yarn.paths.coords[:, 2])
    assert wide["bobble"] > wide["sc"] + 1.5 and wide["loopst"] > wide["sc"] + 1.5


PLAIN = ["sc", "3 sc", "inc", "dec", "bobble", "inc4", "dec4", "2 ch", "sk", "slst", "picot"]
STEP = st.sampled_from([*PLAIN, "{sc, 2 ch, sc}", "{hdc, picot, hdc}", "sp{2 sc}", "sp{dc, ch, dc}", "sp{bobble}"])
LINE = st.lists(STEP, min_size=1, max_size=7).map(lambda steps: ": " + ", ".join(steps))
BEGIN = st.sampled_from(
    [": MR(8)\n: 8 sc", ": oval(9), 7 sc, inc3, 6 sc, inc", ": MR{[dc, 2 ch] x 6}", ": MR(6)\n: 6 inc\n: 12 sc, join"]
)


@settings(max_examples=150, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck))
@given(BEGIN, st.lists(LINE, max_size=4), st.booleans())
@pytest.mark.slow
def test_whatever_is_drawn_together_or_folded_is_closed(begin, lines, folded):
    """Whatever is worked, an opening that is closed at the end leaves a watertight surface of one orientation."""
    text = "\n".join([begin, *lines])
    for k in range(8):
        end = "\n: fold, [sc] around\nFO" if folded else "\n: [dec] around" * k + "\nFO"
        try:
            built = made(text + end)
        except TambourError:
            continue
        if min(this.count for this in built.rounds if this.whole) >= 4:
            assert closed(built.graph.faces[built.shell])[1] == 0, text + end
        return


def test_chains_that_count_are_stitches_of_their_height():
    graph = made(": MR(6), join\n: ch3dc, 5 dc, join (6)\n: ch2hdc, 5 hdc (6)", stitch=(4.0, 6.0)).graph
    length = {tuple(e): r for e, r in zip(graph.edges.tolist(), graph.rest)}
    assert length[7, 1] == length[8, 2] == 12.0 and length[13, 7] == 9.0
    rows = made(": 7 ch, turn\n: 6 sc\n: turn, ch3dc, 5 dc (6)\n: turn, ch3dc, {2 dc, ch}, 4 dc (8)\n")
    assert not rows.warnings and [r.count for r in rows.rounds] == [7, 6, 6, 8]


def test_slip_stitches_before_a_round_carry_the_yarn():
    built = made(": MR(6)\n: 6 inc, join\n: 4 slst, 8 sc\n: 4 dec\nFO")
    graph = built.graph
    assert closed(graph.faces[built.shell])[1] == 0
    assert graph.previous[19] == 10 and graph.parent[19] == 11
    length = {tuple(e): r for e, r in zip(graph.edges.tolist(), graph.rest)}
    assert length[19, 10] == pytest.approx(5.0 * 2**0.5)  # one along, one up
