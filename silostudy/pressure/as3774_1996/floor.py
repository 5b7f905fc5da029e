"""AS 3774-1996, the flat floor of a circular container after filling: most in the middle, p_vi in the mean."""

from silostudy.pressure.as3774_1996 import wall
from silostudy.pressure.calls import asking

# factors of the formulas below
MIDDLE = 1.25  # pressure in the middle over the mean
FALL = 1.6  # how it falls with the square of the distance
SHEAR = 0.3  # of the shear
SEEN = "Source: as3774_1996, second-hand (one account)"


def normal_pressure(x, given):
    """Pressure (Pa) on the floor at distance x (m) from the axis: 1.25 p_vi [1 - 1.6 (x/d_c)^2], of mean p_vi."""
    return MIDDLE * wall.load(given) * (1 - FALL * (x / given["diameter"]) ** 2)


def shear_traction(x, given):
    """Shear (Pa) on the floor, outward, at distance x (m) from the axis: 0.3 p_vi [2 x/d_c - (2 x/d_c)^2]."""
    share = 2 * x / given["diameter"]
    return SHEAR * wall.load(given) * (share - share**2)


PRESSURES = {
    "floor_normal_pressure": asking(
        lambda x, **given: normal_pressure(x, given),
        wall.GIVEN,
        f"Pressure (Pa) on the floor at distance x (m) from the axis. {SEEN}; its mean is in equilibrium.",
        "x",
    ),
    "floor_shear_traction": asking(
        lambda x, **given: shear_traction(x, given),
        wall.GIVEN,
        f"Outward shear (Pa) on the floor at distance x (m) from the axis. {SEEN}.",
        "x",
    ),
}
LOAD = asking(lambda **given: wall.load(given), wall.GIVEN, f"Mean vertical pressure p_vi (Pa) on the bottom. {SEEN}.", None)
