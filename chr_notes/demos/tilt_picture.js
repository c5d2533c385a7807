/** The picture of the tilt demo: two views of the aircraft, and the errors of a second of readings. */
import { accelerometerAtRest, matrixFromEuler } from "../generated/javascript/attitude.mjs";
import { arrow, beside, inPart, line, linear, mark, words } from "./chart.js";
import { camera, label, scaled, sum, toChild, toParent } from "./draw.js";
import { flown } from "./globe.js";
import { attitude, estimates, reading, readings, unaccelerated } from "./tilt_estimates.js";

/* global STANDARD_GRAVITY, DASHES: build.py puts them in, m/s² and { axis: pattern } */

const PER_GRAVITY = 0.58; // length of an arrow of 1 g
const SIZE = 1.25; // length of the aircraft
const PLUMB = 1.0; // length of the plumb lines
const DISTANCE = 60; // of the viewer: so far that angles look as they are
const WEST = -Math.PI / 2;

// Where the viewer looks: north from behind, west from the right-hand side; the two ends of the aircraft
// by one of which it is held there, and the body axis along which the plumb line is pushed.
const VIEWS = [
  { title: "from behind", view: matrixFromEuler(0, 0, 0), ends: [[-0.04, 0.53, -0.01], [-0.04, -0.53, -0.01]], push: [0, 1, 0] },
  { title: "from the right", view: matrixFromEuler(0, 0, WEST), ends: [[0.54, 0, 0.02], [-0.5, 0, 0]], push: [1, 0, 0] },
];
const VIEWED = 0.66; // of the height
const lookAt = (view, size) => camera(view, DISTANCE, size, { wide: 2.2, high: 2.85, shift: 0.12 });
const along = (vector, length) => scaled(vector, length / Math.hypot(...vector));
const matrixOf = (state) => matrixFromEuler(...attitude(state), 0);
const STRIPS = [
  { title: "roll error over 1 s", axis: "x", shape: "circle" },
  { title: "pitch error over 1 s", axis: "y", shape: "square" },
];
const DASH = { ...DASHES, real: [9, 5] };

/** The lines of the picture, each with what it stands for; `symbol` stands beside the arrow too. */
export const LEGEND = [
  { symbol: ["f"], colour: "ink", width: 3.5, text: "what the accelerometer feels" },
  { symbol: ["−g"], colour: "z", dash: DASH.z, width: 3, text: "held up against gravity" },
  { symbol: ["a", "x"], colour: "x", width: 3, text: "forward acceleration" },
  { symbol: ["a", "y"], colour: "y", dash: DASH.y, width: 3, text: "lateral acceleration" },
  { colour: "ink", dash: DASH.real, width: 2, text: "the real vertical" },
  { colour: "alert", width: 7, text: "the vertical it believes in" },
  { colour: "alert", dash: [3, 5], width: 4, text: "that of single readings, where it is shaken" },
];

export function draw(context, { width, height }, state, colours) {
  const [half, views] = [width / 2, VIEWED * height];
  const found = estimates(state);
  [0, 1].forEach((i) => {
    inPart(context, [i * half, 0, half, views], (size) =>
      scene(context, size, state, VIEWS[i], found, colours),
    );
    inPart(context, [i * half, views, half, height - views], (size) =>
      strip(context, size, found, i, colours),
    );
  });
  line(context, [[half, 10], [half, height - 10]], { colour: colours("line"), width: 1 });
}

