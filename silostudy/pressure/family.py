"""The row of a pressure method: which quantity it gives in which phase, from which parameters."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field

import numpy as np

from silostudy.catalogue import Row
from silostudy.pressure.calls import asking, call, first_line, parameters_of
from silostudy.pressure.limits import Limit, broken
from silostudy.pressure.parameters import PARAMETERS
from silostudy.soundness import check_numbers, faults_of_function, faults_of_look, faults_of_trial

PHASES = ("filling", "switch", "discharge")
USUAL_PHASES = ("filling", "discharge")
QUANTITIES = {
    "wall_normal_pressure": "Pa",
    "wall_friction_traction": "Pa",
    "vertical_pressure": "Pa",
    "axial_wall_force": "N m-1",
    "accompanying_wall_pressure": "Pa",
}
USUAL_QUANTITIES = ("wall_normal_pressure", "wall_friction_traction", "vertical_pressure", "axial_wall_force")
# on the hopper wall, over the height above the hopper's apex
HOPPER_QUANTITIES = {
    "hopper_normal_pressure": "Pa",
    "hopper_friction_traction": "Pa",
    "hopper_vertical_pressure": "Pa",
    "hopper_end_normal_pressure": "Pa",
    "hopper_end_friction_traction": "Pa",
    "switch_force": "N",
}
# on a flat floor, over the distance from the axis
FLOOR_QUANTITIES = {"floor_normal_pressure": "Pa", "floor_shear_traction": "Pa"}
# one number for the whole silo; the last ones are the numbers behind the others
TOTALS = {
    "transition_force": "N",
    "ring_force": "N",
    "outlet_force": "N",
    "peak_height": "m",
    "unloaded_peak_position": "1",
    "radial_force_coefficient": "1",
    "design_unit_weight": "N m-3",
    "averaging_height": "m",
    "patch_pressure": "Pa",
    "patch_depth": "m",
    "patch_height": "m",
    "patch_resultant": "N",
    "band_pressure": "Pa",
    "bottom_pressure": "Pa",
    "bottom_load_magnifier": "1",
    "slenderness_class": "1",
    "least_assessment_class": "1",
    "normal_pressure_increase": "1",
    "wall_friction_increase": "1",
    "patch_load_factor": "1",
    "hopper_steep": "1",
    "hopper_effective_friction": "1",
    "hopper_pressure_ratio": "1",
    "hopper_exponent": "1",
    "hopper_flow_angle": "rad",
    "far_side_increase": "1",
    "far_side_depth": "m",
    "far_side_pressure": "Pa",
    "near_side_decrease": "1",
    "near_side_half_angle": "rad",
    "eccentric_band_height": "m",
}
# on the wall of a silo in large eccentric discharge, by the size of the flow channel
CHANNEL_SIZES = (0.25, 0.40, 0.60)  # k_c: radius of the channel over that of the silo
CHANNEL_QUANTITIES = {
    "channel_normal_pressure": "Pa",
    "channel_friction_traction": "Pa",
    "static_normal_pressure": "Pa",
    "static_friction_traction": "Pa",
    "adjacent_normal_pressure": "Pa",
    "adjacent_friction_traction": "Pa",
    "channel_resultant": "N m-1",
}
CHANNEL_TOTALS = {
    "channel_half_width": "rad",
    "channel_eccentricity": "m",
    "channel_radius": "m",
    "channel_shear": "N",
    "channel_moment": "N m",
}
# values that a method reckons with, after caps and factors, by what it reckons
USED = {
    "unit_weight": "N m-3",
    "internal_friction_angle": "rad",
    "wall_friction": "1",
    "wall_friction_uncapped": "1",
    "lateral_pressure_ratio": "1",
    "power_law_exponent": "1",
}
ON_HOPPER = "hopper"
USED_FOR = (*QUANTITIES, ON_HOPPER)
OF_HOPPER = frozenset(
    {"transition_force", "ring_force", "outlet_force", "peak_height", "unloaded_peak_position", "radial_force_coefficient"}
    | {name for name in TOTALS if name.startswith("hopper_")}
)
PLANS = ("circular", "square", "rectangular", "polygonal", "slot")
SLOT = frozenset({"slot"})
ANY_PLAN = frozenset(PLANS)
CELLS = ANY_PLAN - SLOT
CIRCULAR = frozenset({"circular"})
CONE_OR_WEDGE = CIRCULAR | SLOT
PYRAMID = frozenset({"square", "rectangular"})
WITH_HOPPER = CONE_OR_WEDGE | PYRAMID

# Why a value is masked: position = flag value in the cube.
REASONS = (
    "in_scope",
    "quantity_not_defined_by_source",
    "phase_not_covered",
    "plan_not_covered",
    "solid_property_missing",
    "outside_published_range",
    "above_wall_contact",
    "no_hopper",
    "no_flat_floor",
)
IN_SCOPE, NO_QUANTITY, NO_PHASE, NO_PLAN, NO_PROPERTY, OUT_OF_RANGE, ABOVE_CONTACT, NO_HOPPER, NO_FLOOR = range(len(REASONS))

# a curve of its own; a thin one, of the handbook; one edge of a band, of a set of characteristic values; a dotted one, of a
# reading that leaves the source's misprints in; none
DRAWN = ("curve", "handbook", "set", "misprint", "none")

Quantities = Mapping[str, Callable]


@dataclass(frozen=True, kw_only=True)
class PressureMethod(Row):
    """A theory or design code.

    phases: phase -> quantity -> function(z, *, parameters) in SI; NaN from a function means outside its published range.
    static: function for the method's own static Janssen pressure, over which its overpressure factor is counted.
    as_printed: the same as `phases` with the source's misprints left in, where they change a formula.
    misprinted_table: the source misprints one of the method's parameters (tables/solids_by_method.csv).
    equilibrium: phases in which weight = vertical pressure + wall friction holds to rounding.
    hopper: phase -> quantity -> function(x, *, parameters), x the height (m) above the hopper's apex.
    floor: phase -> name of FLOOR_QUANTITIES -> function(x, *, parameters), x the distance (m) from the axis.
    totals: phase -> name of TOTALS -> function(*, parameters).
    limits: the method's range as data; beyond it values are masked.
    plans_of: plans of quantities that do not cover all of the method's.
    channel: phase -> name of CHANNEL_QUANTITIES or CHANNEL_TOTALS -> function([z,] *, channel_size, parameters).
    values: which quantity is computed with which characteristic values, where they differ from those handed over.
    used: phase -> what is reckoned -> parameter of USED -> function(*, parameters), where it is not the value handed over.
    varies: parameters that the method itself takes at several values: no switch of the scene moves them.
    not_computed: what the source treats and the method leaves out, for want of checked formulas.
    table_key: method under which the tables keep its own values, where several rows share them.
    on_request: stands on one source alone, so that `all` leaves it out and a study has to name it.
    number: how the handbook numbers the curve in Fig. 4.2.11; empty where it is not in that figure.
    initial_state: from which state in the hopper the switch to flow starts.
    drawn: one of DRAWN: how a figure that compares many methods shows it; drawn_as_printed: how its reading with misprints.
    """

    phases: Mapping[str, Quantities]
    static: Callable
    plans: frozenset[str]
    formula: str
    validity: str
    colour: str
    marker: str
    on_request: bool = False
    number: str = ""
    drawn: str = "curve"
    drawn_as_printed: str = "none"
    initial_state: str = ""
    as_printed: Mapping[str, Quantities] = field(default_factory=dict)
    misprinted_table: bool = False
    equilibrium: tuple[str, ...] = ()
    hopper: Mapping[str, Quantities] = field(default_factory=dict)
    floor: Mapping[str, Quantities] = field(default_factory=dict)
    totals: Mapping[str, Quantities] = field(default_factory=dict)
    limits: tuple[Limit, ...] = ()
    plans_of: Mapping[str, frozenset[str]] = field(default_factory=dict)
    channel: Mapping[str, Quantities] = field(default_factory=dict)
    values: Mapping[str, str] = field(default_factory=dict)
    used: Mapping[str, Mapping[str, Quantities]] = field(default_factory=dict)
    varies: frozenset[str] = frozenset()
    not_computed: tuple[str, ...] = ()
    table_key: str = ""

    @property
    def has_misprint(self) -> bool:
        """Whether the method can be asked for as printed."""
        return bool(self.as_printed) or self.misprinted_table

    @property
    def needs(self) -> frozenset[str]:
        """Names of all parameters that its functions and its limits ask for."""
        tables = (
            quantities
            for table in (self.phases, self.hopper, self.floor, self.totals, self.channel)
            for quantities in table.values()
        )
        functions = [self.static, *(function for quantities in tables for function in quantities.values())]
        functions += [limit.measure.of for limit in self.limits]
        return frozenset(name for function in functions for name in parameters_of(function))

    @property
    def range(self) -> str:
        """The limits in words, then what else there is to say of the method's range."""
        return "; ".join((*dict.fromkeys(limit.words() for limit in self.limits), self.validity))

    def covers(self, quantity: str) -> frozenset[str]:
        """Plans for which the method gives a quantity; below a circle lies a cone, a slot a wedge, a rectangle a pyramid."""
        plans = self.plans_of.get(quantity, self.plans)
        return plans & WITH_HOPPER if quantity in HOPPER_QUANTITIES or quantity in OF_HOPPER else plans

    def bounded(self, phase: str) -> Quantities:
        """Functions by quantity in a phase, NaN beyond the method's limits."""
        return {name: self._bounded(name, phase, function) for name, function in self.phases.get(phase, {}).items()}

    def _bounded(self, name: str, phase: str, function: Callable) -> Callable:
        def within(z, **given):
            return np.where(broken(self.limits, name, phase, z, given), np.nan, call(function, z, given))

        here = (limit.measure.of for limit in self.limits if limit.holds_for(name, phase))
        limiting = [asked for measure in here for asked in parameters_of(measure)]
        return asking(within, (*parameters_of(function), *limiting), first_line(function))

    def faults(self) -> Iterator[str]:
        """Faults of the row, in words."""
        yield from super().faults()
        yield from faults_of_look(self)
        for name in ("drawn", "drawn_as_printed"):
            if getattr(self, name) not in DRAWN:
                yield f"{name} = {getattr(self, name)!r}: must be one of {', '.join(DRAWN)}"
        yield from _faults_of_names(self)
        for name, function, unit, place in _functions(self):
            faults = list(faults_of_function(name, function, unit, parameters_of(function), PARAMETERS))
            yield from faults or faults_of_trial(name, lambda f=function, p=place: _tried(f, p))  # type: ignore[misc]


