"""A run: the engine carried through a list of events, with what is to be recorded on the way."""

from collections.abc import Callable

import numpy as np

from silostudy.dem.branch import CARRIED, go_on
from silostudy.dem.calm import calm_down, wake, watch_after
from silostudy.dem.change import keep_discs, not_open, open_holes, set_friction, swap_walls, take_walls
from silostudy.dem.checkpoint import checkpoint, restore
from silostudy.dem.engine import Engine
from silostudy.dem.events import TRIGGERS, Event, acted_at
from silostudy.dem.explosion import Explosion
from silostudy.dem.feeder import Feeder
from silostudy.dem.follow import EVERY, follow_in
from silostudy.dem.leaving import DISCHARGED, REMOVED, SPILT, OutletAt, Over, below, drawn, lowest, number_of, passing
from silostudy.dem.ledger import ENTRIES, carry_out, change_gravity, take_springs
from silostudy.dem.moves import MOVES, OF_LID, lid_meets
from silostudy.dem.observer import Observer, after, read_due
from silostudy.dem.rain import Rain, pour
from silostudy.dem.recording import Recording
from silostudy.dem.rest import PAPER, Look, Rest
from silostudy.dem.snapshot import held_energy, snapshot
from silostudy.dem.trouble import trouble_of
from silostudy.errors import BadInput

CHECK_EVERY = 200  # usual steps between looks at rest, discharge and drop-outs: counted from the start, so chunks do not matter


