"""Pieces: routes that list, make and change pieces, go back and forth, and send one to another craft."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from tambour import __version__, files
from tambour.craft import Craft
from tambour.examples import folder
from tambour.run import CRAFTS, craft
from tambour.studio import limits
from tambour.studio.asked import (
    Alter,
    Go,
    NewPiece,
    NewRevision,
    Plain,
    Send,
    checked,
    crafts_of,
    files_of,
    known_craft,
    source_of,
    titled,
)
from tambour.studio.context import Answer, Studio, clean_name, until_left
from tambour.studio.library import Content, Library, Piece, Revision

if TYPE_CHECKING:
    from starlette.requests import Request

EXAMPLES: dict[str, tuple[tuple[str, str, Plain], ...]] = {
    "crochet": (
        ("Frog", "frog.acl", {}),
        ("Bear", "bear.txt", {}),
        ("Mushroom", "mushroom.acl", {}),
        ("Octopus", "octopus.acl", {}),
    ),
    "knit": (("Cat", "cat.png", {"stitches": 90}), ("Rose", "rose.png", {"stitches": 90}), ("Band", "band.csv", {})),
    "ink": (("Plum", "plum", {"span": 1024.0}), ("Autumn", "autumn", {"span": 1024.0, "season": "autumn"})),
    "embroidery": (("Botanical", "botanical.svg", {}), ("Heart", "heart.svg", {}), ("Boat", "boat.svg", {})),
}
"""Craft → what the shelf shows: a title, a file of the examples or for ink a seed, parameters."""


# -- what a page is told ----------------------------------------------------------------------------------------------


async def plain_piece(studio: Studio, piece: Piece) -> Plain:
    """A piece as data."""

    def ways(library: Library) -> tuple[bool, bool]:
        head = library.revision(piece.head)
        return head.parent is not None, head.next is not None

    undo, redo = await studio.library.do(ways, studio.library)
    return {
        "id": piece.id,
        "craft": piece.craft,
        "title": piece.title,
        "made": piece.made,
        "changed": piece.changed,
        "head": piece.head,
        "thumb": f"/api/revisions/{piece.head}/thumb.webp",
        "before": None if piece.thumb in (None, piece.head) else f"/api/revisions/{piece.thumb}/thumb.webp",
        "binned": piece.binned is not None,
        "undo": undo,
        "redo": redo,
    }


async def plain_revision(studio: Studio, revision: Revision, text: bool = True) -> Plain:
    """A revision as data; ``text``: with its source, where that is one."""
    it = revision.content
    source: Plain | None = None
    if it.source is not None and it.name is not None:
        source = {"name": it.name, "sha256": it.source, "size": await studio.library.do(studio.library.size, it.source)}
        if text:
            plain = Path(it.name).suffix in (".txt", ".acl", ".md") and source["size"] <= limits.BODY
            raw = await studio.library.do(studio.library.blob, it.source) if plain else b""
            source["text"] = _decoded(raw) if plain else None
    return {
        "id": revision.id,
        "piece": revision.piece,
        "parent": revision.parent,
        "at": revision.at,
        "said": revision.said,
        "source": source,
        "params": dict(it.params),
        "files": dict(it.files),
        "edits": list(it.edits),
        "edition": it.edition,
        "version": it.version,
    }


def _decoded(raw: bytes) -> str:
    try:
        text = raw.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = raw.decode("cp1252", errors="replace")
    return text.replace("\r\n", "\n").replace("\r", "\n")


async def both(studio: Studio, found: tuple[Piece, Revision]) -> Plain:
    """A piece and its revision as data."""
    return {"piece": await plain_piece(studio, found[0]), "revision": await plain_revision(studio, found[1])}


# -- routes -----------------------------------------------------------------------------------------------------------


async def crafts(studio: Studio, request: Request) -> Plain:
    """What there is: crafts, what they read and show, their examples."""
    return {"crafts": [_craft(craft(name)) for name in CRAFTS]}


def _craft(what: Craft) -> Plain:
    suffixes = {v: sorted(s for s, kind in files.WRITE if kind == it.value) for v, it in what.views.items()}
    return {
        "name": what.name,
        "help": CRAFTS[what.name][1],
        "source": "none" if not what.reads else "optional" if what.optional_source else "wanted",
        "reads": sorted(s for s, kinds in files.READ.items() if set(kinds) & set(what.reads)),
        "examples": [{"name": n, "title": title} for title, n, _ in EXAMPLES[what.name]],
        "views": [
            {"name": v, "help": it.help, "suffixes": suffixes[v], "usual": list(it.suffixes)}
            for v, it in what.views.items()
        ],
    }


async def one_craft(studio: Studio, request: Request) -> Plain:
    """A craft with the form of its parameters, and of its edits."""
    what = known_craft(request.path_params["craft"])
    changes = {kind: {"help": it.help, "form": it.params.form()} for kind, it in what.changes.items()}
    return {**_craft(what), "form": what.params.form(), "changes": changes}


async def listed(studio: Studio, request: Request) -> Plain:
    """Pieces, the last changed first, a page at a time."""
    after, most = request.query_params.get("after", ""), request.query_params.get("limit", "")
    at, _, name = after.partition("-")
    if after and not (at.isascii() and at.isdecimal() and len(at) < 16):
        raise Answer.of(422, "this is not where a page of the list begins", where="after")
    count = int(most[:4]) if most.isascii() and most.isdecimal() else limits.LISTED
    count = max(1, min(limits.LISTED, count))
    binned = request.query_params.get("binned", "0") in ("1", "true")
    words = request.query_params.get("words", "")[: limits.TITLE].split()[:8]
    found = await studio.library.do(studio.library.pieces, (int(at), name) if after else None, count, binned, words)
    following = f"{found[-1].changed}-{found[-1].id}" if len(found) == count else None
    return {"pieces": [await plain_piece(studio, p) for p in found], "next": following}


async def new(studio: Studio, request: Request, body: NewPiece) -> tuple[int, Plain]:
    """A new piece."""
    given = body.source
    name, digest, raw = "", None, None
    params = dict(body.params)
    called = body.craft
    title = body.title
    if body.seed is not None:
        called, params = called or "ink", {**params, "seed": body.seed}
    if body.example is not None:
        called, title, name, raw, params = _example(body.example, title, params)
    if given is not None:
        guess = "pattern.txt" if given.text is not None and not given.name else given.name or ""
        likely = crafts_of(clean_name(guess))
        if called is None and not likely:
            raise Answer.of(422, "no craft can begin with this file", where="source")
        what = known_craft(called or likely[0])
        name, digest, raw = source_of(what, given)
        called = what.name
    if called is None:
        raise Answer.of(422, "say what the piece is made of: a craft, a source, an example or a seed")
    what = known_craft(called)
    content = Content(
        name or None,
        digest or ("" if raw is not None else None),
        params,
        files_of(body.files),
        tuple(body.edits),
        1,
        __version__,
    )
    content = checked(what, content)
    title = titled(title or (Path(name).stem if name else str(params.get("seed", ""))) or what.name)
    return 201, await both(
        studio, await studio.library.do(studio.library.add, what.name, title, content, raw, body.own)
    )


def _example(wanted: str, title: str | None, params: Plain) -> tuple[str, str, str, bytes | None, Plain]:
    """Craft, title, source's name and bytes, and parameters of a piece that begins as an example."""
    for craft_name, listed in EXAMPLES.items():
        for known, called, usual in listed:
            if called == wanted:
                name, raw, own = example(craft_name, called, usual)
                return craft_name, title or known, name, raw, {**own, **params}
    raise Answer.of(422, "there is no such example", where="example")


