"""Demos: widgets in a notebook, and the same modules on a page without a kernel."""

from chr_notes.demos.drift import DriftDemo
from chr_notes.demos.gimbal_lock import GimbalLockDemo
from chr_notes.demos.quaternion import QuaternionDemo
from chr_notes.demos.tilt import TiltDemo

__all__ = ["DriftDemo", "GimbalLockDemo", "QuaternionDemo", "TiltDemo"]
