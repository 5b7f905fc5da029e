"""`silostudy doctor` tells what is there, and what is not with the command that brings it."""

import tomllib

from silostudy.__main__ import main
from silostudy.commands import doctor
from tests.conftest import ROOT


def test_it_tells_what_is_there_and_what_is_not(capsys, monkeypatch, tmp_path):
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    monkeypatch.setenv("PATH", str(tmp_path))
    (tmp_path / "chromium").write_text("#!/bin/sh\n")
    (tmp_path / "chromium").chmod(0o755)
    (tmp_path / "old").mkdir()
    (tmp_path / "old/kernel").write_bytes(bytes(3_000_000))
    assert main(["doctor"]) == 0
    said = dict(line.strip().split(None, 1) for line in capsys.readouterr().out.splitlines() if "  " in line.strip())
    assert said["numba"] == doctor.installed("numba") != ""
    assert said["chromium"] == str(tmp_path / "chromium")
    assert said["ccx"].endswith("Debian's package calculix-ccx")
    assert said["folder"].startswith(str(tmp_path))
    assert "3 MB in 1 folders" in said["of"]


def test_every_optional_distribution_stands_in_the_group_that_is_named():
    groups = tomllib.loads((ROOT / "pyproject.toml").read_text())["dependency-groups"]
    for name, (group, _) in doctor.OPTIONAL.items():
        assert any(line.split(">")[0] == name for line in groups[group]), name
