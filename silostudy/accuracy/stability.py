"""The stability stage: for every network, damping and way of marching, the largest step that keeps resting discs at rest."""

from collections.abc import Callable

import numpy as np
import xarray as xr

from silostudy.accuracy.peers import available
from silostudy.accuracy.stability_map import DiscsAtRest, contact_number, kick_of, our_step, peer_step, settled
from silostudy.compute.axes import stacked, sweep_of
from silostudy.cube.assemble import assemble
from silostudy.dem.integrate import INTEGRATORS
from silostudy.scene.expand import Expansion
from silostudy.scene.stability import RestingDiscs


def stability_cube(expansion: Expansion, tell: Callable[[str], None] = lambda text: None) -> xr.Dataset:
    """The cube of a stability study; `tell` hears of each case.  Equal discs come to rest once, LAMMPS tries them once."""
    study, rests, peers, trials = expansion.study, {}, {}, []
    missing = available() if study.peer else "not asked for"
    if study.peer and missing:
        tell(f"{missing}: its steps are left out")
    for number, case in enumerate(expansion.cases):
        scene: RestingDiscs = case.scene
        same, at_rest = _same(scene, "damping_ratio"), _same(scene)
        if same not in rests:
            rests[same] = settled(scene.calm)
        if at_rest not in peers:
            peers[at_rest] = np.nan if missing else _peer(study, scene, rests[same])
        trials.append(_found(study, scene, rests[same]) | {"peer_step": peers[at_rest]})
        tell(f"case {number + 1} of {len(expansion.cases)}: {trials[-1]['stable_step']:.3g} s")
    notes = {"peer": "LAMMPS" if not missing else ""}
    data = stacked(trials, expansion.shape)
    return assemble(study, "stability", data, sources=_sources(expansion), notes=notes, sweep=sweep_of(expansion))


def _same(scene: RestingDiscs, *more: str) -> str:
    """Parts that tell arrangements at rest apart: everything but the laws' dashpots and the integrator."""
    laws = [law.at_rest for law in scene.config.discs.laws.values()]
    return f"{laws} {scene.config.model_dump_json(exclude={'integrator': True, 'discs': {'normal', 'tangential', *more}})}"


def _found(study, scene: RestingDiscs, rest: DiscsAtRest) -> dict[str, float]:
    kick = kick_of(len(rest.places), scene.lonely)
    step, bound = our_step(scene.model, rest, kick, study.trial_steps, study.resolution)
    return {
        "stable_step": step,
        "stability_bound": bound,
        "contact_number": contact_number(rest.places, scene.model),
        "implicit_dashpots": sum(row.implicit for row in scene.model.pair_contact.rows),
    }


def _peer(study, scene: RestingDiscs, rest: DiscsAtRest) -> float:
    kick = kick_of(len(rest.places), scene.lonely)
    return peer_step(scene.calm, scene.model, rest, kick, study.trial_steps, study.resolution)


def _sources(expansion: Expansion) -> list[str]:
    models = [case.scene.model for case in expansion.cases]
    laws = [row.source for model in models for row in model.pair_contact.rows if row.acts]
    return sorted({*laws, *(INTEGRATORS[model.integrator].source for model in models)})
