"""The netCDF contract: which variables exist, with which units and dimensions; all writing and reading passes here."""
