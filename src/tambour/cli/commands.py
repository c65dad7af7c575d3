"""The commands beside the crafts: make again, list and copy what there is, open the studio."""

from __future__ import annotations

import click

from tambour.cli.craft import made_and_told
from tambour.core.errors import Problem, TambourError


@click.command("run")
@click.argument("report")
@click.option("-o", "out", multiple=True, metavar="OUT", help="A file to write instead of the report's own.")
def again(report: str, out: tuple[str, ...]) -> None:
    """Make a piece again from its report."""
    import json
    from os.path import abspath
    from pathlib import Path

    from tambour.files.text import small
    from tambour.run import craft

    raw = small(report)
    try:
        told = json.loads(raw)
        name, values, origin = told["craft"], dict(told["params"]), told["source"] or {}
        kept, edits = told.get("files", []), told.get("edits", [])
        words = [name, *kept, *origin.values()]
        if not (isinstance(kept, list) and isinstance(edits, list) and all(isinstance(word, str) for word in words)):
            raise ValueError("words are wanted")
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError):
        raise TambourError("this is not a report of tambour", where=report) from None
    # A report may come from a stranger: by itself it writes beside itself or here, and nowhere else.
    rooms = [Path.cwd(), Path(report).absolute().parent]
    astray = [] if out else [k for k in kept if not any(Path(abspath(k)).is_relative_to(r) for r in rooms)]
    if astray:
        raise TambourError(
            [Problem("the report would write elsewhere", f"to write there: -o {k}", where=k) for k in astray]
        )
    what, source = craft(name), origin.get("path")
    made = made_and_told(what, source, what.params.of(values), out or tuple(kept), edits)
    if source and made["source"]["sha256"] != origin.get("sha256"):
        click.echo(f"{source}: warning: the source has changed since the report was written", err=True)


@click.command("formats")
def formats() -> None:
    """List the file types that can be read and written."""
    from tambour.files import READ, WRITE

    click.echo("read   " + " ".join(sorted(READ)))
    click.echo("write  " + " ".join(sorted({s for s, _ in WRITE})))


@click.command("examples")
@click.argument("folder", type=click.Path(file_okay=False))
def examples(folder: str) -> None:
    """Copy the examples into a folder."""
    from pathlib import Path

    from tambour.examples import copy

    made = copy(Path(folder))
    click.echo(f"wrote {len(made)} files into {folder}")


@click.command("studio")
@click.option("--port", type=click.IntRange(0, 65535), help="The port to serve at; 0 for any free one. [default: 8421]")
@click.option("--no-open", is_flag=True, help="Open no browser: print the address with its token, in one line.")
@click.option("--library", type=click.Path(dir_okay=False), help="The file that your pieces are kept in.")
@click.option("--host", default="127.0.0.1", show_default=True, help="The address to serve at.")
@click.option("--allow-host", "names", multiple=True, help="A name that the server may be called by from outside.")
@click.option(
    "--export",
    "archive",
    type=click.Path(dir_okay=False),
    metavar="FILE",
    help="Write all pieces into a .zip; serve nothing.",
)
def studio(
    port: int | None, no_open: bool, library: str | None, host: str, names: tuple[str, ...], archive: str | None
) -> None:
    """Open the four crafts in the browser, served by this machine to itself."""
    from importlib.util import find_spec
    from pathlib import Path

    if not all(find_spec(name) for name in ("starlette", "uvicorn", "websockets", "segno")):
        raise TambourError("the studio's libraries are not there", hint="pip install 'tambour[studio]'")
    from tambour.studio.serve import home, serve

    if archive is not None:
        from tambour.studio.export import export

        count = export(Path(library) if library else home() / "library.db", Path(archive))
        click.echo(f"wrote {count} pieces into {archive}")
        return
    serve(host, port, None if library is None else Path(library), names, not no_open, click.echo)
