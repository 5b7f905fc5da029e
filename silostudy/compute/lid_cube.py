"""Variables of the cube on a lid that moves, of any grains."""

import numpy as np

from silostudy.dem.run import Run


def lid_arrays(run: Run) -> dict[str, np.ndarray]:
    """Height and speed of the lid at the end of each window, and its mean pressure; of a run whose lid may move."""
    model, record = run.engine.model, run.recording
    if model.lid is None or not record.window:
        return {}
    number = run.engine.lid
    height, speed = np.array(record.motion)[:, number, :2].T
    first = run.engine.walls.cells[:, 0]
    force = np.add.reduceat(np.array(record.window)[:, :, 0, 0], first, axis=1)[:, number]
    return {"lid_height": height, "lid_speed": speed, "lid_stress": force / model.lid.area}
