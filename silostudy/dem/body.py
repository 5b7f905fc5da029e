"""One body of a scene by words that mean the same in the plane and in space: its place, its speed, its gap to a wall.

In a kernel the kind of the bodies chooses a word's meaning when it is compiled; in Python it does so at every call.
"""

from collections.abc import Callable

from numba.extending import overload

from silostudy.dem import lanes as plane
from silostudy.dem import walls as plane_walls
from silostudy.dem.arrays import Spheres
from silostudy.dem.space import lanes as space
from silostudy.dem.space import surfaces


def word(of_disc: Callable, of_sphere: Callable) -> Callable:
    """A function of bodies and one's number that is `of_disc` in the plane and `of_sphere` in space."""

    def of_body(bodies, i):
        return (of_sphere if isinstance(bodies, Spheres) else of_disc)(bodies, i)

    @overload(of_body, jit_options={"forceinline": True})
    def _of_body(bodies, i):
        return of_sphere if bodies.instance_class is Spheres else of_disc

    return of_body


def _place_of_disc(bodies, i):
    return bodies.rows[i, plane.X], bodies.rows[i, plane.Y], 0.0


def _place_of_sphere(bodies, i):
    return bodies.rows[i, space.X], bodies.rows[i, space.Y], bodies.rows[i, space.Z]


def _square_speed_of_disc(bodies, i):
    u, v = bodies.rows[i, plane.U], bodies.rows[i, plane.V]
    return u * u + v * v


def _square_speed_of_sphere(bodies, i):
    u, v, w = bodies.rows[i, space.U], bodies.rows[i, space.V], bodies.rows[i, space.W]
    return u * u + v * v + w * w


def _spin_of_disc(bodies, i):
    return abs(bodies.rows[i, plane.W])


def _spin_of_sphere(bodies, i):
    return abs(bodies.rows[i, space.P]) + abs(bodies.rows[i, space.Q]) + abs(bodies.rows[i, space.R])


def _motion_of_disc(bodies, i):
    return plane.W + 1


def _motion_of_sphere(bodies, i):
    return space.R + 1


place = word(_place_of_disc, _place_of_sphere)  # x, y, z (m); discs lie at a height of zero
square_speed = word(_square_speed_of_disc, _square_speed_of_sphere)  # m2/s2
spin = word(_spin_of_disc, _spin_of_sphere)  # rad/s, sum of the sizes of its parts
motion = word(_motion_of_disc, _motion_of_sphere)  # how many numbers of a row are place, velocity and spin


def square_gap(bodies, shape, wall, i):
    """Square of the distance (m2) of body i's centre from a wall, joined ends of it too."""
    return (_gap_of_sphere if isinstance(bodies, Spheres) else _gap_of_disc)(bodies, shape, wall, i)


def _gap_of_disc(bodies, shape, wall, i):
    return plane_walls.square_apart(shape, wall, bodies.rows[i, plane.X], bodies.rows[i, plane.Y])


def _gap_of_sphere(bodies, shape, wall, i):
    return surfaces.square_apart(shape, wall, bodies.rows[i, space.X], bodies.rows[i, space.Y], bodies.rows[i, space.Z])


@overload(square_gap, jit_options={"forceinline": True})
def _square_gap(bodies, shape, wall, i):
    return _gap_of_sphere if bodies.instance_class is Spheres else _gap_of_disc


def goes_on_from(bodies, shape, wall, before):
    """Whether a wall goes straight on from another: pieces of a floor of discs, at shut outlets."""
    return (_none_of_spheres if isinstance(bodies, Spheres) else _goes_on_of_discs)(bodies, shape, wall, before)


def _goes_on_of_discs(bodies, shape, wall, before):
    return before == wall - 1 and plane_walls.seam_before(shape, wall)


def _none_of_spheres(bodies, shape, wall, before):
    return False


@overload(goes_on_from, jit_options={"forceinline": True})
def _goes_on_from(bodies, shape, wall, before):
    return _none_of_spheres if bodies.instance_class is Spheres else _goes_on_of_discs
