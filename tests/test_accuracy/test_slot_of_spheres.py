"""Slots of 4 to 8 diameters under a wedge of spheres: they drain here and in LAMMPS, unless its walls go on below the slot.

A public comparison of a code with LAMMPS (SueHeir/dirt, examples/bench_hopper_beverloo) finds a power of 1.36 for the code, and
of 3.99 for LAMMPS, which lets nothing out of a slot of 6 diameters.
"""

from math import pi

import numpy as np
import pytest
from scipy.stats import linregress

from silostudy.accuracy.peers import available
from silostudy.config.spheres import SphereScene
from tests.test_accuracy.slot_in_lammps import DEEP, DENSITY, DIAMETER, LOW, TOP, WIDE, SlotInLammps, blocks, planes_in_a_slab
from tests.test_spheres.small import run

COUNT = 1400
EDGE = 1.4 * DIAMETER  # by which the comparison takes a slot to be narrower
SLOTS = (0.016, 0.024, 0.032)
MASS = DENSITY * pi * DIAMETER**3 / 6
BODY = {"youngs_modulus_MPa": 50, "poissons_ratio": 0.3}
TOUCH = {"restitution": 0.5, "sliding_friction": 0.5}


def slope(slot: float, side: int) -> dict:
    """A sloping wall of the wedge, from the slot up to the wall on a side of it."""
    low, high = side * slot / 2, side * WIDE / 2
    ends = [[-DEEP / 2, low, 0.0], [DEEP / 2, low, 0.0], [DEEP / 2, high, TOP], [-DEEP / 2, high, TOP]]
    return {"kind": "polygon", "name": "left" if side < 0 else "right", "corners_m": ends}


def scene(slot: float) -> SphereScene:
    return SphereScene.model_validate({
        "kind": "dem", "grains": "spheres", "title": "a slot below a wedge",
        "silo": {"plan": "rectangular", "width_m": DEEP, "length_m": WIDE, "cylinder_depth_m": 0.3},
        "outlets": [{"width_m": DEEP, "length_m": slot}],
        "inserts": [slope(slot, -1), slope(slot, 1)],
        "grain": BODY | {"density_kg_m3": DENSITY}, "wall": BODY, "spheres": TOUCH, "walls": TOUCH,
        "surfaces": {"wall_1": {"sliding_friction": 0.0}, "wall_3": {"sliding_friction": 0.0}},
        "sizes": {"kind": "equal", "diameter_mm": 1e3 * DIAMETER},
        "filling": {"kind": "rain", "count": COUNT, "rate_1_s": 2800, "speed_m_s": 0.5},
        "march": {"limit_s": 3.0},
        "events": [{"when": "time", "value": 0.9, "do": "open_outlet"}, {"when": "after", "value": 1.6, "do": "stop"}],
        "record": {},
    })  # fmt: skip


def flow(times, passed) -> float:
    """Mean mass flow (kg/s) between a tenth and nine tenths of the spheres."""
    first, last = np.interp([0.1 * COUNT, 0.9 * COUNT], passed, times)
    return 0.8 * COUNT * MASS / (last - first)


def power(flows) -> float:
    return linregress(np.log(np.array(SLOTS) - EDGE), np.log(flows)).slope


@pytest.mark.long
def test_slots_drain_here():
    flows = []
    for slot in SLOTS:
        done = run(scene(slot))
        done.go()
        passed = np.array(done.recording.discharged) / MASS
        assert passed[-1] == pytest.approx(COUNT)
        flows.append(flow(done.recording.discharge_time, passed))
    assert flows == pytest.approx([0.083, 0.178, 0.308], rel=0.05)
    assert power(flows) == pytest.approx(1.40, abs=0.06)


@pytest.mark.long
@pytest.mark.skipif(bool(available()), reason=available())
def test_they_drain_in_lammps_where_its_walls_end_at_the_slot():
    flows = []
    for slot, duration in zip(SLOTS, (1.8, 0.85, 0.5), strict=True):
        times, passed = SlotInLammps(slot, blocks(slot), COUNT).flow_out(duration)
        assert passed[-1] == COUNT
        flows.append(flow(times, passed))
    assert flows == pytest.approx([0.082, 0.184, 0.315], rel=0.05)
    assert power(flows) == pytest.approx(1.44, abs=0.06)


@pytest.mark.long
@pytest.mark.skipif(bool(available()), reason=available())
def test_a_slot_of_six_diameters_is_shut_by_walls_that_go_on_below_it():
    slot = SLOTS[1]
    shut = SlotInLammps(slot, planes_in_a_slab(slot), COUNT)
    _, passed = shut.flow_out(0.3, look=0.1)
    below = np.sort(shut.heights[shut.heights < 0.0])
    assert passed[-1] == 0
    assert 10 < len(below) < 100
    tip = -TOP * slot / (WIDE - slot)  # where the two planes meet
    lowest = tip + 0.5 * DIAMETER / np.sin(np.arctan2(WIDE - slot, 2.0 * TOP))
    assert below[0] == pytest.approx(lowest, abs=0.1 * DIAMETER)


def test_a_power_of_four_comes_of_the_outlet_that_such_walls_leave():
    """The comparison counts its spheres 40 mm below the slot, under a wedge 0.17 m high; slots of 32 to 56 mm."""
    slots = np.array([0.032, 0.038, 0.044, 0.050, 0.056])
    left = slots + LOW * (WIDE - slots) / 0.17
    assert left[0] == pytest.approx(2.8 * DIAMETER, rel=0.01)
    found = linregress(np.log(slots - EDGE), 1.5 * np.log(left - EDGE)).slope
    assert found == pytest.approx(3.99, abs=0.2)
