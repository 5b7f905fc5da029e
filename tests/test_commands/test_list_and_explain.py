"""`silostudy list` and `silostudy explain` as a user types them."""

import re
from typing import get_args

import pytest
import yaml

from silostudy.choice.fronts import FRONTS
from silostudy.commands.explain_keys import key_explanation
from silostudy.commands.explain_scene import PARTS, grains_of, rows_of
from silostudy.config.dem import EventConfig
from silostudy.config.sphere_events import SphereEventConfig
from silostudy.pressure import PRESSURE
from silostudy.stages import FILE_KINDS
from silostudy.tables.asked import quantities
from tests.conftest import ROOT
from tests.own import BOTH, LAW
from tests.test_commands.said import WHEAT, said


@pytest.mark.parametrize(
    ("what", "expected"),
    [
        ("methods", PRESSURE),
        ("solids", ["cement", "wheat_benchmark"]),
        ("walls", ["roughness_5"]),
        ("outputs", ["fig_4_2_11"]),
        ("measurements", ["thompson_12_8", "jarrett_corner"]),
    ],
)
def test_list(capsys, what, expected):
    out = said(capsys, "list", what)
    for key in expected:
        assert re.search(rf"^{key} ", out, re.MULTILINE)


def test_list_studies(capsys):
    assert "wheat-family" in said(capsys, "list", "studies", "--studies", ROOT / "config/studies")
    assert "holds no study files" in said(capsys, "list", "studies", "--studies", ROOT / "tests", status=2)


@pytest.mark.parametrize("method", PRESSURE)
def test_explain_every_method(capsys, method):
    out = said(capsys, "explain", method)
    for part in ("formula", "range", "plans", "gives wall_normal_pressure", "symbols", f"source    {PRESSURE[method].source}"):
        assert part in out


def test_explain_names_its_symbols(capsys):
    out = said(capsys, "explain", "jenike_mass_flow")
    assert "nu: poisson_ratio (1)" in out
    assert "R = A/U: hydraulic_radius (m)" in out


def test_explain_accuracy_names_every_kind(capsys):
    out = said(capsys, "explain", "accuracy")
    assert "seismic, effective_mass_coefficient: coefficient found" in out
    assert "sets identification.refinement" in out
    assert "shell, wall_force: friction force of the whole wall" in out  # a shell study is a pressure study too
    assert "buckling: may not ask: none of its settings decides a numerical error" in out
    for row in FRONTS:
        assert f"{row.kind}, {row.quantity}: {quantities([row.kind])[row.quantity].title}" in out
        assert f"error goes with {row.scaled_by or 'no trait'}; measured within" in out


def test_explain_tells_the_sources_errors(capsys):
    assert "printed 0.584; right: 0.548" in said(capsys, "explain", "caquot")
    assert "unknown; known: janssen" in said(capsys, "explain", "jansen", status=2)


def test_a_users_own_file_is_listed_explained_and_compared(capsys, tmp_path):
    (tmp_path / "mine.py").write_text(BOTH)
    (tmp_path / "law.py").write_text(LAW)
    mine, law = ("--methods-from", tmp_path / "mine.py"), ("--methods-from", tmp_path / "law.py")
    assert "frictionless " in said(capsys, "list", "methods", *mine)
    assert "a_fifth " in said(capsys, "list", "buckling", *mine)
    assert re.search(r"^normal +stiffer +A stiffer spring", said(capsys, "list", "laws", *law), re.MULTILINE)
    told = said(capsys, "explain", "frictionless", *mine)
    assert "  formula   p_h = K gamma z" in told
    assert told.count("J. Doe, Notes on a smooth silo, 2026, page 3") == 1
    assert "takes     stiffening (1), positive: from stiffening" in said(capsys, "explain", "stiffer", *law)
    silo = ("--diameter", 5, "--depth", 18, "--solid", "wheat_benchmark")
    table = said(capsys, "compare", *silo, "--methods", "frictionless", *mine)
    own = next(line for line in table.splitlines() if line.startswith("frictionless, filling"))
    assert "63.55" in own  # K gamma z at 18 m
    assert said(capsys, "compare", *silo, "--methods", "frictionles", *mine, status=2).count("\n") == 1
    assert "unknown; known: janssen" in said(capsys, "explain", "frictionless", status=2)
    assert "--methods-from = " in said(capsys, "compare", WHEAT, *mine, status=2)
    scene = ROOT / "config/scenes/kiyama-17-18.yaml"
    assert f"write `methods_from` into {scene}" in said(capsys, "explain", scene, *mine, status=2)


