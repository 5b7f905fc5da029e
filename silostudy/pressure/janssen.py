"""Janssen (1895): horizontal slices in equilibrium, wall friction fully mobilised, constant ratio of stresses."""

from collections.abc import Callable

from silostudy.pressure.calls import asking, call, parameters_of
from silostudy.pressure.family import ANY_PLAN, PressureMethod, Quantities
from silostudy.pressure.saturation import saturation, saturation_deficit


def relative_depth(z, *, hydraulic_radius, wall_friction, lateral_pressure_ratio):
    """Depth over Janssen's depth constant (1): K mu z / R at depth z (m)."""
    return lateral_pressure_ratio * wall_friction * z / hydraulic_radius


def normal_pressure(z, *, unit_weight, hydraulic_radius, wall_friction, lateral_pressure_ratio):
    """Horizontal wall pressure (Pa) at depth z (m).

    Source: silo_handbook, section 4.2.2 (a), second equation.
    """
    return lateral_pressure_ratio * vertical_pressure(
        z,
        unit_weight=unit_weight,
        hydraulic_radius=hydraulic_radius,
        wall_friction=wall_friction,
        lateral_pressure_ratio=lateral_pressure_ratio,
    )


def friction_traction(z, *, unit_weight, hydraulic_radius, wall_friction, lateral_pressure_ratio):
    """Wall friction traction (Pa), carrying the solid's weight, at depth z (m).

    Source: silo_handbook, section 4.2.2 (a): mu times the wall pressure.
    """
    return wall_friction * normal_pressure(
        z,
        unit_weight=unit_weight,
        hydraulic_radius=hydraulic_radius,
        wall_friction=wall_friction,
        lateral_pressure_ratio=lateral_pressure_ratio,
    )


def vertical_pressure(z, *, unit_weight, hydraulic_radius, wall_friction, lateral_pressure_ratio):
    """Mean vertical pressure in the solid (Pa) at depth z (m).

    Source: silo_handbook, section 4.2.2 (a), first equation.
    """
    x = relative_depth(
        z,
        hydraulic_radius=hydraulic_radius,
        wall_friction=wall_friction,
        lateral_pressure_ratio=lateral_pressure_ratio,
    )
    return unit_weight * z * saturation(x)


def axial_wall_force(z, *, unit_weight, hydraulic_radius, wall_friction, lateral_pressure_ratio):
    """Axial wall force per metre of perimeter (N/m, compression positive) at depth z (m).

    Source: the wall friction traction of silo_handbook, section 4.2.2 (a), integrated from the surface to z.
    """
    x = relative_depth(
        z,
        hydraulic_radius=hydraulic_radius,
        wall_friction=wall_friction,
        lateral_pressure_ratio=lateral_pressure_ratio,
    )
    return unit_weight * hydraulic_radius * z * x * saturation_deficit(x)


def transition_force(
    *, unit_weight, hydraulic_radius, wall_friction, lateral_pressure_ratio, cylinder_depth, diameter, perimeter, slot
):
    """Downward force Q_c (N) at the transition of the cylinder's contents on the hopper's.

    Source: silo_handbook, section 4.5.2 (Janssen's vertical pressure on the area of the transition).
    """
    stress = vertical_pressure(
        cylinder_depth,
        unit_weight=unit_weight,
        hydraulic_radius=hydraulic_radius,
        wall_friction=wall_friction,
        lateral_pressure_ratio=lateral_pressure_ratio,
    )
    return stress * perimeter * diameter / (4 - 2 * slot)


def times(factor: Callable) -> Callable:
    """The wall pressure (Pa) of a code that multiplies Janssen's by factor(z, *, ...) (1).

    The function returned asks for the parameters of both by name.
    """

    def design_pressure(z, **parameters):
        return call(factor, z, parameters) * call(normal_pressure, z, parameters)

    doc = f"Horizontal wall pressure (Pa): {factor.__doc__} times Janssen's."
    return asking(design_pressure, parameters_of(factor) + parameters_of(normal_pressure), doc)


STATE = {
    "wall_normal_pressure": normal_pressure,
    "wall_friction_traction": friction_traction,
    "vertical_pressure": vertical_pressure,
    "axial_wall_force": axial_wall_force,
}


def for_state(used: Quantities) -> dict[str, Quantities]:
    """The same values used for every quantity of Janssen's state."""
    return dict.fromkeys(STATE, used)


ROW = PressureMethod(
    key="janssen",
    rank=10,
    title="Janssen",
    source="silo_handbook",
    locator="section 4.2.2 (a)",
    phases={"filling": STATE},
    static=normal_pressure,
    plans=ANY_PLAN,
    formula="p_h = gamma R / mu (1 - exp(-K mu z / R)), p_v = p_h / K, p_w = mu p_h, n_z = R (gamma z - p_v)",
    validity="any depth and plan (through the hydraulic radius R); mu is capped at tan(phi)",
    colour="#000000",
    marker="o",
    number="6",
    drawn="handbook",
    equilibrium=("filling",),
)
