"""Checkpoints of a discrete-element run on disk: what one was made of, and going on from one of the same."""

import hashlib
import pickle
import sys
from pathlib import Path

import numpy as np

from silostudy.config.grain_scenes import AnyScene
from silostudy.dem.run import Run
from silostudy.files import replacing
from silostudy.stamp import stamp


def made_of(run: Run, scene: AnyScene) -> dict[str, str]:
    """What a run is made of, part by part: a checkpoint holds for a run of the same alone.

    Files of the user's own count by what was read from them: a path says nothing of a changed file.
    """
    model = run.engine.model
    return {
        "scene": scene.model_dump_json(),
        "program": stamp("contact", "dem", "packing"),
        "laws": repr(model.pieces),
        "grains": _digest(*model.place.T, model.radius),
        "acceleration of the box": "" if model.quake is None else _digest(model.quake),
    }


def _digest(*arrays: np.ndarray) -> str:
    digest = hashlib.sha256()
    for array in arrays:
        digest.update(f"{array.shape}".encode() + np.ascontiguousarray(array).tobytes())
    return digest.hexdigest()


def save(run: Run, scene: AnyScene, checkpoint: Path) -> None:
    """Write a checkpoint of where the run stands."""
    content = pickle.dumps((made_of(run, scene), run.checkpoint()))
    with replacing(checkpoint) as temporary:
        temporary.write_bytes(hashlib.sha256(content).digest() + content)


def _whole(raw: bytes) -> bytes:
    """The content of a checkpoint whose checksum stands in front; nothing else is unpickled, for that would run it."""
    size = hashlib.sha256().digest_size
    if hashlib.sha256(raw[size:]).digest() != raw[:size]:
        raise ValueError("not what was written")
    return raw[size:]


def resume(run: Run, scene: AnyScene, checkpoint: Path) -> None:
    """Go on from a checkpoint, where there is one of this run; says so where it is of another, and sets it aside."""
    if not checkpoint.exists():
        return
    try:
        then, saved = pickle.loads(_whole(checkpoint.read_bytes()))
        now = made_of(run, scene)
        other = [part for part in now if then.get(part) != now[part]]
    except Exception as error:  # a file cut short or of another kind fails in any way
        other, saved = [f"cannot be read ({type(error).__name__})"], None
    if not other:
        run.restore(saved)
        return
    why = other[0] if saved is None else f"was made with other {', other '.join(other)}"
    aside = checkpoint.with_name(f"{checkpoint.name}.old")
    checkpoint.replace(aside)
    print(f"silostudy: {checkpoint} {why}: the run starts anew; kept as {aside.name}", file=sys.stderr)
