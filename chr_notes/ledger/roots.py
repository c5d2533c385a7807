"""The errors behind the entries: each counts once, in however many places it shows."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

ROOTS: Final[Mapping[str, str]] = MappingProxyType(
    {
        "rates-by-projection": "The Euler rates are said to come about by rotating each gyro's "
        "output into the frame of one turn; they come about by solving for the three together.",
        "body-to-inertial-symbol": "The symbol of the matrix from inertial to body stands in front "
        "of the one from body to inertial.",
        "opposite-at-the-lock": "At a pitch of +90° yaw and roll are said to move the sensor in "
        "the same fashion; they turn it about the same line in opposite senses.",
        "lock-without-a-cure": "Only another representation is said to cure the lock; another "
        "sequence of angles, or care near the lock, does as well.",
        "vehicle-3": "A caption names a frame that there is not.",
        "quaternion-direction": "The quaternion note uses one quaternion in both directions: "
        "section 3 from the inertial frame to the body, section 4 and the sensors the other way.",
        "complex-for-imaginary": "A quaternion is said to have complex elements.",
        "inverse-is-conjugate": "The inverse of a quaternion is said to be its conjugate.",
        "accelerometer-for-magnetometer": "The magnetometer's terms have the accelerometer's "
        "symbols.",
        "specific-force-called-acceleration": "What the accelerometer tells, the specific force, "
        "is called the actual acceleration.",
        "constant-but-for-temperature": "Bias and sensitivity are said to be constant, and to "
        "change with temperature.",
        "figure-without-a-number": "The text names another figure than the one that it means.",
        "gravity-alone": "No net force is said to mean that gravity alone acts; it means that "
        "something holds the sensor against it.",
        "missing-half": "Position under a constant acceleration: the half in front of the time "
        "squared is missing.",
        "kilometre": "The 612 m of the note's own table are called almost a kilometre.",
        "cut-off": "Two numbers of Table 1 are cut off instead of rounded.",
        "local-gravity": "The gravity that is added is taken to be the local one.",
        "matrix-label": "The validation paper calls its matrix that from the inertial frame to the "
        "body and prints that of the way back.",
        "gravity-or-reading": "The validation paper takes what an accelerometer reads for gravity; "
        "it reads minus gravity.",
        "no-information": "Yaw from gravity: a division of zero by zero is taken for a "
        "contradiction.",
        "roll-quadrant": "Roll as the arctangent of a quotient: beyond 90° it comes out wrong by "
        "180°.",
        "seam": "A weighted mean of two angles that are more than half a turn apart as numbers "
        "goes the long way round.",
        "bias-stays": "A filter with a fixed gain is said to settle at the accelerometer's angle; "
        "a bias of the gyro keeps it beside.",
        "angles-before": "The Euler rates of a loop are said to follow from the angles of the loop "
        "before, as if these had not changed.",
        "factor-needs-field": "The factor E is said to be zero with exact angles, whatever "
        "disturbs the field.",
        "factor-blind": "The factor E is said to tell an error of the Euler angles; one of yaw it "
        "does not see.",
        "south-field": "The Earth's field is printed as if it pointed south.",
    }
)
"""What is wrong, in our words, by the name that the cases give as `root`.

In the order of the documents.
"""

KNOWN_BY: Final[Mapping[str, str]] = MappingProxyType(
    {
        "rates-by-projection": r".+R_\{B\}\^\{v_2\}.+ for .+\^\{-1\}.+",
        "body-to-inertial-symbol": r"R_\{I\}\^\{B\}.+ for R_\{B\}\^\{I\}.+",
        "opposite-at-the-lock": r"minus before numbers",
        "lock-without-a-cure": r"0 for 1",
        "vehicle-3": r".*vehicle-3.* for .*vehicle-2.*",
        "quaternion-direction": r"readings of .*\\mathbf\{q\}.*",
        "complex-for-imaginary": r".*\\mathbb\{C\} for .* i\\mathbb\{R\}",
        "inverse-is-conjugate": r"only if a\^\{2\} \+ b\^\{2\} \+ c\^\{2\} \+ d\^\{2\} = 1",
        "accelerometer-for-magnetometer": r"\{S_a\}.* for \{S_b\}.*",
        "specific-force-called-acceleration": r"\\mathbf\{F\} - \\mathbf\{F\}_g for \\mathbf\{F\}",
        "constant-but-for-temperature": r"only if T_\{1\} = T_\{2\}",
        "figure-without-a-number": r".*Figure 1.* for .*no number.*",
        "gravity-alone": r"\\mathbf\{F\}_g for \\mathbf\{F\}_g \+ .*",
        "missing-half": r"2 times too large",
        "kilometre": r"3\.25 times too large",
        "cut-off": r"cut off",
        "local-gravity": r"only if \\hat\{g\} = g",
        "matrix-label": r"readings of .*R_\{i\}\^\{b\}.*",
        "gravity-or-reading": r"minus before \\phi, \\theta, g",
        "no-information": r"step .*g_\{xb\}.* = 0.*g_\{yb\}.* = 0",
        "roll-quadrant": r"only if .*\\phi.* < \\frac\{\\pi\}\{2\}",
        "seam": r"only from - \\pi to \\pi",
        "bias-stays": r"only if b = 0",
        "angles-before": r"only if \\phi_\{Comp\(n-1\)\} = \\phi .*",
        "factor-needs-field": r"only if .*M_\{zi\}",
        "factor-blind": r"3 for 2",
        "south-field": r"minus before .*\\alpha.*",
    }
)
"""How each place of an error is known: a pattern for one of its `ties.traits`."""
