"""Measurements of a run of a packing study: wall forces at rest, their peaks in discharge, flow and displacements."""

from dataclasses import dataclass

import numpy as np
from scipy.optimize import least_squares

from silostudy.compute.packing_run import SAMPLE, WINDOW, Discharge, Rested
from silostudy.config.packing import PackingScene, PackingStudy
from silostudy.dem.walls import wall_cells
from silostudy.scene.packing import CELLS_IN_LAYER, LAYERS
from silostudy.scene.plane_silo import FLOOR, HALVES, SIDES
from silostudy.tables.constants import STANDARD_GRAVITY

MEASURES = ("layer_peak", "layer_mean", "panel_peak", "panel_mean")
LOOKS = {"step": 0.0, "1 ms": 1e-3, "5 ms": 5e-3, "10 ms": 0.01, "20 ms": 0.02, "50 ms": 0.05, "100 ms": 0.1}  # s
PANEL = 0.7  # of the width: height over which Wagner measured mean wall loads (silo_handbook, section 4.5.1)
EARLY = 0.4  # s: end of the paper's early flow
NORMAL, SHEAR = range(2)  # components of a window's forces
MEAN, LEAST, MOST = range(3)  # what it holds of each


@dataclass(frozen=True)
class WallCells:
    """Rows of the engine's wall cells: the floor and its halves, and both side walls from the floor up."""

    floor: np.ndarray
    halves: np.ndarray
    sides: np.ndarray  # (2, cells)


def cells_of(rested: Rested) -> WallCells:
    """Cells that hold the forces of each wall; end points count with the floor's halves, never with the sides."""
    floor, half_left, half_right, left, right = (wall_cells(rested.model, name) for name in (FLOOR, *HALVES, *SIDES))
    return WallCells(floor, np.concatenate([half_left, half_right]), np.array([left[-2:0:-1], right[1:-1]]))


def layers(cells: np.ndarray, axis: int = -1) -> np.ndarray:
    """Forces on the layers of a side wall from those on its cells."""
    shape = list(cells.shape)
    shape[axis : axis + 1 or None] = [LAYERS, CELLS_IN_LAYER]
    return cells.reshape(shape).sum(axis=axis)


def janssen_force(depth, *, unit_weight, hydraulic_radius, wall_friction, lateral_ratio):
    """Horizontal force (N/m) on a wall from the surface down to a depth (m): Janssen's pressure summed over the depth.

    Source: silo_handbook, section 4.2.2 (Janssen), integrated; hydraulic radius (m) is half the width of a plane silo.
    """
    length = hydraulic_radius / (wall_friction * lateral_ratio)
    return unit_weight * hydraulic_radius / wall_friction * (depth - length * -np.expm1(-depth / length))


def tributary(depth: np.ndarray) -> np.ndarray:
    """Edges (m) of the stretches of wall that contacts from the top one down answer for: the middles between neighbours."""
    return np.concatenate([[0.0], 0.5 * (depth[1:] + depth[:-1])])


def fit_janssen(
    force: np.ndarray, depth: np.ndarray, *, unit_weight: float, hydraulic_radius: float
) -> tuple[float, float, float]:
    """K, wall friction and residual of Janssen's law through contact forces (N/m) at depths (m) from the top one down.

    Each contact answers for the wall between the middles to its neighbours.  The lowest is left out: the drop at the floor
    is a finding of its own.  residual: root mean square miss over the mean contact force.
    """
    edges = tributary(depth)
    known = {"unit_weight": unit_weight, "hydraulic_radius": hydraulic_radius}

    def miss(logs):
        lateral, friction = np.exp(logs)
        expected = np.diff(janssen_force(edges, wall_friction=friction, lateral_ratio=lateral, **known))
        return (expected - force[:-1]) / force[:-1].mean()

    best = least_squares(miss, np.log([0.5, 0.2]), bounds=(np.log([1e-2, 1e-3]), np.log([20.0, 2.0])))
    lateral, friction = np.exp(best.x)
    return float(lateral), float(friction), float(np.sqrt(np.mean(best.fun**2)))


