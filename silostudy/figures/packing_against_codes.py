"""Wall forces of the discs beside the codes: over depth against static Janssen, and every kind of peak beside C_d."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures import ensembles
from silostudy.figures.style import save
from silostudy.tables.handbook import STATIC_COLUMN, table_4_2_5
from silostudy.tables.kiyama_1983 import WALL_FRICTION

ACTIVE = (1 - 0.5) / (1 + 0.5)  # Rankine's K for the 30 degrees that the source gives its particles
SHOWN = (12, 15, 18)
COLOURS = {12: "#0072b2", 15: "#009e73", 18: "#d55e00"}
CLOSEST = 1.07  # ratio between the places of neighbouring names of codes
NAMES = {
    "step": "one contact,\nany step",
    "50 ms": "one contact,\nseen every 50 ms",
    "layer_peak": "4 cm of wall,\nlargest 1 ms",
    "panel_peak": "0.7 widths of wall,\nlargest 1 ms",
    "layer_mean": "4 cm of wall,\nmean of 0.4 s",
    "panel_mean": "0.7 widths of wall,\nmean of 0.4 s",
}


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: forces over depth, factors by what is averaged, and the factors of the codes."""
    cube = ensembles.first(cube)
    figure, (depth, factors) = plt.subplots(1, 2, figsize=(14, 6.6), width_ratios=(1, 1.25))
    shown = [s for s in SHOWN if s in cube["packing"].values] or [int(cube["packing"].values[0])]
    numbers = [_profile(depth, cube.sel(packing=s), s) for s in shown]
    numbers += [_factors(factors, cube.sel(packing=s), s, k - (len(shown) - 1) / 2) for k, s in enumerate(shown)]
    numbers.append(_codes(factors))
    depth.axvline(1, color="black", linewidth=0.8)
    depth.set(
        xscale="log", xlabel="normal force on 4 cm of wall over static Janssen's", ylabel="depth below the top of the fill (cm)"
    )
    depth.invert_yaxis()
    depth.set_title("over depth: static, mean of the first 0.4 s, largest 1 ms")
    depth.set_xlim(0.3, 60)
    depth.legend(fontsize=7, loc="upper center", bbox_to_anchor=(0.5, -0.1), ncols=3)
    factors.set_xticks(range(len(NAMES)), list(NAMES.values()), fontsize=7.5)
    factors.set(yscale="log", ylabel="largest in discharge over largest at rest, of the same kind and packing")
    factors.set_yticks([0.5, 1, 2, 5, 10, 20], ["0.5", "1", "2", "5", "10", "20"])
    factors.set_title("what a peak is depends on what is averaged")
    factors.legend(fontsize=7.5, loc="upper right")
    figure.suptitle(
        f"{cube.attrs['title']}\nmedian and middle four fifths of {cube.sizes['run'] - 1} runs; Janssen in the same plane box,"
        f" K = {ACTIVE:.2f} (Rankine, 30°), wall friction {WALL_FRICTION}"
    )
    save(figure, pd.concat(numbers, ignore_index=True), stem)


def janssen_layers(one: xr.Dataset) -> np.ndarray:
    """Force (N/m) on every layer of a side wall by static Janssen in the same box; NaN above the fill.

    Source: silo_handbook, section 4.2.2, with the hydraulic radius of a plane silo, half its width; the mean of the runs'
    height and weight.
    """
    width, height = float(one.attrs["width_m"]), float(one["rest_height"].mean())
    unit_weight = float(one["rest_weight"].mean()) / (width * height)
    step = float(one["layer"][1] - one["layer"][0])
    depth = height - one["layer"].values
    radius = width / 2
    pressure = unit_weight * radius / WALL_FRICTION * -np.expm1(-ACTIVE * WALL_FRICTION * depth / radius)
    return np.where(depth > step / 2, pressure * step, np.nan)


def _profile(panel, one: xr.Dataset, across: int) -> pd.DataFrame:
    """Static force, mean of the early flow and largest force of every layer over Janssen's, over depth."""
    static = janssen_layers(one)
    depth = (float(one["rest_height"].mean()) - one["layer"].values) * 100
    looks = {
        "rest_side_normal_force": (":", "static"),
        "layer_force_mean": ("--", "mean"),
        "layer_force_peak": ("-", "largest"),
    }
    found = []
    for variable, (line, label) in looks.items():
        low, middle, high = ensembles.spread(ensembles.runs(one[variable])) / static
        text = f"{ensembles.name(across)}, {label}"
        panel.plot(middle, depth, color=COLOURS[across], linestyle=line, linewidth=1.5, label=text)
        if line == "-":
            panel.fill_betweenx(depth, low, high, color=COLOURS[across], alpha=0.15, linewidth=0)
        table = {"depth_cm": depth, "tenth": low, "median": middle, "nine_tenths": high}
        found.append(pd.DataFrame({"packing": ensembles.name(across), "quantity": f"{label} over Janssen", **table}))
    table = pd.concat(found)
    return table[np.isfinite(table["median"])]


def _factors(panel, one: xr.Dataset, across: int, shift: float) -> pd.DataFrame:
    found = []
    for place, measure in enumerate(NAMES):
        kind = "look" if measure in one["look"].values else "measure"
        values = one["contact_overpressure" if kind == "look" else "wall_overpressure"].sel({kind: measure})
        low, middle, high = ensembles.spread(ensembles.runs(values))
        panel.errorbar(
            place + 0.18 * shift, middle, [[middle - low], [high - middle]], fmt="o", markersize=5, capsize=3,
            color=COLOURS[across], label=ensembles.name(across) if place == 0 else None,
        )  # fmt: skip
        quantity = NAMES[measure].replace("\n", " ")
        found.append(
            {"packing": ensembles.name(across), "quantity": quantity, "tenth": low, "median": middle, "nine_tenths": high}
        )
    return pd.DataFrame(found)


def code_factors() -> dict[str, float]:
    """Largest printed discharge pressure of each method of Table 4.2.5 over the largest of static Janssen there."""
    printed = table_4_2_5()
    static = max(value.wall_normal_pressure for value in printed if value.method == STATIC_COLUMN)
    found: dict[str, float] = {}
    for value in printed:
        if value.phase == "discharge":
            found[value.method] = max(found.get(value.method, 0.0), value.wall_normal_pressure / static)
    return found


def _codes(panel) -> pd.DataFrame:
    """The band of the codes, and the line of each."""
    found = code_factors()
    panel.axhspan(1.0, max(found.values()), color="#999999", alpha=0.18, linewidth=0)
    place = 0.0
    for method, factor in sorted(found.items(), key=lambda item: item[1]):
        panel.axhline(factor, color="#555555", linewidth=0.6, linestyle=(0, (1, 2)))
        place = max(factor, place * CLOSEST)
        panel.text(1.01, place, f"{method} {factor:.2f}", transform=panel.get_yaxis_transform(), fontsize=6.5, va="center")
    panel.text(
        0.01, 1.03, "discharge of Table 4.2.5's methods over static Janssen", fontsize=7, transform=panel.get_yaxis_transform()
    )
    return pd.DataFrame([{"packing": "Table 4.2.5", "quantity": method, "median": factor} for method, factor in found.items()])
