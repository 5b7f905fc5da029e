"""What `silostudy explain` says of a contact law."""


def explanation(row) -> list[str]:
    """The lines that explain a law."""
    from silostudy.tables.references import with_locator

    lines = [f"{row.title} ({row.key})", f"  gives     {row.law.__doc__.splitlines()[0]}"]
    for one in row.coefficients:
        lines.append(f"  takes     {one.name} ({one.unit}), {one.range}{_from(one)}")
        if one.in_space is not None and "spheres" in row.grains:
            lines.append(f"            of spheres {one.of_spheres.unit}{_from(one.of_spheres)}")
    if row.dissipates:
        lines.append(f"  costs     energy of {', '.join(row.dissipates)}")
    return [*lines, f"  source    {with_locator(row.source, row.locator)}"]


def _from(one) -> str:
    """The fields that a coefficient comes from."""
    fields = ", ".join(" or ".join(group) for group in one.fields)
    return f": from {fields}" if fields else ""
