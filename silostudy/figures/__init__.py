"""Pictures and tables drawn from a cube: one file each, all of them listed here."""

from dataclasses import dataclass

from silostudy.catalogue import Family, Row
from silostudy.figures.seismic_rows import SEISMIC


@dataclass(frozen=True, kw_only=True)
class Output(Row):
    """A figure or table of a study.

    axes: sweep axes it needs; only_axes: it can show no others; single_case: it shows one silo, so it needs a study without
    sweep; strakes: it needs a wall of given thickness; hopper: it shows the hopper wall, so the study must ask for
    hopper_position.
    The module of the same name in this room draws it (loaded only then: drawing needs matplotlib).
    """

    kind: str  # "figure" or "table"
    stage: str  # the cube it is drawn from
    axes: tuple[str, ...] = ()
    single_case: bool = False
    methods: tuple[str, ...] = ()  # methods whose curves it cannot do without
    phases: tuple[str, ...] = ()  # phases likewise
    rules: tuple[str, ...] = ()  # buckling rules it cannot do without
    only_axes: bool = False
    strakes: bool = False
    hopper: bool = False


SHELL_AXES = ("radius_over_thickness", "relative_bay_length", "ring_area_ratio", "steel", "making")

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
            key="miller_fig_1",
            title="C M^2 against M^2: Miller's elastic local coefficient and his tests",
            source="miller1977",
            locator="Fig. 1",
            kind="figure",
            stage="buckling",
            axes=("test",),
            only_axes=True,
        ),
        Output(
            key="miller_fig_2_3",
            title="C and J against R/t with their lower bounds",
            source="miller1977",
            locator="Figs. 2, 3",
            kind="figure",
            stage="buckling",
            axes=("test",),
            only_axes=True,
        ),
        Output(
            key="miller_fig_4_5",
            title="General buckling: C_3 M_e^2 against M_e^2, C_3 against ring area",
            source="miller1977",
            locator="Figs. 4, 5",
            kind="figure",
            stage="buckling",
            axes=("test",),
            only_axes=True,
        ),
        Output(
            key="miller_fig_6_7",
            title="Inelastic buckling: formula against tests with and without rings",
            source="miller1977",
            locator="Figs. 6, 7",
            kind="figure",
            stage="buckling",
            axes=("test",),
            rules=("miller1977",),
            only_axes=True,
        ),
        Output(
            key="test_over_prediction",
            title="Test over prediction by rule and by rival reading of the source",
            source="miller1977",
            locator="Tables 2, 3",
            kind="figure",
            stage="buckling",
            axes=("test",),
            only_axes=True,
        ),
        Output(
            key="miller_statistics",
            title="Test over prediction: mean, scatter, least, largest by group of tests",
            source="miller1977",
            locator="Tables 2, 3",
            kind="table",
            stage="buckling",
            axes=("test",),
            only_axes=True,
        ),
        Output(
            key="miller_tests",
            title="Every test with every rule, and the errors of the source",
            source="miller1977",
            locator="Tables 2, 3",
            kind="table",
            stage="buckling",
            axes=("test",),
            only_axes=True,
        ),
        Output(
            key="knockdown_over_slenderness",
            title="Elastic knock-down factor against R/t by rule, tests as points",
            source="miller1977",
            locator="Table 2",
            kind="figure",
            stage="buckling",
            axes=SHELL_AXES,
            only_axes=True,
        ),
        Output(
            key="buckling_stress_map",
            title="Buckling stress over R/t and bay length by rule",
            source="miller1977",
            locator="eqs. (1) to (15)",
            kind="figure",
            stage="buckling",
            axes=SHELL_AXES,
            only_axes=True,
        ),
        Output(
            key="ring_area_map",
            title="Buckling stress over R/t and ring area, and which mode governs",
            source="miller1977",
            locator="eqs. (8) to (12)",
            kind="figure",
            stage="buckling",
            axes=SHELL_AXES,
            rules=("miller1977",),
            only_axes=True,
        ),
        Output(
            key="strength_over_pressure",
            title="Buckling stress over internal pressure: help first, then the elephant's foot",
            source="en1993_4_1",
            locator="axial compression with internal pressure",
            kind="figure",
            stage="buckling",
            axes=("radius_over_thickness", "internal_pressure"),
            only_axes=True,
        ),
        Output(
            key="required_thickness",
            title="Wall thickness that each pressure method and buckling rule asks for, over D and H/D",
            source="silo_handbook",
            locator="sections 4.2.2 and 4.5.4",
            kind="figure",
            stage="shell",
            axes=("diameter", "slenderness", "wall_friction_end"),
            rules=("en1993_1_6_2007",),
            methods=("janssen",),
            only_axes=True,
        ),
        Output(
            key="shell_over_depth",
            title="A steel wall over its depth: force, pressure, strength, utilisation",
            source="silo_handbook",
            locator="sections 4.2.2 and 4.5.4",
            kind="figure",
            stage="shell",
            axes=("wall_friction_end",),
            only_axes=True,
            strakes=True,
        ),
        Output(
            key="shell_summary",
            title="Where a steel wall is used most, by rule, method and phase",
            source="silo_handbook",
            locator="sections 4.2.2 and 4.5.4",
            kind="table",
            stage="shell",
            strakes=True,
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
        *(
            Output(key=key, title=title, source="sasaki_yoshimura_effective_mass", locator=locator, kind=kind, stage="seismic")
            for key, (title, locator, kind) in SEISMIC.items()
        ),
    ],
)
