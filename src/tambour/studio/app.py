"""App: the table of routes becomes an application behind its guard."""

from __future__ import annotations

import json
from collections.abc import AsyncIterator, Awaitable, Callable, Iterable
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

from pydantic import ValidationError
from starlette.applications import Starlette
from starlette.convertors import Convertor, register_url_convertor
from starlette.requests import ClientDisconnect, Request
from starlette.responses import HTMLResponse, JSONResponse, Response
from starlette.routing import Route as Way
from starlette.routing import WebSocketRoute
from starlette.websockets import WebSocket

from tambour import __version__
from tambour.core.errors import TambourError
from tambour.studio import openapi, web
from tambour.studio.context import Answer, Studio
from tambour.studio.guard import App, Guard, Refused
from tambour.studio.library import Conflict, Full, Library, Missing
from tambour.studio.making import Making
from tambour.studio.pieces import both
from tambour.studio.pool import Failed, Pool
from tambour.studio.problems import plains, said
from tambour.studio.routes import PARAMETERS, ROUTES, Route, followed, longest_body
from tambour.studio.share import Share
from tambour.studio.socket import Hub, Page
from tambour.studio.token import Tokens


class _Part(Convertor[str]):
    """A part of a path, as it is written."""

    def convert(self, value: str) -> str:
        """The part."""
        return value

    def to_string(self, value: str) -> str:
        """The part."""
        return value


for _name, _pattern in PARAMETERS.items():
    register_url_convertor(f"our_{_name}", type("_Part", (_Part,), {"regex": _pattern})())


def application(
    library: Path,
    tokens: Tokens,
    hosts: Iterable[str],
    base: str,
    log: Any,
    workers: int | None = None,
    shared: bool = False,
) -> App:
    """The guarded application. Its library is opened here, so that what is wrong with it is told before it starts.

    shared : whether ``base`` is an address that phones reach
    """
    shelf = Library(library)
    ours: list[Studio] = []

    @asynccontextmanager
    async def life(app: Starlette) -> AsyncIterator[None]:
        pool = Pool(log, workers)
        ours.append(Studio(shelf, pool, Making(shelf, pool), tokens, web.read(), Hub(), base, share))
        try:
            yield
        finally:
            ours[0].hub.bye("the studio was closed")
            await share.close()
            await pool.close()
            shelf.close()

    def studio() -> Studio:
        return ours[0]

    ways: list[Any] = [Way(_path(route.path), _handler(route, studio), methods=[route.method]) for route in ROUTES]
    ways += [
        Way("/api/openapi.json", _plainly(lambda request: JSONResponse(openapi.document()))),
        Way("/api/health", _plainly(lambda request: JSONResponse({"ok": True, "version": __version__}))),
        Way("/api", _plainly(lambda request: HTMLResponse(openapi.page()))),
        Way("/", _plainly(lambda request: _page(studio(), "index.html"))),
        Way(_path("/follow/{id}"), _plainly(lambda request: _page(studio(), "follow.html"))),
        Way("/web/{hash}/{path:path}", _plainly(lambda request: _file(studio(), request))),
        WebSocketRoute("/api/live", _live(studio)),
    ]
    app = Starlette(routes=ways, lifespan=life, exception_handlers={404: _missing, 405: _missing, 500: _fault})
    share = Share(
        lambda names: Guard(app, tokens, names, longest_body, followed, narrow=True), tokens, base if shared else ""
    )
    return Guard(app, tokens, hosts, longest_body, followed)


def _path(path: str) -> str:
    for name in PARAMETERS:
        path = path.replace(f"{{{name}}}", f"{{{name}:our_{name}}}")
    return path


def _handler(route: Route, studio: Callable[[], Studio]) -> Callable[[Request], Awaitable[Response]]:
    """A route's function as an endpoint: its body judged by its model, what it raises told as problems."""

    async def endpoint(request: Request) -> Response:
        ours = studio()
        ours.pool.open()  # not before: a page's first picture does not share the processor with a worker's start
        try:
            given = () if route.takes is None else (route.takes.model_validate(await _json(request)),)
            made = await route.do(ours, request, *given)
        except Answer as answer:
            return _told(answer.status, answer.problems)
        except Failed as failed:
            return _told(failed.status, failed.problems)
        except TambourError as error:
            return _told(422, plains(error))
        except ValidationError as error:
            return _told(422, [_invalid(e) for e in error.errors()])
        except Missing:
            return _told(404, [said("this is not there, or not any more")])
        except Conflict as conflict:
            return await _conflict(ours, request, str(conflict))
        except Full:
            problem = said("the disk is full: this was not saved", "make room; what was saved before is safe")
            return _told(507, [problem])
        except ClientDisconnect:
            return _told(499, [said("the page left")])
        if isinstance(made, Response):
            return made
        status, plain = made if isinstance(made, tuple) else (200, made)
        return JSONResponse(plain, status)

    return endpoint


async def _json(request: Request) -> Any:
    kind = request.headers.get("content-type", "").partition(";")[0].strip().lower()
    if kind != "application/json":
        raise Answer.of(415, "JSON is wanted here")
    raw = await request.body()
    try:
        return json.loads(raw.decode())
    except (ValueError, RecursionError):
        raise Answer.of(400, "this is no JSON") from None


def _invalid(error: Any) -> dict[str, Any]:
    """An error of a model as a problem."""
    where = ".".join(map(str, error["loc"]))
    return said(f"{where}: {error['msg'].lower()}" if where else error["msg"].lower(), where=where[:200])


async def _conflict(studio: Studio, request: Request, why: str) -> Response:
    """409, with what stands instead."""
    piece = await studio.library.do(studio.library.piece, request.path_params["id"])
    head = await studio.library.do(studio.library.revision, piece.head)
    return JSONResponse({"problems": [said(why)], **await both(studio, (piece, head))}, 409)


def _told(status: int, problems: list[dict[str, Any]]) -> Response:
    return JSONResponse({"problems": problems}, status)


def _plainly(answer: Callable[[Request], Response]) -> Callable[[Request], Awaitable[Response]]:
    async def endpoint(request: Request) -> Response:
        return answer(request)

    return endpoint


def _page(studio: Studio, name: str) -> Response:
    found = studio.web.page(name)
    if found is None:
        return HTMLResponse("<!doctype html><title>Tambour</title><p>This copy of the studio has no pages.", 404)
    return HTMLResponse(found.decode())


def _file(studio: Studio, request: Request) -> Response:
    """A file of the pages, by the hash over all of them."""
    path = request.path_params["path"]
    if request.path_params["hash"] != studio.web.hash or path not in studio.web.files:
        return _told(404, [said("this is not there")])
    kind, raw = studio.web.files[path]
    return Response(raw, headers={"content-type": kind, "cache-control": "private, max-age=31536000, immutable"})


def _live(studio: Callable[[], Studio]) -> Callable[[WebSocket], Awaitable[None]]:
    async def endpoint(socket: WebSocket) -> None:
        await Page(studio(), socket).live()

    return endpoint


async def _missing(request: Request, error: Exception) -> Response:
    status = getattr(error, "status_code", 404)
    told = said("there is nothing at this address" if status == 404 else "this is not done here")
    return JSONResponse({"problems": [told]}, status, headers=getattr(error, "headers", None))


async def _fault(request: Request, error: Exception) -> Response:
    if isinstance(error, (Refused, TimeoutError)):
        raise error  # the guard's
    return _told(500, [said("this is a fault of tambour's: it stands in the studio's log")])
