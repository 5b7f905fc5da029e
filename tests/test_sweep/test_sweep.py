"""Sweeps in parts: each case once, whatever grows or breaks; failed cases masked; merged exactly and in bounded memory."""

import json
import re

import numpy as np
import pytest

from silostudy.__main__ import main
from silostudy.choice.expand import expand_file
from silostudy.choice.promise import promises
from silostudy.cube.io import read
from silostudy.errors import BadInput
from silostudy.sweep import merge as merging
from silostudy.sweep.journal import sound
from silostudy.sweep.merge import merge
from silostudy.sweep.part import Progress, compute_part
from silostudy.sweep.plan import DONE, case_keys, grouped, planned, read_plan
from tests.test_sweep.sweeps import compute, content, make_plan, save, stand_in


@pytest.fixture
def calls(monkeypatch):
    found = []
    monkeypatch.setattr("silostudy.compute.scenes.measure", stand_in(found))
    return found


def test_every_case_is_in_one_part_and_work_is_shared_out(tmp_path):
    path = save(tmp_path, slits=[0.04 + 0.001 * k for k in range(50)], case_s=3.0, part_s=30.0)
    plan, _ = make_plan(path, tmp_path / "parts", 2)
    rows = sorted(row for rows in plan.values() for row in rows)
    assert [position for position, _ in rows] == list(range(100))
    assert {len(rows) for rows in plan.values()} == {10}
    assert plan == read_plan(tmp_path / "parts")


def test_planning_writes_nothing(tmp_path):
    planned(expand_file(save(tmp_path)), tmp_path / "parts", 2)
    assert not (tmp_path / "parts").exists()


def test_parts_of_uneven_cases_take_about_the_same():
    class Asked:
        part_s = 30.0

    costs = np.random.default_rng(1).uniform(0.1, 5.0, 400)
    sums = [sum(costs[k] for k in group) for group in grouped(range(400), costs, Asked, 2)]
    assert max(sums) - min(sums) < 2 * 5.0
    assert np.mean(sums) == pytest.approx(30.0, rel=0.05)
    assert len(list(grouped(range(4), [20.0] * 4, Asked, 2))) == 3
    assert len(list(grouped(range(4), [2.0] * 4, Asked, 2))) == 1


def test_one_plan_gives_what_any_other_gives(tmp_path, calls, monkeypatch):
    """Whatever the parts and the memory of the merge, the cube has the same bits."""
    monkeypatch.setattr("silostudy.sweep.slabs.CHUNK", 4)
    cubes = []
    for number, (asked, memory) in enumerate([({}, 1e9), ({"case_s": 60.0}, 1.0), ({"case_s": 30.0, "part_s": 90.0}, 100.0)]):
        path, folder = save(tmp_path, **asked), tmp_path / str(number)
        compute(path, folder)
        merge(path, folder, tmp_path / f"{number}.nc", memory=memory)
        cubes.append(read(tmp_path / f"{number}.nc").drop_attrs())
    assert len({len(read_plan(tmp_path / str(k))) for k in range(3)}) == 3
    for other in cubes[1:]:
        assert cubes[0].identical(other)
    assert float(cubes[0]["end_time"].sel(slit_width=0.08, wall_friction=0.176)) == 0.976


def test_a_longer_axis_computes_only_its_new_cases(tmp_path, calls):
    assert compute(save(tmp_path), tmp_path / "parts") == 6
    before = read_plan(tmp_path / "parts")
    longer = save(tmp_path, slits=[0.03, 0.04, 0.05, 0.06, 0.08], title="another title")
    calls.clear()
    assert compute(longer, tmp_path / "parts") == 4
    assert {slit for slit, _ in calls} == {0.03, 0.05}
    after = read_plan(tmp_path / "parts")
    assert {key for part in before for _, key in after[part]} == {key for rows in before.values() for _, key in rows}
    assert compute(save(tmp_path, slits=[0.05]), tmp_path / "parts") == 0
    merge(save(tmp_path, slits=[0.05]), tmp_path / "parts", tmp_path / "scenes.nc")
    assert read(tmp_path / "scenes.nc").sizes["slit_width"] == 1
    assert compute(longer, tmp_path / "parts") == 0  # a shorter axis forgot nothing


