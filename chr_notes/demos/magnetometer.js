/**
 * A magnetometer near iron: the cloud of its readings, the ellipsoid fitted to it, and what both
 * mean for the heading.
 */
import { ironAdded, ironRemoved, matrixFromEuler, matrixFromQuaternion } from "../generated/javascript/attitude.mjs";
import { inPart, line, linear, mark, words } from "./chart.js";
import { mountOf } from "./controls.js";
import { scaled } from "./draw.js";
import { arcOf, direction, flown, globe, looking, namesRound, path, pointer } from "./globe.js";
import { keeping } from "./keeping.js";
import { FIELD_DIP, STRENGTH, cloud, gap, headingErrors, ironOf, path as walked } from "./magnetometer_cloud.js";
import { AROUND, FEWEST, WIDEST_GAP, fit } from "./magnetometer_fit.js";
import { TURNED, turning } from "./magnetometer_hand.js";
import { rounded } from "./parts.js";

const largest = (errors, when) => Math.max(...errors.map((each) => Math.abs(each[when])));

const start = { readings: 150, tilt: 180, hard_iron: 15, soft_iron: 0.2, noise: 0.3, turned: "" };

/** The cloud, what the fit says of it, and the errors of the heading. */
const found = keeping(Object.keys(start), (state) => {
  const points = cloud(state);
  const fitted = fit(points);
  return { points, fitted, gap: gap(state), now: walked(state).at(-1), errors: headingErrors(state, fitted) };
});

function readouts(state) {
  const { fitted, errors } = found(state);
  return {
    gap: rounded(found(state).gap),
    error_before: rounded(largest(errors, "before")),
    error_after: fitted.refused ? { text: "–", note: "refused" } : rounded(largest(errors, "after")),
    meaning: meaning(state, fitted, errors),
  };
}

const DEGREE = Math.PI / 180;

/** Why the fit refuses: by its own ellipsoid, if it finds one, and how far that is from the true one; else by the field. */
function refusal(state, { gap: own, tooLong }) {
  const within = (degrees) => `no reading comes from within ${rounded(degrees)}° of one direction`;
  if (own === undefined) return `${within(found(state).gap)}, and one ellipsoid cannot be told from many`;
  const why = own > WIDEST_GAP ? `where it takes ${rounded(WIDEST_GAP / DEGREE)}° at most` : "too far with so much noise";
  const off = AROUND.map((each) => Math.abs(tooLong(ironAdded(...ironOf(state), ...scaled(each, STRENGTH)))));
  return `${within(own / DEGREE)} of its ellipsoid, ${why}. It would get readings wrong by up to ${Number((100 * Math.max(...off)).toPrecision(2))}\u00a0%`;
}

function meaning(state, fitted, errors) {
  const count = state.turned.length / 4;
  const worst = rounded(largest(errors, "before"));
  const before = `${worst === "0" ? "Without iron the heading is right." : `Uncalibrated, the heading is off by up to ${worst}°.`}`;
  if (fitted.refused && count > 0 && count < FEWEST)
    return `${before} ${count} ${count === 1 ? "reading" : "readings"} by hand; a fit needs ${FEWEST} at least: turn the sensor further. Readings and Tilt bring the walk back.`;
  if (fitted.refused)
    return `${before} The fit refuses: ${refusal(state, fitted)}. Turn the sensor further.`;
  return `${before} The fitted ellipsoid is brought back to a sphere about zero, and the heading is off by up to ${rounded(largest(errors, "after"))}°.`;
}

const summary = (state) => readouts(state).meaning;

/** The picture in words. */
function describe(state) {
  const { fitted, errors } = found(state);
  const how = state.turned === "" ? `${state.readings} readings of a magnetometer that is turned, and tilted by up to ${rounded(state.tilt)}°` : `${state.turned.length / 4} readings of a magnetometer that is turned by hand`;
  return `${how}, as points in space, with the sphere on which they would lie without iron. Hard iron of ${rounded(state.hard_iron)} µT shifts them, soft iron stretches them. Below, the error of the heading all around the compass. ${meaning(state, fitted, errors)}`;
}

// ── the picture ─────────────────────────────────────────────────────────────────────────────

const AXES = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
const CIRCLES = [[0, 1], [0, 2], [1, 2]].map(([i, j]) => arcOf(AXES[i], AXES[j]));
const SHOWN = 2.15;
const BALL = 0.72; // radius of the sphere without iron: so that what iron shifts stays in the picture
const SCALE = BALL / STRENGTH;

const [SPLIT, HELD] = [0.68, 0.4]; // of the height, for the clouds; of the width, for the sensor and for what is calibrated

