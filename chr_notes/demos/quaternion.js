/**
 * Quaternions: one axis and one angle, the four numbers that hold half of it, and the two products
 * by which they turn a vector.
 */
import {
  matrixFromQuaternion,
  quaternionConjugate,
  quaternionFromAxisAngle,
  quaternionMultiply,
} from "../generated/javascript/attitude.mjs";
import { bars, inPart, line, mark, words } from "./chart.js";
import { mountOf } from "./controls.js";
import { scaled } from "./draw.js";
import { directed, direction, flown, globe, looking, namesRound, path, pointer } from "./globe.js";
import { entry, rounded } from "./parts.js";

const DEGREE = Math.PI / 180;
const NOSE = [0, 1, 0, 0]; // the vector that is turned, as a quaternion: it points north
const ONE = [1, 0, 0, 0];

const axisOf = (state) => direction(state.axis_yaw, state.axis_pitch);

/** The quaternion of a share of the turn, its sign kept: four quarters of up to 180° each. */
function partOf(state, share) {
  const quarter = quaternionFromAxisAngle(...axisOf(state), (share * state.angle * DEGREE) / 4);
  const half = quaternionMultiply(...quarter, ...quarter);
  return quaternionMultiply(...half, ...half);
}

/** The quaternion, and how far the two products have come: the left one first, then the right one. */
function stages(state) {
  const left = partOf(state, Math.min(1, state.product));
  const right = partOf(state, Math.max(0, state.product - 1));
  const product = quaternionMultiply(...quaternionMultiply(...left, ...NOSE), ...quaternionConjugate(...right));
  return { q: partOf(state, 1), product };
}

const NAMES = ["v", "q v", "q v q*"];

/** Name of a stage of the product, of one on the way too. */
const stageOf = (product) =>
  Number.isInteger(product) ? NAMES[product] : `${NAMES[Math.floor(product)]} → ${NAMES[Math.ceil(product)]}`;

function readouts(state) {
  const { q, product } = stages(state);
  return {
    half_angle: rounded(state.angle / 2),
    quaternion: q.map(entry).join("\n"),
    product: product.map(entry).join("\n"),
    meaning: `${turnInWords(state, q)} ${productInWords(state, product)}`,
  };
}

function turnInWords({ angle }, [a]) {
  if (angle === 0) return "No turn: q = 1.";
  if (angle === 360) return "After 360° the aircraft is back, but the quaternion is not: q = −1. It takes another whole turn.";
  if (angle === 720) return "After 720° the aircraft is back for the second time, and the quaternion with it: q = 1.";
  const half = `The aircraft has turned by ${rounded(angle)}°, and q holds half of that: a = cos ${rounded(angle / 2)}° = ${rounded(a)}.`;
  return angle < 360 ? half : `${half} At ${rounded(angle - 360)}° its attitude was the same, and all four numbers had the other sign.`;
}

function productInWords({ product: stage, angle }, [scalar]) {
  if (stage === 2) return "q\u00a0v\u00a0q* is a vector again: its first element is 0.";
  if (stage === 0) return "v is a vector: its first element is 0.";
  if (Math.abs(scalar) < 5e-4) return angle % 720 === 0 ? "Nothing has moved." : "Here nothing has leaked into the first element.";
  return stage === 1
    ? `q\u00a0v is no vector: ${rounded(scalar)} has leaked into its first element.`
    : `On the way, ${rounded(scalar)} has leaked into the first element.`;
}

const summary = (state) => readouts(state).meaning;

/** The picture in words. */
function describe(state) {
  const { q, product } = stages(state);
  const list = (numbers) => numbers.map((value) => entry(value).trim()).join(", ");
  return `An aircraft that has turned by ${rounded(state.angle)}° about an axis at yaw ${rounded(state.axis_yaw)}°, pitch ${rounded(state.axis_pitch)}°. Its quaternion is ${list(q)}. ${stageOf(state.product)} is ${list(product)}.`;
}

