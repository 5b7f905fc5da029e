"""Writing files so that a half-written one never looks like a result."""

import fcntl
import hashlib
import os
import sys
import tempfile
import time
from contextlib import suppress
from pathlib import Path

from silostudy.errors import BadInput


class replacing:
    """A temporary file beside `path` that takes its name only when the block ends without an error.

    seal: also keep its checksum in a hidden file beside it, by which `remove_damaged` knows it again.
    """

    def __init__(self, path: Path, *, seal: bool = False):
        self.path, self.seal = path, seal

    def __enter__(self) -> Path:
        try:
            self.path.parent.mkdir(parents=True, exist_ok=True)
            handle, name = tempfile.mkstemp(prefix=f".{self.path.name}.", suffix=self.path.suffix, dir=self.path.parent)
        except OSError as error:
            raise BadInput("results folder", str(self.path.parent), f"cannot be written ({error.strerror})") from None
        os.close(handle)
        self.temporary = Path(name)
        return self.temporary

    def __exit__(self, kind, error, trace) -> None:
        if kind is None:
            os.chmod(self.temporary, 0o666 & ~_umask())
            if self.seal:  # before the file: one without its seal's checksum was never finished
                _seal_of(self.path).write_text(_digest(self.temporary), encoding="ascii")
            self.temporary.replace(self.path)
        else:
            self.temporary.unlink(missing_ok=True)


def _seal_of(path: Path) -> Path:
    return path.with_name(f".{path.name}.sha256")


def _digest(path: Path) -> str:
    with path.open("rb") as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest()


def damaged(path: Path) -> bool:
    """Whether a sealed file's content is not what was written."""
    return path.exists() and _seal_of(path).exists() and _digest(path) != _seal_of(path).read_text(encoding="ascii")


def remove_damaged(folder: Path) -> None:
    """Removes files of a folder whose content is not what was written, with a word: they will be made again."""
    for seal in sorted(folder.glob(".*.sha256")):
        path = seal.with_name(seal.name.removeprefix(".").removesuffix(".sha256"))
        if damaged(path):
            print(f"silostudy: {path} is damaged: removed, to be made again", file=sys.stderr)
            path.unlink()


def end_future(folder: Path) -> None:
    """Gives files that are later than now, as after a clock set back, the time of now: Snakemake refuses to work with them."""
    now = time.time()
    for path in folder.rglob("*"):
        with suppress(FileNotFoundError):  # a temporary file of a job that goes on
            if path.is_file() and path.stat().st_mtime > now:
                os.utime(path, (now, now))


def alone(folder: Path) -> None:
    """Holds a folder of results for this process until it ends, however it ends; BadInput where another process holds it."""
    folder.mkdir(parents=True, exist_ok=True)
    handle = os.open(folder / ".lock", os.O_RDWR | os.O_CREAT, 0o666)
    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        raise BadInput("results folder", str(folder), "another run is writing to it") from None


def check_writable(folder: Path) -> None:
    """BadInput unless the folder can be written or made, without making it."""
    nearest = next(place for place in (folder, *folder.absolute().parents) if place.exists())
    if not nearest.is_dir() or not os.access(nearest, os.W_OK):
        raise BadInput("results folder", str(folder), "cannot be written")


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