def at_rest(config: PackingScene, rested: Rested) -> dict[str, np.ndarray | float]:
    """Wall forces at rest and what they say of the packing, by the names of the contract."""
    cells, radius = cells_of(rested), config.discs.radius_m
    sides = rested.walls[cells.sides]  # (2, cells, 2)
    height = float(rested.places[:, 1].max()) + radius
    weight = float(rested.model.mass.sum()) * STANDARD_GRAVITY
    force = sides.mean(axis=0)
    rows = np.flatnonzero(force[:, NORMAL] > 0.0)[::-1]  # contacts from the top one down
    step = config.silo.height_m / force.shape[0]
    depth = height - (rows + 0.5) * step
    normal, shear = force[rows].T
    law = {"unit_weight": weight / (config.silo.width_m * height), "hydraulic_radius": config.silo.width_m / 2.0}
    lateral, friction, residual = fit_janssen(normal, depth, **law)
    straight = np.diff(0.5 * tributary(depth) ** 2)  # of pressure in proportion to depth
    line = straight @ normal[:-1] / (straight @ straight) * straight - normal[:-1]
    low = (rows + 0.5) * step < 0.25 * height
    return {
        "rest_reached": float(rested.rested),
        "rest_time": rested.time,
        "rest_speed": rested.speed,
        "rest_disc_count": float(len(rested.places)),
        "rest_height": height,
        "rest_weight": weight,
        "rest_side_normal_force": layers(force[:, NORMAL]),
        "rest_side_shear_force": layers(force[:, SHEAR]),
        "rest_side_share": float(normal.sum()) / weight,
        "rest_carried_share": 2.0 * float(shear.sum()) / weight,
        "rest_floor_drop": float(normal[-1] / normal.max()),
        "rest_corner_shear": float((shear / normal)[low].min()) if low.any() else np.nan,
        "janssen_lateral_ratio": lateral,
        "janssen_wall_friction": friction,
        "janssen_residual": residual,
        "hydrostatic_residual": float(np.sqrt(np.mean(line**2)) / normal[:-1].mean()),
    }


def in_flow(study: PackingStudy, config: PackingScene, rested: Rested, flowed: Discharge) -> dict[str, np.ndarray | float]:
    """Wall forces, flow and displacements of a discharge, by the names of the contract."""
    return _walls(config, rested, flowed) | _flow(config, rested, flowed) | _moved(config, rested, flowed)


def _walls(config: PackingScene, rested: Rested, flowed: Discharge) -> dict[str, np.ndarray | float]:
    cells = cells_of(rested)
    sides = flowed.windows[:, cells.sides]  # (windows, 2, cells, 2, 3)
    still = rested.walls[cells.sides]  # (2, cells, 2)
    normal, shear = sides[..., NORMAL, :], sides[..., SHEAR, :]
    single, floor = normal[..., MOST], flowed.windows[:, cells.halves, NORMAL, MOST]
    when, wall, cell = np.unravel_index(int(np.argmax(single)), single.shape)
    mean = normal[..., MEAN]
    band = layers(mean)  # (windows, 2, layers)
    early = slice(0, round(EARLY / WINDOW))
    total, rest = mean.sum(axis=(1, 2)), float(still[..., NORMAL].sum())
    sampled = {"side_normal_force": total, "side_shear_force": shear[..., MEAN].sum(axis=(1, 2))}
    sampled["floor_force"] = flowed.windows[:, cells.halves, NORMAL, MEAN].sum(axis=1)
    coarse = {name: _by_sample(values) for name, values in sampled.items()}
    top = int(np.argmax(coarse["side_normal_force"]))
    rest_floor = rested.walls[cells.floor, NORMAL]
    return {
        **coarse,
        "contact_overpressure": seen(mean.reshape(len(mean), -1), single.reshape(len(mean), -1)) / still[..., NORMAL].max(),
        "floor_overpressure": seen(flowed.windows[:, cells.halves, NORMAL, MEAN], floor) / rest_floor.max(),
        "wall_overpressure": _overpressure(config, normal, still[..., NORMAL]),
        "layer_force_peak": band.max(axis=(0, 1)),
        "layer_force_mean": band[early].mean(axis=(0, 1)),
        "contact_force_peak": layers_most(single.max(axis=(0, 1))),
        "contact_peak_time": (when + 0.5) * WINDOW,
        "contact_peak_shear": float(shear[when, wall, cell, MEAN] / mean[when, wall, cell]),
        "side_peak": float(coarse["side_normal_force"][top]) / rest,
        "side_peak_time": (top + 0.5) * WINDOW * SAMPLE,
        "side_peak_shear": float(coarse["side_shear_force"][top] / coarse["side_normal_force"][top]),
        "side_least_shear": float(coarse["side_shear_force"].min()) / rest,
        "side_late": float(total[early.stop :].mean()) / rest,
        "floor_peak_time": (int(np.argmax(floor.max(axis=1))) + 0.5) * WINDOW,
    }


def layers_most(cells: np.ndarray) -> np.ndarray:
    """Largest force in each layer of a side wall."""
    return cells.reshape(LAYERS, CELLS_IN_LAYER).max(axis=1)


