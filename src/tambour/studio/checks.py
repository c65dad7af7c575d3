"""Checks: a route that says what is wrong with a text or with parameters while they are typed."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any

from pydantic import Field

from tambour.studio import limits
from tambour.studio.asked import Body, Plain, known_craft
from tambour.studio.context import Studio, clean_name, until_left

if TYPE_CHECKING:
    from starlette.requests import Request


class CheckIn(Body):
    """A text and parameters as they stand."""

    text: Annotated[str, Field(max_length=limits.TEXT)] | None = None
    name: Annotated[str, Field(max_length=1000)] = "pattern.txt"
    params: Plain = Field(default_factory=dict)
    edits: list[Any] = Field(default_factory=list, max_length=limits.EDITS)


async def check(studio: Studio, request: Request, body: CheckIn) -> dict[str, Any]:
    """Problems, steps and counts; nothing is made."""
    what = known_craft(request.path_params["craft"])
    asked = set(what.params.files())
    job = {
        "do": "check",
        "lane": "check",
        "craft": what.name,
        "text": body.text,
        "name": clean_name(body.name),
        "params": {k: v for k, v in body.params.items() if k not in asked},
        "edits": body.edits,
    }
    told = await until_left(request, studio.pool.run(job, seconds=limits.CHECK_SECONDS))
    return {"problems": told["problems"], "steps": told["steps"], "counts": told["counts"]}
