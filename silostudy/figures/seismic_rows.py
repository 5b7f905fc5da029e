"""Figures and tables of a seismic study: what their rows in the list of outputs say."""

SEISMIC = {  # key -> title, locator, kind
    "seismic_resonance": ("Resonance curves of the empty and the filled tube", "section 3 and Fig. 2", "figure"),
    "seismic_histories": (
        "Histories of base and top, measured and computed with several coefficients",
        "Figs. 3 and 6",
        "figure",
    ),
    "seismic_spectra": ("Fourier amplitudes of the top, measured and computed with several coefficients", "Fig. 4", "figure"),
    "seismic_indices": (
        "Likeness indices over the effective mass coefficient, with the first frequency",
        "Figs. 5 and 7",
        "figure",
    ),
    "seismic_recovery": (
        "How well a known coefficient is found again, and what moves the answer",
        "equations (3) and (5)",
        "figure",
    ),
    "seismic_demand": ("Shear, moment, axial wall force and additional wall pressure over depth", "section 1", "figure"),
    "sasaki_1991": ("The source's printed numbers beside the computed ones", "sections 3 and 4", "table"),
}
