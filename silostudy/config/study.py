"""What a user writes to ask for a parametric study."""

from typing import Any, Literal, Self

from pydantic import Field, field_validator, model_validator

from silostudy.config.fields import Numbers, Range, Strict, described, expand
from silostudy.config.scene import SceneConfig
from silostudy.figures import OUTPUTS
from silostudy.pressure import PRESSURE
from silostudy.pressure.family import PHASES

MethodKey = Literal[tuple(PRESSURE)]  # type: ignore[valid-type]
PhaseKey = Literal[PHASES]  # type: ignore[valid-type]
OutputKey = Literal[tuple(OUTPUTS)]  # type: ignore[valid-type]
TAKEN = ("method", "phase", "depth", "relative_depth", "case")


class Axis(Strict):
    """One axis of a sweep: one key with its values, several keys that change together, or a list of points."""

    axis: str = described("name of the axis: a dimension of the cube", "", pattern=r"^[a-z][a-z0-9_]*$")
    values: dict[str, Range | tuple[Any, ...]] | None = described(
        "dotted key of the scene -> its values; several keys of equal length change together (paired)",
        "",
        default=None,
        min_length=1,
    )
    points: tuple[dict[str, Any], ...] | None = described(
        "list of points, each a set of dotted keys with one value", "", default=None, min_length=1
    )

    @field_validator("axis")
    @classmethod
    def _free_name(cls, name: str) -> str:
        if name in TAKEN:
            raise ValueError(f"this name is the cube's own; not one of {', '.join(TAKEN)}")
        return name

    @model_validator(mode="after")
    def _one_kind(self) -> Self:
        if (self.values is None) == (self.points is None):
            raise ValueError("give either values or points, and not both")
        lengths = {key: len(expand(values)) for key, values in (self.values or {}).items()}
        if 0 in lengths.values() or len(set(lengths.values())) > 1:
            raise ValueError(f"keys that change together need equally many values (one at least), not {lengths}")
        for key, values in (self.values or {}).items():
            listed = expand(values)
            if len(lengths) == 1 and len({repr(value) for value in listed}) < len(listed):
                raise ValueError(f"{key} holds a value twice")
        if self.points is not None and len({frozenset(point) for point in self.points}) > 1:
            raise ValueError("every point must set the same keys")
        return self

    def settings(self) -> list[dict[str, Any]]:
        """The keys and values of each position on the axis."""
        if self.points is not None:
            return [dict(point) for point in self.points]
        columns = {key: expand(values) for key, values in (self.values or {}).items()}
        return [dict(zip(columns, row, strict=True)) for row in zip(*columns.values(), strict=True)]


class Study(Strict):
    """One parametric study: a base scene, the axes swept, the methods asked, and what to draw."""

    title: str = described("one line for figures and reports", "", min_length=1)
    description: str = described("what the study is for, and which of its values are assumed", "", default="")
    materials: str | None = described(
        "CSV file with further solids, relative to the study file, in the columns of the solids table", "", default=None
    )
    scene: SceneConfig = described("the base scene", "")
    sweep: tuple[Axis, ...] = described("axes; every combination is a case", "", default=())
    methods: tuple[MethodKey, ...] | Literal["all"] = described("pressure methods, or all", "")
    as_printed: tuple[MethodKey, ...] = described(
        "methods to give a second time with the source's misprints left in", "", default=()
    )
    phases: tuple[PhaseKey, ...] = Field(default=PHASES, min_length=1, description="phases of operation")
    depth_m: Range | Numbers | None = described("depths below the equivalent surface", "m", default=None)
    relative_depth: Range | Numbers | None = described(
        "depths over the depth of the transition below the equivalent surface, 0 ... 1", default=None
    )
    outputs: tuple[OutputKey, ...] = described("figures and tables to make (`silostudy list outputs`)", "", default=())

    @field_validator("methods")
    @classmethod
    def _some_method(cls, methods):
        if not methods:
            raise ValueError(f"a study needs a method; known: {', '.join(PRESSURE)}")
        return methods

    @field_validator("methods", "as_printed", "phases", "outputs")
    @classmethod
    def _no_twin(cls, keys):
        if isinstance(keys, tuple) and len(set(keys)) < len(keys):
            raise ValueError("holds a key twice")
        return keys

    @field_validator("as_printed")
    @classmethod
    def _has_misprint(cls, keys):
        for key in keys:
            if not PRESSURE[key].has_misprint:
                known = ", ".join(k for k, row in PRESSURE.items() if row.has_misprint)
                raise ValueError(f"{key} has no misprint in the source; known: {known}")
        return keys

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

    @field_validator("depth_m", "relative_depth")
    @classmethod
    def _increasing(cls, depths):
        listed = expand(depths) if depths is not None else []
        if any(b <= a for a, b in zip(listed, listed[1:], strict=False)):
            raise ValueError("depths must increase, none twice")
        if listed and listed[0] < 0:
            raise ValueError("depths must not be negative")
        return depths

    @model_validator(mode="after")
    def _one_depth_axis(self) -> Self:
        if (self.depth_m is None) == (self.relative_depth is None):
            raise ValueError("give either depth_m or relative_depth, and not both")
        if self.relative_depth is not None and expand(self.relative_depth)[-1] > 1:
            raise ValueError("relative_depth ends at 1, the transition")
        return self

    @model_validator(mode="after")
    def _outputs_can_be_drawn(self) -> Self:
        axes = {axis.axis for axis in self.sweep}
        for key in self.outputs:
            missing = set(OUTPUTS[key].axes) - axes
            if missing or (OUTPUTS[key].single_case and axes):
                wanted = f"the axes {', '.join(OUTPUTS[key].axes)}" if missing else "a study without sweep"
                raise ValueError(f"output {key} needs {wanted}")
            without = set(OUTPUTS[key].methods) - set(self.method_keys)
            if without:
                raise ValueError(f"output {key} needs the methods {', '.join(sorted(without))}")
        return self

    @property
    def method_keys(self) -> tuple[str, ...]:
        """The methods asked for, in order."""
        return tuple(PRESSURE) if self.methods == "all" else self.methods
