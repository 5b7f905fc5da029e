"""No file, however broken, shows as more than one line that names it; what is read all the same holds finite numbers."""

from pathlib import Path

import numpy as np
import obspy
import pytest
import xarray as xr
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from silostudy.compute.checkpoints import resume, save
from silostudy.compute.dem import run_of, scene_model
from silostudy.compute.dem_files import given_discs, quake_steps
from silostudy.config.load import read_study
from silostudy.cube.io import read, write
from silostudy.errors import BadInput
from silostudy.seismic.readers import read_record
from silostudy.tables.solids import own_solids
from tests.conftest import ROOT
from tests.test_dem.small import scene_of
from tests.test_readers.mutations import mutated
from tests.test_readers.test_columns import QUAKE
from tests.test_readers.test_units_and_headers import HEADER, SAMPLES
from tests.test_seismic.test_records import AT2, COLUMNS

COUNTS = SAMPLES.split()[4:104]  # the first second
PEAK = 2000 / 8388608 * np.abs(np.array(COUNTS, float) - np.mean(np.array(COUNTS, float))).max()  # gal
KNET = HEADER.replace("Time(s)  59", "Time(s)  1").replace("4.383", f"{PEAK:.3f}") + "Memo.\n" + "\n".join(COUNTS)
SOLIDS = """# a user's own
solid,title,grain,unit_weight_kN_m3,internal_friction_angle_deg,wall_friction,lateral_pressure_ratio,source,locator
sand,Dry sand,coarse_grain,15.5,35.0,0.4,0.45,own shear tests 2025,table 1
meal,"Meal, fine",powder,6.5,41,,,own shear tests 2025,table 2
"""
DISCS = {"disc_x": ("disc", [0.1, 0.2, 0.3]), "disc_y": ("disc", [0.1, 0.1, 0.1]), "disc_radius": ("disc", [0.02, 0.02, 0.02])}


def of_obspy(folder: Path) -> list[bytes]:
    trace = obspy.Trace(np.array([1.0, 2.0, -4.0, 3.0], dtype="float32"), {"delta": 0.01, "station": "AAA", "channel": "HNE"})
    forms = {
        "MSEED": {},
        "SAC": {},
        "SLIST": {},
        "TSPAIR": {},
        "SACXY": {},
        "AH": {},
        "SH_ASC": {},
        "SEGY": {"data_encoding": 5},
    }
    found = [KNET.encode()]
    for form, more in forms.items():
        trace.write(str(folder / form), format=form, **more)
        found.append((folder / form).read_bytes())
    trace.data = np.arange(50, dtype="int32")
    trace.write(str(folder / "GSE2"), format="GSE2")
    return [*found, (folder / "GSE2").read_bytes()]


def of_netcdf(folder: Path) -> list[bytes]:
    for form in ("NETCDF4", "NETCDF3_CLASSIC"):
        xr.Dataset(DISCS, attrs={"title": "discs"}).to_netcdf(folder / form, format=form)
    xr.Dataset({"other": ("a", [1, 2, 3]), "text": ("b", ["x", "y"])}).to_netcdf(folder / "other", format="NETCDF4")
    return [(folder / name).read_bytes() for name in ("NETCDF4", "NETCDF3_CLASSIC", "other")]


def of_cube(folder: Path, wheat: xr.Dataset) -> list[bytes]:
    write(wheat.isel(pressure_method=slice(2), depth=slice(4)), folder / "cube.nc")
    return [(folder / "cube.nc").read_bytes()]


def finite(*arrays) -> None:
    assert all(np.isfinite(array).all() and np.size(array) for array in arrays)


def shaken(form: str, unit: str | None):
    def call(path: Path) -> None:
        record = read_record(path, form, unit)
        finite(record.acceleration, record.dt)
        assert record.dt > 0

    return call


READERS = {
    "two columns": shaken("two_columns", "gal"),
    "peer at2": shaken("peer_at2", None),
    "obspy": shaken("obspy", "gal"),
    "quake": lambda path: finite(quake_steps(path.name, path.parent, dt=0.001, limit=1.0)),
    "given discs": lambda path: finite(*given_discs(path.name, path.parent)),
    "materials": own_solids,
    "cube": read,
    "study": read_study,
}


