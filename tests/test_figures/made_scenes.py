"""Cubes of shipped sweeps of scenes whose numbers are made up, so that no kernel is compiled."""

from functools import cache

import numpy as np
import xarray as xr

from silostudy.compute.axes import sweep_of
from silostudy.compute.grains import CARRIERS
from silostudy.compute.published import coordinates as published_coordinates
from silostudy.compute.published import sources
from silostudy.compute.scenes import SWEPT, coordinates
from silostudy.compute.scenes_means import mean_numbers
from silostudy.cube.assemble import assemble
from tests.test_compute.made_walls import made_walls
from tests.test_figures.small_studies import expansion_of


@cache
def flow_cube(study: str) -> xr.Dataset:
    """The cube of a sweep of spheres that flow by Beverloo's law, each filling a little off: no kernel is compiled."""
    expansion = expansion_of(study)
    shape = tuple(len(axis.settings()) for axis in expansion.study.sweep)
    scenes = [case.scene.config for case in expansion.cases]
    width = np.array([scene.outlets[0].width_m for scene in scenes])
    diameter = np.array([1e-3 * scene.sizes.diameter_mm for scene in scenes])
    flow = (1.0 + 0.02 * np.sin(np.arange(len(width)))) * 2700.0 * (width - 1.5 * diameter) ** 2.5
    numbers = {"mean_mass_flow": flow.reshape(shape), "mean_grain_diameter": diameter.reshape(shape)}
    return assemble(expansion.study, "scenes", numbers, sources=[], sweep=sweep_of(expansion))


@cache
def jam_cube(study: str) -> xr.Dataset:
    """The cube of a sweep of discs over slots of which the narrow ones jam in every other filling."""
    expansion = expansion_of(study)
    shape = tuple(len(axis.settings()) for axis in expansion.study.sweep)
    scenes = [case.scene.config for case in expansion.cases]
    width = np.array([scene.silo.slit_width_m for scene in scenes])
    jams = (width < 5.0 * 2.0 * scenes[0].radius_m) & (np.arange(len(width)) % 2 == 0)
    flow = np.where(jams, 0.1, 1.0) * 500.0 * width**1.5
    numbers = {"mean_discharge_rate": flow, "mean_grain_diameter": np.full(len(width), 2.0 * scenes[0].radius_m)}
    shaped = {name: values.reshape(shape) for name, values in (numbers | {"limit_reached": jams.astype(float)}).items()}
    return assemble(expansion.study, "scenes", shaped, sources=[], sweep=sweep_of(expansion))


@cache
def emptying_cube(study: str) -> xr.Dataset:
    """The cube of a sweep of silos of spheres that empty evenly in two seconds, each filling a little slower."""
    expansion = expansion_of(study)
    share = coordinates(expansion.study)["flow_share"]
    slower = 1.0 + 0.1 * np.arange(expansion.shape[-1])
    left = np.broadcast_to(1.0 - share / slower[:, None], (*expansion.shape, len(share)))
    numbers = {"share_left": left, "flow_share": share, "first_event_time": np.full(expansion.shape, 0.5)}
    numbers |= {"end_time": np.full(expansion.shape, 2.5)}
    return assemble(expansion.study, "scenes", numbers, sources=[], sweep=sweep_of(expansion))


@cache
def published_cube(study: str, off: tuple[float, ...] = (0.5, -0.8, 0.1)) -> xr.Dataset:
    """The cube of a study of published cases whose fillings are all so many tolerances off."""
    expansion = expansion_of(study)
    own = published_coordinates(expansion.study)
    values = np.broadcast_to(np.array(off)[:, None], (*expansion.shape, len(own["expectation"])))
    named = sources(expansion.study)
    return assemble(expansion.study, "published", {"off_published": values} | own, sources=named, sweep=sweep_of(expansion))


