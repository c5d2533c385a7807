/** Readings of a magnetometer near iron, and what they mean for the heading. */
import {
  headingFromMagnetometer,
  ironAdded,
  ironRemoved,
  matrixFromEuler,
  quaternionFromAxisAngle,
  quaternionMultiply,
  wrapAngle,
} from "../generated/javascript/attitude.mjs";
import { scaled, sum, toChild } from "./draw.js";
import { gapOf, unit } from "./magnetometer_fit.js";
import { attitudes, fieldAt } from "./magnetometer_hand.js";
import { noise } from "./noise.js";

/* global MAGNETOMETER: build.py puts it in, from magnetometer.py */

const DEGREE = Math.PI / 180;
const { field: FIELD, walk: WALK, turns: TURNS, seed: SEED, headings: HEADINGS } = MAGNETOMETER;
const { hard: HARD, soft: SOFT } = MAGNETOMETER;
const NOISE = noise(WALK, 3, SEED);
export const STRENGTH = Math.hypot(...FIELD);
/** Degrees by which the field points below the horizon. */
export const FIELD_DIP = Math.atan2(FIELD[2], FIELD[0]) / DEGREE;

const column = (count, make) => Array.from({ length: count }, (_, i) => make(i));

/** The iron: a bias, and a matrix that stretches, each by how strong it is. */
export function ironOf({ hard_iron: hard, soft_iron: soft }) {
  const stretch = SOFT.map((element, i) => (i % 4 === 0 ? 1 : 0) + soft * element);
  return [...stretch, ...scaled(HARD, hard)];
}

/** The attitudes: those of the hand, or a walk on which it is turned all the while, and tilted more and more. */
export function path({ readings, tilt, turned }) {
  if (turned !== "") return attitudes(turned);
  return column(readings, (i) => {
    const leaning = Math.acos(1 - (1 - Math.cos(tilt * DEGREE)) * ((i + 0.5) / WALK));
    const [yaw, side] = TURNS.map((turn) => 2 * Math.PI * turn * i);
    const whole = quaternionFromAxisAngle(0, 0, 1, yaw);
    const leant = quaternionFromAxisAngle(Math.cos(side), Math.sin(side), 0, leaning);
    return quaternionMultiply(...whole, ...leant);
  });
}

/** The field in the body at each attitude. */
const walk = (state) => path(state).map(fieldAt);

export const cloud = (state) => {
  const iron = ironOf(state);
  return walk(state).map((field, i) => sum(ironAdded(...iron, ...field), scaled(NOISE[i], state.noise)));
};

/** The part of the sphere that the walk leaves out: the largest gap, degrees. */
export const gap = (state) => gapOf(walk(state).map(unit)) / DEGREE;

/** Errors of the heading of a level sensor at each heading, degrees, without and with a calibration. */
export function headingErrors(state, found) {
  const iron = ironOf(state);
  const error = (mag, yaw) => wrapAngle(headingFromMagnetometer(...mag, 0, 0, 1, 0) - yaw) / DEGREE;
  return column(HEADINGS, (i) => {
    const yaw = (2 * Math.PI * i) / HEADINGS;
    const mag = ironAdded(...iron, ...toChild(matrixFromEuler(0, 0, yaw), FIELD));
    return {
      heading: (360 * i) / HEADINGS,
      before: error(mag, yaw),
      after: found.refused ? NaN : error(ironRemoved(...found.iron, ...mag), yaw),
    };
  });
}
