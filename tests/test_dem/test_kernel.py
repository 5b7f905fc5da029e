"""The compiled step: its Python twin, effects that are neutral, orders of convergence, the cache."""

import ast
import dis
import os
import subprocess
import sys
from pathlib import Path
from types import FunctionType

import numpy as np
import pytest
from numba import config
from numba.core.dispatcher import Dispatcher
from numba.core.extending import _Intrinsic

import silostudy.dem
from silostudy.choice.dem import load
from silostudy.compute.dem import scene_model
from silostudy.dem.cache import is_compiled
from silostudy.dem.engine import Engine
from silostudy.dem.integrate import INTEGRATORS
from silostudy.dem.kernel import kernel
from silostudy.dem.lanes import U, X
from silostudy.dem.model import Contact, Wall
from silostudy.dem.pieces import Laws
from silostudy.errors import BadInput
from tests.conftest import ROOT

from .scenes import DENSITY, RADIUS, SLIDING, STIFFNESS, contact, free, rows, silo

FREQUENCY = np.sqrt(2.0 * STIFFNESS / (DENSITY * np.pi * RADIUS**2))  # of two equal discs in contact, 1/s


def five_grains(**changes):
    x, y = np.array([0.011, 0.0305, 0.021, 0.0112, 0.031]), np.array([0.0099, 0.0101, 0.0270, 0.0441, 0.0445])
    walls = (Wall("floor", (0.0, 0.0), (0.05, 0.0), cells=3), Wall("left", (0.0, 0.1), (0.0, 0.0), cells=3))
    settings = {"walls": walls, "gravity": (0.5, -9.81), "dt": 2.5e-5, "watched": True, "u": [0.3, -0.2, 0.1, 0.0, 0.0]}
    return free(x, y, **(settings | changes))


def test_python_twin_of_the_step():
    compiled, plain = Engine(five_grains()), Engine(five_grains())
    plain._kernel = plain._kernel.py_func
    for engine in (compiled, plain):
        engine.step_to(300)
    assert np.array_equal(rows(compiled), rows(plain))
    assert np.array_equal(compiled.record.window, plain.record.window)
    assert compiled.record.window[:, 0, 2].max() > 0.0


def test_the_list_gives_what_all_pairs_give():
    """A list that always holds every pair, and one that the engine chooses, step alike."""
    wide, chosen = Engine(silo(), skin=1.99 * RADIUS), Engine(silo())
    for engine in (wide, chosen):
        engine.step_to(3000)
    assert np.array_equal(rows(wide), rows(chosen))
    count = [engine.parts[0].pairs.begin[engine.blocks_of(engine.parts[0])] for engine in (wide, chosen)]
    assert count[0] > 2 * count[1]


NEUTRAL = {
    "friction": {"pair_contact": contact(laws=Laws()), "wall_contact": contact(2.0, laws=Laws())},
    "rolling": {
        "pair_contact": contact(
            laws=Laws.of(tangential="spring-slider", rolling="spring-slider"), rolling_stiffness=1.0, rolling_friction=0.0
        )
    },
    "cohesion": {"pair_contact": contact(laws=Laws.of(tangential="spring-slider", cohesion="constant-pull"), pull=0.0)},
    "shaking": {"quake": np.zeros((10, 2))},
    "observers": {"watched": False},
}


@pytest.mark.parametrize(
    "effect", [*(pytest.param(effect, marks=pytest.mark.long) for effect in ("rolling", "cohesion")), "shaking", "observers"]
)
def test_an_effect_with_neutral_parameters_changes_no_bit(effect):
    without, neutral = Engine(silo()), Engine(silo(**NEUTRAL[effect]))
    for engine in (without, neutral):
        engine.step_to(1500)
    assert np.array_equal(rows(without), rows(neutral))


