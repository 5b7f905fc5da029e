"""The walls of a round silo of spheres, cell by cell over height and angle."""

import numpy as np

from silostudy.compute.scenes_windows import Felt, Walled
from silostudy.config.spheres import SphereScene
from silostudy.cube.contents import levelled
from silostudy.dem.run import Run
from silostudy.dem.space.cells import areas, faces, middles
from silostudy.scene.space_silo import HOPPER, LID, WALL
from silostudy.scene.spheres import space_silo_of

SURFACES = (WALL, HOPPER)  # whose cells are levels and turns


def keeps(scene: SphereScene) -> bool:
    """Whether the silo is round and its wall forces are recorded."""
    return scene.silo.plan == "circular" and scene.record.wall_force_window_s is not None


def cells(scene: SphereScene) -> tuple[int, np.ndarray]:
    """Number of levels of a wall, and the angles (rad) of the cells of a level about the axis."""
    levels, turns = scene.record.pressure_cells
    return levels, 2.0 * np.pi * (np.arange(turns) + 0.5) / turns


def contents(run: Run, scene: SphereScene) -> tuple[float, float]:
    """Height (m) of the level surface above the transition, and unit weight (N/m3), of the spheres where they are."""
    space, engine = space_silo_of(scene), run.engine
    weight = engine.mass * -scene.gravity_m_s2[2]
    surface, unit_weight = levelled(engine.places[:, 2], weight, space.bottom, space.silo.area)
    return surface - space.bottom, unit_weight


def felt(run: Run, scene: SphereScene) -> dict[str, Felt]:
    """Pressure and shear (Pa) of each surface's cells in every window, and the levels' heights (m)."""
    seen, surfaces = faces(run.engine.model.walls, LID), {}
    starts = np.cumsum([0, *(face.count for face in seen)])
    for face, start in zip(seen, starts, strict=False):
        if face.name in SURFACES:
            surface = run.engine.model.walls[face.wall]
            force = np.array([window[start : start + face.count, :2] for window in run.recording.window])
            shape = (len(force), *scene.record.pressure_cells, 2, 3)
            height = middles(surface)[:, 2].reshape(scene.record.pressure_cells)[:, 0]
            surfaces[face.name] = Felt((force / areas(surface)[:, None, None]).reshape(shape), height)
    return surfaces


ROUND = Walled(keeps, cells, contents, felt)
