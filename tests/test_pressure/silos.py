"""Small pressure studies that several tests of faults share."""

import numpy as np

from silostudy.compute.pressure import pressure_cube
from silostudy.pressure.family import REASONS
from tests.conftest import expanded

SLENDER = {"plan": "circular", "diameter_m": 5.0, "cylinder_depth_m": 18.0}
CONE = {"half_angle_deg": 45.0, "outlet_width_m": 0.5}


def study(silo=SLENDER, methods=("janssen", "en1991_4"), depth_m=(9.0, 18.0), hopper=None, **scene):
    silo = silo | ({"hopper": hopper} if hopper else {})
    content = {"kind": "pressure", "title": "a fault", "scene": {"silo": silo, "solid": "wheat_e1", "wall": "d2"} | scene}
    content |= {"methods": list(methods), "depth_m": list(depth_m)}
    return content | ({"hopper_position": [0.0, 0.5, 1.0]} if hopper else {})


def cube_of(*args, **kwargs):
    return pressure_cube(expanded(study(*args, **kwargs)))


def on_wall(cube, quantity="wall_normal_pressure", method="en1991_4", phase="filling", **where):
    return float(cube[quantity].sel(pressure_method=method, phase=phase, **where)) / 1e3


def why(cube, name, method="en1991_4", phase="filling"):
    return {REASONS[flag] for flag in np.unique(cube[f"{name}_scope"].sel(pressure_method=method, phase=phase).values)}
