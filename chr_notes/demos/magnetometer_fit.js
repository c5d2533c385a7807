/** The ellipsoid that is fitted to a cloud of points, and whether it can be trusted: as `fit_ellipsoid` does. */
import { normMisfit } from "../generated/javascript/attitude.mjs";
import { evenlySpread } from "./directions.js";
import { scaled, sum, toChild } from "./draw.js";
import { solved } from "./equations.js";

/* global MAGNETOMETER: build.py puts it in, from magnetometer.py */

export const { widest_gap: WIDEST_GAP, largest_error: LARGEST_ERROR } = MAGNETOMETER;
const [STEPS, CONVERGED] = [30, 1e-9]; // of Gauss and Newton
const [HALVINGS, ROUNDING] = [60, 1e-12]; // of the largest element
export const FEWEST = 10; // one more than there are unknowns
export const AROUND = evenlySpread(500);

const column = (count, make) => Array.from({ length: count }, (_, i) => make(i));
const dot = (a, b) => a.reduce((total, part, i) => total + part * b[i], 0);
const times = (rows, vector) => rows.map((row) => dot(row, vector));
const apart = (rows, others, factor) => rows.map((row, i) => row.map((each, j) => each - factor * others[i][j]));

/** The largest angle between a direction and the nearest of these, radians. */
export function gapOf(outward) {
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

export const unit = (vector) => scaled(vector, 1 / Math.hypot(...vector));

const full = ([xx, xy, xz, yy, yz, zz]) => [xx, xy, xz, xy, yy, yz, xz, yz, zz];
const determinant = ([a, b, c, d, e, f, g, h, i]) => a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);

function positive(matrix) {
  const [a, b, , d, e] = matrix;
  return a > 0 && a * e - b * d > 0 && determinant(matrix) > 0;
}

/** Sums of products of the columns of rows, each with each. */
function products(rows) {
  const size = rows[0].length;
  const found = column(size, () => column(size, () => 0));
  for (const row of rows) for (let i = 0; i < size; i++) for (let j = i; j < size; j++) found[i][j] += row[i] * row[j];
  for (let i = 0; i < size; i++) for (let j = 0; j < i; j++) found[i][j] = found[j][i];
  return found;
}

/** Whether a symmetric matrix is positive definite: by the pivots of its elimination. */
function definite(matrix) {
  const rows = matrix.map((row) => [...row]);
  return rows.every((row, k) => {
    for (const other of rows.slice(k + 1)) {
      const factor = other[k] / row[k];
      for (let j = k; j < row.length; j++) other[j] -= factor * row[j];
    }
    return row[k] > 0;
  });
}

// 4 J − I², with I and J the linear and the quadratic invariant of a quadric's matrix: Li and Griffiths' constraint.
const CONSTRAINT = column(6, (i) => column(6, (j) => (i < 3 && j < 3 ? 1 : 0) - (i === j ? (i < 3 ? 2 : 4) : 0)));

/**
 * Where a x = e C x has its only e above 0: below it a − e C is positive definite, beyond it not. The
 * solution for it is what the inverse of that makes of almost any x.
 */
function onlyPositive(a) {
  const size = Math.max(...a.flat().map(Math.abs));
  const trial = [1, 1, 1, 0, 0, 0];
  let [low, high] = [0, dot(trial, times(a, trial)) / dot(trial, times(CONSTRAINT, trial))];
  for (let i = 0; i < HALVINGS; i++) {
    const middle = (low + high) / 2;
    if (definite(apart(a, CONSTRAINT, middle))) low = middle;
    else high = middle;
  }
  const near = apart(a, CONSTRAINT, low - ROUNDING * size);
  return [1, 2, 3].reduce((x) => x && solved(near, unit(times(CONSTRAINT, x))), trial);
}

/** The root of a symmetric positive matrix, by Newton's steps; null where it is flat. */
function rootOf(matrix) {
  let root = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
  for (let step = 0; step < STEPS; step++) {
    const back = inverted(root);
    if (back === null) return null;
    root = root.map((row, i) => row.map((each, j) => (each + dot(matrix[i], back[j])) / 2));
  }
  return root;
}

