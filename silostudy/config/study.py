"""A parametric study as a user writes it: axes, and the keys of every kind of study."""

from functools import cached_property
from itertools import pairwise
from pathlib import Path
from typing import Any, ClassVar, Literal, Self, TypeAlias

from pydantic import field_validator, model_validator

from silostudy.config.fields import Strict, ValueRange, described, expand
from silostudy.config.sample import SampleConfig
from silostudy.stages import called_for
from silostudy.tables.outputs import OUTPUTS
from silostudy.tables.references import own_files

OutputKey: TypeAlias = Literal[tuple(OUTPUTS)]  # type: ignore[valid-type]
TAKEN = ("pressure_method", "phase", "depth", "relative_depth", "hopper_position", "case", "rule")
FILLING = "filling"  # name of the axis of fillings
KEYWORDS = ("method", "tolerance", "drop", "indexers")  # of xarray's sel: a dimension of such a name cannot be selected by it


class Axis(Strict):
    """One axis of a sweep: one key with its values, several keys that change together, a list of points, or a sample."""

    axis: str = described("name of the axis: a dimension of the cube", "", pattern=r"^[a-z][a-z0-9_]*$")
    values: dict[str, ValueRange | tuple[Any, ...]] | None = described(
        "dotted key of the scene -> its values; several keys of equal length change together (paired)",
        "",
        default=None,
        min_length=1,
    )
    points: tuple[dict[str, Any], ...] | None = described(
        "list of points, each a set of dotted keys with one value", "", default=None, min_length=1
    )
    sample: SampleConfig | None = described("a sampled plan, where the grid of several keys is too large", "", default=None)

    @field_validator("axis")
    @classmethod
    def _free_name(cls, name: str) -> str:
        if name in TAKEN:
            raise ValueError(f"this name is the cube's own; not one of {', '.join(TAKEN)}")
        if name in KEYWORDS:
            raise ValueError(f"this name is a keyword of xarray's; not one of {', '.join(KEYWORDS)}")
        return name

    @model_validator(mode="after")
    def _one_kind(self) -> Self:
        if sum(form is not None for form in (self.values, self.points, self.sample)) != 1:
            raise ValueError("give either values, points or a sample, and one of them alone")
        lengths = {key: len(expand(values)) for key, values in (self.values or {}).items()}
        if 0 in lengths.values() or len(set(lengths.values())) > 1:
            raise ValueError(f"keys that change together need equally many values (one at least), not {lengths}")
        for key, values in (self.values or {}).items():
            listed = expand(values)
            if len(lengths) == 1 and len({repr(value) for value in listed}) < len(listed):
                raise ValueError(f"{key} holds a value twice")
            if len(lengths) == 1 and not _steady(listed):
                raise ValueError(f"the numbers of {key} must all rise or all fall, as a coordinate's do")
        if self.points is not None and len({frozenset(point) for point in self.points}) > 1:
            raise ValueError("every point must set the same keys")
        return self

    def settings(self) -> list[dict[str, Any]]:
        """The keys and values of each position on the axis."""
        return self._positions

    @cached_property
    def _positions(self) -> list[dict[str, Any]]:
        if self.points is not None:
            return [dict(point) for point in self.points]
        if self.sample is not None:
            return self.sample.settings()
        columns = {key: expand(values) for key, values in (self.values or {}).items()}
        return [dict(zip(columns, row, strict=True)) for row in zip(*columns.values(), strict=True)]


def _steady(values: list) -> bool:
    """Whether numbers rise or fall throughout (CF asks it of a coordinate); text has no order to keep."""
    if not all(isinstance(value, (int, float)) for value in values):
        return True
    steps = [b > a for a, b in pairwise(values)]
    return all(steps) or not any(steps)


class BaseStudy(Strict):
    """Base of every kind of study; `kind` tells them apart."""

    unasked: ClassVar[str] = "none of its settings decides a numerical error"  # why this kind may not ask for an accuracy

    kind: str
    title: str = described("one line for figures and reports", "", min_length=1)
    description: str = described("what the study is for, and which of its values are assumed", "", default="")
    scene: Strict
    sweep: tuple[Axis, ...] = described("axes; every combination is a case", "", default=())
    outputs: tuple[OutputKey, ...] = described("figures and tables to make (`silostudy list outputs`)", "", default=())

    @model_validator(mode="before")
    @classmethod
    def _may_ask(cls, content: Any) -> Any:
        if isinstance(content, dict) and "accuracy" in content and "accuracy" not in cls.model_fields:
            raise ValueError(f"a study of kind {content.get('kind')} cannot ask for an accuracy: {cls.unasked}")
        return content

    @classmethod
    def scene_model(cls, scene: dict[str, Any], where: str) -> Any:
        """The model of the content of its scene, or a union of models none of which takes rows of the user's own."""
        return cls.model_fields["scene"].annotation

    def _without_scatter(self) -> bool:
        """Whether the study has an axis of fillings, but one filling alone."""
        return any(axis.axis == FILLING and len(axis.settings()) < 2 for axis in self.sweep)

    @property
    def stages(self) -> tuple[str, ...]:
        """The cubes that the study asks for, in order: results/<study>/<stage>.nc, each by a sub-command of that name."""
        return called_for(self)

    def named_files(self, folder: Path) -> tuple[Path, ...]:
        """Files of the user's own that the study names, with the references beside them."""
        return own_files(folder, getattr(self, "materials", None), getattr(self, "methods_from", None))

    @field_validator("outputs")
    @classmethod
    def _no_twin(cls, keys):
        return distinct(keys)

    @field_validator("sweep")
    @classmethod
    def _distinct_axes(cls, axes):
        names = [axis.axis for axis in axes]
        keys = [key for axis in axes for key in axis.settings()[0]]
        for what, items in (("axis name", names), ("key", keys)):
            twins = sorted({item for item in items if items.count(item) > 1})
            if twins:
                raise ValueError(f"{what} {', '.join(twins)} is swept twice")
        return axes

    @model_validator(mode="after")
    def _outputs_can_be_drawn(self) -> Self:
        axes = {axis.axis for axis in self.sweep}
        for key in self.outputs:
            row = OUTPUTS[key]
            missing = set(row.axes) - axes
            if row.stage not in self.stages:
                raise ValueError(f"output {key} is drawn from a {row.stage} cube; this study computes {', '.join(self.stages)}")
            if missing or (row.single_case and axes):
                wanted = f"the axes {', '.join(row.axes)}" if missing else "a study without sweep"
                raise ValueError(f"output {key} needs {wanted}")
            if row.only_axes and axes - set(row.axes):
                raise ValueError(f"output {key} can show no axes but {', '.join(row.axes)}")
            if FILLING in row.axes and self._without_scatter():
                raise ValueError(f"output {key} needs two values at least on the axis {FILLING}: of one no scatter is known")
        return self


class SweepStudy(BaseStudy):
    """A study whose cases are costly: computed in parts, each case once, failed cases masked."""

    part_s: float = described("about how much work one job does", "s", gt=0, default=120.0)
    case_s: float | None = described("measured time of a case; null: from discs and steps", "s", gt=0, default=None)

    @property
    def settings(self) -> str:
        """Whatever of the study, besides its scene, the numbers of a case depend on (canonical JSON)."""
        return self.model_dump_json(exclude={*SweepStudy.model_fields})


def distinct(keys):
    """The keys themselves; ValueError where one stands twice."""
    twins = sorted({key for key in keys if keys.count(key) > 1}) if isinstance(keys, tuple) else []
    if twins:
        raise ValueError(f"holds a key twice: {', '.join(twins)}")
    return keys
