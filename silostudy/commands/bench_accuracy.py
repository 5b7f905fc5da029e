"""Command `silostudy bench accuracy`: CPU time to an error of the static wall forces, the engine and LAMMPS side by side.

Where discs come to rest hangs on every rounding, so one filling may hit its mark by luck: an error is the root of the mean
square over fillings that differ by tiny offsets, each against the same filling at the finest step of the same code.
"""

import time
from collections.abc import Callable
from dataclasses import replace
from functools import partial

import numpy as np

from silostudy.accuracy import front
from silostudy.accuracy.silo import LEVELS, silo_of_rows
from silostudy.dem.engine import Engine
from silostudy.dem.explosion import Explosion
from silostudy.dem.integrate import PLAIN, SMOOTHED, VERLET
from silostudy.dem.model import Model
from silostudy.scene.plane_silo import inner_width
from silostudy.tables.kiyama_1983 import ACTIVE

PARTS = 6  # of a wall, each with its force
REST = 0.4  # s: the fillings are at rest by then
OFFSET = 4e-6  # m: every disc of a filling starts up to this elsewhere
FILLINGS = 6  # so many that their scatter shows
STEPS = tuple(float(f"{1e-4 * 2.0 ** (-k / 2):.3g}") for k in range(11))  # s
FINEST = 1e-6  # s: step of the runs that the others are measured against
ASKED = (0.2, 0.1, 0.05, 0.02)  # relative errors whose cost is told
INTEGRATORS = (PLAIN.key, SMOOTHED.key, VERLET.key)
LOOKS = {PLAIN.key: ("#0072b2", "o"), SMOOTHED.key: ("#d55e00", "s"), VERLET.key: ("#009e73", "^"), "LAMMPS": ("black", "D")}


def run(chosen) -> None:
    import pandas as pd

    from silostudy.accuracy.peers import available

    missing = available()
    if missing:
        print(f"{missing}: its rows are left out")
    codes: dict[str, Callable] = {name: partial(_ours, name) for name in INTEGRATORS} | ({} if missing else {"LAMMPS": _lammps})
    rows = pd.DataFrame(_in_turn(codes))
    print(rows.to_string(index=False, float_format=lambda value: f"{value:.3g}"))
    for asked in ASKED:
        print(_told(rows, asked))
    _draw(rows, chosen.output)


def _ours(integrator: str, model: Model, dt: float) -> tuple[np.ndarray, float]:
    """Wall forces at rest and CPU seconds."""
    engine = Engine(replace(model, integrator=integrator, dt=dt))
    start = time.process_time()
    try:
        engine.step_to(round(REST / dt))
    except Explosion:
        return np.full((2, PARTS), np.nan), time.process_time() - start
    return _wall_force(model, engine.places), time.process_time() - start


def _lammps(model: Model, dt: float) -> tuple[np.ndarray, float]:
    from silostudy.accuracy.peers import Lammps

    peer = Lammps(replace(model, dt=dt), np.c_[model.x, model.y], slit=0.2 * inner_width(model))
    start = time.process_time()
    peer.step(round(REST / dt))
    spent = time.process_time() - start
    places = peer.places
    peer.close()
    return _wall_force(model, places), spent


def _wall_force(model: Model, places: np.ndarray) -> np.ndarray:
    """Normal force (N/m) at rest on each part of both walls, from the overlaps: (2, parts); NaN where discs are lost."""
    if len(places) < len(model.x) or not np.isfinite(places).all():
        return np.full((2, PARTS), np.nan)
    width, radius = inner_width(model), model.radius[0]
    edges = np.linspace(0.0, float(model.y.max()) + radius, PARTS + 1)
    edges[0], edges[-1] = -np.inf, np.inf
    stiffness = model.at_wall(0, 0).coefficients["normal_stiffness"]
    overlaps = (np.maximum(0.0, radius - places[:, 0]), np.maximum(0.0, places[:, 0] + radius - width))
    return np.array([np.histogram(places[:, 1], edges, weights=stiffness * overlap)[0] for overlap in overlaps])


def _error(force: np.ndarray, exact: np.ndarray) -> float:
    return float(np.abs(force - exact).max() / exact.max())


def _in_turn(codes: dict[str, Callable]) -> list[dict]:
    """Error over the fillings and median CPU time of every code and step, filling by filling."""
    spent: dict[tuple, list[float]] = {(code, dt): [] for dt in STEPS for code in codes}
    errors: dict[tuple, list[float]] = {rung: [] for rung in spent}
    for seed in range(FILLINGS):
        model, _ = silo_of_rows(ACTIVE, LEVELS, offset=OFFSET, seed=seed)
        reference = {VERLET.key: codes[VERLET.key](model, FINEST)[0]}
        if "LAMMPS" in codes:
            reference["LAMMPS"] = codes["LAMMPS"](model, FINEST)[0]
            apart = _error(reference["LAMMPS"], reference[VERLET.key])
            print(
                f"filling {seed}: at {FINEST:g} s the codes are {apart:.1%} apart; each is measured against its own", flush=True
            )
        for code, dt in spent:
            force, seconds = codes[code](model, dt)
            spent[code, dt].append(seconds)
            errors[code, dt].append(_error(force, reference["LAMMPS" if code == "LAMMPS" else VERLET.key]))
    return [
        {
            "code": code,
            "step_s": dt,
            "error": float(np.sqrt(np.mean(np.square(errors[code, dt])))),
            "cpu_s": float(np.median(s)),
        }
        for (code, dt), s in spent.items()
    ]


def _told(rows, asked: float) -> str:
    """The cheapest of ours and of LAMMPS that keep an error at every finer step too, and the ratio."""
    words, costs = [], []
    for mine in (True, False):
        part = rows[(rows["code"] != "LAMMPS") == mine].sort_values("step_s", ascending=False)
        best = front.cheapest(
            part["cpu_s"], part.fillna({"error": np.inf}).groupby("code")["error"].transform(front.lasting_error), asked
        )
        if best is None:
            words.append("not reached")
            continue
        cheapest_run = part.iloc[best]
        costs.append(cheapest_run["cpu_s"])
        words.append(f"{cheapest_run['code']} at {cheapest_run['step_s']:g} s in {cheapest_run['cpu_s']:.3g} s")
    ratio = f"; LAMMPS takes {costs[1] / costs[0]:.1f} times as long" if len(costs) == 2 else ""
    return f"{asked:.0%}: {'; '.join(words)}{ratio}"


def _draw(rows, output) -> None:
    import matplotlib.pyplot as plt

    from silostudy.accuracy.measure import machine
    from silostudy.figures.style import save

    figure, axis = plt.subplots(figsize=(7.5, 5.5))
    for code, part in rows.groupby("code", sort=False):
        shown = part[part["error"] < 1.0]
        colour, marker = LOOKS[code]
        axis.plot(shown["cpu_s"], shown["error"], marker=marker, markersize=5, color=colour, label=code)
    for asked in ASKED:
        axis.axhline(asked, color="black", linewidth=0.5, linestyle=":")
    axis.set(xscale="log", yscale="log", xlabel="CPU time (s)", ylabel="error of the wall forces over the largest of them")
    about = machine()
    axis.set_title(
        f"{ACTIVE * LEVELS - LEVELS // 2} discs brought to rest, {FILLINGS} fillings, one core\n"
        f"{about['machine']}, {about['measured_on']}",
        fontsize=9,
    )
    axis.legend(loc="lower left")
    save(figure, rows, output.with_suffix(""))
