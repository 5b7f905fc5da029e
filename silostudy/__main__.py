"""The `silostudy` command: sub-commands for people (list, explain, compare, check) and for the pipeline's rules."""

import argparse
import os
import sys
from collections.abc import Sequence
from pathlib import Path

from silostudy import __version__
from silostudy.commands import (
    bench,
    check,
    cite,
    compare,
    dem,
    doctor,
    drawing,
    explain,
    explore,
    export,
    facets,
    fronts,
    listing,
    new,
    note,
    stages,
    studies,
    sweeps,
)
from silostudy.errors import BadInput
from silostudy.files import check_output, check_writable

# arguments that name what a command writes
OUTPUT = "output"  # a file
STEMS = ("stem", "figure")  # files without their ending
STOPPED = 130  # status of a command that the user stopped
ROOMS = (
    new,
    listing,
    explain,
    compare,
    cite,
    explore,
    check,
    studies,
    stages,
    export,
    drawing,
    note,
    sweeps,
    dem,
    fronts,
    bench,
    doctor,
    facets,
)


def parser() -> argparse.ArgumentParser:
    """The whole command line."""
    top = argparse.ArgumentParser(prog="silostudy", description=__doc__)
    top.add_argument("--version", action="version", version=f"silostudy {__version__}")
    sub = top.add_subparsers(required=True, metavar="command")
    for room in ROOMS:
        room.add(sub)
    return top


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs one sub-command; bad input is one line a mistake on stderr and status 2.

    Whoever reads the output may stop early, as `head` does.
    """
    chosen = parser().parse_args(arguments)
    try:
        check_outputs(chosen)
        chosen.run(chosen)
        sys.stdout.flush()
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # the interpreter flushes once more at its end
        return 1
    except BadInput as error:
        print("\n".join(f"silostudy: {line}" for line in str(error).split("\n")), file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("silostudy: stopped", file=sys.stderr)
        return STOPPED
    return 0


def check_outputs(chosen) -> None:
    """Raises BadInput for an output that cannot be written, before anything is computed."""
    given = vars(chosen)
    if given.get(OUTPUT) is not None:
        check_output(given[OUTPUT], [path for name, path in given.items() if name != OUTPUT and isinstance(path, Path)])
    for name in STEMS:
        if given.get(name) is not None:
            check_writable(given[name].parent)


if __name__ == "__main__":
    sys.exit(main())
