"""Tables of terms: whole, unambiguous, and every sentence is read back as it was said."""

import ast
import json
import os
import re
import shutil
import string
import subprocess
import sys
from collections import Counter
from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tambour.core.errors import TambourError
from tambour.crochet.language.finishes import SHAPES, Embroidery, Eye, Felt, Finish, Hair, Placed, Spot
from tambour.crochet.language.stitches import STITCHES
from tambour.crochet.places.face import WORDS as MOTIFS
from tambour.crochet.words.phrases import CLOCK, ITEMS, LEANS, TURN, WAYS, Phrases, number
from tambour.crochet.words.table import SENTENCES, TERMS, Tables

LEGEND = {"A": (1, 2, 3), "B": (200, 10, 77), "C2": (9, 9, 9)}
COPIES = {"Head": 1, "Ear": 2, "Arm": 2, "Arm 1": 1, "Left leg": 1}
each = pytest.mark.parametrize("terms", TERMS.values(), ids=TERMS)


@each
def test_tables_are_whole(terms):
    assert set(STITCHES) <= set(terms.stitches)
    assert set(terms.words) == set(TERMS["us"].words)
    assert set(terms.sentences) == set(SENTENCES)
    assert set(terms.stitches) <= set(terms.meaning) <= set(terms.stitches) | set(TERMS["us"].words)
    assert all(terms.meaning.values())
    assert all(spellings and all(spellings) for spellings in [*terms.stitches.values(), *terms.words.values()])


@each
def test_no_spelling_is_there_twice(terms):
    spelt = Counter(s.lower() for v in [*terms.stitches.values(), *terms.words.values()] for s in v)
    assert [s for s, n in spelt.items() if n > 1] == []
    shades = Counter(s.lower() for v in terms.colors.values() for s in v)
    assert [s for s, n in shades.items() if n > 1] == []


@each
def test_fields_of_sentences(terms):
    for key, fields in SENTENCES.items():
        said = [f for _, f, _, _ in string.Formatter().parse(terms.sentences[key]) if f]
        assert sorted(said) == sorted(fields.split()), key


@each
def test_every_item_is_read_back(terms):
    phrases = Phrases(terms, COPIES, LEGEND)
    given_fields = {"count": 7, "next": 3, "label": "tip", "one": "a.2", "other": "b_1", "color": LEGEND["B"]}
    for key, (name, numbers) in ITEMS.items():
        fields = {f: given_fields[f] for f in SENTENCES[key].split()}
        said = phrases.say(key, **fields)
        for text in (said, f"  {said[0].upper()}{said[1:]}. ", said.lower()):
            heard = phrases.item(text)
            assert heard is not None and heard[0] == name, text
            assert phrases.read(text)[0] == key, text
            if "color" in fields:
                assert heard[1] == LEGEND["B"]
            else:
                assert heard[1][:1] == ((7,) if "count" in fields else numbers)
        assert phrases.item(said + " and more") is None
        if "label" not in SENTENCES[key] and key != "sew":
            assert phrases.item(said)[2] == ()


numbers = st.one_of(
    st.integers(0, 400).map(float), st.integers(0, 400).map(lambda n: n + 0.5), st.sampled_from([0.25, 14.3])
)
names = st.sampled_from(["Head", "Ear.1", "Ear.2", "Arm.1", "Arm.2", "Arm 1", "Left leg"])
spots = st.builds(Spot, names, numbers, st.one_of(st.none(), numbers))
colors = st.one_of(
    st.tuples(*[st.integers(0, 255)] * 3), st.sampled_from([(0, 0, 0), (255, 255, 255), *LEGEND.values()])
)
turns = st.one_of(st.just(0.0), st.integers(-360, 360).map(float), st.just(12.5))


def line_of(part, places):
    return tuple(Spot(part, r, s) for r, s in places)


places = st.lists(st.tuples(numbers, st.one_of(st.none(), numbers)), min_size=1, max_size=5)
sizes = st.integers(1, 100).map(lambda n: n / 2)
records = st.one_of(
    st.builds(Placed, names, spots, st.booleans(), turns, turns, turns, st.one_of(st.none(), numbers)),
    st.builds(Eye, spots, sizes, st.one_of(st.just(Eye(spot=None).color), colors)),
    st.builds(lambda p, a, c, w: Embroidery(line_of(p, a), c, w), names, places, colors, sizes),
    st.builds(Felt, spots, st.sampled_from(SHAPES), sizes, sizes, turns, colors),
    st.builds(lambda p, a, n, h, c: Hair(line_of(p, a), n, h, c), names, places, st.integers(1, 99), sizes, colors),
)


@each
@settings(max_examples=60, deadline=None, derandomize=True)
@given(record=records)
def test_finishing_is_read_back(terms, record):
    phrases = Phrases(terms, COPIES, LEGEND)
    said = phrases.finish(record)
    assert phrases.finishing(said) == record
    assert phrases.finishing(said[0].upper() + said[1:] + ".") == record


