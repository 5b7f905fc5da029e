"""`silostudy bench discharge`: how many spheres stay in a bin while it flows out, by the engine and by LAMMPS.

Both start from the same fillings, at rest; which sphere goes when differs soon, so the scatter over fillings is beside it.
"""

from typing import Any

import numpy as np

from silostudy.accuracy.bin_of_spheres import DIAMETER, STEP, bin_of_spheres
from silostudy.commands.bench_dem import has_peer, show
from silostudy.commands.bench_spheres import Ours

COUNT, WIDE, SETTLE = 5_000, 0.05, 40_000  # spheres, radius of the bin (m), steps that settle
FILLINGS = 6
TIMES = np.arange(1, 7) * 0.05  # s after the opening
SKIN = 0.2  # of a diameter: of the peer's lists


def run(chosen) -> None:
    from tqdm import tqdm

    with_peer = has_peer()
    rounds = [filling(seed, with_peer) for seed in tqdm(range(FILLINGS), unit=" fillings")]
    show(table({name: np.array([one[name] for one in rounds]) for name in rounds[0]}), chosen.output)


def filling(seed: int, with_peer: bool) -> dict[str, list[int]]:
    """Spheres above the outlet at the times, by code, from one filling."""
    model = bin_of_spheres(COUNT, WIDE, seed)
    ours = Ours(model)
    ours.step(SETTLE)
    codes: dict[str, Any] = {"silostudy": ours}
    if with_peer:
        from silostudy.accuracy.peer_of_spheres import LammpsSpheres

        codes["LAMMPS"] = LammpsSpheres(model, ours.places, "granular", SKIN * DIAMETER)
    return {name: above(code) for name, code in codes.items()}


def above(code) -> list[int]:
    """Spheres above the outlet of a code at the times after its outlet opens."""
    code.open_outlet()
    counts, done = [], 0
    for time in TIMES:
        until = round(time / STEP)
        code.step(until - done)
        done = until
        counts.append(int((code.places[:, 2] > 0.0).sum()))
    return counts


def table(left: dict[str, np.ndarray]) -> list[dict]:
    """A row a time: of each code the mean over fillings, and of two their mean difference and how far a filling's scatters.

    left: shape (fillings, times) by code.
    """
    rows = []
    for k, time in enumerate(TIMES):
        row = {"time_s": float(time), "fillings": len(left["silostudy"])}
        for name, counts in left.items():
            row |= {f"{name}_left": float(counts[:, k].mean()), f"{name}_deviation": float(counts[:, k].std(ddof=1))}
        if len(left) > 1:
            one, other = left.values()
            row["mean_difference"] = float((one - other)[:, k].mean())
            row["its_standard_error"] = float((one - other)[:, k].std(ddof=1) / np.sqrt(len(one)))
        rows.append(row)
    return rows
