"""Places of the discs and contact forces in discharge, after the source's Figs. 8 and 9."""

from pathlib import Path
from textwrap import fill

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures import discs
from silostudy.figures.style import WIDTH, foot, headline, save

TIMES = (0.0, 0.05, 0.1, 0.2, 0.4, 0.7)  # s: of these the source's text speaks
SCALE = 2 * discs.DIAMETER_IS  # disc weights a diameter: forces in flow are several times those at rest


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: discs left, largest and mean force of each time, then every disc and contact."""
    films = shown(cube)
    figure, panels = plt.subplots(
        2 * len(films), len(TIMES), figsize=(WIDTH, 1.4 + 3.9 * len(films)), squeeze=False, sharex=True, sharey=True
    )
    rows, tables = [], []
    for row, film in enumerate(films):
        for column, snapshot in enumerate(_snapshots(cube, film)):
            place, force = panels[2 * row, column], panels[2 * row + 1, column]
            time = float(cube["snapshot_time"][snapshot])
            for panel in (place, force):
                discs.draw_box(panel, cube, opened=time > 0)
                panel.set_xticks([0, 20, 40])
            place.add_collection(discs.circles(cube, snapshot, place, facecolors="#d9d9d9", edgecolors="black", linewidths=0.3))
            contacts = discs.contacts(cube, snapshot, scale=SCALE)
            force.add_collection(discs.chains(contacts, scale=SCALE))
            place.set_title(f"t = {time:.3g} s")
            rows.append(_row(cube, film, snapshot))
            tables += [part.assign(film=rows[-1]["film"], time_s=time) for part in (discs.centres(cube, snapshot), contacts)]
        panels[2 * row, 0].set_ylabel(fill(discs.name(cube, film), 24) + "\nheight (cm)")
        panels[2 * row + 1, 0].set_ylabel("height (cm)")
    for panel in panels[-1]:
        panel.set_xlabel("across (cm)")
    numbers = pd.DataFrame(rows)
    headline(figure, _message(numbers))
    bar = (
        f"Places of the discs, and below them contact forces: a line as long as a disc's diameter is {SCALE:.1f} disc weights "
    )
    foot(figure, f"{cube.attrs['title']}.", f"{bar}({SCALE * discs.disc_weight(cube):.0f} N/m).")
    save(figure, pd.concat([numbers, *tables], ignore_index=True), stem)


def _message(numbers: pd.DataFrame) -> str:
    """Film by film, how far the largest contact force rises in flow, when, and how many discs have left by the end."""
    told = []
    for _, film in numbers.groupby("film", sort=False):
        top = film.loc[film["largest_force_disc_weights"].idxmax()]
        rise = top.largest_force_disc_weights / film["largest_force_disc_weights"].iloc[0]
        left = int(film["discs_above_floor"].iloc[0] - film["discs_above_floor"].iloc[-1])
        told.append(f"{film['film'].iloc[0].split(',')[0]}: {rise:.1f} times rest at {top.time_s:.2g} s, {left} discs out")
    return f"The largest contact force shown, and the discs that left: {'; '.join(told)}"


def shown(cube: xr.Dataset) -> list[int]:
    """Films of a discharge, the one with the remedy in the place of that without."""
    last: dict[tuple[int, int], int] = {}
    for film in discs.films(cube, moving=True):
        last[int(cube["film_across"][film]), int(cube["film_run"][film])] = film
    return list(last.values())


def _snapshots(cube: xr.Dataset, film: int) -> list[int]:
    """The film's snapshots next to the times."""
    own = discs.frames(cube, film)
    time = cube["snapshot_time"].values[own]
    return [int(own[np.argmin(np.abs(time - wanted))]) for wanted in TIMES]


def _row(cube: xr.Dataset, film: int, snapshot: int) -> dict:
    here = cube["contact_snapshot"].values == snapshot
    size = np.hypot(cube["contact_force_x"].values[here], cube["contact_force_y"].values[here]) / discs.disc_weight(cube)
    return {
        "film": discs.name(cube, film), "time_s": float(cube["snapshot_time"][snapshot]),
        "discs_above_floor": int((cube["disc_y"].values[snapshot] > 0).sum()),
        "largest_force_disc_weights": size.max(), "mean_force_disc_weights": size.mean(),
    }  # fmt: skip
