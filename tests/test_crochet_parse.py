"""The pattern language: what is understood, and that every mistake is found, where it is."""

import pytest

from tambour.core.errors import TambourError, Text
from tambour.crochet.graph.build import build
from tambour.crochet.language.parse import parse
from tambour.crochet.language.stitches import BASIC, STITCHES, standard


def wrong(text, **options):
    """What parse says, and the words it points at."""
    with pytest.raises(TambourError) as caught:
        parse(Text(text), **options)
    assert all(p.span is not None and p.source.text == text for p in caught.value.problems)
    return [(p.message, text[p.span.start : p.span.end]) for p in caught.value.problems]


def doubts(text):
    return [(w.message, text[w.span.start : w.span.end]) for w in parse(Text(text)).warnings]


def edges(text):
    graph = build(parse(Text(text))).graph
    return graph.edges.tolist(), graph.color.tolist(), [graph.kinds[k] for k in graph.kind]


@pytest.mark.parametrize(
    "one, other",
    [
        (": MR(6)\n: 6 inc", "MR(6)\r\n\t:\t6inc (12)\r\n"),
        (": MR(6)\n: 6 inc", ": mr 6 (6)\n:[INC]x6 # twelve"),
        (": MR(6)\n: [sc, [inc] x 2] x 2", ": MR(06)\n: (sc, (inc) * 2) × 2,"),
        (": MR(6)\n: [sc, inc] x 3", "R1: MR(6)\nR2: [sc, inc] around (9)"),
        (": MR(6)\n: 6 sc", "Rnd 1: MR(6)\nRnd 2: sc around (6 sts)"),
        (": MR(6)\n3: 6 sc", ": MR(6)\nR2-R4: 6 sc – 3 rounds (6)"),
        (": MR(6)\n3: 6 sc", ": MR(6)\nr2–4: 6 SC"),
        (": MR(6)\n: 6 hdcinc", ": MR(6)\n: 6 hdc inc"),
        (": MR(6)\n: 2 dec, dcdec", ": MR(6)\n: 2 sc2tog, dc_dec"),
        (": MR(6)\n: slst, sk, 3 inc3", ": MR(6)\n: sl st, skip, inc3 x 3"),
        (": color(255, 0, 0), MR(6)", "color(#ff0000) # red\n: MR(6)"),
        (": color(250, 128, 114), MR(6)", "colour(salmon)\n: MR(6)"),
        (": 12 ch\n: 12 sc", "ch(12)\n: [sc] around"),
        (": ch 5, turn\n: 4 sc", ": 5 ch, turn\n: sc, 3 sc"),
        ("== A ==\n: MR(6)", "== A (make 1)\n: MR(6)"),
        ("== Left arm ==\n: MR(6)", "==Left   arm==\n: MR(6)"),
        (": MR(6)\nmark(a)\n: 3 sc, attach(a)", ": MR(6)\nmark(a)\n: 3 sc, attach(a, 0)"),
    ],
)
def test_spellings(one, other):
    assert edges(one) == edges(other)


def test_all_mistakes_at_once():
    text = """@centroids = many
: MR(six)
: 6 sd, 3 sc 2, color(1, 2, 300)
R3-R2: [sc] x 0
: 6 sc (12
goto(b)
FLO
: mark(a), mark(a), 2 mark(c)
== Arm ==
== Arm ==
: [sc, goto(a)] x 2, sc()
"""
    assert wrong(text) == [
        ('"many" is no number of centroids', "many"),
        ('"six" is no number of stitches', "six"),
        ('there is no stitch or action "sd"', "sd"),
        ("two numbers for one stitch", "2"),
        ('"300" is no part of a colour', "300"),
        ("the range R3-R2 does not rise", "R3-R2"),
        ("brackets are repeated at least once", "0"),
        ("the line ends too early", "\n"),
        ('there is no mark "b" before this', "goto"),
        ('"FLO" stands outside a round', "FLO"),
        ('there is a mark "a" already', "mark"),
        ('"mark" is not repeated', "mark"),
        ('there is a part "Arm" already', "Arm"),
        ('"goto" is not repeated', "goto"),
        ("a stitch takes no parentheses", "()"),
    ]


