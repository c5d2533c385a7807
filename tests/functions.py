"""The functions of attitudes, each with arguments for one, for what all of them have in common."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

import chr_notes

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Function:
    """A function with arguments for one attitude.

    Parameters
    ----------
    call
        The function, with gimbal lock ignored.
    given
        Name and value of each argument.
    zero
        Name of an argument that must not be a row of zeros.
    """

    call: Callable[..., Any]
    given: dict[str, Any]
    zero: str | None = None

    def many(self, count: int) -> list[Floats]:
        """Give arguments for several attitudes, each row a little different."""
        factors = 1 + np.arange(count) / max(count, 1) / 4
        if "matrix" in self.given:
            return [chr_notes.matrix_from_euler(np.outer(factors, EULER))]
        values = map(np.asarray, self.given.values())
        return [factors.reshape(-1, *([1] * value.ndim)) * value for value in values]

    def __call__(self, *arguments: object) -> list[Floats]:
        """Call it; the results in a list."""
        results = self.call(*arguments)
        return list(results) if isinstance(results, tuple) else [results]


EULER = [0.3, -0.7, 1.9]
Q, P, V = [0.5, -0.4, 0.6, 0.2], [0.1, 0.9, -0.3, 0.4], [1.0, -2.0, 0.5]
FUNCTIONS = {
    "matrix_from_euler": Function(chr_notes.matrix_from_euler, {"euler": EULER}),
    "euler_from_matrix": Function(
        lambda m: chr_notes.euler_from_matrix(m, on_gimbal_lock="ignore"),
        {"matrix": chr_notes.matrix_from_euler(EULER)},
    ),
    "euler_rates_matrix": Function(chr_notes.euler_rates_matrix, {"euler": EULER}),
    "euler_rates_from_body_rates": Function(
        chr_notes.euler_rates_from_body_rates, {"euler": EULER, "body_rates": V}
    ),
    "body_rates_from_euler_rates": Function(
        chr_notes.body_rates_from_euler_rates, {"euler": EULER, "euler_rates": V}
    ),
    "wrap_angle": Function(chr_notes.wrap_angle, {"angle": 4.0}),
    "matrix_from_quaternion": Function(chr_notes.matrix_from_quaternion, {"q": Q}, "q"),
    "quaternion_from_matrix": Function(
        chr_notes.quaternion_from_matrix, {"matrix": chr_notes.matrix_from_euler(EULER)}
    ),
    "quaternion_from_euler": Function(chr_notes.quaternion_from_euler, {"euler": EULER}),
    "euler_from_quaternion": Function(
        lambda q: chr_notes.euler_from_quaternion(q, on_gimbal_lock="ignore"), {"q": Q}, "q"
    ),
    "quaternion_from_axis_angle": Function(
        chr_notes.quaternion_from_axis_angle, {"axis": V, "angle": 0.8}, "axis"
    ),
    "axis_angle_from_quaternion": Function(chr_notes.axis_angle_from_quaternion, {"q": Q}, "q"),
    "quaternion_multiply": Function(chr_notes.quaternion_multiply, {"p": P, "q": Q}),
    "quaternion_conjugate": Function(chr_notes.quaternion_conjugate, {"q": Q}),
    "quaternion_inverse": Function(chr_notes.quaternion_inverse, {"q": Q}, "q"),
    "rotate_to_inertial": Function(chr_notes.rotate_to_inertial, {"q": Q, "v_body": V}, "q"),
    "rotate_to_body": Function(chr_notes.rotate_to_body, {"q": Q, "v_inertial": V}, "q"),
    "matrix_from_angles": Function(
        lambda angles: chr_notes.matrix_from_angles(angles, "YXZ"), {"angles": EULER}
    ),
    "angles_from_quaternion": Function(
        lambda q: chr_notes.angles_from_quaternion(q, "YXY", on_gimbal_lock="ignore"), {"q": Q}, "q"
    ),
    "angle_rates_matrix": Function(
        lambda angles: chr_notes.angle_rates_matrix(angles, "XYX"), {"angles": EULER}
    ),
}
