"""Numbers that the study gives for the checks beside the silo's sizes, as variables of the cube: steel, actions, supports."""

from silostudy.compute.checks_wall import WallActions

# variable of the cube -> parameter of the wall, or number of the silo
OF_WALL = {
    "given_yield_stress": "yield_stress",
    "given_youngs_modulus": "youngs_modulus",
    "given_fabrication_quality": "fabrication_quality",
    "given_joint_efficiency": "joint_efficiency",
    "partial_yield": "partial_yield",
    "partial_buckling": "partial_buckling",
    "partial_joint": "partial_joint",
}
OF_SILO = {
    "given_roof_force": "roof",
    "given_snow_force": "snow",
    "given_steel_unit_weight": "steel_weight",
    "given_wall_height": "wall_height",
    "given_wind_pressure": "wind_pressure",
    "given_suction": "suction",
    "given_force_coefficient": "force_coefficient",
    "given_edge_factor": "edge_factor",
    "given_hopper_thickness": "hopper_thickness",
    "given_hopper_joint_efficiency": "hopper_joint_efficiency",
    "given_ultimate_stress": "ultimate_stress",
    "given_ring_area": "ring_area",
    "given_ring_second_moment": "ring_second_moment",
    "given_column_count": "column_count",
    "given_section_modulus": "section_modulus",
    "given_anchor_count": "anchor_count",
    "given_anchor_circle": "circle_diameter",
    "given_anchor_resistance": "anchor_resistance",
}


def given_numbers(loads: WallActions) -> dict:
    """Every number, (axes...), partial factors without a dimension; NaN where the study does not give it."""
    axes, data = loads.source.expansion.shape, {}
    for name, own in OF_WALL.items():
        value = loads.parameters[own]
        data[name] = value if name.startswith("partial") else value.reshape(axes)
    return data | {name: loads.source.numbers[own].reshape(axes) for name, own in OF_SILO.items()}
