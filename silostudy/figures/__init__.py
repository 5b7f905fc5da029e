"""Pictures and tables drawn from a cube: one file each, all of them listed here."""

from dataclasses import dataclass

from silostudy.catalogue import Family, Row


@dataclass(frozen=True, kw_only=True)
class Output(Row):
    """A figure or table of a study.

    axes: sweep axes it needs; single_case: it shows one silo, so it needs a study without sweep.
    The module of the same name in this room draws it (loaded only then: drawing needs matplotlib).
    """

    kind: str  # "figure" or "table"
    stage: str  # the cube it is drawn from
    axes: tuple[str, ...] = ()
    single_case: bool = False
    methods: tuple[str, ...] = ()  # methods whose curves it cannot do without
    phases: tuple[str, ...] = ()  # phases likewise
    hopper: bool = False  # it shows the hopper wall, so the study must ask for hopper_position


OUTPUTS: Family[Output] = Family(
    "output",
    [
        Output(
            key="fig_4_2_11",
            title="Wall pressure over depth by every theory and code, and its ratio to static Janssen",
            source="silo_handbook",
            locator="Fig. 4.2.11",
            kind="figure",
            stage="pressure",
            single_case=True,
            methods=("janssen",),
            phases=("filling",),
        ),
        Output(
            key="table_4_2_5",
            title="The source's table of wall pressures, printed against computed",
            source="silo_handbook",
            locator="Table 4.2.5",
            kind="table",
            stage="pressure",
            single_case=True,
        ),
        Output(
            key="overpressure_over_slenderness",
            title="Overpressure factor over H/D by method",
            source="silo_handbook",
            locator="section 4.2.3",
            kind="figure",
            stage="pressure",
            axes=("slenderness",),
            phases=("discharge",),
        ),
        Output(
            key="governing_method",
            title="Which method asks for the largest wall pressure, over diameter and H/D",
            source="silo_handbook",
            locator="section 4.2.3",
            kind="figure",
            stage="pressure",
            axes=("diameter", "slenderness"),
        ),
        Output(
            key="silo_pressures",
            title="Wall pressures of cylinder and hopper drawn off the wall, with the balance of forces",
            source="silo_handbook",
            locator="section 4.5.2, Fig. 1",
            kind="figure",
            stage="pressure",
            single_case=True,
            phases=("filling", "discharge"),
            hopper=True,
        ),
        Output(
            key="comparison_today",
            title="Fig. 4.2.11 with the codes in use today, the band of upper and lower values, and measured points",
            source="silo_handbook",
            locator="Fig. 4.2.11",
            kind="figure",
            stage="pressure",
            single_case=True,
            phases=("filling",),
            methods=("janssen",),
        ),
        Output(
            key="jenike_charts",
            title="Peak of the initial hopper pressure i_1 and force of the flow field q_2 over the half angle",
            source="silo_handbook",
            locator="section 4.5.2, Figs. 5 and 6",
            kind="figure",
            stage="pressure",
            axes=("half_angle", "hopper_friction"),
            methods=("jenike_1969",),
            phases=("filling", "discharge"),
            hopper=True,
        ),
        Output(
            key="governing_load_case",
            title="Which load case gives the largest hopper wall pressure, over H/D and half angle",
            source="silo_handbook",
            locator="section 4.5.3, Fig. 1",
            kind="figure",
            stage="pressure",
            axes=("half_angle", "slenderness"),
            phases=("filling", "discharge"),
            hopper=True,
        ),
        Output(
            key="uncertainty_bands",
            title="Wall pressure over depth with the scatter of the stored solid, method by method",
            source="silo_handbook",
            locator="Fig. 4.2.11",
            kind="figure",
            stage="uncertainty",
            single_case=True,
        ),
        Output(
            key="sobol_indices",
            title="Which property of the stored solid matters for the largest wall pressure, method by method",
            source="silo_handbook",
            locator="Fig. 4.2.11",
            kind="figure",
            stage="uncertainty",
            single_case=True,
        ),
        Output(
            key="measured_silos",
            title="Measured wall pressures against every method",
            source="silo_handbook",
            locator="section 4.2.3",
            kind="figure",
            stage="pressure",
            axes=("silo",),
        ),
    ],
)
