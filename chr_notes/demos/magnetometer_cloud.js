/** Readings of a magnetometer near iron, and the ellipsoid that is fitted to them. */
import {
  headingFromMagnetometer,
  ironAdded,
  ironRemoved,
  matrixFromEuler,
  normMisfit,
  quaternionFromAxisAngle,
  quaternionMultiply,
  wrapAngle,
} from "../generated/javascript/attitude.mjs";
import { evenlySpread } from "./directions.js";
import { scaled, sum, toChild } from "./draw.js";
import { solved } from "./equations.js";
import { attitudes, fieldAt } from "./magnetometer_hand.js";
import { noise } from "./noise.js";

/* global MAGNETOMETER: build.py puts it in, from magnetometer.py */

const DEGREE = Math.PI / 180;
const { field: FIELD, walk: WALK, turns: TURNS, seed: SEED, headings: HEADINGS } = MAGNETOMETER;
const { hard: HARD, soft: SOFT, widest_gap: WIDEST_GAP, largest_error: LARGEST_ERROR } = MAGNETOMETER;
const NOISE = noise(WALK, 3, SEED);
const [STEPS, CONVERGED] = [30, 1e-9]; // of Gauss and Newton
export const FEWEST = 10; // one more than there are unknowns
export const STRENGTH = Math.hypot(...FIELD);
/** Degrees by which the field points below the horizon. */
export const FIELD_DIP = Math.atan2(FIELD[2], FIELD[0]) / DEGREE;

const column = (count, make) => Array.from({ length: count }, (_, i) => make(i));

const AROUND = evenlySpread(500);

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

/** The largest angle between a direction and the nearest of these, radians. */
function gapOf(outward) {
  let widest = 1; // its cosine
  for (const [x, y, z] of AROUND) {
    let nearest = -1;
    for (const [u, v, w] of outward) {
      nearest = Math.max(nearest, x * u + y * v + z * w);
      if (nearest >= widest) break; // no wider one is here
    }
    widest = Math.min(widest, nearest);
  }
  return Math.acos(Math.max(-1, widest));
}

const unit = (vector) => scaled(vector, 1 / Math.hypot(...vector));

/** The part of the sphere that the walk leaves out: the largest gap, degrees. */
export const gap = (state) => gapOf(walk(state).map(unit)) / DEGREE;

const full = ([xx, xy, xz, yy, yz, zz]) => [xx, xy, xz, xy, yy, yz, xz, yz, zz];
const determinant = ([a, b, c, d, e, f, g, h, i]) => a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);

function positive(matrix) {
  const [a, b, , d, e] = matrix;
  return a > 0 && a * e - b * d > 0 && determinant(matrix) > 0;
}

/** Sums of products of the columns of rows [residual, …slopes]: the normal equations. */
function normal(rows) {
  const found = column(9, () => column(10, () => 0));
  for (const row of rows)
    for (let i = 0; i < 9; i++) {
      for (let j = i; j < 9; j++) found[i][j] += row[i + 1] * row[j + 1];
      found[i][9] -= row[i + 1] * row[0];
    }
  for (let i = 0; i < 9; i++) for (let j = 0; j < i; j++) found[i][j] = found[j][i];
  return found;
}

/** From a sphere by Gauss and Newton to where all norms are as equal to 1 as they get. */
function refined(points) {
  let unknowns = [1, 0, 0, 1, 0, 1, 0, 0, 0];
  for (let step = 0; step < STEPS; step++) {
    const equations = normal(points.map((point) => normMisfit(...unknowns, ...point)));
    const change = solved(equations.map((row) => row.slice(0, 9)), equations.map((row) => row[9]));
    if (change === null) return null;
    unknowns = sum(unknowns, change);
    if (!positive(full(unknowns))) return null;
    if (Math.max(...change.map(Math.abs)) < CONVERGED) return unknowns;
  }
  return null;
}

/** What a fit finds: { refused } or { iron }, the numbers that `ironRemoved` takes. */
export function fit(points) {
  if (points.length < FEWEST) return { refused: true };
  const middle = scaled(points.reduce(sum), 1 / points.length);
  const off = points.map((point) => sum(point, scaled(middle, -1)));
  const extent = Math.sqrt(off.reduce((total, point) => total + Math.hypot(...point) ** 2, 0) / points.length);
  const near = off.map((point) => scaled(point, 1 / extent));
  const found = refined(near);
  if (found === null) return { refused: true };
  const [matrix, centre] = [full(found), found.slice(6)];
  const corrected = (point) => toChild(matrix, sum(point, scaled(centre, -1)));
  if (gapOf(near.map(corrected).map(unit)) > WIDEST_GAP || worstError(near, found, matrix, centre) > LARGEST_ERROR)
    return { refused: true };
  const shape = scaled(matrix, determinant(matrix) ** (-1 / 3));
  const middleOfAll = sum(scaled(centre, extent), middle);
  return { refused: false, iron: [...shape, ...toChild(shape, middleOfAll)] };
}

const dot = (a, b) => a.reduce((total, part, i) => total + part * b[i], 0);
const times = (rows, vector) => rows.map((row) => dot(row, vector));

/** The inverse of a symmetric matrix; null where there is none. */
function inverted(rows) {
  const found = rows.map((_, k) => solved(rows, rows.map((__, i) => Number(i === k))));
  return found.includes(null) ? null : found;
}

/** Standard error of the norm, in the direction in which it is worst. */
function worstError(points, found, matrix, centre) {
  const rows = points.map((point) => normMisfit(...found, ...point));
  const variance = rows.reduce((total, [residual]) => total + residual * residual, 0) / (points.length - 9);
  const covariance = inverted(normal(rows).map((row) => row.slice(0, 9)));
  const back = inverted([0, 3, 6].map((start) => matrix.slice(start, start + 3)));
  if (covariance === null || back === null) return Infinity;
  const errors = AROUND.map((direction) => {
    const [, ...slopes] = normMisfit(...found, ...sum(centre, times(back, direction)));
    return dot(slopes, times(covariance, slopes));
  });
  return Math.sqrt(variance * Math.max(...errors));
}

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