function scene(context, size, state, { title, view }, { unknown }, colours) {
  const attitudeMatrix = matrixOf(state);
  const look = lookAt(view, size);
  const at = (point) => look.project(point);
  const toInertial = (vector) => toParent(attitudeMatrix, vector);

  const taken = [];
  label(context, [title], [size.width / 2, 14], { colour: colours("muted"), rim: colours("page"), size: 12, width: size.width, taken });
  const centre = at([0, 0, 0]);
  const level = [[8, centre[1]], [size.width - 8, centre[1]]];
  line(context, level, { colour: colours("shade"), width: 1 });
  if (view === VIEWS[0].view) words(context, "horizon", [8, centre[1] - 9], { colour: colours("muted"), size: 12 });

  flown(context, look, attitudeMatrix, colours, SIZE);

  // Verticals: the real one, and those that the readings give.
  const believed = (sensed) => at(along(toInertial(sensed), -PLUMB));
  if (state.vibration > 0)
    readings(state).forEach((sensed) =>
      mark(context, "circle", believed(sensed), { colour: `${colours("alert")}66`, radius: 2 }),
    );
  if (!unknown[1]) {
    const bob = believed(reading(state));
    line(context, [centre, bob], { colour: colours("alert"), width: 7 });
    mark(context, "circle", bob, { colour: colours("alert"), rim: colours("page"), radius: 7 });
  }
  line(context, [centre, at([0, 0, PLUMB * 1.2])], { colour: colours("ink"), width: 2, dash: DASH.real });
  arrows(context, state, { at, toInertial, colours, width: size.width, taken });
}

const LEGIBLE = 12; // pixels: a shorter arrow gets no letter

/** The specific force and its parts, head to tail, each with its letter on the outer side. */
function arrows(context, state, { at, toInertial, colours, width, taken }) {
  const [force, gravity, forward, lateral] = LEGEND;
  const parts = [
    { ...gravity, vector: accelerometerAtRest(...attitude(state), STANDARD_GRAVITY) },
    { ...forward, vector: [state.forward_acceleration, 0, 0] },
    { ...lateral, vector: [0, state.lateral_acceleration, 0] },
  ];
  const steps = parts.map(({ vector }) => scaled(toInertial(vector), PER_GRAVITY / STANDARD_GRAVITY));
  const total = steps.reduce(sum);
  const [centre, tip] = [at([0, 0, 0]), at(total)];
  const middle = at(scaled(total, 0.5));
  const letter = (symbol, point, colour) =>
    label(context, symbol, point, { colour: colours(colour), rim: colours("page"), width, size: 13, taken });

  const shafts = steps.map((_, i) => [0, 1].map((end) => at([[0, 0, 0], ...steps.slice(0, i + end)].reduce(sum))));
  shafts.forEach(([from, to], i) =>
    arrow(context, from, to, { colour: colours(parts[i].colour), width: 3, dash: parts[i].dash }),
  );
  // Where both are one line, they are drawn side by side, so that both are seen.
  const still = unaccelerated(state);
  const aside = ([x, y]) => [x - (Math.abs(tip[0] - centre[0]) < 6 ? 7 : 0), y];
  arrow(context, aside(centre), aside(tip), { colour: colours(force.colour), width: 3.5 });
  shafts.forEach(([from, to], i) => {
    if (Math.hypot(to[0] - from[0], to[1] - from[1]) > LEGIBLE)
      letter(parts[i].symbol, beside(from, to, aside(middle), 13), parts[i].colour);
  });
  const length = Math.hypot(tip[0] - centre[0], tip[1] - centre[1]) || 1;
  const beyond = tip.map((value, i) => value + (14 * (value - centre[i])) / length);
  letter(still ? ["f = −g"] : force.symbol, beyond, force.colour);
}

const ROOM = 44; // pixels between what is held, for a finger

/** The bob of each plumb line, which the acceleration pushes aside, and the right wing tip and the nose, or the other ends. */
export function handles(state, { width, height }) {
  const size = { width: width / 2, height: VIEWED * height };
  const matrix = matrixOf(state);
  const unknown = estimates(state).unknown[1];
  return VIEWS.flatMap(({ view, ends, push }, i) => {
    const at = (point) => sum(lookAt(view, size).project(point), [i * size.width, 0]);
    const centre = at([0, 0, 0]);
    const hold = (part) => () => ([x, y]) => part(x - centre[0], y - centre[1]);
    const bob = { at: at(along(toParent(matrix, reading(state)), -PLUMB)), hold: hold((...to) => pushedTo(state, matrix, view, push, to)) };
    const [first, other] = ends.map((end) => at(toParent(matrix, scaled(end, SIZE))));
    const far = ([x, y]) => Math.hypot(x - bob.at[0], y - bob.at[1]);
    const sign = !unknown && far(first) < ROOM && far(first) < far(other) ? -1 : 1;
    const part = { at: sign > 0 ? first : other, hold: hold((...to) => [rolledTo, pitchedTo][i](state, scaled(to, sign))) };
    return unknown ? [part] : [bob, part];
  });
}

