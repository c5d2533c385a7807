/** The picture of the tilt demo: two views of the aircraft, and the errors of a second of readings. */
import { accelerometerAtRest, matrixFromEuler } from "../generated/javascript/attitude.mjs";
import { aircraft } from "./aircraft.js";
import { arrow, beside, inPart, line, linear, mark, words } from "./chart.js";
import { camera, label, paint, parsed, placed, scaled, sum, toParent } from "./draw.js";
import { attitude, estimates, reading, readings, unaccelerated } from "./tilt_estimates.js";

/* global STANDARD_GRAVITY, DASHES: build.py puts them in, m/s² and { axis: pattern } */

const PER_GRAVITY = 0.6; // length of an arrow of 1 g
const SIZE = 1.25; // length of the aircraft
const PLUMB = 1.0; // length of the plumb lines
const DISTANCE = 60; // of the viewer: so far that angles look as they are
const WEST = -Math.PI / 2;

// Where the viewer looks: north from behind, west from the right-hand side.
const VIEWS = [
  { title: "from behind", view: matrixFromEuler(0, 0, 0) },
  { title: "from the right", view: matrixFromEuler(0, 0, WEST) },
];
const STRIPS = [
  { title: "roll error over 1 s", axis: "x", shape: "circle" },
  { title: "pitch error over 1 s", axis: "y", shape: "square" },
];
const DASH = { ...DASHES, real: [9, 5], believed: [2, 4] };

/** The lines of the picture, each with what it stands for; `symbol` stands beside the arrow too. */
export const LEGEND = [
  { symbol: ["f"], colour: "ink", width: 3.5, text: "what the accelerometer feels" },
  { symbol: ["−g"], colour: "z", dash: DASH.z, width: 3, text: "held up against gravity" },
  { symbol: ["a", "x"], colour: "x", width: 3, text: "forward acceleration" },
  { symbol: ["a", "y"], colour: "y", dash: DASH.y, width: 3, text: "lateral acceleration" },
  { colour: "ink", dash: DASH.real, width: 2, text: "the real vertical" },
  { colour: "alert", dash: DASH.believed, width: 3, text: "the vertical it believes in" },
];

export function draw(context, { width, height }, state, colours) {
  const [half, views] = [width / 2, 0.66 * height];
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
  const attitudeMatrix = matrixFromEuler(...attitude(state), 0);
  const look = camera(view, DISTANCE, size, { wide: 2.2, high: 2.85, shift: 0.12 });
  const at = (point) => look.project(point);
  const toInertial = (vector) => toParent(attitudeMatrix, vector);
  const along = (vector, length) => scaled(vector, length / Math.hypot(...vector));

  words(context, title, [size.width / 2, 14], { colour: colours("muted"), align: "center", weight: 600 });
  const centre = at([0, 0, 0]);
  const level = [[8, centre[1]], [size.width - 8, centre[1]]];
  line(context, level, { colour: colours("line"), width: 1 });

  const names = ["body", "glass", "x", "y", "z"];
  const fills = Object.fromEntries(names.map((name) => [name, parsed(colours(name))]));
  paint(context, placed(aircraft(fills), scaled(attitudeMatrix, SIZE)), look);

  // Verticals: the real one, and those that the readings give.
  const believed = (sensed) => at(along(toInertial(sensed), -PLUMB));
  if (state.vibration > 0)
    readings(state).forEach((sensed) =>
      mark(context, "circle", believed(sensed), { colour: `${colours("alert")}66`, radius: 2 }),
    );
  line(context, [centre, at([0, 0, PLUMB * 1.12])], { colour: colours("ink"), width: 2, dash: DASH.real });
  if (!unknown[1]) {
    const bob = believed(reading(state));
    line(context, [centre, bob], { colour: colours("alert"), width: 3, dash: DASH.believed });
    mark(context, "circle", bob, { colour: colours("alert"), rim: colours("page"), radius: 7 });
  }
  arrows(context, state, { at, toInertial, colours, width: size.width });
}

const LEGIBLE = 12; // pixels: a shorter arrow gets no letter

/** The specific force and its parts, head to tail, each with its letter on the outer side. */
function arrows(context, state, { at, toInertial, colours, width }) {
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
    label(context, symbol, point, { colour: colours(colour), rim: colours("page"), width, size: 13 });

  const shafts = steps.map((_, i) => [0, 1].map((end) => at([[0, 0, 0], ...steps.slice(0, i + end)].reduce(sum))));
  shafts.forEach(([from, to], i) =>
    arrow(context, from, to, { colour: colours(parts[i].colour), width: 3, dash: parts[i].dash }),
  );
  const still = unaccelerated(state);
  if (!still) arrow(context, centre, tip, { colour: colours(force.colour), width: 3.5 });
  shafts.forEach(([from, to], i) => {
    if (Math.hypot(to[0] - from[0], to[1] - from[1]) > LEGIBLE)
      letter(parts[i].symbol, beside(from, to, middle, 13), parts[i].colour);
  });
  const length = Math.hypot(tip[0] - centre[0], tip[1] - centre[1]) || 1;
  const beyond = tip.map((value, i) => value + (14 * (value - centre[i])) / length);
  letter(still ? ["f = −g"] : force.symbol, beyond, force.colour);
}

const LIMITS = [2, 5, 10, 20, 45, 90, 180]; // degrees

/** The errors of the readings of a second, and their average. */
function strip(context, { width, height }, { error, scatter, single, unknown }, which, colours) {
  const { title, axis, shape } = STRIPS[which];
  const values = single.map((each) => each[which]);
  const largest = Math.max(Math.abs(error[which]), ...values.map(Math.abs));
  const limit = LIMITS.find((each) => each >= largest * 1.05) ?? 180;
  const [left, right, top, bottom] = [46, width - 12, 26, height - 22];
  const [x, y] = [linear(0, 1, left, right), linear(-limit, limit, bottom, top)];
  const small = { colour: colours("muted"), size: 12 };

  words(context, title, [8, 10], { ...small, weight: 600 });
  for (const tick of [-limit, 0, limit]) {
    line(context, [[left, y(tick)], [right, y(tick)]], { colour: colours("line"), width: 1 });
    words(context, `${tick}°`.replace("-", "−"), [left - 5, y(tick)], { ...small, align: "right" });
  }
  line(context, [[left, y(0)], [right, y(0)]], { colour: colours("ink"), width: 1.5, dash: DASH.real });
  if (scatter[which] > 0) values.forEach((value, i) =>
    mark(context, shape, [x((i + 0.5) / values.length), y(value)], { colour: `${colours(axis)}80`, radius: 2 }),
  );
  words(context, "0 s", [left, bottom + 12], small);
  words(context, "1 s", [right, bottom + 12], { ...small, align: "right" });
  if (unknown[which]) {
    const style = { colour: colours("alert"), rim: colours("page"), width, size: 13 };
    label(context, ["undefined"], [(left + right) / 2, y(limit / 2)], style);
    return;
  }
  const average = [[left, y(error[which])], [right, y(error[which])]];
  line(context, average, { colour: colours("page"), width: 6 });
  line(context, average, { colour: colours("alert"), width: 3, dash: DASH.believed });
  mark(context, "circle", average[1], { colour: colours("alert"), rim: colours("page"), radius: 5 });
}
