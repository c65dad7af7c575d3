"""Examine: what is wrong with a text, or with parameters, and what its rounds make, before anything is made of it."""

from __future__ import annotations

from typing import Any

from tambour.core.errors import Problem, TambourError, Text
from tambour.run import craft
from tambour.studio.problems import plains


def examined(job: dict[str, Any]) -> dict[str, Any]:
    """Problems, steps and counts of ``job``'s text, parameters and edits; nothing is settled or drawn."""
    what = craft(job["craft"])
    found: list[Problem] = []
    steps: list[dict[str, Any]] = []
    counts: dict[str, Any] = {}
    params = None
    try:
        params = what.params.of(job["params"])
        found += params.idle()
    except TambourError as error:
        found += error.problems
    try:
        what.edits(job["edits"])
    except TambourError as error:
        found += error.problems
    if what.name == "crochet" and job["text"] is not None:
        try:
            told = _worked(Text(job["text"], job["name"]), params or what.params())
            found, steps, counts = [*found, *told[0]], told[1], told[2]
        except TambourError as error:
            found += error.problems
    return {"problems": plains(found, what), "steps": steps, "counts": counts}


def _worked(text: Text, params: Any) -> tuple[list[Problem], list[dict[str, Any]], dict[str, Any]]:
    """Of a pattern that can be worked: doubts, rounds, and how many of what."""
    from tambour.crochet.live import steps_of
    from tambour.crochet.plush import worked

    built, doubts = worked(text, params)
    graph = built.graph
    counts = {"stitches": len(graph), "rounds": len(built.rounds), "parts": len(graph.parts)}
    return doubts, steps_of(built)["steps"], counts