def example(craft_name: str, called: str, usual: Plain) -> tuple[str, bytes | None, Plain]:
    """An example's source (name and bytes; none for a seed) and parameters."""
    if craft_name == "ink":
        return "", None, {"seed": called, **usual}
    return called, (folder() / craft_name / called).read_bytes(), dict(usual)


async def one(studio: Studio, request: Request) -> Plain:
    """A piece and its head."""
    piece = await studio.library.do(studio.library.piece, request.path_params["id"])
    return await both(studio, (piece, await studio.library.do(studio.library.revision, piece.head)))


async def alter(studio: Studio, request: Request, body: Alter) -> Plain:
    """Another title; out of the bin, or into it."""
    title = None if body.title is None else titled(body.title)
    piece = await studio.library.do(studio.library.alter, request.path_params["id"], title, body.binned)
    return {"piece": await plain_piece(studio, piece)}


async def binned(studio: Studio, request: Request) -> Plain:
    """Into the bin, from where it goes after thirty days."""
    piece = await studio.library.do(studio.library.alter, request.path_params["id"], None, True)
    return {"piece": await plain_piece(studio, piece)}


async def history(studio: Studio, request: Request) -> Plain:
    """The revisions of a piece, the youngest first."""
    name = request.path_params["id"]
    found = await studio.library.do(studio.library.history, name)
    piece = await studio.library.do(studio.library.piece, name)
    return {"revisions": [await plain_revision(studio, r, False) for r in found], "head": piece.head}


