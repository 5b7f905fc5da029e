"""Lines of `silostudy check PROJECT.yaml`: every study and scene that a project names, one after another, and their time."""

from pathlib import Path

NAMED = 4  # studies without a time that are told by name


def project_checked(path: Path) -> None:
    """Prints what `check` says of each file of a project as it comes; BadInput at the end with the mistakes of all."""
    from silostudy.config.load import Mistakes, load_project
    from silostudy.errors import BadInput

    studies, scenes = load_project(path)
    mistakes, times = [], {}
    for name, file in (*studies.items(), *scenes.items()):
        try:
            lines, times[name] = _checked(file, studies, path)
            print("\n".join(lines), flush=True)
        except BadInput as error:
            mistakes += str(error).split("\n")
    if mistakes:
        raise Mistakes(mistakes)
    print(f"{path}: {len(times)} file(s), {together(times)}")


def _checked(file: Path, studies: dict[str, Path], project: Path) -> tuple[list[str], float | None]:
    """Lines on a file of a project, and its time (s) where that is known."""
    from silostudy.commands.check import checked
    from silostudy.config.load import check_lenders, read_study
    from silostudy.errors import NotYet

    if file in studies.values():
        check_lenders(file.stem, read_study(file), studies, project)
    try:
        return checked(file)
    except NotYet as error:
        if error.maker not in studies:
            raise
        return waiting(file, error.maker), None


def waiting(file: Path, maker: str) -> list[str]:
    """Lines on a study whose solid another study of the project makes first: of its own cases, those are known then."""
    from silostudy.commands.check import count_of
    from silostudy.config.load import read_study

    study = read_study(file)
    told = f"waits for a solid that {maker} makes first: its cases are looked at once that is there"
    return [f"{file}: {study.title}", f"  {count_of(study)} case(s), {told}"]


def together(times: dict[str, float | None]) -> str:
    """Time of all whose time is known, in words, and the names or the number of those whose time is not."""
    from silostudy.scene.costs import told_time

    known = [time for time in times.values() if time is not None]
    others = [name for name, time in times.items() if time is None]
    if not others:
        return f"together about {told_time(sum(known))} of one core"
    named = ", ".join(others) if len(others) <= NAMED else f"{len(others)} of them"
    told = f"of {named} no time is known before"
    return f"{told}, of the others together about {told_time(sum(known))} of one core" if known else told
