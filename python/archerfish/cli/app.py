"""The command `archerfish`, and what becomes of its errors: one line and an exit status."""

from __future__ import annotations

import contextlib
import errno
import importlib
import io
import os
import signal
import sys

import click
import numpy as np

from archerfish import __version__
from archerfish.cli.errors import RefusedValue

BAD_INPUT = 2
FAILURE = 1
INTERRUPTED = 130


class Commands(click.Group):
    """Each command stands in the module of its name, which is imported when it is asked for."""

    NAMES = ("aim", "angles", "envelope", "explore", "figure", "locus", "series", "shot")

    def list_commands(self, ctx: click.Context) -> list[str]:  # noqa: ARG002 - click's
        """The names, in the order of the help page."""
        return list(self.NAMES)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """The command of that name. For another name click looks for one like it among them all."""
        for name in [cmd_name] if cmd_name in self.NAMES else self.NAMES:
            self.add_command(getattr(importlib.import_module(f"archerfish.cli.{name}"), name))
        return super().get_command(ctx, cmd_name)


@click.group(
    cls=Commands,
    invoke_without_command=True,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
    epilog="""\b
Examples:
  archerfish locus --speed 10 --epsilon 0.1
  archerfish locus --speed 10 --terminal-speed 30 --output locus.csv --figure locus.svg
  archerfish figure 4 --output curvature.png
  archerfish series --of exact --order 6
  archerfish shot --speed 10 --epsilon 0.1 --angle 45 --figure shot.svg
  archerfish aim --speed 10 --epsilon 0.1 --x 6 --y 2
  archerfish angles --epsilon 0.1
  archerfish envelope --speed 10 --epsilon 0.1
""",
)
@click.version_option(__version__, prog_name="archerfish")
@click.pass_context
def archerfish(context: click.Context) -> None:
    """Projectile motion under gravity and linear drag: shots, aiming and the locus of apexes.

    Angles are in degrees, everything else in SI units. `archerfish COMMAND --help` explains each
    command.
    """
    if context.invoked_subcommand is None:
        click.echo(context.get_help())


def main() -> None:
    """Run the command on the process's arguments and end the process."""
    if hasattr(signal, "SIGPIPE"):
        # A reader that has seen enough (`| head`) ends this process, as it does any other tool.
        signal.signal(signal.SIGPIPE, signal.SIG_DFL)
    if signal.getsignal(signal.SIGTERM) == signal.SIG_DFL:
        # Asked to end, it takes the part of a file that it has written with it.
        signal.signal(signal.SIGTERM, lambda number, _: sys.exit(128 + number))
    if sys.stdout is None:
        # Closed by whoever started this: what is written there goes nowhere.
        sys.stdout = open(os.devnull, "w", encoding="utf-8")  # noqa: PTH123, SIM115 - stays open
    if isinstance(sys.stdout, io.TextIOWrapper):
        # A terminal without Greek letters gets question marks, not an exception.
        sys.stdout.reconfigure(errors="replace")
    sys.exit(run(sys.argv[1:]))


def run(arguments: list[str]) -> int:
    """Run the command; return 0, or say what is wrong in one line and return the exit status."""
    try:
        # Extreme drags overflow or underflow in good order: to inf and 0, without a warning.
        with np.errstate(over="ignore", under="ignore"):
            status = archerfish.main(arguments, prog_name="archerfish", standalone_mode=False)
        sys.stdout.flush()
    except RefusedValue as error:
        return _complain(_command(error), error.format_message(), BAD_INPUT)
    except click.UsageError as error:
        where = _command(error)
        message = error.format_message()
        stop = "" if message.endswith((".", "?")) else "."
        return _complain(where, f"{message}{stop} See {where} --help.", BAD_INPUT)
    except click.ClickException as error:
        return _complain("archerfish", error.format_message(), error.exit_code)
    except (click.Abort, KeyboardInterrupt):
        return INTERRUPTED
    except OSError as error:
        return _failed_write(error)
    return status if isinstance(status, int) else 0


def _command(error: click.UsageError) -> str:
    return error.ctx.command_path if error.ctx else "archerfish"


def _failed_write(error: OSError) -> int:
    if error.errno == errno.EPIPE:  # Where there is no SIGPIPE.
        return FAILURE
    if not error.filename:
        # What could not be written is still buffered: let the flush at exit go nowhere.
        with contextlib.suppress(io.UnsupportedOperation):
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    name = error.filename or "standard output"
    return _complain("archerfish", f"cannot write {name}: {error.strerror or error}", FAILURE)


def _complain(where: str, message: str, status: int) -> int:
    click.echo(f"{where}: {' '.join(message.split())}", err=True)
    return status
