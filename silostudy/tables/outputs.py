"""Pictures and tables drawn from a cube: one file each, all of them listed in tables/outputs.csv."""

from collections.abc import Iterable
from dataclasses import dataclass

from silostudy.catalogue import Family, Row
from silostudy.tables.read import HERE, rows
from silostudy.tables.references import cite

LISTS = ("axes", "methods", "phases", "rules")
ENDINGS = {"figure": ("png", "svg", "csv"), "table": ("csv",), "animation": ("webp",), "note": ("html",)}


@dataclass(frozen=True, kw_only=True)
class Output(Row):
    """A figure or table of a study.

    axes, methods, phases, rules: what it cannot do without; demands: what else the study must hold (see outputs.csv).
    The module of the same name in this room draws it (loaded only then: drawing needs matplotlib).
    """

    kind: str  # one of ENDINGS
    stage: str  # the cube it is drawn from
    also: tuple[str, ...]  # further cubes that it shows where the study has them
    axes: tuple[str, ...]
    methods: tuple[str, ...]
    phases: tuple[str, ...]
    rules: tuple[str, ...]
    demands: frozenset[str]

    @property
    def per_silo(self) -> bool:
        """Whether every silo of the study gets files of its own."""
        return self.kind == "note"

    @property
    def single_case(self) -> bool:
        return "single_case" in self.demands

    @property
    def only_axes(self) -> bool:
        return "only_axes" in self.demands

    @property
    def strakes(self) -> bool:
        return "strakes" in self.demands

    @property
    def hopper(self) -> bool:
        return "hopper" in self.demands


def _output(raw: dict) -> Output:
    cells: dict = {name: raw[name] for name in ("title", "kind", "source", "locator")}
    cells["stage"], *also = raw["stage"].split()
    cells |= {name: tuple(raw[name].split()) for name in LISTS}
    return Output(key=raw["output"], also=tuple(also), demands=frozenset(raw["demands"].split()), **cells)


_TEXT = ("output", "kind", "stage", "demands", *LISTS)
OUTPUTS: Family[Output] = Family("output", map(_output, rows(HERE / "outputs.csv", text=_TEXT)))


def output_of(module: str) -> Output:
    """The row of the output that a module of figures draws, by the module's dotted name."""
    return OUTPUTS[module.rpartition(".")[2]]


def files_of(key: str, folder: str, silos: Iterable[str] = ()) -> list[str]:
    """Files of an output in the folder of a study's results: a figure as PNG, SVG and the numbers it shows, a table as CSV.

    silos: the cases that name the silos of the study, each with a file of its own where the output is of one silo.
    """
    row = OUTPUTS[key]
    stems = [f"{key}-{silo}" for silo in silos] if row.per_silo else [key]
    return [f"{folder}/{row.kind}s/{stem}.{ending}" for stem in stems for ending in ENDINGS[row.kind]]


def caption(key: str) -> str:
    """Caption of an output in the report (reStructuredText), where Snakemake puts the name of the cube in."""
    row = OUTPUTS[key]
    place = row.locator[0].upper() + row.locator[1:]
    return f"{row.title}.\n\nSource: {cite(row.source)} {place}.\n\nDrawn from ``{{{{ snakemake.input[0] }}}}``.\n"
