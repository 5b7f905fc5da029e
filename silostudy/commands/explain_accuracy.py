"""Lines of `silostudy explain accuracy`: which kinds of study may ask for which accuracy, and what their errors hang on."""

KEY = "accuracy"
BY_RUNS = [
    "    of discs and spheres, by any law and filling, in a study of kind scenes: each case is the mean of as many fillings as",
    "    its scatter asks for; an eighth of them are computed at half the time step too, which is taken where it changes the",
    "    mean beyond chance; the cube holds errors asked for and found, fillings, CPU time and its part on the step",
]


def explanation() -> list[str]:
    """The lines that explain the key `accuracy`."""
    from silostudy.choice.fronts import TRAITS
    from silostudy.stages import FILE_KINDS
    from silostudy.tables.asked import quantities

    lines = [
        "Accuracy in place of settings: `accuracy: {QUANTITY: largest relative error}` in a study or a discrete-element scene",
        "  the cheapest measured settings (`silostudy list accuracies`) that keep it in every case are taken, and recorded",
    ]
    for kind, row in FILE_KINDS.items():
        if "accuracy" not in row.study.model_fields:
            lines.append(f"  {kind}: may not ask: {row.study.unasked}")
            continue
        for name, quantity in quantities(row.study.fronts).items():
            lines.append(f"  {kind}, {name}: {quantity.title}")
            lines += _by_fronts(row.study.fronts, quantity) if quantity.decides else BY_RUNS
    return [*lines, "Numbers of a scene that errors hang on:", *(f"  {name}: {title}" for name, title in TRAITS.items())]


def _by_fronts(fronts, quantity) -> list[str]:
    from silostudy.choice.fronts import rows_for

    rows = rows_for(fronts, [quantity.name])
    told = f"    sets {', '.join(quantity.decides)}; measured on {rows[0].machine}, {rows[0].measured_on}"
    return [told, *(f"    {text}" for text in dict.fromkeys(map(_traits, rows)))]


def _traits(row) -> str:
    ranges = ", ".join(f"{name} {low:g} to {high:g}" for name, (low, high) in row.within.items())
    return f"error goes with {row.scaled_by or 'no trait'}; measured within {ranges or 'any scene'}"
