/**
 * The fixed-gain observer: gyro alone, accelerometer alone, both together, and the gain between.
 */
import { line, linear, logarithmic, mark, words } from "./chart.js";
import { mountOf } from "./controls.js";
import { label } from "./draw.js";
import { DURATION, GAINS, SPACING, errors, rms } from "./filter_run.js";
import { formatted, rounded } from "./parts.js";

/* global FILTER_RUN: build.py puts it in, from filter.py */

const { begins: BEGINS, ends: ENDS } = FILTER_RUN;
const [LEAST, MOST] = [GAINS[0], GAINS.at(-1)];
const NEARLY = 1.1; // times the lowest error

/** RMS errors in degrees, and the best gain of those tried. */
function found(state) {
  const { best, rest, valley, ...series } = errors(state);
  const [gyro, accelerometer, observer, averaging] = LINES.map(({ filter }) => rms(series[filter]));
  return { gyro, accelerometer, observer, averaging, best, atRest: rest.best, thenAtRest: rest.valley[GAINS.indexOf(best.gain)] , here: valley[GAINS.indexOf(rest.best.gain)] };
}

function readouts(state) {
  const { gyro, accelerometer, observer, averaging, best } = found(state);
  return {
    gyro_error: rounded(gyro),
    accelerometer_error: rounded(accelerometer),
    observer_error: rounded(observer),
    averaging_error: rounded(averaging),
    best_gain: formatted(best.gain),
    best_error: rounded(best.error),
    meaning: meaning(state, found(state)),
  };
}

function meaning({ gain, push, bank }, { gyro, accelerometer, observer, averaging, best, atRest, here, thenAtRest }) {
  const both = `Both together are off by ${rounded(observer)}°, the gyro alone by ${rounded(gyro)}°, the accelerometer alone by ${rounded(accelerometer)}°.`;
  if (push === 0 && bank === 0) {
    if (observer <= NEARLY * best.error) return `${both} No other gain does much better.`;
    return `${both} A ${best.gain > gain ? "larger" : "smaller"} gain does better: ${formatted(best.gain)} reaches ${rounded(best.error)}°.`;
  }
  const two = `The gain that is best at rest, ${formatted(atRest.gain)}, is off by ${rounded(here)}° here; the best one here, ${formatted(best.gain)}, by ${rounded(best.error)}°, and at rest by ${rounded(thenAtRest)}°.`;
  return `${both} ${two} The average in a frame that does not turn has no gain: ${rounded(averaging)}°.`;
}

const summary = (state) => readouts(state).meaning;

/** The picture in words. */
function describe(state) {
  const { best } = found(state);
  const event = [state.push > 0 && `pushed by ${rounded(state.push)} m/s²`, state.bank > 0 && `in a turn banked by ${rounded(state.bank)}°`].filter(Boolean);
  const happens = event.length > 0 ? `, ${event.join(" and ")} from ${BEGINS} to ${ENDS} seconds` : ", at rest";
  return `Two charts. Above, the errors of four estimates of the vertical over ${DURATION} seconds${happens}, at a gain of ${formatted(state.gain)}. Below, the RMS error over the gain, a valley with its bottom at ${formatted(best.gain)}. ${meaning(state, found(state))}`;
}

// ── the picture ─────────────────────────────────────────────────────────────────────────────

const LIMITS = [1, 2, 5, 10, 20, 45, 90, 180]; // degrees
const LINES = [
  { filter: "gyro", text: "gyro alone", colour: "z", width: 2.5, dash: [2, 3] },
  { filter: "accelerometer", text: "accelerometer alone", colour: "shade", width: 1, dash: [] },
  { filter: "observer", text: "both together, by the gain L", colour: "x", width: 2.5, dash: [] },
  { filter: "averaging", text: "average in a frame that does not turn", colour: "y", width: 2.5, dash: [8, 4] },
];
const DRAWN = [LINES[1], LINES[0], LINES[3], LINES[2]]; // from behind

function draw(context, { width, height }, state, colours) {
  const all = errors(state);
  const middle = 0.56 * height;
  overTime(context, [44, width - 14, 30, middle - 26], state, all, colours);
  overGain(context, [44, width - 14, middle + 26, height - 28], state, all, colours);
}

