"""The `silostudy` command: sub-commands for people (list, explain, compare, check) and for the pipeline's rules."""

import argparse
import sys
from collections.abc import Sequence

from silostudy import __version__
from silostudy.commands import (
    bench,
    cite,
    compare,
    dem,
    drawing,
    explain,
    fronts,
    listing,
    stages,
    studies,
    sweeps,
)
from silostudy.errors import BadInput

ROOMS = (listing, explain, compare, cite, studies, stages, drawing, sweeps, dem, fronts, bench)


def parser() -> argparse.ArgumentParser:
    """The whole command line."""
    top = argparse.ArgumentParser(prog="silostudy", description=__doc__)
    top.add_argument("--version", action="version", version=f"silostudy {__version__}")
    sub = top.add_subparsers(required=True, metavar="command")
    for room in ROOMS:
        room.add(sub)
    return top


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs one sub-command; bad input is one line a mistake on stderr and status 2."""
    chosen = parser().parse_args(arguments)
    try:
        chosen.run(chosen)
    except BadInput as error:
        print("\n".join(f"silostudy: {line}" for line in str(error).split("\n")), file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
