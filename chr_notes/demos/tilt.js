/**
 * Tilt from an accelerometer: it feels what holds it up against gravity, and the acceleration of
 * the body with it. Where the two differ it believes in a vertical that is not there.
 */
import {
  accelerometerAtRest,
  accelerometerFromAcceleration,
  matrixFromEuler,
  tiltFromAccelerometer,
  wrapAngle,
} from "../generated/javascript/attitude.mjs";
import { aircraft } from "./aircraft.js";
import { arrow, line, linear, mark, words } from "./chart.js";
import { mountDemo } from "./controls.js";
import { camera, label, paint, parsed, placed, scaled, sum, toParent } from "./draw.js";
import { rounded } from "./parts.js";
import shakes from "./vibration.json"; // readings of a vibration of 1 m/s² RMS on each axis
import { widget } from "./widget.js";

/* global STANDARD_GRAVITY: build.py puts it in, m/s² */

const DEGREE = Math.PI / 180;
const RIGHT = 0.005; // degrees, less than what is shown

const attitude = ({ roll, pitch }) => [roll * DEGREE, pitch * DEGREE];

/** The reading without vibration, in the body frame, m/s². */
function reading(state) {
  const angles = [...attitude(state), 0];
  const acceleration = [state.forward_acceleration, state.lateral_acceleration, 0];
  return accelerometerFromAcceleration(
    ...toParent(matrixFromEuler(...angles), acceleration), ...angles, STANDARD_GRAVITY,
  );
}

/** Each of the readings of one second with the vibration in them. */
const readings = (state) => {
  const still = reading(state);
  return shakes.map((shake) => sum(still, scaled(shake, state.vibration)));
};

const rms = (values) => Math.hypot(...values) / Math.sqrt(values.length);

/** Errors in degrees, [roll, pitch], of the angles that a reading gives. */
const errors = (state, sensed) => {
  const truth = attitude(state);
  return tiltFromAccelerometer(...sensed).map((angle, i) => wrapAngle(angle - truth[i]) / DEGREE);
};

/** What the accelerometer makes of it all, in degrees; each a pair [roll, pitch]. */
function estimates(state) {
  const average = reading(state);
  const error = errors(state, average);
  const single = readings(state).map((sensed) => errors(state, sensed));
  const scatter = error.map((mean, i) =>
    rms(single.map((each) => wrapAngle((each[i] - mean) * DEGREE) / DEGREE)),
  );
  const estimate = tiltFromAccelerometer(...average).map((angle) => angle / DEGREE);
  return { estimate, error, single, scatter };
}

function readouts(state) {
  const { estimate, error, scatter } = estimates(state);
  return {
    roll_estimate: rounded(estimate[0]),
    pitch_estimate: rounded(estimate[1]),
    roll_error: rounded(error[0]),
    pitch_error: rounded(error[1]),
    roll_scatter: rounded(scatter[0]),
    pitch_scatter: rounded(scatter[1]),
    meaning: meaning(state, error, scatter),
  };
}

function meaning(state, error, scatter) {
  const still = state.forward_acceleration === 0 && state.lateral_acceleration === 0;
  const wrong = ["roll", "pitch"].filter((_, i) => Math.abs(error[i]) > RIGHT);
  const shaken = state.vibration > 0 && scatter.some((each) => each > RIGHT);
  const sentences = [];
  if (still && Math.abs(state.pitch) >= 90)
    return "Gravity lies along the roll axis: roll about it changes nothing that the accelerometer feels, so its roll means nothing.";
  if (still) sentences.push("The body does not accelerate, so the two verticals agree and both angles are right.");
  else if (wrong.length > 0) sentences.push(`The sensor cannot tell acceleration from tilt. Its ${wrong.join(" and its ")} will be wrong for as long as the acceleration lasts.`);
  else sentences.push("The acceleration happens to leave both angles as they are.");
  if (shaken) sentences.push("Single readings scatter; their average does not.");
  return sentences.join(" ");
}

function summary(state) {
  const texts = readouts(state);
  const angle = (name) =>
    `${name} ${texts[`${name}_estimate`]} degrees, error ${texts[`${name}_error`]}, scatter ${texts[`${name}_scatter`]}`;
  return `Estimated ${angle("roll")}; ${angle("pitch")}. ${texts.meaning}`;
}

// ── the picture ─────────────────────────────────────────────────────────────────────────────

const PER_GRAVITY = 0.6; // length of an arrow of 1 g
const SIZE = 1.25; // length of the aircraft
const PLUMB = 1.0; // length of the plumb lines
const DISTANCE = 60; // of the viewer: so far that angles look as they are

