/** Forty seconds of a body, the readings of its sensors, and what each filter makes of them. */
import {
  averagingTurn,
  bodyRatesFromEulerRates,
  gyroTurn,
  inclinationFromQuaternion,
  observerTurn,
  quaternionConjugate,
  quaternionFromEuler,
  quaternionMultiply,
  rotateToBody,
  tiltFromAccelerometer,
} from "../generated/javascript/attitude.mjs";
import { keeping } from "./keeping.js";
import { noise } from "./noise.js";

/* global STANDARD_GRAVITY, FILTER_RUN: build.py puts them in, from filter.py */

const DEGREE = Math.PI / 180;
const { step: STEP, steps: COUNT, every: EVERY, begins: BEGINS, ends: ENDS, speed: SPEED } = FILTER_RUN;
const { seed: SEED, time_constant: TIME_CONSTANT, longest_step: LONGEST_STEP } = FILTER_RUN;
export const GAINS = FILTER_RUN.gains;
export const DURATION = STEP * COUNT;
/** Seconds from error to error. */
export const SPACING = STEP * EVERY;

const NOISE = noise(COUNT, 6, SEED);

/** From 0 to 1 in the second after the beginning, and back in the last second before the end. */
function share(time) {
  const t = Math.min(1, Math.max(0, Math.min(time - BEGINS, ENDS - time)));
  return t * t * (3 - 2 * t);
}

/** True attitudes, true body rates and true specific forces of a body that is pushed and turns. */
function flight({ push, bank }) {
  let [attitude, heading, speed, before] = [[1, 0, 0, 0], 0, SPEED, 0];
  return Array.from({ length: COUNT }, (_, n) => {
    const part = share(STEP * (n + 1));
    const roll = bank * DEGREE * part;
    const middle = (roll + before) / 2;
    speed += push * part * STEP;
    const yawRate = (STANDARD_GRAVITY * Math.tan(middle)) / speed;
    heading += yawRate * STEP;
    const rates = bodyRatesFromEulerRates(middle, 0, (roll - before) / STEP, 0, yawRate);
    attitude = gyroTurn(...attitude, ...rates, STEP);
    before = roll;
    const [forward, right] = [push * part, STANDARD_GRAVITY * Math.tan(roll)];
    const north = forward * Math.cos(heading) - right * Math.sin(heading);
    const east = forward * Math.sin(heading) + right * Math.cos(heading);
    return { attitude, rates, force: rotateToBody(...attitude, north, east, -STANDARD_GRAVITY) };
  });
}

const SENSORS = ["bias", "gyro_noise", "accel_noise"];
const READ = ["push", "bank", ...SENSORS];

const flown = keeping(["push", "bank"], flight);
const STILL = flight({ push: 0, bank: 0 });

/** What the sensors read on a flight, with the truth beside it. */
const recorded = (flight, state) =>
  flight.map(({ attitude, rates, force }, n) => ({
    attitude,
    rates: rates.map((rate, i) => rate + state.bias * DEGREE + state.gyro_noise * DEGREE * NOISE[n][i]),
    force: force.map((value, i) => value + state.accel_noise * NOISE[n][3 + i]),
  }));
const recording = keeping(READ, (state) => recorded(flown(state), state));

/** Degrees between the true vertical and the one of an attitude. */
const apart = (estimate, truth) =>
  inclinationFromQuaternion(...quaternionMultiply(...estimate, ...quaternionConjugate(...truth))) / DEGREE;

/** The attitude that the first reading shows: all that is known at the start. */
const first = ([{ force }]) => quaternionFromEuler(...tiltFromAccelerometer(...force), 0);

/** The angles to the truth, after each so many steps, of what `estimate(reading, n)` says. */
function errorsOf(readings, estimate) {
  const found = [];
  readings.forEach((reading, n) => {
    const attitude = estimate(reading, n);
    if (n % EVERY === EVERY - 1) found.push(apart(attitude, reading.attitude));
  });
  return found;
}

function observed(readings, gain) {
  let [a, b, c, d] = first(readings);
  return errorsOf(readings, ({ rates: [p, q, r], force: [x, y, z] }, n) => {
    if (n > 0) [a, b, c, d] = observerTurn(a, b, c, d, p, q, r, x, y, z, STEP, gain);
    return [a, b, c, d];
  });
}

const byForceAlone = (readings) => errorsOf(readings, (reading) => first([reading]));

function averaging(readings) {
  let state = [...first(readings), 0, 0, 0, 0, 0, 0];
  return errorsOf(readings, ({ rates, force }, n) => {
    state = averagingTurn(...state, ...rates, ...force, n === 0 ? 0 : STEP, TIME_CONSTANT, LONGEST_STEP);
    return state.slice(0, 4);
  });
}

export const rms = (values) => Math.sqrt(values.reduce((total, value) => total + value * value, 0) / values.length);

const COARSE = 5; // gains from one that is tried everywhere to the next

/**
 * The RMS error over the gains, [gain, error]: everywhere in large steps, and in small ones round the
 * lowest, which is `best`; and `of(gain)`.
 */
function valleyOf(readings) {
  const kept = new Map();
  const of = (gain) => {
    if (!kept.has(gain)) kept.set(gain, rms(observed(readings, gain)));
    return kept.get(gain);
  };
  const lowest = (places) => places.reduce((low, i) => (of(GAINS[i]) < of(GAINS[low]) ? i : low), places[0]);
  const places = GAINS.map((_, i) => i);
  const about = lowest(places.filter((i) => i % COARSE === 0));
  const near = places.filter((i) => Math.abs(i - about) < COARSE);
  const best = GAINS[lowest(near)];
  const valley = [...kept].sort(([one], [other]) => one - other);
  return { valley, best: { gain: best, error: of(best) }, of };
}

const ofBody = keeping(READ, (state) => {
  const readings = recording(state);
  return {
    gyro: observed(readings, 0),
    accelerometer: byForceAlone(readings),
    averaging: averaging(readings),
    ...valleyOf(readings),
  };
});

/** The same sensors on a body that stays at rest. */
const atRest = keeping(SENSORS, (state) => valleyOf(recorded(STILL, state)));

/** Errors of each filter after each step, degrees, and the valleys over the gains. */
export const errors = keeping(["gain", ...READ], (state) => ({
  ...ofBody(state),
  rest: atRest(state),
  observer: observed(recording(state), state.gain),
}));
