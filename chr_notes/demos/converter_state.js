/** What the converter computes of its state, and what it makes of a text: no page is needed for it. */
import {
  SEQUENCES,
  SYSTEMS,
  conventionOf,
  faultOf,
  fromMatrix,
  inAxesOf,
  toBody,
  triplesOf,
  turnNames,
} from "./converting.js";
import { numbersIn, rotationIn } from "./reading.js";

export const SIZES = { angles: 3, quaternion: 4, "axis angle": 4, matrix: 9 };
export const KINDS = Object.keys(SIZES);
const UNITS = ["", "degrees", "radians"];

/** The conventions of the two systems of a state. */
export const sourceOf = (state) => conventionOf(state.source, state.source_sequence, state.source_unit);
export const targetOf = (state) => conventionOf(state.target, state.target_sequence, state.target_unit);

/** All that a convention says of a matrix from navigation to body, in its own axes. */
const saidOf = (matrix, convention) => ({
  ...Object.fromEntries(KINDS.map((kind) => [kind, fromMatrix(matrix, convention, kind)])),
  ...triplesOf(matrix, convention),
});

/** What both systems say; the source as it was given, where it was given. */
export function computed(state) {
  const [source, target] = [sourceOf(state), targetOf(state)];
  const own = toBody(state.value, source, state.kind);
  const matrix = inAxesOf(own, source, target);
  return {
    source, target, matrix, own,
    here: { ...saidOf(own, source), [state.kind]: state.value },
    there: saidOf(matrix, target),
  };
}

/** What is wrong with values of a kind, as { words, matrix? }; null for nothing. */
function faultIn(kind, values) {
  if (!values.every(Number.isFinite)) return { words: "A number is too large to be one." };
  if (kind === "matrix") return faultInMatrix(values);
  const directed = kind === "quaternion" ? values : kind === "axis angle" ? values.slice(0, 3) : [1];
  return directed.some((value) => value !== 0) ? null : { words: `This ${kind === "quaternion" ? "quaternion" : "axis"} is zero, and stands for no turn.` };
}

function faultInMatrix(matrix) {
  const fault = faultOf(matrix);
  if (fault === null) return null;
  const { defect, determinant } = fault;
  const off = `R Rᵀ is off the unit matrix by ${Number(defect.toPrecision(3))} (root mean square; 0.0001 passes), and the determinant is ${Number(determinant.toPrecision(4))}`;
  return determinant < 0
    ? { words: `No rotation but a reflection: ${off}. One axis points the other way, as between a right-handed and a left-handed frame.` }
    : { words: `No rotation: ${off}. With fewer than four digits take the nearest rotation.`, matrix };
}

/** Numbers with labels in the order of the convention; as they stand without. */
function inOrder({ values, labels }, kind, convention) {
  if (labels === null) return values;
  const names = kind === "quaternion"
    ? (convention.scalarFirst ? ["w", "x", "y", "z"] : ["x", "y", "z", "w"])
    : turnNames(convention).map((name) => name.split(" ")[0]);
  const places = names.map((name) => labels.indexOf(name));
  return places.includes(-1) ? values : places.map((place) => values[place]);
}

/**
 * What a text in the field of a kind says: { kind, value }, or { fault }. So many numbers as another
 * kind has are taken for that one: a matrix pasted into the field of a quaternion is a matrix.
 */
export function understood(text, kind, convention) {
  const found = numbersIn(text);
  const values = rotationIn(found.values);
  const fits = (name) => SIZES[name] === values.length;
  const meant = fits(kind) ? kind : KINDS.find(fits);
  if (meant === undefined)
    return { fault: { words: `Expected ${SIZES[kind]} numbers, found ${values.length}.` } };
  const value = inOrder({ ...found, values }, meant, convention);
  const fault = faultIn(meant, value);
  return fault ? { fault } : { kind: meant, value };
}

/** What of a state from an address is one. */
export function stated(given) {
  const known = {};
  const take = (name, choices) => choices.includes(given[name]) && (known[name] = given[name]);
  for (const side of ["source", "target"]) {
    take(side, Object.keys(SYSTEMS));
    take(`${side}_sequence`, ["", ...SEQUENCES]);
    take(`${side}_unit`, UNITS);
  }
  const value = String(given.value ?? "").split(",").map((text) => (text.trim() === "" ? NaN : Number(text)));
  if (KINDS.includes(given.kind) && value.length === SIZES[given.kind] && faultIn(given.kind, value) === null)
    Object.assign(known, { kind: given.kind, value });
  return known;
}

const axesWords = ({ room, along }) => `${room.join("-")} and ${along.join("-")}`;

/** What two conventions have not in common, a sentence each. */
export function differences(source, target) {
  const way = ({ transposed }) => (transposed ? "from body to navigation" : "from navigation to body");
  const place = ({ scalarFirst }) => (scalarFirst ? "first" : "last");
  const unit = ({ degrees }) => (degrees ? "degrees" : "radians");
  const turns = ({ sequence, signs }) => [sequence, ...[...sequence.toLowerCase()].filter((letter, i) => signs[i] < 0).map((letter) => `${letter} the other way`)].join(", ");
  const leads = ({ conjugated }) => (conjugated ? "conjugate" : "plain");
  const differ = (by, words) => (by(source) === by(target) ? [] : [words]);
  return [
    ...differ(axesWords, `Axes: ${axesWords(source)} become ${axesWords(target)}.`),
    ...differ(way, `The matrix leads ${way(source)} in one, ${way(target)} in the other.`),
    ...differ(leads, "The quaternions of one are the conjugates of the other's."),
    ...differ(place, `The scalar part stands ${place(source)} in one, ${place(target)} in the other.`),
    ...differ(turns, `The angles are ${turns(source)} in one, ${turns(target)} in the other.`),
    ...differ(unit, `Angles in ${unit(source)} become ${unit(target)}.`),
  ];
}

/** How far from the lock, in words. */
export function lockWords({ locked, fromLock }) {
  if (locked) return "At the lock: the first and the third turn go about one line. The last turn is set to 0, the other carries the rest.";
  if (fromLock < 1) return `${Number(fromLock.toPrecision(3))}° from the lock: a small error of the attitude is a large one of the outer angles.`;
  return `${Number(fromLock.toFixed(2))}° from the lock.`;
}
