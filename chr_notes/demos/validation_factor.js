/** The factor E of an attitude that is off, in each direction in which it can be. */
import {
  eulerFromQuaternion,
  inclinationFromQuaternion,
  quaternionFromAxisAngle,
  quaternionFromEuler,
  quaternionMultiply,
  rotateToBody,
  validationFactor,
} from "../generated/javascript/attitude.mjs";
import { evenlySpread } from "./directions.js";
import { scaled, sum } from "./draw.js";
import { direction } from "./globe.js";
import { keeping } from "./keeping.js";
import { noise } from "./noise.js";

/* global VALIDATION: build.py puts it in, from validation.py */

const DEGREE = Math.PI / 180;
const { directions: DIRECTIONS, readings: READINGS, noise: SIZE, seed: SEED } = VALIDATION;
const AROUND = evenlySpread(DIRECTIONS);
const NOISE = noise(READINGS, 3, SEED);

/** The direction of the field, north and down. */
export const fieldOf = ({ inclination }) => direction(0, -inclination);

const truth = ({ heading }) => quaternionFromEuler(0, 0, heading * DEGREE);

/** What the magnetometer of the level robot reads, the field being 1, with iron below or above it. */
const readingOf = (state) => sum(rotateToBody(...truth(state), ...fieldOf(state)), [0, 0, state.iron]);

const turnOf = (state, axis) => quaternionFromAxisAngle(...axis, state.error * DEGREE);

/** E, with its sign, by the axis in the inertial frame about which the attitude is off by the error. */
export function signedFactor(state) {
  const [q, reading, down] = [truth(state), readingOf(state), fieldOf(state)[2]];
  return (axis) => {
    const [roll, pitch] = eulerFromQuaternion(...quaternionMultiply(...turnOf(state, axis), ...q));
    return validationFactor(...reading, roll, pitch, down);
  };
}

/** What E about an axis depends on: a level robot sees the same, wherever it heads to. */
export const SEEN_BY = ["error", "iron", "inclination"];

/** The axis of the error, fixed to the robot, in the inertial frame. */
export const axisOf = ({ heading, axis_yaw: yaw, axis_pitch: pitch }) => direction(heading + yaw, pitch);

export const factor = (state) => Math.abs(signedFactor(state)(axisOf(state)));

/** Degrees between the true vertical and the believed one. */
export const tiltError = (state) => inclinationFromQuaternion(...turnOf(state, axisOf(state))) / DEGREE;

const rising = (values) => values.map(Math.abs).sort((a, b) => a - b);

/** E for errors all around, from small to large. */
export const around = keeping(SEEN_BY, (state) => rising(AROUND.map(signedFactor(state))));

/** E for readings with noise at the right attitude, from small to large. */
export const quietly = keeping(["heading", "iron", "inclination"], (state) => {
  const [reading, down] = [readingOf(state), fieldOf(state)[2]];
  return rising(NOISE.map((each) => validationFactor(...sum(reading, scaled(each, SIZE)), 0, 0, down)));
});

/** The share of values, in per cent, that a threshold does not exceed: `values` from small to large. */
export function belowOf(values, threshold) {
  let [below, above] = [0, values.length];
  while (below < above) {
    const middle = (below + above) >> 1;
    if (values[middle] > threshold) above = middle;
    else below = middle + 1;
  }
  return (100 * below) / values.length;
}
