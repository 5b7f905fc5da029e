"""Likeness indices over the effective mass coefficient, normalised by their value at the last one, with f1 written in."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures.shaken import answer, cases, head, name, printed, style
from silostudy.figures.style import save

INDICES = {  # what each is, and the width of its line
    "amplitude_error": ("e_A, Fourier amplitudes", 1.8),
    "phase_error": ("e_P, wrapped phase differences", 1.8),
    "phase_error_as_printed": ("e_P divided by the phase, as the source prints it", 1.0),
}
F1_LABELS = 6  # frequencies written along the top


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers."""
    columns = cases(cube)
    figure, panels = plt.subplots(1, len(columns), figsize=(5.6 * len(columns) + 1, 6.0), squeeze=False, sharey=True)
    tables = []
    for panel, one in zip(panels[0], columns, strict=True):
        _curves(panel, one, label=panel is panels[0, 0])
        _frequencies(panel, one)
        _answers(panel, one, printed(cube, one))
        panel.set_title(f"{name(one)}; damping ratio {float(one['damping_ratio']):.3f}", fontsize=9)
        panel.set(xlabel="effective mass coefficient C_eff", ylim=(0, 1.4))
        tables.append(_numbers(one).assign(case=str(one["case"].values)))
    last = float(cube["coefficient"][-1])
    panels[0, 0].set_ylabel(f"index over its value at C_eff = {last:.2f}")
    panels[0, 0].legend(loc="upper right", fontsize=8)
    low, high = cube.attrs["band_Hz"]
    head(figure, cube, f"likeness of measured and computed top acceleration, {low:g} to {high:g} Hz, whole record")
    save(figure, pd.concat(tables, ignore_index=True), stem)


def _curves(panel, one: xr.Dataset, label: bool) -> None:
    for number, (index, (title, width)) in enumerate(INDICES.items()):
        values = one[index] / one[index][-1]
        panel.plot(one["coefficient"], values, linewidth=width, label=title if label else None, **style(number))


def _frequencies(panel, one: xr.Dataset) -> None:
    """The first frequency of each coefficient along the top edge."""
    top = panel.secondary_xaxis("top")
    every = slice(None, None, max(1, (one.sizes["coefficient"] - 1) // (F1_LABELS - 1)))
    top.set_xticks(one["coefficient"].values[every], [f"{f:.1f}" for f in one["candidate_frequency"].values[every]])
    top.set_xlabel("first frequency f1 (Hz)")


def _answers(panel, one: xr.Dataset, source) -> None:
    """Where the indices are least, and the source's own answer."""
    keys, values = one["identification"].values, one["effective_mass_coefficient"].values
    found = {str(key): float(value) for key, value in zip(keys, values, strict=True)}
    lines = [
        f"▲ least e_A: {answer(one, 'amplitude_error', 'uncertainty')}",
        f"   coarse: {answer(one, 'amplitude_error_coarse', 'coarse_uncertainty', 2)}",
        f"least e_P: {answer(one, 'phase_error')}; coarse {answer(one, 'phase_error_coarse', places=2)}",
    ]
    apart = abs(found["amplitude_error"] - found["phase_error"])
    known = np.isfinite(float(one["uncertainty"]))  # an open interval judges nothing
    judged = ("agree" if apart <= float(one["uncertainty"]) else "DISAGREE") if known else "are not judged"
    lines.append(f"e_A and e_P {judged}: {apart:.3f} apart")
    if source:
        lines.append(
            f"dotted: source, really measured: {source.effective_mass_coefficient:.2f}, f1 = {source.full_frequency:g} Hz"
        )
        lines.append(f"(implies contents of {source.implied_mass_ratio:.2f} wall masses)")
        panel.axvline(source.effective_mass_coefficient, color="black", linewidth=0.9, linestyle=":")
    panel.plot(found["amplitude_error"], 0, marker="^", color="black", clip_on=False, markersize=8, linestyle="none",
               transform=panel.get_xaxis_transform())  # fmt: skip
    panel.text(0.98, 0.03, "\n".join(lines), transform=panel.transAxes, ha="right", va="bottom", fontsize=7,
               bbox={"color": "white", "alpha": 0.85})  # fmt: skip


def _numbers(one: xr.Dataset) -> pd.DataFrame:
    names = ["candidate_frequency", *INDICES]
    table = one[names].to_dataframe().reset_index()[["coefficient", *names]]
    for index in INDICES:
        table[f"{index}_normalised"] = table[index] / table[index].iloc[-1]
    return table.rename(columns={"candidate_frequency": "f1_Hz"})
