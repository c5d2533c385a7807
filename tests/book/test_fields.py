"""Names of which one sentence tells stand on one line."""

from docutils.core import publish_doctree

from chr_notes.book.fields import join

TEXT = """
:Parameters: * **p** (*int*) -- Of *two* names.
             * **q** (*int*) -- Of *two* names.
             * **r** (*float*) -- Of *two* names.
             * **s**
             * **t**
             * **u** -- Another.
"""


def test_a_sentence_stands_once_for_all_names_of_which_it_tells() -> None:
    document = publish_doctree(TEXT)
    join(document)
    text = [line for line in document.astext().splitlines() if line]
    assert text[-5:] == [
        "p, q (int) -- Of two names.",
        "r (float) -- Of two names.",
        "s",
        "t",
        "u -- Another.",
    ]
