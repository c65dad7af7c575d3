"""Command: ``tambour tiles``: the words of the command line."""

from __future__ import annotations

from typing import Any

import click

from tambour.sweep.command import Making, Tally, divided, with_making


@click.command("tiles", short_help="Cut the endless scroll into numbered tiles, plotter sheets or hoops.")
@click.option("--seed", default="1", show_default=True, metavar="TEXT", help="The scroll's seed, any text.")
@click.option(
    "--first", type=int, default=0, show_default=True, metavar="N", help="The number of the first tile; below 0 too."
)
@click.option(
    "--count", type=click.IntRange(1, 10_000_000), default=16, show_default=True, metavar="N", help="How many."
)
@click.option(
    "-o",
    "outs",
    multiple=True,
    metavar="OUT",
    help="The folder (out/) or .zip, and the kind of tile (.png, .svg, .dst).",
)
@click.option(
    "--pixels", type=click.IntRange(16, 8192), default=512, show_default=True, metavar="N", help="Width of a picture."
)
@click.option("--set", "sets", multiple=True, metavar="NAME=VALUE", help="What else ink can be told: season=winter.")
@with_making
def command(
    seed: str,
    first: int,
    count: int,
    outs: tuple[str, ...],
    pixels: int,
    sets: tuple[str, ...],
    **making: Any,
) -> int:
    """Cut the endless scroll into numbered tiles: each is made of the seed and its number alone.

    \b
    tambour tiles --seed 7 --first 0 --count 2000 -o scroll/
    tambour tiles --seed 7 --count 300 -o scroll.zip -o .svg
    tambour tiles --seed 7 --count 6 -o sheets/ -o .svg --set plotter=yes --set page=a3
    tambour tiles --seed 7 --count 6 -o hoops/ -o .dst --set page=100x100mm

    Pictures and SVG are 512 units of the scroll wide, and scroll.html beside them shows them all, near and from afar,
    without a server. Plotter sheets have crosses where the next one continues. Hoops are as large as the page, and meet
    stitch for stitch.
    """  # noqa: D301 - the sign itself: click keeps the lines below it
    from pathlib import Path

    from tambour.core.errors import Problem, TambourError
    from tambour.sweep.course import pool
    from tambour.tiles.leave import into_folder, into_zip
    from tambour.tiles.plan import tiles
    from tambour.work.limit import Limit

    how = Making(**making)
    places, kinds, problems = divided(outs, how)
    limited = Limit()
    try:
        limited = Limit.of(how.limit) if how.limit else limited
    except TambourError as error:
        problems += error.problems
    try:
        plan, doubts = tiles(seed, first, count, kinds, sets, pixels)
    except TambourError as error:
        problems += error.problems
    packed = any(place.lower().endswith(".zip") for place in places)
    if packed and how.again:
        problems.append(Problem("has no effect on a .zip: it is always made whole", where="{--again}"))
    if problems:
        raise TambourError(problems)
    for doubt in doubts:
        click.echo(str(doubt), err=True)
    tally = Tally(count, how.quiet)
    place = Path(places[0])
    workers = pool(how.jobs, limited, how.scheduler, how.cluster or 0)
    for made in into_zip(plan, place, workers) if packed else into_folder(plan, place, workers, how.again):
        tally.count(made)
    tally.end(places[0])
    return 1 if tally.failed else 0
