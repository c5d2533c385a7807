/**
 * One attitude in the conventions of two systems, as `chr_notes.convert` does it in Python.
 *
 * A convention is a row of Python's table: { sequence, order, signs, degrees, transposed, scalarFirst,
 * conjugated, navigation, body, … }, its axes as columns of flat matrices. What each field does is
 * only which element goes where and with which sign; all formulas are generated.
 */
import {
  anglesFromMatrix,
  axisAngleFromQuaternion,
  matrixFromAngles,
  matrixFromQuaternion,
  quaternionConjugate,
  quaternionFromAxisAngle,
  quaternionFromMatrix,
  rotationDefect,
} from "../generated/javascript/attitude.mjs";
import { times, transposed } from "./draw.js";

/* global CONVENTIONS: build.py puts in what chr_notes/demos/converter.py has of Python's tables */

export const { systems: SYSTEMS, sequences: SEQUENCES } = CONVENTIONS;
const LARGEST_DEFECT = 1e-4; // as in Python: printed matrices pass
const [TO_RADIANS, TO_DEGREES] = [Math.PI / 180, 180 / Math.PI];
const [NOWHERE, ALONG] = [1e-9, 1e-12]; // degrees from the lock, and between triples of one attitude

/** A system's convention, with another sequence or unit where they are given. */
export function conventionOf(name, sequence = "", unit = "") {
  const own = SYSTEMS[name];
  const changed = sequence === "" || sequence === own.sequence ? own : { ...own, sequence, order: [0, 1, 2], signs: [1, 1, 1] };
  return unit === "" ? changed : { ...changed, degrees: unit === "degrees" };
}

const isRotating = (sequence) => sequence === sequence.toUpperCase();
const isProper = (sequence) => sequence[0] === sequence[2];

/** Angles in the order of turns about rotating axes, or back in the order of the letters. */
const ordered = (angles, sequence) => (isRotating(sequence) ? angles : [...angles].reverse());

/** The axes of the turns as they have turned, 1, 2, 3 for x, y, z. */
const axesOf = (sequence) => ordered([...sequence.toUpperCase()].map((letter) => 1 + "XYZ".indexOf(letter)), sequence);

const NAMES = { forward: "roll", back: "roll", left: "pitch", right: "pitch", up: "yaw", down: "yaw" };

/** The angles as they are written, each by its axis, and by its name where there are three axes. */
export function turnNames({ sequence, order, along }) {
  const letters = [...sequence.toLowerCase()];
  const named = letters.map((letter, i) =>
    isProper(sequence) ? `${["first", "second", "third"][i]} ${letter}` : `${NAMES[along["xyz".indexOf(letter)]]} ${letter}`,
  );
  const written = [];
  order.forEach((place, i) => (written[place] = named[i]));
  return written;
}

/** The matrix from navigation to body of turns by angles in radians, in the order of the letters. */
export const matrixOfTurns = (angles, sequence) => matrixFromAngles(...ordered(angles, sequence), ...axesOf(sequence));

/** Angles in radians in the order of the letters, and whether they lock. */
export function turnsOf(matrix, sequence) {
  const found = anglesFromMatrix(...matrix, ...axesOf(sequence));
  return { turns: ordered(found.slice(0, 3), sequence), locked: found[3] };
}

/** How far a matrix is from a rotation: what is to be said of it, or nothing. */
export function faultOf(matrix) {
  const [defect, determinant] = rotationDefect(...matrix);
  return defect <= LARGEST_DEFECT && determinant > 0 ? null : { defect, determinant };
}

const unscaled = (numbers) => {
  const size = Math.max(...numbers.map(Math.abs));
  return numbers.map((value) => value / size);
};

const conjugatedAs = (q, { conjugated }) => (conjugated ? quaternionConjugate(...q) : q);

/** The matrix from navigation to body, in the convention's own axes, of what stands for it. */
export function toBody(value, convention, kind) {
  const radians = (angle) => (convention.degrees ? angle * TO_RADIANS : angle);
  if (kind === "angles") return matrixOfTurns(convention.order.map((place, i) => convention.signs[i] * radians(value[place])), convention.sequence);
  if (kind === "matrix") return convention.transposed ? transposed(value) : value;
  if (kind === "axis angle") {
    const q = quaternionFromAxisAngle(...unscaled(value.slice(0, 3)), radians(value[3]));
    return matrixFromQuaternion(...conjugatedAs(q, convention));
  }
  const [scalar, ...vector] = convention.scalarFirst ? value : [value[3], ...value.slice(0, 3)];
  return matrixFromQuaternion(...conjugatedAs(unscaled([scalar, ...vector]), convention));
}

/** Angles as the convention writes them, of turns in radians in the order of its letters. */
const writtenAs = (turns, { order, signs, degrees }) => {
  const written = [];
  order.forEach((place, i) => (written[place] = signs[i] * (degrees ? turns[i] * TO_DEGREES : turns[i])));
  return written;
};

/** A matrix from navigation to body, in the convention's own axes, as it writes it. */
export function fromMatrix(matrix, convention, kind) {
  if (kind === "angles") return writtenAs(turnsOf(matrix, convention.sequence).turns, convention);
  if (kind === "matrix") return convention.transposed ? transposed(matrix) : matrix;
  const q = conjugatedAs(quaternionFromMatrix(...matrix), convention);
  if (kind === "quaternion") return convention.scalarFirst ? q : [...q.slice(1), q[0]];
  const [x, y, z, angle] = axisAngleFromQuaternion(...q);
  return [x, y, z, convention.degrees ? angle * TO_DEGREES : angle];
}

/** The same attitude as a matrix from navigation to body in the axes of another convention. */
export const inAxesOf = (matrix, source, target) =>
  times(times(transposed(target.body), source.body), times(matrix, times(transposed(source.navigation), target.navigation)));

export function convert(value, source, target, kind, wanted = kind) {
  return fromMatrix(inAxesOf(toBody(value, source, kind), source, target), target, wanted);
}

/** All triples of angles of a matrix, as written, but for whole turns: two, or one of many at the lock. */
export function triplesOf(matrix, convention) {
  const { sequence } = convention;
  const { turns, locked } = turnsOf(matrix, sequence);
  const half = (angle) => (angle > 0 ? angle - Math.PI : angle + Math.PI);
  const [first, second, third] = turns;
  // What else could be: half a turn more about the outer axes. What rebuilds the matrix is kept.
  const others = [-second, half(-second)].map((angle) => [half(first), angle, half(third)]);
  const same = (angles) => matrixOfTurns(angles, sequence).every((value, i) => Math.abs(value - matrix[i]) < ALONG);
  const kept = locked ? [turns] : [turns, ...others.filter(same)];
  return { triples: kept.map((angles) => writtenAs(angles, convention)), locked, fromLock: fromLock(second, sequence, locked) };
}

/** Degrees from the second angle to the nearest lock. */
function fromLock(second, sequence, locked) {
  const angle = Math.abs(second) * TO_DEGREES;
  const apart = isProper(sequence) ? Math.min(angle, 180 - angle) : 90 - angle;
  return locked || apart < NOWHERE ? 0 : apart;
}
