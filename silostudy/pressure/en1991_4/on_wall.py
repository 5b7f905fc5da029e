"""EN 1991-4:2006 on the cylinder's wall: each quantity with a set of characteristic values, as functions of a method."""

import numpy as np

from silostudy.pressure.calls import asking, call, parameters_of
from silostudy.pressure.en1991_4 import classes, cylinder, factors
from silostudy.pressure.en1991_4.characteristic import PROPERTIES, characteristic, used

STATE = ("unit_weight", "hydraulic_radius", "diameter", "cylinder_depth", "repose_angle", "contact_depth")
CYLINDER = (*STATE, *PROPERTIES)
# which factor increases a quantity in discharge; p_v in discharge was not verified
INCREASED_BY = {
    "wall_normal_pressure": "normal_pressure_increase",
    "wall_friction_traction": "wall_friction_increase",
    "axial_wall_force": "wall_friction_increase",
}
# the set of each quantity that is unfavourable for it; what presses on the wall while the axial force acts follows the force
DESIGN_SETS = {
    "wall_normal_pressure": "wall_normal",
    "wall_friction_traction": "wall_friction",
    "axial_wall_force": "wall_friction",
    "vertical_pressure": "vertical_load",
    "accompanying_wall_pressure": "wall_friction",
}
SEEN = "Source: en1991_4_2006 (printed standard not seen; agrees in two or more public programs)."
DOCS = {
    "wall_normal_pressure": "Wall normal pressure (Pa) at depth z (m).",
    "wall_friction_traction": "Wall friction traction (Pa) at depth z (m).",
    "axial_wall_force": "Axial wall force per metre of perimeter (N/m, compression positive) at depth z (m).",
    "vertical_pressure": "Mean vertical pressure (Pa) at depth z (m).",
    "accompanying_wall_pressure": "Wall pressure (Pa) after filling in the state of the axial wall force, at depth z (m).",
}


def take(given, names):
    """The named parameters out of all that were handed over."""
    return {name: given[name] for name in names}


def filled(z, set_name, given):
    """Pressures p_h, p_v (Pa) and mu (1) after filling with a set's characteristic values."""
    mu, k, _ = characteristic(set_name, **take(given, PROPERTIES))
    return *cylinder.pressures(z, mu=mu, k=k, **take(given, STATE)), mu


def read_off(quantity, z, set_name, given):
    """One quantity of a filling state; the axial force is the friction integrated, R (gamma z - p_v)."""
    p_h, p_v, mu = filled(z, set_name, given)
    weight = given["unit_weight"] * z
    return {
        "wall_normal_pressure": p_h,
        "wall_friction_traction": mu * p_h,
        "axial_wall_force": given["hydraulic_radius"] * (weight - p_v),
        "vertical_pressure": p_v,
        "accompanying_wall_pressure": p_h,
    }[quantity]


def on_cylinder(quantity, set_name, phase, increases=factors.USUAL):
    """A method function for one quantity with one set, increased in discharge by C_h or C_w of `increases`."""
    by = increases.get(INCREASED_BY.get(quantity)) if phase == "discharge" else None

    def function(z, **given):
        value = read_off(quantity, z, set_name, given)
        return value if by is None else value * call(by, None, given)

    return asking(function, (*CYLINDER, *(parameters_of(by) if by else ())), f"{DOCS[quantity]} {SEEN}")


def phases(sets, increases=factors.USUAL):
    """Functions by phase and quantity, with the set of each quantity."""
    in_discharge = (*INCREASED_BY, "accompanying_wall_pressure")
    return {
        "filling": {quantity: on_cylinder(quantity, name, "filling") for quantity, name in sets.items()},
        "discharge": {q: on_cylinder(q, name, "discharge", increases) for q, name in sets.items() if q in in_discharge},
    }


def used_by(sets):
    """Functions by phase, quantity and parameter: the characteristic values of each quantity's set."""
    functions = {quantity: used(name) | {"power_law_exponent": power_exponent(name)} for quantity, name in sets.items()}
    return {"filling": functions, "discharge": functions}


def power_exponent(set_name):
    """Function that gives the exponent of the power law with a set's values; NaN for slender silos, which go without it."""

    def function(**given):
        mu, k, _ = characteristic(set_name, **take(given, PROPERTIES))
        own = {"contact": given["contact_depth"], **take(given, ("hydraulic_radius", "repose_angle"))}
        n = cylinder.power_exponent(mu=mu, k=k, **own)
        return np.where(given["cylinder_depth"] / given["diameter"] >= cylinder.SLENDER, np.nan, n)

    names = (*PROPERTIES, "hydraulic_radius", "contact_depth", "repose_angle", "cylinder_depth", "diameter")
    return asking(function, names, f"Exponent n (1) of the power law with the set {set_name}. {SEEN}", None)


def numbers(phase, increases=factors.USUAL):
    """The slenderness class and the least action assessment class (1), and in discharge C_h and C_w (1)."""
    functions = {"slenderness_class": cylinder.slenderness_class, "least_assessment_class": classes.least_class}
    return functions | (dict(increases) if phase == "discharge" else {})
