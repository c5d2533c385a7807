"""What chapters and docstrings cite stands on the page of references, and the other way round."""

import re

from pybtex.database import Entry, parse_file

from chr_notes.book import sources

ROOT = sources.CLONE
ENTRIES = parse_file(str(ROOT / "book" / "references.bib")).entries.values()
CHAPTERS = {
    path.name: path.read_text(encoding="utf-8") for path in (ROOT / "notebooks").glob("*.ipynb")
}
LINK = re.compile(r"\[([^\]]*?) \((\d{4})\)\]\(([^)]*)\)")
"""Names, year and target of a citation in a chapter."""


def surnames(entry: Entry) -> list[str]:
    return [" ".join(person.last_names) for person in entry.persons["author"]]


def test_each_citation_of_a_chapter_leads_to_its_entry() -> None:
    cited = [found for text in CHAPTERS.values() for found in LINK.findall(text)]
    assert cited
    for names, year, target in cited:
        first = re.split(r" and |, ", names)[0]
        (entry,) = (e for e in ENTRIES if surnames(e)[0] == first and e.fields["year"] == year)
        doi = entry.fields.get("doi")
        assert target == (f"https://doi.org/{doi}" if doi else "../book/bibliography.md"), names
        if "others" not in names:
            assert names == " and ".join(surnames(entry))


def test_each_entry_is_cited() -> None:
    code = [path.read_text(encoding="utf-8") for path in (ROOT / "chr_notes").rglob("*.py")]
    texts = [*CHAPTERS.values(), *code]
    for entry in ENTRIES:
        first, year = surnames(entry)[0], entry.fields["year"]
        assert any(re.search(rf"{first}.{{1,250}}{year}", text, re.DOTALL) for text in texts), first
