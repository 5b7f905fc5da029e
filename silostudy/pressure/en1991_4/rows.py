"""EN 1991-4:2006 as methods: the design pressures, and one state of equilibrium for each set of characteristic values."""

from typing import Any

import numpy as np

from silostudy.pressure import hopper_shape, janssen
from silostudy.pressure.en1991_4 import cylinder, hopper
from silostudy.pressure.en1991_4.characteristic import PROPERTIES, characteristic, described
from silostudy.pressure.family import CELLS, SLOT, PressureMethod, asking

CYLINDER = ("unit_weight", "hydraulic_radius", "diameter", "cylinder_depth", "repose_angle", "circular", *PROPERTIES)
PATCH = (*CYLINDER, "patch_factor", "eccentricity")
HOPPER = (*CYLINDER, "slot", "perimeter", "hopper_half_angle", "hopper_wall_friction")
SHAPE = ("diameter", "perimeter", "hopper_half_angle", "slot")
INCREASE = {
    "wall_normal_pressure": cylinder.NORMAL_INCREASE,
    "wall_friction_traction": cylinder.FRICTION_INCREASE,
    "axial_wall_force": cylinder.FRICTION_INCREASE,
}
QUANTITY_SETS = {
    "wall_normal_pressure": "wall_normal",
    "wall_friction_traction": "wall_friction",
    "axial_wall_force": "wall_friction",
    "vertical_pressure": "vertical_load",
}
SEEN = "Source: en1991_4_2006 (printed standard not seen; agrees in two or more public programs)."
DOCS = {
    "wall_normal_pressure": "Wall normal pressure (Pa) at depth z (m).",
    "wall_friction_traction": "Wall friction traction (Pa) at depth z (m).",
    "axial_wall_force": "Axial wall force per metre of perimeter (N/m, compression positive) at depth z (m).",
    "vertical_pressure": "Mean vertical pressure (Pa) at depth z (m).",
}


def take(given, names):
    """The named parameters out of all that were handed over."""
    return {name: given[name] for name in names}


def filled(z, set_name, given):
    """(p_h, p_v, mu) after filling with a set's characteristic values."""
    mu, k, _ = characteristic(set_name, **take(given, PROPERTIES))
    names = ("unit_weight", "hydraulic_radius", "diameter", "cylinder_depth", "repose_angle", "circular")
    return *cylinder.pressures(z, mu=mu, k=k, **take(given, names)), mu


def read_off(quantity, z, set_name, given):
    """One quantity of a filling state; the axial force is the friction integrated, R (gamma z - p_v)."""
    p_h, p_v, mu = filled(z, set_name, given)
    weight = given["unit_weight"] * z
    return {
        "wall_normal_pressure": p_h,
        "wall_friction_traction": mu * p_h,
        "axial_wall_force": given["hydraulic_radius"] * (weight - p_v),
        "vertical_pressure": p_v,
    }[quantity]


def on_cylinder(quantity, set_name, phase):
    """A method function for one quantity with one set, increased in discharge."""

    def function(z, **given):
        value = read_off(quantity, z, set_name, given)
        if phase == "discharge":
            value = value * cylinder.discharge_factor(INCREASE[quantity], **take(given, ("diameter", "cylinder_depth")))
        return value

    return asking(function, CYLINDER, f"{DOCS[quantity]} {SEEN}")


def phases(sets):
    """phase -> quantity -> function, with the set of each quantity; p_v in discharge was not verified."""
    return {
        "filling": {quantity: on_cylinder(quantity, name, "filling") for quantity, name in sets.items()},
        "discharge": {q: on_cylinder(q, name, "discharge") for q, name in sets.items() if q in INCREASE},
    }


def hopper_state(phase, given):
    """(mu_heff, F, weight, exponent, p_vft) of the hopper; F is NaN for wedges (not verified).

    Discharge in a shallow hopper is taken as filling: as one public program has it (sandtes_silo).
    """
    properties = take(given, PROPERTIES) | {"wall_friction": given["hopper_wall_friction"]}
    beta = given["hopper_half_angle"]
    mu, k, _ = characteristic("hopper_filling", **properties)
    effective = hopper.effective_friction(beta, mu, k)
    ratio = hopper.filling_ratio(beta, effective)
    if phase == "discharge":
        mu, k, phi = characteristic("hopper_discharge", **properties)
        steep = hopper.is_steep(beta, mu, k)
        effective = np.where(steep, mu, effective)
        ratio = np.where(steep, hopper.discharge_ratio(beta, mu, phi), ratio)
    ratio = np.where(given["slot"] == 1, np.nan, ratio)
    height = hopper_shape.apex_height(given["diameter"], beta)
    top = filled(given["cylinder_depth"], "vertical_load", given)[1]
    return effective, ratio, given["unit_weight"] * height, hopper.exponent(ratio, beta, effective), top


def in_hopper(quantity, phase):
    """A method function for one quantity of the hopper wall."""

    def function(x, **given):
        mu, ratio, weight, exponent, top = hopper_state(phase, given)
        share = x / hopper_shape.apex_height(given["diameter"], given["hopper_half_angle"])
        p_v = hopper.vertical_pressure(share, weight=weight, exponent=exponent, top=top)
        scale = {"normal_pressure": ratio, "friction_traction": mu * ratio, "vertical_pressure": 1.0}[quantity]
        return np.where(np.isnan(ratio), np.nan, scale * p_v)

    return asking(function, HOPPER, f"{quantity.replace('_', ' ').capitalize()} (Pa) at height x (m). {SEEN}", "x")


