"""A bin of spheres as figures see it: its walls' cells, its phases, the column at rest and Janssen's curve for it."""

from dataclasses import dataclass

import numpy as np
import pandas as pd
import xarray as xr

from silostudy.cube.contents import levelled
from silostudy.errors import BadInput

WALLS = ("wall", "hopper")  # surfaces whose names begin so are walls
EARLY = 0.25  # share of the solid: what figures call discharge ends when so much is out, since an empty bin presses on nothing
LEVELS = 2  # heights of wall cells that the solid is to stand against at least, for a curve over depth
SHORT = 0.25  # of the longest window: the mean of a shorter one jumps more than those of the others
OPENS = ": open_"  # of an event that opens an outlet
REST = "at rest"
AT_END = "at the end"
TURNING = "while surfaces turn"
FLOWING = "while grains flow"
EARLY_WORDS = "in discharge: until a quarter of the solid is out"


def opened_at(cube: xr.Dataset) -> float:
    """Time (s) at which the outlet opened; endless where it did not."""
    done = zip(cube["event_time"].values, cube["event_action"].values, strict=True)
    return float(min((time for time, action in done if OPENS in str(action)), default=np.inf))


def opening(cube: xr.Dataset) -> str:
    """Words on what opens at `opened_at`: the outlet, one of those with names, the first of them, or all at once."""
    if cube.sizes.get("outlet", 1) == 1:
        return "the outlet opens"
    times = cube["outlet_opened"].values[cube["outlet_opened"].values >= began(cube)]
    if len(times) < 2:
        return "an outlet opens"
    return "the outlets open" if len(np.unique(times)) == 1 else "the first outlet opens"


def began(cube: xr.Dataset) -> float:
    """Time (s) at which the run began: later than 0 where it goes on from another."""
    return float(cube.attrs.get("began_s", 0.0))


def windows(cube: xr.Dataset) -> tuple[np.ndarray, np.ndarray]:
    """Starts (s) of the windows of forces, and whether each is about as long as the others: the last may not be."""
    starts = np.append(began(cube), cube["window_time"].values[:-1])
    lasts = cube["window_time"].values - starts
    return starts, lasts >= SHORT * lasts.max(initial=0.0)


def open_before(cube: xr.Dataset) -> np.ndarray:
    """Whether each outlet, or that without a name, had opened before the run began, which goes on from another."""
    opened = cube["outlet_opened"].values if "outlet" in cube else cube.attrs.get("outlet_opened_s", np.inf)
    return np.atleast_1d(opened) < began(cube)


def in_discharge(cube: xr.Dataset, after: np.ndarray, time: np.ndarray) -> np.ndarray:
    """Numbers of readings after the opening (mask) that end (s) before EARLY of the solid is out, and of the first."""
    flow = np.flatnonzero(after)
    if "outflow_mass" not in cube:
        return flow
    late = cube["outflow_time"].values[cube["outflow_mass"].values > EARLY * float(cube["grain_mass"].sum())]
    return flow[(time[flow] <= min(late, default=np.inf)) | (flow == flow[:1])]


def phases(cube: xr.Dataset) -> pd.DataFrame:
    """A row a wall cell: surface, place, area, and pressure (Pa) before, in discharge on average and at most.

    Before (columns of rest): the last whole window before the outlet opened, or of the run; discharge: see in_discharge.
    """
    time, opened, (begun, long) = cube["window_time"].values, opened_at(cube), windows(cube)
    rest, flow = np.flatnonzero((time <= opened) & long), in_discharge(cube, (begun >= opened) & long, time)
    if not len(rest):
        raise BadInput("record.wall_force_window_s", float(time[0]), f"must be short enough for a window {before(cube)}")
    names = cube["wall_name"].values.astype(str)
    walls = np.flatnonzero([name.startswith(WALLS) for name in names])
    mean, most, shear = (
        cube[f"wall_{name}"].values[:, walls] for name in ("pressure_mean", "pressure_max", "shear_stress_mean")
    )
    nothing = np.full(len(walls), np.nan)
    return pd.DataFrame({
        "surface": names[walls],
        "height_m": cube["wall_cell_z"].values[walls].round(9),
        "angle_deg": np.degrees(cube["wall_cell_turn"].values[walls]),
        "area_m2": cube["wall_cell_area"].values[walls],
        "pressure_rest_Pa": mean[rest[-1]],
        "shear_rest_Pa": shear[rest[-1]],
        "pressure_discharge_Pa": mean[flow].mean(axis=0) if len(flow) else nothing,
        "peak_discharge_Pa": most[flow].max(axis=0) if len(flow) else nothing,
    })  # fmt: skip


