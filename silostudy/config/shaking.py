"""Shaking of a box of grains as a user writes it."""

from typing import Literal, Self, TypeAlias

from pydantic import model_validator

from silostudy.config.fields import Strict, described
from silostudy.tables.records import RECORDS

RecordKey: TypeAlias = Literal[tuple(RECORDS)]  # type: ignore[valid-type]


class Shaking(Strict):
    """Horizontal acceleration of the box: a sine, or a record."""

    amplitude_gal: float = described("amplitude of the sine, or peak of the record", "gal", gt=0)
    frequency_Hz: float | None = described("frequency of the sine", "Hz", gt=0, default=None)
    record: RecordKey | None = described("a record at hand, in place of frequency_Hz", "", default=None)
    time_compression: float = described("how many times as fast to run the record", gt=0, default=1.0)

    @model_validator(mode="after")
    def _one(self) -> Self:
        if (self.frequency_Hz is None) == (self.record is None):
            raise ValueError("give either frequency_Hz or record, and not both")
        return self
