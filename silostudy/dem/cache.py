"""Where compiled kernels are kept: a folder named by the sources, because numba does not notice a changed import."""

import hashlib
import os
import tempfile
import warnings
from pathlib import Path

from numba import config

from silostudy.stamp import stamp


def named(function, key: str):
    """The function under a name of its own for this key, so that its compiled form has files of its own.

    Numba numbers the files of one name as they come: two processes that compile different kernels of one name at the
    same time take the same number, and each then finds the other's code.
    """
    function.__qualname__ = f"{function.__name__}_{hashlib.sha256(key.encode()).hexdigest()[:12]}"
    return function


def root() -> Path:
    """Folder of all compiled kernels: NUMBA_CACHE_DIR, or the user's cache folder."""
    given = os.environ.get("NUMBA_CACHE_DIR")
    return Path(given) if given else Path(os.environ.get("XDG_CACHE_HOME", Path.home() / ".cache")) / "silostudy"


def prepare() -> None:
    """Point numba at the folder of these sources; where that cannot be written, at a temporary one, with a word."""
    folder = root() / stamp("contact", "dem", "packing")
    try:
        folder.mkdir(parents=True, exist_ok=True)
        tempfile.TemporaryFile(dir=folder).close()
    except OSError as reason:
        folder = Path(tempfile.mkdtemp(prefix="silostudy-kernels-"))
        warnings.warn(f"compiled kernels are not kept: {reason}; using {folder}", RuntimeWarning, stacklevel=2)
    setattr(config, "CACHE_DIR", str(folder))  # noqa: B010 (numba makes its settings at run time)
