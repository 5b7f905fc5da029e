"""A sweep of silos of spheres whose walls feel Janssen's pressures times known factors: no kernel is compiled."""

import numpy as np
import xarray as xr

from silostudy.compute.axes import sweep_of
from silostudy.compute.scenes import coordinates
from silostudy.compute.scenes_walls import windows_in_flow
from silostudy.cube.assemble import assemble
from silostudy.scene.expand import Expansion

GAMMA, MU, K = 7850.0, 0.4, 0.5  # unit weight (N/m3), wall friction, lateral pressure ratio (1) of the made-up solid
LOADS = np.array([[1.0, 4.0, 2.0], [2.0, 8.0, 1.0]])  # N: on walls, hopper and floor, at rest and at most in flow
FLOWS, PATCH = 1.3, 2.0  # pressure in flow over that at rest all around, and in one cell of one window over that


def janssen(depth: np.ndarray, wide: float) -> np.ndarray:
    """Wall pressure (Pa) at a depth (m); zero above the surface."""
    radius = wide / 4
    return np.where(depth > 0, GAMMA * radius / MU * -np.expm1(-K * MU * np.maximum(depth, 0) / radius), 0.0)


def walls_of(scene, depth: float, scatter: float) -> dict[str, np.ndarray]:
    """Numbers of a silo that is so deep (m); scatter: factor on all pressures of the filling."""
    (levels, turns), wide, windows = scene.record.pressure_cells, scene.silo.diameter_m, windows_in_flow(scene)
    step = scene.silo.cylinder_depth_m / levels
    above = step * (np.arange(levels) + 0.5)
    rest = scatter * janssen(depth - above, wide)[:, None] * np.ones((levels, turns))
    flow = FLOWS * rest * np.ones((windows, 1, 1))
    flow[1, 1, 3] *= PATCH
    low = 0.06
    found = {"filled_height_at_rest": np.array(depth), "unit_weight_at_rest": np.array(GAMMA)}
    found["flow_window_end"] = 0.02 * (np.arange(windows) + 1.0)
    found |= {"mean_mass_flow": np.array(0.3 * scatter), "mean_grain_diameter": np.array(0.005)}
    found |= {"body_load_at_rest": LOADS[0], "largest_body_load": LOADS[1]}
    for stem, height in (("wall", low + above), ("hopper", low * (np.arange(levels) + 0.5) / levels)):
        found |= {
            f"{stem}_level_height": height,
            f"{stem}_pressure_at_rest": rest + (stem == "hopper"),
            f"{stem}_shear_at_rest": MU * rest,
            f"{stem}_pressure_in_flow": flow + (stem == "hopper"),
            f"{stem}_shear_in_flow": MU * flow,
            f"{stem}_largest_pressure": flow.max(axis=0),
        }
    return found


def made_walls(expansion: Expansion, depths: list[float]) -> xr.Dataset:
    """The scenes cube of a study whose settings are so deep (m), its last axis the fillings."""
    fillings = expansion.shape[-1]
    cases = [case.scene.config for case in expansion.cases]
    each = [walls_of(scene, depths[k // fillings], 1.0 + 0.05 * (k % fillings)) for k, scene in enumerate(cases)]
    data = {name: np.array([one[name] for one in each]) for name in each[0]}
    shaped = {name: values.reshape((*expansion.shape, *values.shape[1:])) for name, values in data.items()}
    return assemble(expansion.study, "scenes", shaped | coordinates(expansion.study), sources=[], sweep=sweep_of(expansion))
