"""The earthquake of a shell study: the seismic study that it names, and whether that one shakes the same silo."""

from pathlib import Path

from silostudy.config.fields import expand
from silostudy.config.load import read_study
from silostudy.config.seismic import SeismicScene, SeismicStudy
from silostudy.config.shell import Earthquake
from silostudy.errors import BadInput
from silostudy.scene.expand import Expansion, file_as_asked
from silostudy.scene.scene import Scene, solid_parameters
from silostudy.tables.constants import STANDARD_GRAVITY

SAME = {"inner radius": 1e-3, "depth of the contents": 1e-6, "unit weight": 0.01}  # relative; the tube has one thickness


def read_earthquake(asked: Earthquake, folder: Path, where: str) -> Expansion:
    """The seismic study beside the shell study, as asked; BadInput where it is missing or cannot be laid on a shell."""
    path = folder / f"{asked.study}.yaml"
    if not path.is_file():
        known = sorted(file.stem for file in folder.glob("*.yaml"))
        raise BadInput("earthquake.study", asked.study, f"unknown; known: {', '.join(known)}", where)
    study = read_study(path)
    if not isinstance(study, SeismicStudy) or study.sweep:
        raise BadInput("earthquake.study", asked.study, "must be a seismic study without sweep", where)
    if asked.mass_choice == "identified" and study.identification is None:
        raise BadInput("earthquake.mass_choice", asked.mass_choice, f"{asked.study} identifies none", where)
    if study.relative_depth is not None:  # those chosen for an accuracy do
        depths = expand(study.relative_depth)
        if (depths[0], depths[-1]) != (0, 1):
            raise BadInput("relative_depth", [depths[0], depths[-1]], "must run from 0 to 1: a shell study reads it", str(path))
    return file_as_asked(path)


def check_same_silo(scene: Scene, shaken: SeismicScene, where: str) -> None:
    """BadInput unless the shaken tube is the silo of a shell study, filled alike, and its bottom flat."""
    if scene.silo.hopper:
        raise BadInput("earthquake.study", scene.silo.plan, "needs a flat bottom: EN 1998-4's pressure is for one", where)
    tube = shaken.silo
    ours = (scene.silo.diameter / 2, scene.silo.cylinder_depth, solid_parameters(scene, "")["unit_weight"])
    theirs = (
        tube.mid_wall_radius_m - tube.wall_thickness_mm / 2e3,
        tube.fill_height_m or tube.height_m,
        shaken.contents.density_kg_m3 * STANDARD_GRAVITY,
    )
    for (what, tolerance), own, other in zip(SAME.items(), ours, theirs, strict=True):
        if abs(other / own - 1) > tolerance:
            allowed = f"its {what} of {other:.6g} must be the silo's {own:.6g} (SI units)"
            raise BadInput("earthquake.study", shaken.motion.record or shaken.motion.file, allowed, where)
