"""Fourier amplitudes of the top's acceleration: measured, and computed with several coefficients, a column a case."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures.shaken import MEASURED, cases, head, kind, name
from silostudy.figures.style import save

ENERGY = (0.05, 0.95)  # the part of the band that is drawn holds this much of the measured energy, and a margin


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers (those of the whole band)."""
    columns = cases(cube)
    shown = list(map(float, cube["shown_coefficient"].values))
    figure, panels = plt.subplots(
        len(shown), len(columns), figsize=(5.6 * len(columns) + 1, 8.5), sharex=True, sharey="col", squeeze=False
    )
    for column, one in zip(panels.T, columns, strict=True):
        for panel, coefficient in zip(column, shown, strict=True):
            _panel(panel, one, coefficient)
        column[0].set_title(name(one))
        column[-1].set(xlabel="frequency at the model's scale (Hz)", ylim=(0, None))
    lows, highs = zip(*map(_limits, columns), strict=True)
    panels[0, 0].set_xlim(min(lows), max(highs))
    figure.supylabel("Fourier amplitude of the top's acceleration (cm/s)", fontsize=9)
    panels[0, 0].legend(fontsize=8, loc="upper right")
    low, high = cube.attrs["band_Hz"]
    head(
        figure,
        cube,
        f"Fourier spectra, the part of the indices' band ({low:g} to {high:g} Hz) that holds nine tenths of the energy",
    )
    tables = [_numbers(one).assign(case=str(one["case"].values)) for one in columns]
    save(figure, pd.concat(tables, ignore_index=True), stem)


def _panel(panel, one: xr.Dataset, coefficient: float) -> None:
    frequency = one["spectrum_frequency"]
    panel.fill_between(frequency, one["measured_spectrum"] * 1e2, color=MEASURED, alpha=0.6, linewidth=0, label=kind(one))
    amplitude = one["top_spectrum"].sel(shown_coefficient=coefficient) * 1e2
    panel.plot(frequency, amplitude, linewidth=0.9, color="black", label="computed")
    panel.text(0.01, 0.95, f"C_eff = {coefficient:.2f}", transform=panel.transAxes, va="top", fontsize=9)


def _limits(one: xr.Dataset) -> tuple[float, float]:
    """Frequencies (Hz) between which the measured energy lies, with a quarter of their distance on either side."""
    frequency, amplitude = one["spectrum_frequency"].values, np.nan_to_num(one["measured_spectrum"].values)
    energy = np.cumsum(amplitude**2) / np.sum(amplitude**2)
    low, high = (float(frequency[np.searchsorted(energy, share)]) for share in ENERGY)
    margin = (high - low) / 4
    return max(low - margin, float(np.nanmin(frequency))), min(high + margin, float(np.nanmax(frequency)))


def _numbers(one: xr.Dataset) -> pd.DataFrame:
    table = {"frequency_Hz": one["spectrum_frequency"].values, "measured_m_s": one["measured_spectrum"].values}
    for coefficient in map(float, one["shown_coefficient"].values):
        table[f"computed_{coefficient:.2f}_m_s"] = one["top_spectrum"].sel(shown_coefficient=coefficient).values
    return pd.DataFrame(table).dropna()