// Where the viewer looks: north from behind, west from the right-hand side.
const VIEWS = [
  { title: "from behind", axis: "y", view: matrixFromEuler(0, 0, 0) },
  { title: "from the right", axis: "x", view: matrixFromEuler(0, 0, -90 * DEGREE) },
];
const STRIPS = [
  { title: "roll error", axis: "x", shape: "circle" },
  { title: "pitch error", axis: "y", shape: "square" },
];
const DASH = { x: [], y: [7, 3], z: [2, 2], real: [9, 5], believed: [2, 4] };

function draw(context, { width, height }, state, colours) {
  const [half, views] = [width / 2, 0.64 * height];
  const found = estimates(state);
  [0, 1].forEach((i) => {
    inPart(context, [i * half, 0, half, views], (size) => scene(context, size, state, VIEWS[i], colours));
    inPart(context, [i * half, views, half, height - views], (size) =>
      strip(context, size, found, i, colours),
    );
  });
  line(context, [[half, 10], [half, height - 10]], { colour: colours("line"), width: 1 });
}

/** Draw in a part of the picture, as if it were all of it. */
function inPart(context, [x, y, width, height], drawIt) {
  context.save();
  context.translate(x, y);
  context.beginPath();
  context.rect(0, 0, width, height);
  context.clip();
  drawIt({ width, height });
  context.restore();
}

function scene(context, size, state, { title, view }, colours) {
  const attitudeMatrix = matrixFromEuler(...attitude(state), 0);
  const look = camera(view, DISTANCE, size, { wide: 2.2, high: 2.85, shift: 0.12 });
  const at = (point) => look.project(point);
  const toInertial = (vector) => toParent(attitudeMatrix, vector);
  const colour = (name) => colours(name);
  const along = (vector, length) => scaled(vector, length / Math.hypot(...vector));

  words(context, title, [size.width / 2, 14], { colour: colour("muted"), align: "center", weight: 600 });
  const [left, right] = [8, size.width - 8];
  const [, level] = at([0, 0, 0]);
  line(context, [[left, level], [right, level]], { colour: colour("line"), width: 1 });

  const names = ["body", "glass", "x", "y", "z"];
  const fills = Object.fromEntries(names.map((name) => [name, parsed(colour(name))]));
  paint(context, placed(aircraft(fills), scaled(attitudeMatrix, SIZE)), look);

  // Verticals: the real one, and those that the readings give.
  const believed = (sensed) => at(along(toInertial(sensed), -PLUMB));
  const centre = at([0, 0, 0]);
  if (state.vibration > 0)
    readings(state).forEach((sensed) =>
      mark(context, "circle", believed(sensed), { colour: `${colour("alert")}66`, radius: 2 }),
    );
  const real = at([0, 0, PLUMB * 1.12]);
  line(context, [centre, real], { colour: colour("ink"), width: 2, dash: DASH.real });
  const bob = believed(reading(state));
  line(context, [centre, bob], { colour: colour("alert"), width: 3, dash: DASH.believed });
  mark(context, "circle", bob, { colour: colour("alert"), rim: colour("surface"), radius: 7 });

  arrows(context, state, { at, toInertial, colours, width: size.width });
}

/** The specific force and its parts, head to tail. */
function arrows(context, state, { at, toInertial, colours, width }) {
  const parts = [
    { name: "−g", axis: "z", vector: accelerometerAtRest(...attitude(state), STANDARD_GRAVITY) },
    { name: "a", axis: "x", vector: [state.forward_acceleration, 0, 0] },
    { name: "a", axis: "y", vector: [0, state.lateral_acceleration, 0] },
  ];
  const drawn = (vector) => scaled(toInertial(vector), PER_GRAVITY / STANDARD_GRAVITY);
  const say = (text, point, name, offset) =>
    label(context, text, at(point), { colour: colours(name), rim: colours("surface"), offset, width, size: 13 });
  let tail = [0, 0, 0];
  for (const { name, axis, vector } of parts) {
    const tip = sum(tail, drawn(vector));
    const [from, to] = [at(tail), at(tip)];
    arrow(context, from, to, { colour: colours(axis), width: 3, dash: DASH[axis] });
    if (Math.hypot(to[0] - from[0], to[1] - from[1]) > 12)
      say(name, scaled(sum(tail, tip), 0.5), axis, axis === "z" ? [-9, 0] : [0, -12]);
    tail = tip;
  }
  const still = state.forward_acceleration === 0 && state.lateral_acceleration === 0;
  if (!still) arrow(context, at([0, 0, 0]), at(tail), { colour: colours("ink"), width: 3.5 });
  say(still ? "f = −g" : "f", tail, "ink", [10, 0]);
}

const LIMITS = [2, 5, 10, 20, 45, 90, 180]; // degrees