def hopper_totals(phase):
    """Forces at the transition and the outlet (N); EN 1991-4 has no ring force."""
    p_v = in_hopper("vertical_pressure", phase)

    def transition(**given):
        top = filled(given["cylinder_depth"], "vertical_load", given)[1]
        return top * hopper_shape.area(
            hopper_shape.apex_height(given["diameter"], given["hopper_half_angle"]), **take(given, SHAPE)
        )

    def outlet(**given):
        x = hopper_shape.outlet_height(given["outlet_width"], given["hopper_half_angle"])
        area = hopper_shape.area(x, **take(given, SHAPE))
        return np.where(x > 0, area * p_v(x, **take(given, HOPPER)), 0.0)

    return {
        "transition_force": asking(transition, HOPPER, f"Downward force p_vft A (N) on the hopper. {SEEN}", None),
        "outlet_force": asking(outlet, (*HOPPER, "outlet_width"), f"Downward force (N) on the outlet. {SEEN}", None),
    }


def patch(phase):
    """The patch load of a phase: depth, height (m), pressure (Pa) and resultant (N)."""
    factor = cylinder.patch_factor_filling if phase == "filling" else cylinder.patch_factor_discharge
    normal = on_cylinder("wall_normal_pressure", "wall_normal", phase)

    def depth(**given):
        mu, k, _ = characteristic("wall_normal", **take(given, PROPERTIES))
        return cylinder.patch_depth(mu=mu, k=k, **take(given, ("hydraulic_radius", "cylinder_depth")))

    def pressure(**given):
        c_p = factor(**take(given, ("patch_factor", "eccentricity", "diameter", "cylinder_depth")))
        return c_p * normal(depth(**given), **take(given, CYLINDER))

    def resultant(**given):
        return cylinder.patch_resultant(pressure(**given), diameter=given["diameter"])

    return {
        "patch_depth": asking(depth, CYLINDER, f"Depth (m) of the patch's middle. {SEEN}", None),
        "patch_height": cylinder.patch_height,
        "patch_pressure": asking(pressure, PATCH, f"Patch pressure (Pa). {SEEN}", None),
        "patch_resultant": asking(resultant, PATCH, f"Resultant (N) of the patch on a thin steel wall. {SEEN}", None),
    }


COMMON: dict[str, Any] = {
    "source": "en1991_4_2006",
    "rank": 160,
    "locator": "as public programs carry it (printed standard not seen)",
    "static": janssen.normal_pressure,
    "plans": CELLS - {"polygonal"} | SLOT,
    "table_key": "en1991_4",
}
LEFT_OUT = (
    "retaining silos (h_c/d_c <= 0.4): masked",
    "the simplified rules of action assessment class 1, and which class asks for which load case: the user chooses",
    "wedge hoppers: the exponent that public programs carry is not in vertical equilibrium (the wall would carry 1.7 times "
    "contents and load)",
    "the bottom load magnifier C_b on the vertical load (three public programs take 1.0, 1.0 and 1.2; here 1.0), flat bottoms, "
    "pyramidal hoppers",
    "thick-walled and non-circular patch loads, the uniform increase in place of patches, rapid filling, temperature, "
    "entrained air, silage, earthquake",
)
FORMULA = (
    "p_hf = gamma R/mu (1 - exp(-z/z_o)), z_o = R/(K mu), for h_c/d_c >= 2, below it a power law; discharge times C_h, C_w; "
    "hopper p_v = gamma h/(n - 1) [x/h - (x/h)^n] + p_vft (x/h)^n, p_n = F p_v"
)

DESIGN = PressureMethod(
    key="en1991_4",
    title="EN 1991-4:2006, design",
    phases=phases(QUANTITY_SETS),
    hopper={
        phase: {
            f"hopper_{quantity}": in_hopper(quantity, phase)
            for quantity in ("normal_pressure", "friction_traction", "vertical_pressure")
        }
        for phase in ("filling", "discharge")
    },
    totals={phase: {**hopper_totals(phase), **patch(phase)} for phase in ("filling", "discharge")},
    values={
        **{quantity: described(name) for quantity, name in QUANTITY_SETS.items()},
        "hopper in filling": described("hopper_filling"),
        "hopper in discharge": described("hopper_discharge"),
        "load on the hopper": described("vertical_load"),
        "every quantity": "unit weight upper",
    },
    not_computed=LEFT_OUT,
    formula=FORMULA,
    validity="h_c/d_c > 0.4; discharge in shallow hoppers as filling (one public program); each quantity with the "
    "characteristic values that are unfavourable for it, so that together they are no single state of equilibrium (the sets' "
    "own rows are); printed standard not seen; no published numbers: checked "
    "in 50-digit arithmetic and by equilibrium",
    colour="#2166AC",
    marker="$E$",
    **COMMON,
)


def state(name: str, title: str, colour: str, marker: str) -> PressureMethod:
    """The row of one set: every quantity with the same characteristic values, so that equilibrium holds."""
    return PressureMethod(
        key=f"en1991_4_{name}",
        title=f"EN 1991-4:2006, {title}",
        phases=phases(dict.fromkeys(QUANTITY_SETS, name)),
        values={"every quantity": f"{described(name)}, unit weight upper"},
        formula=FORMULA,
        validity="h_c/d_c > 0.4; one set of characteristic values throughout; printed standard not seen; no published "
        "numbers: checked in 50-digit arithmetic and by equilibrium",
        colour=colour,
        marker=marker,
        equilibrium=("filling",),
        drawn="set",
        **COMMON,
    )


ROWS = (
    DESIGN,
    state("mean", "mean values", "#67A9CF", "1"),
    state("wall_normal", "set for the wall pressure", "#1A3F6B", "2"),
    state("wall_friction", "set for the wall friction", "#5E3C99", "3"),
    state("vertical_load", "set for the vertical load", "#B2ABD2", "4"),
)
