"""A law is declared once: a row that joins its family runs from a scene's YAML fields through the kernel into a cube."""

import copy
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from numba.extending import register_jitable

from silostudy.compute.dem import carry_through, run_of, scene_model
from silostudy.compute.dem_cube import cube_of
from silostudy.config.dem import DemScene
from silostudy.config.load import validated
from silostudy.contact import LAWS, NORMAL, ROLLING, TANGENTIAL
from silostudy.contact.coefficient import Coefficient
from silostudy.contact.family import NormalLaw, RollingLaw, TangentialLaw
from silostudy.dem.ledger import TURNOVER, balance
from silostudy.dem.stability import longest_step
from silostudy.errors import BadInput

SOURCE = {"source": "kiyama_fujimura_1983", "locator": "a toy"}
RADIUS, DENSITY, GRAVITY, STIFFNESS = 0.01, 2650.0, 9.81, 2e10


@register_jitable
def push(overlap, closing, touch, c):
    """Elastic and total normal force (N/m) of a spring that stiffens with the overlap, without dashpot."""
    return c[0] * overlap * overlap, c[0] * overlap * overlap + c[1] * overlap * closing


@register_jitable
def push_energy(overlap, touch, c):
    return c[0] * overlap * overlap * overlap / 3.0


@register_jitable
def push_stiffness(overlap, touch, c):
    return 2.0 * c[0] * overlap


@register_jitable
def drag(stored, sliding, touch, elastic, normal, c):
    """Tangential force (N/m): a dashpot without a cap."""
    return 0.0, -c[0] * sliding


@register_jitable
def brake(stored, rolling, touch, elastic, c):
    """Stored (nothing) and total moment (N m/m): a dashpot by the difference of the spins."""
    return stored, -c[0] * rolling


NORMAL_ROW = NormalLaw(
    key="toy-square", title="Square spring", **SOURCE, law=push, energy=push_energy, stiffness=push_stiffness,
    damping=lambda touch, c: c[1] * 2e-4 + 0.0 * touch.mass, dissipates=("dashpot",),
    coefficients=(
        Coefficient(name="toy_square", unit="N m-3", fields=(("toy_square_N_m3",),), text="force over overlap squared",
                    positive=True),
        Coefficient(name="toy_dashpot", unit="N s m-3", fields=(("toy_dashpot_N_s_m3",),), text="dashpot over overlap",
                    default=0.0),
    ),
)  # fmt: skip
TANGENTIAL_ROW = TangentialLaw(
    key="toy-drag", title="Dashpot", **SOURCE, law=drag, damping=lambda touch, c: c[0] + 0.0 * touch.mass,
    dissipates=("dashpot",),
    coefficients=(Coefficient(name="toy_drag", unit="N s m-2", fields=(("toy_drag_N_s_m2",),), text="drag", default=1.0),),
)  # fmt: skip
ROLLING_ROW = RollingLaw(
    key="toy-brake", title="Rotational dashpot", **SOURCE, law=brake, damping=lambda touch, c: c[0] + 0.0 * touch.mass,
    dissipates=("dashpot",),
    coefficients=(Coefficient(name="toy_brake", unit="N s", fields=(("toy_brake_N_s",),), text="brake", default=0.0),),
)  # fmt: skip
FAMILIES = {family.name: family.joined([row]) for family, row in (
    (NORMAL, NORMAL_ROW), (TANGENTIAL, TANGENTIAL_ROW), (ROLLING, ROLLING_ROW))}  # fmt: skip
SCENE = {
    "kind": "dem",
    "title": "toy laws",
    "silo": {"width_m": 0.17, "height_m": 0.3, "wall_cells": 3},
    "packing": {"kind": "rows", "across": 8, "fill_height_m": 0.06, "gap_m": 4e-5},
    "radius_m": RADIUS,
    "density_kg_m3": DENSITY,
    "discs": {"normal": "toy-square", "tangential": "toy-drag", "rolling": "toy-brake", "toy_square_N_m3": STIFFNESS,
              "toy_dashpot_N_s_m3": 4e7, "toy_drag_N_s_m2": 20.0, "toy_brake_N_s": 1e-4},
    "march": {"step_s": 2e-5, "limit_s": 0.6},
    "events": [{"when": "time", "value": 0.6, "do": "stop"}],
    "record": {"wall_force_window_s": 0.05, "energy": True},
}  # fmt: skip


