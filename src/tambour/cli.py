"""The command line: one command per craft, its options made from the craft's Params."""

from __future__ import annotations

import time

BEGAN = time.perf_counter()

import atexit  # noqa: E402
import gc  # noqa: E402
import os  # noqa: E402
import signal  # noqa: E402
import sys  # noqa: E402
import threading  # noqa: E402
import types  # noqa: E402
from collections.abc import Callable, Iterator  # noqa: E402
from contextlib import contextmanager, suppress  # noqa: E402
from typing import Any, Literal, Union, get_args, get_origin  # noqa: E402

# Threads are ours (core.threads): BLAS's own take .05 s to start, and add in an order that hangs on their number.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
atexit.register(gc.freeze)  # what is left at the end is the system's to clear, at once

import click  # noqa: E402

from tambour import __version__  # noqa: E402
from tambour.core.errors import Problem, TambourError, Text, did_you_mean, shown, spelt  # noqa: E402
from tambour.core.progress import Stopped  # noqa: E402
from tambour.run import CRAFTS  # noqa: E402
from tambour.sweep import command as sweep  # noqa: E402
from tambour.tiles import command as tiles  # noqa: E402

ISSUES = "please report it, with the command, the input and the lines above"


class _Crafts(click.Group):
    """Loads a craft only when its command is run or its help is asked for."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return [*CRAFTS, *sorted(self.commands)]

    def get_command(self, ctx: click.Context, name: str) -> click.Command | None:
        return craft_command(name) if name in CRAFTS else super().get_command(ctx, name)

    def invoke(self, ctx: click.Context) -> Any:
        try:
            return super().invoke(ctx)
        except BrokenPipeError:  # who reads no further has what they wanted; the files stand
            _hushed()
            return 0

    def resolve_command(self, ctx: click.Context, args: list[str]) -> Any:
        known = self.list_commands(ctx)
        if args and args[0] not in known and not args[0].startswith("-"):
            raise TambourError(
                f'there is no command "{args[0]}"', hint=did_you_mean(args[0], known) or f"known: {', '.join(known)}"
            )
        return super().resolve_command(ctx, args)

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        with formatter.section("Crafts"):
            formatter.write_dl([(name, line) for name, (_, line) in CRAFTS.items()])
        with formatter.section("Commands"):
            formatter.write_dl([(n, c.get_short_help_str(90)) for n, c in sorted(self.commands.items())])


class _Option(click.Option):
    """An option whose help is put together only where it is shown."""

    def __init__(self, *words: Any, told: Callable[[], str], **given: Any) -> None:
        super().__init__(*words, **given)
        self.told = told

    def get_help_record(self, ctx: click.Context) -> tuple[str, str] | None:
        self.help = self.told()
        return super().get_help_record(ctx)


@click.group(cls=_Crafts, context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 110})
@click.version_option(__version__, prog_name="tambour")
def tambour() -> None:
    """Turn a pattern, a picture or a seed into something to make with yarn, thread or ink, and see it first."""


def options(params: Any) -> Callable[[Any], Any]:
    """Decorate a click command with one option per field of a Params model.

    Values arrive as texts and are judged by the model alone, so that the library, the command line and the studio
    refuse the same things in the same words.
    """
    from tambour.core.params import unit

    def option(name: str, f: Any) -> Any:
        flag = "--" + name.rstrip("_").replace("_", "-")  # "from_": a word that Python keeps for itself
        extra = f.json_schema_extra if isinstance(f.json_schema_extra, dict) else {}
        kind, many = f.annotation, False
        if get_origin(kind) in (Union, types.UnionType):
            kind = next(k for k in get_args(kind) if k is not type(None))
        if get_origin(kind) is tuple and get_args(kind)[-1] is Ellipsis:
            kind, many = get_args(kind)[0], True

        def told() -> str:
            default = f.get_default(call_default_factory=True)
            standard = f"  [default: {_plain(default)}]" if default not in (None, (), "", False, True) else ""
            if kind is bool:
                standard = "" if default is None else f"  [default: {'on' if default else 'off'}]"
            note = _bounds(f)
            return spelt(params.help(name)) + standard + (f" [{note}]" if note else "")

        if kind is bool:
            return click.option(f"{flag}/--no-{flag[2:]}", name, cls=_Option, told=told, default=None)
        if get_origin(kind) is Literal:
            metavar = "[" + "|".join(str(w) for w in get_args(kind)) + "]"
        else:
            counted = extra.get("metavar") or unit(f) or {int: "N", float: "X"}.get(kind, "TEXT")
            metavar = "|".join([*extra.get("words", []), "FILE"]) if "file" in extra else str(counted).upper()
        return click.option(flag, name, cls=_Option, told=told, type=str, default=None, metavar=metavar, multiple=many)

    def decorate(command: Any) -> Any:
        for name, f in reversed(list(params.asked().items())):
            command = option(name, f)(command)
        return command

    return decorate


def _plain(default: Any) -> str:
    return ", ".join(map(str, default)) if isinstance(default, tuple) else str(default)


def _bounds(f: Any) -> str:
    from tambour.core.params import bounds

    signs = {"minimum": "≥", "exclusiveMinimum": ">", "maximum": "≤", "exclusiveMaximum": "<"}
    return ", ".join(f"{signs[k]} {v}" for k, v in bounds(f).items() if k in signs)


def craft_command(name: str) -> click.Command:
    """The command of one craft."""
    from tambour.run import craft

    what = craft(name)
    views = "\n".join(
        f"  {v:<10} {spelt(it.help)}" + (f" ({' '.join(it.suffixes)})" if it.suffixes else "")
        for v, it in what.views.items()
    )
    text = f"{what.help}\n\n\b\nViews (-o name.VIEW.suffix; the suffixes in brackets take it by themselves):\n{views}"

    @click.command(name, help=text)
    @options(what.params)
    @click.option(
        "-o",
        "out",
        multiple=True,
        metavar="OUT",
        help="A file to write; may be given several times. -.svg: standard output.",
    )
    @click.option("--edit", "edit", multiple=True, metavar="KIND:PLACE=VALUE", help=_edits(what))
    @click.option(
        "--edits", "edits", metavar="FILE", help="A JSON file of edits, such as a report; before those of --edit."
    )
    @click.option("--report", metavar="FILE", help="Write what was measured as JSON.")
    @click.option("--quiet", is_flag=True, help="No progress, no summary.")
    def command(source: str | None = None, **given: Any) -> None:
        run_craft(what, source, **given)

    if what.reads:
        command.params.insert(0, click.Argument(["source"], required=not what.optional_source))
    return command


def _edits(what: Any) -> str:
    """The help of --edit: the kinds of edits that a craft understands."""
    kinds = [f"{k}:{c.words.replace('{', '').replace('}', '').upper()}, {c.help}" for k, c in what.changes.items()]
    return "Change a thing by hand; may be given several times. " + "; ".join(kinds)


def run_craft(
    what: Any,
    source: str | None,
    out: tuple[str, ...],
    report: str | None,
    quiet: bool,
    edit: tuple[str, ...] = (),
    edits: str | None = None,
    **given: Any,
) -> None:
    """Run one craft from the words of the command line."""
    from tambour.files.text import read_edits
    from tambour.run import run

    values = {name: value for name, value in given.items() if value is not None and value != ()}
    params = what.params.of(values)
    with _bar(quiet) as progress, _streams(what, source, out) as (given_source, places):
        changed = [*(read_edits(edits) if edits else ()), *edit]
        made = run(what, given_source, params, places, progress, BEGAN, report, changed)
    for problem in progress.warnings:
        click.echo(str(problem), err=True)
    if not quiet and places == out:  # else standard output is the piece
        summary(made)


_BEGINS = (
    (b"\x89PNG", ".png"),
    (b"\xff\xd8", ".jpg"),
    (b"RIFF", ".webp"),
    (b"<", ".svg"),
    (b"glTF", ".glb"),
    (b"%PDF", ".pdf"),
)


@contextmanager
def _streams(what: Any, source: str | None, out: tuple[str, ...]) -> Iterator[tuple[Any, tuple[str, ...]]]:
    """The source and the outputs, where ``-`` is standard input, of the kind that its first bytes say (else text), and ``-.svg`` standard output."""
    from dataclasses import replace
    from pathlib import Path
    from tempfile import TemporaryDirectory

    from tambour.files import LARGEST, read
    from tambour.files.sink import refused

    to = [name for name in out if name == "-" or name.startswith("-.")]
    if "-" in to or len(to) > 1:
        message = "standard output takes one file" if len(to) > 1 else "the kind of file is missing"
        raise TambourError(message, hint="such as: -o -.svg", where="-o -")
    if not to and source != "-":
        yield source, out
        return
    with TemporaryDirectory(prefix="tambour-") as folder:
        value: Any = source
        if source == "-":
            raw = sys.stdin.buffer.read(LARGEST + 1)
            place = Path(folder) / f"stdin{next((s for start, s in _BEGINS if raw.lstrip().startswith(start)), '.txt')}"
            place.write_bytes(raw)
            try:
                value = read(place, what.reads)
            except TambourError as error:
                raise TambourError([replace(p, where="<stdin>") for p in error.problems]) from None
            if isinstance(value, Text):
                value = replace(value, name="<stdin>")
        room = Path(folder) / "out"
        room.mkdir()
        yield value, tuple(str(room / f"stdout{name[1:]}") if name in to else name for name in out)
        made = sorted(room.iterdir())
        if len(made) > 1:
            raise TambourError(f"this makes {len(made)} files, standard output takes one", where=f"-o {to[0]}")
        with refused(Path(f"-o {to[0]}" if to else "-")):
            for one in made:
                sys.stdout.buffer.write(one.read_bytes())
                sys.stdout.buffer.flush()


def summary(report: dict[str, Any]) -> None:
    """Print what was made: the short facts, then the files."""
    skip = {"craft", "version", "edition", "params", "source", "edits", "warnings", "problems", "files", "seconds"}
    for key, value in report.items():
        if key not in skip and isinstance(value, (int, float, str)) and not isinstance(value, bool):
            text = f"{value:.4g}" if isinstance(value, float) else shown(str(value))
            click.echo(f"{key.replace('_', ' ')}: {text}")
        elif isinstance(value, list) and value and all(isinstance(v, (int, float)) for v in value):
            click.echo(f"{key.replace('_', ' ')}: {' × '.join(f'{v:.4g}' for v in value)}")
    for path in report["files"]:
        click.echo(shown(f"wrote {path}"))


def _bar(quiet: bool) -> Any:
    """A context that gives a Progress: a bar on a terminal, silent elsewhere."""
    from contextlib import contextmanager

    from tambour.core.progress import Progress

    @contextmanager
    def shown() -> Any:
        if quiet or not sys.stderr.isatty():
            yield Progress()
            return
        from rich.console import Console
        from rich.progress import BarColumn, TextColumn, TimeElapsedColumn
        from rich.progress import Progress as Bars

        columns = (
            TextColumn("{task.description:<18}"),
            BarColumn(),
            TextColumn("{task.fields[count]}"),
            TimeElapsedColumn(),
        )
        with Bars(*columns, console=Console(stderr=True), transient=True) as bars:
            task = bars.add_task("start", total=None, count="")

            def show(stage: str, done: int, total: int) -> None:
                count = f"{done:,} of {total:,}" if total else ""
                bars.update(task, description=stage, completed=done, total=total or None, count=count)

            yield Progress(show)

    return shown()


@tambour.command("run")
@click.argument("report", type=click.Path(exists=True, dir_okay=False))
@click.option("-o", "out", multiple=True, metavar="OUT", help="A file to write instead of the report's own.")
def again(report: str, out: tuple[str, ...]) -> None:
    """Make a piece again from its report."""
    import json
    from os.path import abspath
    from pathlib import Path

    from tambour.files.text import small
    from tambour.run import craft, run

    raw = small(report)
    try:
        told = json.loads(raw)
        name, values, source = told["craft"], dict(told["params"]), (told["source"] or {}).get("path")
        known, kept = (told["source"] or {}).get("sha256"), told.get("files", ())
        edits = list(told.get("edits", ()))
        words = [name, *kept, *([source] if source is not None else [])]
        if isinstance(kept, str) or not all(isinstance(word, str) for word in words):
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
    what = craft(name)
    made = run(what, source, what.params.of(values), out or kept, began=BEGAN, edits=edits)
    if known and made["source"]["sha256"] != known:
        click.echo(f"{source}: warning: the source has changed since the report was written", err=True)
    summary(made)


@tambour.command("formats")
def formats() -> None:
    """List the file types that can be read and written."""
    from tambour.files import READ, WRITE

    click.echo("read   " + " ".join(sorted(READ)))
    click.echo("write  " + " ".join(sorted({s for s, _ in WRITE})))


@tambour.command("examples")
@click.argument("folder", type=click.Path(file_okay=False))
def examples(folder: str) -> None:
    """Copy the examples into a folder."""
    from pathlib import Path

    from tambour.examples import copy

    made = copy(Path(folder))
    click.echo(f"wrote {len(made)} files into {folder}")


@tambour.command("studio")
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


tambour.add_command(sweep.command)
tambour.add_command(tiles.command)


def _opened() -> None:
    """See that the three standard streams are open, so that no file that is written takes the place of one."""
    for number in range(3):
        try:
            os.fstat(number)
        except OSError:
            os.open(os.devnull, os.O_RDWR)
    sys.stdout = sys.stdout or open(os.devnull, "w")  # noqa: SIM115
    sys.stderr = sys.stderr or open(os.devnull, "w")  # noqa: SIM115


def _hushed() -> None:
    """Send what is still to be printed nowhere."""
    with suppress(OSError, ValueError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


@contextmanager
def _stoppable() -> Iterator[None]:
    """Signals that ask the process to end are raised as Stopped, so that what is being made is cleared away."""

    def leave(number: int, frame: Any) -> None:
        raise Stopped(number)

    names = [getattr(signal, n) for n in ("SIGTERM", "SIGHUP") if hasattr(signal, n)]
    before = {s: signal.getsignal(s) for s in names if threading.current_thread() is threading.main_thread()}
    before = {s: handler for s, handler in before.items() if handler is not signal.SIG_IGN}
    for number in before:
        signal.signal(number, leave)
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, signal.SIG_DFL if handler is None else handler)


def main(arguments: list[str] | None = None) -> None:
    """Run the command line; leaves with 0, 2 for bad input, 1 for a fault of ours, 130 when interrupted."""
    _opened()
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="replace")  # a terminal that cannot show "→" is no reason to stop
    try:
        os.getcwd()
    except OSError:
        click.echo("the folder that you are in is not there any more; go to another", err=True)
        sys.exit(2)
    try:
        with _stoppable():
            code = tambour.main(arguments, prog_name="tambour", standalone_mode=False)
            sys.stdout.flush()
    except TambourError as error:
        for problem in error.problems:
            click.echo(str(problem), err=True)
        sys.exit(2)
    except (click.exceptions.Abort, KeyboardInterrupt):
        click.echo("interrupted; no file is left half written", err=True)
        sys.exit(130)
    except Stopped as stopped:
        click.echo("stopped; no file is left half written", err=True)
        sys.exit(128 + stopped.args[0])
    except click.ClickException as error:
        error.show()
        sys.exit(2)
    except OSError as error:  # files speak by TambourError: this was printing, or something that bears a name
        _hushed()
        told = "cannot be printed" if error.filename is None else f"{shown(str(error.filename))}: the system refuses"
        click.echo(f"{told}: {error.strerror}", err=True)
        sys.exit(2)
    except Exception:  # noqa: BLE001 - the last line of defence: a traceback, and what to do with it
        import traceback

        traceback.print_exc()
        click.echo(f"\nThis is a fault of tambour {__version__}: {ISSUES}.", err=True)
        sys.exit(1)
    sys.exit(code if isinstance(code, int) else 0)
