"""Writing files so that a half-written one never looks like a result."""

import os
import tempfile
from pathlib import Path

from silostudy.errors import BadInput


class replacing:
    """A temporary file beside `path` that takes its name only when the block ends without an error."""

    def __init__(self, path: Path):
        self.path = path

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
            self.temporary.replace(self.path)
        else:
            self.temporary.unlink(missing_ok=True)


def check_writable(folder: Path) -> None:
    """BadInput unless the folder can be written or made, without making it."""
    nearest = next(place for place in (folder, *folder.absolute().parents) if place.exists())
    if not nearest.is_dir() or not os.access(nearest, os.W_OK):
        raise BadInput("results folder", str(folder), "cannot be written")


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
