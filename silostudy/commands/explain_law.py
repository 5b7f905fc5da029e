"""Lines of `silostudy explain` on a contact law."""


def explanation(row) -> list[str]:
    """The lines that explain a law."""
    from silostudy.tables.references import with_locator

    lines = [f"{row.title} ({row.key})", f"  gives     {row.law.__doc__.splitlines()[0]}"]
    for coefficient in row.coefficients:
        lines.append(f"  takes     {coefficient.name} ({coefficient.unit}), {coefficient.range}{_from(coefficient)}")
        if coefficient.in_space is not None and "spheres" in row.grains:
            lines.append(f"            of spheres {coefficient.of_spheres.unit}{_from(coefficient.of_spheres)}")
    if row.dissipates:
        lines.append(f"  costs     energy of {', '.join(row.dissipates)}")
    return [*lines, f"  source    {with_locator(row.source, row.locator)}"]


def _from(coefficient) -> str:
    """The fields that a coefficient comes from."""
    fields = ", ".join(" or ".join(group) for group in coefficient.fields)
    return f": from {fields}" if fields else ""
