"""Files as they come to be broken: cut off, bytes changed, pieces lost, doubled or moved, numbers replaced."""

from hypothesis import strategies as st

NUMBERS = (b"nan", b"-inf", b"1e400", b"0", b"-1", b"0.0", b"1.D-2", b"1_0", b"9" * 50, "٣".encode(), b"2001-13-45")
SIGNS = (
    b"",
    b",",
    b"\n",
    b"\r",
    b'"',
    b"#",
    b"=",
    b": ",
    b"{",
    b"&a *a",
    b"(g)",
    b"\x00",
    b"\xff\xfe",
    b"\xef\xbb\xbf",
    b"GCOL",
)


def mutated(seeds: list[bytes]):
    """Strategy: one of the seeds after none to a few mutations, or bytes that never were such a file."""
    kinds = st.sampled_from((_cut, _change, _insert, _lose, _double, _swap))
    step = st.tuples(
        kinds, st.floats(0, 1), st.floats(0, 1), st.one_of(st.sampled_from(NUMBERS + SIGNS), st.binary(max_size=8))
    )
    worn = st.tuples(st.sampled_from(seeds), st.lists(step, max_size=4)).map(_applied)
    return st.one_of(worn, worn, worn, worn, worn, worn, worn, st.binary(max_size=200))


def _applied(drawn) -> bytes:
    content, steps = drawn
    for kind, place, size, piece in steps:
        content = kind(content, int(place * len(content)), 1 + int(60 * size**3), piece)
    return content


def _cut(content, place, size, piece):
    return content[:place]


def _change(content, place, size, piece):
    return content[:place] + piece + content[place + max(1, len(piece)) :]


def _insert(content, place, size, piece):
    return content[:place] + piece + content[place:]


def _lose(content, place, size, piece):
    return content[:place] + content[place + size :]


def _double(content, place, size, piece):
    return content[:place] + content[place : place + size] + content[place:]


def _swap(content, place, size, piece):
    middle = place + size
    return content[:place] + content[middle : middle + size] + content[place:middle] + content[middle + size :]
