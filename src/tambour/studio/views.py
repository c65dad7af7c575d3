"""Views: routes that show a revision and give it away: packs, steps, reports, pictures, every file of every format."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any
from urllib.parse import quote

from tambour import __version__, files
from tambour.run import craft
from tambour.studio.context import Answer, Studio, until_left
from tambour.studio.guard import SANDBOX
from tambour.studio.library import Content, Piece, Revision
from tambour.studio.making import Output, file_name, key_of, tag
from tambour.studio.pieces import EXAMPLES, example, plain_revision
from tambour.studio.pool import Failed

if TYPE_CHECKING:
    from starlette.requests import Request
    from starlette.responses import Response

FOREVER = "private, max-age=31536000, immutable"
ASKED = "private, no-cache"
"""A browser may keep it and asks whether it still holds: another library has other revisions of the same numbers."""
_KINDS = {".webp": "image/webp", ".json": "application/json"}


async def _found(studio: Studio, request: Request) -> tuple[str, Revision]:
    piece, revision = await _titled(studio, request)
    return piece.craft, revision


async def _titled(studio: Studio, request: Request) -> tuple[Piece, Revision]:
    revision = await studio.library.do(studio.library.revision, int(request.path_params["r"]))
    if request.scope["only"] not in ("", revision.piece):
        raise Answer.of(404, "this is not of the piece that is followed")
    return await studio.library.do(studio.library.piece, revision.piece), revision


def sent(request: Request, output: Output, kind: str, *, as_file: bool = False, cache: str = ASKED) -> Response:
    """An output as an answer; ``as_file``: to be kept on the disk, never shown."""
    from starlette.responses import FileResponse, Response

    headers = {"cache-control": cache, "etag": output.tag}
    if request.headers.get("if-none-match") == output.tag:
        return Response(status_code=304, headers=headers)
    if as_file:
        headers["content-security-policy"] = SANDBOX
        plain = "".join(c if c.isascii() and (c.isalnum() or c in "-_. ") else "_" for c in output.name)
        headers["content-disposition"] = f"attachment; filename=\"{plain}\"; filename*=UTF-8''{quote(output.name, '')}"
    return FileResponse(output.path, media_type=kind, headers=headers)


async def shown(
    studio: Studio,
    request: Request,
    name: str,
    content: Content,
    view: str,
    suffix: str,
    kind: str,
    as_file: bool = False,
    title: str = "",
) -> Response:
    """A view of a piece as an answer; nothing is made for who has it."""
    from starlette.responses import Response

    mark = tag(f"{key_of(name, content)}/{view}/{file_name(name, content, view, suffix, title)}")
    if request.headers.get("if-none-match") == mark:
        return Response(status_code=304, headers={"cache-control": ASKED, "etag": mark})
    made = await until_left(request, studio.making.view(name, content, view, suffix, title))
    return sent(request, made, kind, as_file=as_file)


async def revision(studio: Studio, request: Request) -> dict[str, Any]:
    """A revision: what a piece was made of then."""
    _, found = await _found(studio, request)
    return await plain_revision(studio, found)


async def live(studio: Studio, request: Request) -> Response:
    """The piece as a screen draws it, a pack."""
    name, found = await _found(studio, request)
    return await shown(studio, request, name, found.content, "live", ".pack", "application/octet-stream")


async def _example(studio: Studio, request: Request) -> tuple[str, Content]:
    """An example as the content of a piece that nobody made."""
    name, called = request.path_params["craft"], request.path_params["example"]
    for _, known, usual in EXAMPLES.get(name, ()):
        if known == called:
            source, raw, params = example(name, called, usual)
            digest = None if raw is None else await studio.library.do(studio.library.keep, raw)
            return name, Content(source or None, digest, params, {}, (), 1, __version__)
    raise Answer.of(404, "there is no such example")


async def example_live(studio: Studio, request: Request) -> Response:
    """An example as a screen draws it, a pack."""
    name, content = await _example(studio, request)
    return await shown(studio, request, name, content, "live", ".pack", "application/octet-stream")


async def example_steps(studio: Studio, request: Request) -> Response:
    """The steps of an example's making."""
    name, content = await _example(studio, request)
    return await shown(studio, request, name, content, "steps", ".json", "application/json")


