"""Builds the engine's model from a scene of discs: where they start, what pushes them, and the time step."""

from dataclasses import replace
from typing import TypeVar

import numpy as np

from silostudy.config.dem import DemScene
from silostudy.config.grain_scenes import AnyScene
from silostudy.dem.model import Model, Wall
from silostudy.dem.pace import FIXED, Pace, following, longer_at_rest
from silostudy.dem.stability import chosen_step, packed_bound
from silostudy.errors import BadInput, within
from silostudy.packing import PACKINGS
from silostudy.scene.dem import check_events, check_start, contacts_of, events_of, plane_silo_of, room
from silostudy.scene.disc_mixture import densities_of_kinds, kinds_of, radii_of_kinds
from silostudy.scene.lid import check_lid, lid_of, moves

M = TypeVar("M", bound=Model)
COUNTED = 2.0**53  # steps that can be counted
SIZES = {"width": "silo.width_m", "radius": "radius_m"}  # arguments of a packing -> keys of a scene


def placed(scene: DemScene):
    """Places x, y, radius (m) and kind of the discs of a packing that no file gives; y from the lowest point of the silo.

    Each kind takes places that are laid for the largest.
    """
    packing, of_kinds = PACKINGS[scene.packing.kind], radii_of_kinds(scene)
    known = {"width": scene.silo.width_m, "radius": float(of_kinds.max()), "seed": scene.seed}
    size = {name: value for name, value in known.items() if name in packing.needs}
    with within(keys=SIZES | {row.argument: f"packing.{row.name}" for row in packing.asks}):
        x, y, radius = packing.place(**size, **packing.arguments(scene.packing))
    silo, kind = plane_silo_of(scene), kinds_of(scene, len(x))
    if kind is not None:
        radius = radius * of_kinds[kind] / of_kinds.max()
    clear = clear_of(silo.inserts, x, y + silo.bottom, radius)
    return x[clear], y[clear] + silo.bottom, radius[clear], kind if kind is None else kind[clear]


def clear_of(inserts: tuple[Wall, ...], x, y, radius) -> np.ndarray:
    """Mask of the discs that cut no insert; BadInput where none is left."""
    clear = np.all([room(insert, x, y) >= radius for insert in inserts], axis=0) & np.ones(len(x), bool)
    if not clear.any():
        raise BadInput("inserts", inserts[0].name, "leave no room for a disc of the packing")
    return clear


def unshaken_scene_model(scene: DemScene, discs, where: str = "") -> Model:
    """The engine's model of a scene without shaking, of discs as `placed` gives them.

    BadInput for a start or a step that cannot be.
    """
    integrator = scene.march.integrator
    assert integrator is not None, "march.integrator is not chosen yet"
    silo, (x, y, radius, kind) = plane_silo_of(scene, where), discs
    walls = silo.walls(scene.silo.wall_cells)
    check_start(walls, x, y, radius, where)
    check_events(scene, len(x), where)
    check_lid(scene.events, silo.bottom, silo.bottom + silo.height, where)
    contacts = contacts_of(scene, radius, where)
    model = Model(
        x=x, y=y, radius=radius, density=scene.density_kg_m3 if kind is None else densities_of_kinds(scene)[kind],
        walls=walls, pair_contact=contacts[0], wall_contact=contacts[1], kind=kind,
        dt=scene.march.step_s or 1.0, gravity=scene.gravity_m_s2, integrator=integrator,
        watched=scene.record.wall_force_window_s is not None, booked=scene.record.energy,
        moving=moves(scene.events),
    )  # fmt: skip
    touching = silo.width / (2.0 * float(radius.min()))
    model = replace(model, lid=lid_of(scene.events, silo.width, touching, float(model.mass.sum())))
    events_of(scene, float(model.mass.sum()), where)  # tells names of surfaces that are none before a run is made
    return stepped(scene, model, where)


def stepped(scene: AnyScene, model: M, where: str) -> M:
    """A model with the clock and the pace that its scene asks for."""
    pace = pace_of(scene)
    step = step_of(scene, model, where)
    if scene.march.limit_s / step > COUNTED:
        allowed = f"takes more steps of {step:.3g} s than can be counted, {COUNTED:.2g}"
        raise BadInput("march.limit_s", scene.march.limit_s, allowed, where)
    return replace(model, dt=step / pace.ticks, pace=pace)


def pace_of(scene: AnyScene) -> Pace:
    """Pace that a scene asks for: whether and how its time steps change."""
    factor = scene.march.step_factor or 1.0
    if scene.march.step == "longer_at_rest":
        return longer_at_rest(factor)
    return following(factor) if scene.march.step == "follow" else FIXED


def step_of(scene: AnyScene, model: Model, where: str) -> float:
    """The time step (s) that a scene asks for, or that is chosen for it; BadInput beyond the stability bound.

    That of a branch is checked once it is known to be like the run that it goes on from: else the step would be blamed.
    """
    if scene.march.step_s is None:
        assert scene.march.step_factor is not None, "march.step_factor is not chosen yet"
        return scene.march.step_factor * chosen_step(model)
    if scene.start_from is None:
        check_bound(scene, model, where)
    return scene.march.step_s


def check_bound(scene: AnyScene, model: Model, where: str) -> None:
    """BadInput for a time step that a scene asks for, beyond the stability bound."""
    asked, bound = scene.march.step_s, packed_bound(model)
    if asked is not None and asked > bound and not scene.march.beyond_stability:
        allowed = f"beyond the stability bound {bound:.4g} s of its densest packing; shorten it, or set march.beyond_stability"
        raise BadInput("march.step_s", asked, allowed, where)
