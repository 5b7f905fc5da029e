"""Command `silostudy bench accuracy --grains spheres`: CPU time to an error of means over fillings, the engine and LAMMPS.

Where spheres come to rest hangs on every rounding: forces on a wall scatter from filling to filling by far more than a stable
step changes them.  What can be asked for is a mean, and it costs as many fillings as the scatter asks for, each at the longest
step whose mean is that of the finer ones.
"""

import time
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from math import ceil, sqrt

import numpy as np
import pandas as pd

from silostudy.accuracy.bin_of_spheres import Bin, bin_of_spheres
from silostudy.commands.bench_dem import has_peer
from silostudy.commands.bench_spheres import OwnSpheres
from silostudy.dem.explosion import Explosion
from silostudy.dem.integrate import PLAIN, SMOOTHED, VERLET
from silostudy.dem.space.model import SphereModel
from silostudy.scene.space_silo import HOPPER

BIN = Bin(count=2_000, wide=0.03, outlet=0.024)
REST = 0.4  # s: the lattice has fallen together by then
FLOW = (0.1, 0.4)  # s after the opening, between which the spheres that leave are counted
STEPS = tuple(float(f"{1.13e-4 * 2.0 ** (-k / 2):.3g}") for k in range(6))  # s
FILLINGS = 6
ASKED = (0.1, 0.05, 0.02)  # relative errors of a mean whose cost is told
SKIN = 0.2  # of a diameter: of the peer's lists
SURE = 2.0  # standard errors by which a mean must be off those of finer steps before the step is blamed
QUANTITIES = {"force": "wall force at rest", "flow": "mass flow"}
MARKERS = {PLAIN.key: "o", SMOOTHED.key: "s", VERLET.key: "^", "LAMMPS": "D"}


def run(chosen) -> None:
    runs = measured(has_peer())
    rows = pd.concat([errors(runs, quantity) for quantity in QUANTITIES], ignore_index=True)
    print(rows.to_string(index=False, float_format=lambda value: f"{value:.3g}"))
    for quantity in QUANTITIES:
        for asked in ASKED:
            print(told(rows[rows["quantity"] == quantity], asked))
    draw(rows, chosen.output)


def measured(with_peer: bool) -> pd.DataFrame:
    """A row a filling, step and code: wall force at rest (N), mass flow (kg/s), CPU time (s); filling by filling, in turn."""
    from tqdm import tqdm

    codes: dict[str, Callable] = {key: partial(ours, key) for key in (PLAIN.key, SMOOTHED.key, VERLET.key)}
    codes |= {"LAMMPS": theirs} if with_peer else {}
    rows = []
    with tqdm(total=FILLINGS * len(STEPS) * len(codes), unit=" runs") as bar:
        for seed in range(FILLINGS):
            model = bin_of_spheres(BIN, seed)
            for dt in STEPS:
                for name, make in codes.items():
                    rows.append({"code": name, "step_s": dt, **emptied(make, replace(model, dt=dt))})
                    bar.update()
    return pd.DataFrame(rows)


def ours(integrator: str, model: SphereModel) -> OwnSpheres:
    """The engine with an integrator."""
    return OwnSpheres(replace(model, integrator=integrator))


def theirs(model: SphereModel):
    """LAMMPS."""
    from silostudy.accuracy.peer_of_spheres import LammpsSpheres

    return LammpsSpheres(BIN, model, np.c_[model.x, model.y, model.z], "granular", SKIN * BIN.diameter)


def emptied(make: Callable, model: SphereModel) -> dict[str, float]:
    """Wall force at rest (N) and mass flow (kg/s) of a filling by a code, and its CPU time (s); NaN where spheres are lost."""
    code = make(model)
    start = time.process_time()
    try:
        code.step(round(REST / model.dt))
        force = wall_force(model, code.places)
        code.open_outlet()
        left = []
        for begin, end in ((0.0, FLOW[0]), FLOW):
            code.step(round((end - begin) / model.dt))
            left.append(int((code.places[:, 2] > 0.0).sum()))  # NaN of those that have left is not above
    except Explosion:
        force, left = np.nan, [0, 0]
    spent = time.process_time() - start
    flow = float(model.mass[0]) * (left[0] - left[1]) / (FLOW[1] - FLOW[0]) if np.isfinite(force) else np.nan
    return {"force": force, "flow": flow, "cpu_s": spent}


def wall_force(model: SphereModel, places: np.ndarray) -> float:
    """Normal force (N) at rest on the cylinder, from the overlaps; NaN where spheres are lost."""
    if len(places) < len(model.x) or not np.isfinite(places).all():
        return np.nan
    wide, top = model.wall_named(HOPPER).end
    radius, stiffness = float(model.radius[0]), model.at_wall(0, 0).coefficients["hertz_stiffness"]
    depth = np.maximum(0.0, np.hypot(places[:, 0], places[:, 1]) + radius - wide)[places[:, 2] > top]
    reduced = radius / (1.0 - radius * 0.5 / wide)  # a cylinder bends about the sphere in one of two directions
    return float(stiffness * (np.sqrt(reduced * depth) * depth).sum())


