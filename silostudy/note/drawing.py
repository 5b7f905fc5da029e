"""Drawings of the note as SVG text: the silo with its sizes, and loads over depth beside it on the same scale."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from html import escape

import numpy as np
import xarray as xr

from silostudy.note.mathml import rounded

# of the picture's height
TOP = 40.0  # margin above
DOWN = 370.0  # what the silo takes
SIZE = 14  # of words: 12 px on the page, which shows the picture somewhat smaller
PHASES = {"filling": ("#0072B2", "0"), "discharge": ("#D55E00", "6 3")}  # colour, dashes


@dataclass(frozen=True)
class Scale:
    """Scale from metres below the equivalent surface to places in the picture."""

    highest: float
    lowest: float

    def y(self, z: float) -> float:
        """Height in the picture of a depth (m)."""
        return TOP + DOWN * (z - self.highest) / (self.lowest - self.highest)

    @property
    def per_metre(self) -> float:
        """Length in the picture of a metre."""
        return DOWN / (self.lowest - self.highest)


def line(x1: float, y1: float, x2: float, y2: float, **look: str) -> str:
    """A straight line."""
    return f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" {_look(look)}/>'


def path(points: Sequence[tuple[float, float]], **look: str) -> str:
    """A line through points."""
    return f'<polyline points="{" ".join(f"{x:.1f},{y:.1f}" for x, y in points)}" fill="none" {_look(look)}/>'


def text(x: float, y: float, content: str, anchor: str = "middle", **look: str) -> str:
    """A word."""
    below = '<tspan dy="3" font-size="75%">{}</tspan><tspan dy="-3">\u200b</tspan>'
    told = re.sub(r"\b(\w)_(\w+)", lambda match: match[1] + below.format(match[2]), escape(content))
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" {_look(look)}>{told}</text>'


def _look(look: dict[str, str]) -> str:
    given = {"stroke": "#222", "stroke-width": "1"} | look if "font_size" not in look else look
    return " ".join(f'{key.replace("_", "-")}="{value}"' for key, value in given.items())


def _word(x: float, y: float, content: str, anchor: str = "middle") -> str:
    return text(x, y, content, anchor, font_size=str(SIZE), fill="#222")


def picture(cube: xr.Dataset, checks: xr.Dataset | None) -> str:
    """The silo, then wall pressure, wall friction and axial force over its depth; one: a silo by one method, all phases."""
    first = cube.isel(phase=0)
    scale = _scale(first)
    middle, parts = 140.0, []
    parts += _silo(first, checks, scale, middle)
    for number, (name, label, unit) in enumerate(
        (("wall_normal_pressure", "p_h", "kPa"), ("wall_friction_traction", "p_w", "kPa"), ("axial_wall_force", "n_z", "kN/m"))
    ):
        parts += _panel(cube, name, f"{label} ({unit})", scale, 330.0 + 140 * number)
    legend = [_legend(key, 330.0 + 120 * k, TOP + DOWN + 34) for k, key in enumerate(PHASES) if key in cube["phase"].values]
    return _svg(760, TOP + DOWN + 48, [*parts, *legend])


def _svg(width: float, height: float, parts: Sequence[str]) -> str:
    head = (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height:.0f}" role="img" font-family="sans-serif">'
    )
    return head + "".join(parts) + "</svg>"


def _scale(first: xr.Dataset) -> Scale:
    depth, contact = float(first["cylinder_depth"]), float(first["contact_depth"])
    hopper = _value(first, "hopper_height") - _outlet_height(first) if _value(first, "hopper_height") else 0.0
    return Scale(min(0.0, contact - _value(first, "given_heap_height")), depth + hopper)


def _value(first: xr.Dataset, name: str) -> float:
    return float(first[name]) if name in first and np.isfinite(float(first[name])) else 0.0


def _outlet_height(first: xr.Dataset) -> float:
    """Height (m) of the outlet above the hopper's apex."""
    return float(first["outlet_width"]) / 2 / np.tan(float(first["hopper_half_angle"]))


