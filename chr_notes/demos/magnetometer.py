"""A magnetometer near iron: a cloud of readings, the fit to it, and the heading."""

import math
import re
import string
from typing import Any, ClassVar, Final, NamedTuple

import numpy as np
import traitlets

from chr_notes._arrays import Floats
from chr_notes.demos.base import Control, Demo, rounded
from chr_notes.demos.noise import noise
from chr_notes.generated.scalar.euler import matrix_from_euler, wrap_angle
from chr_notes.generated.scalar.quaternions import (
    quaternion_from_axis_angle,
    quaternion_from_euler,
    quaternion_multiply,
    rotate_to_body,
)
from chr_notes.generated.scalar.sensors import iron_added, iron_removed
from chr_notes.generated.scalar.validation import heading_from_magnetometer
from chr_notes.sensors.coverage import WIDEST_GAP, widest_gap
from chr_notes.sensors.ellipsoid import LARGEST_ERROR, fit_ellipsoid

__all__ = ["SETTING", "MagnetometerDemo", "Setting"]

Vector = tuple[float, float, float]
Iron = list[float]
"""Soft iron by rows, then hard iron: twelve numbers."""


class Setting(NamedTuple):
    """What the demo does not let one change.

    The field north, east and down in µT, that of the chapter; attitudes of the whole walk, and
    turns from one to the next, of the yaw and of the side that it leans to; directions of hard and
    of soft iron; headings round the compass; seed of the noise; and when a fit refuses. Of a hand
    that turns the sensor: the letters that write an attitude, 64 of them; the degrees that yaw,
    pitch and roll have in all; and by how many degrees readings are apart.
    """

    field: Vector = (22.0, 0.0, 45.0)
    walk: int = 200
    turns: tuple[float, float] = (0.618034, 0.754878)
    hard: Vector = (0.8, -0.5, 0.3)
    soft: tuple[float, ...] = (0.8, 0.4, 0.0, 0.4, -0.6, 0.2, 0.0, 0.2, 0.1)
    headings: int = 72
    seed: int = 7
    widest_gap: float = WIDEST_GAP
    largest_error: float = LARGEST_ERROR
    letters: str = string.ascii_uppercase + string.ascii_lowercase + string.digits + "-_"
    turn_in: tuple[float, float, float] = (360.0, 180.0, 360.0)
    apart: float = 5.0


SETTING: Final = Setting()


