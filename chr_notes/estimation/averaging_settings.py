"""Constants of the averaging filter, for a recording and for a stream."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from chr_notes._arrays import Floats
from chr_notes._kernels import of_arrays
from chr_notes._samples import positive
from chr_notes.estimation.bias import Bias
from chr_notes.estimation.earth_field import EarthField
from chr_notes.estimation.fixed_gain import WAYS
from chr_notes.generated.scalar import estimation as steps


@dataclass(frozen=True)
class Settings:
    """Constants of the filter, checked."""

    time_constant: float
    heading_time_constant: float
    bias: Bias
    field: EarthField
    longest_step: float

    def __post_init__(self) -> None:
        """Check them."""
        for name in ("time_constant", "heading_time_constant", "longest_step"):
            positive(name, getattr(self, name))

    def step(self, *, heading: bool) -> tuple[Callable[..., tuple[float, ...]], tuple[float, ...]]:
        """Give the generated step, and what it takes after state and sample."""
        given = (float(self.time_constant), float(self.longest_step))
        if not heading:
            return steps.averaging_turn, given
        field = self.field
        return steps.averaging_heading_turn, (
            *given,
            float(self.heading_time_constant),
            *map(float, field.reference),
            float(field.tolerance),
            float(field.patience),
        )

    def begin(self, tilt: Sequence[float], *sample: Floats, heading: bool) -> Floats:
        """Give the state after the first sample, whose time step is nobody's."""
        step, given = self.step(heading=heading)
        known = self.field.begin() if heading else ()
        state = np.array((*WAYS["quaternion"].begin(*tilt), *[0.0] * 6, *known))
        begun: Floats = of_arrays(step)(state, *sample, 0.0, *given, None)
        return begun
