"""The one place where a cube comes together: arrays by name, where they come from, and the check of the contract."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any, Protocol

import numpy as np
import xarray as xr

from silostudy.cube.contract import SCOPE, check, variable
from silostudy.cube.provenance import provenance
from silostudy.cube.variables import attributes
from silostudy.errors import BadInput

Arrays = Mapping[str, Any]  # name of the contract -> values, or (values, attributes in place of the contract's)


class Titled(Protocol):
    """A study or a scene: what a cube answers."""

    @property
    def title(self) -> str: ...

    def model_dump_json(self, *, exclude_defaults: bool) -> str: ...


@dataclass(frozen=True)
class Sweep:
    """The axes of a study: their xarray coordinates, and where they are known the ids of its cases, shape (axes...)."""

    axes: tuple[str, ...] = ()
    coordinates: Mapping[str, tuple] = field(default_factory=dict)
    cases: np.ndarray | None = None


def assemble(
    asked: Titled,
    stage: str,
    arrays: Arrays,
    *,
    sources: Iterable[str],
    notes: Mapping[str, Any] | None = None,
    sweep: Sweep = Sweep(),
) -> xr.Dataset:
    """The checked cube of arrays, whose dimensions, units and roles are the contract's.

    sources: references of the rows used; notes: further attributes of the cube.
    """
    whole = arrays if sweep.cases is None else {**arrays, "case": sweep.cases}
    if twins := sweep.coordinates.keys() & whole.keys():
        raise BadInput(
            "axis", ", ".join(sorted(twins)), f"the {stage} cube has a variable of this name: name the axis otherwise"
        )
    relative = "relative_depth" in whole
    held: dict[str, dict[str, tuple]] = {"coordinate": dict(sweep.coordinates), "data": {}}
    for name, given in whole.items():
        known = variable(name)
        values, told = given if isinstance(given, tuple) else (given, attributes(name, whole))
        dims = known.dims_in(sweep.axes, relative=relative)
        held[known.role if known.name == name else "data"][name] = (dims, values, {**told, **_beside(name, dims, whole)})
    about = provenance(asked.title, asked.model_dump_json(exclude_defaults=True), sources, stage)
    own = {"sweep_axes": " ".join(sweep.axes), **(notes or {})}
    return check(xr.Dataset(held["data"], held["coordinate"], {**about, **own}))


def _beside(name: str, dims: tuple[str, ...], arrays: Arrays) -> dict[str, str]:
    """Attributes that depend on the rest of the cube: whose scope is told, and which depth is an axis of its own."""
    attributes = {"ancillary_variables": name + SCOPE} if name + SCOPE in arrays else {}
    return attributes | ({"axis": "Z"} if name == "depth" and dims == ("depth",) else {})
