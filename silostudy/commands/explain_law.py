"""What `silostudy explain` says of a contact law."""


def explanation(row) -> list[str]:
    """The lines that explain a law."""
    from silostudy.tables.references import with_locator

    lines = [f"{row.title} ({row.key})", f"  gives     {row.law.__doc__.splitlines()[0]}"]
    for one in row.coefficients:
        fields = ", ".join(" or ".join(group) for group in one.fields)
        lines.append(f"  takes     {one.name} ({one.unit}), {one.range}" + (f": from {fields}" if fields else ""))
    if row.dissipates:
        lines.append(f"  costs     energy of {', '.join(row.dissipates)}")
    return [*lines, f"  source    {with_locator(row.source, row.locator)}"]