@cache
def certified_cube(study: str) -> xr.Dataset:
    """The cube of a sweep whose means are certified, of runs that are made up: no kernel is compiled."""
    expansion = expansion_of(study)
    shape = tuple(len(axis.settings()) for axis in expansion.study.sweep)

    def run(scene) -> dict:
        flow, push = 1.0 + 0.1 * np.random.default_rng([scene.seed, round(1e3 * scene.march.step_factor)]).normal(size=2)
        found = {
            "mean_mass_flow": flow,
            "body_normal_force_at_rest": [push, 0.0, 0.0],
            "grains_at_start": 400.0,
            "time_step": 1e-5,
        }
        return {name: np.array(value) for name, value in found.items()}

    cases = [mean_numbers(case.scene.config, run, SWEPT["spheres"]) for case in expansion.cases]
    numbers = {name: np.array([case[name] for case in cases]) for name in cases[0]}
    numbers = {name: values.reshape(*shape, *values.shape[1:]) for name, values in numbers.items()}
    return assemble(expansion.study, "scenes", numbers | coordinates(expansion.study), sources=[], sweep=sweep_of(expansion))


@cache
def ladder_cube(study: str) -> xr.Dataset:
    """The cube of a sweep over settings and fillings, each setting a little off the first: no kernel is compiled."""
    expansion = expansion_of(study)
    shape = tuple(len(axis.settings()) for axis in expansion.study.sweep)
    off = 0.01 * np.arange(shape[0])[:, None] + 0.05 * np.random.default_rng(0).normal(size=shape)
    numbers = {"mean_mass_flow": 0.2 * (1.0 + off), "unit_weight_at_rest": 8e3 * (1.0 + 0.1 * off),
               "body_normal_force_at_rest": 3.0 * (1.0 - off)[..., None] * np.ones(3),
               "grains_at_start": np.full(shape, 2000.0), "end_time": np.full(shape, 0.5),
               "time_step": 1e-5 * np.sqrt(np.arange(1.0, shape[0] + 1.0))[:, None] * np.ones(shape)}  # fmt: skip
    numbers |= _ladder_walls(off, coordinates(expansion.study))
    return assemble(expansion.study, "scenes", numbers | coordinates(expansion.study), sources=[], sweep=sweep_of(expansion))


def shaken_ladder_cube(study: str) -> xr.Dataset:
    """The cube of shaken spheres whose wall carries 0.8, and 1 % less with each further setting, 0.1 % more each filling."""
    expansion = expansion_of(study)
    fillings = np.array(expansion.study.seeds)
    off = 1.0 - 0.01 * np.arange(expansion.shape[0])[:, None] + 0.001 * fillings
    numbers = {"carried_in_phase": off[..., None] * [0.8, 0.2, 1.0], "contents_damping": 0.1 * off, "ring_share": 0.3 * off}
    own = {"filling": fillings, "carrier": list(CARRIERS)}
    return assemble(expansion.study, "grains", numbers | own, sources=[], sweep=sweep_of(expansion))


def _ladder_walls(off: np.ndarray, own: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    """Pressures that fall with the height to none at 0.25 m; in flow one lowest cell bears five times that."""
    levels, turns, windows = (len(own[name]) for name in ("wall_level", "wall_turn", "flow_window"))
    height = 0.3 * (np.arange(levels) + 0.5) / levels
    rest = 4e3 * np.maximum(0.25 - height, 0.0)[:, None] * np.ones((*off.shape, levels, turns)) * (1.0 - off)[..., None, None]
    flow = np.repeat(rest[:, :, None], windows, axis=2)
    flow[:, :, -1, 0, 0] *= 5.0
    top = {
        "filled_height_at_rest": np.full(off.shape, 0.25),
        "wall_level_height": np.broadcast_to(height, (*off.shape, levels)),
    }
    return {"wall_pressure_at_rest": rest, "wall_pressure_in_flow": flow, **top}


@cache
def walls_cube(study: str) -> xr.Dataset:
    """The cube of a sweep of silos of spheres that feel Janssen's pressures times known factors."""
    expansion = expansion_of(study)
    return made_walls(expansion, [case.scene.silo.wall_depth for case in expansion_of(expansion.study.codes.study).cases])
