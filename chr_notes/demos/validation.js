/**
 * The factor E: which errors of the attitude it sees, to which it is blind, and what a threshold
 * costs.
 */
import { inPart, line, linear, mark, words } from "./chart.js";
import { mountOf } from "./controls.js";
import { label, mixed, paint, parsed, scaled } from "./draw.js";
import { directed, direction, globe, looking, pointer } from "./globe.js";
import { keeping } from "./keeping.js";
import { rounded } from "./parts.js";
import { axisOf, belowOf, factor, factorAbout, fieldOf, samples, tiltError } from "./validation_factor.js";

const three = (value) => String(Number(value.toFixed(3)));

const start = { heading: 0, axis_yaw: 0, axis_pitch: 0, error: 10, threshold: 0.05, iron: 0, inclination: 66 };

/** What is to be shown of a state. */
const found = keeping(Object.keys(start), (state) => {
  const { all, quiet } = samples(state);
  return {
    all, quiet,
    seen: factor(state),
    tilt: tiltError(state),
    missed: belowOf(all, state.threshold),
    falsely: 100 - belowOf(quiet, state.threshold),
  };
});

function readouts(state) {
  const { seen, tilt, missed, falsely } = found(state);
  return {
    factor: three(seen),
    tilt_error: rounded(tilt),
    missed: rounded(missed),
    false_alarms: rounded(falsely),
    meaning: meaning(state, found(state)),
  };
}

function meaning({ error, threshold, iron }, { seen, missed, falsely }) {
  const above = seen > threshold;
  const shares = `Of all directions of such an error it misses ${rounded(missed)} %. Where the angles are right, noise makes ${rounded(falsely)} % of the readings a false alarm.`;
  const said = `E is ${three(seen)}, ${above ? "above" : seen < threshold ? "below" : "at"} the threshold`;
  if (error === 0 && iron !== 0 && above) return `${said}, although the angles are right: the magnetometer lies. Noise alone makes ${rounded(falsely)} % of the readings a false alarm.`;
  if (error === 0) return `${said}, and the angles are right. Noise makes ${rounded(falsely)} % of the readings a false alarm.`;
  return above ? `${said}: it sees this error. ${shares}` : `${said}, although the attitude is off by ${rounded(error)}°: to this direction it is blind. ${shares}`;
}

const summary = (state) => readouts(state).meaning;

/** The picture in words. */
const describe = (state) =>
  `A globe of the axes, north, east and down, about which the attitude can be off by ${rounded(state.error)}°: dark where E sees it, plain where it is blind, for a robot that heads to ${rounded(state.heading)}° in a field ${rounded(state.inclination)}° below the horizon. The axis chosen is at yaw ${rounded(state.axis_yaw)}°, pitch ${rounded(state.axis_pitch)}° from the nose. Below, what a threshold misses and its false alarms. ${meaning(state, found(state))}`;

// ── the picture ─────────────────────────────────────────────────────────────────────────────

const [BELTS, SECTORS] = [12, 24];
const BRIGHTEST = 0.5; // of E: what it can reach with an error of 30°

/** The globe in patches, each with E for an error about its axis. */
const patches = (state) =>
  Array.from({ length: BELTS * SECTORS }, (_, i) => {
    const [belt, sector] = [Math.floor(i / SECTORS), i % SECTORS];
    const at = (b, s) => direction((360 * s) / SECTORS, 90 - (180 * b) / BELTS);
    const corners = [at(belt, sector), at(belt, sector + 1), at(belt + 1, sector + 1), at(belt + 1, sector)];
    const distinct = corners.filter((corner, k) => !(belt === 0 && k === 1) && !(belt === BELTS - 1 && k === 2));
    return { points: distinct, seen: factorAbout(state, at(belt + 0.5, sector + 0.5)) };
  });

const [SPLIT, SHOWN] = [0.68, 3.25]; // of the height, for the globe; what it shows, in radii

function draw(context, { width, height }, state, colours, viewpoint) {
  const split = SPLIT * height;
  inPart(context, [0, 0, width, split], (size) => scene(context, size, state, colours, viewpoint));
  curves(context, [52, width - 14, split + 26, height - 28], state, colours);
}

function scene(context, size, state, colours, viewpoint) {
  const view = looking(viewpoint, size, SHOWN);
  const [plain, full] = [parsed(colours("surface")), parsed(colours("alert"))];
  const fillOf = (seen) => (seen > state.threshold ? mixed(plain, full, Math.min(1, 0.3 + seen / BRIGHTEST)) : plain);
  paint(context, patches(state).map(({ points, seen }) => ({ points, fill: fillOf(seen), unlit: true })), view);
  globe(context, view, colours, size);
  const style = { colours, room: size.width };
  const out = (end, name, colour, dash = []) => {
    if (near(end, view.eye)) pointer(context, view, scaled(end, 1.35), { ...style, from: end, name: [name], colour, dash, width: 4 });
    else {
      const there = view.project(scaled(end, 1.35)); // behind the globe: where it points, and its name
      mark(context, "circle", there, { colour: colours(colour), rim: colours("page"), radius: 4 });
      label(context, [name], there, { colour: colours(colour), rim: colours("page"), size: 13, width: size.width, offset: [8, 0] });
    }
  };
  out(fieldOf(state), "field", "z", [6, 3]);
  const [axis, nose] = [axisOf(state), direction(state.heading, 0)];
  const alike = axis[0] * nose[0] + axis[1] * nose[1] + axis[2] * nose[2] > ALIKE;
  if (!alike) out(nose, "nose", "x");
  out(axis, alike ? "nose, axis" : "axis", "ink");
}

