"""What a command prints when a user types it."""

from silostudy.__main__ import main
from tests.conftest import ROOT

WHEAT = str(ROOT / "config/studies/wheat-silo.yaml")


def said(capsys, *arguments, status=0):
    assert main(list(map(str, arguments))) == status
    captured = capsys.readouterr()
    return captured.out if status == 0 else captured.err
