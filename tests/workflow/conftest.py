"""A project of hard names whose pipeline has run, for all tests that look at it or break a copy of it."""

import shutil

import pytest

from tests.workflow.projects import make, snakemake


@pytest.fixture(scope="session")
def run(tmp_path_factory):
    """(folder, what Snakemake said) of a whole run; the folder is not to be changed."""
    folder = make(tmp_path_factory.mktemp("hard") / "n a;$HOME{x}+([|'\"ü&*?#")
    done = snakemake(folder)
    assert done.returncode == 0, done.stdout[-3000:]
    return folder, done.stdout


@pytest.fixture
def finished(run, tmp_path):
    """A copy of the finished project, with its times, to be changed."""
    return shutil.copytree(run[0], tmp_path / "finished")
