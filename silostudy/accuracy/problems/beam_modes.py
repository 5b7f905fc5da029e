"""Answer of a tube shaken by a pulse over the number of modes that are summed."""

from dataclasses import replace

import numpy as np
from scipy.linalg import expm

from silostudy.accuracy.problems.beam_frequency import TUBE
from silostudy.seismic.beam import Modes, modes, second_moment, section_area
from silostudy.seismic.response import absolute_acceleration, internal_forces

MODES = (1, 2, 3, 4, 5, 7, 10, 15, 22, 34)  # the last: all that the package's polynomials of degree 17 have
LADDERS = {"modes": MODES}
PULSE = 4e-3  # s, about the tube's first period
FOLLOWED = 4  # pulses that are followed
STEPS = 4000  # in a pulse
SHIFT = 18.0  # of the contour, over the period of the transform
FINER = 2  # samples of the transform over the steps of LOOKED
LOOKED = 200  # looks at the histories in a pulse


def _base(time: np.ndarray) -> np.ndarray:
    """Acceleration (m s-2): one smooth push of 1 m/s2."""
    return np.where(time < PULSE, np.sin(np.pi * time / PULSE) ** 4, 0.0)


def prepare(ladder: str, setting: float):
    """Undamped, from rest; the histories of the sum are looked at in the reference's moments."""
    base, dt = _base(np.arange(FOLLOWED * STEPS + 1) * PULSE / STEPS), PULSE / STEPS
    every = STEPS // LOOKED

    def run():
        ends = modes(TUBE, 0.0, heights=np.array([0.0, TUBE.height]))
        some = first(ends, int(setting))
        shear, moment = internal_forces(base, dt, some, 0.0)
        top = absolute_acceleration(base, dt, some, 0.0)[1]
        values = {"top_acceleration": top, "base_shear": shear[0], "base_moment": moment[0]}
        return {name: history[::every] for name, history in values.items()}

    return run


def first(shapes: Modes, count: int) -> Modes:
    """The lowest modes alone."""
    columns = {name: getattr(shapes, name)[:, :count] for name in ("displacement", "curvature", "shear_angle")}
    return replace(shapes, frequency=shapes.frequency[:count], participation=shapes.participation[:count], **columns)


def reference():
    """The beam's equations in Laplace's domain, solved by transfer over the height, turned back along a shifted line."""
    count = 2 * FOLLOWED * LOOKED * FINER  # twice the time that is followed: the end of the transform wraps around
    dt = PULSE / LOOKED / FINER
    time = np.arange(count) * dt
    grown = SHIFT / time[-1]
    s = grown + 2j * np.pi * np.fft.fftfreq(count, dt)
    pushed = np.fft.fft(_base(time) * np.exp(-grown * time))
    answers = _transferred(s) * pushed
    histories = np.fft.ifft(answers).real * np.exp(grown * time)
    looked = histories[:, : FOLLOWED * LOOKED * FINER + 1 : FINER]
    return dict(zip(("top_acceleration", "base_shear", "base_moment"), looked, strict=True))


def _transferred(s: np.ndarray) -> np.ndarray:
    """Top acceleration, base shear and moment over the base's acceleration at complex frequencies (s-1): (3, frequency).

    State over the height: displacement, rotation, its slope, angle of shear; in units of the height L and L/c.
    """
    size = {"radius": TUBE.radius, "thickness": TUBE.thickness}
    area, inertia, height = section_area(**size), second_moment(**size), TUBE.height
    bending = TUBE.youngs_modulus * inertia
    shearing = TUBE.shear_factor * TUBE.youngs_modulus / (2 * (1 + TUBE.poisson_ratio)) * area
    slope = np.zeros((len(s), 4, 4), complex)
    slope[:, 0, 1] = slope[:, 0, 3] = slope[:, 1, 2] = 1.0
    slope[:, 2, 1] = TUBE.wall_density * inertia * s**2 * height**2 / bending
    slope[:, 2, 3] = -shearing * height**2 / bending
    slope[:, 3, 0] = TUBE.wall_density * area * s**2 * height**2 / shearing
    whole = expm(slope)
    base = 1.0 / s**2 / height  # of a base acceleration of 1, over the height
    unknown = np.linalg.solve(whole[:, 2:, 2:], -whole[:, 2:, :1] * base[:, None, None])[..., 0]
    top = s**2 * height * (whole[:, 0, 0] * base + whole[:, 0, 2] * unknown[:, 0] + whole[:, 0, 3] * unknown[:, 1])
    return np.array([top, shearing * unknown[:, 1], bending / height * unknown[:, 0]])
