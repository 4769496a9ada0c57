"""`archerfish explore`: a folder of files on loopback, or one file."""

import http.client
import signal
import socket
import subprocess
import sys
import threading

import pytest
from click.testing import CliRunner

from archerfish.cli import explore as module


@pytest.fixture
def page(tmp_path, monkeypatch):
    folder = tmp_path / "explorer"
    folder.mkdir()
    (tmp_path / "secret.txt").write_text("secret")
    (folder / "index.html").write_text("<!doctype html><title>page</title>")
    (folder / "kernels.wasm").write_bytes(b"\0asm")
    (folder / "archerfish-explorer.html").write_text("one file")
    (folder / "assets").mkdir()
    monkeypatch.setattr(module, "PAGE", folder)
    return folder


@pytest.fixture
def ask(page):
    server = module.page_server(page, 0)
    thread = threading.Thread(target=server.serve_forever)
    thread.start()

    def ask(path):
        connection = http.client.HTTPConnection("127.0.0.1", server.server_address[1], timeout=10)
        connection.request("GET", path)
        answer = connection.getresponse()
        body = answer.read()
        connection.close()
        return answer, body

    yield ask
    server.shutdown()
    server.server_close()
    thread.join()


@pytest.mark.parametrize(
    ("path", "content_type"),
    [("/", "text/html; charset=utf-8"), ("/kernels.wasm", "application/wasm")],
)
def test_files_are_served_with_types_that_browsers_take(ask, path, content_type):
    answer, body = ask(path)
    assert (answer.status, answer.headers["Content-Type"]) == (200, content_type)
    assert answer.headers["X-Content-Type-Options"] == "nosniff"
    assert body


@pytest.mark.parametrize("path", ["/../secret.txt", "/%2e%2e/secret.txt", "/assets/", "/nothing"])
def test_nothing_else_is_served(ask, path):
    answer, body = ask(path)
    assert answer.status == 404
    assert b"secret" not in body.replace(path.encode(), b"")


def test_only_this_machine_is_served(page):
    with module.page_server(page, 0) as server:
        assert server.server_address[0] == "127.0.0.1"


@pytest.mark.usefixtures("page")
def test_the_page_as_one_file(tmp_path):
    target = tmp_path / "sent.html"
    done = CliRunner().invoke(module.explore, ["--output", str(target)])
    assert (done.exit_code, done.output) == (0, f"wrote {target}\n")
    assert target.read_text() == "one file"


def test_a_page_that_is_not_built_says_how_to_build_it(tmp_path, monkeypatch):
    monkeypatch.setattr(module, "PAGE", tmp_path)
    done = CliRunner().invoke(module.explore, [])
    assert done.exit_code == 1
    assert "not built here: run `make explore`" in done.output
    assert done.output.count("\n") == 1


@pytest.mark.usefixtures("page")
def test_a_port_in_use_is_one_line():
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
        done = CliRunner().invoke(module.explore, ["--port", str(port), "--no-browser"])
    assert done.exit_code == 1
    assert done.output.startswith(f"Error: cannot serve at port {port}: ")
    assert done.output.count("\n") == 1


def test_interrupting_ends_it_quietly(page):
    # A shell in the background starts its children deaf to interrupts, this test's runner maybe.
    program = (
        "import signal; signal.signal(signal.SIGINT, signal.default_int_handler); "
        "from pathlib import Path; from archerfish.cli import explore as module; "
        f"module.PAGE = Path({str(page)!r}); module.explore(['--no-browser'])"
    )
    with subprocess.Popen(
        [sys.executable, "-c", program], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as process:
        try:
            line = process.stdout.readline()
            assert line.startswith("The explorer is at http://127.0.0.1:")
            process.send_signal(signal.SIGINT)
            _, errors = process.communicate(timeout=20)
        finally:
            process.kill()
    assert (process.returncode, errors) == (0, "")
