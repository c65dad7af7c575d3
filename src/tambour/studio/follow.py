"""Follow: routes for the phone beside the work: how far one is, and how the phone comes in."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any

from pydantic import Field

from tambour.studio import limits
from tambour.studio.asked import Body
from tambour.studio.context import Studio
from tambour.studio.library import Place

if TYPE_CHECKING:
    from starlette.requests import Request

_COUNT = Annotated[int, Field(ge=0, lt=2**31)]


class PlaceIn(Body):
    """How far the work is; ``at``: when that was so, in milliseconds since 1970."""

    step: _COUNT
    unit: _COUNT
    at: Annotated[int, Field(ge=0, lt=2**53)]


class PairIn(Body):
    """The piece that a phone is to follow, else the shelf."""

    piece: Annotated[str, Field(pattern=r"^[a-z2-7]{26}$")] | None = None


def _plain(place: Place | None) -> dict[str, Any]:
    return {"place": None if place is None else {"step": place.step, "unit": place.unit, "at": place.at}}


async def place(studio: Studio, request: Request) -> dict[str, Any]:
    """How far the work is."""
    return _plain(await studio.library.do(studio.library.place, request.path_params["id"]))


async def put_place(studio: Studio, request: Request, body: PlaceIn) -> dict[str, Any]:
    """Say how far the work is; what was said later counts."""
    name = request.path_params["id"]
    found = await studio.library.do(studio.library.place, name, Place(body.step, body.unit, body.at))
    told = _plain(found)
    studio.hub.placed(name, told["place"])
    return told


async def pair(studio: Studio, request: Request, body: PairIn) -> dict[str, Any]:
    """A code of one use that lets a phone in, with the rows of a QR code that says where."""
    import segno

    if body.piece is not None:
        await studio.library.do(studio.library.piece, body.piece)
    code = studio.tokens.code("/" if body.piece is None else f"/follow/{body.piece}")
    url = f"{studio.base}/pair/{code}"
    rows = ["".join("01"[bool(v)] for v in row) for row in segno.make_qr(url, error="m").matrix]
    return {"code": code, "url": url, "minutes": limits.PAIR_SECONDS // 60, "qr": rows}
