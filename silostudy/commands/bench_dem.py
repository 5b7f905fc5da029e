"""Command `silostudy bench dem`: the engine and LAMMPS in turn, on the same scene, law and number of steps."""

import os
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from silostudy.accuracy.silo import LEVELS, OPEN, silo_of_rows
from silostudy.tables.kiyama_1983 import ACTIVE

REPEATS = 7  # turns of each code; the best counts, since whatever else runs on the machine only adds
# discs across, rows, steps that settle, steps a turn
SIZES = {"350": (ACTIVE, LEVELS, 40000, 5000), "10 thousand": (100, 101, 20000, 600), "100 thousand": (316, 317, 3000, 60)}
LARGE = (1000, 1001, 100, 10)  # as SIZES: a million discs
BATCH = 60  # discharges of 350 discs: a twentieth of a thousand or so
BATCH_STEPS = 20000  # over 0.5 s
BATCH_OF_PEER = 3  # discharges by LAMMPS, one after another


def run(chosen) -> None:
    with_peer = has_peer()
    rows = [row for name in SIZES for row in compare(name, with_peer)]
    rows += threads() + large(rows) + batch(with_peer) + memory() + start_up()
    show(rows, chosen.output)


def has_peer() -> bool:
    """Whether LAMMPS can be timed here; says why where it cannot."""
    from silostudy.accuracy.peers import available

    missing = available()
    if missing:
        print(f"{missing}: its rows are left out")
    return not missing


def show(rows: list[dict], output: Path) -> None:
    """Print the table of a bench and write it."""
    import pandas as pd

    from silostudy.figures.style import save_table

    table = pd.DataFrame(rows)
    print(table.to_string(index=False, float_format=digits))
    save_table(table, output)


def digits(value: float) -> str:
    """A number in four digits, a count of up to a million in all of its own."""
    return f"{value:.0f}" if 1e4 <= abs(value) < 1e6 else f"{value:.4g}"


class OwnDiscs:
    """The engine under the bench's own names."""

    def __init__(self, model, threads=1):
        from silostudy.dem.engine import Engine
        from silostudy.dem.events import Event
        from silostudy.dem.run import Run

        self.engine = Engine(model, threads=threads)
        self.task = Run(self.engine, (Event("time", 1e9, "stop"),), limit=1e9)

    def step(self, steps):
        self.task.go(until=self.engine.step + steps)

    def open_slit(self):
        from silostudy.dem.change import swap_walls

        swap_walls(self.engine, *OPEN)

    @property
    def grains(self):
        return self.engine.n


def compare(name: str, with_peer: bool) -> list[dict]:
    """Both codes, settled and discharging, in turn."""
    across, levels, settle, steps = SIZES[name]
    model, slit = silo_of_rows(across, levels)
    ours = OwnDiscs(model)
    ours.step(settle)
    codes: dict[str, Any] = {"silostudy": ours}
    if with_peer:
        from silostudy.accuracy.peers import Lammps

        codes["LAMMPS"] = Lammps(model, ours.engine.places, slit)
        codes["LAMMPS"].step(steps)
    rows = []
    for phase in ("settled", "discharging"):
        if phase == "discharging":
            for code in codes.values():
                code.open_slit()
                code.step(2 * steps)
        rows += in_turn(codes, phase, steps)
    if with_peer:
        codes["LAMMPS"].close()
    return rows


def by_the_clock(code, steps: int) -> float:
    """Time (s) on the wall that a code's steps take."""
    start = time.perf_counter()
    code.step(steps)
    return time.perf_counter() - start


def in_turn(codes: dict, phase: str, steps: int, timed: Callable = by_the_clock) -> list[dict]:
    """The best turn of each code: particle-steps a second, counting the grains that were there on average."""
    best: dict[str, dict] = {}
    for _ in range(REPEATS):
        for code, runner in codes.items():
            before, seconds = runner.grains, timed(runner, steps)
            grains = (before + runner.grains) / 2.0
            measured = row(code, round(grains), phase, steps, seconds, grains * steps / seconds)
            if code not in best or measured["particle_steps_per_s"] > best[code]["particle_steps_per_s"]:
                best[code] = measured
    rows = list(best.values())
    for line in rows:
        line["ratio"] = line["particle_steps_per_s"] / rows[-1]["particle_steps_per_s"]
    return rows


