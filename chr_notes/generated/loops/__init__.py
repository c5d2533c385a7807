"""Functions of recordings, sample after sample."""
