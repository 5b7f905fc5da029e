"""What the study gives for the checks beside the silo's sizes, as variables of the cube: steel, actions, supports."""

from silostudy.compute.checks_wall import Load

# variable of the cube -> parameter of the wall, or number of the silo
OF_WALL = {
    "yield_stress": "yield_stress",
    "youngs_modulus": "youngs_modulus",
    "fabrication_quality": "fabrication_quality",
    "joint_efficiency": "joint_efficiency",
    "partial_yield": "partial_yield",
    "partial_buckling": "partial_buckling",
    "partial_joint": "partial_joint",
}
OF_SILO = {
    "roof_axial_force": "roof",
    "snow_axial_force": "snow",
    "steel_unit_weight": "steel_weight",
    "wall_height": "wall_height",
    "wind_pressure": "wind_pressure",
    "wind_suction": "suction",
    "wind_force_coefficient": "force_coefficient",
    "edge_factor": "edge_factor",
    "hopper_thickness": "hopper_thickness",
    "hopper_joint_efficiency": "hopper_joint_efficiency",
    "ultimate_stress": "ultimate_stress",
    "transition_ring_area": "ring_area",
    "transition_ring_second_moment": "ring_second_moment",
    "column_count": "column_count",
    "ring_beam_section_modulus": "section_modulus",
    "anchor_count": "anchor_count",
    "anchor_circle_diameter": "circle_diameter",
    "anchor_resistance": "anchor_resistance",
}


def given_numbers(loads: Load) -> dict:
    """Every number, (axes...), partial factors without a dimension; NaN where the study does not give it."""
    axes, found = loads.source.expansion.shape, {}
    for name, own in OF_WALL.items():
        value = loads.parameters[own]
        found[name] = value if name.startswith("partial") else value.reshape(axes)
    return found | {name: loads.source.numbers[own].reshape(axes) for name, own in OF_SILO.items()}
