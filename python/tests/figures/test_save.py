"""Figures as files: whole, the same every time, and readable without colour."""

import errno
import struct
import subprocess
import sys
import zlib
from pathlib import Path
from xml.etree import ElementTree

import matplotlib as mpl
import pytest

from archerfish import Launcher
from archerfish.figures import FIGURES, caption, save
from archerfish.figures import __main__ as command

SVG = "{http://www.w3.org/2000/svg}"
DUBLIN_CORE = "{http://purl.org/dc/elements/1.1/}"


def png_chunks(content: bytes) -> dict[str, bytes]:
    """The chunks of a PNG file, the last of each kind; every checksum compared."""
    assert content[:8] == b"\x89PNG\r\n\x1a\n"
    chunks, place = {}, 8
    while place < len(content):
        (length,) = struct.unpack_from(">I", content, place)
        kind = content[place + 4 : place + 8]
        body = content[place + 8 : place + 8 + length]
        (checksum,) = struct.unpack_from(">I", content, place + 8 + length)
        assert zlib.crc32(kind + body) == checksum
        chunks[kind.decode()] = body
        place += 12 + length
    return chunks


@pytest.mark.parametrize("number", FIGURES)
def test_svg_is_the_same_every_time_and_says_what_it_shows(number, tmp_path):
    first = save(number, tmp_path / "first.svg").read_bytes()
    with mpl.rc_context({"font.size": 20.0, "svg.hashsalt": None, "axes.grid": True}):
        second = save(number, tmp_path / "second.svg").read_bytes()
    assert first == second
    root = ElementTree.fromstring(first)
    assert root.tag == f"{SVG}svg"
    title = next(root.iter(f"{DUBLIN_CORE}title"))
    assert title.text == f"Figure {number}"
    (description,) = root.iter(f"{DUBLIN_CORE}description")
    assert description.text == caption(number)
    assert not list(root.iter(f"{DUBLIN_CORE}date"))
    # Type is drawn as outlines, so that every reader sees the same.
    assert not list(root.iter(f"{SVG}text"))
    assert len(first) < 200_000


@pytest.mark.parametrize("number", FIGURES)
def test_png_is_sharp_enough_to_print(number, tmp_path):
    chunks = png_chunks(save(number, tmp_path / "figure.png").read_bytes())
    width, _ = struct.unpack_from(">II", chunks["IHDR"])
    per_metre, _, unit = struct.unpack(">IIB", chunks["pHYs"])
    assert unit == 1
    assert per_metre * 0.0254 == pytest.approx(300.0, abs=0.02)
    assert width == pytest.approx(300.0 * FIGURES[number].size[0], abs=1.0)


def test_pdf_has_no_date(tmp_path):
    content = save(1, tmp_path / "figure.pdf").read_bytes()
    assert content.startswith(b"%PDF-")
    assert b"CreationDate" not in content


def test_caption_can_be_left_out(tmp_path):
    with_caption = png_chunks(save(2, tmp_path / "with.png", dpi=72).read_bytes())
    without = png_chunks(save(2, tmp_path / "without.png", dpi=72, show_caption=False).read_bytes())
    height = [struct.unpack_from(">II", chunks["IHDR"])[1] for chunks in (with_caption, without)]
    assert height[1] == int(72 * FIGURES[2].size[1])
    assert height[0] > height[1] + 20


def test_options_reach_the_data(tmp_path):
    launcher = Launcher(25.0, epsilon=3.0)
    path = save(1, tmp_path / "figure.svg", launcher=launcher)
    assert "V₀ = 25 m/s" in path.read_text(encoding="utf-8")
    assert "= 3," in caption(1, launcher=launcher)


@pytest.mark.parametrize("number", [0, 7, -1])
def test_no_such_figure(number, tmp_path):
    with pytest.raises(ValueError, match=f"^figure must be from 1 to {max(FIGURES)}, got {number}"):
        save(number, tmp_path / "figure.svg")


def test_no_such_format(tmp_path):
    with pytest.raises(ValueError, match=r"must end in \.png, \.svg, \.pdf, got figure\.gif"):
        save(1, tmp_path / "figure.gif")
    assert list(tmp_path.iterdir()) == []


def test_a_failure_leaves_the_old_file_and_nothing_else(tmp_path, monkeypatch):
    target = tmp_path / "figure.svg"
    target.write_text("old")

    def fails(*_):
        raise OSError(errno.ENOSPC, "No space left")

    monkeypatch.setattr(Path, "replace", fails)
    with pytest.raises(OSError, match="No space left"):
        save(1, target)
    assert target.read_text() == "old"
    assert list(tmp_path.iterdir()) == [target]


def test_unwritable_folder(tmp_path):
    with pytest.raises(FileNotFoundError):
        save(1, tmp_path / "missing" / "figure.svg")


def test_command_draws_everything(tmp_path, capsys):
    folder = tmp_path / "new" / "folder"
    assert command.main([str(folder)]) == 0
    names = {path.name for path in folder.iterdir()}
    assert names == {f"figure{n}.{end}" for n in FIGURES for end in ("svg", "png", "txt")}
    assert (folder / "figure1.txt").read_text(encoding="utf-8") == caption(1) + "\n"
    assert capsys.readouterr().out.count("\n") == 2 * len(FIGURES)


def test_command_says_what_is_wrong(tmp_path, capsys):
    assert command.main([]) == 2
    assert capsys.readouterr().err.startswith("usage:")
    blocked = tmp_path / "file"
    blocked.write_text("")
    assert command.main([str(blocked)]) == 1
    assert capsys.readouterr().err.count("\n") == 1


def test_data_do_not_import_matplotlib():
    program = """
import sys
from archerfish.figures import FIGURES, caption
for number, figure in FIGURES.items():
    figure.caption(figure.data())
assert not [name for name in sys.modules if name.startswith("matplotlib")]
"""
    subprocess.run([sys.executable, "-c", program], check=True)
