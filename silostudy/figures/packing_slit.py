"""Discharge through slits of several widths: rate against the plane Beverloo law, chance of arching, overpressure."""

from itertools import product
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr
from scipy.optimize import curve_fit

from silostudy.figures import ensembles
from silostudy.figures.style import save
from silostudy.tables.constants import STANDARD_GRAVITY

ENOUGH = 5  # runs with a rate, from which on a slit takes part in the fit
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#000000", "#999999")
LINES = ("-", "--", ":", "-.")
SHORT = {"disc_friction": "disc friction", "wall_friction_coefficient": "wall", "stiffness": "E"}
CLOSE = 0.1  # relative miss up to which the law is said to hold


def rate(slit, coefficient, edge, *, density: float, diameter: float):
    """Discharge (kg/m/s) of a plane silo through a slit (m): C rho_b sqrt(g) (D - k d)^1.5, none below k d.

    Source: mankoc_2007 (Beverloo's law), in the plane form that the dimensions ask for.
    """
    free = np.maximum(slit - edge * diameter, 0.0)
    return coefficient * density * np.sqrt(STANDARD_GRAVITY) * free**1.5


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: a line for each combination of the study's other axes."""
    cube = ensembles.first(cube)
    others = [axis for axis in cube.attrs["sweep_axes"].split() if axis in cube.dims and axis != "slit"]
    figure, panels = plt.subplots(1, 3, figsize=(15, 6.4))
    numbers = []
    for number, place in enumerate(product(*(range(cube.sizes[axis]) for axis in others))):
        one = cube.isel(dict(zip(others, place, strict=True)))
        look: dict = {"color": COLOURS[place[0] % 8 if place else 0], "linestyle": LINES[_place(place, cube, others) % 4]}
        look |= {"marker": "os^vDPX*"[_place(place, cube, others) % 8], "markersize": 4, "linewidth": 1.1}
        numbers.append(_line(panels, one, _name(one, others), look, number))
    flow, chance, over = panels
    flow.set(
        ylabel="discharge rate (kg m⁻¹ s⁻¹), runs until their first stop", title="points: median of the runs; lines: Beverloo"
    )
    chance.set(
        ylabel="share of runs that an arch stops", ylim=(-0.03, 1.03), title="arching, with 95 % intervals from 5 runs on"
    )
    over.set(yscale="log", ylabel="largest over static: 4 cm of wall, largest 1 ms", title="overpressure, median of the runs")
    over.set_yticks([1, 2, 5, 10], ["1", "2", "5", "10"])
    for panel in panels:
        panel.set(xlabel="width of the slit (cm)", xlim=(0, None))
    figure.legend(loc="outside lower center", ncols=4 if len(numbers) <= 16 else 6, fontsize=7 if len(numbers) <= 16 else 6)
    figure.suptitle(f"{cube.attrs['title']}\n{cube.sizes['run'] - 1} runs a point")
    save(figure, pd.concat(numbers, ignore_index=True), stem)


def _place(place: tuple[int, ...], cube: xr.Dataset, others: list[str]) -> int:
    """A number for the combination of all axes but the first."""
    sizes = tuple(cube.sizes[axis] for axis in others[1:])
    return int(np.ravel_multi_index(place[1:], sizes)) if sizes else 0


def _name(one: xr.Dataset, others: list[str]) -> str:
    """A combination in words."""
    words = []
    for axis in others:
        value = one[axis].item()
        words.append(
            ensembles.name(value) if axis == "packing" else f"{SHORT.get(axis, axis.replace('_', ' '))} {_shown(axis, value)}"
        )
    return ", ".join(words)


def _shown(axis: str, value) -> str:
    return f"{value / 1e6:.3g} MPa" if axis == "stiffness" else f"{value:g}" if isinstance(value, float) else str(value)


def _line(panels, one: xr.Dataset, name: str, look: dict, number: int) -> pd.DataFrame:
    flow, chance, over = panels
    slit = one["slit"].values
    rates = ensembles.runs(one["discharge_rate"])
    known = np.isfinite(rates).sum(axis=0)
    median = np.array([np.nanmedian(column) if np.isfinite(column).any() else np.nan for column in rates.T])
    diameter = 2 * float(one.attrs["radius_m"])
    density = float((one["rest_weight"] / (STANDARD_GRAVITY * one.attrs["width_m"] * one["rest_height"])).mean())
    coefficient, edge = fit(slit, median, known, density=density, diameter=diameter)
    flow.plot(slit * 100, median, color=look["color"], marker=look["marker"], markersize=4, linestyle="none")
    fine = np.linspace(0.0, slit.max(), 100)
    law = {"density": density, "diameter": diameter}
    curve = {"case": name, "runs": rates.shape[0], "slit_cm": fine * 100}
    fitted = pd.DataFrame(curve | {"beverloo_kg_m_s": rate(fine, coefficient, edge, **law)}).dropna()
    flow.plot(fitted.slit_cm, fitted.beverloo_kg_m_s, color=look["color"], linestyle=look["linestyle"], linewidth=1)
    shares = np.array([ensembles.chance(ensembles.runs(one["flow_stopped"].isel(slit=k))) for k in range(len(slit))]).T
    middle, low, high = shares
    shift = 0.02 * number
    bars = [middle - low, high - middle] if rates.shape[0] >= ENOUGH else None  # of fewer runs they would span the panel
    chance.errorbar(slit * 100 + shift, middle, bars, capsize=2, label=name, **look)
    peaks = np.median(ensembles.runs(one["wall_overpressure"].sel(measure="layer_peak")), axis=0)
    over.plot(slit * 100, peaks, **look)
    expected = rate(slit, coefficient, edge, **law)
    miss = np.where(expected > 0, median / np.where(expected > 0, expected, 1.0) - 1.0, np.nan)
    good = slit[np.abs(miss) <= CLOSE]
    columns = {
        "case": name, "slit_cm": slit * 100, "slit_over_diameter": slit / diameter,
        "runs": rates.shape[0], "runs_with_rate": known,
        "rate_median_kg_m_s": median, "beverloo_kg_m_s": expected, "miss": miss, "C": coefficient, "k": edge,
        "holds_from_cm": good.min() * 100 if len(good) else np.nan, "holds_to_cm": good.max() * 100 if len(good) else np.nan,
        "stopped_share": middle, "share_low_95": low, "share_high_95": high,
    }  # fmt: skip
    for measure in one["measure"].values:
        columns[f"overpressure_{measure}_median"] = np.median(
            ensembles.runs(one["wall_overpressure"].sel(measure=measure)), axis=0
        )
    return pd.concat([pd.DataFrame(columns), fitted])


def fit(slit, median, known, *, density: float, diameter: float) -> tuple[float, float]:
    """(C, k) of Beverloo's law through the medians of the slits where enough runs flowed; NaN where there are too few slits."""
    use = (known >= min(ENOUGH, known.max())) & np.isfinite(median)
    if use.sum() < 3:
        return np.nan, np.nan
    found, _ = curve_fit(
        lambda width, c, k: rate(width, c, k, density=density, diameter=diameter), slit[use], median[use],
        p0=(1.0, 1.0), bounds=([0.0, 0.0], [10.0, slit[use].min() / diameter]),
    )  # fmt: skip
    return float(found[0]), float(found[1])
