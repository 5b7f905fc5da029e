"""Jenike and Johanson (1969): initial, switch and flow loads of a mass-flow bin, in the cylinder and in the hopper.

Cylinder: Janssen throughout.  Hopper: the wall pressure rises from the apex along a radial stress field to a peak at i
times the hopper's height and falls straight to zero at the transition; i and the peak follow from vertical equilibrium
under the transition load Q_c.  Where Q_c is more than the field can hold, i = 1 and the rest is a ring force P at the
transition.  Below the travelling switch the flow field acts, above it the initial one, and the difference of the two
vertical forces is a ring force at the switch.
"""

from collections.abc import Callable

import numpy as np

from silostudy.pressure import hopper_shape, janssen
from silostudy.pressure.calls import asking, call, parameters_of
from silostudy.pressure.family import CONE_OR_WEDGE, PressureMethod
from silostudy.pressure.radial_field import flow_slope, initial_slope

INITIAL_RATIO = 0.8  # K of the source's Fig. 5
NEAREST = 1e-9  # of the hopper's height: where the mean pressure at the apex is read, which is 0/0 there
SHAPE = ("diameter", "hydraulic_radius", "perimeter", "hopper_half_angle", "slot")


def initial_field(*, hopper_half_angle, hopper_wall_friction, slot):
    """Slope (1) of the initial wall pressure: over unit weight and height above the apex; NaN where no field exists.

    Source: radial_field.  Many mass-flow hoppers have none: the wall is too smooth to hold a peaked field, whose peak would
    sink to the apex.
    """
    slope = initial_slope(hopper_half_angle, hopper_wall_friction, INITIAL_RATIO, slot)
    return np.where(np.isfinite(slope), slope, np.nan)


def flow_field(*, hopper_half_angle, hopper_wall_friction, effective_friction_angle, slot):
    """Slope (1) of the wall pressure in flow: over unit weight and height above the apex. Source: radial_field."""
    return flow_slope(hopper_half_angle, hopper_wall_friction, effective_friction_angle, slot)


class State:
    """The hopper's contents in equilibrium on a field of the given slope, under a share `loaded` of the transition load.

    Source: silo_handbook, section 4.5.2: triangle of wall pressure with its peak at i times the hopper's height,
    p = gamma D / [2 (1 + m i) (tan theta + tan phi')] without load; i from s i (1 + m i) T = 1 + Q/W, T = 1 + mu / tan theta.
    """

    def __init__(self, field, given, loaded=1.0):
        self.m, self.slope = 1 - given["slot"], call(field, None, given)
        self.height = hopper_shape.apex_height(given["diameter"], given["hopper_half_angle"])
        self.steepness = hopper_shape.steepness(given["hopper_half_angle"], given["hopper_wall_friction"])
        self.hydrostatic = given["unit_weight"] * self.height
        self.weight = given["unit_weight"] * hopper_shape.contents(self.height, **{name: given[name] for name in SHAPE})
        load = 1 + loaded * call(janssen.transition_force, None, given) / self.weight
        self.bearing = self.slope * self.steepness * (1 + self.m)  # of the whole field, in weights of the contents
        self.carried = np.minimum(load, self.bearing)
        self.ring_force = self.weight * (load - self.carried)
        share = self.carried / (self.slope * self.steepness)
        self.peak = 2 * share / (1 + np.sqrt(1 + 4 * self.m * share))
        self.largest = self.hydrostatic * self.carried / (self.steepness * (1 + self.m * self.peak))

    def normal_pressure(self, x):
        """Wall normal pressure (Pa) at height x (m) above the apex."""
        share, peak = np.broadcast_arrays(x / self.height, self.peak)
        rising = np.divide(share, peak, out=np.ones_like(share), where=peak > 0)
        falling = np.divide(1 - share, 1 - peak, out=np.ones_like(share), where=peak < 1)
        return self.largest * np.where(share <= peak, rising, falling)

    def force(self, x):
        """Downward force (N) through the level at height x (m): what the wall carries below, less the weight below."""
        share, peak = np.broadcast_arrays(x / self.height, self.peak)
        below = np.minimum(share, peak)
        rising = np.divide(below ** (self.m + 2), peak * (self.m + 2), out=np.zeros_like(share), where=peak > 0)
        width = np.divide(share - below, 6 * (1 - peak), out=np.zeros_like(share), where=peak < 1)
        points = ((1, below), (4, (below + share) / 2), (1, share))  # Simpson's rule is exact for these polynomials
        falling = width * sum(weight * place**self.m * (1 - place) for weight, place in points)
        scale = self.largest * self.steepness / self.hydrostatic * (1 + self.m) * (2 + self.m)
        return self.weight * (scale * (rising + falling) - share ** (2 + self.m))

    def field_force(self, x):
        """Downward force (N) that the radial field alone passes through the level at height x (m)."""
        return self.weight * (self.bearing - 1) * (x / self.height) ** (2 + self.m)


