"""Whatever breaks a sweep, the one documented command brings the same bits, and no finished case is computed twice."""

import subprocess

import pytest

from silostudy.cube.fingerprint import fingerprint
from silostudy.cube.io import read
from silostudy.sweep.plan import read_plan
from tests.test_sweep.faults import CUBE, Breaker, ask, computed, mounted, project


@pytest.fixture
def place(tmp_path):
    """(project, results on a small file system of their own, whether it is one) with what was mounted taken away after."""
    results = tmp_path / "results"
    small = mounted(results, 16)
    yield project(tmp_path / "project"), results, small
    if small:
        subprocess.run(["umount", "-l", str(results)], check=True)


@pytest.mark.long
@pytest.mark.parametrize("faults", [6, 30])
def test_random_faults(place, tmp_path, faults, capsys):
    folder, results, small = place
    if not small:
        print("no file system may be mounted here: a full disk and read-only results are left out")
    undisturbed = Breaker(folder, tmp_path / "undisturbed", 0, tmpfs=False)
    assert undisturbed.run() == 0, (folder / "said.txt").read_text()[-3000:]
    data = fingerprint(tmp_path / "undisturbed" / CUBE)

    breaker = Breaker(folder, results, seed=faults, tmpfs=small)
    breaker.length, finished = undisturbed.length, 0
    while breaker.happened.total() < faults:
        breaker.fault()
        assert set(computed(results).values()) <= {1}  # nothing finished is computed twice
        if breaker.happened.total() % 8 == 0 or breaker.happened.total() == faults:
            assert breaker.run() == 0, (folder / "said.txt").read_text()[-3000:]
            assert fingerprint(results / CUBE) == data  # the same bits; a flipped bit of a text beside them is told and kept
            finished += 1
            for path in [*(results / "sweep").rglob("*"), *(results / "sweep").rglob(".*")]:
                if path.is_file():
                    path.unlink()  # from the start again
    with capsys.disabled():
        print(f"\n{breaker.happened.total()} faults {dict(breaker.happened)}, {finished} sweeps brought to their end")


@pytest.mark.long
def test_a_failed_case_leaves_the_others(tmp_path):
    """A step beyond stability for the stiffest walls: those cases are masked and listed, the run says so and fails."""
    stiff = {"axis": "stiffness", "values": {"walls.normal_stiffness_N_m2": [1.9e7, 1.9e12]}}
    changes = {"slits": [0.06, 0.08], "frictions": [0.1], "axes": [stiff], "case_s": None}
    folder, results = project(tmp_path / "project", **changes), tmp_path / "results"
    breaker = Breaker(folder, results, 0, tmpfs=False)
    assert breaker.run() != 0
    said = (folder / "said.txt").read_text()
    assert "failed cases = 2" in said
    assert f"silostudy retry {results}/sweep" in said
    cube = read(results / CUBE)
    assert cube["case_outcome"].sum("stiffness").values.tolist() == [[1], [1]]
    assert "stability bound" in str(cube["case_error"].isel(slit_width=0, wall_friction=0, stiffness=1).values)
    assert cube["end_time"].isel(stiffness=0).notnull().all()
    assert cube["end_time"].isel(stiffness=1).isnull().all()


def test_two_runs_at_once_are_refused(tmp_path):
    from silostudy.files import alone

    folder, results = project(tmp_path / "project"), tmp_path / "results"
    alone(results)
    assert Breaker(folder, results, 0, tmpfs=False).run() != 0
    assert "another run is writing to it" in (folder / "said.txt").read_text()


@pytest.mark.long
def test_a_longer_axis_through_the_pipeline(tmp_path):
    """Only new cases are computed, and what is done is done."""
    changes = {"slits": [0.1, 0.12], "frictions": [0.1], "case_s": None}
    folder, results = project(tmp_path / "project", **changes), tmp_path / "results"
    breaker = Breaker(folder, results, 0, tmpfs=False)
    assert breaker.run() == 0, (folder / "said.txt").read_text()[-3000:]
    (journal,) = (results / "sweep/parts").glob("*.jsonl")
    before = journal.read_bytes()
    ask(folder, **changes | {"slits": [0.1, 0.11, 0.12]})
    assert breaker.run() == 0
    assert journal.read_bytes() == before
    assert len(read_plan(results / "sweep/parts")) == 2
    assert computed(results).total() == 3
    assert read(results / CUBE)["slit_width"].values.tolist() == [0.1, 0.11, 0.12]
    (folder / "said.txt").unlink()
    assert breaker.run() == 0
    assert "Nothing to be done" in (folder / "said.txt").read_text()
