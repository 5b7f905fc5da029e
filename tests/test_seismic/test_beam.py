"""The tube against the closed frequency equation, exact transfer matrices, and limits that need no program."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.linalg import expm
from scipy.optimize import brentq

from silostudy.seismic.added_mass import (
    coefficient_from_shift,
    equivalent_density,
    mass_ratio,
    stiffness_reduction,
    volume_ratio,
)
from silostudy.seismic.beam import Tube, contents_area, modes, second_moment, section_area

MODEL = Tube(radius=0.25, thickness=0.015, height=1.08, fill_height=1.08, wall_density=2350.0, youngs_modulus=25e9,
             poisson_ratio=0.2, shear_factor=0.5, contents_density=790.0)  # fmt: skip
SLENDER_TO_STUBBY = (40.0, 10.0, 4.0, 2.0, 1.0, 0.5)  # height over diameter


def properties(tube: Tube) -> tuple[float, float, float, float]:
    """Area, second moment, EI and kGA."""
    size = {"radius": tube.radius, "thickness": tube.thickness}
    area, inertia = section_area(**size), second_moment(**size)
    shear = tube.shear_factor * tube.youngs_modulus / (2 * (1 + tube.poisson_ratio)) * area
    return area, inertia, tube.youngs_modulus * inertia, shear


def frequency_equation(b: float, r: float, s: float) -> float:
    """Zero at the natural frequencies of a Timoshenko cantilever.

    b^2 = rho A L^4 omega^2 / EI, r^2 = I / A L^2, s^2 = EI / k G A L^2.
    """
    root = np.sqrt(complex((r**2 - s**2) ** 2 + 4 / b**2))
    alpha, beta = np.sqrt((root - r**2 - s**2) / 2), np.sqrt((root + r**2 + s**2) / 2)
    value = 2 + (b**2 * (r**2 - s**2) ** 2 + 2) * np.cosh(b * alpha) * np.cos(b * beta)
    value -= b * (r**2 + s**2) / np.sqrt(complex(1 - b**2 * r**2 * s**2)) * np.sinh(b * alpha) * np.sin(b * beta)
    assert abs(value.imag) <= 1e-9 * abs(value)
    return float(value.real)


def closed_frequencies(tube: Tube, density: float, count: int) -> list[float]:
    """The lowest frequencies (Hz) of the uniform tube from the closed equation, by a scan fine enough to miss none."""
    area, inertia, bending, shearing = properties(tube)
    r, s = np.sqrt(inertia / area) / tube.height, np.sqrt(bending / shearing) / tube.height
    found, step, low = [], 0.01, 0.5
    while len(found) < count:
        if frequency_equation(low, r, s) * frequency_equation(low + step, r, s) < 0:
            found.append(brentq(frequency_equation, low, low + step, args=(r, s), xtol=1e-12, rtol=1e-13))
        low += step
    return [b * np.sqrt(bending / (density * area * tube.height**4)) / (2 * np.pi) for b in found]


def transfer_determinant(frequency: float, tube: Tube, densities: list[float], lengths: list[float]) -> float:
    """Zero at the natural frequencies: exact transfer of (deflection, rotation, moment, shear) from base to free top."""
    area, inertia, bending, shearing = properties(tube)
    square, whole, scale = (2 * np.pi * frequency) ** 2, np.eye(4), tube.height
    for density, length in zip(densities, lengths, strict=True):
        per_length = np.array(
            [
                [0, 1, 0, 1 / shearing],
                [0, 0, 1 / bending, 0],
                [0, -density * inertia * square, 0, -1],
                [-density * area * square, 0, 0, 0],
            ]
        )
        units = np.array([scale, 1, bending / scale, bending / scale**2])
        whole = expm(per_length * units[None, :] / units[:, None] * length) @ whole
    return float(np.linalg.det(whole[2:, 2:]))


@pytest.mark.parametrize("slenderness", SLENDER_TO_STUBBY)
def test_frequencies_satisfy_the_closed_equation(slenderness):
    tube = replace(MODEL, height=2 * MODEL.radius * slenderness, fill_height=2 * MODEL.radius * slenderness)
    found = modes(tube, 0.0).frequency[:5]
    assert found == pytest.approx(closed_frequencies(tube, tube.wall_density, 5), rel=1e-8, abs=0)


def test_closed_equation_without_shear_and_rotary_inertia():
    for known in (3.5160153, 22.0344916, 61.6972144):
        assert brentq(frequency_equation, known - 0.1, known + 0.1, args=(0.0, 0.0), xtol=1e-12) == pytest.approx(
            known, rel=2e-8
        )


@pytest.mark.parametrize("slenderness", SLENDER_TO_STUBBY)
@pytest.mark.parametrize("filled", [0.25, 0.6, 1.0])
def test_partly_filled_tube_against_transfer_matrices(slenderness, filled):
    height = 2 * MODEL.radius * slenderness
    tube = replace(MODEL, height=height, fill_height=filled * height)
    size = {"radius": tube.radius, "thickness": tube.thickness}
    ratio = volume_ratio(**size)
    full = equivalent_density(0.8, wall_density=2350.0, contents_density=790.0, volume_ratio=ratio)
    densities, lengths = [full, 2350.0], [filled * height, (1 - filled) * height]
    for frequency in modes(tube, 0.8).frequency[:4]:
        around = [transfer_determinant(frequency * (1 + side), tube, densities, lengths) for side in (-1e-6, 1e-6)]
        assert around[0] * around[1] < 0, frequency


def test_modes_are_orthogonal_in_what_they_carry():
    """The modal masses come to the whole moving mass but for the part next to the clamped base."""
    found = modes(MODEL, 0.7)
    size = {"radius": MODEL.radius, "thickness": MODEL.thickness}
    mass = MODEL.height * (2350 * section_area(**size) + 0.7 * 790 * contents_area(**size))
    carried = np.cumsum(found.participation**2) / mass
    assert 0.6 < carried[0] < 0.75
    assert carried[-1] == pytest.approx(1, abs=0.01)
    assert np.all(np.diff(carried) >= 0)


def test_static_limit_of_base_forces():
    """A base that accelerates evenly: shear = mass x acceleration, moment = mass x acceleration x half the height."""
    found = modes(MODEL, 0.7, 0.03, heights=np.array([0.0]))
    deflections = found.participation / (2 * np.pi * found.frequency) ** 2
    size = {"radius": MODEL.radius, "thickness": MODEL.thickness}
    mass = MODEL.height * (2350 * section_area(**size) + 0.7 * 790 * contents_area(**size))
    assert float((found.curvature @ deflections)[0]) * found.bending_stiffness == pytest.approx(
        mass * MODEL.height / 2, rel=1e-9
    )
    assert float((found.shear_angle @ deflections)[0]) * found.shear_stiffness == pytest.approx(mass, rel=1e-9)


def test_section_is_that_of_a_ring():
    outer, inner = 0.25 + 0.0075, 0.25 - 0.0075
    size = {"radius": 0.25, "thickness": 0.015}
    assert section_area(**size) == pytest.approx(np.pi * (outer**2 - inner**2), rel=1e-12)
    assert second_moment(**size) == pytest.approx(np.pi / 4 * (outer**4 - inner**4), rel=1e-12)
    assert volume_ratio(**size) == pytest.approx(contents_area(**size) / section_area(**size), rel=1e-12)


def test_stiffness_reduction_and_shift():
    whole = modes(MODEL, 0.0).frequency[0]
    alpha = stiffness_reduction(33.0, whole)
    assert modes(MODEL, 0.0, alpha).frequency[0] == pytest.approx(33.0, rel=1e-9)
    ratio = mass_ratio(wall_density=2350.0, contents_density=790.0, volume_ratio=volume_ratio(radius=0.25, thickness=0.015))
    full = modes(MODEL, 0.7, alpha).frequency[0]
    assert coefficient_from_shift(33.0, full, mass_ratio=ratio) == pytest.approx(0.7, rel=1e-9)
