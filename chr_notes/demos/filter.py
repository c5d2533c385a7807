"""Gyro alone, accelerometer alone, both together, and the gain between them."""

import math
from collections.abc import Iterator
from typing import Final, NamedTuple

from chr_notes.conventions import STANDARD_GRAVITY
from chr_notes.demos.base import Control, Demo, formatted, rounded
from chr_notes.demos.noise import noise
from chr_notes.generated.scalar.estimation import (
    averaging_turn,
    gyro_turn,
    observer_turn,
    tilt_from_accelerometer,
)
from chr_notes.generated.scalar.euler import body_rates_from_euler_rates
from chr_notes.generated.scalar.quaternions import (
    inclination_from_quaternion,
    quaternion_conjugate,
    quaternion_from_euler,
    quaternion_multiply,
    rotate_to_body,
)

__all__ = ["RUN", "FilterDemo", "Reading", "Run"]


_GAINS = tuple(float(f"{10 ** (i / 20 - 4):.2g}") for i in range(81))


class Run(NamedTuple):
    """The run of the demo.

    `step` seconds a step and so many `steps`, of which each fourth counts for an error; from
    when to when, in seconds, a push or a turn lasts, and the speed before it in m/s; the constants
    of the averaging filter in seconds; the gains of the slider; and the seed of the noise.
    """

    step: float = 0.04
    steps: int = 1000
    every: int = 4
    begins: float = 10.0
    ends: float = 30.0
    speed: float = 2.0
    time_constant: float = 3.0
    longest_step: float = 0.15
    gains: tuple[float, ...] = _GAINS
    seed: int = 20


RUN: Final = Run()

Vector = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]
Averaging = tuple[float, float, float, float, float, float, float, float, float, float]


class Reading(NamedTuple):
    """The true attitude, and what the sensors read: rates in rad/s, specific force in m/s²."""

    attitude: Quaternion
    rates: Vector
    force: Vector


class FilterDemo(Demo):
    """Forty seconds of a body at rest, pushed, or in a turn, and four estimates of the vertical.

    The gyro alone, the accelerometer alone, both joined with a fixed gain, and the average of the
    specific force in a frame that does not turn with the body. There are twenty-five
    readings a second. All begin with the tilt that the first reading shows. Push and turn last from
    10 to 30 s, and the turn begins at 2 m/s. An error is the RMS angle between the true and the
    estimated vertical. Its numbers come from the ledger entries estimation.2.5,
    estimation.2.6, estimation.3.1 and estimation.4.3.

    Parameters
    ----------
    gain : float, optional
        The gain L of the observer, from 0.0001 to 1; 0.1 unless told. Each value follows its
        slider while a kernel runs.
    bank : float, optional
        Roll in the turn in degrees, from 0 to 45; 0, no turn, unless told.
    push : float, optional
        Forward acceleration in m/s², from 0 to 3; 0 unless told.
    bias : float, optional
        Bias of each gyro in °/s, from 0 to 1; 0.2 unless told.
    gyro_noise : float, optional
        White noise of each gyro in °/s RMS, from 0 to 5; 1 unless told.
    accel_noise : float, optional
        White noise of each axis of the accelerometer in m/s² RMS, from 0 to 3; 1.5 unless told.
    """

    element = "filter"
    controls = ("gain", "bank", "push", "bias", "gyro_noise", "accel_noise")

    gain = Control(0.1, min=1e-4, max=1.0).tag(sync=True)
    bank = Control(0.0, min=0.0, max=45.0).tag(sync=True)
    push = Control(0.0, min=0.0, max=3.0).tag(sync=True)
    bias = Control(0.2, min=0.0, max=1.0).tag(sync=True)
    gyro_noise = Control(1.0, min=0.0, max=5.0).tag(sync=True)
    accel_noise = Control(1.5, min=0.0, max=3.0).tag(sync=True)

    def recording(self) -> list[Reading]:
        """Return what the sensors read, with the true attitude."""
        source = noise(RUN.seed)
        return [
            Reading(
                attitude,
                _shaken(rates, math.radians(self.bias), math.radians(self.gyro_noise), source),
                _shaken(force, 0.0, self.accel_noise, source),
            )
            for attitude, rates, force in self._flight()
        ]

    def readouts(self) -> dict[str, float]:
        """Return the RMS errors of three filters without a gain to choose, and of the observer."""
        readings = self.recording()
        return {
            "observer_error": _rms(_observed(readings, self.gain)),
            "gyro_error": _rms(_observed(readings, 0.0)),
            "accelerometer_error": _rms(
                _apart(quaternion_from_euler(*tilt_from_accelerometer(*force), 0.0), attitude)
                for n, (attitude, _, force) in enumerate(readings)
                if _counts(n)
            ),
            "averaging_error": _rms(_averaged(readings)),
        }

    def fallback(self) -> str:
        """Return the state and the errors in two sentences."""
        texts = {name: rounded(value) for name, value in self.readouts().items()}
        return (
            f"A body that is pushed by {rounded(self.push)} m/s² and turns at a bank of "
            f"{rounded(self.bank)}°; gyros with a bias of {rounded(self.bias)} °/s and noise of "
            f"{rounded(self.gyro_noise)} °/s RMS, an accelerometer with noise of "
            f"{rounded(self.accel_noise)} m/s² RMS. RMS error of the vertical over 40 s: "
            f"gyro alone {texts['gyro_error']}°, accelerometer alone "
            f"{texts['accelerometer_error']}°, both with a gain of {formatted(self.gain)} "
            f"{texts['observer_error']}°, average in a frame that does not turn "
            f"{texts['averaging_error']}°."
        )

    def _flight(self) -> Iterator[Reading]:
        """Yield the truth after each step."""
        step = RUN.step
        attitude = (1.0, 0.0, 0.0, 0.0)
        heading, speed, before = 0.0, RUN.speed, 0.0
        for n in range(RUN.steps):
            part = _share(step * (n + 1))
            roll = math.radians(self.bank) * part
            middle = (roll + before) / 2
            speed += self.push * part * step
            yaw_rate = STANDARD_GRAVITY * math.tan(middle) / speed
            heading += yaw_rate * step
            roll_rate = (roll - before) / step
            rates = body_rates_from_euler_rates(middle, 0.0, roll_rate, 0.0, yaw_rate)
            attitude = gyro_turn(*attitude, *rates, step)
            before = roll
            forward, right = self.push * part, STANDARD_GRAVITY * math.tan(roll)
            north = forward * math.cos(heading) - right * math.sin(heading)
            east = forward * math.sin(heading) + right * math.cos(heading)
            force = rotate_to_body(*attitude, north, east, -STANDARD_GRAVITY)
            yield Reading(attitude, rates, force)