function overTime(context, [left, right, top, bottom], { push, bank }, all, colours) {
  const small = { colour: colours("muted"), size: 12 };
  const largest = Math.max(...["gyro", "observer", "averaging"].flatMap((name) => all[name]), rms(all.accelerometer));
  const limit = LIMITS.find((each) => each >= largest) ?? 180;
  const [x, y] = [linear(0, DURATION, left, right), linear(0, limit, bottom, top)];
  words(context, "error of the vertical", [8, 14], { ...small, weight: 600 });
  if (push > 0 || bank > 0) {
    context.fillStyle = colours("surface");
    context.fillRect(x(BEGINS), top, x(ENDS) - x(BEGINS), bottom - top);
    const names = [push > 0 && "push", bank > 0 && "turn"].filter(Boolean).join(" and ");
    words(context, names, [x((BEGINS + ENDS) / 2), top - 10], { ...small, align: "center", weight: 600 });
  }
  for (const tick of [0, limit / 2, limit]) {
    line(context, [[left, y(tick)], [right, y(tick)]], { colour: colours("line"), width: 1 });
    words(context, `${tick}°`, [left - 6, y(tick)], { ...small, align: "right" });
  }
  for (const time of [0, 10, 20, 30, 40])
    words(context, `${time} s`, [x(time), bottom + 13], { ...small, align: time === 0 ? "left" : time === 40 ? "right" : "center" });
  context.save();
  context.beginPath();
  context.rect(left, top, right - left, bottom - top);
  context.clip();
  for (const { filter, colour, width, dash } of DRAWN) {
    const points = all[filter].map((error, n) => [x(SPACING * (n + 1)), y(error)]);
    line(context, points, { colour: colours(colour), width, dash });
  }
  context.restore();
}

function overGain(context, [left, right, top, bottom], { gain, push, bank }, all, colours) {
  const small = { colour: colours("muted"), size: 12 };
  const [x, y] = [logarithmic(LEAST, MOST, left, right), logarithmic(0.05, 100, bottom, top)];
  const height = (error) => y(Math.min(100, Math.max(0.05, error)));
  words(context, "RMS error over the gain L", [8, top - 14], { ...small, weight: 600 });
  for (const tick of [0.1, 1, 10, 100]) {
    line(context, [[left, y(tick)], [right, y(tick)]], { colour: colours("line"), width: 1 });
    words(context, `${tick}°`, [left - 6, y(tick)], { ...small, align: "right" });
  }
  for (const tick of [1e-4, 1e-3, 0.01, 0.1, 1])
    words(context, String(tick), [x(tick), bottom + 13], { ...small, align: tick === LEAST ? "left" : tick === MOST ? "right" : "center" });
  const level = height(rms(all.averaging));
  line(context, [[left, level], [right, level]], { colour: colours("y"), width: 2.5, dash: [8, 4] });
  if (push > 0 || bank > 0)
    line(context, GAINS.map((each, i) => [x(each), height(all.rest.valley[i])]), { colour: colours("muted"), width: 1.5, dash: [3, 3] });
  line(context, GAINS.map((each, i) => [x(each), height(all.valley[i])]), { colour: colours("ink"), width: 2.5 });
  const bottomOf = [x(all.best.gain), height(all.best.error)];
  mark(context, "triangle", [bottomOf[0], Math.min(bottomOf[1] + 9, bottom - 6)], { colour: colours("ink"), rim: colours("page"), radius: 6 });
  line(context, [[x(gain), top], [x(gain), bottom]], { colour: colours("x"), width: 1.5 });
  mark(context, "circle", [x(gain), height(rms(all.observer))], { colour: colours("x"), rim: colours("page"), radius: 6 });
  label(context, ["L"], [x(gain), top + 4], { colour: colours("x"), rim: colours("page"), width: right + 14, offset: [8, 0] });
}