def usual(rows: Mapping[str, PressureMethod]) -> tuple[str, ...]:
    """Keys of the methods that the word all stands for."""
    return tuple(key for key, row in rows.items() if not row.on_request)


def _faults_of_names(row: PressureMethod) -> Iterator[str]:
    for name, given, known in (
        ("plans", row.plans, PLANS),
        ("phases", row.phases, PHASES),
        ("equilibrium", row.equilibrium, row.phases),
        *((f"phases[{phase!r}]", functions, QUANTITIES) for phase, functions in row.phases.items()),
        *((f"hopper[{phase!r}]", functions, HOPPER_QUANTITIES) for phase, functions in row.hopper.items()),
        *((f"floor[{phase!r}]", functions, FLOOR_QUANTITIES) for phase, functions in row.floor.items()),
        *((f"totals[{phase!r}]", functions, TOTALS) for phase, functions in row.totals.items()),
        *((f"channel[{phase!r}]", functions, CHANNEL_QUANTITIES | CHANNEL_TOTALS) for phase, functions in row.channel.items()),
        *((f"used[{phase!r}]", functions, USED_FOR) for phase, functions in row.used.items()),
        *((f"used[{phase!r}]", numbers, USED) for phase, functions in row.used.items() for numbers in functions.values()),
        ("varies", row.varies, PARAMETERS),
        ("plans_of", row.plans_of, QUANTITIES | HOPPER_QUANTITIES | FLOOR_QUANTITIES | TOTALS),
    ):
        if isinstance(given, str):
            yield f"{name} = {given!r}: must be several, as {{{given!r}}}"
        elif strange := [asked for asked in given if asked not in known]:
            yield f"{name}: {', '.join(map(str, strange))} unknown; known: {', '.join(known)}"
    if not row.plans or not row.phases:
        yield "plans and phases must not be empty"
    spread = {"a_mu": "wall_friction", "a_K": "lateral_pressure_ratio"}
    if switched := [spread[name] for name in spread if name in row.needs and spread[name] not in row.varies]:
        yield f"varies: must name {', '.join(switched)}, whose spread the method asks for"
    for phase, functions in row.phases.items():
        if "wall_normal_pressure" not in functions:
            yield f"phases[{phase!r}]: must give wall_normal_pressure"


