"""Functions of arrays, for many attitudes at once."""
