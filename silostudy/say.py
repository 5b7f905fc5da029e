"""Lines for people beside the results, on standard error."""

import sys


def say(words: str) -> None:
    """Writes a line of its own, also where a bar of progress stands at work."""
    from tqdm import tqdm

    tqdm.write(f"silostudy: {words}", file=sys.stderr)
