"""Files appear whole or not at all."""

import stat
from pathlib import Path

import pytest

from archerfish import files
from archerfish.files import write_whole


def test_new_file_and_replaced_file(tmp_path):
    path = tmp_path / "a.csv"
    write_whole(path, b"one")
    write_whole(str(path), b"two")
    assert path.read_bytes() == b"two"
    assert [entry.name for entry in tmp_path.iterdir()] == ["a.csv"]


def test_a_failure_leaves_the_old_file_and_nothing_else(tmp_path, monkeypatch):
    path = tmp_path / "a.csv"
    path.write_bytes(b"old")

    def full(_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(files.os, "fsync", full)
    with pytest.raises(OSError, match="No space left on device") as failure:
        write_whole(path, b"new")
    assert failure.value.filename == str(path)
    assert path.read_bytes() == b"old"
    assert [entry.name for entry in tmp_path.iterdir()] == ["a.csv"]


@pytest.mark.parametrize(
    ("name", "error"),
    [
        ("missing/a.csv", FileNotFoundError),
        ("file/a.csv", NotADirectoryError),
        ("", IsADirectoryError),
    ],
)
def test_errors_name_the_path_asked_for(tmp_path, name, error):
    (tmp_path / "file").write_bytes(b"")
    with pytest.raises(error) as failure:
        write_whole(tmp_path / name, b"new")
    assert failure.value.filename == str(tmp_path / name)
    assert [entry.name for entry in tmp_path.iterdir()] == ["file"]


def test_links_and_modes_stay(tmp_path):
    real, link = tmp_path / "real", tmp_path / "link"
    real.write_bytes(b"old")
    real.chmod(0o640)
    link.symlink_to(real)
    write_whole(link, b"new")
    assert link.is_symlink()
    assert real.read_bytes() == b"new"
    assert stat.S_IMODE(real.stat().st_mode) == 0o640


def test_a_read_only_file_is_not_replaced(tmp_path):
    path = tmp_path / "a.csv"
    path.write_bytes(b"old")
    path.chmod(0o444)
    with pytest.raises(PermissionError, match="the file is read-only") as failure:
        write_whole(path, b"new")
    assert failure.value.filename == str(path)
    assert path.read_bytes() == b"old"
    assert [entry.name for entry in tmp_path.iterdir()] == ["a.csv"]


def test_a_new_file_has_the_mode_any_program_gives(tmp_path):
    write_whole(tmp_path / "ours", b"")
    (tmp_path / "theirs").write_bytes(b"")
    assert (tmp_path / "ours").stat().st_mode == (tmp_path / "theirs").stat().st_mode


def test_a_device_is_written_to_and_not_replaced():
    write_whole("/dev/null", b"gone")
    assert stat.S_ISCHR(Path("/dev/null").stat().st_mode)