// ── the picture ─────────────────────────────────────────────────────────────────────────────

const [SPLIT, SHOWN] = [0.64, 2.95]; // of the height, for the sphere; what it shows, in radii

function draw(context, { width, height }, state, colours, viewpoint) {
  const split = SPLIT * height;
  const { q, product } = stages(state);
  inPart(context, [0, 0, width, split], (size) => scene(context, size, state, q, product, colours, viewpoint));
  const third = width / 3;
  const low = (i, drawIt) => inPart(context, [i * third, split, third, height - split], drawIt);
  low(0, (size) => dial(context, size, state, colours));
  const names = [["a", "ink"], ["b", "x"], ["c", "y"], ["d", "z"]];
  low(1, (size) =>
    bars(context, size, "q, and −q ○", names.map(([text, colour], i) => ({ text, colour, value: q[i], twin: -q[i] })), colours),
  );
  const units = [["1", "alert"], ["i", "x"], ["j", "y"], ["k", "z"]];
  low(2, (size) =>
    bars(context, size, stageOf(state.product), units.map(([text, colour], i) => ({ text, colour, value: product[i] })), colours),
  );
}

function scene(context, size, state, q, product, colours, viewpoint) {
  const view = looking(viewpoint, size, SHOWN);
  const axis = axisOf(state);
  const style = { colours, room: size, taken: [] };
  globe(context, view, colours, size, { names: [] });
  const ends = [-1.25, 1.25].map((far) => view.project(scaled(axis, far)));
  line(context, ends, { colour: colours("accent"), width: 2, dash: [7, 4] });
  pointer(context, view, scaled(axis, 1.2), { ...style, name: ["axis"], held: true, colour: "accent" });
  flown(context, view, matrixFromQuaternion(...q), colours, 0.9);
  const count = Math.max(1, Math.ceil(Math.min(state.angle, 360) / 5));
  const nose = Array.from({ length: count + 1 }, (_, i) => {
    const matrix = matrixFromQuaternion(...partOf({ ...state, angle: Math.min(state.angle, 360) }, i / count));
    return matrix.slice(0, 3);
  });
  path(context, view, nose, { colour: colours("x"), width: 3.5 });
  pointer(context, view, nose.at(-1), { ...style, name: ["nose"], colour: "x", width: 1.5 });
  pointer(context, view, product.slice(1), { ...style, name: [stageOf(state.product)], colour: "alert", dash: [6, 2], width: 4 });
  namesRound(context, view, colours, size, style); // last, or an arrow or the path would cover them
}

const handles = (state, { width, height }, viewpoint) => [
  directed(looking(viewpoint, { width, height: SPLIT * height }, SHOWN), scaled(axisOf(state), 1.2), ([axis_yaw, axis_pitch]) => ({ axis_yaw, axis_pitch })),
];

/** The angle as the aircraft turns it, round and round, and half of it as the quaternion holds it. */
function dial(context, { width, height }, { angle }, colours) {
  words(context, "angle, half", [12, 12], { colour: colours("muted"), weight: 600 });
  const [middle, radius] = [[width / 2, 24 + (height - 32) / 2], Math.min(width / 2 - 12, (height - 36) / 2)];
  const at = (degrees, far) => [
    middle[0] + far * radius * Math.cos(degrees * DEGREE), middle[1] - far * radius * Math.sin(degrees * DEGREE),
  ];
  const spiral = (to, from, until) => Array.from({ length: 91 }, (_, i) => at((to * i) / 90, from + ((until - from) * i) / 90));
  line(context, spiral(360, 1, 1), { colour: colours("line"), width: 1.5 });
  line(context, [at(180, 1), at(0, 1)], { colour: colours("line"), width: 1 });
  line(context, spiral(angle, 0.6, 0.6 + angle / 2400), { colour: colours("x"), width: 2 });
  line(context, [middle, at(angle, 1)], { colour: colours("x"), width: 2 });
  mark(context, "circle", at(angle, 1), { colour: colours("x"), rim: colours("page"), radius: 5 });
  line(context, [middle, at(angle / 2, 1)], { colour: colours("ink"), width: 3 });
  mark(context, "square", at(angle / 2, 1), { colour: colours("ink"), rim: colours("page"), radius: 5 });
  const foot = [at(angle / 2, 1)[0], middle[1]];
  line(context, [foot, at(angle / 2, 1)], { colour: colours("muted"), width: 1, dash: [2, 2] });
  line(context, [middle, foot], { colour: colours("ink"), width: 5 });
  const aside = Math.sin((angle / 2) * DEGREE) < 0 ? -12 : 12; // where half the angle is not
  words(context, "a", [(middle[0] + foot[0]) / 2, middle[1] + aside], { colour: colours("ink"), size: 13, align: "center", weight: 600 });
}

