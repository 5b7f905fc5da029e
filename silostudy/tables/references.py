"""The references behind every row: one BibTeX file, read by a library."""

from functools import cache

from pybtex.database import BibliographyData, parse_string

from silostudy.errors import unknown
from silostudy.tables.read import HERE


@cache
def references() -> BibliographyData:
    """All references, by key."""
    return parse_string((HERE / "references.bib").read_text(encoding="utf-8"), "bibtex")


def cite(key: str) -> str:
    """One reference as a line of text; BadInput for an unknown key."""
    entries = references().entries
    if key not in entries:
        raise unknown("reference", key, entries)
    people = [str(person).replace("{", "").replace("}", "") for person in entries[key].persons.get("author", [])]
    order = ("title", "journal", "booktitle", "volume", "number", "pages", "publisher", "year", "doi", "note")
    fields = [entries[key].fields[name] for name in order if name in entries[key].fields]
    return ". ".join([" and ".join(people), *fields]) + "."
