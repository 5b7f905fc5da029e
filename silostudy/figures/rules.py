"""How buckling rules and Miller's tests look in every figure."""

import numpy as np
import xarray as xr

KPA_PER_PSI = 6.894757293
PSI = KPA_PER_PSI * 1e3
# group of tests -> (marker, filled, label); markers tell them apart without colour
GROUPS = {
    "unstiffened": ("o", "small, no rings"),
    "ringed": ("^", "small, rings"),
    "large": ("s", "large, rings"),
}


def look(cube: xr.Dataset, rule: str) -> dict:
    """Colour and line of a rule, as line properties."""
    one = cube.sel({"rule": rule})
    return {"color": str(one.rule_colour.values), "linestyle": str(one.rule_line.values)}


def name(cube: xr.Dataset, rule: str) -> str:
    """Name of a rule for a legend."""
    return str(cube.sel({"rule": rule}).rule_title.values)


def is_rival(rule: str) -> bool:
    """Whether a name on the rule axis is a rival reading of a source rather than a rule."""
    return rule.startswith("miller1977_")


def group(cube: xr.Dataset) -> np.ndarray:
    """For each test the group it belongs to: a key of GROUPS."""
    small = np.where(cube["ring_area"].values > 0, "ringed", "unstiffened")
    return np.where(cube["test_scale"].values == "large", "large", small)
