"""Fields of a bin of spheres over radius and height: before the outlet opens left of the axis, in discharge right."""

from itertools import takewhile
from pathlib import Path
from textwrap import fill

import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.collections import QuadMesh
from matplotlib.figure import Figure
from matplotlib.patches import Polygon

from silostudy.errors import BadInput
from silostudy.figures import bin as bins
from silostudy.figures import silo_cut
from silostudy.figures.style import AID, TALLEST, WIDTH, foot, headline, plt, save

CM = 100.0  # of a metre
KPA = 1e3  # Pa
THIN = 0.1  # of the largest solid fraction: cells with less are empty
FILLED = 0.5  # of the same: cells with less have no ratio of stresses
SHOWN = {
    "solid_fraction": ("solid over whole volume", "viridis"),
    "speed_m_s": ("speed (m/s)", "YlOrRd"),
    "vertical_stress_kPa": ("vertical stress (kPa)", "cividis"),
    "stress_ratio": ("lateral over vertical stress", "magma_r"),
}
FLOW = "in discharge"
LETTERS = 16  # of a line of words over half a panel, of four beside each other
LOW = 0.5  # of the width: panels of a lower silo stand in two rows, twice as wide
# inches: width of a panel, height of what stands over and under it, and over and under all of them
WIDE = {4: 2.25, 2: 4.6}
BESIDE = 1.7
AROUND = 1.1


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and the fields of both phases as CSV."""
    cells = phases(cube)
    half, top = (float(cube.attrs[name]) * CM for name in ("half_width_m", "top_height_m"))
    high = min(top, 1.1 * float(cells["height_cm"][cells["solid_fraction"].notna()].max()))
    high = silo_cut.inside(cube)[:, 1].max(initial=high / CM) * CM
    flows, before = cells["phase"].nunique() > 1, bins.before(cube)
    figure, panels = _lay_out(high / (2.0 * half))
    for panel, (name, (label, colours)) in zip(panels.flat, SHOWN.items(), strict=True):
        mesh = _halves(panel, cells, name, colours, silo_cut.outline_of(cube))
        silo_cut.draw(panel, cube, 0.0, folded=True)
        panel.set(xlabel="from the axis (cm)", xlim=(-half - 0.3, half + 0.3), ylim=(-0.3, high), aspect="equal")
        panel.xaxis.set_major_formatter(lambda value, _: f"{abs(value):g}")
        panel.axvline(0.0, color="white", linewidth=0.8, gid=AID)
        for side, told in {"left": fill(before, LETTERS), "right": FLOW}.items() if flows else [("center", before)]:
            panel.set_title(told, loc=side)
        panel.grid(False)
        figure.colorbar(mesh, ax=panel, location="bottom", label=label, shrink=0.9)
    for panel in panels[:, 0]:
        panel.set_ylabel("height (cm)")
    headline(figure, _message(cube, cells, before))
    cut = " Inserts as the slice through the axis cuts them, on both sides of it." if "insert_x" in cube else ""
    fade = f"Within {_reach(cube):.1f} cm of walls and surface the kernel reaches beyond them: fields fade.{cut}"
    foot(figure, f"{cube.attrs['title']}{f'; {bins.EARLY_WORDS}{_readings(cube)}' if flows else ''}.", fade)
    _close_up(figure, panels)
    save(figure, cells, stem)


def _readings(cube: xr.Dataset) -> str:
    """Words on which readings of the fields are in discharge: how many, and when."""
    times = cube["field_time"].values[_flowing(cube)]
    if len(times) == 1:
        return f", one reading alone, {times[0] - bins.opened_at(cube):.2g} s after the opening"
    return f", the mean of {len(times)} readings from {times[0]:.3g} to {times[-1]:.3g} s"


def _flowing(cube: xr.Dataset) -> np.ndarray:
    """Numbers of the readings of the fields in discharge."""
    time = cube["field_time"].values
    return bins.in_discharge(cube, time > bins.opened_at(cube), time)


def _close_up(figure: Figure, panels: np.ndarray) -> None:
    """Takes from the height of a figure what its panels, as wide as they can be, leave empty."""
    figure.draw_without_rendering()
    high = figure.bbox.height
    empty = [max(0.0, panel.get_position(original=True).y1 * high - panel.get_tightbbox().y1) for panel in panels[:, 0]]
    figure.set_figheight(figure.get_figheight() * (1.0 - sum(empty) / high))


def _lay_out(slender: float) -> tuple[Figure, np.ndarray]:
    """Figure and panels, beside each other or, of a silo that is low for its width, in two rows; slender: height over width."""
    rows = 1 if slender > LOW else 2
    columns = len(SHOWN) // rows
    high = min(TALLEST, AROUND + rows * (BESIDE + WIDE[columns] * slender))
    return plt.subplots(rows, columns, figsize=(WIDTH, high), sharey=True, squeeze=False)


def phases(cube: xr.Dataset) -> pd.DataFrame:
    """A row a cell and phase: place, solid fraction, speed, vertical stress, lateral over vertical stress.

    Before: the last reading before the outlet opened, or of the run; discharge: the mean of the readings in it.
    """
    if "field_r" not in cube:
        raise BadInput("record.fields.cells", "three numbers", "must be two, of distance and height, for this figure")
    time, opened, before = cube["field_time"].values, bins.opened_at(cube), bins.before(cube)
    rest, flow = np.flatnonzero(time <= opened)[-1:], _flowing(cube)
    if not len(rest):
        raise BadInput("record.fields.every_s", float(time[0]), f"must be short enough for a reading {before}")
    tables = [_phase(cube.isel(field_time=rest), before)]
    tables += [_phase(cube.isel(field_time=flow), FLOW)] if len(flow) else []
    return pd.concat(tables, ignore_index=True)


def _phase(cube: xr.Dataset, name: str) -> pd.DataFrame:
    """The cells of some readings on average: velocities by mass, stresses by volume."""
    density = cube["field_density"]
    momentum = (density * cube["field_velocity"].fillna(0.0)).mean("field_time")
    mean, fraction = density.mean("field_time"), cube["field_solid_fraction"].mean("field_time").values
    stress = (cube["field_contact_stress"] + cube["field_kinetic_stress"]).mean("field_time")
    across, upright = (stress.sel(field_way=way, field_of=way).values for way in ("r", "z"))
    there, bulk = fraction > THIN * fraction.max(), (fraction > FILLED * fraction.max()) & (upright > 0.02 * upright.max())
    speed = np.sqrt((momentum**2).sum("field_way")) / mean.where(mean > 0.0)
    return pd.DataFrame({
        "phase": name,
        "distance_cm": cube["field_r"].values * CM,
        "height_cm": cube["field_z"].values * CM,
        "solid_fraction": np.where(there, fraction, np.nan),
        "speed_m_s": np.where(there, speed, np.nan),
        "vertical_stress_kPa": np.where(there, upright / KPA, np.nan),
        "stress_ratio": np.divide(across, upright, out=np.full_like(upright, np.nan), where=bulk),
        "volume_cm3": cube["field_cell_volume"].values * CM**3,
    })  # fmt: skip


def _halves(panel: Axes, cells: pd.DataFrame, name: str, colours: str, inside: np.ndarray) -> QuadMesh:
    """Cells of the phases left and right of the axis, cut off at the walls; without a discharge both sides are alike."""
    r, z = np.unique(cells["distance_cm"]), np.unique(cells["height_cm"])
    sides = [part[name].to_numpy().reshape(len(r), len(z)).T for _, part in cells.groupby("phase", sort=False)]
    edges = _edges(r)
    shown = cells[name][cells["height_cm"] > 0.0]  # not what falls below the outlet
    mesh = panel.pcolormesh(
        np.append(-edges[:0:-1], edges), _edges(z), np.hstack([sides[0][:, ::-1], sides[-1]]), cmap=colours,
        vmin=0.0, vmax=float(shown.quantile(0.99)),
    )  # fmt: skip
    mesh.set_clip_path(Polygon(inside * CM, transform=panel.transData))
    return mesh


def _edges(middles: np.ndarray) -> np.ndarray:
    """Edges of equal cells from their middles."""
    half = 0.5 * (middles[1] - middles[0]) if len(middles) > 1 else middles[0]
    return np.append(middles - half, middles[-1] + half)


def _message(cube: xr.Dataset, cells: pd.DataFrame, before: str) -> str:
    """Message: means over the bulk between the upright walls, away from them; before: words on what is not in discharge."""
    low, half = (float(cube.attrs[name]) * CM for name in ("transition_height_m", "half_width_m"))
    if not (cells["solid_fraction"].notna() & (cells["height_cm"] > low)).any():
        return "No solid stands between the upright walls"
    parts = list(takewhile(lambda part: _inside(cube, part), (part for _, part in cells.groupby("phase", sort=False))))
    if not parts:
        return (
            f"All that stands between the upright walls is within {_reach(cube):.1f} cm of walls or surface, where fields fade"
        )
    parts = [part[(part["height_cm"] > low) & (part["distance_cm"] < half - _reach(cube))] for part in parts]
    parts = [part[part["stress_ratio"].notna()] for part in parts]
    ratios = [np.average(part["stress_ratio"], weights=part["vertical_stress_kPa"] * part["volume_cm3"]) for part in parts]
    fractions = [np.average(part["solid_fraction"], weights=part["volume_cm3"]) for part in parts]
    ratio = "the ratio of lateral to vertical stress between the upright walls"
    if len(parts) < 2:
        return f"{before.capitalize()} {ratio} is {ratios[0]:.2f}, the solid fraction {fractions[0]:.2f}"
    return f"In discharge {ratio} {_went(ratios)}, the solid fraction {_went(fractions)}"


def _inside(cube: xr.Dataset, part: pd.DataFrame) -> bool:
    """Whether a phase has bulk between the upright walls that the kernel reaches neither walls, floor nor surface from."""
    low, half = (float(cube.attrs[name]) * CM for name in ("transition_height_m", "half_width_m"))
    reach, dense = _reach(cube), part["solid_fraction"] > FILLED * part["solid_fraction"].max()
    low += 0.0 if low > 0.0 else reach  # without a hopper the floor is there
    away = (part["distance_cm"] < half - reach) & part["height_cm"].between(low, part["height_cm"][dense].max() - reach)
    return bool((away & part["stress_ratio"].notna()).any())


def _went(values: list) -> str:
    """Change of a number, in words."""
    before, after = (f"{value:.2f}" for value in values)
    if before == after:
        return f"stays at {before}"
    return f"{'rises' if values[1] > values[0] else 'falls'} from {before} to {after}"


def _reach(cube: xr.Dataset) -> float:
    """Distance (cm) over which the kernel spreads what a grain has."""
    return 2.0 * float(cube.attrs["field_width_m"]) * CM