/** The nearest quadric that is an ellipsoid, as the unknowns of `normMisfit`; null where there is none. */
function direct(points) {
  const rows = points.map(([x, y, z]) => [x * x, y * y, z * z, 2 * y * z, 2 * x * z, 2 * x * y, 2 * x, 2 * y, 2 * z, 1]);
  const all = products(rows);
  const linear = all.slice(6).map((row) => row.slice(6));
  const fromSquares = all.slice(0, 6).map((row) => solved(linear, row.slice(6)));
  if (fromSquares.includes(null)) return null;
  const left = all.slice(0, 6).map((row) => row.slice(0, 6).map((each, j) => each - dot(row.slice(6), fromSquares[j])));
  const quadric = onlyPositive(left);
  if (quadric === null) return null;
  const [xx, yy, zz, yz, xz, xy] = quadric;
  const matrix = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
  const [u, v, w, rest] = [0, 1, 2, 3].map((i) => -quadric.reduce((total, each, j) => total + each * fromSquares[j][i], 0));
  const centre = solved(matrix, [-u, -v, -w]);
  if (centre === null) return null;
  const size = dot(centre, times(matrix, centre)) - rest;
  const ellipsoid = matrix.map((row) => scaled(row, 1 / size));
  const root = definite(ellipsoid) ? rootOf(ellipsoid) : null;
  return root && [...root[0], ...root[1].slice(1), root[2][2], ...centre];
}

/** From there by Gauss and Newton to where all norms are as equal to 1 as they get. */
function refined(points) {
  let unknowns = direct(points);
  if (unknowns === null) return null;
  for (let step = 0; step < STEPS; step++) {
    const [[, ...right], ...equations] = products(points.map((point) => normMisfit(...unknowns, ...point)));
    const change = solved(equations.map((row) => row.slice(1)), scaled(right, -1));
    if (change === null) return null;
    unknowns = sum(unknowns, change);
    if (!positive(full(unknowns))) return null;
    if (Math.max(...change.map(Math.abs)) < CONVERGED) return unknowns;
  }
  return null;
}

/**
 * What a fit finds: { iron }, the numbers that `ironRemoved` takes, or { refused }, with the ellipsoid if there
 * is one: the gap in it, radians, and how much too long a point of any direction comes out of it, a part of 1.
 */
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
  const gap = gapOf(near.map(corrected).map(unit));
  if (gap > WIDEST_GAP || worstError(near, found, matrix, centre) > LARGEST_ERROR) {
    const tooLong = (point) => Math.hypot(...corrected(scaled(sum(point, scaled(middle, -1)), 1 / extent))) - 1;
    return { refused: true, gap, tooLong };
  }
  const shape = scaled(matrix, determinant(matrix) ** (-1 / 3));
  const middleOfAll = sum(scaled(centre, extent), middle);
  return { refused: false, iron: [...shape, ...toChild(shape, middleOfAll)] };
}

/** The inverse of a symmetric matrix; null where there is none. */
function inverted(rows) {
  const found = rows.map((_, k) => solved(rows, rows.map((__, i) => Number(i === k))));
  return found.includes(null) ? null : found;
}

/** Standard error of the norm, in the direction in which it is worst. */
function worstError(points, found, matrix, centre) {
  const rows = points.map((point) => normMisfit(...found, ...point));
  const variance = rows.reduce((total, [residual]) => total + residual * residual, 0) / (points.length - 9);
  const covariance = inverted(products(rows.map(([, ...slopes]) => slopes)));
  const back = inverted([0, 3, 6].map((start) => matrix.slice(start, start + 3)));
  if (covariance === null || back === null) return Infinity;
  const errors = AROUND.map((direction) => {
    const [, ...slopes] = normMisfit(...found, ...sum(centre, times(back, direction)));
    return dot(slopes, times(covariance, slopes));
  });
  return Math.sqrt(variance * Math.max(...errors));
}