async def steps(studio: Studio, request: Request) -> Response:
    """The steps of its making."""
    name, found = await _found(studio, request)
    return await shown(studio, request, name, found.content, "steps", ".json", "application/json")


async def report(studio: Studio, request: Request) -> dict[str, Any]:
    """What the command line's report says."""
    name, found = await _found(studio, request)
    spec = await studio.making.spec(name, found.content)
    told = await until_left(request, studio.pool.run({"do": "report"}, spec))
    return dict(told["report"])


async def text(studio: Studio, request: Request) -> dict[str, Any]:
    """The text that the source is read as, of a PDF or a document too."""
    name, found = await _found(studio, request)
    if name != "crochet":
        raise Answer.of(404, "this piece has no text")
    spec = await studio.making.spec(name, found.content)
    told = await until_left(request, studio.pool.run({"do": "read"}, spec))
    return {"text": told["text"], "name": told["name"]}


async def thumb(studio: Studio, request: Request) -> Response:
    """A small picture; kept with the piece when it is of its head."""
    from starlette.responses import Response

    name, found = await _found(studio, request)
    headers = {"cache-control": ASKED, "etag": tag(f"{key_of(name, found.content)}/thumb")}
    if request.headers.get("if-none-match") == headers["etag"]:
        return Response(status_code=304, headers=headers)
    kept = await studio.library.do(studio.library.picture, found.id)
    if kept is not None:
        return Response(kept, media_type="image/webp", headers=headers)

    async def make(to: Path) -> dict[str, Any]:
        spec = await studio.making.spec(name, found.content)
        return await studio.pool.run({"do": "thumb", "to": str(to)}, spec)

    try:
        made = await until_left(request, studio.making.get(f"{key_of(name, found.content)}/thumb", make))
    except Failed as failed:
        if failed.status != 422:
            raise
        return Response(status_code=204, headers={"cache-control": ASKED})  # what cannot be made has no picture
    raw = made.path.read_bytes()
    piece = await studio.library.do(studio.library.piece, found.piece)
    if piece.head == found.id:
        await studio.library.do(studio.library.show, found.id, raw)
    return Response(raw, media_type="image/webp", headers=headers)


def drawn(name: str, content: Content, view: str) -> Content:
    """What a view is made of: a pen's lines, of the scroll as ``--plotter`` draws it; all else of the content as it is."""
    pen = name == "ink" and view == "plot" and not content.params.get("plotter")
    return replace(content, params={**content.params, "plotter": True}) if pen else content


async def takeaway(studio: Studio, request: Request) -> dict[str, Any]:
    """Every file that can be made of it; with its size where it was made already."""
    piece, found = await _titled(studio, request)
    name, listed = piece.craft, []
    for view, it in craft(name).views.items():
        for suffix in sorted(s for s, kind in files.WRITE if kind == it.value):
            called = file_name(name, drawn(name, found.content, view), view, suffix, piece.title)
            key = key_of(name, drawn(name, found.content, view))
            made = studio.making.known(f"{key}/{view}/{called}")
            size = None if made is None else made.size
            listed.append({"view": view, "suffix": suffix, "help": it.help, "name": called, "size": size})
    return {"files": listed}


async def download(studio: Studio, request: Request) -> Response:
    """A file: the command line's bytes; several files as one archive."""
    piece, found = await _titled(studio, request)
    name = piece.craft
    view, dot, rest = request.path_params["file"].partition(".")
    suffix = dot + rest
    views = craft(name).views
    if view not in views or not files.can_write(suffix, views[view].value):
        raise Answer.of(404, "there is no such file of this piece")
    kind = _KINDS.get(suffix, "application/octet-stream")
    content = drawn(name, found.content, view)
    return await shown(studio, request, name, content, view, suffix, kind, True, piece.title)
