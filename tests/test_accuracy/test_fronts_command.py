"""`silostudy fronts`: which rows it writes, and what it says of trials."""

import pandas as pd
import pytest

from silostudy.__main__ import main
from silostudy.accuracy import fronts
from silostudy.accuracy.trial import Trial, front_row
from silostudy.choice.fronts import COLUMNS
from tests.conftest import ROOT

SHIPPED = ROOT / "silostudy/tables/fronts.csv"


@pytest.fixture
def shells(monkeypatch):
    """Stands for the shells' own measuring."""

    class Shells:
        @staticmethod
        def measured_fronts(tell):
            settings = {"relative_depth": {"start": 0.0, "stop": 1.0, "count": 4}}
            return [front_row("shell", "axial_wall_force", settings, 0.1234, 1e-5, 7, "silo_handbook")]

        @staticmethod
        def trials(tell):
            return [
                Trial("shell", "axial_wall_force", 0.1, error, cost, 1.0, 6.0, 4.0) for error, cost in ((0.05, 1), (0.2, 3))
            ]

    monkeypatch.setattr(fronts, "_of", lambda kind: {"shell": Shells}[kind])


def test_one_kind_is_measured_anew_and_the_rest_stays(shells, tmp_path):
    output = tmp_path / "fronts.csv"
    main(["fronts", "--kind", "shell", "--output", str(output)])
    assert output.read_text().split("\nkind,")[0] == SHIPPED.read_text().split("\nkind,")[0]
    found, before = (pd.read_csv(path, comment="#", keep_default_na=False, dtype=str) for path in (output, SHIPPED))
    assert tuple(found) == COLUMNS
    assert found[found["kind"] == "shell"]["error"].tolist() == ["0.123"]
    rest = [table[table["kind"] != "shell"].reset_index(drop=True) for table in (found, before)]
    assert rest[0][["kind", "quantity", "settings", "within", "machine"]].equals(
        rest[1][["kind", "quantity", "settings", "within", "machine"]]
    )
    assert rest[0]["error"].astype(float).tolist() == rest[1]["error"].astype(float).tolist()


def test_trials_are_summed_up_by_quantity(shells, tmp_path, capsys):
    main(["fronts", "--trial", "--kind", "shell", "--output", str(tmp_path / "trial.csv")])
    told = capsys.readouterr().out
    assert "shell, axial_wall_force: met in 50.0% of 2; at most 1.5 times the cheapest cost in 50%; median ratio 2.00" in told
    assert "1.5 times the fewest levels, samples or runs" in told
    assert len(pd.read_csv(tmp_path / "trial.csv")) == 2


def test_an_unknown_kind_lists_the_known(capsys):
    assert main(["fronts", "--kind", "shells"]) == 2
    assert "unknown; known: dem, packing, pressure, seismic, shell" in capsys.readouterr().err
