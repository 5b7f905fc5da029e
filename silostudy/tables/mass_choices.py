"""Shares of the contents that a seismic study lets move with the wall: its choices, and their short names."""

# choice -> (share of the contents' mass (1), or None where it is identified; name for legends); codes accept 80 % where
# nothing better is known: sasaki_yoshimura_effective_mass, section 1
MASS_CHOICES: dict[str, tuple[float | None, str]] = {
    "identified": (None, "identified"),
    "eighty_percent": (
        0.8,
        "80 %",
    ),
    "all_contents": (1.0, "all"),
}
STATED = {key: share for key, (share, _) in MASS_CHOICES.items() if share is not None}
USUAL = next(iter(STATED))  # what a study takes that says nothing
