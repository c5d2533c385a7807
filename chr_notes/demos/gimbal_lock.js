/**
 * Gimbal lock: an aircraft in three rings, each turning on the one outside it, in the order
 * yaw, pitch, roll. At a pitch of 90 degrees the outer and the inner axis become one line.
 */
import {
  eulerRatesCondition,
  eulerRatesDeterminant,
  eulerRatesMatrix,
  matrixFromEuler,
  quaternionRates,
} from "../generated/javascript/attitude.mjs";
import { aircraft } from "./aircraft.js";
import { mountOf } from "./controls.js";
import {
  arrowhead, camera, cross, label, loft, mixed, paint, parsed, placed, ring, scaled, strip,
  sum, toParent,
} from "./draw.js";
import { attitude, drawFlight, drawRates, parts } from "./gimbal_views.js";
import { keeping } from "./keeping.js";
import { entry, formatted, rounded } from "./parts.js";

const DEGREE = Math.PI / 180;
// Seen from beside the plane of the yaw and the roll axis, so that the angle between the two is seen.
const [BESIDE, ABOVE] = [-118, -22]; // degrees
const [NORTH, EAST, DOWN] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
const FLOOR = 1.4; // below the centre
const [YAW_ARROW, PITCH_ARROW, ROLL_ARROW] = [1.42, 1.2, 1.17]; // distances from the centre
const TINY = 1e-9; // what rounding leaves of a rate
const LOCKED = 1e-9; // cosine of pitch below which a double cannot tell it from a right angle

// The second cue of an axis: which segments of its ring are bright.
const MARKS = { x: () => true, y: (i) => i % 6 < 4, z: (i) => i % 2 === 0 };

/** Each ring by its colours, made anew only where these change. */
function ringsOf(shapes) {
  const made = ([axis, shape]) => [axis, keeping(["fill", "marked"], (paints) => ring({ ...shape, ...paints, mark: MARKS[axis] }))];
  return Object.fromEntries(Object.entries(shapes).map(made));
}

const RINGS = ringsOf({
  z: { u: EAST, v: DOWN, inner: 0.95, outer: 1.03, depth: 0.05 },
  y: { u: NORTH, v: EAST, inner: 0.81, outer: 0.89, depth: 0.05 },
  x: { u: DOWN, v: NORTH, inner: 0.67, outer: 0.75, depth: 0.05 },
});

// Spheres between the stand and the arrows, the three rings with their pins, and the aircraft.
const SHELLS = [1.04, 0.9, 0.76, 0.54];

/** Attitudes, as matrices from the inertial frame, of what each axis turns. */
function frames(state) {
  const [phi, theta, psi] = attitude(state).euler;
  return {
    z: matrixFromEuler(0, 0, psi),
    y: matrixFromEuler(0, theta, psi),
    x: matrixFromEuler(phi, theta, psi),
  };
}

/** What the yaw axis (inertial z) and the roll axis (body x) do to each other. */
function axesOf(state) {
  const [north, east, down] = toParent(frames(state).x, NORTH);
  const apart = Math.atan2(Math.hypot(north, east), down) / DEGREE;
  return { apart, locked: Math.hypot(north, east) < LOCKED, opposite: down < 0 };
}

const LOST = "About the dashed line no ring can turn it.";

function rings(state) {
  const { apart, locked, opposite } = axesOf(state);
  if (locked && opposite)
    return `Gimbal lock. Yaw and roll turn the aircraft about the same axis, in opposite senses: raise both by the same amount and it stays where it is. ${LOST}`;
  if (locked)
    return `Gimbal lock. Yaw and roll turn the aircraft about the same axis, in the same sense: raise one, lower the other by as much, and it stays where it is. ${LOST}`;
  const [roll, pitch] = attitude(state).euler;
  const d = eulerRatesMatrix(roll, pitch);
  const fastest = formatted(Math.hypot(d[6], d[7], d[8]));
  const short = formatted(Math.min(apart, 180 - apart));
  return `The roll axis is ${short}° from the line of the yaw axis. To follow the aircraft, the yaw ring turns at up to ${fastest} × its speed.`;
}

