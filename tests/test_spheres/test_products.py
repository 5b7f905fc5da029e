"""Every product of laws: an oblique impact of two spheres against an integration written apart from them."""

from itertools import product
from types import SimpleNamespace

import numpy as np
import pytest

from silostudy.contact import COHESION as PULLS
from silostudy.contact import NORMAL, SPHERE_LAWS
from silostudy.dem.arrays import aligned
from silostudy.dem.engine import Engine
from silostudy.dem.force import contact_pass
from silostudy.dem.integrate import INTEGRATORS
from silostudy.dem.model import Contact
from silostudy.dem.pieces import Laws
from silostudy.dem.space.dimension import SPACE
from silostudy.dem.space.lanes import PLACE, SPIN, VELOCITY, gather, scatter
from tests.test_spheres import two_bodies
from tests.test_spheres.scenes import rows, spheres
from tests.test_spheres.two_bodies import END, MASSES, RADII, C, M, apart

pytestmark = pytest.mark.long
BEFORE = np.hstack([two_bodies.VELOCITY, two_bodies.SPIN * RADII[:, None]])
FAMILIES = tuple(SPHERE_LAWS)
PLAIN = dict.fromkeys(FAMILIES, "none")
STEP = 2e-6


def choices(**fixed):
    """All products of the laws of spheres that stand together, some families held at a law."""
    families = (([fixed[name]] if name in fixed else list(SPHERE_LAWS[name])) for name in FAMILIES)
    for keys in (dict(zip(FAMILIES, chosen, strict=True)) for chosen in product(*families)):
        if NORMAL[keys["normal"]].of_hertz or not PULLS[keys["cohesion"]].of_hertz:
            yield keys


def met(laws, c, integrator, dt):
    """Velocities and spins by the kernel's own pieces, without lists: gather, laws, scatter, move."""
    row = INTEGRATORS[integrator]
    contact = contact_pass(SPACE, laws, unequal=True, flat=False)
    move = SPACE.move(row.advance, row.holds, True, True, integrator)
    rows, held, pair = aligned(2, SPACE.row), aligned(2, SPACE.row // 2), (np.array([0]), np.array([1]))
    bodies = SimpleNamespace(rows=rows, held=held, inverse_mass=1.0 / MASSES, inverse_inertia=2.5 / (MASSES * RADII**2))
    scratch, out = SimpleNamespace(lanes=aligned(*SPACE.lanes), motion=aligned(2)), aligned(*SPACE.forces)
    for columns, values in ((PLACE, two_bodies.START), (VELOCITY, two_bodies.VELOCITY), (SPIN, two_bodies.SPIN)):
        rows[:, columns] = values
    held[:, :6] = rows[:, [*VELOCITY, *SPIN]]
    histories = (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), 0.0, 0.0
    for step in range(round(END / dt)):
        gather(rows, *pair, 0, 1, scratch.lanes)
        histories = contact(scratch.lanes, out, 0, *RADII, M, *histories, dt, c)
        scatter(rows, *pair, 0, 1, out)
        move(bodies, 0, 2, (0.0, 0.0, 0.0), 0.5 * dt if row.half_start and step == 0 else dt, dt, scratch)
    return np.hstack([rows[:, VELOCITY], rows[:, SPIN] * RADII[:, None]])


def check(found, expected):
    changed = np.abs(expected - BEFORE).max()
    assert changed > 0.02
    assert found == pytest.approx(expected, abs=0.015 * changed)


@pytest.mark.parametrize("tangential", SPHERE_LAWS["tangential"])
@pytest.mark.parametrize("normal", SPHERE_LAWS["normal"])
def test_all_laws_by_every_march(normal, tangential):
    for keys in choices(normal=normal, tangential=tangential):
        contact, expected = Contact.taking(Laws.of(**keys), C), apart(keys, STEP / 2.0)
        for integrator in INTEGRATORS:
            try:
                check(met(contact.laws, contact.ordered, integrator, STEP), expected)
            except AssertionError as error:
                raise AssertionError(f"{', '.join(keys.values())}; {integrator}") from error


def one_of_each():
    """Every law once, the others as plain as they can be beside it."""
    for family, rows_of in SPHERE_LAWS.items():
        for key in rows_of:
            yield PLAIN | {"normal": "hertz", "tangential": "mindlin-rescaled"} | {family: key}


@pytest.mark.parametrize("keys", list(one_of_each()), ids=lambda keys: ", ".join(keys.values()))
def test_every_law_through_the_lists(keys):
    """By the engine whole: its lists, histories and memories; in Python, since a product of laws is not worth a kernel."""
    touch = Contact.taking(Laws.of(**keys), C)
    model = spheres(two_bodies.START, two_bodies.VELOCITY, two_bodies.SPIN, radius=RADII, pair_contact=touch,
                    wall_contact=touch, dt=STEP, watched=False)  # fmt: skip
    engine = Engine(model, sort=False)
    engine._kernel = engine._kernel.py_func
    engine.step_to(round(END / STEP))
    found = rows(engine)[:, 3:]
    check(np.hstack([found[:, :3], found[:, 3:] * RADII[:, None]]), apart(keys, STEP / 2.0))


@pytest.mark.parametrize("family", FAMILIES)
def test_every_law_makes_a_difference(family):
    """Else a product of laws would agree with anything."""
    keys = {"normal": "hertz", "tangential": "mindlin", "rolling": "spring-slider", "cohesion": "none", "twisting": "none"}
    ends = [apart(keys | {family: key}, STEP) for key in SPHERE_LAWS[family] if key != "spring-dashpot-implicit"]
    for k, one in enumerate(ends):
        for other in ends[:k]:
            assert np.abs(one - other).max() > 2e-4
