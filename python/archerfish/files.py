"""Files that appear whole or not at all."""

from __future__ import annotations

import contextlib
import os
from pathlib import Path


def write_whole(path: str | os.PathLike[str], content: bytes) -> None:
    """Write `content` to `path`: into a file beside it, onto the disk, then under its name.

    A reader sees the old file or the new one. Raises OSError where the path cannot be written;
    then what was there is untouched and nothing is left behind.
    """
    target = Path(path)
    try:
        if target.exists() and not target.is_file():
            # A device or a pipe must not be replaced by a file. A folder raises here.
            target.write_bytes(content)
            return
        # A link stays a link: the file it names is replaced.
        target = target.resolve()
        part = target.with_name(f".{target.name}.{os.urandom(4).hex()}.part")
        try:
            with part.open("xb") as stream:
                stream.write(content)
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