def _shaken(vector: Vector, bias: float, size: float, source: Iterator[float]) -> Vector:
    """Add a bias and noise to each component."""
    x, y, z = vector
    return (
        x + bias + size * next(source),
        y + bias + size * next(source),
        z + bias + size * next(source),
    )


def _share(time: float) -> float:
    """Return 1 while push and turn last, and less in their first and last second."""
    t = min(1.0, max(0.0, min(time - RUN.begins, RUN.ends - time)))
    return t * t * (3 - 2 * t)


def _counts(n: int) -> bool:
    """Say whether the error after a step counts."""
    return n % RUN.every == RUN.every - 1


def _apart(estimate: Quaternion, truth: Quaternion) -> float:
    """Return the angle between two verticals in degrees."""
    between = quaternion_multiply(*estimate, *quaternion_conjugate(*truth))
    return math.degrees(inclination_from_quaternion(*between))


def _first(readings: list[Reading]) -> Quaternion:
    """Return the attitude that the first specific force shows: all that is known at the start."""
    return quaternion_from_euler(*tilt_from_accelerometer(*readings[0].force), 0.0)


def _observed(readings: list[Reading], gain: float) -> Iterator[float]:
    estimate = _first(readings)
    for n, (attitude, rates, force) in enumerate(readings):
        if n > 0:
            estimate = observer_turn(*estimate, *rates, *force, RUN.step, gain)
        if _counts(n):
            yield _apart(estimate, attitude)


def _averaged(readings: list[Reading]) -> Iterator[float]:
    state: Averaging = (*_first(readings), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    for n, (attitude, rates, force) in enumerate(readings):
        dt = RUN.step if n > 0 else 0.0
        state = averaging_turn(*state, *rates, *force, dt, RUN.time_constant, RUN.longest_step)
        if _counts(n):
            yield _apart(state[:4], attitude)


def _rms(values: Iterator[float]) -> float:
    squares = [value * value for value in values]
    return math.sqrt(sum(squares) / len(squares))
