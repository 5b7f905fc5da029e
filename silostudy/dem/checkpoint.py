"""Checkpoints: everything that the next step depends on, taken out of an engine and put back."""

import numpy as np

from silostudy.dem.arrays import Memory
from silostudy.dem.change import keep_discs
from silostudy.dem.contacts import Contact
from silostudy.dem.engine import Engine
from silostudy.dem.varied import Varied


def checkpoint(engine: Engine) -> dict[str, np.ndarray]:
    """Everything that the next step depends on, as arrays by name."""
    pairs, near = engine.take_memories()
    memories = {f"pair_{k}": v for k, v in pairs._asdict().items()} | {f"wall_{k}": v for k, v in near._asdict().items()}
    return memories | {
        "step": np.array(engine.step),
        "ticks": np.array([engine.ticks, engine.past]),
        "rows": engine.bodies.rows[: engine.n].copy(),
        "held": engine.bodies.held[: engine.n].copy(),
        "label": engine.labels.copy(),
        "live": engine.walls.live.copy(),
        "shape": engine.walls.shape.copy(),
        "drive": engine.walls.drive.copy(),
        "gravity": np.array(engine.gravity),
        "window": engine.record.window.copy(),
        "whole": engine.record.whole.copy(),
        "account": engine.ledger.account.copy(),
        "coefficients": np.array(
            [
                value
                for contact in engine.contacts
                for coefficients in contact.sets
                for law in coefficients.ordered
                for value in law
            ]
        ),
    }


def restore(engine: Engine, saved: dict[str, np.ndarray]) -> None:
    """Go on from a checkpoint of the same model."""
    engine.n = engine.most  # those that wait count, for they may have come in by then
    staying = np.isin(engine.labels, saved["label"])
    keep_discs(engine, staying)
    engine.clock[0] = int(saved["step"])
    engine.ticks, engine.past = map(int, saved["ticks"])
    engine.bodies.rows[: engine.n] = saved["rows"]
    engine.bodies.held[: engine.n] = saved["held"]
    for name in ("live", "shape", "drive"):
        getattr(engine.walls, name)[:] = saved[name]
    engine.record.window[:], engine.record.whole[:] = saved["window"], saved["whole"]
    engine.ledger.account[:] = saved["account"]
    engine.gravity = tuple(float(part) for part in saved["gravity"])
    engine.contacts = _contacts_from(engine, list(saved["coefficients"]))
    memories = [Memory(*(saved[f"{kind}_{name}"] for name in Memory._fields)) for kind in ("pair", "wall")]
    engine.give_memories(*memories)


def _contacts_from(engine: Engine, values: list) -> tuple[Contact | Varied, Contact | Varied]:
    contacts = []
    for contact in engine.contacts:
        names = [coefficient.name for row in contact.rows for coefficient in row.coefficients]
        sets = tuple(coefficients.changed({name: float(values.pop(0)) for name in names}) for coefficients in contact.sets)
        contacts.append(Varied(sets) if isinstance(contact, Varied) else sets[0])
    return contacts[0], contacts[1]
