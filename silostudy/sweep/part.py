"""Computes the cases of one part of a sweep into its journal; a case that fails is recorded and the others go on."""

import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from silostudy.choice.expand import expand_file
from silostudy.errors import BadInput
from silostudy.scene.costs import told_time
from silostudy.scene.expand import Case
from silostudy.sweep.journal import ENDING, Journal, sound
from silostudy.sweep.plan import DONE, case_keys, parts_of, rows_of, sizes

EVERY = 10.0  # s between words on the progress


def compute_part(path: Path, part: str, folder: Path, tell: Callable[[str], None]) -> int:
    """Computes those cases of a part that have no record yet; how many they were.  BadInput where the study has changed."""
    rows = rows_of(part, folder)
    with Journal(folder / f"{part}{ENDING}") as journal:
        done = journal.keys()
        todo = [(position, key) for position, key in rows if key not in done]
        if not todo:
            return 0
        expansion = expand_file(path, [position for position, _ in todo])
        if case_keys(expansion) != [key for _, key in todo]:
            raise BadInput("study", str(path), "it or the code changed while the pipeline ran: run the same command again")
        progress = Progress(path.stem, folder, tell)
        for (_, key), case in zip(todo, expansion.cases, strict=True):
            journal.add(key, record_of(expansion.study, case))
            progress.step()
    return len(todo)


def record_of(study: Any, case: Case) -> dict[str, Any]:
    """The record of a case: its numbers, or its error.  A full disk or lost memory is no error of the case: it ends the job."""
    start = time.process_time()
    try:
        numbers = parts_of(study).call("measure", study, case.scene)
    except (OSError, MemoryError):
        raise
    except Exception as error:
        text = f"{type(error).__name__}: {error}"
        print(f"case {case.id} failed: {text}", file=sys.stderr)
        return {"error": text, "case": case.id}
    seconds = time.process_time() - start
    return {"case": case.id, "seconds": round(seconds, 3), "numbers": {k: np.asarray(v).tolist() for k, v in numbers.items()}}


class Progress:
    """Says now and then how far the whole study is: cases done by all its jobs, rate of this one, time that remains."""

    def __init__(self, name: str, folder: Path, tell: Callable[[str], None]):
        self.name, self.folder, self.tell = name, folder, tell
        self.start = self.said = 0.0  # s: the first case, which may wait for a kernel to be compiled, does not count
        self.sizes = sizes(folder)

    def step(self) -> None:
        """Called after each case."""
        now = time.monotonic()
        if not self.start:
            self.start, self.said, self.first = now, now, self._done()
        if now - self.said < EVERY:
            return
        self.said, done, whole = now, self._done(), self.sizes.total()
        rate = (done - self.first) / max(now - self.start, 1e-9)
        left = f"{told_time((whole - done) / rate)} left" if rate else "no rate yet"
        self.tell(f"{self.name}: {done} of {whole} cases, {rate:.2g} cases/s, {left}")

    def _done(self) -> int:
        """Cases with a record: all of a part that is marked done, those in the journals of the others."""
        return sum(
            size if (self.folder / f"{part}{DONE}").exists() else sum(1 for _ in sound(self.folder / f"{part}{ENDING}"))
            for part, size in self.sizes.items()
        )