class MagnetometerDemo(Demo):
    """The readings of a magnetometer near iron, as a cloud in space, and a calibration from them.

    The sensor turns from reading to reading and leans more and more, so that the cloud grows. An
    ellipsoid is fitted to it, which refuses where the readings cover too little. Below stands the
    error of the heading of the level sensor, by its heading, before and after. Its numbers come
    from the ledger entries sensors.4.2 and validation.16.

    Parameters
    ----------
    readings : float, optional
        How many of the walk's 200 readings, from 10 to 200; 150 unless told. Each value follows
        its slider while a kernel runs.
    tilt : float, optional
        How far the sensor leans in the end of the whole walk in degrees, from 0 to 180; 180 unless
        told. With 0 it turns about the vertical alone.
    hard_iron : float, optional
        Size of the field that turns with the sensor in µT, from 0 to 40; 15 unless told.
    soft_iron : float, optional
        How much the field is stretched and sheared, a part of it, from 0 to 0.5; 0.2 unless told.
    noise : float, optional
        White noise of each axis in µT RMS, from 0 to 2; 0.3 unless told.
    turned : str, optional
        Attitudes of a sensor that is turned by hand, at most 200, which take the place of the walk:
        four letters of base64 each, 24 bits for yaw, pitch and roll, a 256th of their range a bit.
    """

    element = "magnetometer"
    controls = ("readings", "tilt", "hard_iron", "soft_iron", "noise")
    texts: ClassVar[tuple[str, ...]] = ("turned",)

    readings = Control(150.0, min=10.0, max=200.0).tag(sync=True)
    tilt = Control(180.0, min=0.0, max=180.0).tag(sync=True)
    hard_iron = Control(15.0, min=0.0, max=40.0).tag(sync=True)
    soft_iron = Control(0.2, min=0.0, max=0.5).tag(sync=True)
    noise = Control(0.3, min=0.0, max=2.0).tag(sync=True)
    turned = traitlets.Unicode("").tag(sync=True)

    @traitlets.validate("turned")
    def _is_turned(self, proposal: dict[str, Any]) -> str:
        text = str(proposal["value"])
        if re.fullmatch(rf"(?:[A-Za-z0-9_-]{{4}}){{0,{SETTING.walk}}}", text) is None:
            msg = f"turned: attitudes of four letters of base64 each, got {text[:40]!r}"
            raise traitlets.TraitError(msg)
        return text

    def walk(self) -> Floats:
        """Return the field in the body at each reading, µT."""
        if self.turned:
            return np.array([rotate_to_body(*q, *SETTING.field) for q in self._by_hand()])
        lowest = 1 - math.cos(math.radians(self.tilt))
        found = []
        for i in range(math.floor(self.readings)):
            leaning = math.acos(1 - lowest * ((i + 0.5) / SETTING.walk))
            yaw, side = (2 * math.pi * turn * i for turn in SETTING.turns)
            turned = quaternion_from_axis_angle(0.0, 0.0, 1.0, yaw)
            leant = quaternion_from_axis_angle(math.cos(side), math.sin(side), 0.0, leaning)
            found.append(rotate_to_body(*quaternion_multiply(*turned, *leant), *SETTING.field))
        return np.array(found)

    def cloud(self) -> Floats:
        """Return the readings, µT."""
        source = noise(SETTING.seed)
        return np.array(
            [
                [value + self.noise * next(source) for value in iron_added(*self._iron(), *field)]
                for field in self.walk().tolist()
            ]
        )

    def readouts(self) -> dict[str, float]:
        """Return the largest gap and the largest errors of the heading, degrees.

        The error after the calibration is NaN where the fit refuses.
        """
        directions = self.walk() / math.hypot(*SETTING.field)
        return {
            "gap": math.degrees(widest_gap(directions)[0]),
            "error_before": self._largest_error(None),
            "error_after": self._largest_error(self._calibration()),
        }

    def fallback(self) -> str:
        """Return the state and the numbers in two sentences."""
        found = self.readouts()
        after = found["error_after"]
        said = "the fit refuses" if math.isnan(after) else f"after it {rounded(after)}°"
        how = (
            f"{len(self.turned) // 4} readings of a magnetometer that is turned by hand"
            if self.turned
            else f"{rounded(math.floor(self.readings))} readings of a magnetometer that leans by "
            f"up to {rounded(self.tilt)}°"
        )
        return (
            f"{how}, near hard iron of {rounded(self.hard_iron)} µT and soft iron "
            f"of {rounded(self.soft_iron)}, with noise of {rounded(self.noise)} µT RMS. The "
            f"largest gap is {rounded(found['gap'])}°; before calibration the heading is off by up "
            f"to {rounded(found['error_before'])}°, {said}."
        )

    def _by_hand(self) -> list[tuple[float, float, float, float]]:
        """Return the attitudes in which the hand held the sensor."""
        found = []
        for start in range(0, len(self.turned), 4):
            bits = 0
            for letter in self.turned[start : start + 4]:
                bits = 64 * bits + SETTING.letters.index(letter)
            yaw, pitch, roll = (
                math.radians(whole * ((bits >> low & 255) - 128) / 256)
                for whole, low in zip(SETTING.turn_in, (16, 8, 0), strict=True)
            )
            found.append(quaternion_from_euler(roll, pitch, yaw))
        return found

    def _iron(self) -> Iron:
        stretch = np.eye(3).ravel() + self.soft_iron * np.array(SETTING.soft)
        return [*stretch.tolist(), *(self.hard_iron * part for part in SETTING.hard)]

    def _calibration(self) -> Iron:
        """Return soft and hard iron as fitted; NaN where the fit refuses."""
        try:
            fitted = fit_ellipsoid(self.cloud())
        except ValueError:
            return [math.nan] * 12
        hard = fitted.to_sphere @ fitted.centre
        return [*fitted.to_sphere.ravel().tolist(), *hard.tolist()]

    def _largest_error(self, calibration: Iron | None) -> float:
        """Return the largest error of the heading of the level sensor, degrees."""
        errors = []
        for i in range(SETTING.headings):
            yaw = 2 * math.pi * i / SETTING.headings
            matrix = np.reshape(matrix_from_euler(0.0, 0.0, yaw), (3, 3))
            mag = list(iron_added(*self._iron(), *(matrix @ SETTING.field).tolist()))
            if calibration is not None:
                mag = list(iron_removed(*calibration, *mag))
            x, y, z = mag
            heading = heading_from_magnetometer(x, y, z, 0.0, 0.0, 1.0, 0.0)
            errors.append(abs(wrap_angle(heading - yaw)))
        return math.degrees(max(errors))
