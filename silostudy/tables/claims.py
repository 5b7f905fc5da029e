"""Claims of a source on its runs, each as a quantity and its range."""

from dataclasses import dataclass

from silostudy.tables.read import HERE, rows

TEXT = ("claim", "variable", "measure", "printed")


@dataclass(frozen=True)
class Claim:
    """A claim: the quantity (a variable of the cube) that must lie between two bounds, and what the source prints."""

    claim: str
    across: int | None  # of the packing it is said of; None: of every packing
    variable: str
    measure: str
    at_least: float
    at_most: float
    printed: str
    remark: str
    locator: str


def kiyama_1983() -> list[Claim]:
    """The claims of Kiyama and Fujimura (1983)."""
    names = (*TEXT, "at_least", "at_most", "remark", "locator")
    return [
        Claim(across=int(row["across"]) if "across" in row else None, **{name: row[name] for name in names})
        for row in rows(HERE / "kiyama_1983_claims.csv", text=TEXT)
    ]
