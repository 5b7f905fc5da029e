"""The stiffest motion of a network, against all motions of a dense matrix that is made of stretches in other words."""

import numpy as np
import pytest

from silostudy.dem.stiffest import Network, stiffest

BODIES, CONTACTS = 9, 24


def network_of(ways: int, spins: int, seed: int) -> tuple[Network, np.ndarray]:
    """Contacts by chance of bodies by chance, a third of them with walls, and their strengths."""
    random = np.random.default_rng(seed)
    first = random.integers(0, BODIES, CONTACTS)
    second = np.where(np.arange(CONTACTS) % 3, (first + random.integers(1, BODIES, CONTACTS)) % BODIES, -1)
    normal = np.zeros((CONTACTS, 3))
    normal[:, :ways] = random.standard_normal((CONTACTS, ways))
    start = np.zeros((BODIES, 6))
    start[:, :ways], start[:, 6 - spins :] = random.standard_normal((BODIES, ways)), random.standard_normal((BODIES, spins))
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    network = Network(first, second, normal, random.uniform(0.5, 2.0, BODIES), random.uniform(0.5, 2.0, (BODIES, 2)), start)
    return network, random.uniform(0.0, 3.0, (CONTACTS, 4))


def stretches(network: Network, motion: np.ndarray, contact: int) -> np.ndarray:
    """Stretch along, across, of rolling and twisting that motions (body, 6) of unit energy give to a contact."""
    i, j, normal = network.first[contact], network.second[contact], network.normal[contact]

    def of(body, side):
        moved, turned = network.rates[body, 0] * motion[body, :3], network.rates[body, 1] * motion[body, 3:]
        return moved + np.cross(turned, side * network.radius[body] * normal), turned

    surface, turned = of(i, -1.0)
    if j >= 0:
        other, other_turned = of(j, 1.0)
        surface, turned = surface - other, turned - other_turned
    across = np.eye(3) - np.outer(normal, normal)
    return np.concatenate([[surface @ normal], across @ surface, across @ turned, [turned @ normal]])


@pytest.mark.parametrize(("ways", "spins"), [(2, 1), (3, 3)])
@pytest.mark.parametrize("springs", [(1, 1, 1, 1), (1, 1, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0)])
def test_the_largest_of_all_motions(ways, spins, springs):
    network, strength = network_of(ways, spins, seed=ways)
    strength = strength * springs
    units = np.eye(6 * BODIES).reshape(-1, BODIES, 6)
    each = strength[:, [0, 1, 1, 1, 2, 2, 2, 3]] ** 0.5
    rows = np.array([[each[c] * stretches(network, unit, c) for c in range(CONTACTS)] for unit in units])
    matrix = np.einsum("acs,bcs->ab", rows, rows)
    moving = np.flatnonzero(np.tile(network.start[0] != 0.0, BODIES))
    largest = np.linalg.eigvalsh(matrix[np.ix_(moving, moving)])[-1]
    assert largest > 0.0
    assert stiffest(network, strength, 1e-9) == pytest.approx(largest, rel=1e-7)


def test_a_rough_answer_lies_below():
    network, strength = network_of(3, 3, seed=0)
    rough, close = stiffest(network, strength, 0.5), stiffest(network, strength, 1e-9)
    assert 0.5 * close < rough <= close * (1.0 + 1e-12)


def test_nothing_is_stiff_without_springs():
    network, strength = network_of(3, 3, seed=1)
    assert stiffest(network, 0.0 * strength, 1e-6) == 0.0
