"""A run: the engine carried through a list of events, with what is to be recorded on the way."""

from collections.abc import Callable
from dataclasses import dataclass, field
from math import inf

import numpy as np

from silostudy.dem.change import keep_discs, set_friction, swap_walls
from silostudy.dem.checkpoint import checkpoint, restore
from silostudy.dem.engine import Engine, Explosion
from silostudy.dem.lanes import U, V, W, Y
from silostudy.dem.ledger import ENTRIES, carry_out
from silostudy.dem.snapshot import pair_contacts, stress, wall_contacts
from silostudy.errors import BadInput

CHECK_EVERY = 200  # steps between looks at rest, discharge and drop-outs: counted from the start, so chunks do not matter
REST = 1e-8  # of dt^2 g: mean displacement in a step of a packing at rest, Kiyama & Fujimura (1983), note 3
TRIGGERS = ("time", "after", "rest", "discharged")
ACTIONS = ("open", "remove", "gravity", "friction", "stop")


@dataclass(frozen=True)
class Event:
    """One event: it waits for its turn, then for its trigger, then acts.

    trigger: time (s from the start), after (s from the event before), rest, discharged (share of the mass).
    action: open (wall, walls that replace it), remove (label or x, y), gravity (x, y), friction (pair, wall), stop.
    """

    trigger: str
    value: float
    action: str
    what: tuple = ()

    def __post_init__(self):
        if self.trigger not in TRIGGERS:
            raise BadInput("trigger", self.trigger, f"unknown; known: {', '.join(TRIGGERS)}")
        if self.action not in ACTIONS:
            raise BadInput("action", self.action, f"unknown; known: {', '.join(ACTIONS)}")


@dataclass
class Recording:
    """What a run has recorded: windows of wall forces, discharge, snapshots, the events that happened."""

    window_time: list[float] = field(default_factory=list)  # s, end of each window
    window: list[np.ndarray] = field(default_factory=list)  # (cells, 2, 3): mean, least, largest
    energy: list[np.ndarray] = field(default_factory=list)  # J/m, entries of the ledger, with each window
    discharge_time: list[float] = field(default_factory=list)
    discharged: list[float] = field(default_factory=list)  # kg/m
    snapshots: list[dict[str, np.ndarray]] = field(default_factory=list)
    happened: list[tuple[float, str, str]] = field(default_factory=list)  # time, trigger, action
    explosion: Explosion | None = None


