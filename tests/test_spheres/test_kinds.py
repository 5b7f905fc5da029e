"""Scenes of several kinds of spheres: an impact of unlike ones, one kind as two, the same bits, the ledger, a bin."""

import meshio
import numpy as np
import pytest

from silostudy.compute.dem import scene_model
from silostudy.compute.dem_cube import cube_of
from silostudy.compute.paraview import export
from silostudy.cube.io import write
from silostudy.dem.change import set_friction
from silostudy.dem.checkpoint import checkpoint, restore
from silostudy.dem.engine import Engine
from silostudy.dem.ledger import DASHPOT, SLIDING, TURNOVER, balance
from silostudy.dem.varied import Varied
from silostudy.tables.constants import ROUNDED_GRAVITY as GRAVITY
from tests.test_spheres import two_bodies
from tests.test_spheres.scenes import DENSITY, RADIUS, contact, heap, rows, same, spheres, stepped
from tests.test_spheres.small import carried, scene_of

pytestmark = pytest.mark.long  # a kernel of its own
STEPS = 5000
FIRM, SOFT, OTHER = (1e7, 0.25), (3e6, 0.4), contact(0.9, 0.1)
BETWEEN = Varied((contact(0.5, 0.5, materials=(FIRM, FIRM)), contact(0.3, 0.2, materials=(FIRM, SOFT)),
                  contact(0.8, 0.7, materials=(SOFT, SOFT))))  # fmt: skip
WALLS = Varied((contact(0.5, 0.3), contact(0.2, 0.6), OTHER, contact(0.5, 0.05)))  # of both kinds at floor and cylinder


def mixed(**changes):
    """Every third sphere of a heap is smaller, lighter and of another kind."""
    kind = np.arange(9 * changes.get("layers", 12)) % 3 // 2
    settings = {"kind": kind, "radius": np.where(kind, 0.9, 1.0) * RADIUS, "density": np.where(kind, 0.6, 1.0) * DENSITY,
                "pair_contact": BETWEEN, "wall_contact": WALLS, "wide": 4.1 * RADIUS}  # fmt: skip
    return heap(**(settings | changes))


@pytest.fixture(scope="module")
def reference():
    return stepped(Engine(mixed()), STEPS)


def test_one_kind_as_two_equal_ones_is_one_to_the_bit():
    pair, wall = contact(0.5), contact(0.5, 0.3)
    two = stepped(Engine(mixed(pair_contact=Varied((pair,) * 3), wall_contact=Varied((wall,) * 4))), STEPS)
    assert same(two, stepped(Engine(mixed(pair_contact=pair, wall_contact=wall)), STEPS))


@pytest.mark.parametrize("number", range(3))
def test_every_pair_of_kinds_counts(reference, number):
    other = Varied(tuple(OTHER if n == number else one for n, one in enumerate(BETWEEN.sets)))
    assert not np.array_equal(stepped(Engine(mixed(pair_contact=other)), STEPS)[0], reference[0])


@pytest.mark.parametrize("how", [{"skin": 0.5 * RADIUS}, {"threads": 2}], ids=str)
def test_however_it_is_carried_out(reference, how):
    assert same(stepped(Engine(mixed(), **how), STEPS), reference)


def test_any_number_of_threads_of_more_than_a_block():
    model = mixed(layers=60)
    assert same(stepped(Engine(model, threads=3), 3000), stepped(Engine(model), 3000))


def test_restart_after_a_change_of_friction():
    whole, after = Engine(mixed()), Engine(mixed(), threads=2)
    whole.step_to(1500)
    set_friction(whole, pair=0.9, wall=0.4, walls=("cylinder",))
    assert [one.coefficients["sliding_friction"] for one in whole.contacts[0].sets] == [0.9] * 3
    assert [one.coefficients["sliding_friction"] for one in whole.contacts[1].sets] == [0.3, 0.4, 0.1, 0.4]
    whole.step_to(2000)
    restore(after, checkpoint(whole))
    assert same(stepped(after, STEPS), stepped(whole, STEPS))


def test_python_twin():
    compiled, plain = (Engine(mixed(layers=1, u=0.3, w=-0.2)) for _ in range(2))
    plain._kernel = plain._kernel.py_func
    for engine in (compiled, plain):
        engine.step_to(400)
    assert np.abs(rows(compiled)[:, 6:]).max() > 0.1
    assert np.allclose(rows(plain), rows(compiled), rtol=1e-9, atol=1e-12)


