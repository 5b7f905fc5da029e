"""The profile stage of a stability study: the wall forces of a silo at rest over the time step, by march and in LAMMPS."""

from collections.abc import Callable

import numpy as np
import xarray as xr

from silostudy.accuracy.peers import available
from silostudy.accuracy.silo_step import REFERENCE_MARCH, at_rest, error_of, filled, peer_at_rest, profile
from silostudy.contact.family import NormalLaw, TangentialLaw
from silostudy.contact.normal import spring_dashpot
from silostudy.contact.tangential import spring_slider, spring_slider_total
from silostudy.cube.assemble import assemble
from silostudy.errors import BadInput
from silostudy.scene.expand import Expansion

PEER = "LAMMPS"
PEER_SLIDER = spring_slider_total.ROW  # spring and dashpot capped together
March = tuple[str, NormalLaw, TangentialLaw]


def profile_cube(expansion: Expansion, tell: Callable[[str], None] = lambda text: None) -> xr.Dataset:
    """The cube of the silo of a stability study; `tell` hears of each march and step."""
    study, silo = expansion.study, expansion.study.silo
    if silo is None:
        raise BadInput("silo", None, "the study has no such section")
    marches = {name(case.scene.config): _march(case.scene.config) for case in expansion.cases}
    marchers = [*marches, *([PEER] if study.peer and not available() else [])]
    steps, seeds = np.array(silo.steps_ms) * 1e-3, range(1, silo.fillings + 1)
    references = {key: _reference(silo, key == PEER, seeds) for key in {"", PEER} & {"", *marchers}}
    error, noise = (np.full((len(marchers), len(steps)), np.nan) for _ in "en")
    push = np.full((len(marchers), len(steps), silo.parts), np.nan)
    for i, marcher in enumerate(marchers):
        reference = references.get(marcher, references[""])
        for k, step in enumerate(steps):
            profiles = _profiles(silo, marches.get(marcher), step, seeds)
            if profiles is not None:
                push[i, k] = profiles.mean(axis=0)
                error[i, k], noise[i, k] = error_of(profiles, reference)
            tell(f"{marcher}, {step * 1e3:g} ms: {error[i, k]:.3g} +- {noise[i, k]:.2g}")
    data = {
        "profile_error": error,
        "profile_noise": noise,
        "silo_push": push,
        "reference_push": np.array([references.get(key, references[""]).mean(axis=0) for key in marchers]),
        "marcher": marchers,
        "march_step": steps,
        "wall_part": np.arange(silo.parts),
    }
    notes = {"reference_step_s": silo.reference_step_ms * 1e-3, "fillings": silo.fillings}
    return assemble(study, "profile", data, sources=["kiyama_fujimura_1983"], notes=notes)


def name(config) -> str:
    """Integrator and dashpots of a way of marching."""
    implicit = any(law.implicit for law in config.discs.laws.values())
    return config.integrator + (", semi-implicit dashpots" if implicit else "")


def _march(config) -> March:
    return config.integrator, config.discs.laws["normal"], config.discs.laws["tangential"]


def _reference(silo, of_peer: bool, seeds) -> np.ndarray:
    """Profiles (filling, part) at the short step, each program by its own; BadInput where a filling does not come to rest."""
    march = None if of_peer else (REFERENCE_MARCH, spring_dashpot.ROW, spring_slider.ROW)
    profiles = _profiles(silo, march, silo.reference_step_ms * 1e-3, seeds)
    if profiles is None:
        raise BadInput("silo.rest_s", silo.rest_s, "is too short for a filling to come to rest")
    return profiles


def _profiles(silo, march: March | None, step: float, seeds) -> np.ndarray | None:
    """Profiles (filling, part) at a step; None where a filling does not come to rest. Without a march: LAMMPS."""
    profiles = []
    for seed in seeds:
        model = filled(seed, step, *(march or (REFERENCE_MARCH, spring_dashpot.ROW, PEER_SLIDER)))
        places = at_rest(model, silo.rest_s) if march else peer_at_rest(model, silo.rest_s)
        if places is None:
            return None
        profiles.append(profile(places, model, silo.parts))
    return np.array(profiles)
