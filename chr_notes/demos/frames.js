/**
 * The four frames: three turns one after the other, and one wind whose three numbers change with
 * the axes, although the wind does not.
 */
import { matrixFromEuler } from "../generated/javascript/attitude.mjs";
import { bars, inPart, line, words } from "./chart.js";
import { mountOf } from "./controls.js";
import { cross, scaled, times, toChild, toParent } from "./draw.js";
import { flown, looking, pointer } from "./globe.js";
import { entry, rounded } from "./parts.js";

const DEGREE = Math.PI / 180;
const FRAMES = ["inertial", "vehicle-1", "vehicle-2", "body"];
const AXES = ["x", "y", "z"];
const UNITS = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];

/** The matrix to the frame after so many turns: yaw before pitch, and pitch before yaw. */
function matrices({ yaw, pitch, roll, frame }) {
  const share = (turn) => Math.min(1, Math.max(0, frame - turn)) * DEGREE;
  const [psi, theta, phi] = [yaw * share(0), pitch * share(1), roll * share(2)];
  const [pitched, turned] = [matrixFromEuler(0, pitch * share(0), 0), matrixFromEuler(0, 0, yaw * share(1))];
  return [matrixFromEuler(phi, theta, psi), times(matrixFromEuler(phi, 0, 0), times(turned, pitched))];
}

/** Name of a frame, or between which two a turn has come. */
const nameOf = (frame) => (Number.isInteger(frame) ? FRAMES[frame] : `${FRAMES[Math.floor(frame)]} → ${FRAMES[Math.ceil(frame)]}`);

const windOf = ({ wind }) => toParent(matrixFromEuler(0, 0, wind * DEGREE), UNITS[0]);

/** Degrees between where the nose points in the one order and in the other. */
function apart([one, other]) {
  const [a, b] = [one.slice(0, 3), other.slice(0, 3)];
  return Math.atan2(Math.hypot(...cross(a, b)), a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) / DEGREE;
}

const listed = (numbers) => numbers.map((value) => entry(value).trim()).join(", ");

function readouts(state) {
  const both = matrices(state);
  const [components, other] = both.map((matrix) => toChild(matrix, windOf(state)));
  return {
    components: components.map(entry).join("\n"),
    other_order: other.map(entry).join("\n"),
    apart: rounded(apart(both)),
    meaning: meaning(state, both, components),
    matrix: table(state, both[0], components),
  };
}

function meaning(state, both, components) {
  const { frame, axis } = state;
  const row = both[0].slice(3 * axis, 3 * axis + 3);
  const products = windOf(state).map((part, i) => `${entry(row[i]).trim()}\u00a0·\u00a0${entry(part).trim()}`).join(" + ");
  const first = `In ${nameOf(frame)} axes the wind is (${listed(components)}). Its ${AXES[axis]}-component is row ${AXES[axis]} of the matrix times the wind: ${products} = ${entry(components[axis]).trim()}.`;
  const off = rounded(apart(both));
  if (frame <= 1) return `${first} The wind is the same in each frame; only the axes turn.`;
  return `${first} ${off === "0" ? "The order of yaw and pitch makes no difference to the nose." : `Pitch before yaw leads elsewhere, the nose ${off}° away.`}`;
}

const table = ({ axis }, matrix, components) => [
  ["row", "north", "east", "down", "wind"],
  ...AXES.map((name, i) => [
    i === axis ? `▸ ${name}` : name,
    ...matrix.slice(3 * i, 3 * i + 3).map((value) => entry(value).trim()),
    entry(components[i]).trim(),
  ]),
];

const summary = (state) => readouts(state).meaning;

/** The picture in words. */
function describe(state) {
  const both = matrices(state);
  return `Two aircraft with their axes, in one wind that blows to ${rounded(state.wind)}°: on the left after yaw ${rounded(state.yaw)}°, then pitch ${rounded(state.pitch)}°, then roll ${rounded(state.roll)}°, on the right with pitch before yaw, both as far as ${nameOf(state.frame)}. ${meaning(state, both, toChild(both[0], windOf(state)))}`;
}

// ── the picture ─────────────────────────────────────────────────────────────────────────────

const ORDERS = [["yaw", "pitch", "roll"], ["pitch", "yaw", "roll"]];
const [SPLIT, SHOWN, OUT] = [0.68, 2.5, 1.25]; // of the height, for the aircraft; what is shown, and how far north, east and down reach, in lengths of an axis
const INERTIAL = ["N", "E", "D"];

/** Which turns a picture shows, in their order. */
const titleOf = (order, { frame }) =>
  frame === 0 ? "no turn yet" : frame <= 1 ? `${order[0]} only` : frame <= 2 ? `${order[0]}, then ${order[1]}` : order.join(", ");

function draw(context, { width, height }, state, colours, viewpoint) {
  const [half, split] = [width / 2, SPLIT * height];
  matrices(state).forEach((matrix, i) => {
    inPart(context, [i * half, 0, half, split], (size) => scene(context, size, state, matrix, titleOf(ORDERS[i], state), colours, viewpoint));
    const components = toChild(matrix, windOf(state));
    const rows = AXES.map((name, k) => ({ text: k === state.axis ? `▸${name}` : name, colour: name, value: components[k] }));
    inPart(context, [i * half, split, half, height - split], (size) =>
      bars(context, size, "wind along x, y, z", rows, colours),
    );
  });
  line(context, [[half, 10], [half, height - 10]], { colour: colours("line"), width: 1 });
}

