"""Numbers that a scene expects of its run, beside what the run came to."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from silostudy.compute.sphere_cube import load_at_end
from silostudy.config.grain_scenes import AnyScene
from silostudy.dem.outcomes import OUTCOMES, Looks, Outcome
from silostudy.dem.run import Run


@dataclass(frozen=True)
class Verdict:
    """A published number of a quantity, how far a run may be off, and what the run came to; all in the quantity's unit."""

    quantity: Outcome
    value: float
    tolerance: float
    computed: float
    source: str

    @property
    def met(self) -> bool:
        """Whether the run came as near as it must."""
        return abs(self.computed - self.value) <= self.tolerance

    @property
    def digits(self) -> int:
        """Number of digits that show the tolerance."""
        size = abs(self.value) / self.tolerance
        return max(4, 2 + int(np.ceil(np.log10(size)))) if size > 0.0 else 4

    def __str__(self) -> str:
        told = f"{self.quantity.key} {self.computed:.{self.digits}g} {self.quantity.unit}"
        if np.isnan(self.computed):
            told = f"{self.quantity.key} not seen in this run"
        met = "met" if self.met else "not met"
        return f"{told}; published {self.value:.{self.digits}g} +- {self.tolerance:.3g} ({self.source}): {met}"


def verdicts(run: Run, scene: AnyScene) -> list[Verdict]:
    """Verdict on each number that the scene expects."""
    return verdicts_on(looks_of(run), scene)


def verdicts_on(looks: Looks, scene: AnyScene) -> list[Verdict]:
    """The same of a record that may be another code's."""
    return [_verdict(looks, asked) for asked in scene.expected]


def notes_of(verdicts: list[Verdict]) -> dict[str, Any]:
    """Attributes of a cube: each quantity found, published, and its tolerance; one that is expected again has a number."""
    parts = {"found": "computed", "published": "value", "tolerance": "tolerance"}
    notes: dict[str, Any] = {}
    for number, verdict in enumerate(verdicts):
        again = sum(other.quantity is verdict.quantity for other in verdicts[:number])
        row = f"{verdict.quantity.key.replace('-', '_')}{f'_{again + 1}' if again else ''}_{verdict.quantity.suffix}"
        notes |= {f"{name}_{row}": float(getattr(verdict, part)) for name, part in parts.items()}
    return notes


def _verdict(looks: Looks, asked: Any) -> Verdict:
    row = OUTCOMES[asked.kind]
    arguments = {field.argument: getattr(asked, field.name) for field in row.asks if field.argument}
    value, tolerance = (getattr(asked, f"{name}_{row.suffix}") for name in ("value", "tolerance"))
    return Verdict(row, value, tolerance, row.find(looks, **arguments), f"{asked.source}, {asked.locator}")


def looks_of(run: Run) -> Looks:
    """The run's record, as quantities are computed from it."""
    record, engine = run.recording, run.engine
    weight = np.asarray(engine.gravity, float)
    return Looks(
        places=tuple(snapshot["motion"][:, : engine.space.ways] for snapshot in record.snapshots),
        radii=tuple(np.asarray(engine.model.radius)[snapshot["label"]] for snapshot in record.snapshots),
        times=tuple(float(snapshot["time"]) for snapshot in record.snapshots),
        left_time=np.array(record.discharge_time),
        left_mass=np.array(record.discharged),
        load=load_at_end(run) if engine.space.ways == 3 else np.nan,
        up=-weight / np.linalg.norm(weight) if weight.any() else weight,
    )
