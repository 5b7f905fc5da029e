"""What a pressure method is: one row that says which quantity it gives in which phase, from which parameters."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from inspect import signature

from silostudy.catalogue import Row

PHASES = ("filling", "discharge")
QUANTITIES = ("wall_normal_pressure", "wall_friction_traction", "vertical_pressure", "axial_wall_force")
PLANS = ("circular", "square", "rectangular", "polygonal")
ANY_PLAN = frozenset(PLANS)
CIRCULAR = frozenset({"circular"})

# Every parameter a method may ask for: (unit, symbol); the scene room provides them by these names.
PARAMETERS = {
    "unit_weight": ("N m-3", "gamma"),
    "internal_friction_angle": ("rad", "phi"),
    "wall_friction": ("1", "mu = tan phi_o"),
    "lateral_pressure_ratio": ("1", "K"),
    "poisson_ratio": ("1", "nu"),
    "hydraulic_radius": ("m", "R = A/U"),
    "diameter": ("m", "D"),
    "cylinder_depth": ("m", "H"),
    "outlet_depth": ("m", "total depth"),
    "top_cone_height": ("m", "h"),
    "powder": ("1", "grain class"),
    "i_phi": ("1", "i"),
}

# Why a value is masked: position = flag value in the cube.
REASONS = (
    "in_scope",
    "quantity_not_defined_by_source",
    "phase_not_covered",
    "plan_not_covered",
    "solid_property_missing",
    "outside_published_range",
    "above_wall_contact",
)
IN_SCOPE, NO_QUANTITY, NO_PHASE, NO_PLAN, NO_PROPERTY, OUT_OF_RANGE, ABOVE_CONTACT = range(len(REASONS))

Quantities = Mapping[str, Callable]


@dataclass(frozen=True, kw_only=True)
class PressureMethod(Row):
    """A theory or design code.

    phases: phase -> quantity -> function(z, *, parameters) in SI; NaN from a function means outside its published range.
    static: function for the method's own static Janssen pressure, over which its overpressure factor is counted.
    as_printed: the same as `phases` with the source's misprints left in, where they change a formula.
    misprinted_table: the source misprints one of the method's parameters (tables/solids_by_method.csv).
    equilibrium: phases in which weight = vertical pressure + wall friction holds to rounding.
    number: how the handbook numbers the curve in Fig. 4.2.11; empty where it is not in that figure.
    """

    phases: Mapping[str, Quantities]
    static: Callable
    plans: frozenset[str]
    formula: str
    validity: str
    colour: str
    marker: str
    number: str = ""
    as_printed: Mapping[str, Quantities] = field(default_factory=dict)
    misprinted_table: bool = False
    equilibrium: tuple[str, ...] = ()

    @property
    def has_misprint(self) -> bool:
        """Whether the method can be asked for as printed."""
        return bool(self.as_printed) or self.misprinted_table

    @property
    def needs(self) -> frozenset[str]:
        """Names of all parameters that its functions ask for."""
        functions = [self.static, *(f for quantities in self.phases.values() for f in quantities.values())]
        return frozenset(name for function in functions for name in parameters_of(function))


def parameters_of(function: Callable) -> tuple[str, ...]:
    """The keyword parameters of a method function, in order (all but the depth z)."""
    return tuple(name for name in signature(function).parameters if name != "z")


def call(function: Callable, z, available: Mapping):
    """The function at depth z, handed those of the available parameters that it asks for."""
    return function(z, **{name: available[name] for name in parameters_of(function)})