def scene_of(context=FAMILIES, **discs) -> DemScene:
    content = copy.deepcopy(SCENE)
    content["discs"] |= discs
    content["discs"] = {key: value for key, value in content["discs"].items() if value is not None}
    return validated(DemScene, content, "toy.yaml", context)


@pytest.mark.long
def test_laws_that_join_run_from_the_scene_to_the_cube():
    scene = scene_of()
    model = scene_model(scene, Path())
    assert model.pair_contact.coefficients == {"toy_square": STIFFNESS, "toy_dashpot": 4e7, "toy_drag": 20.0, "toy_brake": 1e-4}
    run = run_of(scene, model)
    run.engine.step_to(1)
    start = balance(run.engine.ledger.account)
    carry_through(run, scene, None, lambda step: None)
    cube = cube_of(run, scene)
    floor = cube["wall_normal_force_mean"][-1].where(cube["wall_name"] == "floor").sum()
    assert float(floor) == pytest.approx(model.mass.sum() * GRAVITY, rel=1e-3)  # nothing rubs on the walls at rest
    account = run.engine.ledger.account
    assert abs(balance(account) - start) < 1e-9 * account[TURNOVER]
    # the overlap of every disc on the floor is what its own spring makes of its force
    pushed = model.mass.sum() * GRAVITY
    lowest = np.sort(run.engine.places[:, 1])[:8]
    assert (STIFFNESS * (RADIUS - lowest) ** 2).sum() == pytest.approx(pushed, rel=1e-2)


def test_the_bound_follows_a_law_s_own_stiffness():
    bare = {"toy_dashpot_N_s_m3": 0.0, "toy_drag_N_s_m2": 0.0, "toy_brake_N_s": 0.0}
    plain, stiff = (
        longest_step(scene_model(scene_of(toy_square_N_m3=k, **bare), Path())) for k in (STIFFNESS, 4.0 * STIFFNESS)
    )
    assert stiff == pytest.approx(0.5 * plain, rel=1e-3)
    with pytest.raises(BadInput, match="beyond the stability bound"):
        scene_model(scene_of(**bare | {"toy_drag_N_s_m2": 1e5}), Path())


@pytest.mark.long
def test_two_laws_of_one_key_are_two_kernels():
    """Another study's law of the same key: its own force, in the same process."""

    @register_jitable
    def softer(overlap, closing, touch, c):
        """Elastic and total normal force (N/m)."""
        return 0.25 * c[0] * overlap * overlap, 0.25 * c[0] * overlap * overlap + c[1] * overlap * closing

    other = FAMILIES | {NORMAL.name: NORMAL.joined([replace(NORMAL_ROW, law=softer)])}
    rest = []
    for families in (FAMILIES, other):
        scene = scene_of(families)
        run = run_of(scene, scene_model(scene, Path()))
        run.go()
        rest.append(RADIUS - np.sort(run.engine.places[:, 1])[:8].mean())
    assert rest[1] == pytest.approx(2.0 * rest[0], rel=0.05)


@pytest.mark.parametrize(("context", "discs", "message"), [
    (None, {}, "discs.normal = 'toy-square': unknown; known: spring-dashpot"),
    (FAMILIES, {"toy_square_N_m3": None}, "toy_square_N_m3: must be given: the law toy-square needs it"),
    (FAMILIES, {"toy_square_N_m3": 0.0}, r"discs.toy_square_N_m3 = 0\.0: must be greater than 0"),
    (FAMILIES, {"toy_drag_N_s_m2": "much"}, "discs.toy_drag_N_s_m2 = 'much': must be a number"),
    (FAMILIES, {"toy_sqare_N_m3": 1.0}, r"discs.toy_sqare_N_m3 = 1\.0: unknown key"),
    (FAMILIES, {"tangential": "spring-slider"}, "give either normal_stiffness_N_m2 or line_contact"),
])  # fmt: skip
def test_refusals_name_key_value_and_range(context, discs, message):
    with pytest.raises(BadInput, match=message):
        scene_of(context, **discs)


def test_the_families_stay_as_they_are():
    assert not {row.key for row in (NORMAL_ROW, TANGENTIAL_ROW, ROLLING_ROW)} & {
        key for family in LAWS.values() for key in family
    }