def test_changed_code_or_scene_gives_other_keys(tmp_path, monkeypatch):
    def keys(**changes):
        return set(case_keys(expand_file(save(tmp_path, **changes))))

    usual = keys()
    assert len(usual) == 6
    assert keys(title="another", outputs=[], part_s=10.0) == usual
    scene = content()["scene"]
    assert not keys(scene=scene | {"density_kg_m3": 2651}) & usual
    monkeypatch.setattr("silostudy.stages.family.stamp", lambda *places: "0" * 12)
    assert not keys() & usual


def test_a_file_of_the_user_is_part_of_the_key(tmp_path):
    (tmp_path / "shake.csv").write_text("time_s,x_m_s2,y_m_s2\n0,1,0\n")
    path = save(tmp_path, scene=content()["scene"] | {"quake": {"file": "shake.csv"}})
    before = case_keys(expand_file(path))
    (tmp_path / "shake.csv").write_text("time_s,x_m_s2,y_m_s2\n0,2,0\n")
    assert not set(case_keys(expand_file(path))) & set(before)


def test_a_study_that_changes_meanwhile_is_refused(tmp_path, calls):
    path = save(tmp_path)
    ((part,), _) = make_plan(path, tmp_path / "parts")
    with pytest.raises(BadInput, match="changed while the pipeline ran"):
        compute_part(save(tmp_path, slits=[0.05, 0.06, 0.08]), part, tmp_path / "parts", print)
    with pytest.raises(BadInput, match="is not in"):
        compute_part(path, "0-0", tmp_path / "parts", print)
    assert calls == []


def test_a_failed_case_is_masked_listed_and_tried_again(tmp_path, calls, capsys, monkeypatch):
    results = tmp_path / "sweep"
    path, folder, cube = save(tmp_path), results / "parts", results / "scenes.nc"
    compute(path, folder)
    assert merge(path, folder, cube) == (6, 1)
    found = read(cube)
    lost = found.sel(slit_width=0.06, wall_friction=0.0)
    assert str(lost["case_error"].values) == "ValueError: ran away"
    assert np.isnan(lost["end_time"])
    assert np.isnan(lost["resting_normal_force"]).all()
    assert int(found["case_outcome"].sum()) == 1
    assert int(found["end_time"].isnull().sum()) == 1
    assert main(["verdict", str(results / "scenes-failed.csv")]) == 2
    said = capsys.readouterr()
    assert "ValueError: ran away" in said.out
    assert f"silostudy retry {results}" in said.err

    calls.clear()
    assert compute(path, folder) == 0  # not tried again unasked
    assert main(["retry", str(results)]) == 0
    mended = {"end_time": np.array(1.0), "resting_normal_force": np.zeros(2)}
    monkeypatch.setattr("silostudy.compute.scenes.measure", lambda study, case: mended)
    assert compute(path, folder) == 1
    assert merge(path, folder, cube) == (6, 0)
    assert main(["verdict", str(results / "scenes-failed.csv")]) == 0


def test_a_full_disk_or_lost_memory_is_no_fault_of_the_case(tmp_path, monkeypatch):
    def full(study, case):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("silostudy.compute.scenes.measure", full)
    with pytest.raises(OSError, match="No space left"):
        compute(save(tmp_path), tmp_path / "parts")
    assert [key for path in (tmp_path / "parts").glob("*.jsonl") for key in sound(path)] == []


