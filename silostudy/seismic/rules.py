"""The family of ways to an effective mass coefficient, identified or set by a code: each in the file of its function."""

from silostudy.catalogue import Family, members
from silostudy.seismic.family import MassRule

MASS_RULES: Family[MassRule] = Family("effective mass rule", members("silostudy.seismic", MassRule))
