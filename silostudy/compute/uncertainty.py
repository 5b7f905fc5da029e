"""The uncertainty stage: the solid's scatter sampled through every method of one silo, and which property matters.

No source says how the properties are distributed between their lower and upper values: friction angle, wall friction and
lateral pressure ratio are sampled log-uniformly from mean/a to mean*a, the unit weight uniformly from lower to upper, all
independent.  The conversion factors themselves are set to 1, so that a code's own safety is not counted twice.
"""

from collections.abc import Callable, Mapping
from math import ceil, log2

import numpy as np
import xarray as xr
from scipy.stats import qmc

from silostudy.choice.expand import Resolved
from silostudy.compute.evaluate import AskedMethod, gather, method_coordinates, methods_of, sources_of, with_reasons
from silostudy.compute.pressure import depth_coordinates, depths_in_metres, evaluate
from silostudy.cube.assemble import assemble
from silostudy.pressure.family import IN_SCOPE, NO_PHASE
from silostudy.scene.scene import solid_parameters

SAMPLED = ("internal_friction_angle", "wall_friction", "lateral_pressure_ratio", "unit_weight")
SPREAD_OF = {"internal_friction_angle": "a_phi", "wall_friction": "a_mu", "lateral_pressure_ratio": "a_K"}
QUANTILES = (0.05, 0.5, 0.95)  # ends of nine tenths of the samples, and the median
QUANTILE = "wall_normal_pressure_quantile"


def uncertainty_cube(expansion: Resolved) -> xr.Dataset:
    """Quantiles of the wall pressure (method, phase, quantile, depth) and Sobol indices of its largest value.

    A depth that some samples mask has no quantiles; its scope is the reason of one of them.
    """
    methods, phases = methods_of(expansion), expansion.study.phases
    z, asked = depths_in_metres(expansion), expansion.study.uncertainty
    points = sequence(len(SAMPLED), asked.samples, asked.seed)
    quantiles = np.full((len(methods), len(phases), len(QUANTILES), z.size), np.nan)
    scopes = np.full(quantiles.shape, NO_PHASE, dtype=np.int8)
    sobol = np.full((2, len(methods), len(phases), len(SAMPLED)), np.nan)
    for m, method in enumerate(methods):
        for p, phase in enumerate(phases):
            if not method.functions(phase):
                continue
            pressure = pressure_of(expansion, method, phase, z)
            sample, scope = pressure(points)
            scopes[m, p] = scope.max(axis=0)
            whole = scope.max(axis=0) == IN_SCOPE
            quantiles[m, p][:, whole] = np.quantile(sample[:, whole], QUANTILES, axis=0)
            if whole.any():
                sobol[:, m, p] = indices(pressure, whole, asked)
    return _assemble(expansion, methods, {QUANTILE: quantiles} | with_reasons({QUANTILE: scopes}), sobol)


def pressure_of(expansion: Resolved, method: AskedMethod, phase: str, z: np.ndarray) -> Callable:
    """Wall pressure (Pa) and its scope, shape (samples, depths), as a function of points (samples, properties) in [0, 1]."""
    parameters, base = gather(expansion, method), spreads(expansion)

    def pressure(points: np.ndarray) -> tuple:
        changed = scattered(parameters, base, points)
        depths = np.broadcast_to(z, (len(points), z.size))
        return evaluate(method, phase, depths, changed)["wall_normal_pressure"]

    return pressure


def spreads(expansion: Resolved) -> dict[str, float]:
    """The scatter of the study's solid: the same for every method."""
    values = solid_parameters(expansion.cases[0].scene, "")
    lightest = values["unit_weight_lower"] / values["unit_weight"]
    return {name: values[spread] for name, spread in SPREAD_OF.items()} | {"unit_weight": lightest}


def scattered(parameters: Mapping, base: Mapping, points: np.ndarray) -> dict[str, np.ndarray]:
    """Parameters of every sample, shape (samples, 1): a method's own means times the sampled factors."""
    share = dict(zip(SAMPLED, points.T[..., None], strict=True))
    factor = {name: base[name] ** (2 * share[name] - 1) for name in SPREAD_OF}
    factor["unit_weight"] = base["unit_weight"] + (1 - base["unit_weight"]) * share["unit_weight"]
    follows = {"hopper_wall_friction": "wall_friction", "unit_weight_lower": "unit_weight"} | {name: name for name in SAMPLED}
    changed = {name: np.broadcast_to(value, (len(points), 1)) for name, value in parameters.items()}
    changed |= {name: changed[name] * factor[source] for name, source in follows.items()}
    changed |= {spread: np.ones((len(points), 1)) for spread in SPREAD_OF.values()}
    for name in ("wall_friction", "hopper_wall_friction"):
        changed[name] = np.minimum(changed[name], np.tan(changed["internal_friction_angle"]))
    return changed


def indices(pressure: Callable, whole: np.ndarray, asked) -> np.ndarray:
    """First-order and total Sobol indices (1) of the largest wall pressure, by Saltelli's estimator with the study's seed."""
    count = len(SAMPLED)
    points = sequence(2 * count, asked.samples, np.random.default_rng(asked.seed))
    first, second = points[:, :count], points[:, count:]
    mixed = [np.where(np.arange(count) == k, second, first) for k in range(count)]
    here, there, *changed = (pressure(points)[0][:, whole].max(axis=1) for points in (first, second, *mixed))
    both = np.array([here, there])
    with np.errstate(invalid="ignore", divide="ignore"):  # of a pressure that does not scatter
        shares = np.array([[np.mean((there - both.mean()) * (other - here)), 0.5 * np.mean((here - other) ** 2)]
                           for other in changed]) / both.var()  # fmt: skip
    return np.nan_to_num(shares.T)


def sequence(dimensions: int, count: int, seed: int | np.random.Generator) -> np.ndarray:
    """The first points of a scrambled Sobol sequence in the unit cube: (count, dimensions)."""
    return qmc.Sobol(dimensions, rng=seed).random_base2(ceil(log2(count)))[:count]


def _assemble(expansion: Resolved, methods: list[AskedMethod], quantiles: Mapping, sobol: np.ndarray) -> xr.Dataset:
    study = expansion.study
    data = {
        **quantiles,
        "sobol_first": sobol[0],
        "sobol_total": sobol[1],
        "cylinder_depth": expansion.cases[0].scene.silo.cylinder_depth,
        **method_coordinates(methods),
        "phase": list(study.phases),
        "quantile": list(QUANTILES),
        "parameter": list(SAMPLED),
        **depth_coordinates(study, depths_in_metres(expansion)),
    }
    notes = {**expansion.promise, **study.own_methods}
    return assemble(study, "uncertainty", data, sources=sources_of(expansion), notes=notes)
