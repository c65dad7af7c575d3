"""Errors name the place, show the line, and tell the remedy."""

from __future__ import annotations

import json
import unicodedata
from html.parser import HTMLParser
from pathlib import Path
from typing import ClassVar

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tambour import files
from tambour.core.errors import Problem, Span, TambourError, Text, did_you_mean, spelt
from tambour.run import craft, run

SOURCE = Text("R1: MR(6)\nR2: 6 sx, 2 inc\n", "owl.acl")


def test_a_problem_points_at_its_text() -> None:
    problem = Problem('unknown stitch "sx"', 'did you mean "sc"?', Span(16, 18), SOURCE)
    assert str(problem) == ('owl.acl:2:7: unknown stitch "sx"\n    R2: 6 sx, 2 inc\n          ^^\n  did you mean "sc"?')


def test_places_are_right_at_the_edges() -> None:
    assert SOURCE.place(0) == (1, 1)
    assert SOURCE.place(9) == (1, 10)
    assert SOURCE.place(10) == (2, 1)
    assert SOURCE.place(10_000) == (3, 1)
    assert SOURCE.line(0) == SOURCE.line(9) == "R1: MR(6)"
    assert Text("a\r\nb").line(1) == "a" and Text("a\nb").line(99) == "b" and Text("").line(0) == ""


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


def test_options_are_spelt_by_who_tells() -> None:
    problem = Problem("{--max-float} as a length needs {--gauge}", where="{--max-float}")
    assert str(problem) == "--max-float: --max-float as a length needs --gauge"
    assert spelt(problem.message, lambda name: name.replace("-", " ").upper()) == "MAX FLOAT as a length needs GAUGE"
    assert spelt("a pattern's own {sc} and {--} stay") == "a pattern's own {sc} and {--} stay"


def test_a_problem_is_plain_data() -> None:
    told = Problem('unknown stitch "sx"', "say sc", Span(16, 18), SOURCE).plain()
    assert told == {
        "message": 'unknown stitch "sx"', "hint": "say sc", "line": 2, "column": 7, "length": 2, "where": "owl.acl", "warning": False,
    }  # fmt: skip
    assert json.loads(json.dumps(Problem("a", where="{--width}", warning=True).plain()))["line"] is None


@given(st.text())
def test_nothing_that_a_terminal_obeys_comes_through(text: str) -> None:
    said = str(Problem(f"unknown {text}", text, Span(2, 5), Text(f"a{text}\n", text), where=text))
    kept = {c for c in said if unicodedata.category(c) in ("Cc", "Cs", "Zl", "Zp")}
    assert kept <= {"\n", "\t"} and not set(said) & set("\u202a\u202b\u202d\u202e\u2066\u2067\u2068")


def test_a_terminals_commands_are_shown_as_signs() -> None:
    text = Text("R1: \x1b[31mMR(6)\x1b]0;pwned\x07 sx", "owl.acl")
    said = str(Problem('unknown stitch "\x1b[2J"', "", Span(text.text.index("sx"), len(text.text)), text)).split("\n")
    assert said[0].endswith('unknown stitch "␛[2J"') and "␛]0;pwned␇" in said[1]
    assert said[1][said[2].index("^") :] == "sx", "and the caret still stands below its place"


def test_a_text_as_html_is_text(tmp_path: Path) -> None:
    bad = '# <script>alert("1")</script>\n\n## Part & part\n- <img src=x onerror=alert(1)>\n- two\n\nRnd 1: 6 sc\n<b>\n'
    files.write(Text(bad), tmp_path / "a.html")
    page = (tmp_path / "a.html").read_text()

    class Tags(HTMLParser):
        seen: ClassVar[list[str]] = []
        words = ""

        def handle_starttag(self, tag: str, attrs: object) -> None:
            self.seen.append(tag)

        def handle_data(self, data: str) -> None:
            self.words += data

    tags = Tags()
    tags.feed(page)
    assert tags.seen[tags.seen.index("body") + 1 :] == ["h1", "h2", "ul", "li", "li", "p", "br"]
    assert '<script>alert("1")</script>' in tags.words and "<img src=x onerror=alert(1)>" in tags.words


def test_what_cannot_be_made_of_that_is_told(tmp_path: Path) -> None:
    (tmp_path / "d.svg").mkdir()
    for name, source, out, report, said in [
        ("crotchet", None, "a.svg", None, 'there is no craft "crotchet"'),
        ("crochet", None, "a.glb", None, "crochet needs a source"),
        ("ink", "b.txt", "a.svg", None, "ink takes no source"),
        ("ink", None, "d.svg", None, "this is a folder"),
        ("ink", None, "a.svg", "\udcff.json", "the name of the report holds bytes"),
    ]:
        with pytest.raises(TambourError) as caught:
            what = craft(name)
            run(what, source, what.params(), [tmp_path / out], report=report)
        assert said in str(caught.value)
    assert list(tmp_path.iterdir()) == [tmp_path / "d.svg"]
