"""The cases of a sweep of discrete-element scenes, and about what each costs."""

from collections.abc import Callable
from dataclasses import dataclass
from math import pi, sqrt
from pathlib import Path
from typing import Any

from silostudy.config.dem import DemScene
from silostudy.config.grain_scenes import AnyScene, scene_class
from silostudy.config.load import own_validated, read_yaml
from silostudy.config.scenes import ScenesStudy
from silostudy.packing import PACKINGS
from silostudy.tables.references import own_files

PARTICLE_STEP = 35e-9  # s: `silostudy explain config/scenes/kiyama-17-18.yaml`, with its looks at rest and discharge
START = 0.02  # s: building a scene


@dataclass(frozen=True)
class SceneCase:
    """One case: its scene, and the folder that files are named from."""

    config: DemScene
    folder: Path

    @property
    def files(self) -> tuple[Path, ...]:
        """The user's own files that the scene is made from."""
        data = (self.folder / name for name in self.config.named_files)
        return (*data, *own_files(self.folder, self.config.methods_from))


def scene_in(path: Path) -> AnyScene:
    """The scene in a file as asked; BadInput lists every mistake of it."""
    content = read_yaml(path)
    return own_validated(scene_class(content, str(path)), content, str(path), path.parent)


def title_of_scene(path: Path) -> str:
    """Title of the scene in a file."""
    return scene_in(path).title


def outputs_of_scene(path: Path) -> tuple[str, ...]:
    """Keys of the figures that a scene file asks for."""
    return getattr(scene_in(path), "outputs", ())


def files_of_scene(path: Path) -> tuple[Path, ...]:
    """The user's own files that a scene file names; BadInput lists every mistake of it."""
    config = scene_in(path)
    return (*(path.parent / name for name in config.named_files), *own_files(path.parent, config.methods_from))


def scenes_builder(study: ScenesStudy, folder: Path, where: str) -> Callable[[DemScene, dict], SceneCase]:
    """Builds the cases of a sweep."""

    def build_one(config: DemScene, settings: dict[str, Any]) -> SceneCase:
        return SceneCase(config, folder)

    return build_one


def cost(case: SceneCase) -> float:
    """About how long (s) a case computes, at most: discs times steps to its end."""
    config, radius = case.config, case.config.radius_m
    mass = config.density_kg_m3 * pi * radius**2
    stiffness = (config.walls or config.discs).normal_stiffness_N_m2 or config.discs.normal_stiffness_N_m2
    step = config.march.step_s or (0.4 * sqrt(mass / stiffness) if stiffness else 2e-5)
    return START + _discs(case) * _duration(config) / step * PARTICLE_STEP


def _discs(case: SceneCase) -> float:
    section, packing = case.config.packing, PACKINGS[case.config.packing.kind]
    if packing.count is not None:
        return packing.count(case.config.radius_m, **packing.arguments(section))
    return (case.folder / section.file).stat().st_size / 100 if (case.folder / section.file).is_file() else 1


def _duration(config: DemScene) -> float:
    """Model time (s) to the stop where events have their times, else to the limit."""
    now = 0.0
    for event in config.events:
        if event.when not in ("time", "after"):
            return config.march.limit_s
        now = event.value + (now if event.when == "after" else 0.0)
    return min(now, config.march.limit_s)
