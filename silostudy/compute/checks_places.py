"""Places at which the checks look at a wall: the depths of the study and both ends of every strake, from the top down."""

from dataclasses import dataclass

import numpy as np
import xarray as xr

from silostudy.choice.expand import Resolved
from silostudy.compute.evaluate import methods_of
from silostudy.compute.shell_load import axial_wall_force, depths, internal_pressures, rubbing
from silostudy.compute.shell_places import of_cases
from silostudy.compute.shell_strakes import (
    ENDS,
    between_levels,
    edges_and_thicknesses,
    ends,
    mass_above,
    strake_at,
    wall_share,
)


@dataclass(frozen=True)
class WallPlaces:
    """Depth (m), strake, thickness (m) and own weight (N/m) of every place, shape (axes..., place); loads of the solid.

    below_top: depth (m) below the wall's upper edge; strake -1, thickness NaN and own weight 0 where no strakes are given.
    force (N/m), pressure (Pa): shape (method, phase, axes..., place); guaranteed (Pa) without the phase.
    """

    z: np.ndarray
    below_top: np.ndarray
    strake: np.ndarray
    thickness: np.ndarray
    own_weight: np.ndarray
    force: np.ndarray
    pressure: np.ndarray
    guaranteed: np.ndarray


def places(expansion: Resolved, pressure: xr.Dataset) -> WallPlaces:
    """The places of every case and what the solid does there; an edge of two strakes stands twice, for the upper one first."""
    levels = depths(pressure)
    share, z, strake = _with_ends(expansion, levels)
    walls = [case.scene.shell for case in expansion.cases]
    whole = of_cases(expansion, [case.scene.silo.wall_depth for case in expansion.cases])
    thickness, own_weight = np.full(z.shape, np.nan), np.zeros(z.shape)
    if _has_strakes(expansion):
        edges, thicknesses = edges_and_thicknesses(expansion)
        thickness = np.take_along_axis(thicknesses, strake, axis=-1)
        weight = of_cases(expansion, [wall.unit_weight for wall in walls])
        own_weight = weight * whole * mass_above(share, edges, thicknesses)
    force = between_levels(levels, axial_wall_force(pressure)[0], z, rubbing(pressure))
    normal = between_levels(levels, pressure["wall_normal_pressure"].values, z)
    guaranteed = between_levels(levels, internal_pressures(pressure)[0], z)
    for of_solid in (force, normal, guaranteed):
        of_solid[uneven(expansion)] = np.nan
    return WallPlaces(z, share * whole, strake, thickness, own_weight, force, normal, guaranteed)


def uneven(expansion: Resolved) -> np.ndarray:
    """Mask of the methods whose pressures differ round the wall: the checks take even ones, and these are no load to them."""
    return np.array([bool(method.row.channel) for method in methods_of(expansion)])


def _has_strakes(expansion: Resolved) -> bool:
    return all(case.scene.shell.edges for case in expansion.cases)


def _with_ends(expansion: Resolved, levels: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Share of the wall's height, depth z (m) and strake of all places, sorted by depth."""
    share = wall_share(expansion, levels)
    if not _has_strakes(expansion):
        return share, levels, np.full(levels.shape, -1)
    edges = edges_and_thicknesses(expansion)[0]
    end_share, end_z = ends(expansion, edges)
    number = np.broadcast_to(np.arange(end_z.shape[-1]) // len(ENDS), end_z.shape)
    columns = ((share, end_share), (levels, end_z), (strake_at(share, edges), number))
    joined = [np.concatenate(pair, axis=-1) for pair in columns]
    order = np.lexsort((joined[2], np.round(joined[0], 9)), axis=-1)
    ordered = [np.take_along_axis(values, order, axis=-1) for values in joined]
    return ordered[0], ordered[1], ordered[2]
