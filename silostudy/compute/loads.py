"""The stage of the loads: the field of each load case on wall and hopper, for finite elements, and what it sums to."""

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np
import xarray as xr

from silostudy.choice.expand import Resolved, expand_file
from silostudy.compute.axes import stacked, sweep_of
from silostudy.compute.evaluate import masked, sources_of
from silostudy.compute.hopper import heights
from silostudy.compute.listed_cases import listed_variables
from silostudy.compute.load_cases import COMPUTED, Listed, load_cases
from silostudy.config.pressure import FIELD_METHODS, MOST_SILOS, Loads
from silostudy.cube.assemble import assemble
from silostudy.cube.load import Load, Piece
from silostudy.errors import BadInput
from silostudy.pressure import PRESSURE
from silostudy.pressure.calls import call
from silostudy.pressure.en1991_4 import on_wall
from silostudy.pressure.family import CHANNEL_SIZES, PressureMethod
from silostudy.scene.scene import Scene, parameters_of_scenes
from silostudy.tables.load_cases import LOAD_CASES

SETS = ("wall_normal", "wall_friction", "vertical_load")
PIECES = ("wall", "patch", "channel", "adjacent", "static", "hopper")
ON_WALL = ("wall_normal_pressure", "wall_friction_traction")
ZONES = ("channel", "adjacent", "static")
ALONE = "wall_normal"  # set of the solid at rest beside a channel
WITH_HOPPER = ("circular", "square")  # plans whose hopper has the same pressure all round
ROUND = np.pi


def loads_cube(expansion: Resolved) -> xr.Dataset:
    """The cube of the loads: every load case of each silo with its state, its field in pieces, its forces."""
    study = expansion.study
    silos = [_of_silo(study, case.scene) for case in expansion.cases]
    data: dict = stacked(silos, expansion.shape)
    labels: dict = {
        "load_case_title": [row.title for row in LOAD_CASES.values()],
        "value_set": list(SETS),
        "load_piece": list(PIECES),
        "load_level": np.linspace(0.0, 1.0, study.loads.levels),
    }
    data = {**labels, **data, **listed_variables(expansion)}
    sources = [*sources_of(expansion), *(row.source for row in LOAD_CASES.values())]
    return assemble(study, "loads", data, sources=sources, notes={**expansion.promise}, sweep=sweep_of(expansion))


def with_loads(path: Path) -> Resolved:
    """The cases of a study file, with the loads at their usual levels where it asks for none; BadInput of other kinds."""
    expansion = expand_file(path)
    if not hasattr(expansion.study, "loads"):
        raise BadInput("kind", expansion.study.kind, "has no loads on walls: a pressure or shell study has", str(path))
    if len(expansion.cases) > MOST_SILOS:
        raise BadInput("sweep", f"{len(expansion.cases)} silos", f"loads are for {MOST_SILOS} silos at most", str(path))
    if not expansion.study.loaded_by:
        raise BadInput(
            "methods", list(expansion.study.method_keys), f"load cases need one of {', '.join(FIELD_METHODS)}", str(path)
        )
    if expansion.study.loads is not None:
        return expansion
    return replace(expansion, study=expansion.study.model_copy(update={"loads": Loads()}))


def _of_silo(study, scene: Scene) -> dict:
    """Everything of one silo: (load case[, set[, piece[, level]]])."""
    listed = load_cases(study, scene)
    shape, levels = (len(listed), len(SETS)), study.loads.levels
    sizes = {"depth": levels, "normal_pressure": levels, "friction_traction": levels}
    arrays: dict = {f"load_{name}": np.full((*shape, len(PIECES), size), np.nan) for name, size in sizes.items()}
    arrays |= {f"load_{name}": np.full((*shape, len(PIECES)), np.nan) for name in ("angle_from", "angle_to", "waves")}
    arrays |= {f"load_{name}": np.full(shape, np.nan) for name in FORCES}
    for place, case in enumerate(listed):
        for number, values in enumerate(SETS):
            if load := _load(case, values, study, scene):
                _written(arrays, (place, number), load)
    silo, hopper = scene.silo, scene.silo.hopper
    arrays |= {"load_radius": silo.diameter / 2, "load_perimeter": silo.perimeter, "load_transition_depth": silo.cylinder_depth}
    arrays |= {"load_half_angle": hopper.half_angle if hopper else np.nan}
    arrays["load_weight"] = scene.silo.volume * _given(scene)["unit_weight"][0, 0]
    return arrays


