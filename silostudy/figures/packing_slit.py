"""Discharge through slits of several widths: rate against the plane Beverloo law, chance of arching, overpressure."""

from itertools import product
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr
from scipy.optimize import curve_fit

from silostudy.figures import ensembles
from silostudy.figures.beside import span
from silostudy.figures.style import TALLEST, WIDTH, foot, headline, save, series
from silostudy.tables.constants import STANDARD_GRAVITY

ENOUGH = 5  # runs with a rate, from which on a slit takes part in the fit
SHORT = {"disc_friction": "disc friction", "wall_friction_coefficient": "wall", "stiffness": "E"}
CLOSE = 0.1  # relative miss up to which the law is said to hold


def rate(slit, coefficient, edge, *, density: float, diameter: float):
    """Discharge (kg/m/s) of a plane silo through a slit (m): C rho_b sqrt(g) (D - k d)^1.5, none below k d.

    Source: mankoc_2007 (Beverloo's law), in the plane form that the dimensions ask for.
    """
    free = np.maximum(slit - edge * diameter, 0.0)
    return coefficient * density * np.sqrt(STANDARD_GRAVITY) * free**1.5


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: a row of panels a value of the first axis, a line a combination of the others."""
    cube = ensembles.first(cube)
    rows, *others = [axis for axis in cube.attrs["sweep_axes"].split() if axis in cube.dims and axis != "slit"] or [None]
    count = cube.sizes[rows] if rows else 1
    figure, panels = plt.subplots(count, 3, figsize=(WIDTH, min(TALLEST, 1.6 + max(4.6, 2.6 * count))), squeeze=False,
                                  sharex=True, sharey="col")  # fmt: skip
    numbers = []
    for number, row in enumerate(panels):
        part = cube.isel({rows: number}) if rows else cube
        numbers += [table.assign(row=_name(part, [rows] if rows else [])) for table in _row(row, part, others)]
        row[0].set_ylabel("\n".join([*numbers[-1]["row"].unique(), "discharge (kg m⁻¹ s⁻¹)"]).strip())
    _dress(panels)
    table = pd.concat(numbers, ignore_index=True)
    headline(figure, _message(table))
    about = f"{cube.sizes['run'] - 1} runs a point. Discharge until the first stop: points are the median of the runs, lines "
    about += (
        f"Beverloo's law; arching with 95 % intervals from {ENOUGH} runs on; overpressure: 4 cm of wall, largest 1 ms, median."
    )
    foot(figure, f"{cube.attrs['title']}.", about, handles=panels[0, 1].get_legend_handles_labels()[0] if others else ())
    save(figure, table, stem)


def _row(panels, part: xr.Dataset, others: list[str]) -> list[pd.DataFrame]:
    """A row of panels: every combination of the other axes; their tables."""
    tables = []
    for number, place in enumerate(product(*(range(part.sizes[axis]) for axis in others))):
        combination = part.isel(dict(zip(others, place, strict=True)))
        look = series(number) | {"markersize": 4, "linewidth": 1.2}
        tables.append(_line(panels, combination, _name(combination, others), look, number))
    return tables


def _dress(panels) -> None:
    """Labels and limits of all panels."""
    for flow, chance, over in panels:
        chance.set(ylabel="share stopped (1)", ylim=(-0.05, 1.05))
        over.set(yscale="log", ylabel="largest over static")
        over.set_yticks([1, 2, 5, 10], ["1", "2", "5", "10"])
        flow.set(xlim=(0, None), ylim=(0, None))
    for panel, title in zip(panels[0], ("discharge", "arching", "overpressure"), strict=True):
        panel.set_title(title)
    for panel in panels[-1]:
        panel.set_xlabel("width of the slit (cm)")


def _message(table: pd.DataFrame) -> str:
    """Between which ends the edge of Beverloo's law lies, and from which slit on no run stops."""
    points = table[table["stopped_share"].notna()]
    edges = points["k"].dropna()
    law = (
        f"Beverloo's law fits with an edge of {span(edges.min(), edges.max())} diameters" if len(edges) else "No law was fitted"
    )
    stopped = points[points["stopped_share"] > 0.0]["slit_cm"]
    wider = points["slit_cm"][points["slit_cm"] > stopped.max()] if len(stopped) else points["slit_cm"]
    free = (
        f"no run stops from {wider.min():g} cm on" if len(wider) else f"runs stop up to the widest slit of {stopped.max():g} cm"
    )
    return f"{law}; {free}"


