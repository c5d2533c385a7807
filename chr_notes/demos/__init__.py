"""Demos: widgets in a notebook, and the same modules on a page without a kernel."""

from chr_notes.demos.gimbal_lock import GimbalLockDemo

__all__ = ["GimbalLockDemo"]
