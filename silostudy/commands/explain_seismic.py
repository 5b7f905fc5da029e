"""Lines of `silostudy explain` on a way to the effective mass coefficient, and on the earthquake on a shell."""

EARTHQUAKE = "earthquake"


def explanation(row) -> list[str]:
    """The lines that explain an effective mass rule."""
    from silostudy.tables.references import with_locator

    return [
        f"{row.title} ({row.key})",
        f"  formula   {row.formula}",
        f"  range     {row.validity}",
        "  gives     effective mass coefficient: share of the contents' mass that moves with the wall (1)",
        f"  needs     {', '.join(row.needs) or 'nothing'}",
        f"  source    {with_locator(row.source, row.locator)}",
    ]


def earthquake() -> list[str]:
    """The lines that explain the load case that a shell study's section `earthquake` adds."""
    from silostudy.compute.shell_earthquake import UNCHECKED
    from silostudy.seismic.en1998_4 import ROW
    from silostudy.tables.references import with_locator

    return [
        "Earthquake on a silo's steel wall (section `earthquake` of a shell study, from a seismic study of the same silo)",
        "  axial     n = M / (pi R^2) beside the static axial wall force: + on the pressed side, - on the lifted side",
        "  pressure  dp = (a/g) gamma min(min(h_b, d_c/2), 3x), x above the flat bottom, a the wall's largest acceleration",
        "            pressed: added to the largest pressure, under which the foot yields; the smallest is left as it is",
        "            lifted: taken off the smallest pressure, which steadies the wall, down to 0",
        "  symbols   M bending moment of the tube (N m), R mid-wall radius (m), gamma unit weight (N m-3), h_b depth (m),",
        "            d_c inner diameter (m), a (m s-2): peaks over time, added to every phase as if they came at once",
        f"  not done  {UNCHECKED}",
        f"  source    {with_locator(ROW.source, ROW.locator)}",
    ]