FORCES = {
    "wall_force": lambda load: load.vertical_force(hopper=False),
    "hopper_force": lambda load: load.vertical_force(hopper=True),
    "bottom_force": lambda load: load.bottom_force,
    "horizontal_force": Load.horizontal_force,
    "overturning_moment": Load.overturning_moment,
    "imbalance": lambda load: _sum(load) / load.weight - 1,
}


def _sum(load: Load) -> float:
    return load.vertical_force(hopper=False) + load.vertical_force(hopper=True) + load.bottom_force


def _written(arrays: Mapping[str, np.ndarray], position: tuple[int, int], load: Load) -> None:
    for piece in load.pieces:
        here = (*position, PIECES.index(piece.name))
        for name, values in (("depth", piece.depth), ("normal_pressure", piece.normal), ("friction_traction", piece.traction)):
            arrays[f"load_{name}"][here] = values
        for name in ("angle_from", "angle_to", "waves"):
            arrays[f"load_{name}"][here] = getattr(piece, name)
    for name, force in FORCES.items():
        arrays[f"load_{name}"][position] = force(load)


def _given(scene: Scene) -> dict:
    """The parameters that the code's own method is handed."""
    return parameters_of_scenes([scene], _usual_method())


def _usual_method() -> PressureMethod:
    """The code's own method: that of the first load case."""
    return PRESSURE[next(iter(LOAD_CASES.values())).methods[0]]


def _load(case: Listed, values: str, study, scene: Scene) -> Load | None:
    """The field of a load case of the contents with one set; None where the case has none, or is not computed."""
    build = FIELDS.get(case.row.field)
    if build is None or case.state != COMPUTED or (build is _channels and values != ALONE):
        return None
    method = PRESSURE[case.row.methods[0]]
    given, levels = parameters_of_scenes([scene], method), study.loads.levels
    pieces = build(case, values, study, scene, given)
    bottom = _bottom(case.row.phase, values, scene)
    if build is _channels:
        bottom = bottom if scene.silo.hopper is None else np.nan  # what a hopper carries beside a channel is not known
    else:
        pieces += _hopper(case, method, given, levels, scene)
    silo, unit_weight = scene.silo, given["unit_weight"][0, 0]
    shape = {"radius": silo.diameter / 2, "perimeter": silo.perimeter, "transition": silo.cylinder_depth}
    half_angle = silo.hopper.half_angle if silo.hopper else np.nan
    weight = silo.volume * unit_weight
    return Load(case.row.title, tuple(pieces), **shape, half_angle=half_angle, weight=weight, bottom_force=bottom)


def _levels(start: float, end: float, count: int) -> np.ndarray:
    return np.linspace(start, end, count)


def _wall(case: Listed, values: str, study, scene: Scene, given: Mapping) -> list[Piece]:
    """The symmetrical pressures of a set, all round from the highest wall contact to the transition."""
    z = _levels(scene.silo.contact_depth, scene.silo.cylinder_depth, study.loads.levels)
    functions = [on_wall.on_cylinder(quantity, values, case.row.phase) for quantity in ON_WALL]
    normal, traction = (np.broadcast_to(call(function, z, given), (1, z.size))[0] for function in functions)
    return [Piece("wall", z, normal, traction, 0.0, ROUND, 0, last=True)]