def before(cube: xr.Dataset) -> str:
    """Words on the window before an outlet opens: while grains flow already or surfaces turn, as of a drum, or at rest.

    At rest is what the last event until then waited for; of what was not waited for, only the moment is said.
    """
    if open_before(cube).any():
        return FLOWING
    opened = opened_at(cube)
    if "surface_spin" in cube:
        last = np.flatnonzero((cube["window_time"].values <= opened) & windows(cube)[1])[-1:]
        if cube["surface_spin"].values[last].any():
            return TURNING
    happened = cube["event_action"].values[cube["event_time"].values <= opened]
    if any(str(action).startswith("rest: ") for action in happened[-1:]):
        return REST
    return f"before {opening(cube)}" if np.isfinite(opened) else AT_END


def profile(cells: pd.DataFrame) -> pd.DataFrame:
    """Means over the angle, weighted by area: a row a height and kind of surface."""
    kind = cells["surface"].str.split("_").str[0]
    columns = [name for name in cells.columns if name.endswith("_Pa")]
    weighted = cells[columns].multiply(cells["area_m2"], axis=0).assign(area=cells["area_m2"])
    total = weighted.groupby([kind.rename("surface"), cells["height_m"]]).sum(min_count=1)
    return total[columns].div(total["area"], axis=0).reset_index()


@dataclass(frozen=True)
class Column:
    """The solid above the transition before the outlet opens: height of its level surface (m), unit weight (N/m3), and as they
    act there wall friction and lateral pressure ratio (1)."""

    surface: float
    unit_weight: float
    wall_friction: float
    lateral_pressure_ratio: float


def column(cube: xr.Dataset, cells: pd.DataFrame) -> Column | None:
    """The column from the spheres of the last snapshot before the outlet opened; None where none stand above the transition.

    Vertical pressure is the weight above a height less the wall's shear, over the plan.
    """
    shots = np.flatnonzero(cube["snapshot_time"].values <= opened_at(cube))
    above = profile(cells[cells["surface"].str.startswith("wall")])
    if not len(shots) or not len(above):
        return None
    low, area, radius = (float(cube.attrs[name]) for name in ("transition_height_m", "plan_area_m2", "hydraulic_radius_m"))
    z, weight = cube["grain_z"].values[shots[-1]], -cube["grain_mass"].values * float(cube.attrs["gravity_z_m_s2"])
    surface, unit_weight = levelled(z, weight, low, area)
    if np.isnan(surface):
        return None
    touched = above[above["height_m"] < surface]
    normal, shear = touched["pressure_rest_Pa"].to_numpy(), touched["shear_rest_Pa"].to_numpy()
    if not len(touched) or not normal.sum() > 0.0:
        return None
    step = np.diff(touched["height_m"], append=surface)
    carried = (shear * step)[::-1].cumsum()[::-1] / radius  # Pa, from the surface down to each cell
    vertical = unit_weight * (surface - touched["height_m"].to_numpy()) - carried
    return Column(surface, unit_weight, float(shear.sum() / normal.sum()), float(normal.sum() / vertical.sum()))


def doubt(of: Column, cube: xr.Dataset, cells: pd.DataFrame) -> str:
    """Reason why Janssen's curve says nothing of a column; empty where it does: too shallow, or forces no pipe has at rest."""
    when = before(cube)
    deep, half = of.surface - float(cube.attrs["transition_height_m"]), 2.0 * float(cube.attrs["hydraulic_radius_m"])
    heights = cells["height_m"][cells["surface"].str.startswith("wall")]
    levels = int(heights[heights < of.surface].nunique())
    if deep < half or levels < LEVELS:
        shallow = (
            f"less than half a diameter, {half:.2g} m" if deep < half else f"{levels} of at least {LEVELS} levels of wall cells"
        )
        return f"the solid stands {deep:.2g} m deep against the upright walls, {shallow}"
    if when in (TURNING, FLOWING):
        return f"no column rests {when}"
    if of.wall_friction < 0.0:
        return f"{when} the walls press the solid down, with a friction of {of.wall_friction:.2g}"
    return "" if of.lateral_pressure_ratio > 0.0 else f"K {when} comes out as {of.lateral_pressure_ratio:.2g}"


def janssen(depth: np.ndarray, of: Column, hydraulic_radius: float) -> np.ndarray:
    """Horizontal wall pressure (Pa) at a depth (m) below the surface of a column; silo_handbook, section 4.2.2 (a)."""
    if not of.wall_friction > 0.0:
        return of.lateral_pressure_ratio * of.unit_weight * depth
    full = of.unit_weight * hydraulic_radius / of.wall_friction
    return full * -np.expm1(-of.lateral_pressure_ratio * of.wall_friction * depth / hydraulic_radius)
