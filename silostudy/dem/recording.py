"""Record that a run makes of itself."""

from dataclasses import dataclass, field

import numpy as np

from silostudy.dem.events import Event
from silostudy.dem.explosion import Explosion
from silostudy.dem.leaving import WAYS


@dataclass
class Recording:
    """Windows of wall forces, discharge, snapshots and events that a run has recorded."""

    window_time: list[float] = field(default_factory=list)  # s, end of each window; the last may be shorter
    window: list[np.ndarray] = field(default_factory=list)  # (cells, 2, 3): mean, least, largest
    whole: list[np.ndarray] = field(default_factory=list)  # (walls, 2, 2): least, largest of every wall, with each window
    motion: list[np.ndarray] = field(default_factory=list)  # (walls, 3) height (m), rise (m/s), turn (rad/s), with each window
    energy: list[np.ndarray] = field(default_factory=list)  # J/m, entries of the energy balance, with each window
    discharge_time: list[float] = field(default_factory=list)
    discharged: list[float] = field(default_factory=list)  # kg/m
    left: dict[str, int] = field(default_factory=lambda: dict.fromkeys(WAYS, 0))  # discs that are gone, by their way
    lost: dict[str, float] = field(default_factory=lambda: dict.fromkeys(WAYS, 0.0))  # their mass, kg/m
    passed: list[tuple[float, float, int]] = field(default_factory=list)  # s at which a body came below, its mass, its outlet
    steps: list[tuple[int, int]] = field(default_factory=list)  # tick, and ticks of a step from then on
    snapshots: list[dict[str, np.ndarray]] = field(default_factory=list)
    readings: dict[str, list[tuple[float, tuple]]] = field(default_factory=dict)  # s and what was read, by the observer's name
    happened: list[tuple[float, str, str]] = field(default_factory=list)  # time, trigger, action
    explosion: Explosion | None = None
    waiting: Event | None = None  # what the time limit came before
    buried: str = ""  # what had no room to come in
