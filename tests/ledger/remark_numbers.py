"""The numbers that occur in a remark, and what each of them says."""

import re
from decimal import ROUND_HALF_UP, Decimal

# Numbers that are told in a word or by a sign. One to four, first and second only count what the
# sentence itself shows, so they stand here no more than "both" does.
WORDS = {
    "half": "0.5",
    "twice": "2",
    "tenth": "0.1",
    "½": "0.5",
    "√½": "0.707107",
    "five": "5",
    "six": "6",
    "seven": "7",
    "eight": "8",
    "nine": "9",
    "ten": "10",
    "eleven": "11",
    "twelve": "12",
    "dozen": "12",
    "twenty": "20",
    "hundred": "100",
    "double": "2",
    "quarter": "0.25",
    "fifth": "0.2",
    "hundredth": "0.01",
    "thousand": "1000",
}
LIST = r"\d+(?:(?:, | and |, and )\d+)*"
REFERENCE = re.compile(
    rf"\b(?:[Ee]quations?|[Ss]ections?|[Ff]igure|[Tt]able) {LIST}"
    r"|\b[a-z_]+\.(?:t1|\d)\.[\w.]*\w|\bvalidation\.\w+"  # the id of an entry
    r"|\bvehicle-\d|\$[^$]*_\w+\$"  # names
)
NUMBER = re.compile(
    rf"(?<![A-Za-z])[−+-]?\d+(?:\.\d+)?|√½|½|\b(?:{'|'.join(w for w in WORDS if w.isalpha())})\b",
    re.IGNORECASE,
)


def numbers(remark: str) -> list[str]:
    """List the numbers of a remark as they are written, in their order."""
    return NUMBER.findall(REFERENCE.sub("", remark))


def says(written: str) -> Decimal:
    """Value of a number as it is written."""
    return Decimal(WORDS.get(written.lower(), written).replace("−", "-"))


def rounded(value: float, like: str) -> Decimal:
    """Round a value to the digits that a number is written with."""
    step = Decimal(1).scaleb(says(like).as_tuple().exponent)
    return Decimal(f"{value:.12f}").quantize(step, ROUND_HALF_UP)
