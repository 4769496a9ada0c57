"""A server of one folder's files, on this machine and to it only."""

from __future__ import annotations

import os
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path


def page_server(folder: Path, port: int) -> ThreadingHTTPServer:
    """A server of the files of one folder, at 127.0.0.1; port 0 takes any that is free."""
    return ThreadingHTTPServer(("127.0.0.1", port), partial(Page, directory=str(folder)))


class Page(SimpleHTTPRequestHandler):
    """Files and nothing else: no listing of folders, no line on the terminal for each request."""

    # What a system's own table says of these differs, and browsers insist.
    extensions_map = SimpleHTTPRequestHandler.extensions_map | {
        ".css": "text/css",
        ".html": "text/html; charset=utf-8",
        ".js": "text/javascript",
        ".wasm": "application/wasm",
        ".woff2": "font/woff2",
    }

    def list_directory(self, path: str | os.PathLike[str]) -> None:  # noqa: ARG002 - the base's signature
        self.send_error(404, "File not found")

    def end_headers(self) -> None:
        self.send_header("X-Content-Type-Options", "nosniff")
        self.send_header("Content-Security-Policy", "frame-ancestors 'none'")
        self.send_header("Cache-Control", "no-cache")
        super().end_headers()

    def log_message(self, format: str, *args: object) -> None:  # noqa: A002 - as above
        pass