class Run:
    """Carries an engine through events until a stop, or at most to a time limit (s).

    window: steps over which wall forces are gathered, snapshots: steps at which contacts are read; both off by default.
    """

    def __init__(
        self,
        engine: Engine,
        events: tuple[Event, ...],
        *,
        limit: float,
        window: int = 0,
        snapshots: tuple[int, ...] = (),
        stress_edges: tuple[np.ndarray, np.ndarray] | None = None,
    ):
        if not events or events[-1].action != "stop":
            raise BadInput("events", [event.action for event in events], "the last event must be a stop")
        self.engine, self.events, self.window, self.snapshots = engine, events, window, snapshots
        self.stress_edges = stress_edges
        self.recording, self.last = Recording(), round(limit / engine.model.dt)
        self.next_event, self.since, self.dropped = 0, 0, 0.0
        self.full = float(engine.model.mass.sum())
        self.floor = min(min(wall.start[1], wall.end[1]) for wall in engine.model.walls) if engine.model.walls else -inf

    @property
    def done(self) -> bool:
        """Whether the stop has happened or a disc ran away."""
        return self.next_event == len(self.events) or self.recording.explosion is not None

    def go(self, *, until: int | None = None, tell: Callable[[int], None] = lambda step: None) -> Recording:
        """Run to the stop, or to `until` steps; `tell` hears the step now and then."""
        if self.engine.step == 0:
            self._act_where_due()
        while not self.done and (until is None or self.engine.step < until):
            try:
                self.engine.step_to(self._next_stop(until))
            except Explosion as explosion:
                self.recording.explosion = explosion
                break
            self._look()
            tell(self.engine.step)
        return self.recording

    def insert(self, event: Event) -> None:
        """Put an event before the one that the run waits for."""
        self.events = (*self.events[: self.next_event], event, *self.events[self.next_event :])

    def _next_stop(self, until: int | None) -> int:
        step = self.engine.step
        stops = [(step // CHECK_EVERY + 1) * CHECK_EVERY]
        if self.window:
            stops.append((step // self.window + 1) * self.window)
        stops += [snapshot for snapshot in self.snapshots if snapshot > step]
        stops += [self._due()] if self._due() > step else []
        return min([*stops, self.last] if until is None else [*stops, self.last, until])

    def _due(self) -> int:
        """Step of the next event where its time is known, else -1."""
        event = self.events[self.next_event]
        start = {"time": 0, "after": self.since}.get(event.trigger)
        return -1 if start is None else start + round(event.value / self.engine.model.dt)

    def _look(self) -> None:
        step = self.engine.step
        if self.window and step % self.window == 0:
            self._close_window()
        if step in self.snapshots:
            self.recording.snapshots.append(self.snapshot())
        if step % CHECK_EVERY == 0:
            self._drop()
        self._act_where_due()
        if step >= self.last and not self.done:
            self.recording.happened.append((self.engine.time, "limit", "stop"))
            self.next_event = len(self.events)

    def _act_where_due(self) -> None:
        while not self.done and self._triggered(self.events[self.next_event]):
            self._act(self.events[self.next_event])

    def _triggered(self, event: Event) -> bool:
        if event.trigger in ("time", "after"):
            return self.engine.step >= self._due()
        if self.engine.step % CHECK_EVERY or not self.engine.step:  # discs that have not moved yet are not at rest
            return False
        return self.at_rest() if event.trigger == "rest" else self.dropped >= event.value * self.full

    def at_rest(self) -> bool:
        """Whether the mean displacement of a step is below the paper's limit in both directions."""
        dt = self.engine.model.dt
        limit = REST * dt * dt * float(np.hypot(*self.engine.gravity))
        return all(np.abs(self.engine.column(lane)).mean() * dt < limit for lane in (U, V))

    def _act(self, event: Event) -> None:
        if event.action == "open":
            swap_walls(self.engine, event.what[0], event.what[1:])
        elif event.action == "remove":
            kept = np.ones(self.engine.n, bool)
            kept[self._disc(event.what)] = False
            self._take_out(kept)
        elif event.action == "gravity":
            self.engine.gravity = (float(event.what[0]), float(event.what[1]))
        elif event.action == "friction":
            set_friction(self.engine, pair=event.what[0], wall=event.what[1])
        self.recording.happened.append((self.engine.time, event.trigger, event.action))
        self.since = self.engine.step
        self.next_event += 1

    def _disc(self, what: tuple) -> int:
        """The engine's number of a disc given by its label, or by a place (m) that it is nearest to."""
        if len(what) == 1:
            found = np.flatnonzero(self.engine.labels == what[0])
            if not len(found):
                raise BadInput("remove", what[0], "no such disc is left")
            return int(found[0])
        place = self.engine.discs.rows[: self.engine.n, :2]
        return int(np.argmin(np.hypot(*(place - np.asarray(what)).T)))

    def _drop(self) -> None:
        """Count and drop discs wholly below the floor that touch nothing any more."""
        engine = self.engine
        below = np.flatnonzero(engine.column(Y) < self.floor - engine.radius)
        kept = np.ones(engine.n, bool)
        place, radius = engine.discs.rows[: engine.n, :2], engine.radius
        for i in below:
            gap = np.hypot(*(place - place[i]).T) - radius - radius[i]
            gap[i] = inf
            kept[i] = bool((gap <= 0.0).any())
        if not kept.all():
            self._take_out(kept)

    def _take_out(self, kept: np.ndarray) -> None:
        self.dropped += float(self.engine.mass[~kept].sum())
        carry_out(self.engine, ~kept)
        keep_discs(self.engine, kept)
        self.recording.discharge_time.append(self.engine.time)
        self.recording.discharged.append(self.dropped)

    def _close_window(self) -> None:
        window = self.engine.record.window.copy()
        window[:, :, 0] /= self.window
        self.recording.window_time.append(self.engine.time)
        self.recording.window.append(window)
        self.recording.energy.append(self.engine.ledger.account[: len(ENTRIES)].copy())
        self.engine.clear_window()

    def checkpoint(self) -> dict:
        """Everything that going on depends on: the engine's arrays, where the events stand, and what was recorded."""
        stand = {"next_event": self.next_event, "since": self.since, "dropped": self.dropped}
        return {"engine": checkpoint(self.engine), "stand": stand, "recording": self.recording}

    def restore(self, saved: dict) -> None:
        """Go on from a checkpoint of the same scene."""
        restore(self.engine, saved["engine"])
        self.next_event, self.since = saved["stand"]["next_event"], saved["stand"]["since"]
        self.dropped, self.recording = saved["stand"]["dropped"], saved["recording"]

    def snapshot(self) -> dict[str, np.ndarray]:
        """Places, velocities and force chains now."""
        engine = self.engine
        averaged = {} if self.stress_edges is None else {"stress": stress(engine, *self.stress_edges)}
        return averaged | {
            "time": np.array(engine.time),
            "label": engine.labels.copy(),
            "motion": engine.discs.rows[: engine.n, : W + 1].copy(),
            "pairs": np.column_stack([*vars(pair_contacts(engine)).values()]),
            "walls": np.column_stack([*vars(wall_contacts(engine)).values()]),
        }