def test_an_impact_of_unlike_spheres(monkeypatch):
    """Unequal radii, densities and moduli, against an integration apart from the package."""
    masses = np.array([DENSITY, 0.5 * DENSITY]) * 4.0 / 3.0 * np.pi * two_bodies.RADII**3
    shear = [e / (2.0 * (1.0 + nu)) for e, nu in (FIRM, SOFT)]
    told = two_bodies.C | {
        "hertz_stiffness": 4.0 / 3.0 / sum((1.0 - nu**2) / e for e, nu in (FIRM, SOFT)),
        "mindlin_stiffness": 8.0 / sum((2.0 - nu) / g for g, (_, nu) in zip(shear, (FIRM, SOFT), strict=True)),
        "hertz_damping": BETWEEN.sets[1].coefficients["hertz_damping"],
        "sliding_friction": 0.2,
    }
    for name, value in (("MASSES", masses), ("M", masses.prod() / masses.sum()), ("C", told)):
        monkeypatch.setattr(two_bodies, name, value)
    end, step = 4e-3, 1e-6
    model = spheres(
        two_bodies.START, two_bodies.VELOCITY, two_bodies.SPIN, radius=two_bodies.RADII, kind=np.array([0, 1]),
        density=np.array([1.0, 0.5]) * DENSITY, pair_contact=BETWEEN, wall_contact=Varied(WALLS.sets[:2]), dt=step,
    )  # fmt: skip
    engine = Engine(model, sort=False)
    engine.step_to(round(end / step))
    found = rows(engine)[:, 3:]
    laws = {"normal": "hertz", "tangential": "mindlin", "rolling": "none", "twisting": "none", "cohesion": "none"}
    expected = two_bodies.apart(laws, step / 2.0, end)
    before = np.hstack([two_bodies.VELOCITY, two_bodies.SPIN * two_bodies.RADII[:, None]])
    changed = np.abs(expected - before).max()
    assert changed > 0.1
    assert np.hstack([found[:, :3], found[:, 3:] * two_bodies.RADII[:, None]]) == pytest.approx(expected, abs=0.005 * changed)


def test_the_ledger_closes():
    engine = Engine(mixed(booked=True, layers=6))
    engine.step_to(1)
    start = balance(engine.ledger.account)
    engine.step_to(6000)
    account = engine.ledger.account
    assert min(account[DASHPOT], account[SLIDING]) > 0.01 * account[TURNOVER]
    assert abs(balance(account) - start) < 1e-9 * account[TURNOVER]


@pytest.fixture(scope="module")
def bin_of_two():
    stones = {"youngs_modulus_MPa": 20, "poissons_ratio": 0.3, "density_kg_m3": 3500, "mass_share": 0.4,
              "sizes": {"kind": "equal", "diameter_mm": 6}}  # fmt: skip
    scene = scene_of(other_grains={"stones": stones}, surfaces={"hopper": {"sliding_friction": 0.1}})
    return scene, carried(scene)


def test_a_bin_of_two_kinds_carries_its_weight_and_flows_out(bin_of_two):
    scene, whole = bin_of_two
    cube = cube_of(whole, scene)
    opened = float(cube.event_time[0])
    rest = cube.sel(window_time=slice(opened - 0.06, opened))
    assert rest.surface_load.sum("surface").values == pytest.approx(GRAVITY * float(cube.grain_mass.sum()), rel=3e-3)
    share = float(cube.grain_mass.where(cube.grain_kind == 1).sum() / cube.grain_mass.sum())
    assert share == pytest.approx(0.4, abs=0.005)
    assert cube.attrs["grain_kinds"] == "grain, stones"
    assert float(cube.outflow_mass[-1]) > 0.05 * float(cube.grain_mass.sum())


def test_its_cube_is_a_filling_and_its_snapshots_tell_kinds(bin_of_two, tmp_path):
    scene, whole = bin_of_two
    write(cube_of(whole, scene), tmp_path / "two.nc")
    others = {"stones": {"youngs_modulus_MPa": 20, "poissons_ratio": 0.3, "density_kg_m3": 3500}}
    model = scene_model(scene_of(filling={"kind": "given", "file": "two.nc"}, sizes=None, other_grains=others), tmp_path)
    there = np.isin(np.arange(whole.engine.most), whole.recording.snapshots[-1]["label"])
    assert np.array_equal(model.kind, whole.engine.model.kind[there])
    names = [file.name for file in export(whole, tmp_path)]
    points = meshio.read(tmp_path / names[0]).point_data
    assert np.array_equal(np.unique(points["radius"][points["kind"] == 1]), [0.003])
