"""Demos: widgets in a notebook, and the same modules on a page without a kernel."""

try:
    import anywidget  # noqa: F401 (before what is made with it)
except ModuleNotFoundError as error:
    MSG = 'demos need anywidget; run: python -m pip install "chr-notes[notebooks]"'
    raise ModuleNotFoundError(MSG, name="anywidget") from error

from chr_notes.demos.converter import ConverterDemo
from chr_notes.demos.detective import DetectiveDemo
from chr_notes.demos.drift import DriftDemo
from chr_notes.demos.filter import FilterDemo
from chr_notes.demos.frames import FramesDemo
from chr_notes.demos.gimbal_lock import GimbalLockDemo
from chr_notes.demos.magnetometer import MagnetometerDemo
from chr_notes.demos.quaternion import QuaternionDemo
from chr_notes.demos.tilt import TiltDemo
from chr_notes.demos.validation import ValidationDemo

__all__ = [
    "ConverterDemo",
    "DetectiveDemo",
    "DriftDemo",
    "FilterDemo",
    "FramesDemo",
    "GimbalLockDemo",
    "MagnetometerDemo",
    "QuaternionDemo",
    "TiltDemo",
    "ValidationDemo",
]
