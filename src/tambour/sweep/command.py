"""Command: ``tambour sweep``: the words of the command line, how far it is, and what failed."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import click

if TYPE_CHECKING:
    from tambour.core.errors import Problem
    from tambour.sweep.course import Result

LINE_SECONDS = 30.0
"""Time between two lines of progress where there is no terminal."""


class Making(NamedTuple):
    """How the pieces of a command are made, as its options say."""

    jobs: int | None
    limit: str
    again: bool
    scheduler: str
    cluster: int | None
    quiet: bool


def with_making(command: Callable[..., int]) -> Callable[..., int]:
    """A command with the options of :class:`Making`."""
    many = click.IntRange(1, 1024)
    for option in (
        click.option("--quiet", is_flag=True, help="No progress, no summary."),
        click.option("--cluster", type=many, metavar="N", help="On a Dask cluster here, of N workers."),
        click.option("--scheduler", default="", metavar="tcp://…", help="Make them on this Dask cluster."),
        click.option("--again", is_flag=True, help="Make what is finished once more."),
        click.option("--limit", default="", metavar="2GB,60s", help="Memory and time that one may take."),
        click.option("--jobs", type=many, metavar="N", help="Processes here. [default: the processors]"),
    ):
        command = option(command)
    return command


@click.command("sweep", short_help="Make many pieces: every source with every combination of values.")
@click.argument("craft")
@click.argument("sources", nargs=-1)
@click.option(
    "-o", "outs", multiple=True, metavar="OUT", help="The folder (out/), and kinds of files (.png, .back.png)."
)
@click.option("--set", "axes", multiple=True, metavar="NAME=VALUES", help="What varies: max_float=3,4,5 or seed=0..9.")
@click.option("--edit", "edit", multiple=True, metavar="KIND:PLACE=VALUE", help="Change every piece by hand.")
@click.option("--edits", "edits", metavar="FILE", help="A JSON file of edits for every piece; before those of --edit.")
@click.option("--no-sheet", is_flag=True, help="No small pictures and no contact sheet.")
@with_making
def command(
    craft: str,
    sources: tuple[str, ...],
    outs: tuple[str, ...],
    axes: tuple[str, ...],
    edit: tuple[str, ...],
    edits: str | None,
    no_sheet: bool,
    **making: Any,
) -> int:
    """Make every source with every combination of values, each named by them.

    \b
    tambour sweep knit photos/ --set max_float=3,4,5 --set stitches=60,80 -o out/ -o .png -o .pdf
    tambour sweep ink --set seed=0..9 --set span=1200 -o out/ -o .svg

    VALUES are a list (3,4,5), a range (0..9, or 0..1..0.25 in steps) or a JSON list (["a,b", "c"]). The folder gets
    the files, reports/ with a report each, index.csv made from them, and a contact sheet (sheet.png, sheet.html). What
    is finished there is not made again. One failure stops nothing: it is listed, and the command leaves with 1.
    """  # noqa: D301 - the sign itself: click keeps the lines below it
    from tambour.core.errors import TambourError
    from tambour.files.text import read_edits
    from tambour.sweep.course import course, planned, pool

    how = Making(**making)
    folders, kinds, problems = divided(outs, how)
    try:
        changed = [*(read_edits(edits) if edits else ()), *edit]
        plan, limited, count, doubts = planned(
            craft, sources, axes, kinds, changed, how.limit, not no_sheet, folders[0] if folders else None
        )
    except TambourError as error:
        problems += error.problems
    if problems:
        raise TambourError(problems)
    for doubt in doubts:
        click.echo(str(doubt), err=True)
    tally = Tally(count, how.quiet)
    workers = pool(how.jobs, limited, how.scheduler, how.cluster or 0)
    for made in course(plan, folders[0], workers, how.again, not no_sheet):
        tally.count(made)
    tally.end(folders[0])
    return 1 if tally.failed else 0


def divided(outs: Sequence[str], how: Making) -> tuple[list[str], list[str], list[Problem]]:
    """What -o names: places (one is wanted), and kinds of files; and what is wrong with that, and with who shall make it."""
    from tambour.core.errors import Problem as Told

    places = [o for o in outs if not o.startswith(".") or "/" in o or o in (".", "..")]
    kinds = list(dict.fromkeys(o for o in outs if o not in places))
    problems = []
    if len(places) != 1:
        told = "name one folder" if places else "a folder is wanted for the pieces"
        problems.append(Told(told, "such as -o out/", where="-o"))
    where = [
        w for w, given in (("--jobs", how.jobs), ("--scheduler", how.scheduler), ("--cluster", how.cluster)) if given
    ]
    if len(where) > 1:
        problems.append(Told(f"{' and '.join(where)} say two things", "one of them is enough", where=where[-1]))
    return places, kinds, problems


class Tally:
    """What has become of the pieces so far: told in one line on a terminal, and now and then elsewhere."""

    def __init__(self, total: int, quiet: bool) -> None:
        self.total, self.quiet = total, quiet
        self.made = self.kept = 0
        self.failed: list[Result] = []
        self.began = self.shown = time.monotonic()
        self.first: float | None = None
        self.terminal = sys.stderr.isatty()

    def count(self, result: Result) -> None:
        """One more; failures are told at once."""
        from tambour.core.errors import shown

        if result.status == "failed":
            self.failed.append(result)
            self._clear()
            click.echo(shown(f"{result.name}: failed: {result.reason}"), err=True)
        elif result.status == "made":
            self.made += 1
        else:
            self.kept += 1
        now = time.monotonic()
        if self.first is None and result.status != "kept":
            self.first = now
        if not self.quiet and now - self.shown > (0.2 if self.terminal else LINE_SECONDS):
            self.shown = now
            self._clear()
            click.echo(self.line(now), err=True, nl=not self.terminal)

    def line(self, now: float) -> str:
        """How far it is, how fast, and how long it will take."""
        done = self.made + self.kept + len(self.failed)
        worked = self.made + len(self.failed)
        text = f"{done:,} of {self.total:,}"
        text += f", {self.kept:,} finished before" if self.kept else ""
        text += f", {len(self.failed):,} failed" if self.failed else ""
        # The first piece waits for its worker to start; it says nothing of those that follow.
        spent = now - (now if self.first is None else self.first)
        if worked > 1 and spent > 0:
            rate = (worked - 1) / spent
            text += f" · {rate:.3g} pieces a second · {_time((self.total - done) / rate)} left"
        return text

    def end(self, folder: str) -> None:
        """The last words: all that failed, and how many there are."""
        from tambour.core.errors import shown

        self._clear()
        if self.quiet:
            return
        words = [f"{self.made:,} made", f"{self.kept:,} finished before" if self.kept else ""]
        words.append(f"{len(self.failed):,} failed" if self.failed else "")
        spent = time.monotonic() - self.began
        click.echo(shown(f"{', '.join(w for w in words if w)} in {_time(spent)}: {folder}"))
        for result in self.failed[:100]:
            click.echo(shown(f"  {result.name}: {result.reason.splitlines()[0]}"))
        if len(self.failed) > 100:
            click.echo(f"  and {len(self.failed) - 100:,} more: index.csv")

    def _clear(self) -> None:
        if self.terminal and not self.quiet:
            click.echo("\r\033[K", err=True, nl=False)


def _time(seconds: float) -> str:
    if seconds < 90:
        return f"{seconds:.1f} s" if seconds < 10 else f"{seconds:.0f} s"
    return f"{seconds / 60:.0f} min" if seconds < 5400 else f"{seconds / 3600:.1f} h"
