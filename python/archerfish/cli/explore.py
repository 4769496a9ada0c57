"""`archerfish explore`: serve the page that moves the locus, on and to this machine only."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from archerfish.cli.options import OUTPUT_PATH
from archerfish.files import write_whole

if TYPE_CHECKING:
    from http.server import ThreadingHTTPServer

#: Where the build of web/ leaves the page; a wheel brings it along.
PAGE = Path(__file__).parent.parent / "explorer"
SINGLE_FILE = "archerfish-explorer.html"


@click.command(
    epilog="""\b
Examples:
  archerfish explore
      serve the page on this machine, print its address, open a browser
  archerfish explore --port 8000 --no-browser
  archerfish explore --output explorer.html
      the page as one file, to be opened by a double click or sent by mail
""",
)
@click.option(
    "--port", type=click.IntRange(0, 65535), default=0, help="Port to serve at.  [default: any]"
)
@click.option("--browser/--no-browser", default=True, show_default=True, help="Open a browser.")
@click.option("--output", type=OUTPUT_PATH, help="Write the page there as one file; serve nothing.")
def explore(port: int, browser: bool, output: Path | None) -> None:
    """The locus in a web page: drag the apex, change the drag, play the flight.

    Served from this machine to this machine; the page asks for nothing from anywhere else.
    """
    if not (PAGE / "index.html").is_file():
        raise click.ClickException(
            "the explorer's page is not built here: run `make explore` in the source tree "
            "(needs Node.js 20.19 or newer)"
        )
    if output is not None:
        write_whole(output, (PAGE / SINGLE_FILE).read_bytes())
        click.echo(f"wrote {output}")
        return
    try:
        server = page_server(PAGE, port)
    except OSError as error:
        raise click.ClickException(f"cannot serve at port {port}: {error.strerror}") from error
    try:
        with server:
            address = f"http://127.0.0.1:{server.server_address[1]}/"
            click.echo(f"The explorer is at {address} (Ctrl-C ends it)")
            sys.stdout.flush()
            if browser and _has_screen():
                import webbrowser

                webbrowser.open(address)
            server.serve_forever()
    except KeyboardInterrupt:
        click.echo()


def page_server(folder: Path, port: int) -> ThreadingHTTPServer:
    """A server of the files of one folder, at 127.0.0.1; port 0 takes any that is free."""
    # Python's server takes as long to import as NumPy, and every command would wait for it.
    from archerfish.cli.page_server import page_server

    return page_server(folder, port)


def _has_screen() -> bool:
    """Whether there is a desktop to open a browser on."""
    if sys.platform in ("darwin", "win32"):
        return True
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))