const DEGREES = { short: "°", long: "degrees" };
const start = { axis_yaw: 40, axis_pitch: 35, angle: 100, product: 1 };

const definition = {
  title: "Axis, angle, quaternion",
  python: "QuaternionDemo",
  hint: "Take the axis by its point and turn it. Raise the angle to 360°. The aircraft is back: is the quaternion? Then take the products one after the other.",
  aspect: 1.08,
  viewpoint: () => ({ heading: 20, elevation: -25 }),
  start,
  legend: [
    { colour: "x", text: "the angle ●, and the path of the nose" },
    { colour: "ink", width: 3, text: "half the angle ■, as q holds it" },
    { colour: "alert", dash: [6, 2], width: 4, text: "the vector part of the product" },
  ],
  controls: [
    { name: "axis_yaw", label: "Axis, yaw", symbol: [], min: -180, max: 180, step: 1, unit: DEGREES },
    { name: "axis_pitch", label: "Axis, pitch", symbol: [], min: -90, max: 90, step: 1, unit: DEGREES },
    { name: "angle", label: "Angle", symbol: [], axis: "x", min: 0, max: 720, step: 5, unit: DEGREES, stops: [0, 180, 360, 540, 720].map((angle) => [angle, `${angle}°`]) },
    {
      name: "product", label: "Product", symbol: [], min: 0, max: 2, step: 0.05, stops: NAMES.map((name, i) => [i, name]),
      words: (product) => ({ short: stageOf(product), long: stageOf(product).replace("*", " conjugate") }),
    },
  ],
  outputs: [
    { name: "meaning", label: "What it means", wide: true, longestAt: [{ ...start, angle: 535, product: 1 }, { ...start, angle: 535, product: 1.5 }] },
    { name: "half_angle", label: "Half the angle", unit: DEGREES },
    { name: "quaternion", label: "q", grid: true, rows: [..."abcd"] },
    { name: "product", label: "The product", grid: true, rows: [..."1ijk"] },
  ],
  story: [
    { state: { ...start, angle: 0, product: 0 }, says: "An aircraft, its nose to the north, and an axis. No turn yet: the quaternion is 1." },
    { state: { ...start, angle: 100, product: 0 }, seconds: 3, says: "A turn by 100°. The hand of the quaternion has gone half as far." },
    { state: { ...start, angle: 100, product: 1 }, seconds: 3, says: "One product, q v: the vector has left its three dimensions. A part is in the first element." },
    { state: { ...start, angle: 100, product: 2 }, seconds: 3, says: "The second product brings it back, and turns by the other half: the vector points along the nose." },
    { state: { ...start, angle: 360, product: 2 }, seconds: 4, says: "A whole turn. The aircraft is back, and the quaternion is −1." },
    { state: { ...start, angle: 720, product: 2 }, seconds: 5, says: "Only after two whole turns is the quaternion back." },
  ],
  readouts,
  summary,
  describe,
  draw,
  handles,
};

export const mount = mountOf(definition);
