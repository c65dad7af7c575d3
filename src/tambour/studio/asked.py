"""Asked: what a page may send of pieces, and what of it is taken: sources, parameters and edits, each checked before anything is made."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict, Field

from tambour import files
from tambour.core.errors import TambourError, unspeakable
from tambour.craft import Craft
from tambour.run import CRAFTS, craft
from tambour.studio import limits
from tambour.studio.context import Answer, clean_name
from tambour.studio.library import Content
from tambour.studio.problems import plains

Digest = Annotated[str, Field(pattern=r"^[0-9a-f]{64}$")]
Plain = dict[str, Any]
NAMES = {"crochet": "pattern.txt", "knit": "chart.json", "ink": "", "embroidery": "drawing.svg"}
"""Craft → what a source that was typed is called."""


class Body(BaseModel):
    """Base of what a page sends: nothing that is not known."""

    model_config = ConfigDict(extra="forbid", strict=True)


class SourceIn(Body):
    """A source: a text, or a file that was given before."""

    text: Annotated[str, Field(max_length=limits.TEXT)] | None = None
    sha256: Digest | None = None
    name: Annotated[str, Field(max_length=1000)] | None = None


class FileIn(Body):
    """A file for a field, given before."""

    sha256: Digest
    name: Annotated[str, Field(max_length=1000)]


class NewPiece(Body):
    """A piece to make: of a source, an example, or a seed. Without a craft, the one that the source is for. ``own``: where its
    craft has one of its title already, it is numbered."""

    craft: str | None = None
    title: Annotated[str, Field(max_length=limits.TITLE)] | None = None
    own: bool = False
    source: SourceIn | None = None
    example: Annotated[str, Field(max_length=100)] | None = None
    seed: Annotated[str, Field(max_length=1000)] | None = None
    params: Plain = Field(default_factory=dict)
    files: dict[str, FileIn] = Field(default_factory=dict)
    edits: list[Any] = Field(default_factory=list, max_length=limits.EDITS)


class Alter(Body):
    """What of a piece is changed beside its revisions."""

    title: Annotated[str, Field(max_length=limits.TITLE)] | None = None
    binned: bool | None = None


class NewRevision(Body):
    """A revision upon ``base``; what is left out is as it is there. ``merge``: part of one go of typing; ``still``:
    only where one looks is another, which takes the base's place and is nothing to undo."""

    base: Annotated[int, Field(ge=1, lt=2**53)]
    source: SourceIn | None = None
    params: Plain | None = None
    files: dict[str, FileIn] | None = None
    edits: Annotated[list[Any], Field(max_length=limits.EDITS)] | None = None
    said: Annotated[str, Field(max_length=limits.TITLE)] = ""
    merge: bool = False
    still: bool = False


class Go(Body):
    """The revision to go to."""

    revision: Annotated[int, Field(ge=1, lt=2**53)]


class Send(Body):
    """A view of the piece that becomes the source of a piece of another craft."""

    craft: str
    view: Annotated[str, Field(max_length=40)]
    suffix: Annotated[str, Field(max_length=12)] | None = None


def known_craft(name: str) -> Craft:
    """The craft of a name; else Answer 404."""
    if name not in CRAFTS:
        raise Answer.of(404, "there is no such craft", f"there is {', '.join(CRAFTS)}")
    return craft(name)


def checked(what: Craft, content: Content) -> Content:
    """Content whose parameters and edits the craft takes; else Answer 422 with all that is wrong.

    No parameter may name a file of the server's: files come by what was given.
    """
    problems: list[Plain] = []
    asked = set(what.params.files())
    for name, value in content.params.items():
        if name in asked and value is not None and str(value) not in what.params.words(name):
            problems += Answer.of(422, "a file is wanted here", "give the file itself", fields=[name]).problems
    for name in set(content.files) - asked:
        problems += Answer.of(422, f"there is no file “{name[:40]}” to give", fields=[name]).problems
    if len(json.dumps(content.params)) > limits.PARAMS:
        problems += Answer.of(413, "these parameters are too long").problems
    edition = 1
    try:
        given = {n: it["name"] for n, it in content.files.items() if n in asked}
        edition = what.params.of({**content.params, **given}).edition
    except TambourError as error:
        problems += plains(error, what)
    try:
        what.edits(content.edits)
    except TambourError as error:
        problems += plains(error, what)
    if content.source is None and what.reads and not what.optional_source:
        problems += Answer.of(422, f"{what.name} needs something to begin with", where="source").problems
    if content.source is not None:
        suffix = Path(content.name or "").suffix
        if not set(what.reads) & set(files.READ.get(suffix, {})):
            can = sorted(s for s, kinds in files.READ.items() if set(kinds) & set(what.reads))
            hint = f"these can: {' '.join(can)}" if can else f"{what.name} begins with a seed"
            problems += Answer.of(
                422, f"{what.name} cannot begin with a “{suffix}” file", hint, where="source"
            ).problems
    if problems:
        raise Answer(422, problems)
    return replace(content, edition=edition)


def crafts_of(name: str) -> list[str]:
    """The crafts that a file can be the source of, the likeliest first."""
    kinds = set(files.READ.get(Path(name).suffix, {}))
    drawn = (
        ("embroidery", "crochet", "knit") if kinds & {"Drawing", "ThreadPlan"} else ("knit", "embroidery", "crochet")
    )
    order = ("crochet", "embroidery", "knit") if "Text" in kinds else drawn
    return [c for c in order if kinds & set(craft(c).reads)]


def source_of(what: Craft, given: SourceIn) -> tuple[str, str | None, bytes | None]:
    """A source's name, and the digest of what is kept already or the bytes to keep."""
    if (given.text is None) == (given.sha256 is None):
        raise Answer.of(422, "a source is a text, or a file that was given before", where="source")
    name = clean_name(given.name or NAMES[what.name] or "source.txt")
    if given.text is not None:
        try:
            return name, None, given.text.encode()
        except UnicodeEncodeError:
            raise Answer.of(422, "this text holds halves of characters", where="source") from None
    return name, given.sha256, None


def files_of(given: dict[str, FileIn]) -> dict[str, dict[str, str]]:
    """Files for fields, by names that any disk takes."""
    return {field: {"name": clean_name(it.name), "sha256": it.sha256} for field, it in given.items()}


def titled(title: str) -> str:
    """A title as it is kept; else Answer 422."""
    title = " ".join(title.split())[: limits.TITLE] or "Untitled"
    if why := unspeakable(title):
        raise Answer.of(422, f"this title {why}", where="title")
    return title
