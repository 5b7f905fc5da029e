"""Instructions that a stretch of work takes, counted by valgrind's callgrind: equal on a busy machine and an idle one.

The work is named as module:function; the function gives name -> callable, each is run once before it is counted.  Kernels are
compiled without valgrind beforehand, for the processor that it shows.
"""

import os
import shutil
import subprocess
import sys
import tempfile
from importlib import import_module
from pathlib import Path

VALGRIND = ("valgrind", "--tool=callgrind", "--instr-atstart=no")
SHOWN = "import llvmlite.binding as llvm; print('processor', llvm.get_host_cpu_name(), llvm.get_host_cpu_features().flatten())"


def missing() -> str:
    """Reason why instructions cannot be counted here; empty where they can."""
    tools = [tool for tool in ("valgrind", "callgrind_control") if shutil.which(tool) is None]
    return f"{' and '.join(tools)} not found (package valgrind)" if tools else ""


def count(work: str, folder: Path | None = None) -> dict[str, int]:
    """Instructions of each callable that module:function gives; a process of its own under valgrind, minutes at first."""
    with tempfile.TemporaryDirectory(prefix="silostudy-callgrind-") as place:
        valgrind, own = [*VALGRIND, f"--callgrind-out-file={place}/out"], [sys.executable, "-m", __name__, work]
        (shown,) = _told("processor", [*valgrind, sys.executable, "-c", SHOWN], folder)
        processor = dict(zip(("NUMBA_CPU_NAME", "NUMBA_CPU_FEATURES"), shown.split(), strict=True))
        _told("ready", [*own, "ready"], folder, processor)
        names = _told("counted", [*valgrind, *own], folder, processor)
        return {name: _total(Path(f"{place}/out.{number}"), number) for number, name in enumerate(names, 1)}


def _told(word: str, command: list[str], folder: Path | None, processor: dict[str, str] | None = None) -> list[str]:
    """Lines that a process prints after a word; RuntimeError where there are none."""
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, env=os.environ | (processor or {}))
    lines = [line.removeprefix(f"{word} ") for line in done.stdout.splitlines() if line.startswith(f"{word} ")]
    if done.returncode or not lines:
        raise RuntimeError(f"callgrind counted nothing: {done.stderr[-500:]}")
    return lines


def _total(path: Path, number: int) -> int:
    """The sum that callgrind writes at the end of a dump, which must be the one asked for."""
    lines = path.read_text().splitlines() if path.exists() else []
    if f"desc: Trigger: dump work{number}" not in lines:
        raise RuntimeError(f"callgrind did not write dump {number}")
    return int([line for line in lines if line.startswith(("totals:", "summary:"))][-1].split()[1])


def _control(*order: str) -> None:
    subprocess.run(["callgrind_control", *order, str(os.getpid())], check=True, capture_output=True)


def _work(name: str, counts: bool) -> None:
    module, function = name.split(":")
    for number, (label, run) in enumerate(getattr(import_module(module), function)().items(), 1):
        run()
        if counts:
            _control("-i", "on")
            _control("-z")
            run()
            _control("-d", f"work{number}")  # not the label: one with brackets is passed over in silence
            _control("-i", "off")
        print(f"{'counted' if counts else 'ready'} {label}", flush=True)


if __name__ == "__main__":
    _work(sys.argv[1], "ready" not in sys.argv[2:])
