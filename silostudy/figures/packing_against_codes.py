"""Wall forces of the discs beside the codes: over depth against static Janssen, and every kind of peak beside C_d."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes

from silostudy.figures import ensembles
from silostudy.figures.apart import apart
from silostudy.figures.beside import span
from silostudy.figures.style import BLUE, GREEN, TALLEST, VERMILION, WIDTH, foot, headline, save
from silostudy.tables.handbook import STATIC_COLUMN, table_4_2_5
from silostudy.tables.kiyama_1983 import WALL_FRICTION

ACTIVE = (1 - 0.5) / (1 + 0.5)  # Rankine's K for the 30 degrees that the source gives its particles
SHOWN = (12, 15, 18)
LOOKS: dict[int, dict] = {
    12: {"color": BLUE, "marker": "o"},
    15: {"color": GREEN, "marker": "^"},
    18: {"color": VERMILION, "marker": "s"},
}
QUANTITIES: dict[str, tuple[str, dict]] = {  # over Janssen's: the largest leads the eye, the others are background
    "rest_side_normal_force": ("static", {"color": "0.65", "linestyle": (0, (1, 1)), "linewidth": 1.2}),
    "layer_force_mean": ("mean of the first 0.4 s", {"color": "0.45", "linestyle": (0, (4, 2)), "linewidth": 1.2}),
    "layer_force_peak": ("largest 1 ms", {"linestyle": "-", "linewidth": 2.0}),
}
CLOSEST = 0.115  # between the logarithms of the places of neighbouring names of codes
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
    figure, (depth, factors) = plt.subplots(2, 1, figsize=(WIDTH, TALLEST), height_ratios=(1, 1.25))
    shown = [s for s in SHOWN if s in cube["packing"].values] or [int(cube["packing"].values[0])]
    profiles = [_profile(depth, cube.sel(packing=s), s) for s in shown]
    peaks = pd.concat([_factors(factors, cube.sel(packing=s), s, k - (len(shown) - 1) / 2) for k, s in enumerate(shown)])
    codes = _codes(factors)
    depth.axvline(1, color="black", linewidth=0.8)
    depth.set(xscale="log", xlim=(0.3, 60), ylabel="depth below the top of the fill (cm)")
    depth.set(xlabel="normal force on 4 cm of wall over static Janssen's", title="over depth: at rest and in discharge")
    depth.invert_yaxis()
    factors.set_xticks(range(len(NAMES)), list(NAMES.values()))
    factors.set(yscale="log", ylabel="largest in discharge over largest at rest", title="by what is averaged")
    factors.set_yticks([0.5, 1, 2, 5, 10, 20], ["0.5", "1", "2", "5", "10", "20"])
    headline(figure, _message(peaks, codes))
    about = f"Median and middle four fifths of {cube.sizes['run'] - 1} runs; Janssen in the same plane box, K = {ACTIVE:.2f} "
    about += (
        f"(Rankine, 30°), wall friction {WALL_FRICTION}. Grey lines: Table 4.2.5's methods in discharge over static Janssen."
    )
    foot(figure, f"{cube.attrs['title']}.", about, handles=depth.get_legend_handles_labels()[0])
    save(figure, pd.concat([*profiles, peaks, codes], ignore_index=True), stem)


def _message(peaks: pd.DataFrame, codes: pd.DataFrame) -> str:
    """Message: how large a peak is by what is averaged, and what the codes ask for."""
    ends = [peaks[peaks["quantity"] == name.replace("\n", " ")]["median"] for name in (NAMES["step"], NAMES["panel_mean"])]
    contact, wall = (span(values.min(), values.max()) for values in ends)
    asked = span(codes["median"].min(), codes["median"].max())
    return (
        f"Peaks are {contact} times rest on one contact, {wall} as a mean of 0.4 s on 0.7 widths of wall; codes ask for {asked}"
    )


def janssen_layers(silo: xr.Dataset) -> np.ndarray:
    """Force (N/m) on every layer of a side wall by static Janssen in the same box; NaN above the fill.

    Source: silo_handbook, section 4.2.2, with the hydraulic radius of a plane silo, half its width; the mean of the runs'
    height and weight.
    """
    width, height = float(silo.attrs["width_m"]), float(silo["rest_height"].mean())
    unit_weight = float(silo["rest_weight"].mean()) / (width * height)
    step = float(silo["layer"][1] - silo["layer"][0])
    depth = height - silo["layer"].values
    radius = width / 2
    pressure = unit_weight * radius / WALL_FRICTION * -np.expm1(-ACTIVE * WALL_FRICTION * depth / radius)
    return np.where(depth > step / 2, pressure * step, np.nan)


def _profile(panel: Axes, silo: xr.Dataset, across: int) -> pd.DataFrame:
    """Static force, mean of the early flow and largest force of every layer over Janssen's, over depth."""
    static = janssen_layers(silo)
    depth = (float(silo["rest_height"].mean()) - silo["layer"].values) * 100
    tables = []
    for variable, (label, look) in QUANTITIES.items():
        low, middle, high = ensembles.spread(ensembles.runs(silo[variable])) / static
        style = {"markersize": 5, **LOOKS[across], **look}
        panel.plot(middle, depth, label=f"{ensembles.name(across)}, {label}", **style)
        if variable == "layer_force_peak":
            panel.fill_betweenx(depth, low, high, color=style["color"], alpha=0.15, linewidth=0)
        table = {"depth_cm": depth, "tenth": low, "median": middle, "nine_tenths": high}
        tables.append(pd.DataFrame({"packing": ensembles.name(across), "quantity": f"{label} over Janssen", **table}))
    numbers = pd.concat(tables)
    return numbers[np.isfinite(numbers["median"])]


