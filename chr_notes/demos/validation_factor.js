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

/** E, with its sign, when the attitude is off by the error about an axis in the inertial frame. */
export function signedFactor(state, axis) {
  const [roll, pitch] = eulerFromQuaternion(...quaternionMultiply(...turnOf(state, axis), ...truth(state)));
  return validationFactor(...readingOf(state), roll, pitch, fieldOf(state)[2]);
}

const factorAbout = (state, axis) => Math.abs(signedFactor(state, axis));

/** The axis of the error, fixed to the robot, in the inertial frame. */
export const axisOf = ({ heading, axis_yaw: yaw, axis_pitch: pitch }) => direction(heading + yaw, pitch);

export const factor = (state) => factorAbout(state, axisOf(state));

/** Degrees between the true vertical and the believed one. */
export const tiltError = (state) => inclinationFromQuaternion(...turnOf(state, axisOf(state))) / DEGREE;

/** E for errors all around, and for readings with noise at the right attitude; both from small to large. */
export function samples(state) {
  const down = fieldOf(state)[2];
  const reading = readingOf(state);
  const quiet = NOISE.map((each) => Math.abs(validationFactor(...sum(reading, scaled(each, SIZE)), 0, 0, down)));
  const rising = (values) => values.sort((a, b) => a - b);
  return { all: rising(AROUND.map((axis) => factorAbout(state, axis))), quiet: rising(quiet) };
}

/** The share of values, in per cent, that a threshold does not exceed: `values` from small to large. */
export function belowOf(values, threshold) {
  const first = values.findIndex((value) => value > threshold);
  return (100 * (first < 0 ? values.length : first)) / values.length;
}
