"""The longest stable time step: from the extreme motions of the contacts as they are, and the integrator's own steps.

Put any mode of the linear contacts, real or complex, into its equation of motion and take the product with itself: it is
an oscillator whose stiffness and damping (per mass) are its Rayleigh quotients.  So every mode stays bounded where all
oscillators do that have at most the largest stiffness, at most the largest damping, and at least the damping that the
least damped contact gives to their stiffness (eqs. 17, 19 need some).
"""

from dataclasses import dataclass
from functools import partial
from math import floor, log10, sqrt
from typing import Any

import numpy as np
from scipy.spatial import cKDTree

from silostudy.dem.integrate import INTEGRATORS
from silostudy.dem.model import Model
from silostudy.dem.packed import differing, least_of_kind, packings
from silostudy.dem.snapshot import length
from silostudy.dem.stiffest import Network, stiffest
from silostudy.dem.strength import DEEP, damping_of, springs, stiffness_of
from silostudy.dem.varied import set_of_pair
from silostudy.errors import BadInput

CLOSE = 1e-6  # of an eigenvalue, by which a round of turns changes it when it is taken as reached; and of the step
VANISHING = 1e-15  # of the longest step that is looked at: no step
SOFTEST = 1e-3  # of the largest stiffness: a slow mode
SAFETY = 0.5  # of the bound, when the engine chooses the step: flow makes contacts that the start does not have
DENSEST = 0.8  # of the bound of six contacts a disc: the most that a start without contacts will come to
HOPELESS = 1e-4  # of the step that undamped springs bear with an integrator that keeps their energy
FAMILIES = ("normal", "tangential", "rolling", "twisting")  # of laws that may hold springs, in their order
OVERDAMPED = 0.1  # of what an explicit dashpot alone bears, as the order of it: damping times the bound
NEAR = 0.05  # of a radius: gaps smaller than this count as contacts, since they close at once


@dataclass(frozen=True)
class Extremes:
    """Extremes of the contacts' modes, per mass: largest stiffness (1/s2) of all springs, and of the incremental ones, the
    tangential, rolling and twisting; largest damping (1/s); least damping over stiffness (s) of any contact."""

    stiffness: float
    incremental: float
    damping: float
    least_damped: float

    @property
    def corners(self) -> list[tuple[float, float, float]]:
        """Oscillators (stiffness of total and of incremental springs, damping) that bound all others."""
        k, slid = self.stiffness, min(self.incremental, self.stiffness)
        oscillators = []
        for total, incremental in ((k, 0.0), (k - slid, slid)):
            oscillators.append((total, incremental, max(self.damping, self.least_damped * k)))
            oscillators += [(share * total, share * incremental, self.least_damped * share * k) for share in (1.0, SOFTEST)]
        return oscillators


def longest_step(model: Model, walls: Any = None, deep: float = DEEP, close: float = CLOSE) -> float:
    """Longest time step (s) that keeps every motion of the linear contacts bounded, and of a lone contact of two discs or a
    disc and a wall, which may come.

    walls: as they stand, None: as the model has them; deep: overlap over the largest radius at which curved laws' slopes are;
    close: share of it by which it may be missed.
    """
    contacts = _contacts(model, model.space.walls_of(model.walls) if walls is None else walls)
    extremes = partial(_extremes, model, contacts, deep=deep, close=close)
    fixed = None if _implicit(model) else extremes(0.0)

    def holds(dt: float) -> bool:
        return _bounded(model.integrator, (fixed or extremes(dt)).corners, dt)

    short, long = 0.0, 4.0 / np.sqrt((fixed or extremes(0.0)).stiffness)
    while holds(long):
        short, long = long, 2.0 * long
    least = VANISHING * long
    while long - short > max(close * long, least):
        middle = 0.5 * (short + long)
        short, long = (middle, long) if holds(middle) else (short, middle)
    return short


def chosen_step(model: Model) -> float:
    """Time step (s) for a scene that gives none: safe for the contacts at the start, and for the densest that may come.

    Rounded down to two digits: the last bits of an eigenvalue differ between machines and must not reach the run.
    """
    step = min(SAFETY * standing(model, longest_step(model)), DENSEST * min(map(longest_step, packings(model))))
    unit = 10.0 ** (floor(log10(step)) - 1)
    return float(f"{floor(0.999 * step / unit) * unit:.2g}")


def packed_bound(model: Model) -> float:
    """Longest stable time step (s) of a scene whatever its bodies come to: of its start, and of the densest packing."""
    return standing(model, min(map(longest_step, (model, *packings(model)))))


