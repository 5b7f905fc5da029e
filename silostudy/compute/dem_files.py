"""Files that a discrete-element scene names: the discs of an earlier run or another program, and the shaking of the box."""

from pathlib import Path

import numpy as np

from silostudy.config.dem import DemScene
from silostudy.config.grain_scenes import AnyScene
from silostudy.cube.netcdf import opened
from silostudy.errors import BadInput, within
from silostudy.packing import PACKINGS
from silostudy.packing.filling import FILLINGS
from silostudy.packing.given import place
from silostudy.tables.columns import equal_steps, read_columns

QUAKE = ("time_s", "x_m_s2", "y_m_s2", "z_m_s2")  # the last of spheres alone
KIND = "grain_kind"
STRONGEST = 1e6  # m s-2: beyond, no acceleration
GIVEN = ("disc_x", "disc_y", "disc_radius")
GIVEN_SPHERES = ("grain_x", "grain_y", "grain_z", "grain_radius")
RATES = ("disc_u", "disc_v", "disc_spin", "grain_u", "grain_v", "grain_w", "grain_spin_x", "grain_spin_y", "grain_spin_z")


def given_discs(file: str, folder: Path) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Places x, y and radius (m) of the discs in a netCDF file's last snapshot; BadInput names the file and what is wrong.

    Discs that have left an earlier run have no place (NaN in all they have) and are left out.
    """
    x, y, radius = _given(file, folder, "packing.file", GIVEN, "disc")
    return place(x=x, y=y, radius=radius)


def given_spheres(file: str, folder: Path, kinds: int = 1) -> tuple[np.ndarray, np.ndarray, np.ndarray | None]:
    """Places (n, 3), radii (m) and kinds of the spheres in a netCDF file, those of its last snapshot, as of discs.

    Kinds are counted from 0 as the scene names them; None where it has one.
    """
    *places, radius = _given(file, folder, "filling.file", GIVEN_SPHERES, "sphere")
    return np.column_stack(places), radius, _kinds(file, folder, kinds) if kinds > 1 else None


def rates_left(scene: AnyScene, folder: Path) -> list[str]:
    """A caution where the file of a given start holds motion: it is left there, and bodies start at rest."""
    start, known = (scene.packing, PACKINGS) if isinstance(scene, DemScene) else (scene.filling, FILLINGS)
    if scene.start_from or not known[start.kind].from_file:
        return []
    held = opened(folder / start.file, "file")
    moving = [
        name for name in RATES if name in held and held[name].dtype.kind in "fiu" and np.nan_to_num(_last(held[name])).any()
    ]
    told = f"{start.file}: its {', '.join(moving)} are left: all start at rest; start_from goes on with a run's motion"
    return [f"note: {told}"] if moving else []


def _kinds(file: str, folder: Path, kinds: int) -> np.ndarray:
    """Kinds of those spheres in a file that have a place; BadInput for kinds that the scene does not have."""
    held, key = opened(folder / file, "filling.file"), "filling.file"
    if KIND not in held:
        raise BadInput(key, file, f"must hold {KIND}: the scene has {kinds} kinds of spheres")
    numbers = held[KIND].to_numpy()[~np.isnan(_metres(held[GIVEN_SPHERES[0]], file, key))]
    if not np.isin(numbers, np.arange(kinds)).all():
        raise BadInput(key, file, f"{KIND} must be from 0 to {kinds - 1}, as the scene counts its kinds")
    return numbers.astype(int)


def _given(file: str, folder: Path, key: str, names: tuple[str, ...], body: str) -> list[np.ndarray]:
    """The named places (m) of bodies in a file and, as the last of them, their radii."""
    held = opened(folder / file, key)
    missing = [name for name in names if name not in held]
    if missing:
        raise BadInput(key, file, f"must hold {', '.join(names)}; {', '.join(missing)} is missing")
    *places, radius = (_metres(held[name], file, key) for name in names)
    radius = np.full_like(places[0], radius) if radius.ndim == 0 else radius
    shapes = [column.shape for column in (*places, radius)]
    if len(set(shapes)) > 1 or places[0].ndim != 1:
        ways = ", ".join(name.rpartition("_")[2] for name in names[:-1])
        raise BadInput(key, file, f"must have an {ways} and radius a {body}, not {', '.join(map(str, shapes))}")
    left = ~np.isnan(places).all(axis=0)
    columns = [column[left] for column in (*places, radius)]
    wrong = np.flatnonzero(~(np.isfinite(columns).all(axis=0) & (columns[-1] > 0)))
    if len(wrong) or not len(columns[0]):
        first = np.flatnonzero(left)[wrong[0]] if len(wrong) else None
        told = f"holds no {body}" if first is None else f"{body} {first} must have finite places and a positive finite radius"
        raise BadInput(key, file, told)
    return columns


def _metres(variable, file: str, key: str) -> np.ndarray:
    """The values of a length, of the last snapshot where there are several."""
    unit = variable.attrs.get("units", "m")
    if unit not in ("m", "metre", "meter", "metres", "meters"):
        raise BadInput(key, file, f"{variable.name} must be in m, and the file says {unit}")
    if variable.dtype.kind not in "fiu":
        raise BadInput(key, file, f"{variable.name} must hold numbers, not {variable.dtype}")
    return _last(variable)


def _last(variable) -> np.ndarray:
    """The values of a variable, of the last snapshot where there are several."""
    last = {"snapshot": -1} if variable.sizes.get("snapshot") else {}
    return variable.isel(last).to_numpy().astype(float)


def quake_steps(file: str, folder: Path, *, dt: float, limit: float, ways: int = 2) -> np.ndarray:
    """Acceleration (steps, ways; m s-2) of the box at every step, the last way up, between the points of its record; none
    beyond its ends.  ways: of space, two of discs, three of spheres."""
    path, names = folder / file, QUAKE[: 1 + ways]
    with within(keys={"file": "quake.file"}):
        columns = read_columns(path, names)
    if sorted(columns.head) != sorted(names):
        raise BadInput("quake.file", file, f"must begin with the names of its columns, {', '.join(names)}", str(path))
    places = [columns.head.index(name) for name in names]
    start, step = equal_steps(columns, places[0])
    shaken = [columns.column(name, place) for name, place in zip(names[1:], places[1:], strict=True)]
    strongest = float(max(np.abs(way).max() for way in shaken))
    if strongest > STRONGEST:
        raise BadInput("quake.file", strongest, f"must be at most {STRONGEST:g} m/s2", str(path))
    if start > limit:
        raise BadInput("quake.file", start, f"must begin before the run ends, at {limit:g} s", str(path))
    time = start + step * np.arange(len(columns.cells))
    steps = np.arange(int(max(min(time[-1], limit), 0.0) / dt) + 2) * dt
    return np.column_stack([np.interp(steps, time, way, left=0.0, right=0.0) for way in shaken])
