"""The longest stable time step: from the stiffest motion of the contact network as it is, and the integrator's own march."""

from dataclasses import replace
from math import floor, log10, sqrt

import numpy as np
from scipy.sparse import csr_matrix, diags, vstack
from scipy.sparse.linalg import eigsh
from scipy.spatial import cKDTree

from silostudy.contact.line import load_of
from silostudy.dem.integrate import INTEGRATORS
from silostudy.dem.model import Contact, Model, Wall
from silostudy.dem.walls import shape_of
from silostudy.errors import BadInput

SAFETY = 0.5  # of the bound, when the engine chooses the step: flow makes contacts that the start does not have
DENSEST = 0.8  # of the bound of six contacts a disc: the most that a start without contacts will come to
NEAR = 0.05  # of a radius: gaps smaller than this count as contacts, since they close at once
DEEP = 0.02  # of a radius: the overlap at which a curved law's slope is taken


def longest_step(model: Model) -> float:
    """Longest time step (s) that keeps the stiffest and the most damped motion of the network bounded.

    Linear analysis: largest eigenvalues of the mass-scaled stiffness and damping, put into the integrator's own recursion.
    """
    network = _network(model)
    stiffness = _largest(model, network, _stiffness)
    damping = _largest(model, network, _damping)
    short, long = 0.0, 4.0 / np.sqrt(stiffness)
    for _ in range(60):
        middle = 0.5 * (short + long)
        short, long = (middle, long) if _bounded(model.integrator, stiffness, damping, middle) else (short, middle)
    return short


def chosen_step(model: Model) -> float:
    """Time step (s) for a scene that gives none: safe for the network at the start, and for the densest that may come.

    Rounded down to two digits: the last bits of an eigenvalue vary from call to call and must not reach the run.
    """
    step = min(SAFETY * longest_step(model), DENSEST * longest_step(_densest(model)))
    unit = 10.0 ** (floor(log10(step)) - 1)
    return float(f"{floor(0.999 * step / unit) * unit:.2g}")


def _densest(model: Model) -> Model:
    """The smallest discs of a model in hexagonal order on a floor; larger ones are heavier, or touch fewer of them."""
    r, (i, j) = float(model.radius.min()), np.mgrid[-3:4, -3:4].reshape(2, -1)
    x, y = 2.0 * r * (i + 0.5 * j), sqrt(3.0) * r * j
    near = np.hypot(x, y) < 4.5 * r
    low = float(y[near].min()) - r
    walls = (Wall("floor", (-9.0 * r, low), (9.0 * r, low)),)
    return replace(model, x=x[near], y=y[near], radius=np.full(near.sum(), r), u=None, v=None, w=None, walls=walls)


def check_step(model: Model) -> float:
    """The bound (s); raises BadInput where the model's step is beyond it."""
    bound = longest_step(model)
    if model.dt > bound:
        raise BadInput("dt", model.dt, f"beyond the stability bound {bound:.4g} s of this contact network")
    return bound


def _bounded(integrator: str, stiffness: float, damping: float, dt: float) -> bool:
    """Whether an oscillator (stiffness and damping per mass) stays bounded: no eigenvalue of one step beyond one."""
    advance = INTEGRATORS[integrator].advance

    def step(rate, held, place):
        rate, held, increment = advance(rate, held, -stiffness * place - damping * rate, dt, dt)
        return rate, held, place + increment

    matrix = np.array([step(*unit) for unit in np.diag([1.0 / dt, 1.0 / dt, 1.0])]).T
    scale = np.array([dt, dt, 1.0])
    return bool(np.abs(np.linalg.eigvals(matrix * scale[:, None])).max() <= 1.0 + 1e-9)


def _network(model: Model) -> list[tuple]:
    """Contacts that are or will be at once: (contact, first, second, nx, ny); second is None for walls."""
    place = np.c_[model.x, model.y]
    i, j = cKDTree(place).query_pairs((2.0 + NEAR) * model.radius.max(), output_type="ndarray").reshape(-1, 2).T
    away = place[i] - place[j]
    distance = np.hypot(*away.T)
    near = distance < model.radius[i] + model.radius[j] + NEAR * np.minimum(model.radius[i], model.radius[j])
    found: list[tuple] = [(model.pair, i[near], j[near], *(away[near] / distance[near, None]).T)]
    for wall, (x, y, tx, ty, length, *_) in zip(model.walls, shape_of(model.walls), strict=True):
        along = np.clip((model.x - x) * tx + (model.y - y) * ty, 0.0, length)
        away = place - np.c_[x + along * tx, y + along * ty]
        distance = np.hypot(*away.T)
        disc = np.flatnonzero((distance < (1.0 + NEAR) * model.radius) & (distance > 0.0) & wall.live)
        found.append((model.wall, disc, None, *(away[disc] / distance[disc, None]).T))
    return found


def _largest(model: Model, network: list[tuple], strengths) -> float:
    """Largest eigenvalue (1/s2 or 1/s) of the mass-scaled network; a lone pair's where nothing touches."""
    n, mass = len(model.x), float(model.mass.min())
    root = np.sqrt(np.r_[model.mass, model.mass, 0.5 * model.mass * model.radius**2])
    blocks = []
    for contact, i, j, nx, ny in network:
        normal, tangential = np.sqrt(strengths(contact, model, i, j))
        for strength, tx, ty, arm in ((normal, nx, ny, 0.0), (tangential, -ny, nx, 1.0)):
            row = _rows(strength, i, tx, ty, arm, model, n)
            blocks.append(row if j is None else row + _rows(strength, j, -tx, -ty, arm, model, n))
    scaled = vstack(blocks).tocsr() @ diags(1.0 / root)
    lone = 2.0 * strengths(model.pair, model, np.array([0]), np.array([0]))[0].max() / mass
    if scaled.nnz == 0:
        return float(lone)
    return max(float(lone), float(eigsh(scaled.T @ scaled, k=1, tol=1e-3, v0=np.ones(3 * n), return_eigenvectors=False)[0]))


def _rows(strength, disc, tx, ty, arm, model, n):
    """One row a contact: how the motion of these discs stretches it."""
    values = np.c_[strength * tx, strength * ty, -strength * arm * model.radius[disc]]
    columns = np.c_[disc, n + disc, 2 * n + disc]
    return csr_matrix((values.ravel(), columns.ravel(), 3 * np.arange(len(disc) + 1)), shape=(len(disc), 3 * n))


def _stiffness(contact: Contact, model: Model, i, j):
    c = contact.coefficients
    normal = c.get("normal_stiffness") or _slope(c, float(model.radius.max()))
    return np.full(len(i), normal), np.full(len(i), c.get("tangential_stiffness", 0.0))


def _slope(c, radius: float) -> float:
    """Slope (N/m per m) of the line-contact curve at a deep overlap."""
    high, low = (load_of(part * DEEP * radius, c["line_compliance"], c["line_bracket"]) for part in (1.0, 0.999))
    return (high - low) / (0.001 * DEEP * radius)


def _damping(contact: Contact, model: Model, i, j):
    c = contact.coefficients
    reduced = model.mass[i] if j is None else 1.0 / (1.0 / model.mass[i] + 1.0 / model.mass[j])
    root = np.sqrt(reduced)
    normal = c["normal_damping"] + c["normal_damping_root"] * root
    return normal, c.get("tangential_damping", 0.0) + c.get("tangential_damping_root", 0.0) * root
