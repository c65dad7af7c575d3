"""Damaged patterns, seven hundred by day and two thousand by night: each gives a graph or an error with a place, never anything else."""

import time
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from night import NIGHT
from tambour.core.errors import TambourError, Text
from tambour.crochet.graph.build import build
from tambour.crochet.language.parse import parse
from tambour.crochet.page.own import pattern

EXAMPLES = sorted((Path(__file__).resolve().parents[1] / "examples" / "crochet").glob("*.acl"))
SMALL = """@centroids = 2
define puff(height 2) = 3 pull through, pull over
== Body (make 2) == # both
R1: MR(6) (6)
R2: [sc, inc] around (9)
mark(a)
: BLO, 3 puff, color(#ff8800), [sc, dec] x 2 (7)
: mark(x), 3 sc, mark(y), attach(x, 2)
2: [hdc, (ch, sk) * 2] x 1
FO
goto(y), color(10, 20, 30)
: turn, ch, 3 dcinc, slst
== Leg ==
: ch 8, turn
3: 7 sc, turn, ch
mark(b)
sew(a.1, b)
"""
TEXTS = [SMALL, SMALL, *(path.read_text(encoding="utf-8") for path in EXAMPLES)]
PIECES = [
    "", " ", "\n", ",", "(", ")", "[", "]", ":", "#", "x", "=", "==", "@", "-", "–", "0", "7", "99", "999999999", "R", "R2-R9:",
    "sc", "inc", "dec3", "ch", "sk", "slst", "MR(6)", "FO", "BLO", "FLO", "turn", "join", "around", "mark(a)", "goto(a)", "é", "\t",
    "attach(a, 3)", "attach(x, merge)", "attach(b)", "sew(a, b)", "color(red)", "define", "make", "{", "}", "(12)", "[sc] x 9",
]  # fmt: skip
EDIT = st.tuples(st.integers(0, 10**6), st.integers(0, 12), st.sampled_from(PIECES))
LINES = st.tuples(st.integers(0, 10**6), st.integers(0, 10**6))


def damaged(text, edits, moves):
    for at, length, piece in edits:
        at %= len(text) + 1
        text = text[:at] + piece + text[at + length * (at % 3 == 0) :]
    lines = text.split("\n")
    for one, other in moves:
        one, other = one % len(lines), other % len(lines)
        lines[one], lines[other] = lines[other], lines[one]
    return "\n".join(lines)


@pytest.mark.slow
@settings(max_examples=2000 if NIGHT else 700, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck))
@given(st.sampled_from(TEXTS), st.lists(EDIT, min_size=1, max_size=4), st.lists(LINES, max_size=1))
def test_a_damaged_pattern_is_a_graph_or_a_located_error(whole, edits, moves):
    text = damaged(whole, edits, moves)
    began = time.process_time()
    try:
        built = build(parse(Text(text), max_stitches=5000))
    except TambourError as error:
        for problem in error.problems:
            assert problem.span is not None and 0 <= problem.span.start <= problem.span.end <= len(text) + 1
            assert problem.message and str(problem)
    else:
        graph = built.graph
        assert len(graph) <= 5000 and np.isfinite(graph.rest).all() and (graph.rest > 0).all()
        assert len(graph.round) == len(graph) and len(built.shell) == len(graph.faces)
        assert all(w.warning and w.span is not None for w in built.warnings)
        pattern(built)
    assert time.process_time() - began < 5
