"""Silos with hoppers by the parameters of the pressure methods."""

import numpy as np

BIN = {
    "unit_weight": 8e3, "wall_friction": 0.3, "lateral_pressure_ratio": 0.5, "hydraulic_radius": 1.25, "diameter": 5.0,
    "perimeter": np.pi * 5, "cylinder_depth": 10.0, "length": 0.0, "slot": 0.0, "circular": 1.0, "end_ratio": 1.0,
    "hopper_half_angle": np.radians(20), "hopper_wall_friction": np.tan(np.radians(18)),
    "effective_friction_angle": np.radians(45), "outlet_width": 0.6, "internal_friction_angle": np.radians(35),
    "poisson_ratio": 0.3, "repose_angle": np.radians(35), "a_phi": 1.1, "a_K": 1.1, "a_mu": 1.15, "patch_factor": 0.5,
    "filling_eccentricity": 0.5, "outlet_eccentricity": 0.5, "volume": 60.0,
    "contact_share": 1.0, "cooling_strain": 0.0, "fluid_depth": 0.0, "wall_flexibility": 0.0, "solid_modulus_factor": 100.0,
    "outlet_depth": 16.0,
    "largest_particle": 0.005, "assessment_class": 1.0, "dynamic_bottom": 0.0, "low_patch": 0.0,
    "contact_depth": 0.0, "top_cone_height": 0.0, "sets_capped": 1.0,
}  # fmt: skip


def one(scene):
    """A scene as the compute room hands it over: shape (1,), the plan beside it."""
    plan = np.array(["slot" if scene["slot"] else "circular"])
    return {name: np.array([value]) for name, value in scene.items()} | {"plan": plan}