/** How fast the angles follow the aircraft that pitches up, and what that has to do with D. */
function rates(state) {
  const { q, euler: [roll, pitch] } = attitude(state);
  const { locked } = axesOf(state);
  const [forRoll, forPitch, forYaw] = parts(roll, pitch).map((part) => formatted(Math.abs(part) < TINY ? 0 : part));
  if (state.view === 1) {
    const same = `The four numbers of the quaternion go on smoothly: taken together, at ${formatted(Math.hypot(...quaternionRates(...q, 0, 1, 0)))} × its speed, as everywhere.`;
    if (locked) return `The nose is on the vertical, where roll and yaw jump. ${same}`;
    return `Here, for each degree that the aircraft pitches up, roll changes by ${forRoll}°, pitch by ${forPitch}°, yaw by ${forYaw}°. ${same}`;
  }
  if (locked) return "The three axes lie in one plane. Parts along them make no turn out of that plane, however large they are.";
  return `The aircraft turns about its own y-axis. Split along the three axes, a speed of 1 is roll ${forRoll}, pitch ${forPitch} and yaw ${forYaw}. The box of their unit vectors has a volume of ${formatted(1 / eulerRatesDeterminant(pitch))}; the determinant of D is 1 over it.`;
}

function readouts(state) {
  const { q, euler } = attitude(state);
  const matrix = matrixFromEuler(...euler).map(entry);
  return {
    determinant: formatted(eulerRatesDeterminant(euler[1])),
    condition: formatted(eulerRatesCondition(euler[1])),
    rings: state.view === 0 ? rings(state) : rates(state),
    matrix: [0, 3, 6].map((start) => matrix.slice(start, start + 3).join(" ")).join("\n"),
    quaternion: q.map(entry).join("\n"),
  };
}

function summary(state) {
  const { determinant, condition, rings: sentence } = readouts(state);
  return `Determinant ${determinant}, condition number ${condition}. ${sentence}`;
}

/** The picture in words. */
function describe(state) {
  const { euler } = attitude(state);
  const angles = ["yaw", "pitch", "roll"].map((name, i) => `${name} ${rounded(euler[2 - i] / DEGREE)}°`).join(", ");
  if (state.view === 1) return `An aircraft that pitches up and has flown ${rounded(state.flown)}° of a loop: ${angles}. Below, its three angles and the four numbers of its quaternion as curves over the loop. ${rates(state)}`;
  if (state.view === 2) return `The axes of yaw, pitch and roll with the box of their unit vectors, an aircraft, ${angles}, and its turn as three arrows along the axes, head to tail. Below, their lengths by pitch. ${rates(state)}`;
  const nose = euler[1] === 0 ? "level" : euler[1] > 0 ? "up" : "down";
  const { apart, locked } = axesOf(state);
  const axes = locked
    ? "The yaw axis and the roll axis are one line, and a dashed line shows the axis about which no ring can turn"
    : `The roll axis is ${formatted(Math.min(apart, 180 - apart))}° from the line of the yaw axis`;
  return `An aircraft in three rings, yaw outside, pitch in the middle, roll inside: ${angles}, nose ${nose}. ${axes}.`;
}

// ── the picture ─────────────────────────────────────────────────────────────────────────────

const arc = (u, v, centre, radius, from, to) =>
  Array.from({ length: 25 }, (_, i) => {
    const angle = from + ((to - from) * i) / 24;
    return centre.map((c, k) => c + radius * (u[k] * Math.cos(angle) + v[k] * Math.sin(angle)));
  });

/** An arrow round an axis, in the sense in which its angle grows, from `u` towards `v`. */
function turn(u, v, centre, colour, eye) {
  const [first, last, tip] = [0.45, 1.8, 2.1].map((halfTurns) => halfTurns * Math.PI);
  const path = arc(u, v, centre, 0.17, first, last);
  const [end] = arc(u, v, centre, 0.165, tip, tip);
  return [...strip(path, 0.03, colour, eye), arrowhead(path.at(-1), end, 0.13, colour, eye)];
}

/** A round bar on the axis `along`, from one distance to another. */
function tube(along, across, from, to, radius, fill) {
  const round = arc(across, cross(along, across), [0, 0, 0], radius, 0, 2 * Math.PI).slice(0, -1);
  const outline = (distance) =>
    round.filter((_, i) => i % 3 === 0).map((point) => sum(point, scaled(along, distance)));
  return loft([outline(from), outline(to)], fill);
}

/** Pins that join a ring to the next one, on both sides of the axis `along`. */
const pin = (along, across, from, to, fill) =>
  [along, scaled(along, -1)].flatMap((side) => tube(side, across, from, to, 0.026, fill));