def row(code, grains, phase, steps, seconds, rate, ratio=float("nan")) -> dict:
    names = ("code", "grains", "phase", "steps", "seconds", "particle_steps_per_s", "ratio")
    return dict(zip(names, (code, grains, phase, steps, seconds, rate, ratio), strict=True))


def threads() -> list[dict]:
    """One large scene on one thread and on two, in turn; the ratio is to one thread."""
    across, levels, _, steps = SIZES["100 thousand"]
    model, _ = silo_of_rows(across, levels)
    codes = {"silostudy, 2 threads": OwnDiscs(model, threads=2), "silostudy, 1 thread": OwnDiscs(model)}
    for code in codes.values():
        code.step(500)
    return in_turn(codes, "settling", steps)


def large(rows: list[dict]) -> list[dict]:
    """A million discs; the ratio is their cost a particle-step over that of ten thousand, measured in turn."""
    small, great = (OwnDiscs(silo_of_rows(*size[:2])[0]) for size in (SIZES["10 thousand"], LARGE))
    small.step(2000)
    great.step(LARGE[2])
    times: list[list[float]] = [[], []]
    for _ in range(REPEATS):
        for k, (runner, steps) in enumerate(((small, SIZES["10 thousand"][3]), (great, LARGE[3]))):
            start = time.perf_counter()
            runner.step(steps)
            times[k].append((time.perf_counter() - start) / (steps * runner.grains))
    cost = [min(some) for some in times]
    seconds = cost[1] * LARGE[3] * great.grains
    return [
        row(
            "silostudy, cost over that of 10 thousand",
            great.grains,
            "settling",
            LARGE[3],
            seconds,
            1 / cost[1],
            cost[1] / cost[0],
        )
    ]


def batch(with_peer: bool) -> list[dict]:
    """Many discharges of 350 discs at once on all cores; LAMMPS one after another; the ratio is of discharges a second."""
    from concurrent.futures import ThreadPoolExecutor

    from silostudy.dem.checkpoint import checkpoint, restore

    model, slit = silo_of_rows(ACTIVE, LEVELS)
    ours = OwnDiscs(model)
    ours.step(SIZES["350"][2])
    settled = checkpoint(ours.engine)

    def discharge(_):
        silo = OwnDiscs(model)
        restore(silo.engine, settled)
        silo.open_slit()
        silo.step(BATCH_STEPS)
        return silo.grains

    start = time.perf_counter()
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        left = list(pool.map(discharge, range(BATCH)))
    seconds = (time.perf_counter() - start) / BATCH
    rows = [
        row(
            f"silostudy, {os.cpu_count()} cores",
            len(model.x),
            "discharge",
            BATCH_STEPS,
            1000 * seconds,
            left[0] * BATCH_STEPS / seconds,
        )
    ]
    if with_peer:
        from silostudy.accuracy.peers import Lammps

        start = time.perf_counter()
        for _ in range(BATCH_OF_PEER):
            peer = Lammps(model, ours.engine.places, slit)
            peer.open_slit()
            peer.step(BATCH_STEPS)
            discs = peer.grains
            peer.close()
        other = (time.perf_counter() - start) / BATCH_OF_PEER
        rows.append(
            row(
                "LAMMPS, one after another",
                len(model.x),
                "discharge",
                BATCH_STEPS,
                1000 * other,
                discs * BATCH_STEPS / other,
                1.0,
            )
        )
        rows[0]["ratio"] = other / seconds
    return rows


def memory() -> list[dict]:
    """Bytes a disc of all arrays of the engine, at a hundred thousand discs."""
    model, _ = silo_of_rows(*SIZES["100 thousand"][:2])
    ours = OwnDiscs(model)
    ours.step(10)
    return [
        row("silostudy, bytes a disc", ours.grains, "memory", 0, float("nan"), float("nan"), ours.engine.nbytes / ours.grains)
    ]


def start_up() -> list[dict]:
    """Seconds of a whole process that runs a short scene with kernels compiled before."""
    code = "from silostudy.commands.bench_dem import OwnDiscs, silo_of_rows; OwnDiscs(silo_of_rows(5, 5)[0]).step(10)"
    seconds = []
    for _ in range(REPEATS + 1):
        start = time.perf_counter()
        subprocess.run([sys.executable, "-c", code], check=True)
        seconds.append(time.perf_counter() - start)
    return [row("silostudy, start-up of a process", 23, "start", 10, min(seconds[1:]), float("nan"))]
