"""The command line: one command per craft, its options made from the craft's Params."""

from __future__ import annotations

from tambour.cli.process import hushed, opened, stoppable

# isort: split
# The process's clock starts, and its threads are said, before anything else is loaded.
import os
import sys
from typing import Any

import click

from tambour import __version__
from tambour.cli import commands
from tambour.cli.craft import craft_command
from tambour.core.errors import Problem, TambourError, did_you_mean, shown
from tambour.core.progress import Stopped
from tambour.run import CRAFTS
from tambour.sweep import command as sweep
from tambour.tiles import command as tiles

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
            hushed()
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


@click.group(cls=_Crafts, context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 110})
@click.version_option(__version__, prog_name="tambour")
def tambour() -> None:
    """Turn a pattern, a picture or a seed into something to make with yarn, thread or ink, and see it first."""


for command in (commands.again, commands.formats, commands.examples, commands.studio, sweep.command, tiles.command):
    tambour.add_command(command)


def _misused(error: click.UsageError) -> Problem:
    """What click finds wrong with the words of a command, in the form of every other problem."""
    command = "tambour" if error.ctx is None else error.ctx.command_path
    near = ""
    if isinstance(error, click.NoSuchOption) and error.ctx is not None:
        near = did_you_mean(error.option_name, [word for one in error.ctx.command.params for word in one.opts])
    said = error.message if isinstance(error, click.NoSuchOption) else error.format_message()
    return Problem(said[:1].lower() + said[1:].rstrip("."), near or f"{command} --help tells more", where=command)


def main(arguments: list[str] | None = None) -> None:
    """Run the command line; leaves with 0, 2 for bad input, 1 for a fault of ours, 130 when interrupted."""
    opened()
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="replace")  # a terminal that cannot show "→" is no reason to stop
    try:
        os.getcwd()
    except OSError:
        click.echo("the folder that you are in is not there any more; go to another", err=True)
        sys.exit(2)
    try:
        with stoppable():
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
    except click.exceptions.NoArgsIsHelpError as error:
        error.show()
        sys.exit(2)
    except click.UsageError as error:
        click.echo(str(_misused(error)), err=True)
        sys.exit(2)
    except OSError as error:  # files speak by TambourError: this was printing, or something that bears a name
        hushed()
        told = "cannot be printed" if error.filename is None else f"{shown(str(error.filename))}: the system refuses"
        click.echo(f"{told}: {error.strerror}", err=True)
        sys.exit(2)
    except Exception:  # noqa: BLE001 - the last line of defence: a traceback, and what to do with it
        import traceback

        traceback.print_exc()
        click.echo(f"\nThis is a fault of tambour {__version__}: {ISSUES}.", err=True)
        sys.exit(1)
    sys.exit(code if isinstance(code, int) else 0)
