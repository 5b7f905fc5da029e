"""Wall pressure theories and design codes: one file a member, all of them listed here."""

from silostudy.catalogue import Family
from silostudy.pressure import (
    aci313_1977,
    aij_container_draft,
    aij_load_draft,
    caquot,
    deutsch,
    din1055_1964,
    janssen,
    jenike_1969,
    jenike_funnel_flow,
    jenike_mass_flow,
    reimbert,
    safarian_steel,
    ty124_1956,
)
from silostudy.pressure.family import PressureMethod

MEMBERS = (
    janssen,
    reimbert,
    caquot,
    jenike_mass_flow,
    jenike_funnel_flow,
    jenike_1969,
    din1055_1964,
    ty124_1956,
    aci313_1977,
    aij_load_draft,
    aij_container_draft,
    safarian_steel,
    deutsch,
)

PRESSURE: Family[PressureMethod] = Family("pressure method", [member.ROW for member in MEMBERS])
