"""The contents of a silo of grains as codes see them: levelled, of one unit weight."""

import numpy as np

INNER = 0.8  # of the height above the transition: where the unit weight is read, below a surface that is not level


def levelled(z: np.ndarray, weight: np.ndarray, low: float, area: float) -> tuple[float, float]:
    """Height (m) of the level surface and unit weight (N/m3) of grains at heights z (m) above the transition at `low` (m).

    The unit weight is that of the inner part, and the surface as high as the whole weight then fills the plan's area (m2).
    NaN of fewer than two grains above the transition, and of none in the inner part, as of a single layer.
    """
    there = np.isfinite(z) & (z > low)
    z, weight = z[there], weight[there]
    if len(z) < 2:
        return np.nan, np.nan
    high = INNER * (z.max() - low)
    unit_weight = float(weight[z < low + high].sum() / (high * area))
    if not unit_weight > 0.0:
        return np.nan, np.nan
    return low + float(weight.sum()) / (unit_weight * area), unit_weight