def errors(runs: pd.DataFrame, quantity: str) -> pd.DataFrame:
    """A row a code and step: mean of a quantity, how far it is surely off that of all finer steps, scatter of a filling (1)."""
    rows = []
    for code, own in runs.dropna().groupby("code", sort=False):
        whole = own[own.groupby("step_s")["step_s"].transform("size") == FILLINGS]  # no filling was lost
        means = whole.groupby("step_s")[quantity].mean()
        scatter = float(np.sqrt(whole.groupby("step_s")[quantity].var(ddof=1).mean()))
        for dt, mean in means.items():
            finer = whole[whole["step_s"] < dt][quantity]
            doubt = SURE * scatter * sqrt(1.0 / FILLINGS + 1.0 / len(finer)) if len(finer) else np.inf
            off = max(0.0, abs(mean - finer.mean()) - doubt) if len(finer) else 0.0
            cost = float(whole[whole["step_s"] == dt]["cpu_s"].median())
            rows.append({"quantity": quantity, "code": code, "step_s": dt, "mean": mean, "surely_off": off / mean,
                         "scatter": scatter / mean, "cpu_s": cost})  # fmt: skip
    return pd.DataFrame(rows)


def fillings_for(row: pd.Series, asked: float) -> float:
    """Fillings whose mean has an error at one step; infinite where the step itself takes all of it."""
    room = asked - row["surely_off"]
    return max(1, ceil((row["scatter"] / room) ** 2)) if room > 0.0 else np.inf


def told(rows: pd.DataFrame, asked: float) -> str:
    """Sentence on the cheapest of ours and of LAMMPS that keeps an error of a quantity, and their ratio."""
    words, costs = [], []
    for part in (rows[rows["code"] != "LAMMPS"], rows[rows["code"] == "LAMMPS"]):
        if part.empty:
            continue
        counts = part.apply(fillings_for, axis=1, asked=asked)
        best = (counts * part["cpu_s"]).idxmin()
        costs.append(counts[best] * part["cpu_s"][best])
        runs = f"{counts[best]:g} filling{'s' if counts[best] > 1.0 else ''}"
        words.append(f"{part['code'][best]} {runs} by {part['step_s'][best]:g} s in {costs[-1]:.3g} s")
    ratio = f"; LAMMPS takes {costs[1] / costs[0]:.1f} times as long" if len(costs) == 2 else ""
    return f"{QUANTITIES[rows['quantity'].iloc[0]]} within {asked:.0%}: {'; '.join(words)}{ratio}"


def draw(rows: pd.DataFrame, output) -> None:
    """Writes the picture: error of a mean over the CPU time of its fillings, at the best step of each code."""
    import matplotlib.pyplot as plt

    from silostudy.accuracy.measure import machine
    from silostudy.figures.style import COLOURS, WIDTH, foot, headline, save

    figure, panels = plt.subplots(1, len(QUANTITIES), figsize=(WIDTH, 5.4), sharey=True)
    for panel, (quantity, title) in zip(panels, QUANTITIES.items(), strict=True):
        for colour, (code, marker) in zip(COLOURS, MARKERS.items(), strict=False):
            part = rows[(rows["quantity"] == quantity) & (rows["code"] == code) & (rows["surely_off"] == 0.0)]
            if part.empty:
                continue
            best, counts = part.loc[part["cpu_s"].idxmin()], 2.0 ** np.arange(8)
            panel.plot(best["cpu_s"] * counts, best["scatter"] / np.sqrt(counts), marker=marker, color=colour,
                       label=f"{code}, {best['step_s']:g} s a step")  # fmt: skip
        for asked in ASKED:
            panel.axhline(asked, color="0.6", linewidth=0.8)
        panel.set(xscale="log", yscale="log", xlabel="CPU time of all fillings (s)", title=title)
        panel.legend(fontsize="small")
    panels[0].set_ylabel("standard error of the mean over its value")
    told_of_flow = told(rows[rows["quantity"] == "flow"], ASKED[1])
    headline(figure, f"{told_of_flow[0].upper()}{told_of_flow[1:]}")
    about = machine()
    foot(figure, f"{BIN.count} spheres in a bin on a cone; scatter of {FILLINGS} fillings. Marks: 1, 2, 4 ... fillings. "
         f"{PLAIN.key}, {SMOOTHED.key}, {VERLET.key}: the engine's integrators.",
         f"{about['machine']}, {about['measured_on']}")  # fmt: skip
    save(figure, rows, output.with_suffix(""))
