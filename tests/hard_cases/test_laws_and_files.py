"""Hard cases of contact laws, packings, configuration, cubes and files."""

from math import inf, nan, pi, sqrt

import mpmath
import numpy as np
import pytest
import xarray as xr

from silostudy.config.load import read_yaml
from silostudy.contact import LAWS, NORMAL, curve
from silostudy.contact.family import Touch
from silostudy.cube.io import read, write
from silostudy.cube.provenance import provenance
from silostudy.cube.variables import attributes as of_the_contract
from silostudy.dem.events import Event
from silostudy.dem.model import Contact
from silostudy.dem.pieces import Laws
from silostudy.errors import BadInput
from silostudy.files import replacing
from silostudy.packing import PACKINGS
from tests.conftest import SMALL, expanded
from tests.test_dem.scenes import contact

STEEL = {"youngs_modulus": 2.1e11, "poissons_ratio": 0.3}


@pytest.mark.parametrize("overlap", [1e-30, 1e-18, 1e-12, 1e-9, 1e-6, 1e-4])
def test_line_contact_over_twenty_six_decades(overlap):
    """q on overlap = A q (B - ln q): against the Lambert function in fifty digits."""
    a, b = curve.curve(0.01, **STEEL)
    with mpmath.workdps(50):
        a50, b50, d50 = map(mpmath.mpf, (a, b, overlap))
        exact = float(-d50 / a50 / mpmath.lambertw(-d50 / a50 * mpmath.exp(-b50), -1))
    assert curve.load_of(overlap, a, b) == pytest.approx(exact, rel=1e-12, abs=0)
    assert curve.load_of(0.0, a, b) == curve.load_of(-overlap, a, b) == 0.0


@pytest.mark.parametrize("load", [0.0, -1.0, nan])
def test_line_contact_under_no_load(load):
    with pytest.raises(BadInput, match=r"load = .*must be positive"):
        curve.secant(0.01, load=load, **STEEL)


def test_line_contact_wider_than_its_discs():
    with pytest.raises(BadInput, match="narrower than the discs"):
        curve.secant(0.01, load=1e12, **STEEL)


@pytest.mark.parametrize("key", ["spring-dashpot", "spring-dashpot-implicit"])
def test_dashpot_that_would_pull(key):
    """Parting at any speed, a contact that may not pull gives nothing, and not minus nothing or NaN."""
    for closing in (-1e-300, -1.0, -1e300):
        elastic, total = NORMAL[key].law(1e-9, closing, Touch(1.0, 0.01, 1e-6), (1e6, 1e9, 0.0))
        assert elastic == pytest.approx(1e-3)
        assert 0.0 <= total <= elastic


def test_slider_under_no_and_under_endless_normal_force():
    c, touch = (1e6, 10.0, 0.0, 0.5), Touch(1.0, 0.01, 1e-6)
    for law in (row.law for row in LAWS["tangential"].values() if row.stores):
        assert law(3.0, 0.0, touch, 0.0, 0.0, c)[1] == 0.0
        assert law(3.0, 0.0, touch, 1e300, 1e300, c) == (3.0, 3.0)


@pytest.mark.parametrize(("name", "value"), [("normal_stiffness", 0.0), ("normal_stiffness", inf), ("sliding_friction", -0.1),
                                             ("normal_damping", nan)])  # fmt: skip
def test_coefficients_that_no_contact_has(name, value):
    with pytest.raises(BadInput, match=rf"{name} = .*must be (positive|zero or more)"):
        Contact(Laws.of(tangential="spring-slider"), contact().coefficients | {name: value})


def test_packings_at_their_smallest():
    """Two discs across that just fit; one disc of a loose packing; a spread of next to one."""
    x, y, _ = PACKINGS["rows"].place(width=0.04 + 1e-9, height=0.021, radius=0.01, across=2, gap=0.0)
    assert len(x) == 2
    assert np.diff(x)[0] >= 0.02
    x, y, radius = PACKINGS["loose"].place(width=1.0, count=1, radius=0.01)
    assert len(x) == 1
    x, y, radius = PACKINGS["loose"].place(width=1.0, count=300, radius=0.01, spread=0.999, seed=3)
    apart = np.hypot(x[:, None] - x, y[:, None] - y) - radius[:, None] - radius + np.diag(np.full(300, inf))
    assert apart.min() >= 0.0
    assert (x - radius).min() >= 0.0
    assert (x + radius).max() <= 1.0


