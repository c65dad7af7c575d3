"""Leave: tiles into a folder, where what is finished stays, or one after the other into a .zip; and the page over them."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import closing
from pathlib import Path
from typing import Any

from tambour.core.errors import Problem, TambourError
from tambour.sweep.course import Pool, Result, course
from tambour.sweep.folder import THUMBS, Folder
from tambour.tiles import overview
from tambour.tiles.plan import PICTURES, Tiles


def into_folder(tiles: Tiles, out: Path, pool: Pool, again: bool = False) -> Iterator[Result]:
    """The results, as those of a sweep; in the end the pictures from afar and the page, where all tiles are there."""
    failed = False
    for result in course(tiles, out, pool, again, sheet=False):
        failed = failed or result.status == "failed"
        yield result
    if failed or tiles.name != "tile":
        return
    with Folder(out) as folder:
        for name, raw in _page(tiles, lambda k: (out / THUMBS / f"tile={k}.webp").read_bytes()):
            (out / name).parent.mkdir(parents=True, exist_ok=True)
            folder.leave(out / name, raw)


def into_zip(tiles: Tiles, out: Path, pool: Pool) -> Iterator[Result]:
    """The same in one file, in the order of numbers and without dates: equal tiles make equal archives.

    It appears when all tiles are made. TambourError where one fails: an archive with gaps is none.
    """
    import zipfile

    from tambour.files.sink import Writing, refused

    waiting: dict[str, Result] = {}
    small: dict[int, bytes] = {}
    names = (f"{tiles.name}={k}" for k in range(tiles.first, tiles.first + tiles.count))
    with Writing() as writing, refused(out):
        with writing.sink(out).stream() as stream, zipfile.ZipFile(stream, "w", allowZip64=True) as archive:

            def put(name: str, raw: bytes) -> None:
                entry = zipfile.ZipInfo(name)
                packed = Path(name).suffix in (*PICTURES, ".pdf")
                entry.compress_type = zipfile.ZIP_STORED if packed else zipfile.ZIP_DEFLATED
                entry.external_attr = 0o644 << 16
                archive.writestr(entry, raw)

            wanted = next(names, None)
            results = course(tiles, None, pool)
            with closing(results):  # type: ignore[type-var]
                for result in results:
                    if result.status == "failed":
                        told = Problem(result.reason, "a folder keeps what is made: -o scroll/", where=result.name)
                        raise TambourError(told)
                    waiting[result.name] = result
                    while wanted in waiting:
                        made = waiting.pop(wanted)
                        for name, raw in made.data.items():
                            put(name, raw)
                        if made.thumb:
                            small[int(wanted.partition("=")[2])] = made.thumb
                            put(f"{THUMBS}/{wanted}.webp", made.thumb)
                        wanted = next(names, None)
                    yield result
            if tiles.name == "tile":
                for name, raw in _page(tiles, small.__getitem__):
                    put(name, raw)
        writing.commit()


def _page(tiles: Tiles, small: Callable[[int], bytes]) -> Iterator[tuple[str, bytes]]:
    """The pictures from afar, and the page."""
    from tambour.ink.paint.layers import LIGHTS

    params: Any = tiles.piece(tiles.first).job.params
    white = not params["paper"] and params["time"] != "night"
    ground = (255, 255, 255) if white else tuple(LIGHTS[params["time"]].paper)
    yield from overview.pictures(tiles.first, tiles.count, small)
    yield overview.PAGE, overview.page(tiles.first, tiles.count, tiles.out[0], str(params["seed"]), ground)
