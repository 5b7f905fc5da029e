"""The strakes of a wall: the thickness at every depth, and the loads at both ends of every strake, between the levels too."""

import numpy as np

from silostudy.choice.expand import Resolved

ENDS = ("top", "foot")


def wall_share(expansion: Resolved, z: np.ndarray) -> np.ndarray:
    """Height of the wall above every depth z (m), shape (axes..., depth), over the wall's whole height; 0 above the wall."""
    silos = [case.scene.silo for case in expansion.cases]
    above, height = (
        np.reshape(values, (*expansion.shape, 1))
        for values in ([silo.contact_depth for silo in silos], [silo.wall_depth for silo in silos])
    )
    return np.clip((z - above) / height, 0.0, 1.0)  # the heap stands above the wall


def edges_and_thicknesses(expansion: Resolved) -> tuple[np.ndarray, np.ndarray]:
    """Share of the wall's height at each strake's foot, and its thickness (m), shape (axes..., strake).

    Where cases have unequally many strakes, the last one stands again, without height.
    """
    walls = [case.scene.shell for case in expansion.cases]
    most = max(len(wall.edges) for wall in walls)
    columns = ([*values, *[values[-1]] * (most - len(values))] for wall in walls for values in (wall.edges, wall.thicknesses))
    pairs = np.array(list(columns)).reshape(len(walls), 2, most)
    return pairs[:, 0].reshape(*expansion.shape, most), pairs[:, 1].reshape(*expansion.shape, most)


def strake_at(share: np.ndarray, edges: np.ndarray) -> np.ndarray:
    """Position of the strake at shares of the wall's height; an edge belongs to the strake above it."""
    place = (share[..., None] > edges[..., None, :] * (1 + 1e-9)).sum(axis=-1)
    return np.minimum(place, edges.shape[-1] - 1)


def thickness_at(share: np.ndarray, edges: np.ndarray, thicknesses: np.ndarray) -> np.ndarray:
    """Thickness (m) at shares of the wall's height."""
    return np.take_along_axis(thicknesses, strake_at(share, edges), axis=-1)


def mass_above(share: np.ndarray, edges: np.ndarray, thicknesses: np.ndarray) -> np.ndarray:
    """Thickness times height of the wall above a share of its height, over the whole height (m), shape as share."""
    starts = np.concatenate([np.zeros((*edges.shape[:-1], 1)), edges[..., :-1]], axis=-1)
    within = np.clip(share[..., None] - starts[..., None, :], 0.0, (edges - starts)[..., None, :])
    return (within * thicknesses[..., None, :]).sum(axis=-1)


def ends(expansion: Resolved, edges: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Share of the wall's height and depth z (m) of every strake's top and foot, shape (axes..., strake x end)."""
    starts = np.concatenate([np.zeros((*edges.shape[:-1], 1)), edges[..., :-1]], axis=-1)
    share = np.stack([starts, edges], axis=-1).reshape(*edges.shape[:-1], -1)
    silos = [case.scene.silo for case in expansion.cases]
    above, height = (
        np.reshape(values, (*expansion.shape, 1))
        for values in ([silo.contact_depth for silo in silos], [silo.wall_depth for silo in silos])
    )
    return share, above + share * height


def between_levels(z: np.ndarray, values: np.ndarray, to: np.ndarray, slopes: np.ndarray | None = None) -> np.ndarray:
    """Values (..., axes..., depth) at depths z (m), shape (axes..., depth), brought to depths `to`, shape (axes..., place).

    Cubic between neighbours, by their slopes or those of their surroundings, and never beyond the neighbours; 0 at the
    surface, NaN below the last level.
    """
    brought = np.full((*values.shape[:-1], to.shape[-1]), np.nan)
    for place in np.ndindex(z.shape[:-1]):
        key = (..., *place, slice(None))
        brought[key] = _one(z[place], values[key], to[place], None if slopes is None else slopes[key])
    return brought


def _one(z: np.ndarray, values: np.ndarray, to: np.ndarray, slopes: np.ndarray | None) -> np.ndarray:
    if z[0] > 0:
        nothing = np.zeros((*values.shape[:-1], 1))
        z, values = np.append(0.0, z), np.concatenate([nothing, values], axis=-1)
        slopes = None if slopes is None else np.concatenate([nothing, slopes], axis=-1)
    if len(z) < 2:
        return np.where(to == z[0], values[..., :1], np.nan)
    steep = np.gradient(values, z, axis=-1) if slopes is None else slopes
    k = np.clip(np.searchsorted(z, to * (1 - 1e-12)) - 1, 0, len(z) - 2)
    step, first, second = z[k + 1] - z[k], values[..., k], values[..., k + 1]
    t = np.where(to <= z[-1] * (1 + 1e-9), np.clip((to - z[k]) / step, 0.0, 1.0), np.nan)
    chord = (second - first) / step
    before, after = (np.where(np.isnan(steep[..., j]), chord, steep[..., j]) for j in (k, k + 1))
    cubic = first + t * step * before + t**2 * (3 * (second - first) - step * (2 * before + after))
    cubic = cubic + t**3 * (step * (before + after) - 2 * (second - first))
    cubic = np.clip(cubic, np.minimum(first, second), np.maximum(first, second))
    return np.select([t <= 1e-9, t >= 1 - 1e-9], [first, second], cubic)
