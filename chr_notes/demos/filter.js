/**
 * The fixed-gain observer: gyro alone, accelerometer alone, both together, and the gain between.
 */
import { dots, line, linear, logarithmic, mark, named, words } from "./chart.js";
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
  const { best, rest, of, ...series } = errors(state);
  const [gyro, accelerometer, observer, averaging] = LINES.map(({ filter }) => rms(series[filter]));
  return { gyro, accelerometer, observer, averaging, best, atRest: rest.best, thenAtRest: rest.of(best.gain), here: of(rest.best.gain) };
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
  const both = `Both together are off by ${rounded(observer)}°`;
  if (push === 0 && bank === 0) {
    const all = `${both}, the gyro alone by ${rounded(gyro)}°, the accelerometer alone by ${rounded(accelerometer)}°.${gain === 1 ? " A gain of 1 is the accelerometer alone." : ""}`;
    if (observer <= NEARLY * best.error) return `${all} No other gain does much better.`;
    return `${all} A ${best.gain > gain ? "larger" : "smaller"} gain does better: ${formatted(best.gain)} reaches ${rounded(best.error)}°.`;
  }
  return `${both}. The gain that is best at rest, ${formatted(atRest.gain)}, is off by ${rounded(here)}° here. The best one here, ${formatted(best.gain)}, is off by ${rounded(best.error)}°, and at rest by ${rounded(thenAtRest)}°. The average in a frame that does not turn has no gain: ${rounded(averaging)}°.`;
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

const LIMITS = [1, 2, 4, 10, 20, 40, 60, 90, 180]; // degrees
const LINES = [
  { filter: "gyro", text: "gyro alone, from the first reading on", name: "gyro", colour: "z", width: 2.5, dash: [2, 3] },
  { filter: "accelerometer", text: "accelerometer alone", name: "accel.", colour: "muted", width: 2, dash: [2, 7], single: true },
  { filter: "observer", text: "both together, by the gain L", name: "both", colour: "x", width: 2.5, dash: [] },
  { filter: "averaging", text: "average in a frame that does not turn", name: "average", colour: "y", width: 2.5, dash: [8, 4] },
];
const DRAWN = [LINES[1], LINES[0], LINES[3], LINES[2]]; // from behind
const [LEFT, NAMES, SPLIT] = [44, 64, 0.5]; // beside the charts, in pixels; of the height, for the upper one

function draw(context, { width, height }, state, colours) {
  const all = errors(state);
  const right = width - NAMES;
  overTime(context, [LEFT, right, 30, SPLIT * height - 26], state, all, colours);
  overGain(context, { width, height }, state, all, colours);
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
  }
  for (const tick of [0, limit / 2, limit]) {
    line(context, [[left, y(tick)], [right, y(tick)]], { colour: colours("line"), width: 1 });
    words(context, `${tick}°`, [left - 6, y(tick)], { ...small, align: "right" });
  }
  for (const time of [0, 10, 20, 30, 40]) words(context, `${time} s`, [x(time), bottom + 13], { ...small, align: "center" });
  context.save();
  context.beginPath();
  context.rect(left, top, right - left, bottom - top);
  context.clip();
  for (const { filter, colour, single, ...style } of DRAWN) {
    const points = all[filter].map((error, n) => [x(SPACING * (n + 1)), y(error)]);
    (single ? dots : line)(context, points, { colour: colours(colour), ...style });
  }
  context.restore();
  const event = [push > 0 && "push", bank > 0 && "turn"].filter(Boolean).join(" and ");
  label(context, [event], [x((BEGINS + ENDS) / 2), top + 10], { colour: colours("muted"), rim: colours("surface"), size: 12, width: right });
  named(context, right + 5, [top + 6, bottom], LINES.map(({ filter, name, colour }) => ({ text: name, colour, y: y(rms(all[filter].slice(-10))) })), colours);
  const most = Math.max(...all.accelerometer);
  if (most > limit) words(context, `accel. up to ${Math.round(most)}°`, [right + NAMES - 8, 14], { ...small, align: "right", weight: 600 });
}

const TICKS = [0.01, 0.03, 0.1, 0.3, 1, 3, 10, 30, 100]; // degrees

