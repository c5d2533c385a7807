"""All cases, in the order in which the documents print their statements."""

from chr_notes.ledger import dead_reckoning, estimation, euler, quaternions, sensors, validation
from chr_notes.ledger.case import Case

TOPICS = (euler, quaternions, sensors, estimation, dead_reckoning, validation)
CASES: dict[str, Case] = {case.id: case for topic in TOPICS for case in topic.CASES}
