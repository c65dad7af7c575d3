"""Tiles: routes of the endless scroll. A tile's address holds all that it depends on, so it never changes."""

from __future__ import annotations

import json
from base64 import urlsafe_b64decode, urlsafe_b64encode
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pydantic import Field

from tambour import __version__
from tambour.core.errors import TambourError
from tambour.run import craft
from tambour.studio.asked import Body, Plain
from tambour.studio.context import Answer, Studio, until_left
from tambour.studio.problems import plains
from tambour.studio.views import FOREVER, sent

if TYPE_CHECKING:
    from starlette.requests import Request
    from starlette.responses import Response

SEEN = (
    *("seed", "density", "height", "season", "time", "reading", "mist", "figures", "buildings", "boats", "birds"),
    *("waterfalls", "paper", "edition", "left_out"),
)
"""The parameters that a tile depends on."""
TILE, HEIGHT, LAST = 512, 700, 10**9


class ScrollIn(Body):
    """A scroll's parameters, and what is left out of it."""

    params: Plain = Field(default_factory=dict)
    edits: list[Any] = Field(default_factory=list)


def _params(given: Plain) -> Any:
    try:
        return craft("ink").params.of({k: v for k, v in given.items() if k in SEEN})
    except TambourError as error:
        raise Answer(422, plains(error, craft("ink"))) from None


async def scroll(studio: Studio, request: Request, body: ScrollIn) -> dict[str, Any]:
    """Where the tiles of a scroll are found."""
    from tambour.ink.paint.layers import LIGHTS

    what = craft("ink")
    try:
        edits = what.edits(body.edits)
    except TambourError as error:
        raise Answer(422, plains(error, what)) from None
    params = _params(body.params)
    left = [*params.left_out, *(str(edit.plain()["whole"]) for kind, edit in edits if kind == "leave")]
    plain = params.plain()
    usual = what.params().plain()
    told = {name: plain[name] for name in SEEN if name in plain and plain[name] != usual.get(name)}
    told |= {"left_out": left} if left else {}
    raw = json.dumps([__version__, told], sort_keys=True, separators=(",", ":"), ensure_ascii=False).encode()
    if len(raw) > 5_000:
        raise Answer.of(422, "more is left out of this scroll than an address can hold")
    white = not params.paper and params.time != "night"
    ground = [255, 255, 255] if white else list(LIGHTS[params.time].paper)
    return {"key": urlsafe_b64encode(raw).decode().rstrip("="), "tile": TILE, "height": HEIGHT, "background": ground}


async def tile(studio: Studio, request: Request) -> Response:
    """A tile of a scroll, a pack."""
    key, k = request.path_params["key"], int(request.path_params["k"])
    try:
        version, told = json.loads(urlsafe_b64decode(key + "=" * (-len(key) % 4)))
        known = isinstance(told, dict) and version == __version__
    except (ValueError, RecursionError, TypeError):
        known = False
    if not known or abs(k) > LAST:
        raise Answer.of(404, "there is no such tile")
    given = {**told, "left_out": tuple(told["left_out"])} if isinstance(told.get("left_out"), list) else told
    params = _params(given)

    async def make(to: Path) -> dict[str, Any]:
        job = {"do": "tile", "lane": "ink", "params": params.plain(), "k": k, "to": str(to)}
        return await studio.pool.run(job)

    made = await until_left(request, studio.making.get(f"tile/{key}/{k}", make))
    return sent(request, made, "application/octet-stream", cache=FOREVER)
