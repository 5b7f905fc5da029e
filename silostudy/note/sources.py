"""Sources as a note names them beside a line."""

CODES = {
    "en1990": "EN 1990",
    "en1991_4_2006": "EN 1991-4:2006",
    "en1993_1_6_2007": "EN 1993-1-6:2007",
    "en1993_1_6_2025": "EN 1993-1-6:2025",
    "en1993_4_1": "EN 1993-4-1",
    "en1998_4_2006": "EN 1998-4:2006",
    "as_nzs_1170_2": "AS/NZS 1170.2",
    "classical_buckling": "classical",
}


def short(source: str) -> str:
    """A code by its number; any other reference by its key."""
    return CODES.get(source, source)