def _by_sample(values: np.ndarray) -> np.ndarray:
    return values.reshape(-1, SAMPLE).mean(axis=1)


def _overpressure(config: PackingScene, normal: np.ndarray, still: np.ndarray) -> np.ndarray:
    """Largest force in flow over the largest at rest, each over the same kind of area, in the order of MEASURES.

    Layers and panels (sums of layers over 0.7 widths) as the largest mean of a window, and as the mean of the early flow.
    """
    early = round(EARLY / WINDOW)
    mean = normal[..., MEAN]
    panel = min(LAYERS, max(1, round(PANEL * config.silo.width_m / config.silo.height_m * LAYERS)))
    band, rest = layers(mean), layers(still)
    wide, wide_rest = (_sliding(values, panel) for values in (band, rest))
    return np.array([
        band.max() / rest.max(), band[:early].mean(axis=0).max() / rest.max(),
        wide.max() / wide_rest.max(), wide[:early].mean(axis=0).max() / wide_rest.max(),
    ])  # fmt: skip


def seen(force: np.ndarray, largest: np.ndarray) -> np.ndarray:
    """Largest force (N/m) by how often one looks: every step, then at instants apart by LOOKS (means of the window there).

    force, largest: (windows, contacts) mean and largest of each window.
    """
    every = [round(interval / WINDOW) for interval in LOOKS.values()]
    return np.array([force[step - 1 :: step].max() if step else largest.max() for step in every])


def _sliding(values: np.ndarray, count: int) -> np.ndarray:
    """Sums over `count` layers in a row."""
    return np.lib.stride_tricks.sliding_window_view(values, count, axis=-1).sum(axis=-1)


def _flow(config: PackingScene, rested: Rested, flowed: Discharge) -> dict[str, np.ndarray | float]:
    time = np.arange(len(flowed.passed)) * WINDOW * SAMPLE
    first = flowed.stops[0] if flowed.stops else None
    flowing = (time >= 0.1) & (time <= (first[0] if first else time[-1]))
    mass = float(rested.model.mass[0])
    enough = flowing.sum() >= 10 and not config.remedy
    arch = first[1] if first and (flowed.stopped or flowed.removed) else None
    return {
        "passed_discs": flowed.passed,
        "discharge_rate": float(np.polyfit(time[flowing], flowed.passed[flowing], 1)[0]) * mass if enough else np.nan,
        "flow_stopped": float(flowed.stopped or bool(flowed.removed)),
        "stop_time": first[0] if first and arch else np.nan,
        "arch_discs": float(len(arch.discs)) if arch else np.nan,
        "arch_span": arch.span if arch else np.nan,
        "arch_height": arch.height if arch else np.nan,
        "discs_removed": float(len(flowed.removed)),
    }


def _moved(config: PackingScene, rested: Rested, flowed: Discharge) -> dict[str, np.ndarray | float]:
    """Displacements from rest to the end of the early flow and to the end: a disc has moved by its radius or more."""
    radius, width, slit = config.discs.radius_m, config.silo.width_m, config.silo.slit_width_m
    x, y = rested.places.T
    early = flowed.places[min(round(EARLY / WINDOW / SAMPLE), len(flowed.places) - 1)]
    ways = {"early": early, "late": flowed.places[-1]}
    gone = {name: ~(np.hypot(*(place - rested.places).T) < radius) for name, place in ways.items()}
    fall = np.where(np.isnan(early[:, 1]) | (early[:, 1] < 0.0), y, y - early[:, 1])
    top = y > y.max() - 3.0 * radius
    middle, outer = np.abs(x - width / 2.0) < slit / 2.0, np.abs(x - width / 2.0) > width / 2.0 - slit / 2.0
    layer = np.minimum((y / (config.silo.height_m / LAYERS)).astype(int), LAYERS - 1)
    share = [gone["early"][layer == k].mean() if (layer == k).any() else np.nan for k in range(LAYERS)]
    wide = np.array(share) * width
    filled = int(np.isfinite(wide).sum())
    return {
        "dead_share_early": 1.0 - float(gone["early"].mean()),
        "dead_share_late": 1.0 - float(gone["late"].mean()),
        "surface_fall_middle": float(fall[top & middle].mean()),
        "surface_fall_sides": float(fall[top & outer].mean()),
        "surface_fall_excess": float(fall[top & middle].mean() - fall[top & outer].mean()),
        "moving_width": wide,
        "channel_widening": float(wide[filled // 2 : filled].mean() / wide[0]) if wide[0] > 0.0 else np.nan,
        "channel_over_slit": float(wide[:filled].mean()) / slit,
    }
