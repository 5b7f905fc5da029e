"""Fourier amplitudes of the top's acceleration: measured, and computed with several coefficients, a column a case."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures.shaken import MEASURED, cases, distance, head, kind, name, nearest
from silostudy.figures.style import BLACK, TALLEST, VERMILION, WIDTH, save

ENERGY = (0.05, 0.95)  # the part of the band that is drawn holds this much of the measured energy, and a margin


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers (those of the whole band)."""
    columns = cases(cube)
    shown = list(map(float, cube["shown_coefficient"].values))
    figure, panels = plt.subplots(
        len(shown),
        len(columns),
        figsize=(WIDTH, min(TALLEST, 1.8 * len(shown) + 2.2)),
        sharex=True,
        sharey="col",
        squeeze=False,
    )
    for column, case in zip(panels.T, columns, strict=True):
        for panel, coefficient in zip(column, shown, strict=True):
            _panel(panel, case, coefficient)
        column[0].set_title(name(case))
        column[-1].set(xlabel="frequency at the model's scale (Hz)", ylim=(0, None))
    lows, highs = zip(*map(_limits, columns), strict=True)
    panels[0, 0].set_xlim(min(lows), max(highs))
    figure.supylabel("Fourier amplitude of the top's acceleration (cm/s)")
    low, high = cube.attrs["band_Hz"]
    about = (
        f"Grey: {' / '.join(dict.fromkeys(map(kind, columns)))}; line: computed, red with the coefficient next to that found. "
    )
    about += "Off: root mean square of the difference over that measured."
    band = f"The part of the indices' band ({low:g} to {high:g} Hz) that holds nine tenths of the energy."
    head(figure, cube, f"Computed spectra come closest {' and '.join(map(_told, columns))}", about, band)
    tables = [_numbers(case).assign(case=str(case["case"].values)) for case in columns]
    save(figure, pd.concat(tables, ignore_index=True), stem)


def _off(case: xr.Dataset, coefficient: float) -> float:
    """Distance (1) of a computed spectrum from the measured one."""
    return distance(case["top_spectrum"].sel(shown_coefficient=coefficient).values, case["measured_spectrum"].values)


def _told(case: xr.Dataset) -> str:
    """The shown coefficient that comes closest to the measured spectrum, and how close."""
    off = {float(c): _off(case, float(c)) for c in case["shown_coefficient"].values}
    closest = min(off, key=lambda coefficient: off[coefficient])
    return f"with C_eff = {closest:.2f} ({100 * off[closest]:.0f} % off)"


def _panel(panel, case: xr.Dataset, coefficient: float) -> None:
    frequency = case["spectrum_frequency"]
    panel.fill_between(frequency, case["measured_spectrum"] * 1e2, color=MEASURED, alpha=0.6, linewidth=0)
    amplitude = case["top_spectrum"].sel(shown_coefficient=coefficient) * 1e2
    best = coefficient == nearest(case)
    panel.plot(frequency, amplitude, linewidth=1.6 if best else 0.9, color=VERMILION if best else BLACK)
    text = f"C_eff = {coefficient:.2f}: {100 * _off(case, coefficient):.0f} % off"
    panel.text(0.01, 0.97, text, transform=panel.transAxes, va="top", fontsize="small")


def _limits(case: xr.Dataset) -> tuple[float, float]:
    """Frequencies (Hz) between which the measured energy lies, with a quarter of their distance on either side."""
    frequency, amplitude = case["spectrum_frequency"].values, np.nan_to_num(case["measured_spectrum"].values)
    energy = np.cumsum(amplitude**2) / np.sum(amplitude**2)
    low, high = (float(frequency[np.searchsorted(energy, share)]) for share in ENERGY)
    margin = (high - low) / 4
    return max(low - margin, float(np.nanmin(frequency))), min(high + margin, float(np.nanmax(frequency)))


def _numbers(case: xr.Dataset) -> pd.DataFrame:
    table = {"frequency_Hz": case["spectrum_frequency"].values, "measured_m_s": case["measured_spectrum"].values}
    for coefficient in map(float, case["shown_coefficient"].values):
        table[f"computed_{coefficient:.2f}_m_s"] = case["top_spectrum"].sel(shown_coefficient=coefficient).values
    return pd.DataFrame(table).dropna()
