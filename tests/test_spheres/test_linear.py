"""Linear springs and dashpots in scenes of spheres: what a user writes, and the restitution that comes of it."""

from math import pi, sqrt

import numpy as np
import pytest
import yaml

from silostudy.__main__ import main
from silostudy.compute.dem import scene_model
from silostudy.contact import restitution
from silostudy.dem.engine import Engine
from silostudy.dem.stability import longest_step
from silostudy.errors import BadInput
from silostudy.scene.spheres import contacts_of
from tests.conftest import ROOT
from tests.test_spheres.scenes import DENSITY, RADIUS, rows, spheres
from tests.test_spheres.small import content, scene_of

LINEAR = {"normal": "spring-dashpot", "tangential": "spring-slider", "restitution": 0.4, "sliding_friction": 0.5}


def linear(stiffness=2e3, **changes):
    return LINEAR | {"normal_stiffness_N_m": stiffness} | changes


def test_coefficients_are_of_springs_in_n_m():
    """A dashpot by the root of the mass, that of the restitution; tangential ones by the ratio and its root."""
    between, wall = contacts_of(scene_of(spheres=linear(stiffness_ratio=0.5), walls=linear(4e3)))
    c = between.coefficients
    assert (c["normal_stiffness"], c["tangential_stiffness"], c["normal_damping"]) == (2e3, 1e3, 0.0)
    assert restitution.of_cut(c["normal_damping_root"] / (2.0 * sqrt(2e3))) == pytest.approx(0.4)
    assert c["tangential_damping_root"] == pytest.approx(sqrt(0.5) * c["normal_damping_root"])
    assert wall.coefficients["normal_stiffness"] == 4e3
    units = {one.name: one.unit for row in between.rows for one in row.coefficients}
    assert (units["normal_stiffness"], units["normal_damping_root"]) == ("N m-1", "N s m-1 kg-1/2")


def test_the_bound_of_linear_springs_knows_no_overlap():
    """Two spheres without dashpots: the stiffer of normal and tangential motion, whatever they weigh upon each other."""
    undamped = linear(restitution=1.0)
    model = scene_model(scene_of(spheres=undamped, walls=undamped, march={"limit_s": 1.0, "step_s": 1e-6}), ROOT)
    mass = 2500 * 4.0 / 3.0 * pi * 0.004**3
    assert longest_step(model) == pytest.approx(2.0 / sqrt(2.0 * max(2e3, 0.25 * 3.5 * 2e3) / mass), rel=1e-6)


@pytest.mark.parametrize(
    ("section", "told"),
    [
        ({"normal": "spring-dashpot", "tangential": "spring-slider"},
         "normal_stiffness_N_m: must be given: the law spring-dashpot needs it"),
        ({"normal": "spring-dashpot", "normal_stiffness_N_m": 1e3}, "tangential: the law mindlin does not go with spring"),
        ({"tangential": "spring-slider", "normal_stiffness_N_m": 1e3}, "spring-slider does not go with hertz: take"),
        ({"normal_stiffness_N_m": 1e3}, "no law here has linear springs: hertz takes the materials' moduli"),
        ({**LINEAR, "normal_stiffness_N_m": 0.0}, "must be greater than 0"),
    ],
)  # fmt: skip
def test_springs_that_do_not_go_together_are_told(section, told):
    with pytest.raises(BadInput, match=r"small\.yaml: spheres") as caught:
        scene_of(spheres={"restitution": 0.3, "sliding_friction": 0.5} | section)
    assert told in str(caught.value)


def test_a_softened_modulus_that_changes_nothing_is_told(tmp_path, capsys):
    path = tmp_path / "linear.yaml"
    path.write_text(yaml.safe_dump(content(spheres=linear(), walls=linear())))
    assert main(["check", str(path)]) == 0
    told = capsys.readouterr().out
    assert "softened_modulus_MPa changes nothing" in told
    assert "times as long" not in told


@pytest.mark.long
@pytest.mark.parametrize("speed", [1e-3, 1.0])
def test_unequal_spheres_rebound_with_the_restitution_asked_for(speed):
    between, _ = contacts_of(scene_of(spheres=linear(), walls=linear()))
    radius = np.array([RADIUS, 1.7 * RADIUS])
    place = np.array([[0.0, 0.0, 1.0], [2.7001 * RADIUS, 0.0, 1.0]])
    mass = DENSITY * 4.0 / 3.0 * pi * radius**3
    reduced = mass.prod() / mass.sum()
    dt = 1e-3 * pi * sqrt(reduced / 2e3)
    model = spheres(place, velocity=[[speed, 0.0, 0.0], [0.0, 0.0, 0.0]], radius=radius, pair_contact=between, dt=dt)
    engine = Engine(model)
    engine.step_to(2500 + round(1e-4 * RADIUS / speed / dt))
    velocity = rows(engine)[:, 3]
    assert velocity[1] - velocity[0] == pytest.approx(0.4 * speed, rel=5e-3)
    assert mass @ velocity == pytest.approx(mass[0] * speed, rel=1e-9)
