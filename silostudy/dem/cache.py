"""Folder of compiled kernels, named by the sources, because numba does not notice a changed import."""

import hashlib
import os
import tempfile
import warnings
from pathlib import Path
from typing import Any

from numba import config
from numba.extending import register_jitable

from silostudy.stamp import stamp

# No fastmath: bits must not depend on the place in an array. No counting of references to arrays (_nrt): it took two
# thirds of a step; all compiled functions go without it, since one that counts must not meet one that does not.
OPTIONS: dict[str, Any] = {"nogil": True, "cache": True, "error_model": "numpy", "_nrt": False}


def named(function, key: str):
    """The function under a name of its own for this key, so that its compiled form has files of its own.

    Numba numbers the files of one name as they come: two processes that compile different kernels of one name at the
    same time take the same number, and each then finds the other's code.
    """
    function.__qualname__ = f"{function.__name__}_{hashlib.sha256(key.encode()).hexdigest()[:12]}"
    return function


def is_compiled(function) -> bool:
    """Whether a compiled form of a function that is named by its key is kept from before."""
    folder = Path(getattr(config, "CACHE_DIR"))  # noqa: B009 (numba makes its settings at run time)
    return any(folder.rglob(f"*.{function.py_func.__qualname__}-*.nbi"))


def piece(*key):
    """Register an inner function of a kernel under a name of its own for this key.

    Numba links compiled functions by name, types and a number that starts anew in every process.  Two processes that
    compile two kernels would give inner functions of one name the same number, and a third process that loads both
    kernels would run the forces of the first in the second, or write histories into arrays that have no room for them.

    They are inlined by force: the arrays of a scene are some 400 words, which a call copies on the stack.  That took a
    fifth of a step of few discs, and half of it where the copy lay 4 KiB from its source: each load then waits for the
    store before it, whose address has the same low twelve bits.
    """

    def registered(function):
        return register_jitable(forceinline=True)(named(function, repr(key)))

    return registered


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
