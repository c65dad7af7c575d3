"""Placing: a route that sews a part on over another stitch, by writing the sentence that says where anew."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from pydantic import Field

from tambour.studio.asked import Body, Plain
from tambour.studio.context import Answer, Studio, until_left
from tambour.studio.pieces import both
from tambour.studio.pool import Failed

if TYPE_CHECKING:
    from starlette.requests import Request


class PlacePart(Body):
    """The part, as patterns call it ("Ear.1"), and the stitch (a unit of the live view) that its middle goes to; ``keep``:
    whether it goes there, or only the words for it are asked for."""

    base: Annotated[int, Field(ge=1, lt=2**53)]
    part: Annotated[str, Field(max_length=200)]
    onto: Annotated[int, Field(ge=0, lt=2**31)]
    keep: bool = True


async def place_part(studio: Studio, request: Request, body: PlacePart) -> tuple[int, Plain]:
    """A part is sewn on elsewhere: a revision whose text says so, and the sentence; or the sentence alone, and nothing is kept."""
    name = request.path_params["id"]
    piece = await studio.library.do(studio.library.piece, name)
    old = await studio.library.do(studio.library.revision, body.base)
    if old.piece != name or piece.craft != "crochet" or old.content.name is None:
        raise Answer.of(422, "no part of this can be sewn elsewhere", where="base")
    spec = await studio.making.spec(piece.craft, old.content)
    job = {"do": "place", "part": body.part, "onto": body.onto}
    try:
        told = await until_left(request, studio.pool.run(job, spec))
    except Failed as failed:
        if body.keep or failed.status != 422:
            raise
        return 200, {
            "sentence": "",
            "problems": failed.problems,
        }  # a hand still moves: that it is no place is an answer
    if not body.keep:
        return 200, {"sentence": told["sentence"], "problems": []}
    own = Path(old.content.name)
    called = own.name if own.suffix in (".txt", ".acl", ".md") else f"{own.stem}.txt"
    content = replace(old.content, name=called, source="")
    raw, said = told["text"].encode(), told["sentence"]
    made = await studio.library.do(studio.library.revise, name, body.base, content, raw, said[:120], False)
    answer = {**await both(studio, made), "sentence": said}
    studio.hub.revised(name, made[1].id)
    return 201, answer
