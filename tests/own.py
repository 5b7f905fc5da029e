"""The file of a user's own method that the guide to the package shows, and one of a buckling rule."""

from tests.guides import blocks

(THEORY,) = (block.text for block in blocks("silostudy/README.md", "python") if block.mark == "own-method")
RULE = '''
from silostudy.buckling.classical import capped_at_yield
from silostudy.buckling.family import BucklingRule, classical_stress
from silostudy.buckling.limits import NO_SUCTION


def strength(*, youngs_modulus, shell_poisson_ratio, yield_stress, shell_radius, thickness):
    """Strength (Pa): a fifth of the classical stress, at most the yield stress. Source: own notes, page 5."""
    perfect = classical_stress(
        youngs_modulus=youngs_modulus,
        shell_poisson_ratio=shell_poisson_ratio,
        shell_radius=shell_radius,
        thickness=thickness,
    )
    return capped_at_yield(perfect / 5, yield_stress)


ROW = BucklingRule(
    key="a_fifth",
    title="a fifth of the classical",
    source="J. Doe, Notes on tin cans, 2026",
    locator="page 5",
    strength=strength,
    limits=(NO_SUCTION,),
    formula="sigma = E t / (5 R sqrt(3 (1 - nu^2)))",
    validity="for comparison only",
    colour="#CC3311",
    marker="$5$",
    line="solid",
)
'''
# a file may hold several rows, of several families
BOTH = f"{THEORY.replace('ROW = ', 'MINE = ')}{RULE.replace('ROW = ', 'RULE = ')}\nROWS = (MINE, RULE)\n"
LAW = '''
from numba.extending import register_jitable

from silostudy.contact import spring
from silostudy.contact.coefficient import Coefficient
from silostudy.contact.family import NormalLaw


@register_jitable
def law(overlap, closing, touch, c):
    """Elastic and total normal force (N/m) of a spring stiffer than asked for, and a dashpot."""
    elastic = c[3] * c[0] * overlap
    total = elastic + c[1] * closing
    return elastic, (total if total > 0.0 else 0.0)


@register_jitable
def energy(overlap, touch, c):
    """Energy (J/m) of the spring."""
    return 0.5 * c[3] * c[0] * overlap * overlap


@register_jitable
def stiffness(overlap, touch, c):
    """Stiffness (N/m2) of the spring."""
    return c[3] * c[0]


ROW = NormalLaw(
    key="stiffer",
    title="A stiffer spring",
    source="J. Doe, Notes on hard discs, 2026",
    locator="page 7",
    law=law,
    energy=energy,
    stiffness=stiffness,
    damping=spring.damping,
    coefficients=(
        *spring.NORMAL,
        Coefficient(name="stiffening", unit="1", fields=(("stiffening",),), text="times as stiff", default=1.0, positive=True),
    ),
    linear=True,
    dissipates=("dashpot",),
)
'''