def test_friction_of_zero_is_no_friction():
    without = Engine(silo(**NEUTRAL["friction"]))
    slippery = {"tangential_damping": 0.0}
    neutral = Engine(silo(pair_contact=contact(friction=0.0, **slippery), wall_contact=contact(2.0, 0.0, **slippery)))
    for engine in (without, neutral):
        engine.step_to(1500)
    assert np.array_equal(rows(without), rows(neutral))
    assert without.parts[0].pairs.stored.size == 0  # no history where nothing slides


def test_unequal_discs_of_equal_size_change_no_bit():
    """A radius array all of one value gives the bits of the single radius."""
    from dataclasses import fields, replace

    model = silo()
    equal = Engine(model)
    each = Engine(model)
    each.model = type("Unequal", (type(model),), {"unequal": True})(
        **{of.name: getattr(model, of.name) for of in fields(model)}
    )
    each.__init__(each.model)
    assert replace(equal.model.pieces, unequal=True) == each.model.pieces
    for engine in (equal, each):
        engine.step_to(1500)
    assert np.array_equal(rows(equal), rows(each))


@pytest.mark.parametrize("integrator", INTEGRATORS)
def test_order_of_convergence(integrator):
    """Of a two-disc impact while the contact lasts: errors against a far finer step, halving the step."""

    def end(dt):
        model = free(
            [0.0, 1.99 * RADIUS], [0.0, 0.0], u=[0.1, -0.1], pair_contact=contact(damping=0.0), dt=dt, integrator=integrator
        )
        engine = Engine(model)
        engine.step_to(round(4e-4 / dt))
        return rows(engine)[1, [X, U]] * [FREQUENCY, 1.0]

    exact = end(1e-6 / 32)
    errors = np.array([np.hypot(*(end(dt) - exact)) for dt in (4e-6, 2e-6, 1e-6)])
    orders = np.log2(errors[:-1] / errors[1:])
    assert orders == pytest.approx(INTEGRATORS[integrator].order, abs=0.2)


def test_a_kernel_is_kept_from_its_first_step(monkeypatch, tmp_path):
    engine = Engine(five_grains())
    engine.step_to(1)
    assert is_compiled(engine._kernel)
    monkeypatch.setattr(config, "CACHE_DIR", str(tmp_path))
    assert not is_compiled(engine._kernel)


KEPT = """
import hashlib, sys
from silostudy.dem.engine import Engine
from silostudy.dem.pieces import Laws
from tests.test_dem.scenes import contact, silo
for tangential in sys.argv[1:]:
    laws = Laws.of(tangential=tangential)
    engine = Engine(silo(pair_contact=contact(laws=laws), wall_contact=contact(2.0, 0.176, laws=laws)))
    engine.step_to(1000)
    print(tangential, hashlib.sha256(engine.bodies.rows.tobytes()).hexdigest(), sum(engine._kernel.stats.cache_hits.values()))
"""


def motions_of_another_process(folder, *laws):
    environment = os.environ | {"NUMBA_CACHE_DIR": str(folder)}
    command = [sys.executable, "-c", KEPT, *laws]
    told = subprocess.run(command, capture_output=True, text=True, check=True, env=environment).stdout
    return {law: (motion, int(found)) for law, motion, found in map(str.split, told.splitlines())}


@pytest.mark.long
def test_kernels_kept_by_two_processes_do_not_mix_in_a_third(tmp_path):
    """Numba numbers functions anew in each process; the first call keeps what all kernels share, so that the numbers agree."""
    motions_of_another_process(tmp_path, "none")
    alone = {law: motions_of_another_process(tmp_path, law)[law] for law in ("spring-slider", "spring-slider-total")}
    both = motions_of_another_process(tmp_path, *alone)
    assert both == {law: (motion, 1) for law, (motion, _) in alone.items()}  # found, and moving as when compiled
    assert [found for _, found in alone.values()] == [0, 0]
    assert len({motion for motion, _ in alone.values()}) == 2