function scene(context, size, state, matrix, title, colours, viewpoint) {
  const view = looking(viewpoint, size, SHOWN);
  const wind = windOf(state);
  const [x, y] = view.project(wind);
  const style = { colours, room: size, taken: [{ x, y, half: 13, high: 13 }] }; // the ring by which it is held
  words(context, title, [size.width / 2, 14], { colour: colours("muted"), align: "center", weight: 600 });
  UNITS.forEach((axis, k) => pointer(context, view, scaled(axis, OUT), { ...style, name: [INERTIAL[k]], colour: "muted", width: 1.5 }));
  flown(context, view, matrix, colours, 1.5);
  const [centre, along] = [view.project([0, 0, 0]), (k, far) => toParent(matrix, scaled(UNITS[k], far))];
  UNITS.forEach((_, k) => {
    const colour = AXES[k];
    line(context, [centre, view.project(along(k, -1))], { colour: colours(colour), width: 1, dash: [2, 3] });
    pointer(context, view, along(k, 1), { ...style, name: [AXES[k]], colour, width: k === state.axis ? 3.5 : 2 });
  });
  // The component along the lit axis: from the centre to the foot of the wind on it.
  const foot = view.project(along(state.axis, toChild(matrix, wind)[state.axis]));
  line(context, [centre, foot], { colour: colours(AXES[state.axis]), width: 8 });
  line(context, [view.project(wind), foot], { colour: colours("ink"), width: 1.5, dash: [3, 3] });
  pointer(context, view, wind, { ...style, name: ["wind"], held: true, colour: "alert", dash: [7, 2, 2, 2], width: 3.5 });
}

/** The wind by its point, in both pictures: it stays level. */
function handles(state, { width, height }, viewpoint) {
  const view = looking(viewpoint, { width: width / 2, height: SPLIT * height }, SHOWN);
  const [x, y] = view.project(windOf(state));
  return [0, width / 2].map((left) => ({
    at: [left + x, y],
    hold: () => ([right, down]) => {
      const ray = view.ray([right - left, down]);
      const far = -view.eye[2] / ray[2];
      const [north, east] = [0, 1].map((i) => view.eye[i] + far * ray[i]);
      return { wind: Math.round(Math.atan2(east, north) / DEGREE) };
    },
  }));
}

const DEGREES = { short: "°", long: "degrees" };
const start = { frame: 3, axis: 1, yaw: 40, pitch: 30, roll: 25, wind: 0 };
const definition = {
  title: "Four frames and one wind",
  python: "FramesDemo",
  hint: "Go from frame to frame, and turn the wind by its point. Which of the wind's three numbers does each turn leave as it is?",
  aspect: 1.02,
  viewpoint: () => ({ heading: 50, elevation: -24 }),
  start,
  legend: [
    { colour: "alert", dash: [7, 2, 2, 2], width: 3.5, text: "the wind" },
    { colour: "muted", width: 8, text: "its component along the chosen axis" },
    { colour: "muted", width: 1.5, text: "north, east, down" },
  ],
  controls: [
    {
      name: "frame", label: "Frame", symbol: [], min: 0, max: 3, step: 0.05, stops: FRAMES.map((name, i) => [i, name]),
      words: (frame) => ({ short: nameOf(frame), long: `frame ${nameOf(frame)}` }),
    },
    { name: "axis", label: "Component along", choices: AXES },
    { name: "yaw", label: "Yaw", symbol: ["ψ"], axis: "z", min: -180, max: 180, step: 1, unit: DEGREES },
    { name: "pitch", label: "Pitch", symbol: ["θ"], axis: "y", min: -90, max: 90, step: 1, unit: DEGREES },
    { name: "roll", label: "Roll", symbol: ["ϕ"], axis: "x", min: -180, max: 180, step: 1, unit: DEGREES },
    { name: "wind", label: "Wind blows to (90° is east)", symbol: [], min: -180, max: 180, step: 1, unit: DEGREES },
  ],
  outputs: [
    { name: "meaning", label: "What it means", wide: true, longestAt: [{ ...start, axis: 0, yaw: -59, pitch: 90, roll: 0, wind: -157, frame: 1.25 }] },
    { name: "matrix", table: true },
    { name: "components", label: "Wind, yaw first", grid: true, rows: AXES },
    { name: "other_order", label: "Wind, pitch first", grid: true, rows: AXES },
    { name: "apart", label: "Noses apart by", unit: DEGREES },
  ],
  story: [
    { state: { ...start, frame: 0 }, says: "An aircraft, its nose to the north, and a wind to the north. In inertial axes it is (1, 0, 0)." },
    { state: { ...start, frame: 1 }, says: "Yaw turns the axes about z. The wind stays as it is, and its x and y change." },
    { state: { ...start, frame: 2 }, says: "Pitch turns them about y: now z has a share too. On the right, the same two turns in the other order." },
    { state: { ...start, frame: 3 }, says: "Roll turns them about x. The three numbers have changed again; the arrow has never moved." },
    { state: { ...start, frame: 3, axis: 0 }, says: "Each row of the matrix is one axis of the aircraft. Times the wind, it gives the component along that axis." },
  ],
  readouts,
  summary,
  describe,
  draw,
  handles,
};

export const mount = mountOf(definition);
