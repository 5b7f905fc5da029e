"""Files for ParaView of snapshots that hold few grains."""

from types import SimpleNamespace

import meshio
import numpy as np
import pytest

from silostudy.compute.paraview import export
from silostudy.dem.plane import PLANE
from silostudy.dem.space.dimension import SPACE


@pytest.mark.parametrize("count", [1, 2])
@pytest.mark.parametrize(("space", "spins"), [(PLANE, ()), (SPACE, (3,))])
def test_snapshots_of_few_grains(space, spins, count, tmp_path):
    """A rain begins with one grain; three spins of one sphere are not spins of three."""
    motion = np.arange(float(count * space.motion)).reshape(count, -1)
    snapshot = {"time": np.array(0.1), "motion": motion, "label": np.arange(count), "pairs": np.empty((0, 2 + 2 * space.ways))}
    engine = SimpleNamespace(space=space, model=SimpleNamespace(radius=np.full(count, 0.004), kind=None))
    names = export(SimpleNamespace(engine=engine, recording=SimpleNamespace(snapshots=[snapshot])), tmp_path)
    assert meshio.read(names[0]).point_data["spin"].shape == (count, *spins)