def standing(model: Model, bound: float) -> float:
    """The bound (s); BadInput where a dashpot too strong, or an integrator that feeds energy into undamped springs, leaves next
    to nothing of it."""
    extremes = _extremes(model, _contacts(model, model.space.walls_of(model.walls)), bound, DEEP)
    plain = 2.0 / sqrt(extremes.stiffness)
    if bound > HOPELESS * plain:
        return bound
    if extremes.damping * bound > OVERDAMPED:
        section, law = _strongest_dashpot(model)
        allowed = f"its dashpot is too strong: steps are stable up to {bound:.2g} s only, where the springs bear {plain:.2g} s"
        raise BadInput(section, law, allowed)
    springs = ", ".join(_undamped(model)) or "the least damped contact"
    allowed = f"feeds energy into springs without a dashpot ({springs}): stable up to {bound:.2g} s only; take another, or damp"
    raise BadInput("march.integrator", model.integrator, allowed)


def _undamped(model: Model) -> list[str]:
    """The springs of a model that have no dashpot: of which contact, which law."""
    undamped = [
        f"{f'{model.space.body}s' if other is not None else 'walls'} {row.key}"
        for contact, body, other in _lone(model)
        for row, k, d in zip(
            springs(contact.rows),
            stiffness_of(contact, model, body, other, 0.0),
            damping_of(contact, model, body, other, 0.0),
            strict=True,
        )
        if k.any() and not d.any()
    ]
    return list(dict.fromkeys(undamped))


def _strongest_dashpot(model: Model) -> tuple[str, str]:
    """Section and family, and law, of the dashpot that brings the bodies of a lone contact to rest first."""
    dashpots = []
    for contact, body, other in _lone(model):
        strengths = [float(np.ravel(strength)[0]) for strength in damping_of(contact, model, body, other, 0.0)]
        section = "walls" if other is None else f"{model.space.body}s"
        rows = zip(FAMILIES, springs(contact.rows), _ways(model, body, other) * strengths, strict=True)
        dashpots += [(float(rate), f"{section}.{family}", row.key) for family, row, rate in rows]
    _, section, law = max(dashpots)
    return section, law


def check_step(model: Model) -> float:
    """The bound (s); raises BadInput where the model's step is beyond it."""
    bound = longest_step(model)
    if model.dt > bound:
        raise BadInput("dt", model.dt, f"beyond the stability bound {bound:.4g} s of these contacts")
    return bound


def _implicit(model: Model) -> bool:
    """Whether a law's stiffness or damping depends on the step."""
    return any(row.implicit for contact in (model.pair_contact, model.wall_contact) for row in contact.rows)


def _bounded(integrator: str, oscillators: list[tuple[float, float, float]], dt: float) -> bool:
    """Whether oscillators stay bounded: no eigenvalue of one step beyond one.

    Normal springs follow the place itself, tangential ones add up rate times dt; some integrators move by another increment.
    """
    advance, (total, incremental, damping) = INTEGRATORS[integrator].advance, np.array(oscillators).T

    def step(rate, held, place, slid):
        rate, held, increment = advance(rate, held, -total * place - incremental * slid - damping * rate, dt, dt)
        return rate, held, place + increment, slid + rate * dt

    scale, still = np.array([dt, dt, 1.0, 1.0]), np.zeros(len(oscillators))
    columns = [[still + of for of in step(*unit)] for unit in np.diag(1.0 / scale)]
    matrices = np.transpose(columns, (2, 1, 0)) * scale[:, None]
    return bool(np.abs(np.linalg.eigvals(matrices)).max() <= 1.0 + 1e-9)


def _contacts(model: Model, walls: Any) -> list[tuple]:
    """Contacts that are or will be at once: (contact, first, second, normals); second is None for walls."""
    place = model.place
    i, j = cKDTree(place).query_pairs((2.0 + NEAR) * model.radius.max(), output_type="ndarray").reshape(-1, 2).T
    away = place[i] - place[j]
    distance = length(away)
    near = distance < model.radius[i] + model.radius[j] + NEAR * np.minimum(model.radius[i], model.radius[j])
    if not distance.all():
        closest = int(np.argmin(distance))
        raise BadInput(
            ", ".join(model.columns[: model.space.ways]),
            f"{model.space.body}s {i[closest]}, {j[closest]}",
            "stand in the same place",
        )
    i, j, normals = i[near], j[near], away[near] / distance[near, None]
    kind = np.zeros(len(place), int) if model.kind is None else model.kind
    groups: list[tuple] = [
        (model.between(first, second), i[these], j[these], normals[these])
        for second in range(model.kinds)
        for first in range(second + 1)
        if (these := set_of_pair(kind[i], kind[j]) == set_of_pair(first, second)).any() or model.kinds == 1
    ]
    for q in np.flatnonzero(walls.live):
        away = model.space.all_from_wall(walls.shape, q, place)
        distance = length(away)
        touching = (distance < (1.0 + NEAR) * model.radius) & (distance > 0.0)
        for number in range(model.kinds):
            body = np.flatnonzero(touching & (kind == number))
            groups.append((model.at_wall(number, int(q)), body, None, away[body] / distance[body, None]))
    return groups


