"""Required thickness: that at which a rule's strength meets the axial force."""

from collections.abc import Mapping

import numpy as np

from silostudy.buckling.family import IN_SCOPE, LONG, NO_LOAD, OUT_OF_RANGE, BucklingRule, evaluate

# R/t between which the required thickness is sought
SLENDEREST = 10_000
STOCKIEST = 20
HALVINGS = 40  # of log R/t: the thickness comes to 1e-11 of itself


def with_thickness(rule: BucklingRule, parameters: Mapping, thickness: np.ndarray) -> dict[str, np.ndarray]:
    """Every quantity of a rule for walls of this thickness (m); masked where the pressure it needs is unknown."""
    own = {name: value for name, value in parameters.items() if name != "inner_radius"}
    values = evaluate(rule, {**own, "thickness": thickness, "shell_radius": parameters["inner_radius"] + thickness / 2})
    if rule.pressurised:
        unknown = np.isnan(parameters["lower_internal_pressure"]) | np.isnan(parameters["upper_internal_pressure"])
        values["buckling_stress_scope"] = np.where(unknown, np.int8(NO_LOAD), values["buckling_stress_scope"])
    return values


def required_thickness(
    rule: BucklingRule, parameters: Mapping, force: np.ndarray, safety, halvings: int = HALVINGS, own_weight=0.0
) -> tuple[np.ndarray, np.ndarray]:
    """Thickness (m) at which the rule's strength meets the force (N/m), and scope flag, by halving the range of log R/t.

    own_weight: axial force (N/m) per thickness (m) of the wall above, which grows with what is sought.
    """
    radius = np.broadcast_to(parameters["inner_radius"], force.shape)
    thin, thick = radius / SLENDEREST, radius / STOCKIEST

    def enough(thickness):
        wall = with_thickness(rule, parameters, thickness)
        with np.errstate(invalid="ignore"):
            carries = safety * (force / thickness + own_weight) <= wall["buckling_stress"]
        return carries | (wall["buckling_stress_scope"] == LONG)  # only a thick wall is too long: the search goes on below it

    enough_thick, lightest = enough(thick), enough(thin)
    for _ in range(halvings):
        middle = np.sqrt(thin * thick)
        carries = enough(middle)
        thin, thick = np.where(carries, thin, middle), np.where(carries, middle, thick)
    enough_thick &= with_thickness(rule, parameters, thick)["buckling_stress_scope"] == IN_SCOPE
    scope = with_thickness(rule, parameters, np.where(enough_thick, thick * (1 - 1e-6), thick))["buckling_stress_scope"]
    beyond = lightest | (~enough_thick & (scope == IN_SCOPE))  # lighter than the slenderest, or more than the stockiest carries
    scope = np.select([np.isnan(force), beyond], [NO_LOAD, OUT_OF_RANGE], scope).astype(np.int8)
    return np.where(enough_thick, thick, np.nan), scope