@pytest.mark.parametrize(("packing", "changes", "message"), [
    ("rows", {"across": 1}, "across = 1: must be a whole number of discs, 2 or more"),
    ("rows", {"across": 30}, "do not fit"),
    ("rows", {"across": 4}, "fall through each other"),
    ("rows", {"offset": 1.0}, r"offset = 1\.0: must lie in 0"),
    ("loose", {"radius": 1.0}, "not one disc of this size fits"),
    ("loose", {"spread": 1.0}, r"spread = 1\.0: must lie in 0 \.\.\. 1"),
])  # fmt: skip
def test_packings_that_cannot_be(packing, changes, message):
    base = {"rows": {"width": 0.2, "height": 0.3, "radius": 0.01, "across": 9, "gap": 1e-5},
            "loose": {"width": 0.2, "count": 10, "radius": 0.01}}  # fmt: skip
    with pytest.raises(BadInput, match=message):
        PACKINGS[packing].place(**base[packing] | changes)


@pytest.mark.parametrize("value", [nan, inf, -inf])
def test_numbers_in_a_study_that_are_none(value):
    with pytest.raises(BadInput, match=r"diameter_m = (nan|inf|-inf): must be a finite number"):
        expanded(SMALL | {"scene": SMALL["scene"] | {"silo": SMALL["scene"]["silo"] | {"diameter_m": value}}})


def test_study_file_that_is_no_mapping(tmp_path):
    for text in ("", "- 1\n- 2\n", "\x00", "a: [1, 2", "just words"):
        file = tmp_path / "study.yaml"
        file.write_text(text)
        with pytest.raises(BadInput, match=r"must (be readable YAML|hold `key: value` lines)"):
            read_yaml(file)


@pytest.mark.parametrize("changes", [{"trigger": "someday"}, {"action": "explode"}])
def test_events_nobody_knows(changes):
    with pytest.raises(BadInput, match=r"unknown; known: time, after|unknown; known: open, open holes, take away, remove"):
        Event(**({"trigger": "time", "value": 0.0, "action": "stop"} | changes))


ABOUT = {**provenance("a cube", "{}", ["kiyama_fujimura_1983"], "dem"), "sweep_axes": ""}


def numbered(discs) -> dict:
    """The coordinate of some discs: their numbers."""
    return {"disc": ("disc", np.arange(len(discs)), of_the_contract("disc"))}


def test_numbers_at_the_ends_of_the_range_in_a_cube(tmp_path):
    """Sub-normal and huge numbers come back bit by bit, and NaN stays what it is: masked."""
    values = np.array([5e-324, -1e-310, 0.0, -0.0, 1e308, nan, pi, sqrt(2.0)])
    attributes = {"units": "m", "long_name": "radius of a disc"}
    cube = xr.Dataset({"disc_radius": ("disc", values, attributes)}, numbered(values), ABOUT)
    write(cube, tmp_path / "ends.nc")
    back = read(tmp_path / "ends.nc")["disc_radius"].to_numpy()
    assert back.tobytes() == values.tobytes()


def test_cube_with_a_variable_nobody_knows(tmp_path):
    with pytest.raises(BadInput, match="variable = 'colour': not in the cube's contract"):
        write(xr.Dataset({"colour": ("disc", np.ones(3))}, attrs={"sweep_axes": ""}), tmp_path / "odd.nc")
    assert not list(tmp_path.iterdir())


def test_file_that_breaks_off(tmp_path):
    """What fails half way leaves neither a half file nor a temporary one, and the old file as it was."""
    file = tmp_path / "result.txt"
    file.write_text("old")

    def fail():
        with replacing(file) as temporary:
            temporary.write_text("half of the n")
            raise RuntimeError("power cut")

    with pytest.raises(RuntimeError, match="power cut"):
        fail()
    assert [path.name for path in tmp_path.iterdir()] == ["result.txt"]
    assert file.read_text() == "old"


def test_cube_cut_off(tmp_path):
    file = tmp_path / "cut.nc"
    attributes = {"units": "m", "long_name": "radius of a disc"}
    write(xr.Dataset({"disc_radius": ("disc", np.ones(1000), attributes)}, numbered(range(1000)), ABOUT), file)
    file.write_bytes(file.read_bytes()[: file.stat().st_size // 3])
    with pytest.raises(BadInput, match="must be a netCDF file"):
        read(file)
