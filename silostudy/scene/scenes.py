"""The cases of a sweep of discrete-element scenes."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from silostudy.config.grain_scenes import AnyScene, scene_class
from silostudy.config.load import own_validated, read_yaml
from silostudy.config.scenes import ScenesStudy
from silostudy.scene.beside import check_codes
from silostudy.tables.references import own_files


@dataclass(frozen=True)
class SceneCase:
    """One case: its scene, and the folder that files are named from."""

    config: AnyScene
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


def outputs_of_scene(path: Path) -> tuple[str, ...]:
    """Keys of the figures that a scene file asks for."""
    return getattr(scene_in(path), "outputs", ())


def files_of_scene(path: Path) -> tuple[Path, ...]:
    """The user's own files that a scene file names; BadInput lists every mistake of it."""
    config = scene_in(path)
    return (*(path.parent / name for name in config.named_files), *own_files(path.parent, config.methods_from))


def scenes_builder(study: ScenesStudy, folder: Path, where: str) -> Callable[[AnyScene, dict], SceneCase]:
    """Builds the cases of a sweep; BadInput where theories and codes that are to stand beside it are of other silos."""
    check_codes(study, folder, where)

    def build_one(config: AnyScene, settings: dict[str, Any]) -> SceneCase:
        return SceneCase(config, folder)

    return build_one
