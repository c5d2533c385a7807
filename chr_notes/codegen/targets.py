"""The table of generated functions: which derived formula becomes which function."""

from chr_notes.codegen import attitude_targets, averaging_targets, sensor_targets, sequence_targets

TARGETS = (
    *attitude_targets.TARGETS,
    *sequence_targets.TARGETS,
    *sensor_targets.TARGETS,
    *averaging_targets.TARGETS,
)
