"""Journals of finished cases: what survives a torn line, a flipped bit, a full disk; who may write."""

import math
import os
import subprocess
import sys

import pytest

from silostudy.sweep.journal import Journal, failed, forget_failed, line, sound


@pytest.fixture
def path(tmp_path):
    with Journal(tmp_path / "a.jsonl") as journal:
        for number in range(5):
            journal.add(f"k{number}", {"case": "c", "numbers": {"x": number / 3}})
    return tmp_path / "a.jsonl"


def keys(path):
    return [key for key, _ in sound(path)]


def test_numbers_come_back_to_the_bit(tmp_path):
    import json

    values = [math.pi, 1e-320, -0.0, math.inf, math.nan, 0.1 + 0.2]
    with Journal(tmp_path / "a.jsonl") as journal:
        journal.add("k", {"numbers": {"x": values}})
    ((_, record),) = sound(tmp_path / "a.jsonl")
    assert [value.hex() for value in json.loads(record)["numbers"]["x"]] == [value.hex() for value in values]


@pytest.mark.parametrize("cut", [2, 7, 30])
def test_a_torn_line_is_lost_alone_and_does_not_spoil_the_next(path, cut):
    os.truncate(path, path.stat().st_size - cut)
    assert keys(path) == ["k0", "k1", "k2", "k3"]
    with Journal(path) as journal:
        assert journal.keys() == {"k0", "k1", "k2", "k3"}
        journal.add("k4", {"case": "c"})
    assert keys(path) == ["k0", "k1", "k2", "k3", "k4"]


def test_a_record_without_its_line_end_is_whole(path):
    os.truncate(path, path.stat().st_size - 1)
    with Journal(path) as journal:
        journal.add("k5", {"case": "c"})
    assert keys(path) == [f"k{number}" for number in range(6)]


def test_a_flipped_bit_loses_its_line_alone(path):
    content = bytearray(path.read_bytes())
    content[content.index(b"k2") + 30] ^= 1
    path.write_bytes(content)
    assert keys(path) == ["k0", "k1", "k3", "k4"]


def test_failed_cases_can_be_forgotten(path):
    with Journal(path) as journal:
        journal.add("k5", {"error": "ran away", "case": "c"})
    assert [failed(record) for _, record in sound(path)] == [False] * 5 + [True]
    assert forget_failed(path) == 1
    assert keys(path) == [f"k{number}" for number in range(5)]
    assert forget_failed(path) == 0


def test_one_writer_at_a_time(path):
    """Another process waits for the journal until its holder is gone, and then sees what the holder wrote."""
    script = "import sys; from pathlib import Path; from silostudy.sweep.journal import Journal\n"
    script += f"with Journal(Path({str(path)!r})) as journal: print(len(journal.keys()))"
    with Journal(path) as journal:
        waiting = subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True)
        with pytest.raises(subprocess.TimeoutExpired):
            waiting.wait(timeout=1.5)
        journal.add("k5", {"case": "c"})
    assert waiting.communicate(timeout=30)[0].strip() == "6"


def test_a_full_disk_is_an_error(path, monkeypatch):
    with Journal(path) as journal:
        monkeypatch.setattr(os, "write", lambda handle, content: len(content) - 3)
        with pytest.raises(OSError, match="No space left"):
            journal.add("k5", {"case": "c"})


def test_a_line_names_its_key():
    assert line("abc", {"a": 1}).split(b" ")[1:] == [b"abc", b'{"a":1}\n']
