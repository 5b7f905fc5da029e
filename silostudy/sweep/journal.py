"""Finished cases of a sweep, a line each with its checksum: a killed job, a full disk, a broken file cost only their lines."""

import fcntl
import json
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from zlib import crc32

ENDING = ".jsonl"


def line(key: str, record: dict[str, Any]) -> bytes:
    """One line: checksum, key of the case, its record as JSON (floats come back to the bit, NaN and infinity included)."""
    text = f"{key} {json.dumps(record, separators=(',', ':'))}".encode()
    return b"%08x %s\n" % (crc32(text), text)


def sound(path: Path) -> Iterator[tuple[str, bytes]]:
    """Key and JSON of each line whose checksum holds; none where there is no file."""
    if not path.exists():
        return
    with path.open("rb") as stream:
        for raw in stream:
            check, _, text = raw.rstrip(b"\n").partition(b" ")
            if check == b"%08x" % crc32(text):
                key, _, record = text.partition(b" ")
                yield key.decode(), record


def failed(record: bytes) -> bool:
    """Whether the record tells of an error."""
    return record.startswith(b'{"error"')


def forget_failed(path: Path) -> int:
    """Takes failed cases out of a journal; how many they were."""
    records = [(key, record) for key, record in sound(path)]
    left = [line(key, json.loads(record)) for key, record in records if not failed(record)]
    if len(left) < len(records):
        temporary = path.with_suffix(".tmp")
        temporary.write_bytes(b"".join(left))
        temporary.replace(path)
    return len(records) - len(left)


class Journal:
    """A journal that one process at a time adds to; others wait until it is closed, by its end or by their death."""

    def __init__(self, path: Path):
        self.path = path

    def __enter__(self):
        self.path.parent.mkdir(parents=True, exist_ok=True)
        self.handle = os.open(self.path, os.O_RDWR | os.O_APPEND | os.O_CREAT, 0o666)
        fcntl.flock(self.handle, fcntl.LOCK_EX)
        size = os.fstat(self.handle).st_size
        if size and os.pread(self.handle, 1, size - 1) != b"\n":
            os.write(self.handle, b"\n")  # ends a line that was cut off: it stays, unsound
        return self

    def __exit__(self, kind, error, trace) -> None:
        os.close(self.handle)

    def keys(self) -> set[str]:
        """Keys of the cases that are done."""
        return {key for key, _ in sound(self.path)}

    def add(self, key: str, record: dict[str, Any]) -> None:
        """Writes a record so that it outlives the process; OSError where it does not fit."""
        content = line(key, record)
        if os.write(self.handle, content) < len(content):
            raise OSError(28, os.strerror(28), str(self.path))  # the disk is full: the next write would say so
        os.fsync(self.handle)
