"""The command of one craft: its options made from its Params, and what it says."""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any, Literal, get_args, get_origin

import click

from tambour.cli.process import BEGAN, streams
from tambour.core.errors import TambourError, shown, spelt
from tambour.core.errors import option as spelling


class _Option(click.Option):
    """An option whose help is put together only where it is shown."""

    def __init__(self, *words: Any, told: Callable[[], str], **given: Any) -> None:
        super().__init__(*words, **given)
        self.told = told

    def get_help_record(self, ctx: click.Context) -> tuple[str, str] | None:
        self.help = self.told()
        return super().get_help_record(ctx)


def options(params: Any) -> Callable[[Any], Any]:
    """Decorate a click command with one option per field of a Params model.

    Values arrive as texts and are judged by the model alone, so that the library, the command line and the studio
    refuse the same things in the same words.
    """
    from tambour.core.params import kind_of, unit

    def option(name: str, f: Any) -> Any:
        flag = spelling(name)
        extra = f.json_schema_extra if isinstance(f.json_schema_extra, dict) else {}
        kind, many = kind_of(f.annotation)

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
    @click.option("--verbose", is_flag=True, help="All that was measured in the summary.")
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
    verbose: bool = False,
    edit: tuple[str, ...] = (),
    edits: str | None = None,
    **given: Any,
) -> None:
    """Run one craft from the words of the command line."""
    from tambour.files.text import read_edits

    values = {name: value for name, value in given.items() if value is not None and value != ()}
    params = what.params.of(values)
    changed = [*(read_edits(edits) if edits else ()), *edit]
    made_and_told(what, source, params, out, changed, report, quiet, verbose)


def made_and_told(
    what: Any,
    source: str | None,
    params: Any,
    out: tuple[str, ...],
    edits: Sequence[Any],
    report: str | None = None,
    quiet: bool = False,
    verbose: bool = False,
) -> dict[str, Any]:
    """Make a piece and its files, with a bar, warnings and a summary; gives the report."""
    from tambour.run import run

    with _bar(quiet) as progress, streams(what.reads, source, out) as (given, places):
        try:
            made = run(what, given, params, places, progress, BEGAN, report, edits)
        except TambourError as error:
            raise pictured(error, places if places == out else ()) from None
    for problem in progress.warnings:
        if problem not in progress.told:
            click.echo(str(problem), err=True)
    if not quiet and places == out:  # else standard output is the piece
        summary(made, () if verbose else what.inner, verbose)
    return made


def pictured(error: TambourError, out: tuple[str, ...]) -> TambourError:
    """An error that a picture shows best, with that picture beside the first file that was asked for, and its name in the hint."""
    from pathlib import Path

    from tambour.files import write

    if error.seen is None or not out or out[0].startswith("."):
        return error
    name, draw = error.seen
    path = Path(out[0])
    path = path.with_name(f"{path.name.split('.')[0]}.{name}.png")
    write(draw(), path, "Picture")
    first = replace(error.problems[0], hint=f"{error.problems[0].hint}; {path} shows where")
    return TambourError([first, *error.problems[1:]])


_VERDICT = ("check", "reading", "left_open")
"""What is said where a check was asked for: its verdict, what of the text it could not read, and what that leaves open."""


def summary(report: dict[str, Any], inner: Sequence[str] = (), verbose: bool = False) -> None:
    """Print what was made: the short facts but ``inner`` ones, then the files. A verdict stands alone, unless all is asked for."""
    skip = {
        "craft",
        "version",
        "edition",
        "params",
        "source",
        "edits",
        "warnings",
        "problems",
        "files",
        "seconds",
        *inner,
    }
    if "check" in report and not verbose:
        skip |= set(report) - set(_VERDICT)
    for key, value in report.items():
        if key in skip:
            continue
        if isinstance(value, (int, float, str)) and not isinstance(value, bool):
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

    def tell(problem: Any) -> None:
        click.echo(str(problem), err=True)

    @contextmanager
    def shown() -> Any:
        if quiet or not sys.stderr.isatty():
            yield Progress(tell=tell)
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

            yield Progress(show, tell=tell)

    return shown()
