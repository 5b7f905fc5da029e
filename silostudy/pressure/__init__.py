"""Wall pressure theories and design codes: one file a member, all of them listed here."""

from silostudy.catalogue import Family
from silostudy.pressure import (
    aci313_1977,
    aij_container_draft,
    aij_load_draft,
    as3774_1996,
    caquot,
    deutsch,
    din1055_1964,
    en1991_4,
    janssen,
    jenike_1969,
    jenike_funnel_1973,
    jenike_funnel_flow,
    jenike_mass_flow,
    pieper_flour,
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
    jenike_funnel_1973,
    din1055_1964,
    ty124_1956,
    aci313_1977,
    aij_load_draft,
    aij_container_draft,
    safarian_steel,
    deutsch,
    pieper_flour,
    en1991_4,
    as3774_1996,
)

PRESSURE: Family[PressureMethod] = Family(
    "pressure method", [row for member in MEMBERS for row in getattr(member, "ROWS", None) or (member.ROW,)]
)
