"""The grammar of a pattern's line: its tables are those that Lark makes of it, and do to a line what Lark does."""

from __future__ import annotations

import json
import random
import re
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from lark import Lark
from lark.exceptions import UnexpectedCharacters, UnexpectedToken
from lark.lexer import PatternStr

from tambour.crochet.language.lalr import END, DoesNotFit, Tree, grammar

LANGUAGE = Path(__file__).parent.parent / "src" / "tambour" / "crochet" / "language"


@cache
def lark() -> Lark:
    return Lark(
        (LANGUAGE / "pattern.lark").read_text(),
        parser="lalr", lexer="contextual", start="line", maybe_placeholders=False,
    )  # fmt: skip


def tables() -> dict[str, Any]:
    """What pattern.json holds, by Lark."""
    made, parser = lark(), lark().parser.parser
    table = parser._parse_table
    # As Lark's scanner has them.
    order = sorted(made.terminals, key=lambda t: (-t.priority, -t.pattern.max_width, -len(t.pattern.value), t.name))
    # A word that another terminal of its priority matches too would have to be told apart after the match.
    for word in (t for t in order if isinstance(t.pattern, PatternStr)):
        alike = [t for t in order if t is not word and t.priority == word.priority]
        assert not any(re.fullmatch(t.pattern.to_regexp(), word.pattern.value) for t in alike), word

    def kept(symbol: Any) -> str:
        return (
            "-"
            if symbol.is_term and symbol.filter_out
            else "*"
            if symbol.name[0] == "_" and not symbol.is_term
            else "+"
        )

    rules = sorted(made.rules, key=lambda r: (str(r.origin.name), [s.name for s in r.expansion]))
    number = {rule: k for k, rule in enumerate(rules)}
    # States in the order in which they are come to: Lark's own numbers change from run to run.
    found = [table.start_states["line"]]
    for state in found:
        for _, (action, to) in sorted(table.states[state].items()):
            if str(action) == "Shift" and to not in found:
                found.append(to)
    return {
        "terminals": {t.name: t.pattern.to_regexp() for t in order if t.name not in made.ignore_tokens},
        "ignored": [t.pattern.to_regexp() for t in order if t.name in made.ignore_tokens],
        "rules": [[str(r.origin.name), "".join(map(kept, r.expansion)), r.options.expand1] for r in rules],
        "states": [
            {name: found.index(to) if str(action) == "Shift" else -1 - number[to]
             for name, (action, to) in sorted(table.states[state].items())}
            for state in found
        ],
        "start": 0,
        "end": found.index(table.end_states["line"]),
    }  # fmt: skip


def written(made: dict[str, Any]) -> str:
    """A line for each rule and state."""

    def listed(name: str) -> str:
        return ",\n".join(json.dumps(one, ensure_ascii=False) for one in made[name])

    head = {name: made[name] for name in ("terminals", "ignored", "start", "end")}
    return (
        json.dumps(head, ensure_ascii=False, indent=0)[:-2]
        + f',\n"rules": [\n{listed("rules")}\n],\n"states": [\n{listed("states")}\n]\n}}\n'
    )


def test_the_tables_are_those_of_the_grammar(request: pytest.FixtureRequest) -> None:
    text = written(tables())
    if request.config.getoption("--update-golden"):
        (LANGUAGE / "pattern.json").write_text(text)
    assert (LANGUAGE / "pattern.json").read_text() == text, "run pytest tests/test_crochet_grammar.py --update-golden"


def plain(tree: Any) -> Any:
    """A tree of either kind."""
    if hasattr(tree, "data"):
        return str(tree.data), [plain(child) for child in tree.children]
    return tree.type, str(tree), tree.start_pos, tree.end_pos


def by_lark(line: str) -> Any:
    try:
        return plain(lark().parse(line))
    except UnexpectedToken as error:
        token = error.token
        return (END, "") if token.type == END else (token.type, str(token), token.start_pos), error.expected
    except UnexpectedCharacters as error:
        return ("", line[error.pos_in_stream], error.pos_in_stream), error.allowed


def by_tables(line: str) -> Any:
    try:
        return plain(grammar().parse(line))
    except DoesNotFit as error:
        token = error.token
        return (END, "") if token.type == END else (token.type, str(token), token.start_pos), error.wanted


PIECES = (
    "== Head == make 2 height ( ) [ ] { } , : @ = - – x × 6 12 0.5 1234 sc inc dec hdc BLO MR(6) MR (6) ch(3) color(#ff8800)"
    " color( 12, 3) sp{2 sc} ring{ sp mr R3: R3-R5: Rnds 4 - 6 : 2-3: 7: around (12) (6 sts) (6 stitch) 6 rounds -3 rows"
    " define bob = define define(bob # é 'x' x2 2x a.1 _a AROUND aroundx FO turn"
).split(" ")


@pytest.mark.parametrize("line", ["== Head == 7: 6 sc", "==Head==x", "== Head (make 2) == MR(6)", "== Head == é"])
def test_what_stands_behind_a_whole_line_is_told_as_what_it_is(line: str) -> None:
    assert by_tables(line) == by_lark(line)
    with pytest.raises(DoesNotFit) as told:
        grammar().parse(line)
    assert str(told.value.token)


@pytest.mark.parametrize("seed", range(4))
def test_a_line_is_read_as_lark_reads_it(seed: int, root: Path) -> None:
    rng = random.Random(seed)
    known = [
        line
        for path in sorted((root / "examples" / "crochet").glob("*.acl"))
        for line in path.read_text().split("\n")
        if line.strip() and not line.startswith("#")
    ]
    assert len(known) > 200
    fits = 0
    for k in range(700):
        line = rng.choice(known)
        if k % 3 == 0:  # pieces in any order
            line = rng.choice(["", " "]).join(rng.choice(PIECES) for _ in range(rng.randint(1, 9)))
        elif k % 3 == 1:  # a line with a mistake
            at = rng.randrange(len(line) + 1)
            line = line[:at] + rng.choice(["", rng.choice(PIECES), " "]) + line[at + rng.randint(0, 3) :]
        expected = by_lark(line)
        assert by_tables(line) == expected, line
        fits += expected[0] == "line"
    assert 200 < fits < 600


def test_tokens_of_a_tree_come_in_their_order() -> None:
    line = "R2-R3: 2 sc, [inc, sc] x 3 (12)"
    tree = grammar().parse(line)
    assert isinstance(tree, Tree)
    places = [token.start_pos for token in tree.tokens()]
    assert places == sorted(places) and places[0] == 0 and line[places[-1] :] == "12)"
