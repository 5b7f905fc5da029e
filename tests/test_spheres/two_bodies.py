"""Two spheres that meet, integrated apart from the package: each law in its own words, by the keys of their rows."""

from math import copysign, pi, sqrt

import numpy as np

from tests.test_spheres.scenes import DENSITY, RADIUS

RADII = np.array([RADIUS, 1.7 * RADIUS])
MASSES = DENSITY * 4.0 / 3.0 * pi * RADII**3
M = MASSES.prod() / MASSES.sum()
R = RADII.prod() / RADII.sum()
C = {
    "normal_stiffness": 4e3, "normal_damping": 0.02, "normal_damping_root": 3.0, "tangential_stiffness": 3e3,
    "tangential_damping": 0.01, "tangential_damping_root": 1.0, "sliding_friction": 0.35, "hertz_stiffness": 8e6,
    "hertz_damping": 8e2, "mindlin_stiffness": 1.1e7, "rolling_stiffness": 2e-4, "rolling_friction": 0.15,
    "rolling_damping": 4e-8, "twisting_stiffness": 3e-4, "twisting_friction": 0.05, "twisting_damping": 4e-8, "pull": 2e-3,
    "cohesion_energy_density": 1e5, "work_of_adhesion": 1.5,
}  # fmt: skip
START = np.array([[0.0, 0.0, 0.5], [0.0, 0.0, 0.5]])
START[1, :2] = np.array([0.8, 0.6]) * (RADII.sum() + 1e-9)
VELOCITY = np.array([[0.3, 0.05, 0.1], [-0.2, -0.1, -0.25]])
SPIN = np.array([[40.0, -60.0, 30.0], [20.0, 90.0, -50.0]])
END = 1.3 * pi * sqrt(M / C["normal_stiffness"])  # s
LEVER = sqrt(2.0 * pi * C["work_of_adhesion"] / (0.75 * C["hertz_stiffness"]))  # of surface energy, m1/2
TORN = 1.5 * pi * C["work_of_adhesion"] * R  # N


def capped(value, cap):
    """A number or vector held at a size."""
    size = np.linalg.norm(value)
    return value * (cap / size) if size > cap else value


def hertz(a, closing):
    """Elastic force and dashpot (N) of a contact of a radius a (m)."""
    return C["hertz_stiffness"] * a**3 / R, C["hertz_damping"] * sqrt(M * a) * closing


def linear(overlap, closing):
    """Elastic force and dashpot (N) of an overlap (m)."""
    return C["normal_stiffness"] * overlap, (C["normal_damping"] + C["normal_damping_root"] * sqrt(M)) * closing


def pressing(elastic, dashpot):
    return elastic, max(elastic + dashpot, 0.0)


def pulling(elastic, dashpot):
    return elastic, elastic + dashpot


NORMAL = {  # (overlap, radius of the contact, closing) -> elastic and total force
    "spring-dashpot": lambda overlap, a, closing: pressing(*linear(overlap, closing)),
    "spring-dashpot-tension": lambda overlap, a, closing: pulling(*linear(overlap, closing)),
    "spring-dashpot-implicit": lambda overlap, a, closing: pressing(*linear(overlap, closing)),
    "hertz": lambda overlap, a, closing: pressing(*hertz(a, closing)),
    "hertz-tension": lambda overlap, a, closing: pulling(*hertz(a, closing)),
}


def drag(sliding):
    return -(C["tangential_damping"] + C["tangential_damping_root"] * sqrt(M)) * sliding


def spring_slider(held, sliding, a, wider, elastic, push, dt):
    held = held - C["tangential_stiffness"] * dt * sliding
    cap = C["sliding_friction"] * elastic
    return (capped(held, cap),) * 2 if np.linalg.norm(held) > cap else (held, held + drag(sliding))


def slider_of_sum(held, stiffness, dashpot, sliding, push, dt):
    total = capped(held - stiffness * dt * sliding + dashpot, C["sliding_friction"] * max(push, 0.0))
    return total - dashpot, total


def mindlin(held, sliding, a, wider, elastic, push, dt):
    dashpot = -C["hertz_damping"] * sqrt(M * a) * sliding
    return slider_of_sum(held, C["mindlin_stiffness"] * a, dashpot, sliding, push, dt)


TANGENTIAL = {  # (held, sliding, radius of the contact, the same a step before, elastic, push, dt) -> held and total force
    "none": lambda held, *_: (held, 0.0 * held),
    "spring-slider": spring_slider,
    "spring-slider-total": lambda held, sliding, a, wider, elastic, push, dt: slider_of_sum(
        held, C["tangential_stiffness"], drag(sliding), sliding, push, dt
    ),
    "viscous-coulomb": lambda held, sliding, a, wider, elastic, push, dt: (
        held, capped(drag(sliding), C["sliding_friction"] * max(push, 0.0))),
    "mindlin": mindlin,
    "mindlin-rescaled": lambda held, sliding, a, wider, *rest: mindlin(
        held * min(1.0, a / wider if wider else 1.0), sliding, a, wider, *rest
    ),
}  # fmt: skip


def resisting(name, spring, dashpot):
    """A resistance to a turning motion of so much friction, with a spring or without, and with a dashpot or without."""

    def resistance(held, turning, a, elastic, dt):
        cap, size = C[f"{name}_friction"] * R * elastic, np.linalg.norm(turning)
        if not spring:
            return held, -turning * (cap / size if size else 0.0)
        trial = held - C[f"{name}_stiffness"] * dt * turning
        if np.linalg.norm(trial) > cap:
            return (capped(trial, cap),) * 2
        return trial, trial - (C[f"{name}_damping"] if dashpot else 0.0) * turning

    return resistance