class Run:
    """Carries an engine through events until a stop, or at most to a time limit (s).

    window: ticks over which wall forces are gathered, snapshots: ticks at which contacts are read, observers: what else is
    read; all off by default.  What comes due within a step is done at its end.
    rest: what the trigger `rest` waits for, once all bodies are there; rain: how those come in that wait at the start;
    feeder: what draws bodies from a closed outlet, once an event sets its rate.
    outlet_at: places (n, d) at the outlets' level -> numbers of their outlets, None: there is one.
    """

    def __init__(
        self,
        engine: Engine,
        events: tuple[Event, ...],
        *,
        limit: float,
        window: int = 0,
        snapshots: tuple[int, ...] = (),
        observers: tuple[Observer, ...] = (),
        rest: Rest = PAPER,
        rain: Rain | None = None,
        feeder: Feeder | None = None,
        outlet_at: OutletAt = None,
    ):
        if not events or events[-1].action != "stop":
            raise BadInput("events", [event.action for event in events], "the last event must be a stop")
        self.engine, self.events, self.window, self.snapshots = engine, events, window, snapshots
        self.observers, self.rest, self.rain, self.feeder = observers, rest, rain, feeder
        self.outlet_at, self.check = outlet_at, CHECK_EVERY * engine.model.pace.usual
        self.recording, self.last = Recording(), round(limit / engine.model.dt)
        self.next_event, self.since, self.opened = 0, 0, engine.step
        self.full = float(engine.model.mass.sum())
        self.come, self.came = engine.n, engine.step  # how many bodies have come in, and when the last of them did
        self.began, self.gone = engine.step, 0.0  # a branch goes on with the clock; mass (kg/m) that had left before
        self.top_speed = 0.0  # of a body since the last event, over that of a fall, where steps are longer at rest
        self.looked: Look | None = None  # where bodies were when rest was last looked for
        self.floor, self.over = lowest(engine.model, engine.model.walls), Over(engine)
        if engine.model.end is not None:
            go_on(self, engine.model.end)
        self.recording.steps.append((engine.step, engine.ticks))

    @property
    def done(self) -> bool:
        """Whether the stop has happened, the time limit came, or a disc ran away."""
        record = self.recording
        ended = self.next_event == len(self.events)
        return ended or record.waiting is not None or record.explosion is not None or bool(record.buried)

    @property
    def dropped(self) -> float:
        """Mass (kg/m) that has left through the opening."""
        return self.recording.lost[DISCHARGED]

    def go(self, *, until: int | None = None, tell: Callable[[int], None] = lambda step: None) -> Recording:
        """Run to the stop, or to `until` ticks; `tell` hears the tick now and then."""
        try:
            if self.engine.step == self.began:
                self._begin()
            while not self.done and (until is None or self.engine.step < until):
                before = self.engine.step
                self.engine.step_to(self._next_stop(until))
                self._look(before)
                tell(self.engine.step)
        except Explosion as explosion:
            self.recording.explosion = explosion
        if self.done and not self.recording.explosion:
            self._close_window()
        return self.recording

    def _begin(self) -> None:
        """A snapshot of the start, where one is asked for, and the events that are due at once."""
        if not self.began:
            self._pour()
        if self.began in self.snapshots and not self.recording.snapshots:
            self.recording.snapshots.append(snapshot(self.engine))
        self._act_where_due(checks=self.began > 0 and self.began % self.check == 0)
        if self.began and self.began % (EVERY * self.check) < self.engine.ticks and not self.done:
            follow_in(self)  # the run that it goes on from ended at this look, before it

    @property
    def trouble(self) -> str:
        """Reason why the run did not come to its stop; empty where it did."""
        return trouble_of(self)

    def insert(self, event: Event) -> None:
        """Put an event before the one that the run waits for."""
        self.events = (*self.events[: self.next_event], event, *self.events[self.next_event :])

    def _next_stop(self, until: int | None) -> int:
        step = self.engine.step
        stops = [watch_after(self, step), *([after(step, self.window)] if self.window else [])]
        stops += [snapshot for snapshot in self.snapshots if snapshot > step]
        stops += [observer.after(step) for observer in self.observers]
        stops += [self.due()] if self.due() > step else []
        return min([*stops, self.last] if until is None else [*stops, self.last, until])

    def due(self) -> int:
        """Tick of the next event where its time is known, else -1."""
        event = self.events[self.next_event]
        start = {"time": 0, "after": self.since}.get(event.trigger)
        return -1 if start is None else start + round(event.value / self.engine.model.dt)

    def _look(self, before: int) -> None:
        """Do what came due after a tick."""
        step = self.engine.step
        checks = after(before, self.check) <= step
        if self.window and after(before, self.window) <= step:
            self._close_window()
        if any(before < snapshot <= step for snapshot in self.snapshots):
            self.recording.snapshots.append(snapshot(self.engine))
        read_due(self.observers, self.engine, before, self.recording.readings)
        if checks:
            self._drop()
            self._feed()
            self._pour()
        calm_down(self, before)
        self._act_where_due(checks=checks)
        if checks and step < self.last and self.rest.criterion.looks_back:
            self.looked = Look(step, self.engine.places)
        if after(before, EVERY * self.check) <= step and not self.done:
            follow_in(self)
        if step >= self.last and not self.done:
            self.recording.happened.append((self.engine.time, "limit", "stop"))
            self.recording.waiting = self.events[self.next_event]

    def _act_where_due(self, *, checks: bool) -> None:
        while not self.done and self._triggered(self.events[self.next_event], checks):
            self._act(self.events[self.next_event])

    def _triggered(self, event: Event, checks: bool) -> bool:
        if event.action in OF_LID and self.come < self.engine.most:  # the lid waits for those that come in below it
            return False
        if event.trigger in ("time", "after"):
            return self.engine.step >= self.due()
        if not checks:
            return False
        if event.trigger == "rest":
            return self.come == self.engine.most and self.rest.holds(self.engine, self.looked)
        if TRIGGERS[event.trigger].of_lid:
            return lid_meets(self.engine, event)
        return self.gone + self.dropped >= event.value * self.full

    def _pour(self) -> None:
        """Let those in that are due, as far as they find room; where none does for long, the run ends."""
        engine, rain = self.engine, self.rain
        if rain is None or self.come == engine.most:
            return
        due = min(engine.most, int(rain.due(engine.time)))
        came = pour(engine, rain, self.come, due)
        self.come += came
        if came or self.come == due:
            self.came = engine.step
        elif (engine.step - self.came) * engine.model.dt > rain.patience(engine):
            body = f"{engine.space.body} {self.come} of {engine.most}"
            self.recording.buried = f"no room for {body} at the plane that they come in on: what is below it is full"

    def _act(self, event: Event) -> None:
        engine, action, told = self.engine, event.action, event.told()
        if action == "open":
            self._take_away(lambda: swap_walls(engine, event.what[0], event.what[1:]))
        elif action == "open holes":
            wall, names, speed = event.what
            names = not_open(engine, wall, names)
            self._take_away(lambda: open_holes(engine, wall, names, speed))
            told = event.told(", ".join(names) or "nothing: open by then")
        elif action == "take away":
            self._take_away(lambda: take_walls(engine, event.what))
            told = event.told(", ".join(event.what))
        elif action == "remove":
            told = event.told(self._remove(event.what))
        elif action == "gravity":
            gravity = tuple(map(float, event.what))
            change_gravity(engine, gravity)
            engine.gravity = gravity
        elif action == "friction":
            set_friction(engine, pair=event.what[0], wall=event.what[1], walls=event.what[2])
        elif action == "feed":
            assert self.feeder is not None
            self.feeder.rate, self.feeder.owed = event.what[0], 0.0
        elif action in MOVES:
            MOVES[action](engine, *event.what)
        self.recording.happened.append((engine.time, event.trigger, told))
        self.since = acted_at(self)
        if action != "stop":  # after which a branch may look on
            self.looked = None
            wake(self)
        self.next_event += 1

    def _remove(self, what: tuple) -> str:
        """Take a body out; says which, or nothing where it is not there."""
        number = number_of(self.engine, what)
        if number is None:
            return f"nothing: the {self.engine.space.body} was not there"
        gone, label = np.arange(self.engine.n) == number, self.engine.labels[number]
        self._take_away(lambda: self._take_out(gone, REMOVED))
        return str(label)

    def _take_away(self, change: Callable[[], None]) -> None:
        """Make a change, and book the springs of the contacts that it ends."""
        if not self.engine.model.booked:
            change()
            return
        before = held_energy(self.engine)
        change()
        take_springs(self.engine, before - held_energy(self.engine))

    def _drop(self) -> None:
        """Count and drop discs wholly below the floor that touch nothing any more."""
        self.over.look(self.engine)
        gone = below(self.engine, self.floor)
        if not gone.any():
            return
        beside = gone & self.over.went[self.engine.labels]
        labels = self.engine.labels.copy()
        if not self.engine.space.passed:
            self.recording.passed += drawn(self.engine, gone & ~beside, self.outlet_at)
        for way, which in ((DISCHARGED, labels[gone & ~beside]), (SPILT, labels[beside])):
            if len(which):
                self._take_out(np.isin(self.engine.labels, which), way)

    def _feed(self) -> None:
        """Let the feeder take what is due."""
        if self.feeder and (gone := self.feeder.take(self.engine, self.check * self.engine.model.dt)).any():
            self.recording.passed += drawn(self.engine, gone, self.outlet_at)
            self._take_away(lambda: self._take_out(gone, DISCHARGED))

    def _take_out(self, gone: np.ndarray, way: str) -> None:
        record = self.recording
        record.left[way] += int(gone.sum())
        record.lost[way] += float(self.engine.mass[gone].sum())
        if way == DISCHARGED:
            record.passed += self.passing(gone)
        carry_out(self.engine, gone)
        keep_discs(self.engine, ~gone)
        if way == DISCHARGED:
            record.discharge_time.append(self.engine.time)
            record.discharged.append(self.dropped)

    def passing(self, which: np.ndarray) -> list[tuple[float, float, int]]:
        """Times (s) at which bodies among those left came below the outlet since the run began, each with mass and outlet."""
        return passing(self.engine, which, self.outlet_at, self.began)

    def _close_window(self) -> None:
        """Keep the window of wall forces up to now, the last of a run also where it is not full."""
        steps = (self.engine.step - self.opened) / self.engine.ticks
        if not self.window or not steps:
            return
        window = self.engine.record.window.copy()
        window[:, :, 0] /= steps
        self.recording.window_time.append(self.engine.time)
        self.recording.window.append(window)
        self.recording.whole.append(self.engine.record.whole[:, :, 1:].copy())
        if self.engine.model.moving:
            self.recording.motion.append(self.engine.space.motion_of(self.engine.walls.shape))
        self.recording.energy.append(self.engine.ledger.account[: len(ENTRIES)].copy())
        self.engine.clear_window()
        self.opened = self.engine.step

    def checkpoint(self) -> dict:
        """Everything that going on depends on: the engine's arrays, where the events stand, and what was recorded."""
        stand = {name: getattr(self, name) for name in ("next_event", "since", "opened", "over", *CARRIED)}
        fed = self.feeder.stand if self.feeder else None
        return {"engine": checkpoint(self.engine), "stand": stand, "recording": self.recording, "fed": fed}

    def restore(self, saved: dict) -> None:
        """Go on from a checkpoint of the same scene."""
        restore(self.engine, saved["engine"])
        vars(self).update(saved["stand"])
        self.recording = saved["recording"]
        if self.feeder:
            self.feeder.stand = saved["fed"]
