"""Kernels that different processes compiled and kept are not taken for one another when one process loads them."""

import os
import subprocess
import sys

STEP = """
import sys, numpy as np
from silostudy.dem.engine import Engine
from tests.test_dem.scenes import contact, silo
from silostudy.dem.pieces import Laws
PAIRS = {"friction": {}, "none": {"pair": contact(laws=Laws()), "wall": contact(2.0, laws=Laws())}}
for name in sys.argv[1:]:
    engine = Engine(silo(**PAIRS[name]))
    engine.step_to(400)
    print(name, engine.discs.rows[: engine.n, :5].tobytes().hex()[:4000])
"""


def lines(folder, *names):
    environment = {**os.environ, "NUMBA_CACHE_DIR": str(folder)}
    done = subprocess.run([sys.executable, "-c", STEP, *names], capture_output=True, text=True, env=environment, check=True)
    return done.stdout.split("\n")[: len(names)]


def test_kernels_kept_by_two_processes_serve_a_third(tmp_path):
    apart = lines(tmp_path, "friction") + lines(tmp_path, "none")
    assert apart[0].split()[1] != apart[1].split()[1]
    assert lines(tmp_path, "friction", "none") == apart
