"""Wall forces of a silo at rest over the time step, by integrator and dashpot, and in LAMMPS.

Where the discs of a filling come to rest depends on every rounding, so the profile is a mean over fillings, compared
filling by filling with the same fillings at a short step of the same program; its noise is the standard error of that
mean difference.
"""

from dataclasses import replace

import numpy as np

from silostudy.accuracy.peers import Lammps
from silostudy.accuracy.silo import LEVELS, silo_of_rows
from silostudy.contact.family import NormalLaw, TangentialLaw
from silostudy.dem.engine import Engine
from silostudy.dem.explosion import Explosion
from silostudy.dem.integrate import PLAIN
from silostudy.dem.model import Model
from silostudy.scene.plane_silo import inner_width
from silostudy.tables.kiyama_1983 import ACTIVE, GAPS, RADIUS

REFERENCE_MARCH = PLAIN.key
CALM = 1e-4  # m/s: faster discs are not at rest, the step is then too long


def filled(seed: int, step: float, integrator: str, normal: NormalLaw, tangential: TangentialLaw) -> Model:
    """Kiyama and Fujimura's critically damped discs on the closed floor, each moved at random by up to a third of the gap."""
    model, _ = silo_of_rows(ACTIVE, LEVELS, offset=GAPS[ACTIVE] / 3.0, seed=seed)
    pair, wall = (
        replace(contact, laws=replace(contact.laws, normal=normal, tangential=tangential))
        for contact in (model.between(0, 0), model.at_wall(0, 0))
    )
    return replace(model, pair_contact=pair, wall_contact=wall, dt=step, integrator=integrator)


def at_rest(model: Model, time: float) -> np.ndarray | None:
    """Places (n, 2) in m after a time (s); None where the discs run away or do not come to rest."""
    engine = Engine(model)
    try:
        engine.step_to(round(time / model.dt))
    except Explosion:
        return None
    return engine.places if np.abs(engine.bodies.rows[: engine.n, 2:4]).max() < CALM else None


def peer_at_rest(model: Model, time: float) -> np.ndarray | None:
    """The same of LAMMPS; its law caps spring and dashpot together."""
    code = Lammps(model, np.c_[model.x, model.y], 0.0)
    code.step(round(time / model.dt))
    rest = None
    if code.grains == len(model.x):
        extract = code.lammps.numpy.extract_atom
        order = np.argsort(extract("id")[: len(model.x)])
        places, speed = (np.array(extract(name))[order][:, :2] for name in ("x", "v"))
        rest = places if np.abs(speed).max() < CALM else None
    code.close()
    return rest


def profile(places: np.ndarray, model: Model, parts: int) -> np.ndarray:
    """Normal force (N/m) on both side walls by parts of the fill's height, from the floor up: springs of discs at rest."""
    x, y = places.T
    stiffness = model.at_wall(0, 0).coefficients["normal_stiffness"]
    width, top = inner_width(model), float(model.y.max()) + RADIUS
    push = stiffness * (np.maximum(RADIUS - x, 0.0) + np.maximum(x - (width - RADIUS), 0.0))
    return np.histogram(y, np.linspace(0.0, top, parts + 1), weights=push)[0]


def error_of(profiles: np.ndarray, reference: np.ndarray) -> tuple[float, float]:
    """Distance (1) of two mean profiles over the size of the second, and its noise; both (fillings, parts), N/m."""
    apart, size = profiles - reference, float(np.linalg.norm(reference.mean(axis=0)))
    noise = np.sqrt((apart.var(axis=0, ddof=1) / len(apart)).sum())
    return float(np.linalg.norm(apart.mean(axis=0)) / size), float(noise / size)
