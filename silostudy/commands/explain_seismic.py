"""What `silostudy explain` says of a way to the effective mass coefficient."""


def explanation(row) -> list[str]:
    """The lines that explain an effective mass rule."""
    from silostudy.tables.references import cite

    return [
        f"{row.title} ({row.key})",
        f"  formula   {row.formula}",
        f"  range     {row.validity}",
        "  gives     effective mass coefficient: share of the contents' mass that moves with the wall (1)",
        f"  needs     {', '.join(row.needs) or 'nothing'}",
        f"  source    {row.source}, {row.locator}: {cite(row.source)}",
    ]
