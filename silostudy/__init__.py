"""Wall pressures of silos by theories, design codes and discrete elements, as parametric studies."""

__version__ = "0.1.0"
