"""Last words of a failed pipeline: which jobs failed, the last line of each one's log, and the command to go on."""

import os
import re
import shlex
from collections.abc import Iterator, Sequence
from pathlib import Path

BLOCK = re.compile(r"^Error in rule (\S+?)[,:].*\n((?: .*\n)*)", re.MULTILINE)  # in Snakemake's log
FIELD = re.compile(r"^    (output|log): (.*?)(?: \(check log file.*)?$", re.MULTILINE)


def ending(said: str, command: Sequence[str]) -> list[str]:
    """The lines for what Snakemake's log says of failed jobs; command: the words that started it."""
    jobs = dict.fromkeys((rule, *_files(block)) for rule, block in BLOCK.findall(said))  # one that was tried again counts once
    lines = [f"silostudy: {len(jobs)} job{'s' * (len(jobs) != 1)} failed"]
    for rule, output, log in jobs:
        lines += [f"  {rule} ({output})" if output else f"  {rule}", *_why(Path(log) if log else None)]
    return [*lines, f"  once that is mended, go on with: {again(command)}"]


def _files(block: str) -> tuple[str, str]:
    """First output and log of a failed job, as Snakemake names them; empty where it names none."""
    fields = dict(FIELD.findall(block))
    return fields.get("output", "").split(", ")[0], fields.get("log", "")


def _why(log: Path | None) -> Iterator[str]:
    if log is None or not log.is_file():
        yield "    said above"
        return
    lines = [line for line in log.read_text(encoding="utf-8", errors="replace").splitlines() if line.strip()]
    yield f"    {lines[-1] if lines else 'it was stopped without a word: out of memory, or killed?'}"
    yield f"    all of it: {log}"


def again(command: Sequence[str]) -> str:
    """The command that goes on, as it was given."""
    program, *arguments = command
    name = Path(program).name
    return ("uv run " if "UV" in os.environ else "") + shlex.join(["snakemake" if name == "__main__.py" else name, *arguments])