def test_a_law_is_explained_in_every_family_that_has_its_key(capsys):
    told = said(capsys, "explain", "spring-slider")
    assert "rolling_stiffness (N), zero or more: from rolling_stiffness_N\n" in told
    assert "of spheres N m: from rolling_stiffness_N_m\n" in told
    assert "tangential_stiffness (N m-2)" in told


@pytest.mark.parametrize("part", PARTS)
def test_every_part_of_a_scene_is_listed_and_explained(capsys, part):
    listed = said(capsys, "list", part)
    for key, row in rows_of(part).items():
        grains = grains_of(part, key)
        assert re.search(rf"^{key} +{', '.join(grains)} +{re.escape(row.title)}$", listed, re.MULTILINE)
        assert f"{row.title} ({key}, of {part} of {' and '.join(grains)})" in said(capsys, "explain", key)


@pytest.mark.parametrize(
    ("part", "key", "grains"),
    [
        ("actions", "remove_disc", "discs"),
        ("actions", "rotate", "spheres"),
        ("actions", "stop", "discs, spheres"),
        ("fillings", "rain", "spheres"),
        ("packings", "rows", "discs"),
        ("inserts", "line", "discs"),
        ("quantities", "wall-load", "spheres"),
        ("quantities", "surface-angle", "discs, spheres"),
    ],
)
def test_a_list_says_of_which_grains_a_part_is(part, key, grains, capsys):
    assert re.search(rf"^{key} +{grains} +[A-Za-z]", said(capsys, "list", part), re.MULTILINE)


def test_actions_say_what_they_take(capsys):
    told = said(capsys, "explain", "set_friction")
    assert "discs     may take disc_friction, wall_friction, surfaces" in told
    assert "spheres   may take sphere_friction, wall_friction, surfaces" in told
    assert "discs" not in said(capsys, "explain", "rotate")


@pytest.mark.parametrize("events", [EventConfig, SphereEventConfig])
def test_every_action_of_a_scene_is_a_row(events):
    assert set(get_args(events.model_fields["do"].annotation)) == set(events.takes) <= set(rows_of("actions"))


def test_kinds_are_listed_with_their_cubes_under_them(capsys):
    told = said(capsys, "list", "kinds").split("\n")
    assert told[0].startswith("What a file says as `kind`")
    place = next(number for number, line in enumerate(told) if line.startswith("scenes "))
    assert told[place + 1].split()[0] == "scenes.nc"
    assert told[place + 2].split()[0] == "beside.nc"
    assert told[place + 2].endswith("(where the study has a section codes)")


@pytest.mark.parametrize("kind", FILE_KINDS)
def test_every_kind_explains_its_keys(capsys, kind):
    told = said(capsys, "explain", kind)
    assert f"(kind: {kind})" in told
    for name, field in FILE_KINDS[kind].study.model_fields.items():
        assert re.search(rf"^  {name}( \(.*?\))?: {re.escape(field.description)}", told, re.MULTILINE)


def test_every_key_that_a_shipped_file_says_is_explained():
    contents = [
        yaml.safe_load(path.read_text()) for part in ("studies", "scenes") for path in (ROOT / "config" / part).glob("*.yaml")
    ]
    said_there = {key for content in contents for key in content}
    assert {"codes", "fillings", "events"} < said_there
    assert [key for key in sorted(said_there) if not key_explanation(key)] == []


def test_a_key_is_explained_with_its_places_and_its_own_keys(capsys):
    told = said(capsys, "explain", "sample")
    assert "key sweep.sample of kind accuracy, buckling, grains" in told
    assert "      count: cases [must be given]" in told
    assert "key checks of kind shell" in said(capsys, "explain", "checks")  # beside the topic of that name


def test_the_energy_balance_says_that_it_takes_one_thread(capsys):
    assert "takes 1 thread and no more" in said(capsys, "explain", "energy")


def test_explain_names_a_sections_keys_units_and_choices(capsys):
    told = said(capsys, "explain", "dem")
    assert "      gap_m (m): gap between neighbours at the start [must be given]" in told
    assert "tangential: law of the tangential force [spring-slider] {none, spring-slider," in told
    assert "[17-18] {17-18, 17-19, velocity-verlet}" in told
