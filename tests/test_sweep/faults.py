"""Breaks a running sweep in the ways of real machines, at random moments, and resumes it with the one documented command."""

import os
import random
import shutil
import signal
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

import yaml

from silostudy.sweep.journal import sound
from tests.conftest import ROOT
from tests.test_sweep.sweeps import content

COMMAND = ["snakemake", "--snakefile", ROOT / "Snakefile", "--workflow-profile", ROOT / "config/profiles/workstation"]
CUBE = "sweep/scenes.nc"


def project(folder: Path, **changes) -> Path:
    """A folder with a project of one small sweep."""
    (folder / "config/studies").mkdir(parents=True)
    (folder / "config/config.yaml").write_text("studies: [sweep]\n")
    ask(folder, **{"slits": [0.03 + 0.005 * k for k in range(12)], "case_s": 30.0, "part_s": 60.0} | changes)
    return folder


def ask(folder: Path, **changes) -> None:
    """Writes the study of the project."""
    (folder / "config/studies/sweep.yaml").write_text(yaml.safe_dump(content(**changes)))


def start(folder: Path, results: Path, *arguments) -> subprocess.Popen:
    """The documented command, in a process group of its own; what it says goes to said.txt."""
    path = f"{Path(sys.executable).parent}:{os.environ['PATH']}"
    command = [*map(str, COMMAND), "--cores", "2", "--config", f"results={results}", *arguments]
    with (folder / "said.txt").open("ab") as said:
        return subprocess.Popen(command, cwd=folder, env={**os.environ, "PATH": path}, stdout=said, stderr=said,
                                start_new_session=True)  # fmt: skip


def jobs(results: Path) -> list[int]:
    """Processes of silostudy that work on these results."""
    found = []
    for place in Path("/proc").glob("[0-9]*"):
        try:
            words = (place / "cmdline").read_bytes().split(b"\0")
        except OSError:
            continue
        if b"silostudy" in words and any(word.startswith(str(results).encode()) for word in words):
            found.append(int(place.name))
    return found


class Breaker:
    """The faults, drawn at random; each waits for its moment in a run that takes about `length` (s)."""

    def __init__(self, folder: Path, results: Path, seed: int, *, tmpfs: bool):
        self.folder, self.results, self.length = folder, results, 10.0
        self.chance, self.happened = random.Random(seed), Counter()
        during = (self.kill_all, self.kill_all, self.kill_snakemake, self.kill_snakemake, self.kill_job, self.kill_job)
        after = (self.flip_a_bit, self.cut_off, self.clock_back)
        self.kinds: list[Callable[[], None]] = [*during, *after, *((self.fill_disk, self.read_only) if tmpfs else ())]

    def fault(self) -> None:
        kind = self.chance.choice(self.kinds)
        kind()
        self.happened[kind.__name__] += 1

    def run(self, *arguments) -> int:
        begun = time.monotonic()
        status = start(self.folder, self.results, *arguments).wait()
        self.length = time.monotonic() - begun if status == 0 and not self.happened else self.length
        return status

    def _run_till(self) -> subprocess.Popen:
        process = start(self.folder, self.results)
        with suppress(subprocess.TimeoutExpired):
            process.wait(self.chance.uniform(0.0, 0.9) * self.length)
        return process

    def kill_all(self) -> None:
        process = self._run_till()
        _kill(process.pid, os.killpg)
        for job in jobs(self.results):
            _kill(job)
        process.wait()

    def kill_snakemake(self) -> None:
        """Its jobs go on without it while the next command starts."""
        process = self._run_till()
        _kill(process.pid)
        process.wait()

    def kill_job(self) -> None:
        process = self._run_till()
        for job in jobs(self.results)[:1]:
            _kill(job)
        process.wait()

    def _file(self) -> Path | None:
        files = [path for ending in ("*.nc", "parts/*.jsonl") for path in sorted((self.results / "sweep").glob(ending))]
        return self.chance.choice([path for path in files if path.stat().st_size]) if files else None

    def _quiet(self) -> None:
        while jobs(self.results):
            time.sleep(0.1)

    def flip_a_bit(self) -> None:
        self._quiet()
        if path := self._file():
            broken = bytearray(path.read_bytes())
            broken[self.chance.randrange(len(broken))] ^= 1 << self.chance.randrange(8)
            path.write_bytes(broken)

    def cut_off(self) -> None:
        self._quiet()
        if path := self._file():
            os.truncate(path, self.chance.randrange(path.stat().st_size))

    def clock_back(self) -> None:
        """Files carry times of the past and the future in no order."""
        self._quiet()
        own = [(path, 1e5) for path in self.results.rglob("*")]
        users = [(path, 0.0) for path in (self.folder / "config").rglob("*.yaml")]
        for path, latest in own + users:
            when = time.time() + self.chance.uniform(-1e6, latest)
            os.utime(path, (when, when))

    def fill_disk(self) -> None:
        process = self._run_till()
        ballast = self.results / "ballast"
        with ballast.open("wb", buffering=0) as stream, suppress(OSError):
            while True:
                stream.write(bytes(65536))
        process.wait()
        ballast.unlink()

    def read_only(self) -> None:
        self._quiet()
        subprocess.run(["mount", "-o", "remount,ro", str(self.results)], check=True)
        assert self.run() != 0
        subprocess.run(["mount", "-o", "remount,rw", str(self.results)], check=True)


def _kill(process: int, how=os.kill) -> None:
    with suppress(ProcessLookupError):
        how(process, signal.SIGKILL)


def computed(results: Path) -> Counter:
    """How often each case was finished, from the journals."""
    return Counter(key for path in (results / "sweep/parts").glob("*.jsonl") for key, _ in sound(path))


def mounted(folder: Path, megabytes: int) -> bool:
    """Mounts a small file system in memory; False where that is not permitted."""
    folder.mkdir(exist_ok=True)
    command = ["mount", "-t", "tmpfs", "-o", f"size={megabytes}m", "tmpfs", str(folder)]
    return shutil.which("mount") is not None and subprocess.run(command, capture_output=True).returncode == 0
