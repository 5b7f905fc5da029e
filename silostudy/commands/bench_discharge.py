"""Command `silostudy bench discharge`: spheres left in a bin while it flows out, by the engine and by LAMMPS.

Both start from the same fillings, at rest; which sphere goes when differs soon, so the scatter over fillings is beside it.
"""

from dataclasses import dataclass
from itertools import product
from typing import Any

import numpy as np

from silostudy.accuracy.bin_of_spheres import Bin, benchmark_bin, bin_of_spheres
from silostudy.commands.bench_dem import has_peer, show
from silostudy.commands.bench_spheres import OwnSpheres
from silostudy.errors import unknown

SKIN = 0.2  # of a diameter: of the peer's lists


@dataclass(frozen=True)
class DischargeCase:
    """A bin that flows out: for how long it settles (s), when after the opening spheres are counted (s), how many fillings."""

    name: str
    bin: Bin
    settle: float
    times: np.ndarray
    fillings: int


def benchmark(diameter: float, softening: float, steps: dict[str, float], until: float, fillings: int) -> list[DischargeCase]:
    """The four cases of Dosta et al. (2024): two materials, each by its step (s), and outlets of 60 and 40 mm."""
    times = np.arange(1, round(until / 0.1) + 1) * 0.1
    return [
        DischargeCase(f"{material}, {1e3 * outlet:g} mm", benchmark_bin(material, outlet, diameter, softening, steps[material]),
                  0.5, times, fillings)
        for material, outlet in product(steps, (0.06, 0.04))
    ]  # fmt: skip


SILOS: dict[str, list[DischargeCase]] = {
    "small": [DischargeCase("5,000 of 4 mm", Bin(count=5_000, wide=0.05), 0.4, np.arange(1, 7) * 0.05, 6)],
    "benchmark-8mm": benchmark(0.008, 500.0, {"m1": 1e-4, "m2": 1e-4}, 1.0, 3),
    "benchmark": benchmark(0.004, 1.0, {"m1": 1.5e-6, "m2": 2e-6}, 5.0, 3),
}


def run(chosen) -> None:
    from tqdm import tqdm

    if chosen.silo not in SILOS:
        raise unknown("--silo", chosen.silo, SILOS)
    with_peer, cases = has_peer(), SILOS[chosen.silo]
    rows: list[dict] = []
    with tqdm(total=sum(case.fillings for case in cases), unit=" fillings") as bar:
        for case in cases:
            rounds = []
            for seed in range(case.fillings):
                rounds.append(filling(case, seed, with_peer))
                bar.update()
            rows += table(case, {name: np.array([number[name] for number in rounds]) for name in rounds[0]})
    show(rows, chosen.output)


def filling(case: DischargeCase, seed: int, with_peer: bool) -> dict[str, list[int]]:
    """Spheres above the outlet at the times, by code, from one filling."""
    model = bin_of_spheres(case.bin, seed)
    ours = OwnSpheres(model)
    ours.step(round(case.settle / case.bin.step))
    codes: dict[str, Any] = {"silostudy": ours}
    if with_peer:
        from silostudy.accuracy.peer_of_spheres import LammpsSpheres

        codes["LAMMPS"] = LammpsSpheres(case.bin, model, ours.places, "granular", SKIN * case.bin.diameter)
    return {name: above(case, code) for name, code in codes.items()}


def above(case: DischargeCase, code) -> list[int]:
    """Spheres above the outlet of a code at the times after its outlet opens."""
    code.open_outlet()
    counts, done = [], 0
    for time in case.times:
        until = round(time / case.bin.step)
        code.step(until - done)
        done = until
        counts.append(int((code.places[:, 2] > 0.0).sum()))
    return counts


def table(case: DischargeCase, left: dict[str, np.ndarray]) -> list[dict]:
    """A row a time: of each code the mean over fillings, and of two their mean difference and how far a filling's scatters.

    left: shape (fillings, times) by code.
    """
    rows = []
    for k, time in enumerate(case.times):
        row = {"case": case.name, "time_s": float(time), "fillings": len(left["silostudy"])}
        for name, counts in left.items():
            row |= {f"{name}_left": float(counts[:, k].mean()), f"{name}_deviation": float(counts[:, k].std(ddof=1))}
        if len(left) > 1:
            ours, theirs = left.values()
            row["mean_difference"] = float((ours - theirs)[:, k].mean())
            row["its_standard_error"] = float((ours - theirs)[:, k].std(ddof=1) / np.sqrt(len(ours)))
        rows.append(row)
    return rows
