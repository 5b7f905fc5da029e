"""A load case of a loads cube as a field: pressure and friction of the contents at any depth and angle, edges not smeared.

    load = load_case("results/eccentric-silo/loads.nc", "channel_40", "wall_normal")
    normal, traction = load.stress(z, theta)  # Pa; z (m) below the equivalent surface, theta (rad) from the outlet's side

The wall and below it the hopper's are sums of pieces, each straight between its levels and smooth within its angles.
"""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import xarray as xr

from silostudy.cube.io import read
from silostudy.errors import BadInput, unknown

ENDS = 2  # of a piece round the wall: it stands on both sides of the angle 0


@dataclass(frozen=True)
class Piece:
    """Part of a load: values times cos(waves theta) from one angle (rad) to another on both sides, over its levels (m).

    A piece holds its first level and angle and not its last one, unless `last`: then the wall or the circle ends there.  Where
    wall and hopper meet, the level is the wall's.
    """

    name: str
    depth: np.ndarray
    normal: np.ndarray
    traction: np.ndarray
    angle_from: float
    angle_to: float
    waves: int
    last: bool
    on_hopper: bool = False

    def stress(self, z: np.ndarray, theta: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Pressure and friction (Pa) of this piece, 0 outside of it; theta between 0 and pi."""
        ends_here = (z == self.depth[-1]) if self.last else False
        begins = z > self.depth[0] if self.on_hopper else z >= self.depth[0]
        level = begins & ((z < self.depth[-1]) | ends_here)
        angle = (theta >= self.angle_from) & ((theta < self.angle_to) | (self.angle_to >= np.pi))
        share = np.where(level & angle, np.cos(self.waves * theta), 0.0)
        normal, traction = (np.interp(z, self.depth, values) for values in (self.normal, self.traction))
        return share * normal, share * traction

    def around(self) -> tuple[float, float]:
        """Integral of the share over the angle (rad), and the same times cos(theta), both sides."""
        if self.waves == 0:
            return ENDS * (self.angle_to - self.angle_from), ENDS * (np.sin(self.angle_to) - np.sin(self.angle_from))
        ends = np.array([self.angle_from, self.angle_to])
        sine, square = np.diff(np.sin(ends))[0], np.diff(ends / 2 + np.sin(2 * ends) / 4)[0]
        return ENDS * float(sine), ENDS * float(square)


@dataclass(frozen=True)
class Load:
    """A load case with one set of characteristic values on a silo, and its shape (m, rad); half_angle NaN: a flat floor.

    bottom_force: downward force (N) on the floor, or through the outlet.
    """

    title: str
    pieces: tuple[Piece, ...]
    radius: float
    perimeter: float
    transition: float
    half_angle: float
    weight: float
    bottom_force: float

    def stress(self, z, theta) -> tuple[np.ndarray, np.ndarray]:
        """Wall normal pressure and friction (Pa) down the wall at depth z (m) and angle theta (rad); 0 where nothing is."""
        z, theta = np.broadcast_arrays(np.asarray(z, dtype=float), np.asarray(theta, dtype=float))
        turned = np.abs(theta)
        turned = np.where(turned > np.pi, np.abs(np.remainder(theta + np.pi, 2 * np.pi) - np.pi), turned)
        stresses = [piece.stress(z, turned) for piece in self.pieces]
        normal, traction = np.sum(stresses, axis=0)
        return normal, traction

    def radius_at(self, z) -> np.ndarray:
        """Inner radius (m) at depth z (m): of the hopper below the transition."""
        below = np.maximum(np.asarray(z, dtype=float) - self.transition, 0.0)
        return self.radius - below * (0.0 if np.isnan(self.half_angle) else np.tan(self.half_angle))

    def vertical_force(self, *, hopper: bool) -> float:
        """Downward force (N) on the cylinder's wall, or on the hopper's."""
        return sum(self._down(piece) for piece in self.pieces if piece.on_hopper == hopper)

    def _down(self, piece: Piece) -> float:
        around, slope = piece.around()[0] / (2 * np.pi), np.tan(self.half_angle) if piece.on_hopper else 0.0
        pushed = piece.normal * slope + piece.traction
        return around * self._integral(piece.depth, pushed) * self.perimeter / self.radius

    def horizontal_force(self) -> float:
        """Horizontal force (N) of the pressures on the cylinder's wall, towards the angle 0."""
        return sum(self._sideways(piece, 1.0) for piece in self.pieces if not piece.on_hopper)

    def overturning_moment(self) -> float:
        """Moment (N m) of the horizontal force about the transition."""
        return sum(self._sideways(piece, self.transition - piece.depth) for piece in self.pieces if not piece.on_hopper)

    def _sideways(self, piece: Piece, lever) -> float:
        return piece.around()[1] * self._integral(piece.depth, piece.normal, lever)

    def _integral(self, z: np.ndarray, values: np.ndarray, lever=1.0) -> float:
        """Integral of values over depth times radius and lever: exact for what is straight between levels."""
        arm = self.radius_at(z) * lever
        upper, lower, wide, narrow = values[:-1], values[1:], arm[:-1], arm[1:]
        return float(np.sum(np.diff(z) / 6 * (2 * upper * wide + upper * narrow + lower * wide + 2 * lower * narrow)))

    def grid(self, *, levels: int, step: float) -> tuple[np.ndarray, np.ndarray]:
        """Depths (m) and angles (rad) of a table: both sides of every edge, so many levels on wall and hopper between them, and
        an angle every `step` where the load waves round the wall."""
        depths, angles = self.edges()
        between = [np.linspace(piece.depth[0], piece.depth[-1], levels) for piece in self.pieces if piece.last]
        waving = any(piece.waves for piece in self.pieces)
        round_it = np.linspace(0.0, np.pi, round(np.pi / step) + 1) if waving else np.array([])
        return _with_sides(np.concatenate([depths, *between]), depths), _with_sides(np.append(angles, round_it), angles)

    def columns(self, *, levels: int, step: float) -> dict[str, np.ndarray]:
        """Columns of a table over the grid: depth (m), angle (deg), inner radius (m), pressure and friction (kPa)."""
        depths, angles = self.grid(levels=levels, step=step)
        z, theta = (grid.ravel() for grid in np.meshgrid(depths, angles, indexing="ij"))
        normal, traction = self.stress(z, theta)
        columns = {"depth_m": z, "angle_deg": np.degrees(theta), "radius_m": self.radius_at(z)}
        return columns | {"normal_kPa": normal / 1e3, "friction_kPa": traction / 1e3}

    def edges(self) -> tuple[np.ndarray, np.ndarray]:
        """Depths (m) and angles (rad) at which the load steps or bends: ends of pieces, for the lines of a mesh."""
        depths = {float(end) for piece in self.pieces for end in (piece.depth[0], piece.depth[-1])}
        angles = {end for piece in self.pieces for end in (piece.angle_from, piece.angle_to)}
        return np.array(sorted(depths)), np.array(sorted(angles))


def _with_sides(values: np.ndarray, edges: np.ndarray) -> np.ndarray:
    """All values, increasing, and beside each inner edge the last number before it and, where pieces end on it, after it."""
    inner = edges[1:-1]
    return np.unique(np.concatenate([values, np.nextafter(inner, -np.inf), np.nextafter(inner, np.inf)]))


def load_case(cube: xr.Dataset | Path | str, load_case: str, values: str, case: str | None = None) -> Load:
    """One load case with one set of characteristic values out of a loads cube or its file; case: of a sweep, its id."""
    cube = cube if isinstance(cube, xr.Dataset) else read(Path(cube))
    if "load_normal_pressure" not in cube:
        raise BadInput("cube", cube.attrs["title"], f"must be a loads cube; it is of the stage {cube.attrs.get('stage')}")
    case_cube = of_case(cube, case)
    given = given_cases(case_cube)
    if load_case not in given:
        raise unknown("load case", load_case, given)
    if values not in given[load_case]:
        raise unknown(f"set of characteristic values of {load_case}", values, given[load_case])
    return _load(case_cube.sel(load_case=load_case, value_set=values))


def of_case(cube: xr.Dataset, case: str | None) -> xr.Dataset:
    """The silo of a sweep by its id; BadInput lists the known ones."""
    axes = cube.attrs["sweep_axes"].split()
    if not axes and case is None:
        return cube
    ids = cube["case"].values.astype(str)
    if case not in ids:
        raise unknown("case", case, dict.fromkeys(ids.ravel()))
    return cube.isel(dict(zip(axes, map(int, np.argwhere(ids == case)[0]), strict=True)))


def given_cases(case_cube: xr.Dataset) -> dict[str, list[str]]:
    """Load case -> the sets of characteristic values that its field is given with, of one silo."""
    there = case_cube["load_angle_to"].notnull().any("load_piece").transpose("load_case", "value_set").values
    sets = case_cube["value_set"].values
    return {
        str(key): list(map(str, sets[row])) for key, row in zip(case_cube["load_case"].values, there, strict=True) if row.any()
    }


def _load(loaded: xr.Dataset) -> Load:
    transition = float(loaded["load_transition_depth"])
    there = [place for place in range(loaded.sizes["load_piece"]) if np.isfinite(float(loaded["load_angle_to"][place]))]
    pieces = tuple(_piece(loaded.isel(load_piece=place), transition) for place in there)
    numbers = {name: float(loaded[f"load_{name}"]) for name in ("radius", "perimeter", "half_angle", "weight", "bottom_force")}
    title = f"{loaded['load_case_title'].values}, {loaded['value_set'].values}"
    return Load(title=title, pieces=pieces, transition=transition, **numbers)


def _piece(piece_cube: xr.Dataset, transition: float) -> Piece:
    names = {"depth": "load_depth", "normal": "load_normal_pressure", "traction": "load_friction_traction"}
    arrays = {key: piece_cube[name].values for key, name in names.items()}
    below = bool(arrays["depth"][0] >= transition)
    return Piece(
        name=str(piece_cube["load_piece"].values),
        **arrays,
        angle_from=float(piece_cube["load_angle_from"]),
        angle_to=float(piece_cube["load_angle_to"]),
        waves=int(piece_cube["load_waves"]),
        last=below or bool(arrays["depth"][-1] == transition),
        on_hopper=below,
    )
