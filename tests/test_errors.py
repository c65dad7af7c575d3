"""Errors name the place, show the line, and tell the remedy."""

from __future__ import annotations

from tambour.core.errors import Problem, Span, TambourError, Text, did_you_mean

SOURCE = Text("R1: MR(6)\nR2: 6 sx, 2 inc\n", "owl.acl")


def test_a_problem_points_at_its_text() -> None:
    problem = Problem('unknown stitch "sx"', 'did you mean "sc"?', Span(16, 18), SOURCE)
    assert str(problem) == ('owl.acl:2:7: unknown stitch "sx"\n    R2: 6 sx, 2 inc\n          ^^\n  did you mean "sc"?')


def test_places_are_right_at_the_edges() -> None:
    assert SOURCE.place(0) == (1, 1)
    assert SOURCE.place(9) == (1, 10)
    assert SOURCE.place(10) == (2, 1)
    assert SOURCE.place(10_000) == (3, 1)
    assert SOURCE.line(1) == "R1: MR(6)"
    assert SOURCE.line(9) == ""


def test_a_long_line_is_shown_around_its_mistake() -> None:
    text = Text("sc, " * 1000 + "sx", "long.acl")
    shown = str(Problem("unknown", "", Span(4000, 4002), text)).split("\n")
    assert shown[0] == "long.acl:1:4001: unknown"
    assert len(shown[1]) < 130
    assert shown[1][shown[2].index("^") :].startswith("sx")


def test_tabs_do_not_shift_the_caret() -> None:
    shown = str(Problem("unknown", "", Span(4, 6), Text("\tR1:sx", "t"))).split("\n")
    assert shown[1][shown[2].index("^") :].startswith("sx")


def test_an_error_carries_all_its_problems() -> None:
    error = TambourError([Problem("one", where="--width"), Problem("two", warning=True)])
    assert str(error) == "--width: one\nwarning: two"
    assert len(error.problems) == 2
    assert TambourError("alone", where="a.svg", hint="do this").problems[0].hint == "do this"


def test_near_words_are_offered() -> None:
    assert did_you_mean("tatmi", ["tatami", "satin"]) == 'did you mean "tatami"?'
    assert did_you_mean("zzz", ["tatami"]) == ""
