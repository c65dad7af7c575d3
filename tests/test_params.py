"""Params of every craft carry all that a form needs, and refuse what no craft could work with."""

from __future__ import annotations

import json
from typing import Any

import pytest

from tambour.core.errors import TambourError
from tambour.core.progress import Progress
from tambour.run import CRAFTS, craft, make

FIELDS = [(name, field) for name in CRAFTS for field in craft(name).params.asked()]


@pytest.mark.parametrize("name", CRAFTS)
def test_a_form_can_be_made_of_every_crafts_params(name: str) -> None:
    params = craft(name).params
    grouped = [f for fields in params.groups.values() for f in fields.split()]
    assert sorted(grouped) == sorted(set(params.asked()) - {"edition"}), "each field in one group"
    assert {*params.first.split(), *params.rare.split(), *params.widgets, *params.when} <= set(params.model_fields)
    assert not set(params.first.split()) & set(params.rare.split())
    form, schema = params.form(), params.model_json_schema()["properties"]
    json.dumps(form)
    for field, told in form.items():
        assert told["label"] and told["help"] and told["tier"] in ("first", "more", "rare"), field
        assert {**schema[field], **told} == schema[field], "the schema says the same"
        if told["widget"] == "number":
            low = told.get("minimum", told.get("exclusiveMinimum"))
            assert low is not None and told["maximum"] >= low, f"{field} has no bounds"
            inner = [part for part in schema[field].get("anyOf", [schema[field]]) if part["type"] != "null"]
            assert all(set(part) <= {"type", "unit"} | set(schema[field]) for part in inner), inner
        if told["widget"] == "choice":
            assert told["choices"]
        assert set(told["when"]) <= set(params.model_fields)


def test_lengths_times_and_angles_keep_unit_and_bounds() -> None:
    """Their bounds were once lost: a schema that pydantic does not see replaces the one that holds them."""
    of = {name: craft(name).params.form() for name in CRAFTS}
    picked = {k: of["embroidery"]["split"][k] for k in ("unit", "minimum", "maximum")}
    assert picked == {"unit": "mm", "minimum": 1, "maximum": 12}
    assert {k: of["crochet"]["hook"][k] for k in ("unit", "minimum", "maximum")} == {
        "unit": "mm",
        "minimum": 0.4,
        "maximum": 30,
    }
    assert of["ink"]["painting"]["exclusiveMinimum"] == 0 and of["ink"]["painting"]["unit"] == "s"
    assert of["embroidery"]["theta"]["unit"] == "degrees" and of["embroidery"]["theta"]["maximum"] == 90
    with_unit = [(c, f) for c in CRAFTS for f, told in of[c].items() if "unit" in told]
    assert len(with_unit) >= 24
    assert all("maximum" in of[c][f] for c, f in with_unit)


@pytest.mark.parametrize(("name", "field"), FIELDS)
@pytest.mark.parametrize(
    "bad", ["\x1b[31m", "a\x00b", "\ud800", "x" * 10_001, 1e308, -1e308, "1e400", float("nan"), True, 7, [], {}]
)
def test_bad_values_are_refused_or_understood(name: str, field: str, bad: Any) -> None:
    try:
        made = craft(name).params.of({field: bad})
    except TambourError as error:
        assert "{--" + field.rstrip("_").replace("_", "-") + "}" in error.problems[0].where or "{--" in str(
            error.problems
        )
        return
    assert not isinstance(bad, str) or bad == "1e400", "no such text is taken"
    assert not (isinstance(bad, float) and abs(bad) > 1e12 and isinstance(getattr(made, field), float))


def test_a_message_repeats_no_more_than_the_beginning_of_a_value() -> None:
    with pytest.raises(TambourError) as caught:
        craft("ink").params.of({"seed": "x" * 1001})
    assert len(str(caught.value)) < 200 and str(caught.value).endswith("xxx…)")


def test_what_has_no_effect_is_told() -> None:
    what = craft("crochet").params
    (one,) = what.of({"steps": 7}).idle()
    assert str(one) == "--steps: warning: has no effect without --solver steps"
    assert not what.of({"steps": 7, "solver": "steps"}).idle() and not what().idle()
    assert str(what.of({"gauge": "20x20", "gauge_circle": "9cm"}).idle()[0]).endswith("no effect with --gauge-circle")
    ink = craft("ink").params
    told = [str(p) for p in ink.of({"plotter": True, "mist": 0.9, "heights": "60..10", "specimen": "pine"}).idle()]
    assert told == [
        "--mist: warning: has no effect with --specimen and --plotter",
        "--heights: warning: has no effect without --swell",
    ]
    progress = Progress()
    made = make("ink", None, craft("ink").params(span=300, pens=2), (), progress)
    assert [str(w) for w in made.progress.warnings] == ["--pens: warning: has no effect without --plotter"]
    said = craft("knit").params.of({**craft("knit").params().plain(), "tidy": 1, "method": "gsat"}).idle()
    assert [w.where for w in said] == ["{--tidy}"], "a report's params, all of them given, tell the same"
