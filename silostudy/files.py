"""Writes files so that a half-written one never looks like a result."""

import fcntl
import glob
import hashlib
import os
import platform
import shutil
import tempfile
import threading
import time
from collections.abc import Callable, Iterable
from contextlib import suppress
from itertools import chain, count
from pathlib import Path

from silostudy.errors import BadInput

LONGEST_NAME = 200  # bytes: the temporary file beside it has a longer one, and file systems take 255


class replacing:
    """A temporary file beside `path` that takes its name only when the block ends without an error.

    held: function of the file that gives a digest of what it holds; with it the file is sealed.
    """

    def __init__(self, path: Path, *, held: Callable[[Path], str] | None = None):
        self.path, self.held = path, held

    def __enter__(self) -> Path:
        try:
            self.path.parent.mkdir(parents=True, exist_ok=True)
            _sweep_up(self.path)
            prefix = f"{_mark(self.path)}{os.getpid()}."
            handle, name = tempfile.mkstemp(prefix=prefix, suffix=self.path.suffix, dir=self.path.parent)
        except OSError as error:
            raise BadInput("results folder", str(self.path.parent), f"cannot be written ({error.strerror})") from None
        os.close(handle)
        self.temporary = Path(name)
        return self.temporary

    def __exit__(self, kind, error, trace) -> None:
        try:
            if kind is None:
                self._finish()
                return
        except Exception as failed:
            error = failed
        self.temporary.unlink(missing_ok=True)
        of_netcdf = str(error).startswith("NetCDF: ")  # as where the disk is full
        if isinstance(error, OSError) or of_netcdf:
            why = f"{error}: is the disk full?" if of_netcdf else getattr(error, "strerror", None) or error
            raise BadInput("output", str(self.path), f"cannot be written ({why})") from None
        if kind is None:
            raise error

    def _finish(self) -> None:
        os.chmod(self.temporary, 0o666 & ~_umask())
        if self.held:  # before the file: one without its seal's checksum was never finished
            _write_seal(self.path, _digest(self.temporary), self.held(self.temporary))
        self.temporary.replace(self.path)


def _mark(path: Path) -> str:
    """Beginning of the names of this machine's temporary files beside a path, before the number of their process."""
    return f".{path.name}.{hashlib.sha256(platform.node().encode()).hexdigest()[:8]}-"


def _sweep_up(path: Path) -> None:
    """Removes temporary files beside a path whose process was killed."""
    mark = _mark(path)
    for left in path.parent.glob(f"{glob.escape(mark)}*"):
        process = left.name.removeprefix(mark).split(".")[0]
        if process.isdecimal() and not Path(f"/proc/{process}").exists() and Path("/proc/self").exists():
            left.unlink(missing_ok=True)


def seal(path: Path) -> None:
    """Keeps the checksum of a finished file in a hidden file beside it, by which it is known again."""
    _write_seal(path, _digest(path))


def _write_seal(path: Path, *digests: str) -> None:
    """Writes a seal in one go: a half-written seal would call an older result damaged."""
    temporary = path.with_name(f"{_mark(path)}{os.getpid()}.{threading.get_ident()}.seal")
    try:
        temporary.write_text("\n".join(digests), encoding="ascii")
        temporary.replace(_seal_of(path))
    finally:
        temporary.unlink(missing_ok=True)


def _seal_of(path: Path) -> Path:
    return path.with_name(f".{path.name}.sha256")


def _digest(path: Path) -> str:
    with path.open("rb") as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest()


def as_written(path: Path) -> bool:
    """Whether a file's bytes are those that were sealed; also where there is no file or no seal."""
    return not path.exists() or not _seal_of(path).exists() or _digest(path) == _sealed(path)[0]


def known_again(path: Path) -> bool:
    """Whether a file is sealed and its bytes are those that were sealed."""
    return _seal_of(path).exists() and as_written(path)


def held_when_written(path: Path) -> str:
    """The digest of what a sealed file held when it was written; empty where none was kept."""
    return "".join(_sealed(path)[1:])


def _sealed(path: Path) -> list[str]:
    return _seal_of(path).read_text(encoding="ascii", errors="replace").split("\n")


def set_aside(path: Path) -> Path:
    """Moves a file to NAME.damaged, or NAME.damaged-2, -3, ... where that is taken; where it is now."""
    endings = chain([""], (f"-{number}" for number in count(2)))
    free = next(place for ending in endings if not (place := path.with_name(f"{path.name}.damaged{ending}")).exists())
    path.rename(free)
    return free


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
    """Raises BadInput unless the folder can be written or made and its disk has room, without making it."""
    try:
        nearest = next(place for place in (folder, *folder.absolute().parents) if place.exists())
        why = "" if nearest.is_dir() and os.access(nearest, os.W_OK) else "cannot be written"
        why = why or ("" if shutil.disk_usage(nearest).free else "its disk is full")
    except OSError as error:  # in a folder that may not be looked into, or of too long a name
        why = f"cannot be written ({error.strerror})"
    if why:
        raise BadInput("results folder", str(folder), why)


def check_folder(folder: Path) -> None:
    """Raises BadInput unless files can be written into a folder, without making it."""
    if folder.exists() and not folder.is_dir():
        raise BadInput("results folder", str(folder), "is a file")
    check_writable(folder)


def check_output(path: Path, read: Iterable[Path] = ()) -> None:
    """Raises BadInput unless a file can be written there, without writing it, and it is none of the files that are read."""
    check_writable(path.parent)
    if len(os.fsencode(path.name)) > LONGEST_NAME:
        raise BadInput("output", str(path), f"has too long a name: {LONGEST_NAME} bytes at most")
    if path.is_dir():
        raise BadInput("output", str(path), "is a folder: name a file in it")
    if path.exists() and not path.is_file():  # a finished file takes the name of what was there
        raise BadInput("output", str(path), "is a device or a pipe: name a file")
    if any(path.exists() and other.exists() and path.samefile(other) for other in read):
        raise BadInput("output", str(path), "is read by this very command: name another file")


def check_there(files: Iterable[Path]) -> None:
    """Raises BadInput for a file that is not there."""
    for path in files:
        if not path.is_file():
            raise BadInput("file", str(path), "is not there")


def check_sent(names: Iterable[str], paths: Iterable[Path]) -> None:
    """Raises BadInput for names that Snakemake spoils on the way to a job: it sends `rule:study=NAME,...` between quotes."""
    for name, spoilt in [*((name, ",'\"") for name in names), *((str(path), "'\"") for path in paths)]:
        if set(name) & set(spoilt) or repr(name)[1:-1] != name:
            raise BadInput("name", name, "jobs elsewhere can be sent no quote, comma or backslash: rename it, or run here")


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
