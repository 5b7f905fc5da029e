"""Wall pressures of silos by theories, design codes and discrete elements, as parametric studies."""

from pathlib import Path

__version__ = "1.0.0"
PACKAGE = Path(__file__).parent
