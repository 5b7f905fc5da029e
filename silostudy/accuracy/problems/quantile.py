"""The 95 % quantile of a wall pressure over the number of samples of the solid's scatter."""

import numpy as np
from scipy.optimize import brentq
from scipy.stats import qmc

from silostudy.pressure import janssen
from silostudy.pressure.calls import call

SAMPLES = tuple(2**k for k in range(4, 17, 2))
LADDERS = {"Sobol sequence, scrambled": SAMPLES, "random": SAMPLES}
SHARE = 0.95  # of the quantile
NODES = 400  # of the exact quadrature
RUNS = 16  # seeds: the worst of them counts, the cost is that of one
SOLID = {"unit_weight": 8000.0, "hydraulic_radius": 1.25, "wall_friction": 0.4, "lateral_pressure_ratio": 0.45}
DEPTH = 10.0  # m
SPREAD = {"wall_friction": 1.16, "lateral_pressure_ratio": 1.11}  # factors of the solid's scatter
LIGHTEST = 0.8  # least unit weight over the tabulated one


def _factors(share, spread):
    """Log-uniform from 1/spread to spread."""
    return spread ** (2.0 * share - 1.0)


def _pressure(friction, ratio, weight):
    changed = {"wall_friction": friction, "lateral_pressure_ratio": ratio, "unit_weight": weight}
    return call(janssen.normal_pressure, DEPTH, {**SOLID, **changed})


def prepare(ladder: str, setting: float):
    """Friction and lateral ratio log-uniform, unit weight uniform, as the uncertainty stage samples them."""

    def drawn(seed):
        if ladder == "random":
            points = np.random.default_rng(seed).random((int(setting), 3))
        else:
            points = qmc.Sobol(3, rng=seed).random(int(setting))
        friction, ratio = (SOLID[name] * _factors(points[:, k], SPREAD[name]) for k, name in enumerate(SPREAD))
        weight = SOLID["unit_weight"] * (LIGHTEST + (1.0 - LIGHTEST) * points[:, 2])
        return np.quantile(_pressure(friction, ratio, weight), SHARE)

    return lambda: {"wall_pressure": np.array([drawn(seed) for seed in range(RUNS)])}


def reference():
    """Pressure where the distribution function, by Gauss quadrature, is the share asked for: it is linear in unit weight."""
    nodes, weights = np.polynomial.legendre.leggauss(NODES)
    share, weights = 0.5 * (nodes + 1.0), 0.5 * weights
    friction, ratio = (SOLID[name] * _factors(share, SPREAD[name]) for name in SPREAD)
    heaviest = _pressure(friction[:, None], ratio[None, :], SOLID["unit_weight"])

    def below(pressure):
        part = np.clip((pressure / heaviest - LIGHTEST) / (1.0 - LIGHTEST), 0.0, 1.0)
        return float(weights @ part @ weights)

    return {"wall_pressure": np.array(brentq(lambda p: below(p) - SHARE, heaviest.min() * LIGHTEST, heaviest.max()))}
