"""Checks of the steel that the package leaves out, and why: told by `silostudy explain checks`."""

MEMORY = (
    "rings under external pressure (I >= 0.1 L t^3, 0.08 C_w r t^3 sqrt(r/t)) and the shortcut C_w of EN 1993-4-1",
    "alpha 0.75 and 0.50 of classes A and C for hoop compression and shear (A is given B's 0.65; C is masked)",
    "C_s of short walls under external pressure with other edges than clamped (C_theta is taken, which is safe)",
    "lapped courses: alpha x 0.7 in axial buckling; EN's own table of joint efficiencies; net section of bolted seams",
    "plastic limit and the factors 0.9 and 1.2 of the hopper's joint; kick pressure at the transition; t_eq of several plates",
    "4 E I/(A r^2) for the ring in its plane (the classical 3 is taken) and buckling of an annular plate out of its plane",
    "three sleeves and their chart for stepped walls (Ritz' method of semi-membrane theory is taken)",
    "vertical earthquake 0.9 and 0.45 a_h; directions 1.0/0.3/0.3; q, psi_2 and overstrength, which the study gives",
    "fatigue, and an earthquake on the empty silo (the seismic studies shake full ones)",
)
CONFLICT = (
    "joint efficiency of laps (0.55 or 0.70 double, 0.45 or 0.35 single): the user gives it",
    "c_f by k/b and Reynolds number: the user gives it; gain of short walls in shear (1.16 or 1.50 at omega 5): left out",
    "spread of a column's force into the wall (30 or 45 degrees): strength above a column is not checked",
    "uniform pressure in place of the patch load (two memories): not built",
    "r/t <= 0.21 sqrt(E/f_y) without check (one program lacks the root): the check is always made",
)
ONE_SOURCE = (
    "C_p(theta) by annex C of EN 1993-4-1, of one silo and of groups, and its harmonics: AS/NZS 1170.2 (two copies) is taken",
    "psi of uneven axial stress: 1 is taken, the safe end",
    "rings that end a bay for axial buckling by their stiffness: area alone counts (`buckling/limits`)",
    "longer cylinders under external pressure (masked); C_s of short ones clamped at both ends (C_theta is taken)",
    "corrugated and stiffened walls",
)
LEFT_OUT = (
    "local bending and membrane peaks of a patch load (shear and moment of the tube are counted); a frame that props the top",
    "the switch of stresses as it moves up a hopper (its ring force at the transition is counted)",
    "a partly filled silo with wind on its empty part; wind on the legs below the wall, and on the roof",
    "hoop strengths of EN 1993-1-6:2025: not seen",
)
