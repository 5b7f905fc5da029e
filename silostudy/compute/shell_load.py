"""Load on the shell from a pressure cube: axial wall force, and the pressures that help and harm."""

import numpy as np
import xarray as xr

from silostudy.pressure.family import ABOVE_CONTACT
from silostudy.pressure.quadrature import from_surface

# Where the axial wall force of a method and phase comes from: position = flag value in the cube.
SOURCES = (
    "not_covered",
    "own_axial_force",
    "own_axial_force_continued_with_own_friction_times_pressure",
    "own_traction_integrated",
    "friction_times_design_pressure_integrated",
)
NOT_COVERED, OWN_FORCE, OWN_CONTINUED, OWN_TRACTION, FRICTION_TIMES_PRESSURE = range(len(SOURCES))


def depths(pressure: xr.Dataset) -> np.ndarray:
    """Depth (m) of every value, shape (axes..., depth)."""
    depth = pressure["depth"].values
    shape = pressure["wall_normal_pressure"].shape[2:]
    return np.broadcast_to(depth, shape)


def axial_wall_force(pressure: xr.Dataset) -> tuple[np.ndarray, np.ndarray]:
    """Axial wall force (N/m), shape (method, phase, axes..., depth), and flag of SOURCES, shape (method, phase).

    A method's own force where it has one; elsewhere its own wall friction traction, or wall friction times its wall
    pressure, integrated from the surface.  The friction coefficient is then the one in the method's own traction, or the one
    handed to it.  The integral of an envelope (Jenike's discharge) is an upper bound, no single state of the silo.  Where
    the wall pressure itself is masked, the force below is unknown.
    """
    names = ("wall_normal_pressure", "axial_wall_force", "wall_friction_traction")
    normal, own, traction = (pressure[name].values for name in names)
    integrated = from_surface(rubbing(pressure), depths(pressure))
    return np.where(np.isfinite(own), own, integrated), _source(normal, own, traction)


def rubbing(pressure: xr.Dataset) -> np.ndarray:
    """Friction traction (Pa) on the wall: a method's own, or its friction times its pressure; 0 above the wall's contact."""
    handed = pressure["wall_friction"].values
    normal, traction = (pressure[name].values for name in ("wall_normal_pressure", "wall_friction_traction"))
    above = pressure["wall_normal_pressure_scope"].values == ABOVE_CONTACT
    friction = own_friction(traction, normal, np.broadcast_to(handed[:, None], normal.shape[:-1]))
    return np.where(above, 0.0, np.where(np.isfinite(traction), traction, friction[..., None] * normal))


def own_friction(traction: np.ndarray, normal: np.ndarray, handed: np.ndarray) -> np.ndarray:
    """Wall friction coefficient (1) in a method's own traction, one for all depths; the one handed to it where it has none."""
    with np.errstate(invalid="ignore", divide="ignore"):
        own = np.fmax.reduce(np.where(normal > 0, traction / normal, np.nan), axis=-1)
    return np.where(np.isfinite(own), own, handed)


def _source(normal: np.ndarray, own: np.ndarray, traction: np.ndarray) -> np.ndarray:
    """Flag of SOURCES for each method and phase."""
    rest = tuple(range(2, normal.ndim))
    covered, has_own, has_traction = (np.isfinite(field).any(axis=rest) for field in (normal, own, traction))
    whole = ~(np.isfinite(normal) & ~np.isfinite(own)).any(axis=rest)
    conditions = [~covered, has_own & whole, has_own, has_traction]
    return np.select(conditions, [NOT_COVERED, OWN_FORCE, OWN_CONTINUED, OWN_TRACTION], FRICTION_TIMES_PRESSURE).astype(np.int8)


def internal_pressures(pressure: xr.Dataset) -> tuple[np.ndarray, np.ndarray]:
    """Smallest guaranteed and largest wall pressure (Pa) of each method over its phases, shape (method, axes..., depth).

    Smallest is the pressure that accompanies the axial force, where the method gives it; else an overpressure is not
    guaranteed, and the smallest is counted with the method's static pressure.
    """
    normal = pressure["wall_normal_pressure"].values
    with np.errstate(invalid="ignore", divide="ignore"):
        smallest = np.fmin(normal, normal / pressure["overpressure_factor"].values)
    if "accompanying_wall_pressure" in pressure:
        accompanying = pressure["accompanying_wall_pressure"].values
        smallest = np.where(np.isfinite(accompanying), accompanying, smallest)
    return np.fmin.reduce(smallest, axis=1), np.fmax.reduce(normal, axis=1)


def carried_share(force: np.ndarray, pressure: xr.Dataset) -> np.ndarray:
    """Axial force at the deepest level over the weight above it (1), shape (method, phase, axes...): above 1 no equilibrium."""
    weight = pressure["unit_weight"].values * pressure["hydraulic_radius"].values * depths(pressure)[..., -1]
    return force[..., -1] / weight[:, None]