function draw(context, { width, height }, state, colours, viewpoint) {
  const { points, fitted, errors, now } = found(state);
  const [beside, split] = [HELD * width, SPLIT * height];
  const small = { colour: colours("muted"), weight: 600 };
  inPart(context, [beside, 20, width - beside, split - 20], (size) => scene(context, size, state, points, colours, viewpoint));
  words(context, `▲ ${points.length} readings`, [beside + 12, 14], { ...small, colour: colours("x") });
  context.fillStyle = colours("surface");
  context.fillRect(6, 6, beside - 6, split / 2 - 8);
  inPart(context, [6, 16, beside - 6, split / 2 - 18], (size) => sensor(context, size, now, colours, viewpoint));
  words(context, "turn it here", [12, 16], small);
  inPart(context, [6, split / 2 + 14, beside - 6, split / 2 - 14], (size) => calibrated(context, size, points, fitted, colours, viewpoint));
  words(context, fitted.refused ? "the fit refuses" : "● calibrated", [12, split / 2 + 14], { ...small, colour: colours(fitted.refused ? "alert" : "y") });
  chart(context, [46, width - 14, split + 28, height - 22], fitted, errors, colours);
}

/** Points of a cloud as marks of a shape, the nearer ones larger and in front. */
function marks(context, view, points, shape, colour) {
  const far = ([x, y, z]) => x * view.eye[0] + y * view.eye[1] + z * view.eye[2] < 0;
  for (const behind of [true, false])
    for (const point of points)
      if (far(point) === behind) mark(context, shape, view.project(point), { colour, radius: behind ? 1.5 : 2.8 });
}

const NAMES = ["x", "y", "z"].map((name, i) => [name, scaled(AXES[i], 1.3)]); // outside the cloud

/** The readings, on the ellipsoid that iron makes of the sphere. */
function scene(context, size, state, points, colours, viewpoint) {
  const view = looking(viewpoint, size, SHOWN);
  globe(context, view, colours, size, { radius: BALL, names: [] });
  const iron = ironOf(state);
  for (const circle of CIRCLES)
    path(context, view, circle.map((point) => scaled(ironAdded(...iron, ...scaled(point, STRENGTH)), SCALE)), { colour: colours("x"), width: 1.2 });
  marks(context, view, points.map((point) => scaled(point, SCALE)), "triangle", colours("x"));
  pointer(context, view, scaled(points.at(-1), SCALE), { colours, colour: "ink", width: 1.5 });
  namesRound(context, view, colours, size, { radius: BALL, names: NAMES }); // over the lines of the ellipsoid
  const centre = view.project(scaled(ironAdded(...iron, 0, 0, 0), SCALE));
  const zero = view.project([0, 0, 0]);
  cross(context, zero, colours("ink"));
  cross(context, centre, colours("x"));
  line(context, [zero, centre], { colour: colours("x"), width: 1.5, dash: [3, 3] });
}

/** The same readings without the iron that the fit has found, if it has. */
function calibrated(context, size, points, fitted, colours, viewpoint) {
  const view = looking(viewpoint, size, 1.8);
  globe(context, view, colours, size, { radius: BALL, names: [] });
  if (!fitted.refused) marks(context, view, corrected(points, fitted), "circle", colours("y"));
  cross(context, view.project([0, 0, 0]), colours("ink"));
}

/** The sensor as it is held, its axes, and the field, which stays where it is. */
function sensor(context, size, now, colours, viewpoint) {
  const view = looking(viewpoint, size, 2.5);
  const matrix = matrixFromQuaternion(...now);
  const style = { colours, room: size, taken: [] };
  flown(context, view, matrix, colours, 1.5);
  AXES.forEach((_, k) => pointer(context, view, matrix.slice(3 * k, 3 * k + 3), { ...style, name: ["xyz"[k]], colour: "muted", width: 1.5 }));
  pointer(context, view, scaled(direction(0, -FIELD_DIP), 1.1), { ...style, name: ["field"], colour: "z", dash: [6, 3], width: 3 });
}

/** The sensor is turned where it is drawn; what it has read before, on a walk, is forgotten. */
const handles = (state, { width, height }, { heading, elevation }) => [{
  at: [(HELD * width) / 2, (SPLIT * height) / 4],
  reach: (HELD * width) / 2,
  tall: (SPLIT * height) / 2,
  hold() {
    const axes = matrixFromEuler(0, (elevation * Math.PI) / 180, (heading * Math.PI) / 180);
    return turning(state, found(state).now, [0, 3, 6].map((i) => axes.slice(i, i + 3)));
  },
}];

/** The readings without what the fit takes for iron, all of them about as long as the sphere is large. */
function corrected(points, { iron }) {
  const back = points.map((point) => ironRemoved(...iron, ...point));
  const mean = back.reduce((total, point) => total + Math.hypot(...point), 0) / back.length;
  return back.map((point) => scaled(point, BALL / mean));
}

function cross(context, [x, y], colour) {
  line(context, [[x - 5, y], [x + 5, y]], { colour, width: 2 });
  line(context, [[x, y - 5], [x, y + 5]], { colour, width: 2 });
}