@each
def test_names_that_are_not_known_yet(terms):
    eye = Eye(Spot("Head", 14.5, 20.0), 9.0)
    assert Phrases(terms, {}, {}).finishing(Phrases(terms, COPIES, {}).finish(eye)) == eye


@each
def test_colors(terms):
    phrases = Phrases(terms, {}, LEGEND)
    for hue in [*LEGEND.values(), (255, 255, 255), (0, 0, 0), (17, 200, 4)]:
        assert phrases.color(phrases.shade(hue)) == hue
    assert phrases.color("nothing of the kind") is None


def test_numbers():
    assert [number(v) for v in (3, 3.0, 0.5, -12.25, 1e-6, 1e9)] == [
        "3",
        "3",
        "0.5",
        "-12.25",
        "0.000001",
        "1000000000",
    ]


def test_uk_terms_are_moved_by_one():
    us, uk = TERMS["us"].stitches, TERMS["uk"].stitches
    assert (uk["sc"][0], uk["dc"][0], uk["tr"][0]) == (us["dc"][0], us["tr"][0], "dtr")


def _made_up(folder, drop=()):
    """A language of our own, as one file: every word of the US table backwards; without the keys ``drop``."""
    import tomllib

    whole = tomllib.loads((folder / "us.toml").read_text(encoding="utf-8"))

    def turned(said):
        """A template with its words turned around; fields and brackets stay where they are."""
        return re.sub(r"(\{\w+\}|\[[^{\]]*)|([^\W\d]{2,})", lambda m: m[1] or f"{m[2][::-1]}o", said)

    def written(said):
        return json.dumps(turned(said) if isinstance(said, str) else [turned(s) for s in said], ensure_ascii=False)

    rows = ['name = "Backwards"', f"standing = {written(whole['standing'])}"]
    for name in (
        "kinds",
        "posts",
        "increase",
        "decrease",
        "bumps",
        "stitches",
        "explained",
        "meaning",
        "words",
        "sentences",
        "colors",
        "page",
    ):
        rows += [f"[{name}]", *(f'"{k}" = {written(v)}' for k, v in whole[name].items() if (name, k) not in drop)]
    return "\n".join(rows)


@pytest.mark.slow
def test_a_language_is_one_file(root, tmp_path):
    package = tmp_path / "tambour"
    shutil.copytree(root / "src" / "tambour", package, ignore=shutil.ignore_patterns("__pycache__"))
    words = package / "crochet" / "words"
    (words / "xx.toml").write_text(_made_up(words), encoding="utf-8")
    code = """
from tambour.core.errors import Text
from tambour.crochet.graph.build import build
from tambour.crochet.page.instructions import instructions
from tambour.crochet.params import CrochetParams
from tambour.crochet.printed.choose import read
from tambour.crochet.printed.pattern import read_printed
from tambour.crochet.words.table import TERMS
assert CrochetParams(terms="xx").terms == "xx"
source = "== Ear ==\\n: MR(6)\\n: 6 inc\\n: [sc, inc] x 6\\n2: 18 sc\\n: [sc, dec] x 6\\nFO\\n"
said = instructions(build(read(Text(source))), "xx").text
print(said)
plain = said[said.rindex("## "):]
for text in (said, plain):
    again = read_printed(Text(text))
    assert again.terms == "xx", again.terms
    assert len(build(again).graph) == len(build(read(Text(source))).graph)
"""
    env = os.environ | {"PYTHONPATH": str(tmp_path)}
    made = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env=env)
    assert made.returncode == 0, made.stderr
    assert "dnRo" in made.stdout and "cnio" in made.stdout and "Rnd" not in made.stdout


def test_what_a_language_lacks_is_told_at_once(root, tmp_path):
    words = root / "src" / "tambour" / "crochet" / "words"
    shutil.copy(words / "us.toml", tmp_path)
    text = _made_up(words, drop=[("words", "turn"), ("page", "care")])
    (tmp_path / "xx.toml").write_text(text.replace("{count} cso nio cigamo gniro", "cso nio cigamo gniro"))
    with pytest.raises(TambourError) as told:
        Tables(tmp_path)["xx"]
    said = [p.message for p in told.value.problems]
    assert said == [
        '[words] "turn" is missing',
        '[page] "care" is missing',
        '[sentences] "ring" wants the fields count',
    ]
    (tmp_path / "yy.toml").write_text("name = ")
    with pytest.raises(TambourError, match="no TOML"):
        Tables(tmp_path)["yy"]