async def revise(studio: Studio, request: Request, body: NewRevision) -> tuple[int, Plain]:
    """A revision upon the head."""
    name = request.path_params["id"]
    piece = await studio.library.do(studio.library.piece, name)
    old = await studio.library.do(studio.library.revision, body.base)
    if old.piece != name:
        raise Answer.of(422, "this base is of another piece", where="base")
    what, raw = craft(piece.craft), None
    content = replace(old.content, version=__version__)
    if body.source is not None:
        given = body.source
        if given.name is None and content.name is not None:
            typed = given.text is not None and Path(content.name).suffix not in (
                ".txt",
                ".acl",
                ".md",
                ".csv",
                ".json",
                ".svg",
            )
            given = given.model_copy(update={"name": f"{Path(content.name).stem}.txt" if typed else content.name})
        called, digest, raw = source_of(what, given)
        content = replace(content, name=called, source=digest or "")
    if body.params is not None:
        content = replace(content, params=body.params)
    if body.files is not None:
        content = replace(content, files=files_of(body.files))
    if body.edits is not None:
        content = replace(content, edits=tuple(body.edits))
    content = checked(what, content)
    made = await studio.library.do(
        studio.library.revise, name, body.base, content, raw, body.said, body.merge, body.still
    )
    told = await both(studio, made)
    studio.hub.revised(name, made[1].id)
    return 201, told


async def undo(studio: Studio, request: Request) -> Plain:
    """The head goes to the revision before."""
    return await _gone(studio, request, "undo")


async def redo(studio: Studio, request: Request) -> Plain:
    """The head goes to where undo came from."""
    return await _gone(studio, request, "redo")


async def head(studio: Studio, request: Request, body: Go) -> Plain:
    """The head goes to a revision of the history."""
    return await _gone(studio, request, body.revision)


async def _gone(studio: Studio, request: Request, to: str | int) -> Plain:
    name = request.path_params["id"]
    made = await studio.library.do(studio.library.go, name, to)
    studio.hub.revised(name, made[1].id)
    return await both(studio, made)


async def send(studio: Studio, request: Request, body: Send) -> tuple[int, Plain]:
    """A piece of another craft, made of a view of this one."""
    piece = await studio.library.do(studio.library.piece, request.path_params["id"])
    revision = await studio.library.do(studio.library.revision, piece.head)
    here, there = craft(piece.craft), known_craft(body.craft)
    if body.view not in here.views:
        raise Answer.of(422, "there is no such view", f"there is {', '.join(here.views)}", where="view")
    kind = here.views[body.view].value
    # Data in JSON is read as a chart alone, and is one only where knitting wrote it.
    can = [s for s, k in files.WRITE if k == kind != "dict" and set(files.READ.get(s, {})) & set(there.reads)]
    can.sort(key=lambda s: s not in (".svg", ".png", ".dst", ".txt"))
    if not can or (body.suffix is not None and body.suffix not in can):
        hint = f"by {' '.join(can)}" if can else "take another view"
        raise Answer.of(422, f"{there.name} cannot begin with this view", hint, where="view")
    suffix = body.suffix or can[0]
    made = await until_left(request, studio.making.view(piece.craft, revision.content, body.view, suffix))
    if made.size > limits.UPLOAD or not made.name.endswith(suffix):
        raise Answer.of(422, "this view is too large to be sent on, or is several files")
    raw = made.path.read_bytes()
    content = checked(there, Content(made.name, "", {}, {}, (), 1, __version__))
    found = await studio.library.do(studio.library.add, there.name, piece.title, content, raw, True)
    return 201, await both(studio, found)


async def upload(studio: Studio, request: Request) -> tuple[int, Plain]:
    """A file, to be the source of a piece or the value of a field. It is opened by workers alone."""
    name = clean_name(request.query_params.get("name", ""))
    raw = await request.body()
    if not raw:
        raise Answer.of(422, "this file is empty", where="name")
    digest = await studio.library.do(studio.library.keep, raw)
    return 201, {"sha256": digest, "name": name, "size": len(raw), "crafts": crafts_of(name)}