const LIMITS = [1, 2, 5, 10, 20, 45, 90, 180]; // degrees

function chart(context, [left, right, top, bottom], fitted, errors, colours) {
  const small = { colour: colours("muted"), size: 12 };
  const most = Math.max(largest(errors, "before"), fitted.refused ? 0 : largest(errors, "after"));
  const limit = LIMITS.find((each) => each >= most) ?? 180;
  const [x, y] = [linear(0, 360, left, right), linear(-limit, limit, bottom, top)];
  words(context, "error of the heading, by heading", [8, top - 16], { ...small, weight: 600 });
  for (const tick of [-limit, 0, limit]) {
    line(context, [[left, y(tick)], [right, y(tick)]], { colour: colours("line"), width: 1 });
    words(context, `${tick}°`.replace("-", "−"), [left - 5, y(tick)], { ...small, align: "right" });
  }
  [["N", 0], ["E", 90], ["S", 180], ["W", 270], ["N", 360]].forEach(([name, heading]) => words(context, name, [x(heading), bottom + 12], { ...small, align: "center" }));
  // From −180° to 180° it is no way at all: there the line begins anew.
  const curves = (when) =>
    [...errors, { ...errors[0], heading: 360 }].reduce((all, each, i) => {
      if (i === 0 || Math.abs(each[when] - errors[i - 1][when]) > 180) all.push([]);
      all.at(-1).push([x(each.heading), y(each[when])]);
      return all;
    }, []);
  for (const part of curves("before")) line(context, part, { colour: colours("x"), width: 2.5, dash: [6, 3] });
  if (!fitted.refused) line(context, curves("after")[0], { colour: colours("y"), width: 2.5 });
}

const DEGREES = { short: "°", long: "degrees" };
const FIELD = { short: " µT", long: "microtesla" };

const definition = {
  title: "Calibrating a magnetometer",
  python: "MagnetometerDemo",
  hint: "Raise the tilt until the fit answers. Then take the small aircraft with the sensor, and turn it by hand.",
  aspect: 1.2,
  viewpoint: () => ({ heading: 35, elevation: -20 }),
  start,
  legend: [
    { colour: "x", width: 2.5, dash: [6, 3], text: "heading from the readings" },
    { colour: "y", width: 2.5, text: "calibrated" },
    { colour: "x", width: 1.2, text: "the ellipsoid that iron makes; + its centre" },
    { colour: "muted", width: 1.2, text: "the sphere without iron" },
    { colour: "ink", width: 1.5, text: "the reading now" },
  ],
  controls: [
    { name: "readings", label: "Readings", symbol: [], min: 10, max: 200, step: 1, unit: { short: "", long: "readings" }, also: { turned: "" } },
    { name: "tilt", label: "Tilt, at most", symbol: [], min: 0, max: 180, step: 5, unit: DEGREES, also: { turned: "" } },
    { name: "hard_iron", label: "Hard iron", symbol: [], min: 0, max: 40, step: 1, unit: FIELD },
    { name: "soft_iron", label: "Soft iron", symbol: [], min: 0, max: 0.5, step: 0.01, unit: { short: "", long: "of the field" } },
    { name: "noise", label: "Noise", symbol: [], min: 0, max: 2, step: 0.1, unit: FIELD },
  ],
  outputs: [
    { name: "meaning", label: "What it means", wide: true, longestAt: [{ ...start, readings: 200, tilt: 50, hard_iron: 29, soft_iron: 0.09 }] },
    { name: "gap", label: "Largest gap, without iron", unit: DEGREES },
    { name: "error_before", label: "Heading error before", unit: DEGREES },
    { name: "error_after", label: "Heading error after", unit: DEGREES },
  ],
  story: [
    { state: { ...start, hard_iron: 0, soft_iron: 0, readings: 200 }, says: "No iron: turned through all attitudes, the readings lie on a sphere about zero." },
    { state: { ...start, soft_iron: 0, readings: 200 }, says: "A magnet fixed to the sensor shifts the whole cloud. Zero is no longer its middle." },
    { state: { ...start, readings: 200 }, says: "Steel stretches it to an ellipsoid. The fit finds it, and brings the readings back to the sphere." },
    { state: { ...start, tilt: 0 }, seconds: 3, says: "Turned about one axis only, the readings lie on a ring. Many ellipsoids go through a ring, so the fit refuses." },
    { state: { ...start, tilt: 60, readings: 200 }, seconds: 3, says: "Tilted as well, the sensor covers more of the ellipsoid." },
    { state: { ...start, readings: 200 }, seconds: 3, says: "Turned over in all directions, it leaves no large gap." },
  ],
  readouts,
  summary,
  describe,
  draw,
  handles,
  texts: { turned: TURNED },
};

export const mount = mountOf(definition);
