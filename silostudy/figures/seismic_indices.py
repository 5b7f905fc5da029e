"""Likeness indices over the effective mass coefficient, normalised by their value at the last one, with f1 written in."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures.shaken import answer, cases, head, name, printed
from silostudy.figures.style import BLUE, GREEN, VERMILION, WIDTH, save

INDICES: dict[str, tuple[str, dict]] = {  # what each is, and its line
    "amplitude_error": ("e_A, Fourier amplitudes", {"color": BLUE, "linewidth": 2.2}),
    "phase_error": ("e_P, wrapped phase differences", {"color": VERMILION, "linewidth": 1.8, "linestyle": (0, (6, 2))}),
    "phase_error_as_printed": (
        "e_P divided by the phase, as the source prints it",
        {"color": GREEN, "linewidth": 1.0, "linestyle": (0, (3, 1.5, 1, 1.5))},
    ),
}
F1_LABELS = 6  # frequencies written along the top


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers."""
    columns = cases(cube)
    figure, panels = plt.subplots(1, len(columns), figsize=(WIDTH, 6.8), squeeze=False, sharey=True)
    for panel, case in zip(panels[0], columns, strict=True):
        _curves(panel, case)
        _frequencies(panel, case)
        _mark(panel, case, printed(cube, case))
        panel.set_title(f"{name(case)}; damping ratio {float(case['damping_ratio']):.3f}")
        panel.set(xlabel="effective mass coefficient C_eff", ylim=(0, 1.4))
    tables = [_numbers(case).assign(case=str(case["case"].values)) for case in columns]
    last = float(cube["coefficient"][-1])
    panels[0, 0].set_ylabel(f"index over its value at C_eff = {last:.2f}")
    low, high = cube.attrs["band_Hz"]
    about = f"Likeness of measured and computed top acceleration, {low:g} to {high:g} Hz, whole record; triangle: least e_A."
    answers = [_answers(case, printed(cube, case)) for case in columns]
    handles = panels[0, 0].get_legend_handles_labels()[0]
    head(figure, cube, _message(columns), about, *answers, handles=handles)
    save(figure, pd.concat(tables, ignore_index=True), stem)


def _message(columns: list[xr.Dataset]) -> str:
    """Message: where the amplitudes of each case are most alike, and how far from that its phases are."""
    answers = " and ".join(answer(case, "amplitude_error", "uncertainty") for case in columns)
    return f"Amplitudes are most alike at C_eff = {answers}; phases agree within {max(map(_apart, columns)):.3f}"


def _apart(case: xr.Dataset) -> float:
    """Distance of the two indices' answers (1)."""
    by_amplitude, by_phase = (
        float(case["effective_mass_coefficient"].sel(identification=key)) for key in ("amplitude_error", "phase_error")
    )
    return abs(by_amplitude - by_phase)


def _curves(panel, case: xr.Dataset) -> None:
    for index, (title, look) in INDICES.items():
        panel.plot(case["coefficient"], case[index] / case[index][-1], label=title, **look)


def _frequencies(panel, case: xr.Dataset) -> None:
    """The first frequency of each coefficient along the top edge."""
    top = panel.secondary_xaxis("top")
    every = slice(None, None, max(1, (case.sizes["coefficient"] - 1) // (F1_LABELS - 1)))
    top.set_xticks(case["coefficient"].values[every], [f"{f:.1f}" for f in case["candidate_frequency"].values[every]])
    top.set_xlabel("first frequency f1 (Hz)")


def _mark(panel, case: xr.Dataset, source) -> None:
    """Marks where the amplitudes' index is least, and the source's own answer."""
    least = float(case["effective_mass_coefficient"].sel(identification="amplitude_error"))
    if source:
        panel.axvline(source.effective_mass_coefficient, color="black", linewidth=0.9, linestyle=":")
    panel.plot(least, 0, marker="^", color="black", clip_on=False, markersize=9, linestyle="none",
               transform=panel.get_xaxis_transform())  # fmt: skip


def _answers(case: xr.Dataset, source) -> str:
    """Answer of the indices of a case, and the source's own answer, in a sentence."""
    coarse = answer(case, "amplitude_error_coarse", "coarse_uncertainty", 2)
    phases = f"{answer(case, 'phase_error')} (coarse {answer(case, 'phase_error_coarse', places=2)})"
    known = np.isfinite(float(case["uncertainty"]))  # an open interval judges nothing
    judged = ("agree" if _apart(case) <= float(case["uncertainty"]) else "DISAGREE") if known else "are not judged"
    least = f"least e_A {answer(case, 'amplitude_error', 'uncertainty')} (coarse {coarse}), least e_P {phases}"
    text = f"{name(case)}: {least}; they {judged}, {_apart(case):.3f} apart."
    if source:
        text += f" Dotted: source, really measured: {source.effective_mass_coefficient:.2f}, f1 = {source.full_frequency:g} Hz "
        text += f"(implies contents of {source.implied_mass_ratio:.2f} wall masses)."
    return text[0].upper() + text[1:]


def _numbers(case: xr.Dataset) -> pd.DataFrame:
    names = ["candidate_frequency", *INDICES]
    table = case[names].to_dataframe().reset_index()[["coefficient", *names]]
    for index in INDICES:
        table[f"{index}_normalised"] = table[index] / table[index].iloc[-1]
    return table.rename(columns={"candidate_frequency": "f1_Hz"})
