"""The chapters of the note on silo, solid and loads, from the cube of pressures."""

from dataclasses import dataclass, field, replace

import numpy as np
import xarray as xr

from silostudy.cube.contract import SCOPE
from silostudy.cube.silence import silences
from silostudy.note import drawing
from silostudy.note.lines import Scope, Written, every_line, write
from silostudy.note.mathml import rounded
from silostudy.note.sources import short
from silostudy.tables.solids import SOLIDS
from silostudy.tables.walls import WALLS

DEPTHS = ("depth", "relative_depth")
OVER_DEPTH = (
    ("wall_normal_pressure", "p_h", "kPa"),
    ("wall_friction_traction", "p_w", "kPa"),
    ("vertical_pressure", "p_v", "kPa"),
    ("axial_wall_force", "n_z", "kN/m"),
)
LEVELS = 13  # rows of a table over depth


@dataclass(frozen=True)
class Block:
    """A part of a chapter: lines, or a table, or a drawing (SVG), or a paragraph, each under a heading of its own."""

    heading: str = ""
    lines: tuple[Written, ...] = ()
    head: tuple[str, ...] = ()
    rows: tuple[tuple[str, ...], ...] = ()
    drawing: str = ""
    texts: tuple[str, ...] = ()
    strong: tuple[int, ...] = ()  # rows that matter most
    items: tuple[str, ...] = ()
    wordy: bool = False  # a table of words rather than numbers


@dataclass(frozen=True)
class Chapter:
    """A numbered chapter of the note."""

    title: str
    blocks: list[Block] = field(default_factory=list)


def method_of(cube: xr.Dataset) -> str:
    """The method that a note follows: the first of the study with lines of its own, else its first."""
    owned = {owner for line in every_line() for owner in line.owner}
    keys = [str(key) for key in cube["pressure_method"].values]
    return next((key for key in keys if key in owned), keys[0])


def phase(cube: xr.Dataset, key: str) -> xr.Dataset | None:
    """The part of a cube in a phase; None where the study has not asked for it."""
    return cube.sel(phase=key) if key in cube["phase"].values else None


def foot(cube: xr.Dataset) -> xr.Dataset:
    """The part of a cube at its lowest depth."""
    return cube.isel({dim: -1 for dim in DEPTHS if dim in cube.dims})


def flags(cube: xr.Dataset) -> dict[str, float]:
    """Numbers for the conditions of lines: kind of plan and of characteristic values."""
    plan = str(cube["given_plan"].values)
    deepest, transition = float(foot(cube)["depth"]), float(cube["cylinder_depth"])
    return {
        "circular": plan == "circular",
        "cone": plan in ("circular", "square"),
        "slot": plan == "slot",
        "capped": float(cube["given_friction_capped"]),
        "share": float(cube["given_contact_share"]),
        "dynamic": float(cube["given_dynamic_bottom"]),
        "reaches": abs(deepest - transition) < 1e-9 * transition,
    }


def chapters(cube: xr.Dataset, method: str, checks: xr.Dataset | None) -> tuple[list[Chapter], Scope]:
    """Chapters on silo, solid and pressures, and the scope that knows all their names; cube: a silo by a method, all phases."""
    first = cube.isel(phase=0)
    scope = Scope(()).reading(foot(first), **flags(cube))
    sizes = tuple(write("silo", scope, method))
    return [
        Chapter("Silo", [Block(drawing=drawing.picture(cube, checks)), Block("Sizes", sizes)]),
        Chapter("Stored solid and walls", _solid(first, scope, method)),
        Chapter("Pressures on the vertical wall", _wall(cube, scope, method)),
        Chapter("Bottom and hopper", _hopper(cube, scope, method)),
    ], scope


def _solid(first: xr.Dataset, scope: Scope, method: str) -> list[Block]:
    lines = [replace(line, origin=_origin(first, line.line.variable)) for line in write("solid", scope, method)]
    blocks = [Block("Properties as handed to the method", tuple(lines))]
    if classed := write("class", scope, method):
        blocks.append(Block("Classes", tuple(classed)))
    if sets := write("sets", scope, method):
        blocks.append(Block("Characteristic values", tuple(sets)))
    return blocks


def _origin(first: xr.Dataset, name: str) -> str:
    """Origin of a property, in words, with the source of its row."""
    if name not in first["solid_property"].values:
        return ""
    flags = first["property_origin"].sel(solid_property=name)
    return ORIGINS.get(word := flags.attrs["flag_meanings"].split()[int(flags)], lambda _: word.replace("_", " "))(first)


def _of_solid(first: xr.Dataset) -> str:
    key = str(first["given_solid"].values)
    return f"{key}: {_place(SOLIDS[key])}" if key in SOLIDS else f"{key}: the study's own table"