/** Where the lower chart stands, and its scales: as much of the axis of errors as the curves need. */
function scalesOf({ width, height }, { push, bank }, { valley, rest, averaging }) {
  const [left, right, top, bottom] = [LEFT, width - NAMES, SPLIT * height + 28, height - 42];
  const drawn = [...valley, ...(push > 0 || bank > 0 ? rest.valley : [])].map(([, error]) => error).concat(rms(averaging));
  const low = TICKS.findLast((tick) => tick <= Math.min(...drawn)) ?? TICKS[0];
  const high = TICKS.find((tick) => tick >= Math.max(...drawn, 3 * low)) ?? TICKS.at(-1);
  const y = logarithmic(low, high, bottom, top);
  const ticks = TICKS.filter((tick) => tick >= low && tick <= high);
  return { left, right, top, bottom, ticks, x: logarithmic(LEAST, MOST, left, right), y: (error) => y(Math.min(high, Math.max(low, error))) };
}

function overGain(context, size, state, all, colours) {
  const { left, right, top, bottom, ticks, x, y } = scalesOf(size, state, all);
  const { gain, push, bank } = state;
  const small = { colour: colours("muted"), size: 12 };
  words(context, "RMS error by the gain L", [8, top - 16], { ...small, weight: 600 });
  for (const tick of ticks) {
    line(context, [[left, y(tick)], [right, y(tick)]], { colour: colours("line"), width: 1 });
    words(context, `${tick}°`, [left - 6, y(tick)], { ...small, align: "right" });
  }
  for (const tick of [1e-4, 1e-3, 0.01, 0.1, 1]) words(context, String(tick), [x(tick), bottom + 13], { ...small, align: "center" });
  words(context, "← gyro alone", [left - 22, bottom + 31], { colour: colours("z"), weight: 600 });
  words(context, "accel. alone →", [right + 14, bottom + 31], { ...small, align: "right", weight: 600 });
  const curve = (points) => points.map(([each, error]) => [x(each), y(error)]);
  const level = y(rms(all.averaging));
  line(context, [[left, level], [right, level]], { colour: colours("y"), width: 2.5, dash: [8, 4] });
  const names = [{ text: "average", colour: "y", y: level }, { text: push > 0 || bank > 0 ? "here" : "both", colour: "ink", y: y(all.valley.at(-1)[1]), aside: x(gain) > right - 8 ? 8 : 0 }];
  if (push > 0 || bank > 0) {
    line(context, curve(all.rest.valley), { colour: colours("muted"), width: 1.5, dash: [3, 3] });
    names.push({ text: "at rest", colour: "muted", y: y(all.rest.valley.at(-1)[1]) });
  }
  line(context, curve(all.valley), { colour: colours("ink"), width: 2.5 });
  mark(context, "triangle", [x(all.best.gain), y(all.best.error) + 7], { colour: colours("ink"), rim: colours("page"), radius: 6 });
  line(context, [[x(gain), top], [x(gain), bottom]], { colour: colours("x"), width: 1.5 });
  const held = y(rms(all.observer));
  mark(context, "circle", [x(gain), held], { colour: colours("x"), rim: colours("page"), radius: 6 });
  label(context, ["L"], [x(gain), held < top + 30 ? bottom - 12 : top + 4], { colour: colours("x"), rim: colours("page"), width: size.width, offset: [gain > 0.3 ? -8 : 8, 0] });
  named(context, right + 5, [top, bottom], names, colours);
}

const STEPS = 80; // of the slider, twenty for a factor of ten
const toPosition = (gain) => (STEPS * Math.log(gain / LEAST)) / Math.log(MOST / LEAST);
const toValue = (position) => Number((LEAST * (MOST / LEAST) ** (position / STEPS)).toPrecision(2));

/** The line of the gain, in the lower chart. */
const handles = (state, size) => {
  const all = errors(state);
  const { left, right, top, bottom, x, y } = scalesOf(size, state, all);
  const place = ([at]) => Math.round(linear(left, right, 0, STEPS)(Math.min(right, Math.max(left, at))));
  const at = [x(state.gain), y(rms(all.observer))];
  const tall = 2 * Math.max(at[1] - top, bottom - at[1]);
  return [{ at, tall, hold: () => (pointer) => ({ gain: toValue(place(pointer)) }) }];
};

const DEGREES = { short: "°", long: "degrees" };
const METRES = { short: " m/s²", long: "metres per second squared" };
const RATE = { short: " °/s", long: "degrees per second" };
const start = { gain: 0.1, bias: 0.2, gyro_noise: 1, accel_noise: 1.5, push: 0, bank: 0 };

const definition = {
  title: "The fixed-gain observer",
  python: "FilterDemo",
  hint: "Find the gain with the smallest error: drag the line of L. Then let the body turn. Is it still the best?",
  aspect: 1.15,
  start,
  legend: [...LINES, { text: "their error over the gain; ▲ the lowest", colour: "ink", width: 2.5 }, { text: "the same at rest", colour: "muted", width: 1.5, dash: [3, 3] }],
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