def _functions(row: PressureMethod) -> Iterator[tuple[str, Callable, str, str | None]]:
    """Name, function, unit and name of its place (or none) of every function of a row."""
    yield "static", row.static, "Pa", "z"
    for tables, units, place in (
        (row.phases, QUANTITIES, "z"),
        (row.hopper, HOPPER_QUANTITIES, "x"),
        (row.floor, FLOOR_QUANTITIES, "x"),
        (row.totals, TOTALS, None),
        (row.channel, CHANNEL_QUANTITIES, "z"),
        (row.channel, CHANNEL_TOTALS, None),
    ):
        for phase, functions in tables.items():
            here = {name: function for name, function in functions.items() if tables is not row.channel or name in units}
            yield from ((f"{name} in {phase}", function, units.get(name, ""), place) for name, function in here.items())


def _tried(function: Callable, place: str | None) -> None:
    """Calls a function on two usual silos at once, at three depths or heights."""
    usual = {name: np.full((2, 1), value) for name, (_, _, value) in PARAMETERS.items()}
    where = None if place is None else np.array([[0.5, 1.0, 1.5]] * 2)
    with np.errstate(all="ignore"):
        values = check_numbers(lambda: call(function, where, usual))
    np.broadcast_to(values, (2, 1) if where is None else where.shape)
