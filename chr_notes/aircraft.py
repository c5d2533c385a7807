"""The small aircraft that figures and demos draw, in its body frame: x forward, y right, z down.

It is about one unit long. Figures draw its outlines flat, demos as solids.
"""

from typing import Final

# Of the fuselage, from the tail forward: x, half width, half height, height of the middle.
SECTIONS: Final = (
    (-0.55, 0.012, 0.02, -0.05),
    (-0.42, 0.035, 0.045, -0.035),
    (-0.15, 0.075, 0.085, -0.01),
    (0.12, 0.085, 0.09, 0.0),
    (0.32, 0.07, 0.07, 0.01),
    (0.45, 0.04, 0.042, 0.018),
    (0.54, 0.008, 0.008, 0.02),
)
CANOPY: Final = (
    (0.02, 0.035, 0.03, -0.085),
    (0.12, 0.05, 0.055, -0.085),
    (0.24, 0.045, 0.045, -0.07),
    (0.33, 0.02, 0.02, -0.05),
)
BELLY: Final = ((-0.05, 0.03, 0.02, 0.085), (0.15, 0.03, 0.02, 0.085))
# Of the plates, from root to tip: leading x, trailing x, y, z, half thickness.
WING: Final = (
    (0.2, -0.1, 0.06, 0.02, 0.022),
    (0.04, -0.09, 0.42, -0.005, 0.012),
    (0.0, -0.085, 0.53, -0.013, 0.008),
)
TAIL: Final = ((-0.38, -0.52, 0.02, -0.05, 0.012), (-0.46, -0.53, 0.2, -0.06, 0.006))
FIN: Final = ((-0.3, -0.52, 0.0, -0.05, 0.012), (-0.46, -0.56, 0.0, -0.25, 0.006))

PARTS: Final = {
    "sections": SECTIONS,
    "canopy": CANOPY,
    "belly": BELLY,
    "wing": WING,
    "tail": TAIL,
    "fin": FIN,
}
"""All of it, by name, for the demos."""