def test_a_mistake_is_told_with_its_line_a_caret_and_a_remedy():
    with pytest.raises(TambourError) as caught:
        parse(Text(": MR(6)\n: 6 sx\n", "owl.acl"))
    assert str(caught.value) == (
        'owl.acl:2:5: there is no stitch or action "sx"\n    : 6 sx\n        ^^\n  did you mean "sc"?'
    )


@pytest.mark.parametrize(
    "text, message, place",
    [
        (": 6 sc 3 inc", '"inc" does not fit here', "inc"),
        (": sc sc", 'there is no stitch or action "sc sc"', "sc sc"),
        (": MR(6) sc", '"sc" does not fit here', "sc"),
        (":", "the line ends too early", ""),
        (": sc, é", '"é" does not fit here', "é"),
        (": [sc, inc] x", "the line ends too early", ""),
        (": [sc, inc x 6", "the line ends too early", None),
        ("6 sc", '"sc" stands outside a round', "sc"),
        (": sew(a, b)", '"sew" stands within a round', "sew"),
        ("@stuffing = lots", '"lots" is no amount of stuffing', "lots"),
        ("@initializer = tower", '"tower" is no way to begin', "tower"),
        ("@a = 1\n@A = 2", '"A" is given twice in this part', "A"),
        ("color(pinkish)", 'there is no colour "pinkish"', "pinkish"),
        (": 99999999999 sc", "this number is too large", "99999999999"),
        (": " + "[" * 30 + "sc" + "] x 2" * 30, "brackets are nested too deep", "["),
        ("== A (make 0) ==", "a part is made at least once", "0"),
        ("hump {\n x = 1,\nsc\n}", "this does not fit in a block of places", "sc"),
        ("hump {\n x = 1,", "a block of places is not closed", ","),
        ("define sc = pull over", '"sc" is there already', "sc"),
        ("define puff = pull trough, pull over", 'there is no move or stitch "pull trough"', "pull trough"),
        ("define puff = pull through", "this stitch does nothing", "puff"),
        ("define puff = pull over, pull through", "yarn is pulled through and left on the hook", "puff"),
        ("define puff = 999 pull over", "a stitch of 201 moves is too long", "puff"),
        ("mark(a.1)", "a mark's name has no point", "mark"),
        ("== A (make 2) ==\n: MR(6), mark(t)\n== B ==\n: MR(6), mark(b)\nsew(t, b)", 'the mark "t" is in a part made 2 times', "sew"),
        ("== A (make 2) ==\n: MR(6), mark(t)\n== B ==\n: MR(6), mark(b)\nsew(t.3, b)", '"t.3" is not there: the part is made 2 times', "sew"),
    ],
)  # fmt: skip
def test_mistakes(text, message, place):
    found = wrong(text)
    assert message in [m for m, _ in found]
    if place:
        assert (message, place) in found


