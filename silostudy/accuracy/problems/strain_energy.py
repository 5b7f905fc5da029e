"""The strain-energy envelope in single and double precision, against 50 digits."""

from decimal import Decimal, localcontext

import numpy as np

from silostudy.pressure.calls import call
from silostudy.pressure.jenike_mass_flow import envelope_pressure

BITS = {32: np.float32, 64: np.float64}
LADDERS = {"float": tuple(BITS)}
SILOS = 400  # that are compared
MANY = 50  # times that they stand in the call that is timed
DIGITS = 50


def silos() -> dict[str, np.ndarray]:
    """Silos of every slenderness from 0.01 to 100, each at one depth, as numbers that 32 bits hold exactly."""
    random = np.random.default_rng(0)
    radius = random.uniform(0.5, 5.0, SILOS)
    depth = 4.0 * radius * np.geomspace(1e-2, 1e2, SILOS)
    given = {
        "z": depth * random.uniform(0.02, 0.98, SILOS),
        "unit_weight": random.uniform(6e3, 16e3, SILOS),
        "hydraulic_radius": radius,
        "wall_friction": random.uniform(0.2, 0.6, SILOS),
        "lateral_pressure_ratio": random.uniform(0.3, 0.6, SILOS),
        "poisson_ratio": random.uniform(0.2, 0.45, SILOS),
        "cylinder_depth": depth,
        "slot": np.zeros(SILOS),
    }
    return {name: values.astype(np.float32) for name, values in given.items()}


def prepare(ladder: str, setting: float):
    """All silos in one call."""
    given = {name: np.tile(values, MANY).astype(BITS[int(setting)]) for name, values in silos().items()}
    z = given.pop("z")

    def run():
        return {"wall_pressure": np.asarray(call(envelope_pressure, z, given)[:SILOS], float)}

    return run


def reference():
    """The same formula by decimals of 50 digits."""
    given = silos()
    columns = [[Decimal(float(value)) for value in values] for values in given.values()]
    with localcontext() as context:
        context.prec = DIGITS
        return {"wall_pressure": np.array([float(_exact(*row)) for row in zip(*columns, strict=True)])}


def _exact(z, weight, radius, friction, ratio, poisson, depth, slot):
    """Pressure p = [g b (1 - 2 nu k)(1 - sech L) + S (k + tanh(L)/M)] / (1 + k M tanh L): silo_handbook, section 4.2.2 (d)."""
    b, k, m = radius / friction, poisson / (1 - poisson), (2 * (1 - poisson)).sqrt()
    stress = weight * b / ratio * (1 - (-z * ratio / b).exp())
    length = (depth - z) / (b * m)
    grow, fall = length.exp(), (-length).exp()
    tanh, sech = (grow - fall) / (grow + fall), 2 / (grow + fall)
    return (weight * b * (1 - 2 * poisson * k) * (1 - sech) + stress * (k + tanh / m)) / (1 + k * m * tanh)