OF_STATE = ("unit_weight", "hopper_wall_friction", *parameters_of(janssen.transition_force), *SHAPE)
FIELDS: dict[str, Callable] = {"filling": initial_field, "discharge": flow_field}


def _of(phase, quantity, doc, place=None, extra=()):
    """A method function that sets up the state of a phase and reads one quantity off it."""
    field = FIELDS[phase]

    def function(*places, **given):
        return quantity(State(field, given), *places, given)

    return asking(function, (*OF_STATE, *parameters_of(field), *extra), f"{doc} Source: silo_handbook, section 4.5.2.", place)


def _hopper(phase):
    def mean(state, x, given):
        level = np.maximum(x, NEAREST * state.height)
        return state.force(level) / hopper_shape.area(level, **{name: given[name] for name in SHAPE})

    def traction(state, x, given):
        return given["hopper_wall_friction"] * state.normal_pressure(x)

    return {
        "hopper_normal_pressure": _of(
            phase, lambda state, x, given: state.normal_pressure(x), "Wall normal pressure (Pa) at height x (m).", "x"
        ),
        "hopper_friction_traction": _of(phase, traction, "Wall friction traction (Pa) at height x (m).", "x"),
        "hopper_vertical_pressure": _of(phase, mean, "Mean vertical pressure (Pa) at height x (m).", "x"),
    }


def _totals(phase):
    def outlet(state, given):
        return state.force(hopper_shape.outlet_height(given["outlet_width"], given["hopper_half_angle"]))

    def coefficient(state, given):
        size = given["unit_weight"] * given["diameter"] ** (2 + state.m) * given["length"] ** given["slot"]
        force = state.field_force(state.height) / size
        return np.where(np.isfinite(force), force, np.nan)

    def unloaded(state, given):
        return State(FIELDS[phase], given, loaded=0.0).peak

    return {
        "transition_force": janssen.transition_force,
        "ring_force": _of(phase, lambda state, given: state.ring_force, "Ring force P (N) at the transition: Q_c - Q_n."),
        "outlet_force": _of(phase, outlet, "Downward force (N) on the outlet.", extra=("outlet_width",)),
        "peak_height": _of(phase, lambda state, given: state.peak * state.height, "Height (m) of the peak above the apex."),
        "unloaded_peak_position": _of(phase, unloaded, "Height of the peak without load over the hopper's height (1): i_n."),
        "radial_force_coefficient": _of(
            phase, coefficient, "Force of the radial field over gamma D^(2+m) L^(1-m) (1): q_n.", extra=("length",)
        ),
    }


def _switch_force(x, **given):
    initial, flow = State(initial_field, given), State(flow_field, given)
    return np.maximum(initial.force(x) - flow.field_force(x), 0.0)


SWITCH = {
    "switch_force": asking(
        _switch_force,
        (*OF_STATE, *parameters_of(flow_field)),
        "Ring force (N) on the wall while the switch from the initial to the flow field stands at height x (m): what the "
        "initial field passes down there less what the flow field takes up. Source: silo_handbook, section 4.5.2.",
        "x",
    )
}

ROW = PressureMethod(
    key="jenike_1969",
    rank=60,
    title="Jenike & Johanson 1969",
    source="silo_handbook",
    locator="section 4.5.2",
    phases={"filling": janssen.STATE, "switch": janssen.STATE, "discharge": janssen.STATE},
    initial_state="peaked radial field (K = 0.8)",
    hopper={"filling": _hopper("filling"), "switch": SWITCH, "discharge": _hopper("discharge")},
    totals={"filling": _totals("filling"), "discharge": _totals("discharge")},
    static=janssen.normal_pressure,
    plans=CONE_OR_WEDGE,
    formula="cylinder: Janssen; hopper: p_n = gamma h (1 + Q_c/W) / [T (1 + m i)] at i times the hopper's height h, straight "
    "to zero at the apex and the transition, s i (1 + m i) T = 1 + Q_c/W, T = 1 + mu/tan(theta), s the slope of the radial "
    "field; beyond i = 1 a ring force P = Q_c - Q_n at the transition",
    validity="hopper: in flow masked where no arched radial field exists (a cone beyond the mass-flow limit), in filling and "
    "at the switch where no peaked one does (a smooth wall, as in many mass-flow hoppers: jenike_mass_flow has another initial "
    "state); initial field with K = 0.8 as the share of the radial stress, an assumption: the source names K without "
    "defining it; no published numbers (the source's charts Figs. 5 and 6 are lost in the copy read): checked by vertical "
    "equilibrium, by the stress-field equations on a finer mesh and against the mass-flow limit",
    colour="#B2182B",
    marker="X",
    equilibrium=("filling", "switch", "discharge"),
)