def closed_over(function, met):
    """Everything that a kernel's inner functions close over or name; functions of a module are kept by their name alone."""
    cells = [cell.cell_contents for cell in function.__closure__ or ()]
    names = {one.argval for one in dis.get_instructions(function) if one.opname == "LOAD_GLOBAL"}
    named = [function.__globals__[name] for name in names if name in function.__globals__]
    for value in (*cells, *(named if met else [])):  # the kernel's own globals do not name it
        if id(value) not in met:
            met[id(value)] = value
            if isinstance(value, FunctionType) and not hasattr(sys.modules[value.__module__], value.__qualname__):
                closed_over(value, met)
    return list(met.values())


@pytest.mark.parametrize("scene", ["kiyama-17-18", "press", "wheat-bin"])
def test_a_kernel_closes_over_plain_functions_only(scene):
    """A compiled one or an intrinsic has other bytes in every process: the kept kernel would never be found again."""
    asked, _ = load(ROOT / f"config/scenes/{scene}.yaml")
    inner = closed_over(kernel(scene_model(asked, ROOT).pieces).py_func, {})
    assert len(inner) > 20
    assert [value for value in inner if isinstance(value, Dispatcher | _Intrinsic)] == []


def test_inner_functions_of_a_kernel_have_names_of_their_own():
    """One that is not registered by `piece` would share its linker name with those of other kernels."""
    inner = [
        (path.name, node.name, ast.unparse(mark))
        for path in Path(silostudy.dem.__file__).parent.rglob("*.py")
        for outer in ast.walk(ast.parse(path.read_text()))
        if isinstance(outer, ast.FunctionDef)
        for node in outer.body
        if isinstance(node, ast.FunctionDef)
        for mark in node.decorator_list
    ]
    assert len(inner) > 5
    # what an overload chooses from has names of its own, and the choice is not compiled
    assert [found for found in inner if not found[2].startswith(("piece(", "overload("))] == []


def test_a_new_scene_of_the_same_pieces_compiles_nothing():
    first = Engine(silo())
    first.step_to(2)
    compiled = len(first._kernel.signatures)
    other = Engine(silo(across=9))
    other.step_to(2)
    assert other._kernel is first._kernel
    assert len(other._kernel.signatures) == compiled


def test_explosion_stops_with_disc_time_and_cause():
    from silostudy.dem.explosion import Explosion

    engine = Engine(silo(dt=4e-4))
    with pytest.raises(Explosion, match=r"disc \d+ ran away at t = .* time step") as caught:
        engine.step_to(5000)
    assert caught.value.step == engine.step < 5000
    found = rows(engine)
    place, moved = found[:, :2], np.hypot(*found[:, 2:4].T) * 4e-4
    apart = np.hypot(*(place - place[caught.value.disc]).T)
    apart[caught.value.disc] = np.inf
    near = min(apart.min() / 2.0, place[caught.value.disc, 1])
    assert moved[caught.value.disc] > RADIUS or near < 0.75 * RADIUS


BAD = {
    "zero radius": {"radius": 0.0},
    "negative radius": {"radius": -1.0},
    "NaN in x": {"x": np.full(5, np.nan)},
    "zero density": {"density": 0.0},
    "zero step": {"dt": 0.0},
    "NaN step": {"dt": np.nan},
    "integrator": {"integrator": "17-20"},
}


@pytest.mark.parametrize("case", BAD)
def test_bad_models(case):
    (field,) = BAD[case]
    with pytest.raises(BadInput) as caught:
        five_grains(**BAD[case]) if field != "x" else free(BAD[case]["x"], np.zeros(5))
    assert caught.value.field == field


def test_bad_coefficients():
    with pytest.raises(BadInput, match=r"normal_stiffness = 0\.0"):
        Contact(SLIDING, {**contact().coefficients, "normal_stiffness": 0.0})
    with pytest.raises(BadInput, match=r"unknown.*these laws take"):
        contact(bounce=1.0)
    with pytest.raises(BadInput, match="sliding_friction = nan"):
        contact(friction=np.nan)
    with pytest.raises(BadInput, match="unknown; known: none, spring-slider"):
        Contact(Laws.of(tangential="glue"), {})
    with pytest.raises(BadInput, match="length"):
        Wall("floor", (0.0, 0.0), (0.0, 0.0))