def _silo(first: xr.Dataset, checks: xr.Dataset | None, scale: Scale, middle: float) -> list[str]:
    depth, contact = float(first["cylinder_depth"]), float(first["contact_depth"])
    half = min(float(first["given_diameter"]) / 2 * scale.per_metre, 85.0)
    left, right = middle - half, middle + half
    top, foot = scale.y(contact), scale.y(depth)
    parts = [line(x, top - 12, x, foot, stroke_width="2") for x in (left, right)]
    parts.append(line(middle, TOP - 8, middle, scale.y(scale.lowest) + 14, stroke="#888", stroke_dasharray="8 3 2 3"))
    parts.append(line(left, scale.y(0), right, scale.y(0), stroke="#2166AC", stroke_dasharray="4 3"))
    parts.append(_word(right + 4, scale.y(0) + 4, "z = 0", "start"))
    if heap := _value(first, "given_heap_height"):
        parts.append(path([(left, top), (middle, scale.y(contact - heap)), (right, top)], stroke="#A6611A"))
    parts += _below(first, scale, left, right, middle)
    parts += _dimension(left - 18, scale.y(0), foot, f"h_c {rounded(depth)} m")
    diameter = f"d_c {rounded(float(first['given_diameter']))} m"
    parts += [_word(middle, TOP - 18, diameter), line(left, TOP - 12, right, TOP - 12, stroke="#555", stroke_width="0.7")]
    return parts + (_strakes(checks, scale, left, right) if checks is not None else [])


def _below(first: xr.Dataset, scale: Scale, left: float, right: float, middle: float) -> list[str]:
    depth = float(first["cylinder_depth"])
    foot = scale.y(depth)
    if not _value(first, "hopper_height"):
        return [line(left, foot, right, foot, stroke_width="2"), _word(middle, foot + 14, "flat bottom or hopper not given")]
    end = scale.lowest
    share = float(first["outlet_width"]) / float(first["given_diameter"])
    out = (right - left) / 2 * share
    sides = [[(left, foot), (middle - out, scale.y(end))], [(right, foot), (middle + out, scale.y(end))]]
    angle = f"β {rounded(np.degrees(float(first['hopper_half_angle'])))}°"
    return [
        *(path(side, stroke_width="2") for side in sides),
        line(left, foot, right, foot, stroke="#555", stroke_width="0.7"),
        _word(middle + 26, foot + 18, angle),
        _word(middle, scale.y(end) + 14, f"b_o {rounded(float(first['outlet_width']))} m"),
        *_dimension(left - 18, foot, scale.y(end), f"{rounded(end - depth)} m"),
    ]


def _dimension(x: float, upper: float, lower: float, label: str) -> list[str]:
    ends = [line(x - 4, y, x + 4, y, stroke="#555", stroke_width="0.7") for y in (upper, lower)]
    turned = f'<g transform="rotate(-90 {x - 7:.1f} {(upper + lower) / 2:.1f})">{_word(x - 7, (upper + lower) / 2, label)}</g>'
    return [line(x, upper, x, lower, stroke="#555", stroke_width="0.7"), *ends, turned]


def _strakes(checks: xr.Dataset, scale: Scale, left: float, right: float) -> list[str]:
    """Edges of the strakes, with their thickness."""
    number, depth, thickness = (checks[name].values for name in ("place_strake", "place_depth", "place_thickness"))
    parts = []
    for strake in range(1, int(number.max()) + 1):
        here = number == strake
        upper, lower = float(depth[here].min()), float(depth[here].max())
        parts.append(line(right - 5, scale.y(upper), right + 5, scale.y(upper), stroke="#555"))
        label = f"{strake}: t {rounded(float(thickness[here][0]) * 1e3)} mm"
        parts.append(_word(right + 8, scale.y((upper + lower) / 2) + 4, label, "start"))
    return parts


