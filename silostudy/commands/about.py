"""What `silostudy check` says of a study, kind by kind: each function takes an expansion and gives lines."""


def pressures(expansion) -> list[str]:
    """How much a study of pressures computes."""
    from silostudy.compute.pressure import silent_cube
    from silostudy.cube.silence import silences

    study = expansion.study
    methods = len(study.method_keys) + len(study.as_printed)
    values = len(expansion.cases) * methods * len(study.phases) * len(study.depths)
    lines = [f"{methods} method(s) x {len(study.phases)} phase(s) x {len(study.depths)} depths: {values} values a quantity"]
    return [*lines, *(f"note: {line}" for line in silences(silent_cube(expansion)))]


def cautions(expansion) -> list[str]:
    """What a study's author should know although it is no mistake."""
    from silostudy.scene.scene import solid_parameters

    found: dict[str, int] = {}
    for case in expansion.cases:
        parameters = solid_parameters(case.scene, "")
        wall = case.scene.wall.key if case.scene.wall else "its own wall friction"
        if parameters["wall_friction"] < parameters["wall_friction_uncapped"]:
            text = f"{case.scene.solid.key} on {wall}: wall friction {parameters['wall_friction_uncapped']:.3g} capped at "
            found[f"{text}tan(phi) = {parameters['wall_friction']:.3g}"] = 1
        for name in ("wall_friction", "poisson_ratio"):
            if parameters[name] != parameters[name]:
                text = f"{case.scene.solid.key} on {wall}: no {name} in the tables; methods that need it are masked"
                found[text] = 1
    return [f"note: {text}" for text in (*found, *unusual_inputs(expansion), *_switches(expansion))]


def unusual_inputs(expansion) -> list[str]:
    """Which inputs of a study's silos and solids can be but hardly are, each once."""
    from silostudy.scene.possible import unusual
    from silostudy.scene.scene import Scene

    scenes = (case.scene for case in expansion.cases if isinstance(case.scene, Scene))
    return list(dict.fromkeys(text for scene in scenes for text in unusual(scene)))


def _switches(expansion) -> list[str]:
    """Which methods a switch of the scene leaves as they are."""
    from silostudy.pressure import PRESSURE

    rows = [expansion.study.family(PRESSURE)[key] for key in expansion.study.method_keys]
    keep = [row.key for row in rows if "wall_friction" in row.varies]
    if keep and any(case.scene.wall_friction_end == "upper" for case in expansion.cases):
        return [f"wall_friction_end: upper does not move {', '.join(keep)}: they vary the wall friction themselves"]
    return []


def shaking(expansion) -> list[str]:
    """What a seismic study shakes with, judges by, and assumes."""
    study, lines = expansion.study, []
    if asked := study.identification:
        count, trials = len(asked.fine_coefficients), asked.recovery_trials
        lines.append(f"{count} coefficients x 3 damping ratios and 2 stiffnesses, and {trials} recovery trials a case")
    lines += dict.fromkeys(f"base motion: {case.scene.base.origin}" for case in expansion.cases)
    if any(case.scene.imitation for case in expansion.cases):
        lines.append("note: the measured response is synthetic")
    return [*lines, f"note: assumed are {', '.join(study.assumed)}"] if study.assumed else lines


def earthquake(expansion) -> list[str]:
    """Which earthquake a shell study lays on its wall, and what is not checked with it."""
    from silostudy.compute.shell_earthquake import UNCHECKED

    asked = expansion.study.earthquake
    return [f"earthquake: {asked.study}, {asked.mass_choice}", f"note: {UNCHECKED}"] if asked else []


def time_of_parts(expansion) -> list[str]:
    """About what a sweep costs: from the measured time of a case where the study states it, else from discs and steps."""
    from silostudy.sweep.plan import parts_of

    study, parts = expansion.study, parts_of(expansion.study)
    seconds = sum(study.case_s or parts.call("cost", case.scene) for case in expansion.cases)
    return [f"at most about {seconds / 60:.3g} min of one core, a kernel's compiling apart"]


def rules(expansion) -> list[str]:
    """How many buckling rules judge the shell."""
    return [f"{len(expansion.study.rule_keys)} buckling rule(s)"]