def _name(combination: xr.Dataset, others: list[str]) -> str:
    """A combination in words."""
    words = []
    for axis in others:
        value = combination[axis].item()
        words.append(
            ensembles.name(value) if axis == "packing" else f"{SHORT.get(axis, axis.replace('_', ' '))} {_shown(axis, value)}"
        )
    return ", ".join(words)


def _shown(axis: str, value) -> str:
    return f"{value / 1e6:.3g} MPa" if axis == "stiffness" else f"{value:g}" if isinstance(value, float) else str(value)


def _line(panels, silo: xr.Dataset, name: str, look: dict, number: int) -> pd.DataFrame:
    flow, chance, over = panels
    slit = silo["slit"].values
    rates = ensembles.runs(silo["discharge_rate"])
    known = np.isfinite(rates).sum(axis=0)
    median = np.array([np.nanmedian(column) if np.isfinite(column).any() else np.nan for column in rates.T])
    diameter = 2 * float(silo.attrs["radius_m"])
    density = float((silo["rest_weight"] / (STANDARD_GRAVITY * silo.attrs["width_m"] * silo["rest_height"])).mean())
    coefficient, edge = fit(slit, median, known, density=density, diameter=diameter)
    flow.plot(slit * 100, median, color=look["color"], marker=look["marker"], markersize=4, linestyle="none")
    fine = np.linspace(0.0, slit.max(), 100)
    law = {"density": density, "diameter": diameter}
    curve = {"case": name, "runs": rates.shape[0], "slit_cm": fine * 100}
    fitted = pd.DataFrame(curve | {"beverloo_kg_m_s": rate(fine, coefficient, edge, **law)}).dropna()
    flow.plot(fitted.slit_cm, fitted.beverloo_kg_m_s, color=look["color"], linestyle=look["linestyle"], linewidth=1)
    shares = np.array([ensembles.chance(ensembles.runs(silo["flow_stopped"].isel(slit=k))) for k in range(len(slit))]).T
    middle, low, high = shares
    shift = 0.06 * number  # so that bars do not hide one another
    bars = [middle - low, high - middle] if rates.shape[0] >= ENOUGH else None  # of fewer runs they would span the panel
    chance.errorbar(slit * 100 + shift, middle, bars, capsize=2, label=name or None, **look)
    peaks = np.median(ensembles.runs(silo["wall_overpressure"].sel(measure="layer_peak")), axis=0)
    over.plot(slit * 100, peaks, **look)
    expected = rate(slit, coefficient, edge, **law)
    miss = np.where(expected > 0, median / np.where(expected > 0, expected, 1.0) - 1.0, np.nan)
    good = slit[np.abs(miss) <= CLOSE]
    columns = {
        "case": name, "slit_cm": slit * 100, "drawn_at_cm": slit * 100 + shift, "slit_over_diameter": slit / diameter,
        "runs": rates.shape[0], "runs_with_rate": known,
        "rate_median_kg_m_s": median, "beverloo_kg_m_s": expected, "miss": miss, "C": coefficient, "k": edge,
        "holds_from_cm": good.min() * 100 if len(good) else np.nan, "holds_to_cm": good.max() * 100 if len(good) else np.nan,
        "stopped_share": middle, "share_low_95": low, "share_high_95": high,
    }  # fmt: skip
    for measure in silo["measure"].values:
        columns[f"overpressure_{measure}_median"] = np.median(
            ensembles.runs(silo["wall_overpressure"].sel(measure=measure)), axis=0
        )
    return pd.concat([pd.DataFrame(columns), fitted])


def fit(slit, median, known, *, density: float, diameter: float) -> tuple[float, float]:
    """Constants (C, k) of Beverloo's law through the medians of the slits where enough runs flowed; NaN of too few slits."""
    use = (known >= min(ENOUGH, known.max())) & np.isfinite(median)
    if use.sum() < 3:
        return np.nan, np.nan
    constants, _ = curve_fit(
        lambda width, c, k: rate(width, c, k, density=density, diameter=diameter), slit[use], median[use],
        p0=(1.0, 1.0), bounds=([0.0, 0.0], [10.0, slit[use].min() / diameter]),
    )  # fmt: skip
    return float(constants[0]), float(constants[1])
