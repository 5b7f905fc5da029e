"""Places at which a steel wall is looked at: depths of the study and ends of its strakes, with loads and parameters there."""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
import xarray as xr

from silostudy.choice.expand import Resolved
from silostudy.compute.shell_load import depths, rubbing
from silostudy.compute.shell_strakes import (
    ENDS,
    between_levels,
    edges_and_thicknesses,
    ends,
    mass_above,
    thickness_at,
    wall_share,
)


@dataclass(frozen=True)
class Places:
    """Places of a wall: depth (m), the solid's force (N/m), the wall above over the silo's height, and its own load.

    thickness (m) and own_weight (N/m): of the strakes, None where the wall has none.
    """

    z: np.ndarray
    force: np.ndarray
    parameters: Mapping
    height: np.ndarray  # m, of the wall above
    thickness: np.ndarray | None = None
    own_weight: np.ndarray | float = 0.0


def at_levels(expansion: Resolved, pressure: xr.Dataset, force, pressures) -> Places:
    """The depths of the study."""
    z = depths(pressure)
    return _places(expansion, z, wall_share(expansion, z), force, pressures)


def at_strake_ends(expansion: Resolved, pressure: xr.Dataset, levels: Places) -> Places:
    """Top and foot of every strake, the loads brought there from the depths of the study."""
    share, z = ends(expansion, edges_and_thicknesses(expansion)[0])
    force = between_levels(levels.z, levels.force, z, rubbing(pressure))
    names = ("lower_internal_pressure", "upper_internal_pressure")
    places = _places(expansion, z, share, force, [between_levels(levels.z, levels.parameters[name], z) for name in names])
    below = np.arange(z.shape[-1]) // len(ENDS)  # at its top too, a strake is as thick as it is
    return replace(places, thickness=edges_and_thicknesses(expansion)[1][..., below])


def _places(expansion: Resolved, z, share, force, pressures) -> Places:
    walls, silos = ([getattr(case.scene, name) for case in expansion.cases] for name in ("shell", "silo"))
    whole = of_cases(expansion, [silo.wall_depth for silo in silos])
    parameters = wall_parameters(expansion, *pressures)
    if not all(wall.edges for wall in walls):
        return Places(z, force, parameters, share * whole)
    edges, thicknesses = edges_and_thicknesses(expansion)
    weight = of_cases(expansion, [wall.unit_weight for wall in walls]) * whole * mass_above(share, edges, thicknesses)
    return Places(z, force, parameters, share * whole, thickness_at(share, edges, thicknesses), weight)


def wall_parameters(expansion: Resolved, lower: np.ndarray, upper: np.ndarray) -> dict[str, np.ndarray]:
    """The buckling rules' parameters but thickness and shell_radius; `inner_radius` (m) in their place."""
    walls, silos = ([getattr(case.scene, name) for case in expansion.cases] for name in ("shell", "silo"))
    bays = [wall.bay_length or silo.wall_depth for wall, silo in zip(walls, silos, strict=True)]
    return {
        **{name: of_cases(expansion, [wall.steel[name] for wall in walls]) for name in walls[0].steel},
        "bay_length": of_cases(expansion, bays),
        "total_length": of_cases(expansion, [silo.wall_depth for silo in silos]),
        "ring_area": of_cases(expansion, [wall.ring_area for wall in walls]),
        "inner_radius": of_cases(expansion, [silo.diameter / 2 for silo in silos]),
        "lower_internal_pressure": lower,
        "upper_internal_pressure": upper,
    }


def of_cases(expansion: Resolved, values: list) -> np.ndarray:
    """One value a case, shape (axes..., 1)."""
    return np.array(values, dtype=float).reshape(*expansion.shape, 1)