function dashes(along, from, to, count, colour, eye) {
  const at = (i) => scaled(along, from + ((to - from) * i) / (2 * count - 1));
  const each = (_, i) => strip([at(2 * i), at(2 * i + 1)], 0.022, colour, eye);
  return Array.from({ length: count }, each).flat();
}

/** The point of the compass in a direction. */
const onFloor = (degrees, radius) => [
  radius * Math.cos(degrees * DEGREE), radius * Math.sin(degrees * DEGREE), FLOOR,
];

function compass(context, { project }, colours) {
  const line = (points, thickness) => {
    context.beginPath();
    points.forEach((point) => context.lineTo(...project(point)));
    context.lineWidth = thickness;
    context.stroke();
  };
  const rim = Array.from({ length: 121 }, (_, i) => onFloor(3 * i, 1));
  context.beginPath();
  rim.forEach((point) => context.lineTo(...project(point)));
  context.fillStyle = colours("surface");
  context.fill();
  context.strokeStyle = colours("line");
  line(rim, 2);
  for (let heading = 0; heading < 360; heading += 10) {
    const quarter = heading % 90 === 0;
    line([onFloor(heading, quarter ? 0.86 : 0.91), onFloor(heading, 0.96)], quarter ? 2.5 : 1.2);
  }
}

/** The letters of the compass, which stand in front of the rings. */
function letters(context, { project }, colours, width) {
  ["N", "E", "S", "W"].forEach((letter, i) =>
    label(context, [letter], project(onFloor(90 * i, 1.14)), {
      colour: colours("muted"), rim: colours("page"), size: 13, width,
    }),
  );
}

const draw = (...given) => [drawRings, drawFlight, drawRates][given[2].view](...given, axesOf(given[2]).locked);

function drawRings(context, size, state, colours, { heading, elevation }) {
  const seen = matrixFromEuler(0, elevation * DEGREE, heading * DEGREE);
  const view = camera(seen, 6, size, { wide: 3.3, high: 3.8, shift: -0.14 });
  const { eye, project } = view;
  const colour = (name) => parsed(colours(name));
  const frame = frames(state);
  const { locked } = axesOf(state);
  const [yAxis, xAxis] = [toParent(frame.y, EAST), toParent(frame.x, NORTH)];

  compass(context, view, colours);
  paint(context, [...solids(frame, colour), ...arrows(frame, colour, eye, locked)], view, SHELLS);

  letters(context, view, colours, size.width);
  const words = (text, point, name, offset) =>
    label(context, [text], project(point), {
      colour: colours(name), rim: colours("page"), offset, width: size.width,
    });
  words("z yaw", scaled(DOWN, -YAW_ARROW), "z", [30, 0]);
  const pitchEnd = scaled(yAxis, 1.3);
  const outwards = project(pitchEnd)[0] < size.width / 2 ? -6 : 6;
  words("y pitch", pitchEnd, "y", [outwards, 34]);
  words("x roll", scaled(xAxis, ROLL_ARROW), "x", [30, 0]);
}

/** Rings, pins, stand and aircraft. */
function solids(frame, colour) {
  const steel = mixed(colour("body"), colour("muted"), 0.4);
  const rings = ["z", "y", "x"].flatMap((axis) => {
    const marked = colour(axis);
    const fill = mixed(marked, colour("page"), 0.55);
    return placed(RINGS[axis]({ fill, marked }), frame[axis]);
  });
  const names = ["body", "glass", "x", "y", "z"];
  const fills = Object.fromEntries(names.map((name) => [name, colour(name)]));
  return [
    ...rings,
    ...pin(DOWN, NORTH, 1.03, 1.1, steel),
    ...tube(DOWN, NORTH, 1.1, FLOOR, 0.05, steel),
    ...placed(pin(EAST, DOWN, 0.89, 0.95, steel), frame.y),
    ...placed(pin(NORTH, EAST, 0.75, 0.81, steel), frame.x),
    ...placed(pin(NORTH, EAST, 0.52, 0.67, steel), frame.x),
    ...placed(aircraft(fills), frame.x),
  ];
}

