"""Routes: the one table of what can be asked for. Nothing is routed elsewhere, and the OpenAPI document is made of it."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from tambour.studio import asked, checks, follow, limits, pieces, placing, tiles, views


@dataclass(frozen=True, slots=True)
class Route:
    """A way in.

    gives : what is answered, in words, or the media type of a file
    takes : the model of the body, where there is one; query : name → help
    body : the most bytes of a body
    phone : whether who was let in to follow one piece may ask for it, of that piece
    """

    method: str
    path: str
    do: Callable[..., Any]
    gives: str = "application/json"
    takes: type[asked.Body] | None = None
    query: tuple[tuple[str, str], ...] = ()
    body: int = limits.BODY
    phone: bool = False

    @property
    def help(self) -> str:
        """What it does: its function's first sentence."""
        return (self.do.__doc__ or "").strip().split("\n\n")[0].replace("\n", " ")


PARAMETERS = {
    "craft": "[a-z]{1,20}",
    "example": "[a-z0-9]{1,40}([.][a-z]{1,5})?",
    "id": "[a-z2-7]{26}",
    "r": "[1-9][0-9]{0,14}",
    "file": "[a-z]{1,30}[.][a-z0-9]{1,12}",
    "key": "[A-Za-z0-9_-]{1,7000}",
    "k": "-?[0-9]{1,10}",
}
"""A part of a path → what it may be; other paths are not there."""

_PACK, _FILE = "application/octet-stream", "application/octet-stream"

ROUTES: tuple[Route, ...] = (
    Route("GET", "/api/crafts", pieces.crafts),
    Route("GET", "/api/crafts/{craft}", pieces.one_craft),
    Route("GET", "/api/examples/{craft}/{example}/live.pack", views.example_live, _PACK),
    Route("GET", "/api/examples/{craft}/{example}/steps.json", views.example_steps),
    Route(
        "GET", "/api/pieces", pieces.listed,
        query=(("after", "where the page before ended"), ("limit", "at most 50"), ("binned", "1: those in the bin"),
               ("words", "those alone whose titles hold them all")),
    ),
    Route("POST", "/api/pieces", pieces.new, takes=asked.NewPiece),
    Route("GET", "/api/pieces/{id}", pieces.one, phone=True),
    Route("PATCH", "/api/pieces/{id}", pieces.alter, takes=asked.Alter),
    Route("DELETE", "/api/pieces/{id}", pieces.binned),
    Route("GET", "/api/pieces/{id}/history", pieces.history),
    Route("POST", "/api/pieces/{id}/revisions", pieces.revise, takes=asked.NewRevision),
    Route("POST", "/api/pieces/{id}/place-part", placing.place_part, takes=placing.PlacePart),
    Route("POST", "/api/pieces/{id}/undo", pieces.undo),
    Route("POST", "/api/pieces/{id}/redo", pieces.redo),
    Route("POST", "/api/pieces/{id}/head", pieces.head, takes=asked.Go),
    Route("POST", "/api/pieces/{id}/send", pieces.send, takes=asked.Send),
    Route("GET", "/api/pieces/{id}/place", follow.place, phone=True),
    Route("PUT", "/api/pieces/{id}/place", follow.put_place, takes=follow.PlaceIn, phone=True),
    Route("POST", "/api/files", pieces.upload, query=(("name", "the file's name, with its suffix"),), body=limits.UPLOAD),
    Route("GET", "/api/revisions/{r}", views.revision),
    Route("GET", "/api/revisions/{r}/report", views.report),
    Route("GET", "/api/revisions/{r}/text", views.text),
    Route("GET", "/api/revisions/{r}/live.pack", views.live, _PACK, phone=True),
    Route("GET", "/api/revisions/{r}/steps.json", views.steps, phone=True),
    Route("GET", "/api/revisions/{r}/thumb.webp", views.thumb, "image/webp"),
    Route("GET", "/api/revisions/{r}/files", views.takeaway),
    Route("GET", "/api/revisions/{r}/files/{file}", views.download, _FILE),
    Route("POST", "/api/check/{craft}", checks.check, takes=checks.CheckIn),
    Route("POST", "/api/ink/scroll", tiles.scroll, takes=tiles.ScrollIn),
    Route("GET", "/api/ink/tiles/{key}/{k}.pack", tiles.tile, _PACK),
    Route("GET", "/api/share", follow.shared),
    Route("PUT", "/api/share", follow.share, takes=follow.ShareIn),
    Route("POST", "/api/pair", follow.pair, takes=follow.PairIn),
)  # fmt: skip


def longest_body(path: str) -> int:
    """The most bytes of a body that is sent to a path."""
    return max([route.body for route in ROUTES if route.path == path], default=limits.BODY)


def followed(method: str, path: str, piece: str) -> bool:
    """Whether who follows ``piece``, and may do nothing else, may ask for this; whose revision it is, its route sees."""
    if path in (f"/follow/{piece}", "/api/live") or path.startswith("/web/"):
        return method in ("", "GET", "HEAD")
    return any(route.phone and route.method == method and _matches(route.path, path, piece) for route in ROUTES)


def _matches(pattern: str, path: str, piece: str) -> bool:
    parts = pattern.replace("{id}", piece).replace("{r}", PARAMETERS["r"]).replace(".", "[.]")
    return re.fullmatch(parts, path) is not None
