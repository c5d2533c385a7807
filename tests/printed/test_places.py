"""Each statement stands where its place says; the documents lie beside the project."""

import re
from pathlib import Path
from types import ModuleType

from chr_notes.ledger.files import see

from .sources import places
from .test_formulas import FORMULAS, STATEMENTS

# A few words of each claim by which to find it.
WORDS = {
    "euler.2.a": "altitude above ground",
    "euler.3.a": "z-axis is aligned with the inertial frame",
    "euler.4.a": "pitch is NOT rotation about",
    "euler.4.b": "Vehicle-3 Frame",
    "euler.5.a": "reverse the order of operations",
    "euler.6.a": "when the pitch angle is 90 degrees",
    "euler.6.b": "OR by pitching and then rolling",
    "euler.7.a": "must be rotated into the vehicle-1 frame",
    "euler.7.b": "is NOT what is being reported",
    "euler.7.c": "diverge to infinity",
    "euler.7.d": r"D(\phi, \theta, \psi)",
    "quaternions.2.a": "three complex elements",
    "quaternions.3.a": "equivalent to its conjugate",
    "quaternions.3.b": "in a single matrix multiply",
    "quaternions.3.c": "By negating the vector part",
    "quaternions.4.a": "the atan2 function",
    "quaternions.4.b": "the gimbal lock problem still manifests",
    "sensors.2.a": "appears equivalent to upward acceleration",
    "sensors.2.b": "hence no measured acceleration",
    "sensors.2.c": "negative one gravity",
    "sensors.2.d": "pitch = roll = 0",
    "sensors.2.e": "Solving, we get",
    "sensors.4.a": "a perfect sphere centered around zero",
    "sensors.4.b": "shift the mean of the sphere",
    "sensors.4.c": "is equivalent to the bias",
    "sensors.4.d": "inverse of the magnetometer sensitivity",
    "estimation.2.a": "the only force acting",
    "estimation.3.a": "errors will accumulate",
    "estimation.4.a": "if L is equal to 0",
    "estimation.4.b": "if L is equal to 1",
    "estimation.4.c": "immune to long-term drift",
    "estimation.4.d": "selected optimally",
    "estimation.4.e": "As L approaches 1",
    "dead_reckoning.2.a": "be 1 gravity",
    "dead_reckoning.4.a": "1.7 m/s after 10 seconds",
    "dead_reckoning.4.b": "17.1 meters",
    "dead_reckoning.4.c": "almost a full kilometer",
    "dead_reckoning.4.d": "62 kilometers",
    "dead_reckoning.4.e": "34.2 meters",
    "dead_reckoning.4.f": "introduce no additional error",
    "dead_reckoning.4.g": "fail to remove measured normal forces",
    "validation.a": "transforms the expression of a vector",
    "validation.b": "contradictory result",
    "validation.c": "tends to converge",
    "validation.d": "100% accurately",
    "validation.e": "towards the South",
    "validation.f": "vary at different altitudes",
    "validation.g": "to measure the accuracy",
}
WORDS |= {
    "euler.1.a": "three rotations about different axes",
    "euler.6.c": "in exactly the same fashion",
    "euler.6.d": "depends on the order of rotations used",
    "euler.6.e": "can only be solved by switching",
    "euler.7.e": "pitch represents rotation about the vehicle-1 frame y-axis",
    "euler.7.f": "not the actual acceleration",
    "euler.7.g": "Magnetometer data can also be converted",
    "quaternions.2.b": "encode any rotation",
    "quaternions.3.d": "a quaternion with zero real-part",
    "quaternions.4.c": "depends on the order of rotations",
    "sensors.2.f": "below the natural frequency",
    "sensors.2.g": "never measure gravity directly",
    "sensors.2.h": "the actual acceleration before scale factors",
    "sensors.2.i": "This is illustrated in Figure 1",
    "sensors.2.j": r"\beta_a(T)",
    "sensors.2.k": "9.8 m/s/s toward the center",
    "sensors.4.e": "fewer calibration terms",
    "sensors.4.f": "will remain constant",
    "sensors.4.g": "looks like a sphere again",
    "sensors.4.h": "caused by the soft-iron distortions",
    "estimation.3.b": "nominally unaffected by acceleration",
    "estimation.3.c": "rotate them into the appropriate frames",
    "estimation.3.d": "ignore the term for yaw",
    "estimation.4.f": "toward the average angle",
    "estimation.5.a": "for arbitrarily large amounts of time",
    "dead_reckoning.2.b": "normal forces must be removed",
    "dead_reckoning.4.h": "within about 2 degrees",
    "dead_reckoning.4.i": "to estimate attitude",
    "validation.h": "gravity components reported by an accelerometer",
    "validation.i": "99% to 93% reliance",
    "validation.j": "th loop are known",
    "validation.k": "cannot be calculated just using an accelerometer",
    "validation.l": "rotations around the",
    "validation.m": "large drift errors",
    "validation.n": "when all the Eulerian angles are zero",
    "validation.o": "g = 9.8",
    "validation.p": "without using the magnetometer",
}
PLACE = re.compile(
    r"(section \d|equation \d+|(before|after) equation \d+)(, (paragraph|Figure|Table) \d+)?"
)


def test_there_are_words_for_every_claim() -> None:
    assert WORDS.keys() == {n for n, each in STATEMENTS.items() if each.kind == "claim"}


def test_a_place_is_a_section_and_a_paragraph_or_an_equation() -> None:
    for name, statement in STATEMENTS.items():
        place, where = statement.place, see(name)
        assert PLACE.fullmatch(place), where
        document, number, *_ = name.split(".")
        if place.startswith("section") and number != "t1":
            assert place.split(",")[0] == f"section {number}", where
        if place.startswith("equation"):
            assert place == f"equation {number}", where
        assert (document == "validation") != place.startswith("section"), where


def test_statements_stand_in_their_places(rules: ModuleType) -> None:
    rules.wait_for("../shared/sources")
    texts = places(Path(__file__).resolve().parents[3] / "shared" / "sources")
    for name, statement in STATEMENTS.items():
        where = f"{name} does not stand in {statement.place}; {see(name)}"
        text = " ".join(texts[statement.document][statement.place].split())
        if statement.kind == "table cell":
            assert f" {name.split('.', 2)[2].rpartition('.')[0]} " in text, where
        elif statement.kind == "equation":
            assert name in FORMULAS, f"{name} has no line in formulas.tsv"
            assert FORMULAS[name] in text, where
        else:
            assert WORDS[name] in text, where
