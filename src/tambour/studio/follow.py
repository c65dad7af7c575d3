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


class ShareIn(Body):
    """Whether phones in this computer's network may come in."""

    open: bool


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


def _shared(studio: Studio) -> dict[str, Any]:
    phones = sum(bool(page.only) for page in studio.hub.pages)
    return {
        "address": studio.share.base or None,
        "always": studio.share.always,
        "phones": phones,
        "came": studio.tokens.redeemed,
    }


async def shared(studio: Studio, request: Request) -> dict[str, Any]:
    """Where phones come in, null where they do not; how many are following, how many ever came in."""
    return _shared(studio)


async def share(studio: Studio, request: Request, body: ShareIn) -> dict[str, Any]:
    """Let phones in by this computer's address in its network, each to the piece of its code alone; or no more."""
    await (studio.share.open() if body.open else studio.share.close())
    return _shared(studio)


async def pair(studio: Studio, request: Request, body: PairIn) -> dict[str, Any]:
    """A code of one use that lets a phone in, with the rows of a QR code that says where."""
    import segno

    if body.piece is not None:
        await studio.library.do(studio.library.piece, body.piece)
    code = studio.tokens.code(body.piece or "")
    url = f"{studio.share.base or studio.base}/pair/{code}"
    rows = ["".join("01"[bool(v)] for v in row) for row in segno.make_qr(url, error="m").matrix]
    return {"code": code, "url": url, "minutes": limits.PAIR_SECONDS // 60, "qr": rows}
