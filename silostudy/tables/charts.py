"""Charts that a source gives in place of a formula, as points."""

import numpy as np

from silostudy.tables.read import HERE, rows


def chart(method: str) -> tuple[np.ndarray, np.ndarray]:
    """Places z/D (1) and values (1) of a method's chart, each of shape (points,)."""
    points = [row for row in rows(HERE / "charts.csv", text=("method",)) if row["method"] == method]
    return np.array([p["relative_depth"] for p in points]), np.array([p["value"] for p in points])
