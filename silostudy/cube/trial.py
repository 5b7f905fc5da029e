"""Tries netCDF files in a process of its own: the libraries behind netCDF crash or never end over some that are broken."""

import atexit
import os
import resource
import subprocess
import sys
from functools import cache
from pathlib import Path
from threading import Lock

# more than zlib can save, so something is lost
DENSEST = 2000  # values a byte of their file
TEXTS = 10  # texts a byte of their file
SECONDS = 2  # of CPU time to open any file, and to read it
VALUES_A_SECOND = 5_000_000  # which is slow
TOO_MANY = 3  # how a child ends over a file with more values than it can hold
_TURN = Lock()


def flaw(path: Path) -> str:
    """Flaw that keeps a file from being read without harm to the process that does it; empty where there is none."""
    with _TURN:
        helper = _helper()
        assert helper.stdin is not None
        assert helper.stdout is not None
        helper.stdin.write(os.fsencode(path.absolute()).hex() + "\n")
        helper.stdin.flush()
        ended = helper.stdout.readline().strip()
    if ended == "0":
        return ""
    return "says that it holds more than it can" if ended == str(TOO_MANY) else "reading it does not end, or ends the process"


@cache
def _helper() -> subprocess.Popen:
    """The process that tries files, one a line, for as long as this one lasts; by its path, so that it loads nothing else."""
    helper = subprocess.Popen([sys.executable, __file__], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    atexit.register(helper.communicate)
    return helper


def _serve() -> None:
    """Answers each path with the state in which a child ended that read all of it: 0, or what killed it."""
    import netCDF4

    for line in sys.stdin:
        child = os.fork()
        if child == 0:
            _read_all(bytes.fromhex(line), netCDF4.Dataset)
        print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), flush=True)


def _read_all(path: bytes, opened) -> None:
    """Reads all of a file, then ends the process; an error that Python can tell is no harm."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), 2)  # the libraries write their last words there
    try:
        _allow(SECONDS)
        with opened(os.fsdecode(path)) as file:
            held, size = file.variables.values(), os.stat(path).st_size
            if any(array.size > (TEXTS if array.dtype is str else DENSEST) * size for array in held):
                os._exit(TOO_MANY)
            _allow(2 * SECONDS + sum(array.size for array in held) // VALUES_A_SECOND)
            file.__dict__  # noqa: B018  reads the attributes
            for array in held:
                array.__dict__, array[...]
    finally:
        os._exit(0)


def _allow(seconds: int) -> None:
    """The CPU time after which the process is ended."""
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, resource.RLIM_INFINITY))


if __name__ == "__main__":
    _serve()
