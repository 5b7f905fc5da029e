"""Eigenvalue buckling of one perfect cylinder, three ways, against the classical stress behind every knock-down factor."""

import shutil

import numpy as np
import pytest
from scipy.linalg import eigh

from silostudy.buckling.family import classical_stress
from tests.test_buckling.calculix import buckling_stress

E, R, T = 210e9, 1.0, 0.01


def half_wave(nu: float) -> float:
    """Length (m) of a half wave of the axisymmetric mode: pi sqrt(R t) / (12 (1 - nu^2))^(1/4)."""
    return np.pi * np.sqrt(R * T) / (12 * (1 - nu**2)) ** 0.25


@pytest.mark.parametrize("nu", [0.0, 0.3])
def test_axisymmetric_mode_by_finite_differences(nu):
    """D w'''' + N w'' + E t w / R^2 = 0 on six half waves, ends simply supported."""
    points, length = 600, 6 * half_wave(nu)
    step = length / (points + 1)
    curvature = (2 * np.eye(points) - np.eye(points, k=1) - np.eye(points, k=-1)) / step**2
    stiffness = E * T**3 / (12 * (1 - nu**2)) * curvature @ curvature + E * T / R**2 * np.eye(points)
    lowest = eigh(stiffness, curvature, eigvals_only=True, subset_by_index=[0, 0])[0] / T
    assert lowest == pytest.approx(classical(nu), rel=1e-4)


@pytest.mark.parametrize("nu", [0.0, 0.3])
def test_no_mode_around_the_shell_lies_lower(nu):
    """Donnell's shallow-shell stress over all waves (m along, n around) of a cylinder of 30 half waves."""
    m, n = np.arange(1, 200)[:, None], np.arange(0, 60)[None, :]
    along, around = m * np.pi / (30 * half_wave(nu)), n / R
    ratio = (along**2 + around**2) ** 2 / along**2
    stress = (E * T**2 / (12 * (1 - nu**2))) * ratio + E / R**2 / ratio
    assert stress.min() == pytest.approx(classical(nu), rel=1e-3)
    assert stress.min() >= classical(nu) * (1 - 1e-12)


@pytest.mark.skipif(shutil.which("ccx") is None, reason="CalculiX (ccx) is not installed")
def test_calculix_agrees(tmp_path):
    """A finite-element program on a sector of 30 degrees, four half waves long; nu = 0 keeps the stress uniform."""
    mesh = {"sector": np.pi / 6, "around": 12, "along": 24}
    found = buckling_stress(tmp_path, radius=R, thickness=T, length=4 * half_wave(0.0), youngs_modulus=E, **mesh)
    assert found == pytest.approx(classical(0.0), rel=0.02)


def classical(nu: float) -> float:
    return float(classical_stress(youngs_modulus=E, shell_poisson_ratio=nu, shell_radius=R, thickness=T))
