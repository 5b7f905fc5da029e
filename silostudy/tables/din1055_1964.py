"""Table 4.2.3: DIN 1055's lateral pressure ratios and shares of the internal friction angle."""

from silostudy.tables.read import HERE, rows

COEFFICIENTS = {row["grain"]: row for row in rows(HERE / "din1055_1964.csv", text=("grain", "particle_size"))}
