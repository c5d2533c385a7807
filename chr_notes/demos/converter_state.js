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
import { misprintWords } from "./nearest.js";
import { numberOf } from "./parts.js";
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
  const alone = misprintWords(matrix);
  return determinant < 0
    ? { words: `No rotation but a reflection: ${off}. One axis points the other way, as between a right-handed and a left-handed frame.${alone}` }
    : { words: `No rotation: ${off}.${alone || " With fewer than four digits take the nearest rotation."}`, matrix };
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
 * kind has are taken for that one if all were pasted: a matrix pasted into the field of a quaternion is
 * a matrix. Whoever is typing has only not come to the end.
 */
export function understood(text, kind, convention, pasted = false) {
  const found = numbersIn(text);
  const values = rotationIn(found.values);
  const fits = (name) => SIZES[name] === values.length;
  const meant = fits(kind) || !pasted ? kind : KINDS.find(fits);
  if (meant === undefined || !fits(meant))
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
  const value = String(given.value ?? "").split(",").map(numberOf);
  if (KINDS.includes(given.kind) && value.length === SIZES[given.kind] && faultIn(given.kind, value) === null)
    Object.assign(known, { kind: given.kind, value });
  return known;
}