/** The axes, the sense in which each angle grows, and at the lock the axis that is lost. */
function arrows(frame, colour, eye, locked) {
  const [yAxis, xAxis] = [toParent(frame.y, EAST), toParent(frame.x, NORTH)];
  const [level, right, down] = [NORTH, EAST, DOWN].map((axis) => toParent(frame.z, axis));
  const [pitchedRight, pitchedDown] = [EAST, DOWN].map((axis) => toParent(frame.y, axis));
  const lost = [
    ...dashes(level, -1.55, -0.25, 12, colour("alert"), eye),
    ...dashes(level, 0.25, 1.55, 12, colour("alert"), eye),
  ];
  return [
    ...dashes(DOWN, -1.1, -1.5, 4, colour("z"), eye),
    ...turn(level, right, scaled(DOWN, -YAW_ARROW), colour("z"), eye),
    ...dashes(yAxis, 1.03, 1.34, 2, colour("y"), eye),
    ...turn(down, level, scaled(yAxis, PITCH_ARROW), colour("y"), eye),
    ...[[0.89, 0.95], [0.95, 1.04], [1.04, 1.26]].flatMap(([from, to]) => dashes(xAxis, from, to, 1, colour("x"), eye)),
    ...turn(pitchedRight, pitchedDown, scaled(xAxis, ROLL_ARROW), colour("x"), eye),
    ...(locked ? lost : []),
  ];
}

const HINTS = [
  "Bring pitch to 90°, then move yaw and roll, one after the other. What does each do to the aircraft?",
  "Fly it on, past the top: how fast do roll and yaw change there? Then try another roll at the start.",
  "Bring pitch to 80°. How long do the parts become, and how flat the box?",
];
const start = { view: 0, yaw: 0, pitch: 0, roll: 0, flown: 0 };

const definition = {
  title: "Gimbal lock",
  python: "GimbalLockDemo",
  viewpoint: ({ yaw }) => ({ heading: yaw + BESIDE, elevation: ABOVE }),
  hint: ({ view }) => HINTS[view],
  aspect: 1.08,
  start,
  controls: [
    { name: "view", label: "Show", choices: ["the rings", "a flight over the top", "the rates"] },
    { name: "yaw", label: "Yaw", symbol: ["ψ"], axis: "z", min: -180, max: 180 },
    { name: "pitch", label: "Pitch", symbol: ["θ"], axis: "y", min: -90, max: 90 },
    { name: "roll", label: "Roll", symbol: ["φ"], axis: "x", min: -180, max: 180 },
    { name: "flown", label: "Then pitched up by", symbol: [], min: 0, max: 360 },
  ].map((control) => ({ ...control, step: 1, unit: { short: "°", long: "degrees" } })),
  outputs: [
    { name: "rings", label: "What it means", wide: true, longestAt: [{ ...start, pitch: 90 }, { ...start, view: 2, pitch: -61, roll: -172 }, { ...start, view: 1, pitch: -61, roll: -172 }] },
    { name: "determinant", label: "Determinant of D" },
    { name: "condition", label: "Condition number" },
    { name: "matrix", label: "Matrix R", grid: true },
    { name: "quaternion", label: "Quaternion", grid: true },
  ],
  story: [
    { state: start, says: "Three rings, three axes at right angles. Each ring turns the aircraft in a way that no other can." },
    { state: { ...start, yaw: 40, pitch: 60 }, says: "Pitch tilts the roll axis towards the yaw axis. At 60° the yaw ring must already turn at up to twice the aircraft's speed." },
    { state: { ...start, yaw: 40, pitch: 90 }, says: "At 90° the roll axis lies along the yaw axis." },
    { state: { ...start, yaw: -20, pitch: 90, roll: -60 }, seconds: 3.5, says: "Yaw and roll turn together by the same amount, and the aircraft stays where it is: one turn is lost." },
    { state: { ...start, view: 1, roll: 12, flown: 60 }, says: "An aircraft, a little banked, pulls up into a loop. Below, its angles and its quaternion." },
    { state: { ...start, view: 1, roll: 12, flown: 130 }, seconds: 5, says: "Over the top yaw and roll swing round by almost half a turn. The quaternion does not notice." },
    { state: { ...start, view: 2, roll: 55, pitch: 30 }, seconds: 0.1, says: "The axes of the three angles, and a turn of the aircraft split along them, head to tail." },
    { state: { ...start, view: 2, roll: 55, pitch: 84 }, seconds: 4, says: "Near 90° the box of the axes is almost flat. The parts grow without bound and nearly cancel." },
  ],
  readouts,
  summary,
  describe,
  draw,
};

export const mount = mountOf(definition);
