"""The vector passes and the surfaces of space against their meaning in plain Python."""

from math import hypot, pi, sqrt

import numpy as np
import pytest
from numba import njit

from silostudy.dem.arrays import aligned
from silostudy.dem.cache import OPTIONS
from silostudy.dem.space import lanes as of_lanes
from silostudy.dem.space.felt import flat_frame, turned_frame
from silostudy.dem.space.lanes import HISTORIES, NEW, OLD, STRETCH
from silostudy.dem.space.motion import carry
from silostudy.dem.space.rows import OUT_OF_REACH
from silostudy.dem.space.surfaces import nearest
from silostudy.dem.space.walls import FlatPiece, TurnedLine, walls_of
from silostudy.errors import BadInput

PLAIN = {**OPTIONS, "cache": False}
COUNT = 24


def arrays(seed=0):
    random = np.random.default_rng(seed)
    rows = aligned(40, 16)
    rows[:] = random.normal(size=rows.shape)
    first, second = (random.integers(0, 40, COUNT + 8).astype(np.int32) for _ in range(2))
    lanes, force = aligned(1, (OLD + HISTORIES) * STRETCH), aligned(1, (NEW + HISTORIES) * STRETCH)
    force[:] = random.normal(size=force.shape)
    history = aligned(3, 64)
    history[:] = random.normal(size=history.shape)
    return rows, first, second, lanes, force, history


@pytest.mark.parametrize("name", ["gather", "gather_rolling", "scatter", "scatter_rolling"])
def test_indexed_passes_are_what_they_say(name):
    function = getattr(of_lanes, name)

    @njit(**PLAIN)
    def compiled(rows, first, second, start, count, lanes):
        function(rows, first, second, start, count, lanes)

    plain, fast = arrays(), arrays()
    for (rows, first, second, lanes, force, _), call in ((plain, function), (fast, compiled)):
        call(rows, first, second, 8, COUNT, force if name.startswith("scatter") else lanes)
    assert plain[0].any()
    assert np.array_equal(plain[3], fast[3])
    assert np.allclose(plain[0], fast[0], rtol=1e-15, atol=0.0)


def test_histories_travel_whole():
    @njit(**PLAIN)
    def there_and_back(history, lanes):
        of_lanes.bring(history, 8, 16, lanes, OLD * STRETCH)
        of_lanes.take(lanes, OLD * STRETCH, history, 32, 16)

    _, _, _, lanes, _, history = arrays()
    before = history.copy()
    there_and_back(history, lanes)
    assert np.array_equal(history[:, 32:48], before[:, 8:24])
    assert np.array_equal(history[:, :32], before[:, :32])


def surface(one) -> np.ndarray:
    return walls_of([one]).shape


def by_search(one, point):
    """Least distance (m) from points strewn densely over the surface."""
    shares = np.linspace(0.0, 1.0, 801)
    if isinstance(one, TurnedLine):
        turns = np.linspace(0.0, 2.0 * pi, 801)
        r, z = (one.start[k] + shares * (one.end[k] - one.start[k]) for k in range(2))
        strewn = np.stack(
            [one.axis[0] + np.outer(r, np.cos(turns)), one.axis[1] + np.outer(r, np.sin(turns)),
             np.repeat(z[:, None], 801, axis=1)], axis=-1)  # fmt: skip
    else:
        a, b, c = (np.array(corner) for corner in one.corners[:3])
        d = np.array(one.corners[3]) if len(one.corners) == 4 else a
        s, t = np.meshgrid(shares, shares)
        s, t = s[..., None], t[..., None]
        strewn = (1 - s) * (1 - t) * a + s * (1 - t) * b + s * t * c + (1 - s) * t * d
    return float(np.linalg.norm(strewn - point, axis=-1).min())


SURFACES = [
    TurnedLine(name="cylinder", start=(0.3, 0.0), end=(0.3, 0.5)),
    TurnedLine(name="cone", start=(0.1, 0.0), end=(0.4, 0.3), axis=(0.05, -0.1)),
    TurnedLine(name="ring", start=(0.1, 0.2), end=(0.3, 0.2)),
    TurnedLine(name="disc", start=(0.0, 0.2), end=(0.3, 0.2)),
    FlatPiece(name="wall", corners=((0.0, 0.0, 0.0), (0.4, 0.1, 0.0), (0.4, 0.1, 0.3), (0.0, 0.0, 0.3))),
    FlatPiece(name="slope", corners=((0.0, 0.0, 0.0), (0.4, 0.0, 0.2), (0.2, 0.3, 0.1))),
]


