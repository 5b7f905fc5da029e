"""Contact forces of every ideal packing at rest, after the source's Fig. 6."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures import discs
from silostudy.figures.style import WIDTH, foot, headline, save


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: largest and mean contact force and inclination of each packing, then every contact."""
    films = discs.films(cube, moving=False)
    columns = min(4, len(films))
    rows = -(-len(films) // columns)
    figure, panels = plt.subplots(
        rows, columns, figsize=(WIDTH, 1.3 + 1.12 * WIDTH / columns * rows), squeeze=False, sharex=True, sharey=True
    )
    for panel in panels.flat[len(films) :]:
        panel.axis("off")
    tables = [pd.DataFrame([_row(cube, film) for film in films])]
    for place, (panel, film) in enumerate(zip(panels.flat, films, strict=False)):
        snapshot = discs.frames(cube, film)[0]
        discs.draw_box(panel, cube, opened=False)
        contacts = discs.contacts(cube, snapshot)
        panel.add_collection(discs.chains(contacts))
        tables.append(contacts.assign(packing=tables[0].packing[place]))
        lowest, leftmost = place + columns >= len(films), place % columns == 0
        panel.set(xlabel="across (cm)" if lowest else "", ylabel="height (cm)" if leftmost else "")
        row = tables[0].iloc[place]
        panel.set_title(f"{row.packing}: at most {row.largest_disc_weights:.0f} disc weights", fontsize="small")
    headline(figure, _message(tables[0]))
    bar = f"Contact forces at rest, ideal starts: a line as long as a disc's diameter is {discs.DIAMETER_IS:.1f} disc weights "
    foot(figure, f"{cube.attrs['title']}.", f"{bar}({discs.DIAMETER_IS * discs.disc_weight(cube):.0f} N/m).")
    save(figure, pd.concat(tables, ignore_index=True), stem)


def _message(rows: pd.DataFrame) -> str:
    """Message: how the largest contact force and the inclination of contact forces differ from packing to packing."""
    strong, weak = (rows.loc[rows["largest_disc_weights"].agg(which)] for which in ("idxmax", "idxmin"))
    steep = rows["mean_inclination_deg"]
    forces = f"a contact carries at most {strong.largest_disc_weights:.0f} disc weights in {strong.packing} but "
    forces += f"{weak.largest_disc_weights:.0f} in {weak.packing}"
    return f"At rest {forces}; forces stand at {steep.min():.0f} to {steep.max():.0f}° on average"


def _row(cube: xr.Dataset, film: int) -> dict:
    here = cube["contact_snapshot"].values == discs.frames(cube, film)[0]
    x, y = (cube[f"contact_force_{way}"].values[here] for way in "xy")
    on_wall, size = cube["contact_on_wall"].values[here] == 1, np.hypot(x, y) / discs.disc_weight(cube)
    across = int(cube["film_across"][film])
    return {
        "packing": f"{across - 1}/{across}",
        "discs": int(np.isfinite(cube["disc_x"].values[discs.frames(cube, film)[0]]).sum()),
        "contacts": len(size),
        "largest_disc_weights": size.max(),
        "mean_between_discs_disc_weights": size[~on_wall].mean(),
        "mean_inclination_deg": np.degrees(np.average(np.arctan2(np.abs(y), np.abs(x))[~on_wall], weights=size[~on_wall])),
    }
