"""What our words say, without the words that carry no sense of their own."""

import re

_PLAIN = """
a an are as be been being by do does has have is it its of so such than that the their them then
there these they this those was what where which who
"""
PLAIN = frozenset(_PLAIN.split())
"""Words that do not turn a sense round, whichever of them stands in a place."""


def meant(says: str) -> str:
    """Take the words and numbers that carry the sense, in their order."""
    words = re.findall(r"[\w°√½−'/²³.-]*\w[\w'\u2032\u2033°%²³]*", says.lower())
    return " ".join(word for word in words if word not in PLAIN)
