"""A new figure, packing or whole kind of study takes one declaration beside its code: it then runs from YAML file to result."""

import shutil

import pandas as pd
import pytest
import yaml

from silostudy.cube.io import read
from tests.conftest import ROOT
from tests.workflow.projects import SHORT
from tests.workflow.test_snakemake import snakemake

FIGURE = '''
"""Largest depth of a cube."""

import matplotlib.pyplot as plt
import pandas as pd

from silostudy.figures.style import save


def draw(cube, stem):
    figure, axes = plt.subplots()
    axes.plot(cube["cylinder_depth"].values.ravel())
    axes.set_ylabel("depth (m)")
    save(figure, pd.DataFrame({"depth_m": cube["cylinder_depth"].values.ravel()}), stem)
'''
FIGURE_ROW = "toy_depths,Depths of the silos,figure,{stage},,,,,,silo_handbook,section 4.2\n"
KIND = '''
"""Toy studies: the volume of tanks."""

from silostudy.stages.family import Kind, Stage

KIND = Kind(
    key="toy",
    title="depths of tanks",
    model="silostudy.compute.toy:ToyStudy",
    builder="silostudy.compute.toy:toy_builder",
    stages=(Stage(key="toy", title="depths of tanks", compute="silostudy.compute.toy:toy_cube"),),
    about=("silostudy.compute.toy:about",),
)
'''
CODE = '''
"""The model, the scenes and the cube of toy studies."""

from typing import Literal

import numpy as np

from silostudy.compute.axes import sweep_of
from silostudy.config.fields import Strict, described
from silostudy.config.study import BaseStudy
from silostudy.cube.assemble import assemble


class Tank(Strict):
    depth_m: float = described("depth", "m", gt=0)


class ToyStudy(BaseStudy):
    kind: Literal["toy"] = described("toy: depths of tanks", "")
    scene: Tank = described("one tank", "")


def toy_builder(study, folder, where):
    return lambda config, settings: config.depth_m


def about(expansion):
    return [f"deepest {max(case.scene for case in expansion.cases):g} m"]


def toy_cube(expansion):
    depths = np.array([case.scene for case in expansion.cases]).reshape(expansion.shape)
    arrays, sources = {"cylinder_depth": depths}, ["silo_handbook"]
    return assemble(expansion.study, "toy", arrays, sources=sources, sweep=sweep_of(expansion))
'''
PACKING = '''
"""Packing of discs in one upright column."""

import numpy as np

from silostudy.packing.family import Packing, PackingField


def place(*, width, count, radius):
    """x, y and radius (m) of `count` discs that stand on each other in the middle of the width."""
    return np.full(count, width / 2), radius * (1 + 2.0 * np.arange(count)), np.full(count, radius)


ROW = Packing(
    key="column",
    title="One upon the other",
    source="kiyama_fujimura_1983",
    locator="none: of a test",
    place=place,
    needs=("width", "count", "radius"),
    asks=(PackingField(name="storeys", argument="count", text="number of discs", kind=int, bounds={"ge": 1}),),
    count=lambda radius, *, count, **_: count,
)
'''
STUDY = {
    "kind": "toy",
    "title": "tanks",
    "scene": {"depth_m": 1.0},
    "sweep": [{"axis": "depth_of_tank", "values": {"depth_m": [1.0, 2.0]}}],
    "outputs": ["toy_depths"],
}


@pytest.fixture
def project(tmp_path):
    """A folder with the pipeline, a copy of the package, and the figure of these tests, a row and a file."""
    for name in ("Snakefile", "silostudy"):
        (shutil.copytree if (ROOT / name).is_dir() else shutil.copy)(ROOT / name, tmp_path / name)
    (tmp_path / "config/studies").mkdir(parents=True)
    (tmp_path / "config/config.yaml").write_text("studies: [small]\n")
    (tmp_path / "silostudy/figures/toy_depths.py").write_text(FIGURE)
    return tmp_path


def run(project, study, stage):
    """Runs the pipeline on one study, whose cube the figure is drawn from; the cube and the figure's numbers."""
    with (project / "silostudy/tables/outputs.csv").open("a") as table:
        table.write(FIGURE_ROW.format(stage=stage))
    (project / "config/studies/small.yaml").write_text(yaml.safe_dump(study))
    done = snakemake(project)
    assert done.returncode == 0, done.stderr
    results = project / "results/small"
    assert (results / "figures/toy_depths.png").stat().st_size > 1000
    return read(results / f"{stage}.nc"), pd.read_csv(results / "figures/toy_depths.csv")


@pytest.mark.long
def test_a_figure_is_one_file_and_one_row(project, study):
    _, numbers = run(project, study | {"outputs": ["toy_depths"]}, "pressure")
    assert numbers["depth_m"].tolist() == [18.0]


@pytest.mark.long
def test_a_kind_of_study_is_declared_once(project):
    (project / "silostudy/stages/toy.py").write_text(KIND)
    (project / "silostudy/compute/toy.py").write_text(CODE)
    cube, numbers = run(project, STUDY, "toy")
    assert cube["cylinder_depth"].values.tolist() == numbers["depth_m"].tolist() == [1.0, 2.0]


@pytest.mark.long
def test_a_packing_is_one_file(project):
    (project / "silostudy/packing/column.py").write_text(PACKING)
    (project / "config/scenes").mkdir()
    scene = SHORT | {"packing": {"kind": "column", "storeys": 3}, "quake": None, "record": {"snapshots_s": [0.0]}}
    (project / "config/scenes/pillar.yaml").write_text(yaml.safe_dump(scene))
    (project / "config/config.yaml").write_text("studies: []\nscenes: [pillar]\n")
    done = snakemake(project)
    assert done.returncode == 0, done.stderr
    cube = read(project / "results/dem/pillar.nc")
    assert float(cube["disc_radius"].sum()) == 3 * scene["radius_m"]
    assert cube["disc_x"].isel(snapshot=0).values.tolist() == [scene["silo"]["width_m"] / 2] * 3