const STEPS = 80; // of the slider, twenty for a factor of ten
const toPosition = (gain) => (STEPS * Math.log(gain / LEAST)) / Math.log(MOST / LEAST);
const toValue = (position) => Number((LEAST * (MOST / LEAST) ** (position / STEPS)).toPrecision(2));

/** The line of the gain, in the lower chart. */
const handles = ({ gain }, { width, height }) => {
  const [left, right] = [44, width - 14];
  const place = ([x]) => Math.round(linear(left, right, 0, STEPS)(Math.min(right, Math.max(left, x))));
  const at = [linear(0, STEPS, left, right)(toPosition(gain)), 0.78 * height];
  return [{ at, tall: 0.44 * height, hold: () => (pointer) => ({ gain: toValue(place(pointer)) }) }];
};

const DEGREES = { short: "°", long: "degrees" };
const METRES = { short: " m/s²", long: "metres per second squared" };
const RATE = { short: " °/s", long: "degrees per second" };
const start = { gain: 0.1, bias: 0.2, gyro_noise: 1, accel_noise: 1.5, push: 0, bank: 0 };

const definition = {
  title: "The fixed-gain observer",
  python: "FilterDemo",
  hint: "Find the gain with the smallest error: drag the line of L. Then let the body turn. Is it still the best?",
  aspect: 1.08,
  start,
  legend: [...LINES, { text: "RMS error over the gain; ▲ its lowest", colour: "ink", width: 2.5 }, { text: "the same at rest", colour: "muted", width: 1.5, dash: [3, 3] }],
  controls: [
    {
      name: "gain", label: "Gain", symbol: ["L"], axis: "x", min: 0, max: STEPS, step: 1,
      toPosition, toValue,
      words: (gain) => ({ short: formatted(gain), long: `a gain of ${formatted(gain)}` }),
    },
    { name: "bank", label: "Turn, banked by", symbol: [], min: 0, max: 45, step: 1, unit: DEGREES },
    { name: "push", label: "Push forward", symbol: [], min: 0, max: 3, step: 0.1, unit: METRES },
    { name: "bias", label: "Bias of the gyros", symbol: ["b"], min: 0, max: 1, step: 0.05, unit: RATE },
    { name: "gyro_noise", label: "Noise of the gyros", symbol: [], min: 0, max: 5, step: 0.1, unit: RATE },
    { name: "accel_noise", label: "Noise of the accelerometer", symbol: [], min: 0, max: 3, step: 0.1, unit: METRES },
  ],
  outputs: [
    { name: "meaning", label: "What it means", wide: true, longestAt: [{ ...start, bank: 44, push: 2.9 }, { ...start, bank: 13, push: 0.7, bias: 0.75 }] },
    { name: "observer_error", label: "Both together", unit: DEGREES },
    { name: "gyro_error", label: "Gyro alone", unit: DEGREES },
    { name: "accelerometer_error", label: "Accelerometer alone", unit: DEGREES },
    { name: "averaging_error", label: "Average", unit: DEGREES },
    { name: "best_gain", label: "Best gain" },
    { name: "best_error", label: "Error at that gain", unit: DEGREES },
  ],
  story: [
    { state: start, says: "A body at rest. The gyro alone drifts away, the accelerometer alone scatters." },
    { state: { ...start, gain: 0.6 }, seconds: 3, says: "A large gain believes the accelerometer, and lets its noise through." },
    { state: { ...start, gain: 0.0002 }, seconds: 4, says: "A small gain believes the gyro, and its bias piles up. Between the two lies a valley." },
    { state: { ...start, gain: 0.02, bank: 30 }, seconds: 3, says: "A turn of twenty seconds. The accelerometer takes it for level flight, and the observer follows." },
    { state: { ...start, gain: 0.0046, bank: 30 }, seconds: 3, says: "A gain that is good in the turn is not the one that is good at rest. In a frame that does not turn the push goes round, and its average is small: the long dashes." },
    { state: { ...start, gain: 0.02, push: 2 }, seconds: 3, says: "A push that keeps its direction cancels in no frame. Each filter that hears the accelerometer takes it for tilt." },
  ],
  readouts,
  summary,
  describe,
  draw,
  handles,
};

export const mount = mountOf(definition);