@pytest.mark.parametrize(
    "text, message, place",
    [
        ("", "the pattern is empty", ""),
        ("# a note", "the pattern is empty", ""),
        ("@gravity = -0.5\n: MR(6)", 'the parameter "gravity" has no effect', "gravity"),
        (": MR(6)\n0: 6 sc", "a round worked no times is left out", "0"),
        (": MR(6)\n: 0 sc, 6 sc", "a stitch made no times is left out", "0"),
        (": MR(6)\n: 6 sc,\n", "a comma with nothing after it", ","),
        ("@centroids = 3,\n: MR(6)", "a comma with nothing after it", ","),
        (": MR(6)\n: BL, 6 sc\n: BL, 6 sc", "BL means both loops here, though printed patterns mean the back loop", "BL"),
        ("# work in a spiral and\nstuff it as you go along.\n: MR(6)", "this reads as the comment above, continued", "stuff it as you go along."),
        ("hump {\n  x = 1, # here\n}\n: MR(6)", "places of rings are not used", "hump {"),
        ("R1: MR(6)\nR2: 6 sc\nR2: 6 sc", "round 2 is there already: the one before is 2", "R2"),
        ("R1: MR(6)\nR3: 6 sc", "round 3 leaves rounds out: the one before is 1", "R3"),
        (": MR(6)\n2: 6 sc - 3 rounds", "3 rounds are said here, 2 at the line's start", "3"),
    ],
)  # fmt: skip
def test_doubts(text, message, place):
    assert doubts(text) == [(message, place)]


def test_strict_takes_numbers_at_their_word():
    assert wrong("R1: MR(6)\nR3: 6 sc", strict=True) == [("round 3 leaves rounds out: the one before is 1", "R3")]


def test_a_wrapped_comment_must_not_hide_stitches():
    assert wrong("# then\nsc inc dec sc")[0][1] == "sc inc dec sc"


def test_the_table_is_consistent():
    table = {name: (s.makes, s.takes) for name, s in STITCHES.items()}
    older = {
        "ch": (1, 0), "slst": (0, 1), "skip": (0, 1),
        "sc": (1, 1), "inc": (2, 1), "inc3": (3, 1), "dec": (1, 2), "dec3": (1, 3),
        "hdc": (1, 1), "hdcinc": (2, 1), "hdcinc3": (3, 1), "hdcdec": (1, 2), "hdcdec3": (1, 3),
        "dc": (1, 1), "dcinc": (2, 1), "dcinc3": (3, 1), "dcdec": (1, 2), "dcdec3": (1, 3),
        "tr": (1, 1), "trinc": (2, 1), "trinc3": (3, 1), "trdec": (1, 2), "trdec3": (1, 3),
    }  # fmt: skip
    assert {name: table[name] for name in older} == older and set(older) == BASIC
    assert table["dtrinc7"] == (7, 1) and table["fpdcdec4"] == (1, 4) and table["picot"] == (3, 0)
    assert all(table[name] == (1, 1) for name in ("bobble", "puff3", "crab", "esc", "fpsc", "ch3dc"))
    for said, name in {
        "DC2TOG": "dcdec", "inc dc": "dcinc", "sl-st": "slst", "invdec": "dec", "sc3tog": "dec3", "ss": "slst",
        "Magic Ring": "mr", "half double crochet": "hdc", "dec": "dec", "sc dec": "dec", "tr inc3": "trinc3",
    }.items():  # fmt: skip
        assert standard(said) == name


def test_parameters_of_a_part():
    pattern = parse(Text("@centroids = 3\n: MR(6)\n== B ==\n@stuffing = light\n@initializer = obo\n: MR(6)\n"))
    first, second = pattern.parts
    assert (first.centroids, first.stuffing, first.initializer) == (3, None, None)
    assert (second.centroids, second.stuffing, second.initializer) == (None, 0.4, "one-by-one")


def test_parameters_before_the_first_part_hold_for_all():
    pattern = parse(
        Text("@stuffing = firm\n@wool = soft\ncolor(red)\n== A ==\n: MR(6)\n== B ==\n@stuffing = none\n: MR(6)\n")
    )
    assert [(p.name, p.stuffing) for p in pattern.parts] == [("", None), ("A", 2.5), ("B", 0.0)]
    assert [w.message for w in pattern.warnings] == ['the parameter "wool" has no effect']
    alone = parse(Text("@stuffing = firm\n: MR(6)\n== B ==\n: MR(6)\n"))
    assert [p.stuffing for p in alone.parts] == [2.5, None]
    assert [p.name for p in parse(Text("@up = start\n== A ==\n: MR(6)\n")).parts] == ["A"]
