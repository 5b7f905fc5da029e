"""Constants of nature: each once, with the reason why there are two of gravity."""

STANDARD_GRAVITY = 9.80665
"""Acceleration of free fall (m s-2), exact by convention.

Source: 3rd General Conference on Weights and Measures (1901); it makes the tonne-force of the sources 9.80665 kN.  Used
wherever a weight is compared with a printed one: packings, shaken discs, earthquakes, units.
"""

ROUNDED_GRAVITY = 9.81
"""Acceleration of free fall (m s-2) as rounded in the discrete-element scenes.

Kiyama and Fujimura (1983), Table 2, print stiffness and dashpots over the weight of a unit of volume; the scenes' values in
N/m2 were formed with this one (364 m of rho g are 9.462726e6 N/m2), and scenes fall with it so that the printed ratio holds.
"""