def _lone(model: Model) -> list[tuple]:
    """Lone contacts of the lightest body of each kind, with those of its own and of other kinds and with each wall."""
    contacts: list[tuple] = []
    light = [np.array([least_of_kind(model, model.mass, kind)]) for kind in range(model.kinds)]
    for kind, body in enumerate(light):
        walls = [model.at_wall(kind, wall) for wall in range(len(model.walls))] or [model.wall_contact.numbered(0)]
        contacts += [(model.between(kind, other), body, light[other]) for other in range(kind + 1)]
        contacts += [(wall, body, None) for wall in differing(walls)]
    return contacts


def _extremes(model: Model, contacts: list[tuple], dt: float, deep: float = DEEP, close: float = CLOSE) -> Extremes:
    """Extremes of all contacts together and of lone contacts of the lightest bodies, at this step."""
    stiff, damp, lone = partial(stiffness_of, dt=dt, deep=deep), partial(damping_of, dt=dt, deep=deep), _lone(model)
    largest = partial(_largest, model, contacts, lone, _network(model, contacts), close)
    ratios = [
        d.min() / k.min()
        for contact, i, j, *_ in (*contacts, *lone)
        for k, d in zip(stiff(contact, model, i, j), damp(contact, model, i, j), strict=True)
        if k.any()
    ]
    return Extremes(
        stiffness=largest(stiff) + _on_lid(model, stiff),
        incremental=largest(lambda *which: [0.0 * (k := stiff(*which))[0], *k[1:]]),
        damping=largest(damp) + _on_lid(model, damp),
        least_damped=float(min(ratios)),
    )


def _on_lid(model: Model, strengths) -> float:
    """Most (1/s2 or 1/s) that a lid of a mass adds when it touches as many bodies as it can: rows of one more motion."""
    if model.lid is None:
        return 0.0
    strongest = max(strengths(contact, model, body, None)[0][0] for contact, body, other in _lone(model) if other is None)
    return float(model.lid.touching * strongest / model.lid.mass)


def _largest(model: Model, contacts: list[tuple], lone: list[tuple], network: Network, close: float, strengths) -> float:
    """Largest eigenvalue (1/s2 or 1/s) of the mass-scaled contacts, or of a lone one."""
    highest = 0.0
    for contact, i, j in lone:
        highest = max(highest, *(_ways(model, i, j) * np.ravel(strengths(contact, model, i, j))))
    strength = np.vstack([_columns(contact, strengths(contact, model, i, j)) for contact, i, j, _ in contacts])
    return max(highest, stiffest(network, strength, close))


def _ways(model: Model, i, j) -> np.ndarray:
    """One over the mass (1/kg) or inertia (1/(kg m2)) that a lone contact's normal, tangential, rolling, twisting spring moves.

    Two translations and two rotations pull at a tangential spring.
    """
    bodies, light = np.r_[i, [] if j is None else j].astype(int), model.space.inverse_inertia
    turn = light / model.radius[bodies] ** 2
    return (np.array([1.0 + 0.0 * turn, 1.0 + light + 0.0 * turn, turn, turn]) / model.mass[bodies]).sum(axis=1)


def _columns(contact, strengths) -> np.ndarray:
    """Strengths (n, 4) of contacts; of a twisting spring only where the laws wind one up."""
    return np.column_stack([*strengths[:3], strengths[3] * contact.laws.winds])


def _network(model: Model, contacts: list[tuple]) -> Network:
    """Contacts as the solver takes them."""
    ways, spins, start = model.space.ways, len(model.space.spin), np.zeros((len(model.x), 6))
    draws = np.random.default_rng(0).standard_normal((len(model.x), ways + spins))  # an even start may be blind to the stiffest
    start[:, :ways], start[:, 6 - spins :] = draws[:, :ways], draws[:, ways:]
    normals = np.vstack([normals for *_, normals in contacts])
    return Network(
        first=np.concatenate([i for _, i, *_ in contacts]),
        second=np.concatenate([np.full(len(i), -1) if j is None else j for _, i, j, _ in contacts]),
        normal=np.pad(normals, ((0, 0), (0, 3 - ways))),
        radius=np.array(model.radius),
        rates=1.0 / np.sqrt(np.column_stack([model.mass, model.mass * model.radius**2 / model.space.inverse_inertia])),
        start=start,
    )
