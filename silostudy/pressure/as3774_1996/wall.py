"""AS 3774-1996 on vertical walls: pressures after filling, of squat containers too, and in flow.

z counts from the equivalent surface.  In a squat container the pressure rises from the highest wall contact in a straight line
to Janssen's at one and a half times that depth; the friction does the same, and what hangs on the wall is its integral.
"""

import numpy as np

from silostudy.pressure import janssen
from silostudy.pressure.calls import asking, call, first_line, parameters_of

LEAST_RATIO = 0.35  # lower end of the lateral pressure ratio k
SQUAT = 1.0  # h_b / d_c below which a container is squat
RAMP = 0.5  # of the contact's depth, over which the pressure rises
SOFTEST = 0.85  # least share of the pressure that stays on a flexible wall
SOLID = ("unit_weight", "hydraulic_radius", "wall_friction")
GIVEN = (*SOLID, "internal_friction_angle", "contact_depth", "cylinder_depth", "diameter")
SOFT = ("wall_flexibility", "solid_modulus_factor", "circular")
SEEN = "Source: as3774_1996, second-hand."


def lateral_ratio(wall_friction, internal_friction_angle):
    """Lateral pressure ratio k (1): [1 + sin^2 f - 2 sqrt(sin^2 f - mu^2 cos^2 f)]/(4 mu^2 + cos^2 f), at least 0.35.

    Source: as3774_1996, second-hand.
    """
    sine, cosine = np.sin(internal_friction_angle), np.cos(internal_friction_angle)
    root = np.sqrt(np.maximum(sine**2 - (wall_friction * cosine) ** 2, 0.0))
    return np.maximum((1 + sine**2 - 2 * root) / (4 * wall_friction**2 + cosine**2), LEAST_RATIO)


def _janssen(quantity, z, given):
    """A quantity of Janssen's state with the code's own lateral pressure ratio."""
    ratio = lateral_ratio(given["wall_friction"], given["internal_friction_angle"])
    return janssen.STATE[quantity](z, **{name: given[name] for name in SOLID}, lateral_pressure_ratio=ratio)


def is_squat(given):
    """Whether a container is squat. Source: as3774_1996, second-hand: h_b/d_c < 1, h_b read as the cylinder's depth."""
    return given["cylinder_depth"] / given["diameter"] < SQUAT


def _squat_share(z, given):
    """Pressure over Janssen's at the ramp's end (1) within the ramp of a squat container; NaN beyond it and in others."""
    contact = given["contact_depth"]
    risen = np.divide(z - contact, RAMP * contact, out=np.ones_like(z + contact), where=z + 0 * contact < (1 + RAMP) * contact)
    return np.where(is_squat(given) & (risen < 1), np.maximum(risen, 0.0), np.nan)


def wall_pressure(z, given):
    """Wall pressure p_ni (Pa) on a rigid wall at depth z (m): Janssen's, and in a squat container the ramp up to it.

    Source: as3774_1996, second-hand (two accounts of the ramp): 0 at h_o, straight to Janssen's value at 1.5 h_o.
    """
    share = _squat_share(z, given)
    end = _janssen("wall_normal_pressure", (1 + RAMP) * given["contact_depth"], given)
    return np.where(np.isnan(share), _janssen("wall_normal_pressure", z, given), np.nan_to_num(share) * end)


def traction(z, given):
    """Wall friction (Pa) at depth z (m): mu times the pressure on a rigid wall. Source: as3774_1996, second-hand."""
    return given["wall_friction"] * wall_pressure(z, given)


def axial_force(z, given):
    """Axial wall force (N/m) above depth z (m): the friction integrated.

    Source: as3774_1996, second-hand: Janssen's; in a squat container the ramp's triangle, then Janssen's growth below it.
    """
    share, contact = _squat_share(z, given), given["contact_depth"]
    end = (1 + RAMP) * contact
    ramp = given["wall_friction"] * _janssen("wall_normal_pressure", end, given) * RAMP * contact / 2  # of the whole triangle
    deep = _janssen("axial_wall_force", z, given)
    below = deep - np.where(is_squat(given), _janssen("axial_wall_force", end, given) - ramp, 0.0)
    return np.where(np.isnan(share), below, ramp * np.nan_to_num(share) ** 2)


def vertical_pressure(z, given):
    """Mean vertical pressure (Pa) at depth z (m) in equilibrium with the wall friction.

    Source: as3774_1996, second-hand, Janssen's; of squat containers equilibrium: the account has gamma z, see `load`.
    """
    hung = given["unit_weight"] * z - axial_force(z, given) / given["hydraulic_radius"]
    return np.where(is_squat(given), hung, _janssen("vertical_pressure", z, given))


def load(given):
    """Mean vertical pressure p_vi (Pa) on a floor or hopper at the transition.

    Source: as3774_1996, second-hand: gamma z in squat containers, as if nothing hung on the wall (one account), else Janssen's.
    """
    z = given["cylinder_depth"]
    return np.where(is_squat(given), given["unit_weight"] * z, _janssen("vertical_pressure", z, given))


def flexibility_factor(z, given):
    """Factor psi (1) on the pressure for the flexible wall of a squat circular container at depth z (m).

    Source: as3774_1996, second-hand (two accounts): 1 - E_s (d_c/2)/(E_w t) >= 0.85, E_s = chi p_vi (one account); 1 where the
    wall is said to be rigid.
    """
    modulus = given["solid_modulus_factor"] * given["unit_weight"] * z
    softened = np.maximum(1 - modulus * given["diameter"] / 2 * given["wall_flexibility"], SOFTEST)
    return np.where(is_squat(given) & (given["circular"] == 1), softened, 1.0)


def normal_pressure(z, given):
    """Wall pressure p_ni (Pa) on the wall as stiff as it is at depth z (m). Source: as3774_1996, second-hand."""
    return flexibility_factor(z, given) * wall_pressure(z, given)


STATE = {
    "wall_normal_pressure": (normal_pressure, (*GIVEN, *SOFT)),
    "wall_friction_traction": (traction, GIVEN),
    "vertical_pressure": (vertical_pressure, GIVEN),
    "axial_wall_force": (axial_force, GIVEN),
}


def _initial(quantity):
    of, names = STATE[quantity]
    return asking(lambda z, **given: of(z, given), names, f"{first_line(janssen.STATE[quantity])} {SEEN}")


INITIAL = {quantity: _initial(quantity) for quantity in STATE}


def flow_factor(*, cylinder_depth, diameter, slot):
    """Factor c_nf (1) of flow over initial pressure.

    Source: as3774_1996, second-hand: max((7.6 (h_b/d_c)^0.06 - 6.4) c_c, 1.2 c_c), c_c 1 axisymmetric, 1.2 planar.
    """
    slenderness, plane = cylinder_depth / diameter, np.where(slot == 1, 1.2, 1.0)
    return np.maximum(7.6 * slenderness**0.06 - 6.4, 1.2) * plane


def friction_factor(*, slot):
    """Flow over initial wall friction (1): 1.2, planar 1.4. Source: as3774_1996, second-hand."""
    return np.where(slot == 1, 1.4, 1.2)


def _flow(quantity, factor):
    initial = INITIAL[quantity]

    def function(z, **given):
        return call(factor, None, given) * call(initial, z, given)

    return asking(function, (*parameters_of(initial), *parameters_of(factor)), f"{initial.__doc__} In flow.")


FLOW = {
    "wall_normal_pressure": _flow("wall_normal_pressure", flow_factor),
    "wall_friction_traction": _flow("wall_friction_traction", friction_factor),
}
