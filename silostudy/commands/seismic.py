"""What `silostudy check` says of a seismic study."""


def told(expansion) -> list[str]:
    """What a seismic study shakes with, judges by, and assumes."""
    study, lines = expansion.study, []
    if asked := study.identification:
        count, trials = len(asked.fine_coefficients), asked.recovery_trials
        lines.append(f"{count} coefficients x 3 damping ratios and 2 stiffnesses, and {trials} recovery trials a case")
    lines += dict.fromkeys(f"base motion: {case.scene.base.origin}" for case in expansion.cases)
    if any(case.scene.imitation for case in expansion.cases):
        lines.append("note: the measured response is synthetic")
    return [*lines, f"note: assumed are {', '.join(study.assumed)}"] if study.assumed else lines
