"""The walls of a plane silo of discs over a wedge, cell by cell: left and right are the two turns of each level."""

import numpy as np

from silostudy.compute.scenes_windows import Felt, Walled
from silostudy.config.dem import DemScene
from silostudy.cube.contents import levelled
from silostudy.dem.model import Model
from silostudy.dem.run import Run
from silostudy.dem.walls import wall_cells
from silostudy.scene.dem import plane_silo_of
from silostudy.scene.plane_silo import HOPPER, SIDES

SURFACES = {"wall": SIDES, "hopper": HOPPER}  # what the cube calls it -> its walls, left and right
TURNS = np.array([np.pi, 0.0])  # rad: of left and right about the middle


def keeps(scene: DemScene) -> bool:
    """Whether the silo stands over a wedge and its wall forces are recorded."""
    return scene.silo.hopper_half_angle_deg is not None and scene.record.wall_force_window_s is not None


def cells(scene: DemScene) -> tuple[int, np.ndarray]:
    """Number of levels of a wall, and the angles (rad) of the cells of a level about the axis."""
    return scene.silo.wall_cells, TURNS


def contents(run: Run, scene: DemScene) -> tuple[float, float]:
    """Height (m) of the level surface above the transition, and unit weight (N/m3), of the discs where they are."""
    silo, engine = plane_silo_of(scene), run.engine
    weight = engine.mass * -scene.gravity_m_s2[1]
    surface, unit_weight = levelled(engine.places[:, 1], weight, silo.bottom, silo.width)
    return surface - silo.bottom, unit_weight


def felt(run: Run, scene: DemScene) -> dict[str, Felt]:
    """Pressure and shear (Pa) of the walls' and the wedge's cells in every window, and the levels' heights (m)."""
    force, model = np.array(run.recording.window), run.engine.model
    surfaces = {}
    for stem, names in SURFACES.items():
        sides = [_of_wall(force, model, name) for name in names]
        surfaces[stem] = Felt(np.stack([stress for stress, _ in sides], axis=2), sides[0][1])
    return surfaces


def _of_wall(force: np.ndarray, model: Model, name: str) -> tuple[np.ndarray, np.ndarray]:
    """Pressure and shear (Pa) of the parts of a wall, from below, in every window, and heights (m) of their middles."""
    wall = model.wall_named(name)
    (x0, y0), (x1, y1) = wall.start, wall.end
    upward = slice(None) if y1 > y0 else slice(None, None, -1)
    inner = wall_cells(model, name)[1:-1]  # without the points that are its ends
    height = y0 + (y1 - y0) * (np.arange(wall.cells) + 0.5) / wall.cells
    stress = force[:, inner, :2] / (np.hypot(x1 - x0, y1 - y0) / wall.cells)
    return stress[:, upward], height[upward]


PLANE = Walled(keeps, cells, contents, felt)
