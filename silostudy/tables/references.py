"""The references behind every row: one BibTeX file, read by a library; a user's own file may bring others."""

import re
from functools import cache
from pathlib import Path

from pybtex.database import BibliographyData, Entry, parse_string
from pybtex.exceptions import PybtexError
from pybtex.richtext import Text

from silostudy.errors import BadInput, unknown
from silostudy.tables.read import HERE

ORDER = ("title", "journal", "booktitle", "volume", "number", "pages", "publisher", "year", "doi", "note")


@cache
def references() -> BibliographyData:
    """All references, by key."""
    return parse_string((HERE / "references.bib").read_text(encoding="utf-8"), "bibtex")


def cite(source: str) -> str:
    """One reference as a line of text, by its key; a citation in words as it is.  BadInput for an unknown key."""
    if _in_words(source):
        return source
    entries = references().entries
    if source not in entries:
        raise unknown("reference", source, entries)
    return _told(entries[source])


def with_locator(source: str, locator: str) -> str:
    """Key, place and reference on a line; a citation in words is not said twice."""
    return f"{source}, {locator}" if _in_words(source) else f"{source}, {locator}: {cite(source)}"


def _in_words(source: str) -> bool:
    return " " in source


def _told(entry: Entry) -> str:
    people = [str(person) for person in entry.persons.get("author", [])]
    parts = [" and ".join(people), *(entry.fields[name] for name in ORDER if name in entry.fields)]
    text = ". ".join(part for part in parts if part) + "."
    return _without_latex(text)


def _without_latex(text: str) -> str:
    """The text with its accents and signs as they are meant; as it is written where it is no LaTeX."""
    try:
        return str(Text.from_latex(re.sub(r"(?<!\\)%", r"\%", text)))
    except (PybtexError, UnicodeDecodeError):
        return text


def beside(file: Path) -> Path:
    """The user's own references, which a file of the user's own may bring: of its name, with the ending .bib."""
    return file.with_suffix(".bib")


def own_files(folder: Path, *names: str | None) -> tuple[Path, ...]:
    """The named files of a folder, each with the references beside it where there are any."""
    files = [folder / name for name in names if name]
    return tuple(path for file in files for path in (file, beside(file)) if path is file or path.is_file())


def own_references(file: Path) -> str:
    """The text of the references beside a file of the user's own; empty where there are none."""
    path = beside(file)
    try:
        return path.read_text(encoding="utf-8") if path.is_file() else ""
    except (OSError, UnicodeDecodeError) as error:
        raise BadInput("file", str(path), f"must be readable BibTeX: {error}") from None


def own_source(source: str, file: Path, references_beside: str, where: str) -> str:
    """The source of a row in a user's file, as `cite` takes it.

    It is a key of the references beside the file, then of the shipped ones, or a citation in words, which has a blank in it.
    """
    source, own = " ".join(source.split()), _parsed(references_beside, beside(file))
    if source in own.entries:
        return " ".join(_told(own.entries[source]).split())
    if _in_words(source) or source in references().entries:
        return source
    told = f"no key of references.bib or of {beside(file).name} beside the file, and no citation in words (with a blank in it)"
    raise BadInput("source", source, told, where)


def _parsed(text: str, path: Path) -> BibliographyData:
    try:
        return parse_string(text, "bibtex")
    except PybtexError as error:
        raise BadInput("file", str(path), "must be readable BibTeX: " + " ".join(str(error).split())) from None
