"""Resonance curves of the empty and the filled tube, and what the two resonances say about the contents."""

from pathlib import Path

import matplotlib.pyplot as plt
import pandas as pd
import xarray as xr

from silostudy.figures.shaken import cases, head
from silostudy.figures.style import BLACK, NAMED, REST, VERMILION, WIDTH, save
from silostudy.tables.sasaki_1991 import printed_tests

# curve -> its name, its look, and on which side of its peak the name stands
CURVES: dict[str, tuple[str, dict, str]] = {
    "empty": ("empty", {"color": BLACK, "linewidth": 1.8}, "left"),
    "full": ("full, by the shift", {"color": VERMILION, "linewidth": 2.4}, "left"),
    "all_contents": ("full, all of the contents", REST | {"linewidth": 1.8}, "right"),
}


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its curves; the sine sweep is that of the first case."""
    case = cases(cube)[0]
    figure, axes = plt.subplots(figsize=(WIDTH, 6.4))
    for curve in map(str, case["curve"].values):
        _draw(axes, case.sel(curve=curve), curve)
    if cube.attrs["published"] == "sasaki_1991":
        _printed(axes)
    axes.set(
        xlabel="frequency of the sine (Hz)",
        ylabel="amplitude of the top's acceleration (gal)",
        ylim=(0, 115 * float(case["resonance"].max())),
    )
    amplitude, damping = float(case["sine_base_acceleration"]) * 100, float(case["sine_damping_ratio"])
    base = f"Base: steady sine of {amplitude:g} gal. Curves computed with a damping ratio of {damping:g}."
    head(figure, cube, _message(case), _remark(cube, case), base=base)
    save(figure, _numbers(case), stem)


def _draw(axes, case: xr.Dataset, curve: str) -> None:
    """A resonance curve with its name at its peak."""
    words, look, side = CURVES[curve]
    frequency, amplitude = case["frequency"].values, case["resonance"].values * 100
    axes.plot(frequency, amplitude, gid=NAMED, **look)
    coefficient, first = float(case["sine_coefficient"]), float(case["sine_frequency"])
    text, offset = f"{words}\nC_eff = {coefficient:.3f}\nf1 = {first:.1f} Hz", 8 if side == "left" else -8
    axes.annotate(text, (frequency[amplitude.argmax()], amplitude.max()), (offset, 0), textcoords="offset points", ha=side,
                  va="top", fontsize="small")  # fmt: skip


def _printed(axes) -> None:
    """The source's resonances as marks on the frequency axis."""
    sine = printed_tests()["sine"]
    for frequency in (sine.empty_frequency, sine.full_frequency):
        axes.axvline(frequency, color="black", linewidth=0.7, linestyle=":")
        axes.annotate(f"source: {frequency:g} Hz", (frequency, 1.0), xycoords=("data", "axes fraction"), xytext=(4, -4),
                      textcoords="offset points", va="top", fontsize="small")  # fmt: skip


def _message(case: xr.Dataset) -> str:
    """Message: what the shift of the resonance means."""
    low, high = (float(case["sine_coefficient_bound"].sel(bound=end)) for end in ("lower", "upper"))
    empty, full = (float(case["sine_frequency"].sel(curve=curve)) for curve in ("empty", "full"))
    coefficient = float(case["sine_coefficient"].sel(curve="full"))
    shift = f"The shift from {empty:.3g} to {full:.3g} Hz means C_eff = {coefficient:.3f}"
    return f"{shift} ({low:.2f} to {high:.2f} by the rounding of both frequencies)"


def _remark(cube: xr.Dataset, case: xr.Dataset) -> str:
    if cube.attrs["published"] != "sasaki_1991":
        return ""
    coefficient = float(case["sine_coefficient"].sel(curve="full"))
    tests = printed_tests()
    ratios = " and ".join(f"{tests[name].implied_mass_ratio:.2f}" for name in ("earthquake_010g", "earthquake_023g"))
    return (
        f"The source prints {tests['sine'].effective_mass_coefficient:.2f}, but its earthquake rows imply contents of {ratios} "
        f"wall masses, with which its 33 Hz and 19 Hz give {coefficient:.3f}: compatible within the rounding, not confirmed."
    )


def _numbers(case: xr.Dataset) -> pd.DataFrame:
    table = (case["resonance"] * 100).to_dataframe("top_acceleration_gal").reset_index()
    return table[["curve", "frequency", "top_acceleration_gal"]].rename(columns={"frequency": "frequency_Hz"})