def _keys(node):
    """The keys that an expression may give, each as a pattern: of a choice both, of a table its values."""
    match node:
        case ast.Constant(value=str(said)):
            yield re.escape(said)
        case ast.JoinedStr(values=values):
            yield "".join(re.escape(v.value) if isinstance(v, ast.Constant) else ".+" for v in values)
        case ast.IfExp(body=one, orelse=other):
            yield from (*_keys(one), *_keys(other))
        case ast.Dict(values=values):
            for value in values:
                yield from _keys(value)
        case ast.Call(func=ast.Attribute(value=table, attr="get"), args=given):
            for one in (table, *given):
                yield from _keys(one)


@settings(max_examples=60, deadline=None)
@given(
    st.sampled_from(sorted(TERMS)),
    st.sampled_from([0, *LEANS]),
    st.integers(0, 23),
    st.integers(0, 7),
    st.sampled_from(WAYS),
    st.booleans(),
    st.integers(1, 40),
)
def test_a_seam_in_a_persons_words_is_read_back_as_the_same(code, tilt, way, turn, ways, flat, half):
    phrases = Phrases(TERMS[code], {"Body": 1, "Arm": 2}, {})
    at = Spot("Body", half / 2.0, float(half))
    one = Placed("Arm.1", at, flat, float(TURN * turn), float(tilt), float(CLOCK * way) if tilt else 0.0)
    said = phrases.sewn(one, "between Rnd 12 and 15, 9 stitches to the right of the middle of the front", ways)
    assert said is not None and phrases.finishing(said[:1].upper() + said[1:] + ".") == one
    assert phrases.sewn(replace(one, across=50.0), "there", ways) is None  # there are no words for it
    assert phrases.sewn(replace(one, tilt=30.0, towards=7.0), "there", ways) is None


_SIDES = [f"mid {side}" for side in ("front", "back", "top", "under")]
_NAMED = {
    "book.py: book.own[name]": ["height", "width", "length", "depth"],
    "placement.py: book.own[side]": ["front", "back", "its left", "its right", "above", "below"],
    "charted.py: book.own[_LEFT.get(key, key) if mirrored else key]": [
        *("chart rounds", "chart rounds left", "chart rows", "chart patch")
    ],
    "ofmodel.py: self.page[side]": _SIDES,
    "ofmodel.py: self.page[key.replace(' of', ' one') if one else key]": [
        "left of",
        "right of",
        "left one",
        "right one",
    ],
    "begin.py: own[size.how]": ["stuffed", "stuffed, sitting", "stuffed, standing", "laid flat", "as it lies"],
    "begin.py: own[key]": ["leftover", "skein", "skeins", "spiral", "turning text", "change text"],
    "begin.py: own[n]": ["needle", "ends", "marker", "scissors"],
    "placed.py: page[many]": ["put eyes", "put eye"],
    "placed.py: page[key]": [
        "embroidered eyes",
        "lines",
        "dots",
        "v nose",
        "y nose",
        "closed eyes",
        *(motif for motif in MOTIFS if motif != "eyes"),
    ],
    "assembly.py: book.own[where]": ["back", "side", "above", "below"],
    "assembly.py: book.own[key]": ["sewn flat", "sewn odd"],
    "taken.py: self.own[key]": ["side under", "side top", "side back", "side front"],
    "taken.py: self.own[key.replace('off', 'off one') if n == '1' else key]": [
        f"off{one} {side}" for one in ("", " one") for side in ("front", "back", "top", "under")
    ],
    **dict.fromkeys(("diagram.py: own[-1:]", "diagram.py: own[0]", "written.py: own[number]"), ()),  # no words
    **dict.fromkeys(("size.py: own[~np.isin(graph.peculiarity[own], (ROOT, TIP))]", "taken.py: own[near, 1]"), ()),
}
"""What is asked for by a name, and which words that may be."""


def test_every_word_that_the_pages_ask_for_is_in_every_language(root):
    """A booklet died of one that no table had; what a table lacks that another has, is told when it is read (above)."""
    asked, places = {}, root / "src" / "tambour" / "crochet"
    for path in (*places.glob("page/*.py"), *places.glob("maker/*.py")):
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            of = node.value if isinstance(node, ast.Subscript) else None
            if getattr(of, "attr", getattr(of, "id", "")) in ("own", "page"):
                keys = [*_keys(node.slice)] or _NAMED.get(f"{path.name}: {ast.unparse(node)}")
                assert keys is not None, (path.name, node.lineno, "say in _NAMED which words this may ask for")
                asked |= dict.fromkeys(keys, f"{path.name}:{node.lineno}")
    asked |= {
        f"a {re.escape(kind.__name__.lower())}": "assembly.py, a step's heading"
        for kind in Finish.__args__
        if kind is not Placed
    }
    assert len(asked) > 90, "the pages' words are asked for in another way: nothing is checked here"
    for code in TERMS:
        lacking = {
            key: where for key, where in asked.items() if not any(re.fullmatch(key, k) for k in TERMS[code].page)
        }
        assert not lacking, (code, lacking)
