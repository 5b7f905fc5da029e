"""Keys of study and scene files that were renamed or replaced, so that a file of an older version is told what to write."""

RETIRED_KEYS = {  # key -> (version since which it is no key, what to write now)
    "outlet": ("1.0.0", "outlets: a list, each {width_m: ...}"),
    "stress_cells": ("1.0.0", "record.fields: {cells: [...], every_s: ...}"),
    "surface": ("1.0.0", "surfaces: a list of names"),
    "eccentricity_m": ("1.0.0", "filling_eccentricity_m and outlet_eccentricity_m"),
    "lateral_pressure_ratio_spread": ("1.0.0", "a_K"),
    "wall_friction_spread": ("1.0.0", "a_mu"),
}
