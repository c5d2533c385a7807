"""Functions of floats, for one attitude at a time."""
