"""Codes in processes of their own: what they answer, and what they do when they cannot."""

import os

import pytest

from silostudy.commands.own_process import OwnProcess
from silostudy.errors import BadInput


class Code:
    """A code that counts its steps."""

    def __init__(self, grains: int):
        if grains < 0:
            raise BadInput("grains", grains, "must not be negative")
        self.grains, self.steps, self.process = grains, 0, os.getpid()

    def step(self, steps: int) -> None:
        if steps < 0:
            raise BadInput("steps", steps, "must not be negative")
        self.steps += steps


@pytest.fixture
def code():
    code = OwnProcess(Code, 5)
    yield code
    code.close()


def test_a_code_is_called_in_a_process_of_its_own(code):
    assert code.step(3) >= 0.0
    code.step(4)
    assert (code.grains, code.get("steps")) == (5, 7)
    assert code.get("process") == code.process.pid != os.getpid()


def test_what_goes_wrong_in_it_is_raised_here_and_it_goes_on(code):
    with pytest.raises(BadInput, match="must not be negative"):
        code.step(-1)
    code.step(2)
    assert code.get("steps") == 2


def test_a_code_that_cannot_be_made_says_why():
    with pytest.raises(BadInput, match="grains"):
        OwnProcess(Code, -1)


def test_its_process_ends_with_it():
    code = OwnProcess(Code, 1)
    code.close()
    assert code.process.exitcode == 0
