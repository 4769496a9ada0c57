"""Files that appear whole or not at all."""

from __future__ import annotations

import contextlib
import errno
import os
import re
import stat
from collections.abc import Iterator
from pathlib import Path
from typing import BinaryIO

#: Somebody may write: where nobody may, not even the superuser's command replaces a file.
_WRITABLE = stat.S_IWUSR | stat.S_IWGRP | stat.S_IWOTH


_STANDARD = {"/dev/stdout": 1, "/dev/stderr": 2}
_DESCRIPTORS = re.compile(r"/(?:dev|proc/self)/fd/(\d+)")


def write_whole(path: str | os.PathLike[str], content: bytes) -> None:
    """Write `content` to `path`; see `whole_file`."""
    with whole_file(path) as stream:
        stream.write(content)


@contextlib.contextmanager
def whole_file(path: str | os.PathLike[str]) -> Iterator[BinaryIO]:
    """A stream into a file beside `path`, which then goes onto the disk and under its name.

    A reader sees the old file or the new one. Raises OSError where the path cannot be written, a
    read-only file among them, though its folder would let it be replaced; then, or when the block
    raises, what was there is untouched and nothing is left behind.
    """
    target = Path(path)
    try:
        if (descriptor := _descriptor(target)) is not None:
            with open(os.dup(descriptor), "wb") as stream:  # noqa: PTH123 - a number, not a path
                yield stream
            return
        if target.exists() and not target.is_file():
            # A device or a pipe must not be replaced by a file. A folder raises here.
            with target.open("wb") as stream:
                yield stream
            return
        # A link stays a link: the file it names is replaced.
        target = target.resolve()
        if target.exists() and not (
            target.stat().st_mode & _WRITABLE and os.access(target, os.W_OK)
        ):
            raise PermissionError(errno.EACCES, "the file is read-only")
        part = target.with_name(f".{target.name}.{os.urandom(4).hex()}.part")
        try:
            with part.open("xb") as stream:
                yield stream
                stream.flush()
                os.fsync(stream.fileno())
            if target.exists():
                part.chmod(target.stat().st_mode & 0o7777)
            part.replace(target)
        except BaseException:
            with contextlib.suppress(OSError):
                part.unlink(missing_ok=True)
            raise
    except OSError as error:
        # The caller knows `path`, not the file beside it.
        raise type(error)(error.errno, error.strerror, os.fspath(path)) from error


def _descriptor(path: Path) -> int | None:
    """The open file that a path like /dev/stdout stands for.

    Opened by its name it would be a second one, at its start again; resolved, the file somebody
    redirected it to, and be replaced under the feet of whoever has it open.
    """
    name = os.fspath(path)
    found = _DESCRIPTORS.fullmatch(name)
    return int(found[1]) if found else _STANDARD.get(name)
