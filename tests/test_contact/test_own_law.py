"""A contact law of the user's own: for one scene file or sweep alone, with its own field, never a kept kernel."""

import copy
import os
import re
import subprocess
import sys

import numpy as np
import pytest
import yaml

from silostudy.choice.dem import load
from silostudy.choice.expand import expand_file
from silostudy.contact import NORMAL
from silostudy.cube.io import read
from silostudy.errors import BadInput
from silostudy.scene.scenes import files_of_scene
from silostudy.sweep.plan import case_keys
from tests.own import LAW, THEORY
from tests.test_dem.small import SMALL
from tests.test_sweep.sweeps import content

SCENE = copy.deepcopy(SMALL) | {
    "methods_from": "law.py",
    "packing": {"kind": "rows", "across": 3, "fill_height_m": 0.1, "gap_m": 4e-5},
    "silo": {"width_m": 0.07, "height_m": 0.2},
    "march": {"step_s": 1e-5, "limit_s": 0.05},
    "events": [{"when": "time", "value": 0.03, "do": "stop"}],
    "record": {"wall_force_window_s": 0.01},
}
for body in ("discs", "walls"):
    SCENE[body] |= {"normal": "stiffer", "stiffening": 2.0, "tangential": "none"}


@pytest.fixture
def saved(tmp_path):
    """Saves a scene beside the user's law, and gives its path."""

    def save(text=LAW, name="own", **changes):
        (tmp_path / "law.py").write_text(text)
        path = tmp_path / f"{name}.yaml"
        path.write_text(yaml.safe_dump(SCENE | changes))
        return path

    return save


@pytest.mark.parametrize("line", ["text = str(overlap) + 'x'", "import math", "values = [overlap] * int(c[0])"])
def test_a_law_that_kernels_cannot_hold_is_told_before_a_run(saved, line):
    path = saved(LAW.replace("    elastic = c[3] * c[0]", f"    {line}\n    elastic = c[3] * c[0]"))
    with pytest.raises(BadInput, match=r"row stiffer: law, compiled: fails for usual values: [A-Z]") as told:
        load(path)
    assert "\n" not in str(told.value)


def forces(path, kernels) -> np.ndarray:
    """Wall forces of a scene that another process runs, with the kernels kept in a folder."""
    output = path.with_suffix(".nc")
    environment = {**os.environ, "NUMBA_CACHE_DIR": str(kernels)}
    command = [sys.executable, "-m", "silostudy", "dem", str(path), str(output)]
    done = subprocess.run(command, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    cube = read(output)
    if "own_methods" in cube.attrs:
        assert "J. Doe, Notes on hard discs, 2026" in cube.attrs["references"]
    return cube["wall_normal_force_mean"].values


@pytest.mark.long
def test_a_law_is_compiled_in_and_a_changed_one_is_compiled_anew(saved, tmp_path):
    kernels = tmp_path / "kernels"
    twice = forces(saved(), kernels)
    doubled = {body: {k: v for k, v in SCENE[body].items() if k not in ("normal", "stiffening")} for body in ("discs", "walls")}
    for contact in doubled.values():
        contact["normal_stiffness_N_m2"] *= 2.0
    shipped = forces(saved(name="shipped", methods_from=None, **doubled), kernels)
    assert np.nanmax(twice) > 0
    np.testing.assert_array_equal(twice, shipped)
    np.testing.assert_array_equal(forces(saved(), kernels), twice)  # from the kept kernel
    assert np.nanmax(np.abs(forces(saved(LAW.replace("c[3]", "1.5 * c[3]")), kernels) - twice)) > 0


def test_it_joins_for_its_scene_alone_and_brings_its_field(saved):
    scene, _ = load(saved())
    assert scene.discs.laws["normal"].title == "A stiffer spring"
    assert "stiffer" not in NORMAL
    assert files_of_scene(saved())[-1].name == "law.py"
    with pytest.raises(BadInput, match=r"discs\.normal = 'stiffer': unknown; known: spring-dashpot"):
        load(saved(methods_from=None))
    with pytest.raises(BadInput, match=r"stiffening = -1\.0: must be greater than 0"):
        load(saved(discs=SCENE["discs"] | {"stiffening": -1.0}))


def test_a_sweep_takes_it_and_a_changed_law_computes_its_cases_anew(tmp_path):
    scene = content()["scene"]
    scene |= {"methods_from": "law.py", "discs": scene["discs"] | {"normal": "stiffer"}}
    path = tmp_path / "sweep.yaml"
    path.write_text(yaml.safe_dump(content(scene=scene)))
    (tmp_path / "law.py").write_text(LAW)
    before = expand_file(path)
    assert before.cases[0].scene.config.discs.laws["normal"].key == "stiffer"
    assert tmp_path / "law.py" in before.files
    keys = case_keys(before)
    assert case_keys(expand_file(path)) == keys
    (tmp_path / "law.py").write_text(LAW + "# changed\n")
    assert not set(keys) & set(case_keys(expand_file(path)))


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ('key="stiffer"', 'key="line-contact"', "row line-contact: this key is already taken by another normal law"),
        ("(N/m) of a spring stiffer", "of a spring stiffer", r"law: its docstring must name its unit, \(N/m\)"),
        ('unit="1"', 'unit=""', r"coefficient stiffening: has no unit"),
        ('text="times as stiff"', 'text=""', "coefficient stiffening: needs a field of its own and a text"),
        ("@register_jitable\ndef law", "def law", "law: must be decorated with numba's register_jitable"),
        ("return elastic, (total", "return (total", "law: fails for usual values: TypeError"),
        ("closing, touch, c)", "closing, c)", "law: fails for usual values: TypeError: law"),
    ],
)
def test_a_mistake_is_one_line_with_file_and_row(saved, old, new, expected):
    assert old in LAW
    path = saved(LAW.replace(old, new))
    with pytest.raises(BadInput) as caught:
        load(path)
    assert re.search(rf"^{re.escape(str(path))}: methods_from = 'law.py': row [a-z-]+: .*", str(caught.value))
    assert re.search(expected, str(caught.value))
    assert "\n" not in str(caught.value)


def test_a_file_without_a_law_is_of_no_use_to_a_scene(saved):
    with pytest.raises(BadInput, match=r"methods_from = 'law\.py': holds no normal law and no tangential law"):
        load(saved(THEORY))
