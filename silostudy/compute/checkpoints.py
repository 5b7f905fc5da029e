"""Checkpoints of a discrete-element run on disk: what one was made of, and going on from one of the same."""

import hashlib
import pickle
from pathlib import Path
from typing import Any

import numpy as np

from silostudy.config.grain_scenes import AnyScene
from silostudy.dem.run import Run
from silostudy.files import replacing
from silostudy.say import say
from silostudy.stamp import stamp


def made_of(run: Run, scene: AnyScene) -> dict[str, str]:
    """Parts that a run is made of: a checkpoint holds for a run of the same parts alone.

    Files of the user's own count by what was read from them: a path says nothing of a changed file.
    """
    model = run.engine.model
    return {
        "scene": scene.model_dump_json(),
        "program": program(),
        "laws": repr(model.pieces),
        "grains": _digest(*model.place.T, model.radius, *([] if model.kind is None else [model.kind])),
        "acceleration of the box": "" if model.quake is None else _digest(model.quake),
        "end that it goes on from": "" if model.end is None else _digest(model.end["engine"]["rows"]),
    }


def program() -> str:
    """Hash of the sources that a run's state hangs on."""
    return stamp("contact", "dem", "packing")


def _digest(*arrays: np.ndarray) -> str:
    digest = hashlib.sha256()
    for array in arrays:
        digest.update(f"{array.shape}".encode() + np.ascontiguousarray(array).tobytes())
    return digest.hexdigest()


def save(run: Run, scene: AnyScene, checkpoint: Path) -> None:
    """Write a checkpoint of where the run stands."""
    write_whole((made_of(run, scene), run.checkpoint()), checkpoint)


def write_whole(held: Any, path: Path) -> None:
    """Write what a run holds into a file, its checksum in front."""
    content = pickle.dumps(held)
    with replacing(path) as temporary:
        temporary.write_bytes(hashlib.sha256(content).digest() + content)


def read_whole(path: Path) -> Any:
    """Content of such a file; any error where it is none, or cut short.  Nothing else is unpickled, for that would run it."""
    raw, size = path.read_bytes(), hashlib.sha256().digest_size
    if hashlib.sha256(raw[size:]).digest() != raw[:size]:
        raise ValueError("not what was written")
    return pickle.loads(raw[size:])


def resume(run: Run, scene: AnyScene, checkpoint: Path) -> None:
    """Go on from a checkpoint, where there is one of this run; says so where it is of another, and sets it aside."""
    if not checkpoint.exists():
        return
    try:
        then, saved = read_whole(checkpoint)
        now = made_of(run, scene)
        other = [part for part in now if then.get(part) != now[part]]
    except Exception as error:  # a file cut short or of another kind fails in any way
        other, saved = [f"cannot be read ({type(error).__name__})"], None
    if not other:
        run.restore(saved)
        say(f"goes on from {checkpoint} at {run.engine.time:.6g} s")
        return
    why = other[0] if saved is None else f"was made with other {', other '.join(other)}"
    aside = checkpoint.with_name(f"{checkpoint.name}.old")
    checkpoint.replace(aside)
    say(f"{checkpoint} {why}: the run starts anew; kept as {aside.name}")
