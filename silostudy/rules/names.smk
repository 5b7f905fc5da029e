# Names and paths of the user's: what Snakemake can carry goes through as it is, and the rest is refused in one line.

import re
from itertools import count
from os.path import normpath

from snakemake.io import contains_wildcard


def path_of(key, usual):
    """A path from Snakemake's own --config."""
    given = config.get(key, usual)
    if not isinstance(given, str) or not given:
        raise BadInput(key, given, "Snakemake reads this as no text: begin it with ./, or choose another name")
    path = Path(normpath(given))
    return carried(key, path.absolute() if given.startswith("-") else path)  # no option of a command


def carried(what, name):
    """A path or name itself; BadInput where Snakemake or the netCDF library would take it for something else."""
    for told, is_there in {
        "{word} in braces": contains_wildcard(name),
        "a line break": re.search(r"[\n\r]", str(name)),
        "a backslash": "\\" in str(Path(name).absolute()),
    }.items():
        if is_there:
            raise BadInput(what, str(name), f"{told} means something else to Snakemake or the netCDF library: rename it")
    return name


def one_of(names):
    """A regular expression for any of some names, or for nothing; Snakemake takes no braces in one."""
    return "|".join(map(re.escape, names)).replace("\\{", r"\x7b").replace("\\}", r"\x7d") or "(?!)"


def name_of_rule(*words):
    """A name of letters, digits and underscores that no rule has yet."""
    name = re.sub(r"\W", "_", "_".join(words))
    return next(free for free in chain([name], (f"{name}_{k}" for k in count(2))) if not workflow.is_rule(free))
