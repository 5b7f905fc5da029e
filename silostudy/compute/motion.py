"""The motion stage: the ideal packings at rest contact by contact, and single runs frame by frame, in one cube."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
import xarray as xr

from silostudy.compute.packing import SOURCES
from silostudy.compute.packing_measure import MEAN, cells_of
from silostudy.compute.packing_run import SAMPLE, WINDOW, discharge, settle
from silostudy.cube.assemble import assemble
from silostudy.dem.snapshot import snapshot
from silostudy.errors import BadInput
from silostudy.scene.expand import Expansion

Frame = dict[str, np.ndarray]
SIDE_WALLS = ("left", "right")  # in the order of packing_measure.cells_of


@dataclass
class RunFrames:
    """Frames of one run of one case; forces on the side walls' cells by frame: (frames, 2 walls, cells, 2 ways)."""

    case: str
    across: int
    run: int
    remedy: bool
    frames: list[Frame]
    sides: np.ndarray
    removed: bool


def motion_cube(expansion: Expansion, tell: Callable[[str], None] = lambda text: None) -> xr.Dataset:
    """The cube of the detailed runs of a packing study, and of every case's ideal packing at rest."""
    known = {case.scene.config.across for case in expansion.cases}
    for detail in expansion.study.detailed:
        if detail.across not in known or detail.run > expansion.study.runs:
            allowed = f"across must be one of {sorted(known)}, run at most {expansion.study.runs}"
            raise BadInput("detailed", detail.model_dump(), allowed, expansion.name)
    films = [_at_rest(expansion.study, case) for case in expansion.cases if not case.scene.config.remedy]
    for case in expansion.cases:
        for detail in expansion.study.detailed:
            if case.scene.config.across == detail.across:
                film = _filmed(expansion.study, case, detail.run)
                films += [film] if film.removed or not film.remedy else []  # a remedy never needed shows nothing new
                tell(f"{detail.across - 1}/{detail.across}, run {detail.run}: {len(film.frames)} frames")
    return _cube(expansion, films)


def _at_rest(study, case) -> RunFrames:
    """The ideal packing at rest: one frame, before the slit opens."""
    film = _filmed(study.model_copy(update={"discharge_s": SAMPLE * WINDOW}), case, 0)
    return replace(film, frames=film.frames[:1], sides=film.sides[:1])


def _filmed(study, case, number: int) -> RunFrames:
    """A run with a frame at every sample; one that has come to a standstill ends there."""
    config = case.scene.config
    rested = settle(study, config, number)
    frames: list[Frame] = []
    flowed = discharge(study, config, rested, lambda run: frames.append(snapshot(run.engine)))
    sides = cells_of(rested).sides
    means = flowed.windows[:, sides][..., MEAN]  # (windows, 2 walls, cells, 2 ways)
    means = means.reshape(-1, SAMPLE, *means.shape[1:]).mean(axis=1)
    forces = np.concatenate([rested.walls[sides][None], means])[: len(frames)]
    return RunFrames(case.id, config.across, number, config.remedy, frames, forces, bool(flowed.removed))


def _cube(expansion: Expansion, films: list[RunFrames]) -> xr.Dataset:
    frames = [(k, frame) for k, film in enumerate(films) for frame in film.frames]
    most = max(int(frame["label"].max()) + 1 for _, frame in frames)
    motion = np.full((len(frames), most, 5), np.nan)
    for row, (_, frame) in enumerate(frames):
        motion[row, frame["label"]] = frame["motion"]
    contacts = [
        (k, on, *row) for k, (_, f) in enumerate(frames) for on, name in enumerate(("pairs", "walls")) for row in f[name]
    ]
    table = np.array(contacts)
    data = {f"disc_{name}": motion[:, :, k] for k, name in enumerate(("x", "y", "u", "v", "spin"))}
    data |= {"snapshot_time": np.array([float(frame["time"]) for _, frame in frames])}
    data |= {"snapshot_film": np.array([k for k, _ in frames], np.int32)}
    data |= {"disc": np.arange(most), "snapshot": np.arange(len(frames)), "film": np.arange(len(films))}
    data |= {"film_across": np.array([film.across for film in films], np.int32)}
    data |= {"film_run": np.array([film.run for film in films], np.int32)}
    data |= {"film_remedy": np.array([film.remedy for film in films], np.int8)}
    data |= {"film_case": np.array([film.case for film in films])}
    data |= {"contact_snapshot": table[:, 0].astype(np.int32), "contact_on_wall": table[:, 1].astype(np.int8)}
    for k, name in enumerate(("first", "second"), start=2):
        data[f"contact_{name}"] = table[:, k].astype(np.int32)
    for k, name in enumerate(("x", "y", "force_x", "force_y"), start=4):
        data[f"contact_{name}"] = table[:, k]
    sides = np.concatenate([film.sides for film in films])
    for way, name in enumerate(("normal", "shear")):
        data[f"frame_{name}_force"] = sides[..., way]
    silo = expansion.study.scene.silo
    data["side_wall"] = np.array(SIDE_WALLS)
    data["side_cell"] = (np.arange(sides.shape[2]) + 0.5) * silo.height_m / sides.shape[2]
    discs = expansion.study.scene.discs
    sizes = {"width_m": silo.width_m, "height_m": silo.height_m, "slit_width_m": silo.slit_width_m}
    sizes |= {"radius_m": discs.radius_m, "density_kg_m3": discs.density_kg_m3}
    return assemble(expansion.study, "motion", data, sources=SOURCES, notes=sizes)