/** The errors of the readings of a second, and their average. */
function strip(context, { width, height }, { error, single }, which, colours) {
  const { title, axis, shape } = STRIPS[which];
  const values = single.map((each) => each[which]);
  const largest = Math.max(Math.abs(error[which]), ...values.map(Math.abs));
  const limit = LIMITS.find((each) => each >= largest * 1.05) ?? 180;
  const [left, right, top, bottom] = [40, width - 12, 26, height - 22];
  const [x, y] = [linear(0, 1, left, right), linear(-limit, limit, bottom, top)];
  const small = { colour: colours("muted"), size: 11 };

  words(context, `${title} over 1 s`, [left, 10], { ...small, weight: 600 });
  for (const tick of [-limit, 0, limit]) {
    line(context, [[left, y(tick)], [right, y(tick)]], { colour: colours("line"), width: 1 });
    words(context, `${tick}°`.replace("-", "−"), [left - 5, y(tick)], { ...small, align: "right" });
  }
  line(context, [[left, y(0)], [right, y(0)]], { colour: colours("ink"), width: 1.5, dash: DASH.real });
  values.forEach((value, i) =>
    mark(context, shape, [x((i + 0.5) / values.length), y(value)], { colour: `${colours(axis)}80`, radius: 2 }),
  );
  const average = [[left, y(error[which])], [right, y(error[which])]];
  line(context, average, { colour: colours("surface"), width: 6 });
  line(context, average, { colour: colours("alert"), width: 3, dash: DASH.believed });
  mark(context, "circle", average[1], { colour: colours("alert"), rim: colours("surface"), radius: 5 });
  words(context, "0 s", [left, bottom + 12], small);
  words(context, "1 s", [right, bottom + 12], { ...small, align: "right" });
}

const DEGREES = { short: "°", long: "degrees" };
const METRES = { short: " m/s²", long: "metres per second squared" };

const definition = {
  title: "An aircraft from behind and from the right, with the real vertical and the one that its accelerometer believes in",
  aspect: 1.12,
  start: { roll: 0, pitch: 0, forward_acceleration: 0, lateral_acceleration: 0, vibration: 0 },
  legend: [
    { colour: "ink", width: 3.5, text: "f, what the accelerometer feels" },
    { colour: "z", dash: DASH.z, width: 3, text: "−g, held up against gravity" },
    { colour: "x", width: 3, text: "a, forward acceleration" },
    { colour: "y", dash: DASH.y, width: 3, text: "a, lateral acceleration" },
    { colour: "ink", dash: DASH.real, width: 2, text: "the real vertical" },
    { colour: "alert", dash: DASH.believed, width: 3, text: "the vertical it believes in" },
  ],
  controls: [
    { name: "roll", label: "Roll", symbol: "φ", axis: "x", min: -180, max: 180, step: 1, unit: DEGREES },
    { name: "pitch", label: "Pitch", symbol: "θ", axis: "y", min: -90, max: 90, step: 1, unit: DEGREES },
    { name: "forward_acceleration", label: "Forward acceleration", symbol: "", axis: "x", min: -10, max: 10, step: 0.1, unit: METRES },
    { name: "lateral_acceleration", label: "Lateral acceleration", symbol: "", axis: "y", min: -10, max: 10, step: 0.1, unit: METRES },
    { name: "vibration", label: "Vibration, RMS", symbol: "", min: 0, max: 5, step: 0.1, unit: METRES },
  ],
  outputs: [
    { name: "roll_estimate", label: "Roll estimate", unit: "°" },
    { name: "pitch_estimate", label: "Pitch estimate", unit: "°" },
    { name: "roll_error", label: "Roll error", unit: "°" },
    { name: "pitch_error", label: "Pitch error", unit: "°" },
    { name: "roll_scatter", label: "Roll scatter", unit: "°" },
    { name: "pitch_scatter", label: "Pitch scatter", unit: "°" },
    { name: "meaning", label: "What it means", wide: true },
  ],
  readouts,
  summary,
  draw,
};

const still = definition.start;
definition.story = [
  { state: still, says: "At rest and level, the accelerometer feels one thing: what holds it up against gravity. The vertical that it believes in is the real one." },
  { state: { ...still, roll: 25, pitch: 15 }, says: "Tilted, and still at rest: both angles are right." },
  { state: { ...still, forward_acceleration: 4 }, says: "Level again, and gaining speed. An aircraft at rest with its nose up would give the same reading, so that is what the sensor believes." },
  { state: { ...still, roll: 30, lateral_acceleration: 4.9 }, says: "Banked in a turn. The reading has no sideways part left, and the sensor takes 30° of roll for none." },
  { state: { ...still, vibration: 3 }, says: "At rest, but shaken. Single readings scatter on both sides, and their average is right." },
  { state: { ...still, forward_acceleration: 4, vibration: 3 }, says: "Shaken and gaining speed. An average gets rid of the shaking and keeps the error of the acceleration." },
];

export const mount = (element, state, onChange) => mountDemo(element, definition, state, onChange);
mount.start = definition.start;

export default widget(mount);