def _panel(cube: xr.Dataset, name: str, label: str, scale: Scale, left: float, width: float = 105.0) -> list[str]:
    most = float(cube[name].max()) / 1e3
    if not np.isfinite(most) or most <= 0:
        return [_word(left + width / 2, TOP + 20, f"{label}: masked")]
    top, foot = scale.y(0), scale.y(float(cube["cylinder_depth"]))
    parts = [line(left, top, left, foot), line(left, top, left + width, top), _word(left + width / 2, top - 24, label)]
    for share in (0.5, 1.0):
        x = left + width * share
        parts += [
            line(x, top - 3, x, foot, stroke="#ccc", stroke_width="0.6"),
            _word(x, top - 5, rounded(float(f"{most * share:.2g}"))),
        ]
    for key, (colour, dashes) in PHASES.items():
        if key in cube["phase"].values:
            values, z = cube[name].sel(phase=key).values / 1e3, cube["depth"].values
            points = [
                (left + width * v / float(f"{most:.2g}"), scale.y(d)) for v, d in zip(values, z, strict=True) if np.isfinite(v)
            ]
            if points:
                parts.append(path(points, stroke=colour, stroke_width="1.6", stroke_dasharray=dashes))
    if name == "wall_normal_pressure":
        parts += _patch(cube, scale, left, width / float(f"{most:.2g}"))
    return parts


def _patch(cube: xr.Dataset, scale: Scale, left: float, per_kPa: float) -> list[str]:
    """The patch pressure of each phase over its height, dark beside the axis."""
    parts = []
    for key, (colour, _) in PHASES.items():
        if (
            key in cube["phase"].values
            and "patch_pressure" in cube
            and np.isfinite(float(cube["patch_pressure"].sel(phase=key)))
        ):
            here = cube.sel(phase=key)
            middle, height = float(here["patch_depth"]), float(here["patch_height"])
            width = float(here["patch_pressure"]) / 1e3 * per_kPa
            upper, lower = scale.y(middle - height / 2), scale.y(middle + height / 2)
            box = f'x="{left:.1f}" y="{upper:.1f}" width="{width:.1f}" height="{lower - upper:.1f}"'
            parts.append(f'<rect {box} fill="{colour}" fill-opacity="0.45" stroke="{colour}"/>')
    return parts


def _legend(key: str, x: float, y: float) -> str:
    colour, dashes = PHASES[key]
    mark = line(x, y - 4, x + 26, y - 4, stroke=colour, stroke_width="1.6", stroke_dasharray=dashes)
    return mark + _word(x + 32, y, key, "start")


def hopper(cube: xr.Dataset) -> str:
    """Pressure normal to the hopper's wall and friction on it, over the height above the apex."""
    height = cube["hopper_place_height"].values
    scale = Scale(-float(height.max()), -float(height.min()))
    parts: list[str] = []
    for number, (name, label) in enumerate(
        (("hopper_normal_pressure", "p_n (kPa)"), ("hopper_friction_traction", "p_t (kPa)"))
    ):
        parts += _beside(cube, name, label, -height, scale, 90.0 + 280 * number)
    legend = [
        _legend(key, 90.0 + 120 * k, TOP + DOWN * 0.5 + 30) for k, key in enumerate(PHASES) if key in cube["phase"].values
    ]
    return _svg(640, TOP + DOWN * 0.5 + 42, [*parts, *legend])


def _beside(
    cube: xr.Dataset, name: str, label: str, z: np.ndarray, scale: Scale, left: float, width: float = 190.0
) -> list[str]:
    most = float(cube[name].max()) / 1e3
    if not np.isfinite(most) or most <= 0:
        return [_word(left + width / 2, TOP + 20, f"{label}: masked")]

    def y(depth: float) -> float:
        return TOP + (scale.y(depth) - TOP) * 0.5

    top, foot = y(z.min()), y(z.max())
    parts = [line(left, top, left, foot), line(left, top, left + width, top), _word(left + width / 2, top - 24, label)]
    parts += [
        _word(left - 5, top + 4, f"x {rounded(-z.min())} m", "end"),
        _word(left - 5, foot, f"x {rounded(-z.max())} m", "end"),
    ]
    for share in (0.5, 1.0):
        x = left + width * share
        parts += [
            line(x, top - 3, x, foot, stroke="#ccc", stroke_width="0.6"),
            _word(x, top - 6, rounded(most * share)),
        ]
    for key, (colour, dashes) in PHASES.items():
        if key in cube["phase"].values:
            values = cube[name].sel(phase=key).values / 1e3
            points = [(left + width * v / most, y(d)) for v, d in zip(values, z, strict=True) if np.isfinite(v)]
            if points:
                parts.append(path(points, stroke=colour, stroke_width="1.6", stroke_dasharray=dashes))
    return parts
