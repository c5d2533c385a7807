/**
 * The factor E: which errors of the attitude it sees, to which it is blind, and what a threshold
 * costs.
 */
import { matrixFromEuler } from "../generated/javascript/attitude.mjs";
import { inPart, line, linear, mark, words } from "./chart.js";
import { mountOf } from "./controls.js";
import { label, scaled } from "./draw.js";
import { directed, direction, flown, globe, looking, namesRound, pointer } from "./globe.js";
import { keeping } from "./keeping.js";
import { rounded } from "./parts.js";
import { SEEN_BY, around, axisOf, belowOf, factor, fieldOf, quietly, signedFactor, tiltError } from "./validation_factor.js";

const three = (value) => String(Number(value.toFixed(3)));

const start = { heading: 0, axis_yaw: 0, axis_pitch: 0, error: 10, threshold: 0.05, iron: 0, inclination: 66 };

/** What is to be shown of a state. */
const found = keeping(Object.keys(start), (state) => {
  const [all, quiet] = [around(state), quietly(state)];
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
  const shares = `Of all directions of such an error it misses ${rounded(missed)}\u00a0%. Where the angles are right, noise makes ${rounded(falsely)}\u00a0% of the readings a false alarm.`;
  const said = `E is ${three(seen)}, ${above ? "above" : seen < threshold ? "below" : "at"} the threshold`;
  if (error === 0 && iron !== 0 && above) return `${said}, although the angles are right: the magnetometer lies. Noise alone makes ${rounded(falsely)}\u00a0% of the readings a false alarm.`;
  if (error === 0) return `${said}, and the angles are right. Noise makes ${rounded(falsely)}\u00a0% of the readings a false alarm.`;
  return above ? `${said}: it sees this error. ${shares}` : `${said}, although the attitude is off by ${rounded(error)}°: to this direction it is blind. ${shares}`;
}

const summary = (state) => readouts(state).meaning;

/** The picture in words. */
const describe = (state) =>
  `A globe of the axes, north, east and down, about which the attitude can be off by ${rounded(state.error)}°: dark where E sees it, plain where it is blind, for an aircraft that heads to ${rounded(state.heading)}° in a field ${rounded(state.inclination)}° below the horizon. The axis chosen is at yaw ${rounded(state.axis_yaw)}°, pitch ${rounded(state.axis_pitch)}° from the nose. Below, what a threshold misses and its false alarms. ${meaning(state, found(state))}`;

// ── the picture ─────────────────────────────────────────────────────────────────────────────

const [BELTS, SECTORS] = [24, 48];

/** Points of the globe, by belts from the top. */
const points = keeping([], () =>
  Array.from({ length: BELTS + 1 }, (_, belt) =>
    Array.from({ length: SECTORS + 1 }, (__, sector) => direction((360 * sector) / SECTORS, 90 - (180 * belt) / BELTS)),
  ));

/** The globe in patches, each corner with E for an error about its axis. */
const patches = keeping(SEEN_BY, (state) => {
  const seenAbout = signedFactor(state);
  const grid = points().map((belt) => belt.map((point) => ({ point, seen: seenAbout(point) })));
  return Array.from({ length: BELTS * SECTORS }, (_, i) => {
    const [belt, sector] = [Math.floor(i / SECTORS), i % SECTORS];
    return [grid[belt][sector], grid[belt][sector + 1], grid[belt + 1][sector + 1], grid[belt + 1][sector]];
  });
});

/** The part of a polygon where `of(corner)` is positive; in between it is taken to change evenly. */
function cut(corners, of) {
  const values = corners.map(of);
  if (values.every((value) => value > 0)) return corners;
  if (!values.some((value) => value > 0)) return [];
  return corners.flatMap((corner, i) => {
    const after = (i + 1) % corners.length;
    const [next, here, there] = [corners[after], values[i], values[after]];
    const t = here / (here - there);
    const mean = (a, b) => a + t * (b - a);
    const between = () => ({ point: corner.point.map((part, k) => mean(part, next.point[k])), seen: mean(corner.seen, next.seen) });
    return [...(here > 0 ? [corner] : []), ...(here > 0 !== there > 0 ? [between()] : [])];
  });
}

const [SPLIT, SHOWN] = [0.62, 3.3]; // of the height, for the globe; what it shows, in radii
const TIP = 1.25; // where the arrows end

function draw(context, { width, height }, state, colours, viewpoint) {
  inPart(context, [0, 0, width, SPLIT * height], (size) => scene(context, size, state, colours, viewpoint));
  curves(context, { width, height }, state, colours);
}

/** A globe of glass round the aircraft: what E sees is painted on its near side. */
function scene(context, size, state, colours, viewpoint) {
  const view = looking(viewpoint, size, SHOWN);
  const away = Math.hypot(...view.eye);
  context.beginPath(); // the outline of a sphere is a little larger than its equator
  context.arc(size.width / 2, size.height / 2, (Math.min(size.width, size.height) / SHOWN) * (away / Math.sqrt(away * away - 1)), 0, 2 * Math.PI);
  context.fillStyle = colours("surface");
  context.fill();
  context.strokeStyle = colours("muted");
  context.lineWidth = 1.2;
  context.stroke();
  const facing = ({ point: [x, y, z] }) => x * view.eye[0] + y * view.eye[1] + z * view.eye[2] - 1;
  context.beginPath();
  for (const patch of patches(state)) {
    const near = cut(patch, facing);
    for (const sign of [1, -1]) {
      const part = cut(near, ({ seen }) => sign * seen - state.threshold);
      part.forEach(({ point }, i) => context[i === 0 ? "moveTo" : "lineTo"](...view.project(point)));
      if (part.length > 0) context.closePath();
    }
  }
  context.fillStyle = colours("alert");
  context.fill();
  const taken = [];
  const key = (text, x, colour) => label(context, [text], [x, 14], { colour: colours(colour), rim: colours("page"), size: 12, width: size.width, taken });
  key("■ E sees", 0, "alert"); // in the corners, where no end of an axis gets
  key("□ E is blind", size.width, "muted");
  const style = { colours, room: size, taken };
  const out = (end, name, colour, dash) =>
    pointer(context, view, scaled(end, TIP), { ...style, name: [name], held: name === "axis", colour, dash, width: facing({ point: scaled(end, TIP) }) > 0 ? 4 : 2.5 });
  globe(context, view, colours, size, { names: [] });
  flown(context, view, matrixFromEuler(0, 0, (state.heading * Math.PI) / 180), colours, 0.9);
  out(fieldOf(state), "field", "z", [6, 3]);
  out(axisOf(state), "axis", "ink");
  namesRound(context, view, colours, size, { taken }); // last, or an arrow would cover them
}

/** The axis by its end, and the threshold by its line. */
const handles = (state, size, viewpoint) => {
  const { x, left, right, top, bottom, limit } = scalesOf(size, state);
  const thresholdAt = (at) => linear(left, right, 0, limit)(Math.min(right, Math.max(left, at)));
  return [
    directed(looking(viewpoint, { width: size.width, height: SPLIT * size.height }, SHOWN), scaled(axisOf(state), TIP), ([yaw, axis_pitch]) => ({
      axis_yaw: ((yaw - state.heading + 540) % 360) - 180,
      axis_pitch,
    })),
    {
      at: [x(state.threshold), (top + bottom) / 2],
      tall: bottom - top,
      hold: () => ([at]) => ({ threshold: Math.min(MOST, Number((Math.round(thresholdAt(at) / STEP) * STEP).toFixed(3))) }),
    },
  ];
};

const [MOST, STEP] = [0.3, 0.005]; // of the threshold
const LIMITS = [0.1, 0.2, 0.3, 0.5, 1, 2]; // of E

/** Where the chart stands, and its scales: as much of the axis of E as there are values. */
function scalesOf({ width, height }, state) {
  const { all, quiet, seen } = found(state);
  const [left, right, top, bottom] = [50, width - 22, SPLIT * height + 48, height - 34];
  const limit = LIMITS.find((each) => each >= Math.max(all.at(-1), quiet.at(-1), seen)) ?? 2;
  const x = linear(0, limit, left, right);
  return { left, right, top, bottom, limit, x: (value) => x(Math.min(limit, value)), y: linear(0, 100, bottom, top) };
}

function curves(context, size, state, colours) {
  const small = { colour: colours("muted"), size: 12 };
  const { all, quiet, seen } = found(state);
  const { left, right, top, bottom, limit, x, y } = scalesOf(size, state);
  words(context, "missed, and false alarms, by threshold", [8, top - 40], { ...small, weight: 600 });
  for (const tick of [0, 50, 100]) {
    line(context, [[left, y(tick)], [right, y(tick)]], { colour: colours("line"), width: 1 });
    words(context, `${tick} %`, [left - 6, y(tick)], { ...small, align: "right" });
  }
  for (const tick of [0, limit / 2, limit]) words(context, String(tick), [x(tick), bottom + 13], { ...small, align: "center" });
  const steps = Array.from({ length: 201 }, (_, i) => (limit * i) / 200);
  line(context, steps.map((step) => [x(step), y(belowOf(all, step))]), { colour: colours("y"), width: 2.5, dash: [6, 3] });
  line(context, steps.map((step) => [x(step), y(100 - belowOf(quiet, step))]), { colour: colours("qualified"), width: 2.5 });
  words(context, "missed", [right - 4, top + 11], { ...small, colour: colours("y"), align: "right", weight: 600 });
  words(context, "false alarms", [right - 4, bottom - 9], { ...small, colour: colours("qualified"), align: "right", weight: 600 });
  const uprights = [[state.threshold, "threshold", "ink", 27, []], [seen, "▲ E now", "alert", 12, [2, 3]]];
  for (const [value, , colour, above, dash] of uprights) line(context, [[x(value), top - above], [x(value), bottom]], { colour: colours(colour), width: 2, dash });
  for (const [value, name, colour, above] of uprights)
    label(context, [value > limit ? `${name} ${three(value)} →` : name], [x(value), top - above + 5], {
      colour: colours(colour), rim: colours("page"), size: 12, width: size.width, offset: [value > limit / 2 ? -5 : 5, 0],
    });
  mark(context, "triangle", [x(seen), bottom + 5], { colour: colours("alert"), rim: colours("page"), radius: 6 });
}

const DEGREES = { short: "°", long: "degrees" };
const SHARE = { short: "%", long: "per cent" };

const definition = {
  title: "What the factor E sees",
  python: "ValidationDemo",
  hint: "The error is one of roll: its axis is the nose, which points north. Turn the aircraft to the east by its heading. What becomes of E? Then take the axis by its end, and the threshold by its line.",
  aspect: 1.2,
  viewpoint: () => ({ heading: 215, elevation: -28 }),
  start,
  legend: [
    { colour: "z", dash: [6, 3], width: 3, text: "the field" },
    { colour: "ink", width: 4, text: "the axis of the error" },
    { colour: "y", dash: [6, 3], width: 2.5, text: "errors missed" },
    { colour: "qualified", width: 2.5, text: "false alarms through noise" },
  ],
  controls: [
    { name: "heading", label: "Heading", symbol: ["ψ"], axis: "z", min: -180, max: 180, step: 1, unit: DEGREES },
    { name: "axis_yaw", label: "Axis of the error, from the nose", symbol: [], min: -180, max: 180, step: 1, unit: DEGREES },
    { name: "axis_pitch", label: "Axis of the error, upwards", symbol: [], min: -90, max: 90, step: 1, unit: DEGREES },
    { name: "error", label: "Error", symbol: [], min: 0, max: 30, step: 0.5, unit: DEGREES },
    { name: "threshold", label: "Threshold of E", symbol: [], min: 0, max: MOST, step: STEP, unit: { short: "", long: "threshold" }, words: (value) => ({ short: three(value), long: `a threshold of ${three(value)}` }) },
    { name: "iron", rare: true, label: "Field of iron, down", symbol: [], min: -0.5, max: 0.5, step: 0.01, unit: { short: "", long: "of the field" } },
    { name: "inclination", rare: true, label: "Inclination of the field", symbol: [], min: -90, max: 90, step: 1, unit: DEGREES },
  ],
  rarely: "Iron and inclination",
  outputs: [
    { name: "meaning", label: "What it means", wide: true, longestAt: [{ ...start, axis_yaw: -117, axis_pitch: 50, error: 10.5, threshold: 0.03, iron: -0.5, inclination: 78 }] },
    { name: "factor", label: "Factor E" },
    { name: "missed", label: "Directions missed", unit: SHARE },
    { name: "false_alarms", label: "False alarms", unit: SHARE },
    { name: "tilt_error", label: "Vertical off by", unit: DEGREES },
  ],
  story: [
    { state: { ...start, heading: 90 }, says: "The aircraft faces east, and its roll is off by 10°. E is large: it sees this error." },
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
