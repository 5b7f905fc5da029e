"""AS 3774-1996, swelling of the stored solid between stiff walls and a stiff floor: the solid pushes the wall upward.

A load case of its own, where the moisture rises by more than one per cent; it grows without bound with depth.
"""

import numpy as np

from silostudy.pressure import janssen
from silostudy.pressure.calls import asking
from silostudy.pressure.family import CIRCULAR, SLOT, PressureMethod
from silostudy.pressure.saturation import growth, growth_excess

RATIO = 1.0  # k_sw, horizontal over vertical pressure of the swelling solid
GIVEN = ("unit_weight", "hydraulic_radius", "wall_friction")
SEEN = "Source: as3774_1996, second-hand (one account), and vertical equilibrium with reversed friction."


def _depth(z, given):
    """Relative depth z/z_o (1), z_o = r_c/(mu k_sw)."""
    return z * given["wall_friction"] * RATIO / given["hydraulic_radius"]


def swelling_pressure(z, given):
    """Swelling pressure p_sw (Pa) at depth z (m): (gamma r_c/mu)(exp(z/z_o) - 1), z_o = r_c/(mu k_sw)."""
    return RATIO * given["unit_weight"] * z * growth(_depth(z, given))


def wall_tension(z, given):
    """Tension of the wall per metre of perimeter (N/m) at depth z (m): gamma r_c [z_o (exp(z/z_o) - 1) - z]."""
    depth = _depth(z, given)
    return given["unit_weight"] * given["hydraulic_radius"] * z * depth * growth_excess(depth)


def _function(of, doc):
    return asking(lambda z, **given: of(z, given), GIVEN, f"{doc} at depth z (m). {SEEN}")


STATE = {
    "wall_normal_pressure": _function(swelling_pressure, "Wall pressure (Pa) of the swelling solid"),
    "wall_friction_traction": _function(
        lambda z, given: -given["wall_friction"] * swelling_pressure(z, given),
        "Friction (Pa), upward on the wall and so negative,",
    ),
    "vertical_pressure": _function(
        lambda z, given: swelling_pressure(z, given) / RATIO, "Vertical pressure (Pa), on the floor too,"
    ),
    "axial_wall_force": _function(lambda z, given: -wall_tension(z, given), "Axial wall force (N/m), tension and so negative,"),
}
ROW = PressureMethod(
    key="as3774_1996_swelling",
    rank=171,
    title="AS 3774-1996, swelling of the solid (one source)",
    source="as3774_1996",
    locator="second-hand account (printed standard not seen)",
    phases={"filling": STATE},
    static=janssen.normal_pressure,
    plans=CIRCULAR | SLOT,
    formula="p_sw = (gamma r_c/mu)(exp(z/z_o) - 1), z_o = r_c/(mu k_sw), k_sw = 1; friction mu p_sw upward",
    used={"filling": janssen.for_state({"lateral_pressure_ratio": asking(lambda: np.float64(RATIO), (), "k_sw (1).", None)})},
    validity="a load case of its own: the moisture of the solid at rest rises by more than one per cent on a stiff floor; wall "
    "friction as handed over, the account takes the upper one; no published numbers: checked by equilibrium",
    colour="#C51B7D",
    marker="$w$",
    equilibrium=("filling",),
    on_request=True,
)
