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
import { mountOf } from "./controls.js";
import { drawRings, handles } from "./gimbal_rings.js";
import { attitude, drawFlight, drawRates, parts } from "./gimbal_views.js";
import { entry, formatted, rounded } from "./parts.js";

const DEGREE = Math.PI / 180;
// Seen from beside the plane of the yaw and the roll axis, so that the angle between the two is seen.
const [BESIDE, ABOVE] = [-118, -22]; // degrees
const TINY = 1e-9; // what rounding leaves of a rate
const LOCKED = 1e-9; // cosine of pitch below which a double cannot tell it from a right angle

/** What the yaw axis (inertial z) and the roll axis (body x) do to each other. */
function axesOf(state) {
  const [north, east, down] = matrixFromEuler(...attitude(state).euler).slice(0, 3);
  const apart = Math.atan2(Math.hypot(north, east), down) / DEGREE;
  return { apart, locked: Math.hypot(north, east) < LOCKED, opposite: down < 0 };
}

const LOST = "About the long dashed line no ring can turn it.";

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
    const same = `The quaternion's four numbers go on smoothly, together at ${formatted(Math.hypot(...quaternionRates(...q, 0, 1, 0)))} × its speed, as everywhere.`;
    if (locked) return `The nose is on the vertical, where roll and yaw jump. ${same}`;
    return `For each degree that it pitches up, roll changes by ${forRoll}°, pitch by ${forPitch}°, yaw by ${forYaw}°. ${same}`;
  }
  if (locked) return "The three axes lie in one plane. Parts along them make no turn out of that plane, however large they are.";
  return `It turns about its own y-axis. Split along the three axes, a speed of 1 is roll ${forRoll}, pitch ${forPitch} and yaw ${forYaw}. The box of their unit vectors has a volume of ${formatted(1 / eulerRatesDeterminant(pitch))}; the determinant of D is 1 over it.`;
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
    ? "The yaw axis and the roll axis are one line, and a long dashed line shows the axis about which no ring can turn"
    : `The roll axis is ${formatted(Math.min(apart, 180 - apart))}° from the line of the yaw axis`;
  return `An aircraft in three rings, yaw outside, pitch in the middle, roll inside: ${angles}, nose ${nose}. ${axes}.`;
}

const draw = (...given) => [drawRings, drawFlight, drawRates][given[2].view](...given, axesOf(given[2]).locked);

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
  hint: HINTS,
  aspect: 1.08,
  start,
  controls: [
    { name: "view", label: "Show", choices: ["the rings", "a flight over the top", "the rates"] },
    { name: "yaw", label: "Yaw", symbol: ["ψ"], axis: "z", min: -180, max: 180 },
    { name: "pitch", label: "Pitch", symbol: ["θ"], axis: "y", min: -90, max: 90 },
    { name: "roll", label: "Roll", symbol: ["ϕ"], axis: "x", min: -180, max: 180 },
    { name: "flown", label: "In the flight, pitched up by", symbol: [], min: 0, max: 360, also: { view: 1 } },
  ].map((control) => ({ ...control, step: 1, unit: { short: "°", long: "degrees" } })),
  outputs: [
    { name: "rings", label: "What it means", wide: true, longestAt: [{ ...start, pitch: 90 }, { ...start, view: 2, pitch: 39, roll: -176 }, { ...start, view: 1, pitch: -61, roll: -172 }] },
    { name: "determinant", label: "Determinant of D" },
    { name: "condition", label: "Condition number" },
    { name: "matrix", label: "Matrix R", grid: true, rows: [..."xyz"] },
    { name: "quaternion", label: "Quaternion", grid: true, rows: [..."abcd"] },
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
  handles,
};

export const mount = mountOf(definition);