def _of_wall(name: str):
    def told(first: xr.Dataset) -> str:
        row = WALLS[str(first[name].values)]
        return f"{row.key}, {row.title}: {_place(row)}"

    return told


def _place(row) -> str:
    return f"{short(row.source)}, {row.locator}"


ORIGINS = {
    "solid_table": _of_solid,
    "kind_of_wall": _of_wall("given_wall"),
    "kind_of_hopper_wall": _of_wall("given_hopper_wall"),
}


def _wall(cube: xr.Dataset, scope: Scope, method: str) -> list[Block]:
    blocks = []
    for key in ("filling", "discharge"):
        here = phase(cube, key)
        if here is None or here["wall_normal_pressure"].isnull().all():
            continue
        lines = write(key, knowing(scope, foot(here)), method)
        blocks.append(Block("After filling, at the foot of the wall" if key == "filling" else "In discharge", tuple(lines)))
        patch = write(f"patch {key}", knowing(scope, foot(here)), method)
        if patch:
            blocks.append(Block(f"Patch load, {key}", tuple(patch)))
        elif "patch_pressure" in here:
            flags = here["patch_pressure" + SCOPE]
            why = flags.attrs["flag_meanings"].split()[int(flags)].replace("_", " ")
            blocks.append(Block(f"Patch load, {key}", texts=(f"Not computed, and in no combination: {why}.",)))
    blocks.append(_over_depth(cube))
    told = silences(cube.expand_dims("pressure_method") if "pressure_method" not in cube.dims else cube)
    return [*blocks, *([Block(texts=tuple(told))] if told else [])]


def knowing(scope: Scope, *cubes: xr.Dataset) -> Scope:
    """The same scope of names, read elsewhere: what is learnt there stays known."""
    return Scope(cubes, scope.known)


def _over_depth(cube: xr.Dataset) -> Block:
    dim = next(dim for dim in DEPTHS if dim in cube["wall_normal_pressure"].dims)
    places = np.unique(np.linspace(0, cube.sizes[dim] - 1, LEVELS).round().astype(int))
    columns = [
        (f"{symbol}{'f' if key == 'filling' else 'e'} ({unit})", cube[name].sel(phase=key))
        for key in ("filling", "discharge")
        if key in cube["phase"].values
        for name, symbol, unit in OVER_DEPTH
        if not cube[name].sel(phase=key).isnull().all()
    ]
    if not columns:
        return Block("Over depth", texts=("Nothing is computed on this wall.",))
    rows = [
        (rounded(float(cube["depth"][place])), *(rounded(float(values[place]) / 1e3) for _, values in columns))
        for place in places
    ]
    head = ("z (m)", *(label for label, _ in columns))
    return Block("Over depth: f after filling, e in discharge", head=head, rows=tuple(rows))


def _hopper(cube: xr.Dataset, scope: Scope, method: str) -> list[Block]:
    blocks: list[Block] = []
    first = phase(cube, "filling")
    if first is not None and (lines := write("bottom", knowing(scope, foot(first)), method)):
        blocks.append(Block("Load on hopper or bottom", tuple(lines)))
    if "hopper_position" not in cube.dims:
        return [*blocks, Block(texts=("No hopper, or the study gives no hopper_position: nothing is computed on its wall.",))]
    middle = cube.sizes["hopper_position"] // 2
    for key in ("filling", "discharge"):
        here = phase(cube, key)
        if here is None or here["hopper_normal_pressure"].isnull().all():
            continue
        lines = write(f"hopper {key}", knowing(scope, foot(here).isel(hopper_position=middle)), method)
        blocks.append(Block(f"Hopper, {key}", tuple(lines)))
        blocks.append(_over_hopper(here, key))
    drawn = not cube["hopper_normal_pressure"].isnull().all()
    return [*blocks, *([Block("Over the hopper", drawing=drawing.hopper(cube))] if drawn else [])]


def _over_hopper(here: xr.Dataset, key: str) -> Block:
    places = np.unique(np.linspace(0, here.sizes["hopper_position"] - 1, 9).round().astype(int))
    names = ("hopper_place_height", "hopper_vertical_pressure", "hopper_normal_pressure", "hopper_friction_traction")
    rows = []
    for place in places:
        level = here.isel(hopper_position=place)
        rows.append(tuple(rounded(float(level[name]) / (1.0 if name == names[0] else 1e3)) for name in names))
    return Block(f"Over the hopper, {key}", head=("x (m)", "p_v (kPa)", "p_n (kPa)", "p_t (kPa)"), rows=tuple(rows))