const handles = (state, { width, height }, viewpoint) => [
  directed(looking(viewpoint, { width, height: SPLIT * height }, SHOWN), scaled(axisOf(state), 1.35), ([yaw, axis_pitch]) => ({
    axis_yaw: ((yaw - state.heading + 540) % 360) - 180,
    axis_pitch,
  })),
];

const ALIKE = Math.cos(Math.PI / 9); // of directions whose names would cover each other

const near = (point, eye) => point[0] * eye[0] + point[1] * eye[1] + point[2] * eye[2] > 0;

const MOST = 0.3; // of the threshold

function curves(context, [left, right, top, bottom], state, colours) {
  const small = { colour: colours("muted"), size: 12 };
  const { all, quiet, seen } = found(state);
  const [x, y] = [linear(0, MOST, left, right), linear(0, 100, bottom, top)];
  words(context, "per cent, by threshold", [8, top - 14], { ...small, weight: 600 });
  for (const tick of [0, 50, 100]) {
    line(context, [[left, y(tick)], [right, y(tick)]], { colour: colours("line"), width: 1 });
    words(context, `${tick} %`, [left - 6, y(tick)], { ...small, align: "right" });
  }
  for (const tick of [0, 0.1, 0.2, 0.3])
    words(context, String(tick), [x(tick), bottom + 13], { ...small, align: tick === 0 ? "left" : tick === MOST ? "right" : "center" });
  const steps = Array.from({ length: 121 }, (_, i) => (MOST * i) / 120);
  line(context, steps.map((step) => [x(step), y(belowOf(all, step))]), { colour: colours("z"), width: 2.5, dash: [6, 3] });
  line(context, steps.map((step) => [x(step), y(100 - belowOf(quiet, step))]), { colour: colours("qualified"), width: 2.5 });
  line(context, [[x(state.threshold), top], [x(state.threshold), bottom]], { colour: colours("ink"), width: 2 });
  mark(context, "triangle", [x(Math.min(seen, MOST)), bottom - 6], { colour: colours("alert"), rim: colours("page"), radius: 7 });
}

const DEGREES = { short: "°", long: "degrees" };
const SHARE = { short: "%", long: "per cent" };

const definition = {
  title: "What the factor E sees",
  python: "ValidationDemo",
  hint: "The error is one of roll: its axis is the nose, which points north. Turn the robot to the east. What becomes of E? Then take the axis by its point.",
  aspect: 1.08,
  viewpoint: () => ({ heading: 215, elevation: -28 }),
  start,
  legend: [
    { colour: "alert", width: 8, text: "axes of errors that E sees" },
    { colour: "z", dash: [6, 3], width: 2.5, text: "errors missed" },
    { colour: "qualified", width: 2.5, text: "false alarms through noise" },
    { colour: "ink", width: 2, text: "the threshold; ▲ E now" },
    { colour: "ink", width: 4, text: "the axis of the error" },
  ],
  controls: [
    { name: "heading", label: "Heading", symbol: ["ψ"], axis: "z", min: -180, max: 180, step: 1, unit: DEGREES },
    { name: "axis_yaw", label: "Axis of the error, from the nose", symbol: [], min: -180, max: 180, step: 1, unit: DEGREES },
    { name: "axis_pitch", label: "Axis of the error, upwards", symbol: [], min: -90, max: 90, step: 1, unit: DEGREES },
    { name: "error", label: "Error", symbol: [], min: 0, max: 30, step: 0.5, unit: DEGREES },
    { name: "threshold", label: "Threshold of E", symbol: [], min: 0, max: 0.3, step: 0.005, unit: { short: "", long: "threshold" }, words: (value) => ({ short: three(value), long: `a threshold of ${three(value)}` }) },
    { name: "iron", label: "Field of iron, down", symbol: [], min: -0.5, max: 0.5, step: 0.01, unit: { short: "", long: "of the field" } },
    { name: "inclination", label: "Inclination of the field", symbol: [], min: -90, max: 90, step: 1, unit: DEGREES },
  ],
  outputs: [
    { name: "meaning", label: "What it means", wide: true, longestAt: [{ ...start, error: 12.5 }] },
    { name: "factor", label: "Factor E" },
    { name: "tilt_error", label: "Vertical off by", unit: DEGREES },
    { name: "missed", label: "Directions missed", unit: SHARE },
    { name: "false_alarms", label: "False alarms", unit: SHARE },
  ],
  story: [
    { state: { ...start, heading: 90 }, says: "The robot faces east, and its roll is off by 10°. E is large: it sees this error." },
    { state: start, seconds: 3, says: "It turns to the north. The same error of roll is now a turn about the level part of the field, and E hardly sees it." },
    { state: { ...start, axis_yaw: 90 }, seconds: 3, says: "Facing north, an error of pitch is one that it sees." },
    { state: { ...start, axis_pitch: -90 }, seconds: 3, says: "About the vertical, an error of yaw. E does not contain yaw, and never sees it." },
    { state: { ...start, axis_yaw: 90, threshold: 0.01 }, seconds: 3, says: "A low threshold misses less, and takes noise for errors." },
    { state: { ...start, error: 0, iron: -0.37 }, seconds: 3, says: "Now the angles are right, and iron takes off a part of the field. E is large all the same: it says that two disagree, not who is wrong." },
  ],
  readouts,
  summary,
  describe,
  draw,
  handles,
};

export const mount = mountOf(definition);
