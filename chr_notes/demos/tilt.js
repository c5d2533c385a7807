/**
 * Tilt from an accelerometer: it feels what holds it up against gravity, and the acceleration of
 * the body with it. Where the two differ it believes in a vertical that is not there.
 */
import { mountOf } from "./controls.js";
import { toParent } from "./draw.js";
import { matrixFromEuler } from "../generated/javascript/attitude.mjs";
import { rounded } from "./parts.js";
import { phone } from "./phone.js";
import { attitude, estimates, reading, unaccelerated } from "./tilt_estimates.js";
import { draw, handles, LEGEND } from "./tilt_picture.js";

const RIGHT = 0.005; // degrees, less than what is shown
const ANGLES = ["roll", "pitch"];

/** Estimate, error and scatter of each angle, [{ name, estimate, error, scatter, unknown }]. */
function angles(state) {
  const found = estimates(state);
  return ANGLES.map((name, i) => ({
    name,
    estimate: rounded(found.estimate[i]),
    error: rounded(found.error[i]),
    scatter: rounded(found.scatter[i]),
    wrong: Math.abs(found.error[i]) > RIGHT,
    scattered: found.scatter[i] > RIGHT,
    unknown: found.unknown[i],
  }));
}

function readouts(state) {
  const texts = angles(state).flatMap(({ name, unknown, ...numbers }) =>
    ["estimate", "error", "scatter"].map((kind) => [
      `${name}_${kind}`, { text: numbers[kind], note: unknown ? "undefined" : "" },
    ]),
  );
  return { ...Object.fromEntries(texts), meaning: meaning(state) };
}

function meaning(state) {
  const [roll, pitch] = angles(state);
  if (pitch.unknown)
    return "The body falls freely: nothing holds it up, and its accelerometer feels nothing. Angles from no reading mean nothing.";
  const wrong = [roll, pitch].filter((angle) => angle.wrong && !angle.unknown);
  const sentences = [];
  if (roll.unknown)
    sentences.push(`What the sensor feels lies along the roll axis, the same at any roll: the ${roll.estimate}° is left by rounding.`);
  if (wrong.length > 0) {
    const list = wrong.map(({ name, error }) => `${name} is wrong by ${error}°`).join(" and ");
    sentences.push(`It takes the acceleration for tilt: ${list} as long as that lasts.`);
  } else if (!roll.unknown)
    sentences.push(
      unaccelerated(state)
        ? "The body does not accelerate, so the two verticals agree and both angles are right."
        : "The acceleration happens to leave both angles as they are.",
    );
  if (roll.scattered || pitch.scattered) sentences.push("Single readings scatter; their average does not.");
  return sentences.join(" ");
}

function summary(state) {
  const texts = angles(state).map(({ name, estimate, error, scatter, unknown }) =>
    unknown
      ? `${name} undefined`
      : `${name} ${estimate} degrees, error ${error}, scatter ${scatter}`,
  );
  return `Estimated ${texts.join("; ")}. ${meaning(state)}`;
}

/** The picture in words. */
function describe(state) {
  const [north, east, down] = toParent(matrixFromEuler(...attitude(state), 0), reading(state));
  const apart = rounded((Math.atan2(Math.hypot(north, east), -down) * 180) / Math.PI);
  const [roll, pitch] = angles(state);
  const { forward_acceleration: forward, lateral_acceleration: lateral, vibration } = state;
  const vertical = pitch.unknown
    ? "It believes in no vertical"
    : `The vertical that it believes in leans ${apart}° from the real one`;
  const shaken = vibration > 0 ? `, and single readings scatter round it: ${roll.scatter}° in roll, ${pitch.scatter}° in pitch` : "";
  return `An aircraft from behind and from the right. Roll ${rounded(state.roll)}°, pitch ${rounded(state.pitch)}°. It accelerates by ${rounded(forward)} m/s² forward and ${rounded(lateral)} m/s² to the right. ${vertical}${shaken}.`;
}

const DEGREES = { short: "°", long: "degrees" };
const METRES = { short: " m/s²", long: "metres per second squared" };
const still = { roll: 0, pitch: 0, forward_acceleration: 0, lateral_acceleration: 0, vibration: 0 };

const PUSHED = { roll: -150, pitch: 10, forward_acceleration: -9.9, lateral_acceleration: -9.9, vibration: 5 };
const UPRIGHT = { ...PUSHED, roll: -100, pitch: 90, forward_acceleration: -10, lateral_acceleration: 0 };

const definition = {
  python: "TiltDemo",
  extra: phone,
  title: "Tilt from an accelerometer",
  hint: "Push the bob of the plumb line on the right, or move the forward acceleration. Which of the two angles goes wrong? Then try the lateral one, and the vibration.",
  aspect: 1.12,
  start: still,
  legend: LEGEND,
  controls: [
    { name: "roll", label: "Roll", symbol: ["ϕ"], axis: "x", min: -180, max: 180, step: 1, unit: DEGREES },
    { name: "pitch", label: "Pitch", symbol: ["θ"], axis: "y", min: -90, max: 90, step: 1, unit: DEGREES },
    { name: "forward_acceleration", label: "Forward acceleration", symbol: ["a", "x"], axis: "x", min: -10, max: 10, step: 0.1, unit: METRES },
    { name: "lateral_acceleration", label: "Lateral acceleration", symbol: ["a", "y"], axis: "y", min: -10, max: 10, step: 0.1, unit: METRES },
    { name: "vibration", label: "Vibration, RMS", symbol: [], min: 0, max: 5, step: 0.1, unit: METRES },
  ],
  outputs: [
    { name: "meaning", label: "What it means", wide: true, longestAt: [PUSHED, UPRIGHT] },
    { name: "roll_estimate", label: "Roll estimate", unit: DEGREES },
    { name: "pitch_estimate", label: "Pitch estimate", unit: DEGREES },
    { name: "roll_error", label: "Roll error", unit: DEGREES },
    { name: "pitch_error", label: "Pitch error", unit: DEGREES },
    { name: "roll_scatter", label: "Roll scatter", unit: DEGREES },
    { name: "pitch_scatter", label: "Pitch scatter", unit: DEGREES },
  ],
  story: [
    { state: still, says: "At rest and level, the accelerometer feels one thing: what holds it up against gravity. The vertical that it believes in is the real one." },
    { state: { ...still, roll: 25, pitch: 15 }, says: "Tilted, and still at rest: both angles are right." },
    { state: { ...still, forward_acceleration: 4 }, says: "Level again, and gaining speed. An aircraft at rest with its nose up would give the same reading, so that is what the sensor believes." },
    { state: { ...still, roll: 30, lateral_acceleration: 4.9 }, says: "Banked in a turn. The reading has no sideways part left, and the sensor takes 30° of roll for none." },
    { state: { ...still, vibration: 3 }, says: "At rest, but shaken. Single readings scatter on both sides, and the average reading is right." },
    { state: { ...still, forward_acceleration: 4, vibration: 3 }, says: "Shaken and gaining speed. An average gets rid of the shaking and keeps the error of the acceleration." },
  ],
  readouts,
  summary,
  describe,
  draw,
  handles,
};

export const mount = mountOf(definition);