/** The acceleration along `push` that swings the plumb line to a place right of and below its upper end. */
function pushedTo(state, matrix, view, push, [right, down]) {
  const seen = (acceleration) => toChild(view, toParent(matrix, acceleration)).slice(1);
  const [u, v] = seen(push);
  const [name, other] = push[0] ? ["forward_acceleration", [0, state.lateral_acceleration, 0]] : ["lateral_acceleration", [state.forward_acceleration, 0, 0]];
  const [x, y] = seen(other);
  const value = ((STANDARD_GRAVITY - y) * right + x * down) / (v * right - u * down);
  const towards = (-x - value * u) * right + (STANDARD_GRAVITY - y - value * v) * down;
  return towards > 0 ? { [name]: Math.min(10, Math.max(-10, Math.round(10 * value) / 10)) + 0 } : {};
}

const whole = (radians) => Math.round((radians * 180) / Math.PI) + 0;
const rolledTo = (state, [right, down]) => {
  const short = Math.cos(attitude(state)[1]); // from behind, the wings of a raised nose look flatter
  return short > 0.05 ? { roll: whole(Math.atan2(down / short, right)) } : {};
};
const pitchedTo = (_, [right, down]) => ({ pitch: whole(Math.atan2(-down, Math.max(0, right))) });

const LIMITS = [2, 5, 10, 20, 45, 90, 180]; // degrees

/** The errors of the readings of a second, and their average. */
function strip(context, { width, height }, { error, scatter, single, unknown }, which, colours) {
  const { title, axis, shape } = STRIPS[which];
  const values = single.map((each) => each[which]);
  const largest = Math.max(...[error, ...single].flat().map(Math.abs)); // of both: one scale
  const limit = LIMITS.find((each) => each >= largest * 1.05) ?? 180;
  const [left, right, top, bottom] = [52, width - 12, 26, height - 22];
  const [x, y] = [linear(0, 1, left, right), linear(-limit, limit, bottom, top)];
  const small = { colour: colours("muted"), size: 12 };

  words(context, title, [8, 10], { ...small, weight: 600 });
  for (const tick of [-limit, 0, limit]) {
    line(context, [[left, y(tick)], [right, y(tick)]], { colour: colours("line"), width: 1 });
    words(context, `${tick}°`.replace("-", "−"), [left - 5, y(tick)], { ...small, align: "right" });
  }
  const zero = () => line(context, [[left, y(0)], [right, y(0)]], { colour: colours("ink"), width: 1.5, dash: DASH.real });
  if (scatter[which] > 0) values.forEach((value, i) =>
    mark(context, shape, [x((i + 0.5) / values.length), y(value)], { colour: `${colours(axis)}80`, radius: 2 }),
  );
  words(context, "0 s", [left, bottom + 12], small);
  words(context, "1 s", [right, bottom + 12], { ...small, align: "right" });
  if (unknown[which]) {
    const style = { colour: colours("alert"), rim: colours("page"), width, size: 13 };
    label(context, ["undefined"], [(left + right) / 2, y(limit / 2)], style);
    zero();
    return;
  }
  const average = [[left, y(error[which])], [right, y(error[which])]];
  line(context, average, { colour: colours("page"), width: 8 });
  line(context, average, { colour: colours("alert"), width: 5 });
  zero();
  mark(context, "circle", average[1], { colour: colours("alert"), rim: colours("page"), radius: 5 });
}