def _factors(panel: Axes, silo: xr.Dataset, across: int, shift: float) -> pd.DataFrame:
    """Draws every kind of peak, a little aside of the other packings'; as a table."""
    rows = []
    for place, measure in enumerate(NAMES):
        kind = "look" if measure in silo["look"].values else "measure"
        values = silo["contact_overpressure" if kind == "look" else "wall_overpressure"].sel({kind: measure})
        low, middle, high = ensembles.spread(ensembles.runs(values))
        panel.errorbar(place + 0.18 * shift, middle, [[middle - low], [high - middle]], markersize=6, capsize=3,
                       linestyle="none", **LOOKS[across])  # fmt: skip
        quantity = NAMES[measure].replace("\n", " ")
        rows.append(
            {"packing": ensembles.name(across), "quantity": quantity, "tenth": low, "median": middle, "nine_tenths": high}
        )
    return pd.DataFrame(rows)


def code_factors() -> dict[str, float]:
    """Largest printed discharge pressure of each method of Table 4.2.5 over the largest of static Janssen there."""
    printed = table_4_2_5()
    static = max(value.wall_normal_pressure for value in printed if value.method == STATIC_COLUMN)
    factors: dict[str, float] = {}
    for value in printed:
        if value.phase == "discharge":
            factors[value.method] = max(factors.get(value.method, 0.0), value.wall_normal_pressure / static)
    return factors


def _codes(panel: Axes) -> pd.DataFrame:
    """The band of the codes, and the line of each with its name beside the panel."""
    factors = dict(sorted(code_factors().items(), key=lambda item: item[1]))
    panel.axhspan(1.0, max(factors.values()), color="#999999", alpha=0.18, linewidth=0)
    places = np.exp(apart(np.log(list(factors.values())), CLOSEST))
    for (method, factor), place in zip(factors.items(), places, strict=True):
        panel.axhline(factor, color="0.5", linewidth=0.7, linestyle=(0, (1, 2)))
        words = f"{method.replace('_', ' ')}: {factor:.2f}"
        panel.text(1.01, place, words, transform=panel.get_yaxis_transform(), fontsize="small", va="center")
    rows = [{"packing": "Table 4.2.5", "quantity": method, "median": factor} for method, factor in factors.items()]
    return pd.DataFrame(rows)
