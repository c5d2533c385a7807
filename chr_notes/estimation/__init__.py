"""Attitude from sensors: tilt, gyros alone, observers, and a monitor that watches them."""
