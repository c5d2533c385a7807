"""The table of generated functions, part two: sensors, filters, heading, dead reckoning.

No formula stands here: each target names the derivation that it comes from.
"""

from functools import partial

from chr_notes.codegen import arguments as given
from chr_notes.codegen import array_arguments as array
from chr_notes.codegen.target import Target
from chr_notes.derivations import calibration, dead_reckoning, estimation, sensors
from chr_notes.derivations.forms import dead_reckoning as reckoning_forms
from chr_notes.derivations.forms import estimation as filter_forms
from chr_notes.derivations.forms import filters, monitor
from chr_notes.derivations.forms import sensors as sensor_forms

SENSORS = partial(Target, "sensors")
ESTIMATION = partial(Target, "estimation")
VALIDATION = partial(Target, "validation")
DEAD_RECKONING = partial(Target, "dead_reckoning")

TARGETS = (
    SENSORS(
        "accelerometer_at_rest",
        "Reading of an accelerometer at rest, m/s²",
        estimation.accelerometer_at_rest,
        ("estimation.2.4", "sensors.2.2", "sensors.2.c"),
        arrays=(array.EULER, array.GRAVITY),
        arguments=(given.ROLL, given.PITCH, given.GRAVITY),
    ),
    SENSORS(
        "sensor_measures",
        "Reading of a three-axis sensor, by its model",
        sensor_forms.measured,
        ("sensors.2.3", "sensors.2.4"),
        arrays=(*array.TERMS, array.ACTUAL),
    ),
    SENSORS(
        "sensor_corrected",
        "What is there, from the reading of a three-axis sensor",
        calibration.corrected,
        ("sensors.2.5", "sensors.2.e", "sensors.4.1"),
        arrays=(*array.TERMS_BACK, array.MEASURED),
    ),
    SENSORS(
        "gyro_measures",
        "Reading of a rate gyro on which acceleration acts, by its model",
        lambda: sensor_forms.measured(calibration.coupled()),
        ("sensors.3.2",),
        arrays=(*array.TERMS, array.G_SENSITIVITY, array.ACCEL, array.ACTUAL),
    ),
    SENSORS(
        "gyro_corrected",
        "Body rates, from the reading of a rate gyro on which acceleration acts",
        lambda: calibration.corrected(calibration.coupled()),
        ("sensors.3.2",),
        arrays=(*array.TERMS_BACK, array.G_SENSITIVITY, array.ACCEL, array.MEASURED),
    ),
    SENSORS(
        "iron_removed",
        "The magnetic field without what soft and hard iron do to it",
        calibration.without_iron,
        ("sensors.4.2",),
        arrays=(
            ("soft_iron", given.SOFT_IRON),
            ("hard_iron", given.HARD_IRON),
            ("field", given.READING),
        ),
    ),
    SENSORS(
        "iron_added",
        "The magnetic field as soft and hard iron distort it",
        calibration.with_iron,
        ("sensors.4.2",),
        arrays=(("soft_iron", given.DISTORTION), ("hard_iron", given.HARD_IRON), array.ACTUAL),
    ),
    SENSORS(
        "vector_rate",
        "Derivatives of the body components of a vector that does not turn, unit/s",
        sensors.vector_rate,
        arrays=(("vector", given.BODY_VECTOR), array.BODY_RATES),
    ),
    SENSORS(
        "norm_misfit",
        "Length of a reading brought to the unit sphere, less 1, and its slopes by the unknowns",
        calibration.norm_misfit,
        arrays=(
            ("to_sphere", given.TO_SPHERE),
            ("centre", given.CENTRE),
            ("reading", given.READING),
        ),
    ),
    ESTIMATION(
        "tilt_from_accelerometer",
        "Roll and pitch of a body at rest, radians",
        filter_forms.tilt,
        ("estimation.2.5", "estimation.2.6", "validation.3", "validation.4"),
        arrays=(array.ACCEL,),
    ),
    ESTIMATION(
        "gyro_step",
        "Roll, pitch and yaw one period later by Euler integration, radians",
        filters.gyro_step,
        ("estimation.3.1", "estimation.3.2", "estimation.3.3"),
        arrays=(array.EULER, array.BODY_RATES, array.DT),
        over_samples=True,
    ),
    ESTIMATION(
        "gyro_turn",
        "Attitude quaternion one period later, by a turn at constant rates",
        filters.gyro_turn,
        arrays=(array.Q, array.BODY_RATES, array.DT),
        over_samples=True,
    ),
    ESTIMATION(
        "observer_turn",
        "Attitude quaternion one period later, the accelerometer heard with a fixed gain",
        filters.observer_turn,
        arrays=(array.Q, array.BODY_RATES, array.ACCEL, array.DT, array.GAIN),
        over_samples=True,
    ),
    ESTIMATION(
        "observer_step",
        "Roll, pitch and yaw one period later, the accelerometer heard with a fixed gain, radians",
        filters.observer_step,
        arrays=(array.EULER, array.BODY_RATES, array.ACCEL, array.DT, array.GAIN),
        over_samples=True,
    ),
    ESTIMATION(
        "euler_observer_step",
        "Roll, pitch and yaw one period later by the notes' step, angle by angle, radians",
        filters.euler_observer_step,
        ("estimation.4.1", "estimation.4.2", "estimation.4.3", "estimation.4.4"),
        arrays=(array.EULER, array.BODY_RATES, array.ACCEL, array.DT, array.GAIN),
        over_samples=True,
    ),
    VALIDATION(
        "heading_from_magnetometer",
        "Yaw, radians",
        filter_forms.heading,
        ("validation.12", "validation.16"),
        arrays=(array.MAG, ("tilt", given.ANGLES[:2]), ("reference", (given.NORTH, given.EAST))),
    ),
    VALIDATION(
        "validation_factor",
        "The factor E: by how much the field down is off, the whole field being 1",
        filter_forms.factor,
        ("validation.17",),
        arrays=(array.MAG, ("tilt", given.ANGLES[:2]), *array.numbers(given.DOWN)),
    ),
    VALIDATION(
        "monitor_gain",
        "Gain to use once E has been above the threshold for so many samples",
        monitor.gain,
        arrays=array.numbers(given.ABOVE, given.PATIENCE, *given.GAINS),
    ),
    VALIDATION(
        "monitor_count",
        "For how many samples in a row E has been above the threshold; NaN tells nothing",
        monitor.samples_above,
        arguments=(given.ABOVE, given.FACTOR, given.THRESHOLD),
    ),
    VALIDATION(
        "monitored_turn",
        "Attitude quaternion one period later by the gain that a monitor asks for, and its count",
        filters.monitored_turn,
        arrays=(
            ("state", (*given.QUATERNION_ARGUMENTS, given.ABOVE)),
            array.BODY_RATES,
            array.ACCEL,
            array.MAG,
            array.DT,
            *array.numbers(given.DOWN, given.THRESHOLD, given.PATIENCE, *given.GAINS),
        ),
        over_samples=True,
    ),
    DEAD_RECKONING(
        "inertial_acceleration",
        "Acceleration of the body in the inertial frame, m/s²",
        dead_reckoning.inertial_acceleration,
        ("dead_reckoning.2.3",),
        arrays=(array.ACCEL, array.EULER, array.GRAVITY),
    ),
    DEAD_RECKONING(
        "accelerometer_from_acceleration",
        "Reading of an accelerometer on a body that accelerates, m/s²",
        dead_reckoning.accelerometer_reading,
        ("dead_reckoning.2.1",),
        arrays=(("acceleration", given.ACCELERATION), array.EULER, array.GRAVITY),
    ),
    DEAD_RECKONING(
        "dead_reckoning_held",
        "Velocity north, east, down (m/s), then position (m), one period later by the notes' step",
        reckoning_forms.held_step,
        ("dead_reckoning.3.3", "dead_reckoning.3.4"),
        arrays=(
            ("state", (*given.VELOCITY, *given.POSITION)),
            ("acceleration", given.ACCELERATION),
            array.DT,
        ),
        over_samples=True,
    ),
    DEAD_RECKONING(
        "dead_reckoning_step",
        "Velocity north, east, down (m/s), then position (m), one period later",
        reckoning_forms.step,
        ("dead_reckoning.3.1", "dead_reckoning.3.2"),
        arguments=(
            *given.VELOCITY,
            *given.POSITION,
            *given.ACCELERATION,
            *given.NEXT,
            given.PERIOD,
        ),
    ),
    DEAD_RECKONING(
        "drift_from_tilt_error",
        "Error of acceleration (m/s²), of velocity (m/s) and of position (m), along the ground",
        dead_reckoning.drift,
        ("dead_reckoning.4.a", "dead_reckoning.4.b"),
        arrays=array.numbers(given.TILT_ERROR, given.TIME, given.GRAVITY),
    ),
    DEAD_RECKONING(
        "position_errors",
        "Errors of position (m) by tilt, biases, motion, and variances (m²) by noise",
        reckoning_forms.position_errors,
        arrays=array.numbers(*given.ERRORS, given.TIME, given.GRAVITY),
    ),
    DEAD_RECKONING(
        "position_at_last_velocity",
        "Error of position (m), had its last error of velocity been there all along",
        dead_reckoning.position_at_last_velocity,
        arguments=(given.TILT_ERROR, given.TIME, given.GRAVITY),
    ),
)