@pytest.mark.parametrize("one", SURFACES, ids=lambda one: one.name)
def test_nearest_point_against_a_search(one):
    random = np.random.default_rng(5)
    for point in random.uniform((-0.3, -0.3, -0.2), (0.6, 0.6, 0.7), (12, 3)):
        *away, _ = nearest(surface(one), 0, *point)
        assert np.linalg.norm(away) == pytest.approx(by_search(one, point), abs=2e-3)
        *still, _ = nearest(surface(one), 0, *(point - away))  # the nearest point lies on the surface
        assert np.linalg.norm(still) < 1e-12


def test_a_joined_edge_does_not_push():
    low = TurnedLine(name="cylinder", start=(0.3, 0.0), end=(0.3, 0.5), joined=(True, False))
    assert nearest(surface(low), 0, 0.2, 0.0, -0.01)[0] == OUT_OF_REACH
    assert hypot(*nearest(surface(low), 0, 0.3, 0.0, 0.6)[:3]) == pytest.approx(0.1)


def test_curvature_is_that_of_the_mean():
    """Inside a cylinder the reduced radius is a/(1 - a/(2 R)), beside its outside a/(1 + a/(2 R))."""
    shape = surface(TurnedLine(name="cylinder", start=(0.3, 0.0), end=(0.3, 0.5)))
    assert nearest(shape, 0, 0.29, 0.0, 0.2)[3] == pytest.approx(0.5 / 0.3)
    assert nearest(shape, 0, 0.31, 0.0, 0.2)[3] == pytest.approx(-0.5 / 0.3)
    assert nearest(surface(SURFACES[2]), 0, 0.2, 0.0, 0.25)[3] == 0.0


def test_places_on_a_surface():
    along, turn, up = turned_frame(surface(TurnedLine(name="c", start=(0.3, 0.5), end=(0.3, 0.0))), 0, 0.0, -0.3, 0.1)
    assert (along, turn) == pytest.approx((0.8, 0.75))
    assert up == pytest.approx((0.0, 0.0, 1.0))
    piece = FlatPiece(name="wall", corners=((0.0, 0.0, 1.0), (2.0, 0.0, 1.0), (2.0, 0.0, 2.0), (0.0, 0.0, 2.0)))
    height, across, up = flat_frame(surface(piece), 0, 0.5, 0.0, 1.2)
    assert height == pytest.approx(0.2)
    assert across in (pytest.approx(0.25), pytest.approx(0.75))
    assert up == pytest.approx((0.0, 0.0, 1.0))


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: TurnedLine(name="c", start=(0.3, 0.0), end=(0.3, 0.0)), "must have an extent"),
        (lambda: TurnedLine(name="c", start=(-0.3, 0.0), end=(0.3, 0.0)), "distances from the axis and heights must be finite"),
        (lambda: TurnedLine(name="c", start=(0.3, 0.0), end=(0.3, 1.0), cells=(0, 1)), "c.cells = .* must be 1 or more"),
        (lambda: FlatPiece(name="p", corners=((0, 0, 0), (1, 0, 0), (2, 0, 0))), "must have an extent"),
        (lambda: FlatPiece(name="p", corners=((0, 0, 0), (1, 0, 0))), "three finite corners or more"),
    ],
)
def test_surfaces_that_are_none(make, message):
    with pytest.raises(BadInput, match=message):
        make()


def test_a_history_turns_with_its_contact():
    """Into the plane across the new normal, as long as before; one along the normal is lost."""
    normal = np.array([2.0, -1.0, 2.0]) / 3.0
    turned = np.array(carry((3.0, 1.0, -2.0), tuple(normal)))
    assert turned @ normal == pytest.approx(0.0, abs=1e-14)
    assert np.linalg.norm(turned) == pytest.approx(sqrt(14.0), rel=1e-14)
    assert carry(tuple(5.0 * normal), tuple(normal)) == pytest.approx((0.0, 0.0, 0.0), abs=1e-14)
    assert carry((0.0, 0.0, 0.0), tuple(normal)) == (0.0, 0.0, 0.0)