def test_a_damaged_record_is_computed_again_alone(tmp_path, calls):
    path, folder = save(tmp_path), tmp_path / "parts"
    compute(path, folder)
    (journal,) = folder.glob("*.jsonl")
    (folder / f"{journal.stem}{DONE}").touch()
    content = bytearray(journal.read_bytes())
    content[len(content) // 2] ^= 4
    journal.write_bytes(content)
    with pytest.raises(BadInput, match=r"1 case\(s\) have no sound record: run the same command again"):
        merge(path, folder, tmp_path / "scenes.nc")
    assert planned(expand_file(path), folder, 1)[1] == [folder / f"{journal.stem}{DONE}"]  # so that the pipeline runs the part
    calls.clear()
    assert compute(path, folder) == 1
    assert len(calls) == 1
    assert planned(expand_file(path), folder, 1)[1] == []
    merge(path, folder, tmp_path / "scenes.nc")


def test_the_cube_says_what_accuracy_its_scenes_asked_for(tmp_path, calls, monkeypatch):
    """Also where an axis sweeps it, and whatever the pieces in which the scenes are read."""
    axis = {"axis": "asked", "values": {"accuracy.wall_force": [0.1, 0.2]}}
    scene = content()["scene"] | {"march": {"limit_s": 2.0}, "accuracy": {"wall_force": 0.2}}
    scene |= {body: scene[body] | {"tangential": "spring-slider-total"} for body in ("discs", "walls")}
    path = save(tmp_path, scene=scene, axes=[axis], frictions=(0.176, 0.35))
    folder, cube = tmp_path / "parts", tmp_path / "scenes.nc"
    compute(path, folder)
    told = []
    for piece in (1000, 5):
        monkeypatch.setattr(merging, "PIECE", piece)
        merge(path, folder, cube)
        told.append({name: text for name, text in read(cube).attrs.items() if name.startswith("accuracy_")})
    chosen = [promises([choice]) for choice in expand_file(path).choices]
    assert len(chosen) == 12
    assert told[0] == told[1]
    assert told[0]["accuracy_asked"] == "wall_force 0.1; wall_force 0.2"
    for each in chosen:
        assert each["accuracy_settings"] in told[0]["accuracy_settings"]
        assert float(each["accuracy_expected"].split()[-1]) <= float(told[0]["accuracy_expected"].split()[-1]) <= 0.2
    assert told[0]["accuracy_measured"]


def test_records_that_do_not_agree_are_refused(tmp_path, monkeypatch):
    shapes = iter([2, 2, 2, 3, 2, 2])
    monkeypatch.setattr("silostudy.compute.scenes.measure",
                        lambda study, case: {"resting_normal_force": np.zeros(next(shapes))})  # fmt: skip
    path = save(tmp_path)
    compute(path, tmp_path / "parts")
    with pytest.raises(BadInput, match="do not all have it in the same shape"):
        merge(path, tmp_path / "parts", tmp_path / "scenes.nc")
    assert not (tmp_path / "scenes.nc").exists()


def test_journals_of_other_code_are_cleared_away(tmp_path, calls, monkeypatch):
    path, folder = save(tmp_path), tmp_path / "parts"
    with monkeypatch.context() as older:
        older.setattr("silostudy.stages.family.stamp", lambda *places: "0" * 12)
        compute(path, folder)
    assert compute(path, folder) == 6
    assert len(list(folder.glob("*.jsonl"))) == 2
    merge(path, folder, tmp_path / "scenes.nc")
    assert [file.stem for file in folder.glob("*.jsonl")] == list(read_plan(folder))


def test_progress_counts_all_jobs(tmp_path, calls, monkeypatch):
    monkeypatch.setattr("silostudy.sweep.part.EVERY", 0.0)
    path, folder = save(tmp_path, case_s=60.0, part_s=60.0), tmp_path / "parts"
    (first, second, *others), _ = make_plan(path, folder)
    heard = []
    compute_part(path, first, folder, heard.append)
    (folder / f"{first}{DONE}").touch()
    progress = Progress("sweep", folder, heard.append)
    progress.step()
    compute_part(path, second, folder, lambda text: None)
    progress.step()
    assert others
    assert heard[-1].startswith("sweep: 2 of 6 cases")
    assert re.search(r"[0-9] (s|min) left", heard[-1])


def test_what_is_written_has_a_readable_record(tmp_path, calls):
    compute(save(tmp_path), tmp_path / "parts")
    (journal,) = (tmp_path / "parts").glob("*.jsonl")
    records = [json.loads(record) for _, record in sound(journal)]
    assert {"case", "seconds", "numbers"} == set(records[0])
    assert merging.MEMORY > 1e6
