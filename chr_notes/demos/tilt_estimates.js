/** What an accelerometer on a moving body reads, and the tilt that it makes of it. */
import {
  accelerometerFromAcceleration,
  matrixFromEuler,
  tiltFromAccelerometer,
  wrapAngle,
} from "../generated/javascript/attitude.mjs";
import { scaled, sum, toParent } from "./draw.js";
import shakes from "./vibration.json"; // readings of a vibration of 1 m/s² RMS on each axis

/* global STANDARD_GRAVITY, NOTHING: build.py puts them in, m/s² */

const DEGREE = Math.PI / 180;

/** Roll and pitch in radians. */
export const attitude = ({ roll, pitch }) => [roll * DEGREE, pitch * DEGREE];

/** True of a body that keeps its velocity. */
export const unaccelerated = (state) =>
  state.forward_acceleration === 0 && state.lateral_acceleration === 0;

/** The reading without vibration, in the body frame, m/s². */
export function reading(state) {
  const angles = [...attitude(state), 0];
  const acceleration = [state.forward_acceleration, state.lateral_acceleration, 0];
  return accelerometerFromAcceleration(
    ...toParent(matrixFromEuler(...angles), acceleration), ...angles, STANDARD_GRAVITY,
  );
}

/** Each of the readings of one second with the vibration in them. */
export const readings = (state) => {
  const still = reading(state);
  return shakes.map((shake) => sum(still, scaled(shake, state.vibration)));
};

/** The same angle in (−π, π], as Python's function has it: the generated one may end at −π. */
const upToHalfTurn = (angle) => -wrapAngle(-angle);

const rms = (values) => Math.hypot(...values) / Math.sqrt(values.length);

/** Errors in degrees, [roll, pitch], of the angles that a reading gives. */
const errors = (state, sensed) => {
  const truth = attitude(state);
  return tiltFromAccelerometer(...sensed).map((angle, i) => wrapAngle(angle - truth[i]) / DEGREE);
};

/**
 * What the accelerometer makes of it all, in degrees; each a pair [roll, pitch]. `unknown` says
 * of which angle the reading holds nothing: of roll when it lies along the roll axis, of both when
 * there is no reading. The function still returns a number, which rounding alone decides.
 */
export function estimates(state) {
  const average = reading(state);
  const error = errors(state, average);
  const single = readings(state).map((sensed) => errors(state, sensed));
  const scatter = error.map((mean, i) =>
    rms(single.map((each) => wrapAngle((each[i] - mean) * DEGREE) / DEGREE)),
  );
  const estimate = tiltFromAccelerometer(...average).map((angle) => upToHalfTurn(angle) / DEGREE);
  const unknown = [Math.hypot(average[1], average[2]), Math.hypot(...average)].map(
    (force) => force < NOTHING,
  );
  return { estimate, error, single, scatter, unknown };
}