def _with_patch(case: Listed, values: str, study, scene: Scene, given: Mapping) -> list[Piece]:
    """The symmetrical pressures and on them the patch: p cos(theta) on a thin circular wall, a band round another plan."""
    method = PRESSURE[case.row.methods[0]]
    of = {name: _total(method, name, case.row.phase, given) for name in ("patch_pressure", "patch_depth", "patch_height")}
    waves = 1
    if np.isnan(of["patch_pressure"]):
        waves, of["patch_pressure"] = 0, _total(method, "band_pressure", case.row.phase, given)
        of["patch_depth"] = scene.silo.cylinder_depth / 2
    half = of["patch_height"] / 2
    z = _levels(of["patch_depth"] - half, of["patch_depth"] + half, study.loads.levels)
    strip = Piece("patch", z, np.full(z.size, of["patch_pressure"]), np.zeros(z.size), 0.0, ROUND, waves, last=False)
    return [*_wall(case, values, study, scene, given), strip]


def _channels(case: Listed, values: str, study, scene: Scene, given: Mapping) -> list[Piece]:
    """Pieces of three zones of wall: in the channel, beside it, and at rest."""
    size = CHANNEL_SIZES[_channels_before(case)]
    method = next(PRESSURE[key] for key in case.row.methods if key in study.method_keys)
    given = {**given, "channel_size": np.full((1, 1), size)}
    functions = method.channel[case.row.phase]
    edge = float(np.ravel(call(functions["channel_half_width"], None, given))[0])
    ends = (0.0, edge, min(2 * edge, ROUND), ROUND)
    z = _levels(scene.silo.contact_depth, scene.silo.cylinder_depth, study.loads.levels)
    pieces = []
    for number, zone in enumerate(ZONES):
        normal, traction = (
            np.broadcast_to(call(functions[f"{zone}_{name}"], z, given), (1, z.size))[0]
            for name in ("normal_pressure", "friction_traction")
        )
        pieces.append(Piece(zone, z, normal, traction, ends[number], ends[number + 1], 0, last=True))
    return pieces


def _channels_before(case: Listed) -> int:
    """Number of channels before this one in the table: its place among the sizes."""
    return [row.key for row in LOAD_CASES.values() if row.field == case.row.field].index(case.row.key)


def _hopper(case: Listed, method: PressureMethod, given: Mapping, levels: int, scene: Scene) -> list[Piece]:
    """The pressures on the wall of a cone or a square pyramid in the phase of the case, with the hopper's own sets."""
    if scene.silo.hopper is None or scene.silo.plan not in WITH_HOPPER:
        return []
    top, bottom = (float(height[0, 0]) for height in heights(given))
    x = _levels(top, bottom, levels)
    names = ("hopper_normal_pressure", "hopper_friction_traction")
    functions = (method.hopper[case.row.phase][name] for name in names)
    normal, traction = (
        masked(method, name, case.row.phase, function, x, given)[0][0] for name, function in zip(names, functions, strict=True)
    )
    if np.isnan(normal).any():
        return []
    z = scene.silo.cylinder_depth + (top - x)
    return [Piece("hopper", z, normal, traction, 0.0, ROUND, 0, last=True, on_hopper=True)]


def _bottom(phase: str, values: str, scene: Scene) -> float:
    """Force (N) through the outlet, of a flat floor that under the vertical pressure after filling of the case's own set."""
    method, given = _usual_method(), _given(scene)
    if scene.silo.hopper is not None:
        return _total(method, "outlet_force", phase, given) if scene.silo.plan in WITH_HOPPER else np.nan
    factor = _total(method, "bottom_load_magnifier", phase, given)
    vertical = on_wall.on_cylinder("vertical_pressure", values, "filling")
    pressure = float(np.ravel(call(vertical, np.array([scene.silo.cylinder_depth]), given))[0])
    return factor * pressure * scene.silo.area


def _total(method: PressureMethod, name: str, phase: str, given: Mapping) -> float:
    """A total of a method; NaN where it is masked."""
    return float(np.ravel(masked(method, name, phase, method.totals[phase][name], None, given)[0])[0])


FIELDS = {"symmetric": _wall, "patch": _with_patch, "channel": _channels}