def spread(held, turning, a, elastic, dt):
    """Sliding friction over a circle of radius a."""
    dashpot = -0.5 * a**2 * C["hertz_damping"] * sqrt(M * a) * turning
    trial = held - 0.5 * a**3 * C["mindlin_stiffness"] * dt * turning + dashpot
    cap = 2.0 / 3.0 * C["sliding_friction"] * a * elastic
    total = copysign(min(abs(trial), cap), trial)
    return total - dashpot, total


ROLLING = {  # (held, difference of spins, radius of the contact, elastic, dt) -> held and total moment
    "none": lambda held, turning, a, elastic, dt: (held, 0.0 * turning),
    "spring-slider": resisting("rolling", spring=True, dashpot=False),
    "spring-dashpot-slider": resisting("rolling", spring=True, dashpot=True),
    "constant-torque": resisting("rolling", spring=False, dashpot=False),
}
TWISTING = {
    "none": ROLLING["none"],
    "spring-dashpot-slider": resisting("twisting", spring=True, dashpot=True),
    "constant-torque": resisting("twisting", spring=False, dashpot=False),
    "marshall": spread,
}


def without_energy(overlap):
    """Radius (m) of Hertz's contact, zero where the bodies are apart."""
    return sqrt(R * max(overlap, 0.0))


def with_energy(overlap):
    """Radius (m) of JKR's contact at an overlap, the larger one: from all roots of a quartic."""
    roots = np.roots([1.0 / R, 0.0, 0.0, -LEVER, -overlap])
    real = roots.real[np.abs(roots.imag) < 1e-9 * np.abs(roots).max()]
    return real.max() ** 2 if real.size else 0.0


def torn_at():
    """Gap (m) at which surface energy pulls most: where the cube of the radius is an eighth of 9 pi w R^2/E*."""
    a = (9.0 * pi * C["work_of_adhesion"] * R**2 / (6.0 * C["hertz_stiffness"])) ** (1.0 / 3.0)
    return LEVER * sqrt(a) - a**2 / R


def surface_pull(overlap, a):
    """Attraction (N) of surface energy, and that less twice the largest pull."""
    pull = sqrt(6.0 * pi * C["work_of_adhesion"] * C["hertz_stiffness"] * a**3)
    return pull, pull - 2.0 * TORN


COHESION = {  # (overlap, radius of the contact) -> attraction, what of it friction does not feel; gap; radius
    "none": (lambda overlap, a: (0.0, 0.0), 0.0, without_energy),
    "constant-pull": (lambda overlap, a: (C["pull"], 0.0), 0.0, without_energy),
    "area-pull": (lambda overlap, a: (C["cohesion_energy_density"] * 2.0 * pi * R * overlap, 0.0), 0.0, without_energy),
    "jkr": (surface_pull, torn_at(), with_energy),
}


def cross(a, b):
    return np.array([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def apart(keys, dt, end=END):
    """Velocities and speeds of the surfaces by spin (m/s) after the time `end` (s), by steps of dt (s)."""
    normal_force, tangential_force = NORMAL[keys["normal"]], TANGENTIAL[keys["tangential"]]
    rolling_moment, twisting_moment = ROLLING[keys["rolling"]], TWISTING[keys["twisting"]]
    attraction, gap, radius_of = COHESION[keys["cohesion"]]
    place, velocity, spin = START.copy(), VELOCITY.copy(), SPIN.copy()
    inertia, touched = 0.4 * MASSES * RADII**2, False
    held, turned, twisted, wider = np.zeros(3), np.zeros(3), 0.0, 0.0
    for _ in range(round(end / dt)):
        away = place[0] - place[1]
        distance = sqrt(away @ away)
        n, overlap = away / distance, RADII.sum() - distance
        touched = overlap > 0.0 or (touched and overlap > -gap)
        if not touched:
            held, turned, twisted, wider = np.zeros(3), np.zeros(3), 0.0, 0.0
            place += velocity * dt
            continue
        a, arms = radius_of(overlap), RADII - 0.5 * overlap
        relative, differing = velocity[0] - velocity[1], spin[0] - spin[1]
        closing = -(relative @ n)
        at_contact = relative + cross(arms[0] * spin[0] + arms[1] * spin[1], -n)
        sliding = at_contact - (at_contact @ n) * n
        about = differing @ n
        held, turned = held - (held @ n) * n, turned - (turned @ n) * n
        elastic, push = normal_force(overlap, a, closing)
        pull, less = attraction(overlap, a)
        held, friction = tangential_force(held, sliding, a, wider, elastic - less, push - less, dt)
        turned, rolling = rolling_moment(turned, differing - about * n, a, elastic - less, dt)
        twisted, twist = twisting_moment(twisted, about, a, elastic - less, dt)
        force, moment, wider = (push - pull) * n + friction, rolling + twist * n, a
        velocity += np.array([force, -force]) / MASSES[:, None] * dt
        spin[0] += (cross(-arms[0] * n, friction) + moment) / inertia[0] * dt
        spin[1] += (cross(-arms[1] * n, friction) - moment) / inertia[1] * dt
        place += velocity * dt
    return np.hstack([velocity, spin * RADII[:, None]])