@pytest.fixture(scope="module")
def seeds(tmp_path_factory, wheat) -> dict[str, list[bytes]]:
    """Whole files, by reader."""
    folder = tmp_path_factory.mktemp("seeds")
    return {
        "two columns": [
            COLUMNS.encode(),
            ("time_s,acceleration_gal\n" + "".join(f"{n / 128:.3f},{n}\n" for n in range(9))).encode(),
        ],
        "peer at2": [AT2.encode()],
        "obspy": of_obspy(folder),
        "quake": [QUAKE.encode()],
        "given discs": of_netcdf(folder),
        "materials": [SOLIDS.encode()],
        "cube": of_cube(folder, wheat),
        "study": [(ROOT / f"config/studies/{name}.yaml").read_bytes() for name in ("wheat-silo", "steel-wheat-shaken")]
        + [b"kind: pressure\ntitle: 2001-13-45\n", b"kind: !!bool x\n", b"kind: !!timestamp x\n", b"? [a]\n: b\n"],
    }


def fuzz(name: str, seeds: list[bytes], path: Path, examples: int) -> None:
    """Reads mutated files; whatever is refused is refused by BadInput, in one line a mistake, with the file's name."""

    @settings(
        max_examples=examples,
        deadline=None,
        database=None,
        suppress_health_check=list(HealthCheck),
    )
    @given(content=mutated(seeds))
    def check(content: bytes) -> None:
        path.unlink(missing_ok=True)  # HDF5 may hold the last one open, and knows files by their place on the disk
        path.write_bytes(content)
        try:
            READERS[name](path)
        except BadInput as error:
            lines = getattr(error, "lines", [str(error)])
            assert all("\n" not in line and path.stem in line for line in lines), lines

    check()


@pytest.mark.parametrize("name", READERS)
def test_whole_files_are_read(name, seeds, tmp_path):
    path = tmp_path / "file.dat"
    path.write_bytes(seeds[name][0])
    READERS[name](path)


@pytest.mark.parametrize("name", READERS)
@pytest.mark.filterwarnings("ignore")
def test_mutated_files(name, seeds, tmp_path):
    fuzz(name, seeds[name], tmp_path / "file.dat", 200)


@pytest.mark.long
@pytest.mark.parametrize("name", READERS)
@pytest.mark.filterwarnings("ignore")
def test_many_mutated_files(name, seeds, tmp_path):
    fuzz(name, seeds[name], tmp_path / "file.dat", 3000)


@pytest.mark.parametrize("name", READERS)
def test_things_that_are_no_file(name, tmp_path):
    for path in (tmp_path, tmp_path / "nothing.dat", tmp_path / "nul\0.dat", tmp_path / "link.dat"):
        (tmp_path / "link.dat").unlink(missing_ok=True)
        (tmp_path / "link.dat").symlink_to("link.dat")  # to itself
        with pytest.raises(BadInput) as caught:
            READERS[name](path)
        assert "\n" not in str(caught.value)


@pytest.fixture(scope="module")
def begun(tmp_path_factory):
    """A scene, a run of it that has not begun, and the checkpoint of one that has."""
    scene, path = scene_of(record__checkpoint_every_s=0.03), tmp_path_factory.mktemp("run") / "run.checkpoint"
    run = run_of(scene, scene_model(scene, Path()))
    run.go(until=400)
    save(run, scene, path)
    return scene, run_of(scene, scene_model(scene, Path())), path.read_bytes()


def checkpoints(begun, tmp_path: Path, examples: int) -> None:
    scene, fresh, whole = begun
    path = tmp_path / "run.checkpoint"

    @settings(max_examples=examples, deadline=None, database=None, suppress_health_check=list(HealthCheck))
    @given(content=mutated([whole]).filter(lambda content: content != whole), kept=st.booleans())
    def check(content: bytes, kept: bool) -> None:
        path.write_bytes(content)
        resume(fresh, scene, path)
        assert fresh.engine.step == 0
        assert not path.exists()
        assert path.with_name("run.checkpoint.old").read_bytes() == content

    check()


def test_broken_checkpoints_are_set_aside(begun, tmp_path, capsys):
    checkpoints(begun, tmp_path, 200)
    assert (
        "run.checkpoint cannot be read (ValueError): the run starts anew; kept as run.checkpoint.old" in capsys.readouterr().err
    )


@pytest.mark.long
def test_many_broken_checkpoints(begun, tmp_path):
    checkpoints(begun, tmp_path, 3000)
