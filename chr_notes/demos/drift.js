/**
 * Drift: an attitude that is off by a small angle lets a part of gravity through as acceleration,
 * and dead reckoning adds it up, once to a velocity and twice to a position.
 */
import { line, linear, logarithmic, mark, named, words } from "./chart.js";
import { mountOf } from "./controls.js";
import { label } from "./draw.js";
import { FIRST, LAST, PLACES, SECONDS, STEPS, distance, duration, errorsAfter, metres, placesLeft } from "./drift_errors.js";
import { noise as noiseOf } from "./noise.js";
import { formatted } from "./parts.js";

/* global TABLE_1: build.py puts it in, { degrees: cells as printed } */

function readouts(state) {
  const errors = errorsAfter(state.time, state);
  return {
    total_error: metres(errors.total),
    position_error: metres(errors.position),
    accel_bias_error: metres(errors.byAccel),
    gyro_bias_error: metres(errors.byGyro),
    noise_error: metres(errors.noise),
    acceleration_error: formatted(errors.acceleration),
    velocity_error: formatted(errors.velocity),
    printed_position_error: metres(errors.printed),
    meaning: meaning(state, errors),
    row: row(state.angle_error),
  };
}

const SMALL = 20; // degrees, up to which an angle is about its sine

function meaning(state, { velocity, position, byAccel, byGyro, noise, total }) {
  const { time, gyro_bias: gyro } = state;
  if (total === 0 && noise === 0) return "With an exact attitude gravity cancels, and a sensor at rest believes that it is at rest.";
  if (total === 0) return `On average a sensor with noise alone believes to stay where it is. After ${duration(time).short} that scatters by ${distance(noise)}.`;
  const after = `After ${duration(time).short} a sensor that has not moved believes that it is ${distance(total)} away${placesLeft(total)}`;
  if (total === position && noise === 0)
    return `${after}, and moves at ${formatted(velocity)}\u00a0m/s. In ten times as long, its velocity gets ten times as wrong, its position a hundred times.`;
  const causes = [
    [position, "by the angle"],
    [byAccel, "by the accelerometer's bias"],
    [byGyro, "by the gyro's bias, with the cube of the time"],
  ].filter(([error]) => error > 0).map(([error, words]) => `${distance(error)} ${words}`);
  const scatter = noise > 0 ? ` Noise scatters that by ${distance(noise)}.` : "";
  const beyond = gyro * time > SMALL ? ` The vertical has turned by ${formatted(gyro * time)}°, too far for these formulas.` : "";
  return `${after}: ${causes.join(", ")}.${scatter}${beyond}`;
}

const COLUMNS = [
  { text: "acceleration, m/s²", time: 0, error: "acceleration" },
  { text: "velocity, 10 s, m/s", time: 10, error: "velocity" },
  { text: "position, 10 s, m", time: 10, error: "position" },
  { text: "position, 1 min, m", time: 60, error: "position" },
  { text: "position, 10 min, m", time: 600, error: "position" },
  { text: "position, 1 h, m", time: 3600, error: "position" },
];

/** The table's row for an angle, standing upright: what is right, and what is printed. */
function row(angle) {
  const found = Object.entries(TABLE_1).find(([degrees]) => Number(degrees) === angle);
  const cells = found?.[1] ?? COLUMNS.map(() => "–");
  return [
    [`at ${formatted(angle)}°`, "right", found ? "printed" : "no such row"],
    ...COLUMNS.map(({ text, time, error }, i) => [text, formatted(errorsAfter(time, { ...still, angle_error: angle })[error]), cells[i]]),
  ];
}

function summary(state) {
  const texts = readouts(state);
  return `Acceleration error ${texts.acceleration_error} metres per second squared. ${texts.meaning}`;
}

/** The picture in words. */
function describe(state) {
  const { view, angle_error: angle, time } = state;
  const { velocity, position, total, noise, printed: reckoned } = errorsAfter(time, state);
  const more = total === position && noise === 0 ? "" : ` ${meaning(state, errorsAfter(time, state))}`;
  if (view === 0) {
    const way = total === 0 ? "it stays where it is" : `after ${duration(time).long} it is ${distance(total)} away${placesLeft(total)}`;
    return `Rings round the table on which a sensor lies, from the room to the country, each so much further out as it is larger by a factor, and the way that it believes to have gone: with an angle that is off by ${formatted(angle)}°, ${way}.${more}`;
  }
  const axes = "A chart on logarithmic axes of the errors of velocity and position from 1 second to 1 hour";
  if (total === 0 && noise === 0) return `${axes}. Without an error of angle it is empty.`;
  return `${axes}, for an angle that is off by ${formatted(angle)}°. All are straight lines, and position rises twice as steeply as velocity. At ${duration(time).long} velocity is off by ${formatted(velocity)} m/s, position by ${distance(total)}, and by the angle without the factor ½, as the note reckons, by ${distance(reckoned)}.${more}`;
}

// ── the picture ─────────────────────────────────────────────────────────────────────────────

const draw = (...given) => (given[2].view === 0 ? drawMap : drawGrowth)(...given);

const [LEAST, MOST] = [0.05, 4e7]; // metres: of the sensor itself, and once round the Earth
const MIDDLE = 0.42; // of the width: what is left to the right is the way
const CLOUD = noiseOf(60, 2, 3);

/** Where the sensor lies, and how many pixels from there a distance in metres is shown. */
function rings({ width, height }) {
  const middle = [MIDDLE * width, height / 2 + 7];
  return { middle, far: (metres) => (((1 - MIDDLE) * width - 16) * Math.log1p(metres / LEAST)) / Math.log1p(MOST / LEAST) };
}

/** The places round the table as rings, equal steps for equal factors, and the way that the sensor believes in. */
function drawMap(context, size, state, colours) {
  const { width } = size;
  const { time } = state;
  const { middle: [x, y], far } = rings(size);
  const { total, noise } = errorsAfter(time, state);
  const small = { colour: colours("muted"), size: 12 };
  const left = PLACES.filter(([metres]) => metres < total).length - 1;
  PLACES.forEach(([metres, name], i) => {
    const radius = far(metres);
    context.beginPath();
    context.arc(x, y, radius, 0, 2 * Math.PI);
    context.strokeStyle = colours("muted");
    context.lineWidth = i === left ? 3 : 1;
    context.stroke();
  });
  // Between the rings, what is within the outer one, and how far that is.
  PLACES.forEach(([metres, name], i) => {
    const off = i === 0 ? 0.6 * far(metres) : (far(metres) + far(PLACES[i - 1][0])) / 2;
    const style = { colour: colours(i === left ? "ink" : "muted"), rim: colours("page"), size: 12, width };
    label(context, [name], [x, y + off], style);
    label(context, [distance(metres)], [x, y - off], style);
  });
  context.fillStyle = colours("page");
  context.fillRect(0, 0, width, 46);
  words(context, "where a sensor at rest believes to be", [8, 14], { ...small, weight: 600 });
  const at = (moment) => [x + far(errorsAfter(moment, state).total), y];
  const end = at(time);
  line(context, [[x, y], end], { colour: colours("proved"), width: 3 });
  if (noise > 0) {
    for (const [along, across] of CLOUD) {
      const there = [total + noise * along, noise * across];
      const part = far(Math.hypot(...there)) / Math.hypot(...there);
      mark(context, "circle", [x + part * there[0], y + part * there[1]], { colour: colours("alert"), radius: 1.8 });
    }
    words(context, `• noise: ${distance(noise)}`, [8, size.height - 12], { ...small, colour: colours("alert"), weight: 600 });
  }
  mark(context, "square", [x, y], { colour: colours("ink"), rim: colours("page"), radius: 4 });
  if (total === 0) return;
  let last = x;
  for (const [moment, text] of TIMES.filter(([each]) => each < time)) {
    const place = at(moment);
    mark(context, "circle", place, { colour: colours("proved"), rim: colours("page"), radius: 3.5 });
    if (place[0] - last > 34 && end[0] - place[0] > 20) label(context, [text], [place[0], y - 15], { ...small, rim: colours("page"), width });
    last = place[0];
  }
  mark(context, "circle", end, { colour: colours("proved"), rim: colours("page"), radius: 7 });
  // Above the rings, whose names it would cover beside its dot.
  words(context, `● ${distance(total)} after ${duration(time).short}`, [8, 36], { colour: colours("proved"), size: 14, weight: 600 });
}

const RANGE = [3e-3, 3e7]; // m/s and m
const TIMES = [[1, "1 s"], [10, "10 s"], [60, "1 min"], [600, "10 min"], [3600, "1 h"]];
const DECADES = [[0.01, "0.01"], [0.1, "0.1"], [1, "1"], [10, "10"], [100, "100"], [1e3, "1000"], [1e4, "10⁴"], [1e5, "10⁵"], [1e6, "10⁶"], [1e7, "10⁷"]];
const SIZES = PLACES.slice(2); // for scale

// What grows by the angle alone, and what by each cause.
const BY_ANGLE = [
  { error: "velocity", text: "velocity", colour: "accent", dash: [2, 3], width: 3, shape: "square" },
  { error: "printed", text: "without ½", colour: "muted", dash: [8, 4], width: 1.5, shape: "triangle" },
  { error: "position", text: "position", colour: "proved", dash: [], width: 3, shape: "circle" },
];
const BY_CAUSE = [
  { error: "position", text: "angle", colour: "x", dash: [8, 4], width: 2, shape: "triangle" },
  { error: "byAccel", text: "accel. bias", colour: "qualified", dash: [2, 4], width: 2, shape: "triangle" },
  { error: "byGyro", text: "gyro bias", colour: "z", dash: [10, 3, 2, 3], width: 2, shape: "square" },
  { error: "noise", text: "noise", colour: "alert", dash: [1, 4], width: 2, shape: "circle" },
  { error: "total", text: "position", colour: "proved", dash: [], width: 3, shape: "circle" },
];
const [LEFT, NAMES] = [46, 80]; // beside the chart, in pixels

function drawGrowth(context, { width, height }, state, colours) {
  const { time } = state;
  const now = errorsAfter(time, state);
  const byAngle = now.total === now.position && now.noise === 0;
  const curves = (byAngle ? BY_ANGLE : BY_CAUSE).filter(({ error }) => now[error] > 0);
  const [right, top, bottom] = [width - NAMES, 30, height - 40];
  const [x, y] = [logarithmic(FIRST, LAST, LEFT, right), logarithmic(...RANGE, bottom, top)];
  const at = (curve, moment) => [x(moment), y(errorsAfter(moment, state)[curve.error])];
  const small = { colour: colours("muted"), size: 12 };

  words(context, byAngle ? "error of position, m, and of velocity, m/s" : "error of position by each cause, m", [8, 14], { ...small, weight: 600 });
  words(context, "time without help from outside", [width - 8, height - 10], { ...small, align: "right", weight: 600 });
  for (const [value, text] of DECADES) {
    line(context, [[LEFT, y(value)], [right, y(value)]], { colour: colours("line"), width: 1 });
    words(context, text, [LEFT - 6, y(value)], { ...small, align: "right" });
  }
  for (const [moment, text] of TIMES) {
    line(context, [[x(moment), top], [x(moment), bottom]], { colour: colours("line"), width: 1 });
    words(context, text, [x(moment), bottom + 14], { ...small, align: "center" });
  }
  for (const [metres, text] of SIZES) words(context, text.replace("the", "a"), [LEFT + 6, y(metres) - 8], small);
  if (curves.length === 0) {
    label(context, ["no error of angle, no drift"], [(LEFT + right) / 2, (top + bottom) / 2], {
      colour: colours("ink"), rim: colours("page"), width,
    });
    return;
  }
  context.save();
  context.beginPath();
  context.rect(LEFT, top, right - LEFT, bottom - top);
  context.clip();
  line(context, [[x(time), bottom], [x(time), top]], { colour: colours("ink"), width: 1.5 });
  const moments = Array.from({ length: 41 }, (_, i) => LAST ** (i / 40));
  for (const curve of curves)
    line(context, moments.map((moment) => at(curve, moment)), { colour: colours(curve.colour), dash: curve.dash, width: curve.width });
  context.restore();
  named(context, right + 5, [top, bottom], curves.map((curve) => ({ ...curve, y: at(curve, LAST)[1] })), colours);
  for (const curve of curves) mark(context, curve.shape, at(curve, time), { colour: colours(curve.colour), rim: colours("page"), radius: 6 });
}

/** On the map the sensor is taken along, in the chart the line of the time. */
const handles = (state, size) => {
  if (state.view === 0) {
    const { middle: [x, y], far } = rings(size);
    const reached = (time) => x + far(errorsAfter(time, state).total);
    if (errorsAfter(LAST, state).total === 0) return [];
    const times = Array.from({ length: STEPS + 1 }, (_, i) => SECONDS.toValue(i));
    const timeAt = (place) => times.reduce((near, time) => (Math.abs(reached(time) - place) < Math.abs(reached(near) - place) ? time : near));
    return [{ at: [reached(state.time), y], hold: () => ([place]) => ({ time: timeAt(place) }) }];
  }
  const [right, from, to] = [size.width - NAMES, Math.log10(FIRST), Math.log10(LAST)];
  const at = [logarithmic(FIRST, LAST, LEFT, right)(state.time), size.height - 56]; // clear of the times below
  const timeAt = (x) => 10 ** Math.min(to, Math.max(from, linear(LEFT, right, from, to)(x)));
  return [{ at, tall: 2 * size.height, hold: () => ([x]) => ({ time: Number(timeAt(x).toPrecision(2)) }) }];
};

const still = { view: 0, angle_error: 1, accel_bias: 0, gyro_bias: 0, accel_noise: 0, time: 10 };

const definition = {
  python: "DriftDemo",
  title: "Drift of dead reckoning",
  hint: "The sensor lies on a table. Drag the green dot, or the time, to an hour: how far does it believe to get? Then make the angle ten times smaller.",
  aspect: 1.2,
  start: still,
  controls: [
    { name: "view", label: "Show", choices: ["where it believes to be", "the growth of the errors"] },
    { name: "angle_error", label: "Error of the angle", symbol: ["ε"], min: 0, max: 5, step: 0.1, unit: { short: "°", long: "degrees" } },
    { name: "accel_bias", label: "Accelerometer bias", symbol: [], min: 0, max: 0.5, step: 0.01, unit: { short: " m/s²", long: "metres per second squared" } },
    { name: "gyro_bias", label: "Gyro bias", symbol: [], min: 0, max: 0.02, step: 0.001, unit: { short: " °/s", long: "degrees per second" }, words: (bias) => ({ short: `${formatted(bias)} °/s`, long: `${formatted(bias)} degrees per second` }) },
    { name: "accel_noise", label: "Accelerometer noise", symbol: [], min: 0, max: 0.05, step: 0.001, unit: { short: "", long: "metres per second squared per root hertz" }, words: (noise) => ({ short: "m/s²/√Hz", long: `${formatted(noise)} metres per second squared per root hertz` }) },
    { name: "time", label: "Time", symbol: ["t"], min: 0, max: STEPS, step: 1, unit: { short: " s", long: "seconds" }, words: duration, ...SECONDS },
  ],
  outputs: [
    { name: "meaning", label: "What it means", wide: true, longestAt: [{ ...still, angle_error: 4.6, accel_bias: 0.46, gyro_bias: 0.019, accel_noise: 0.049, time: 2597 }] },
    { name: "total_error", label: "Position error" },
    { name: "position_error", label: "… by the angle" },
    { name: "accel_bias_error", label: "… by accel. bias" },
    { name: "gyro_bias_error", label: "… by gyro bias" },
    { name: "noise_error", label: "… by noise, RMS" },
    { name: "printed_position_error", label: "… without ½ (note)" },
    { name: "acceleration_error", label: "Acceleration by ε", unit: { short: "m/s²", long: "metres per second squared" } },
    { name: "velocity_error", label: "Velocity by ε", unit: { short: "m/s", long: "metres per second" } },
    { name: "row", table: true, folded: "The note's Table 1 beside the right numbers" },
  ],
  story: [
    { state: { ...still, time: 1 }, says: "A sensor lies on a table. Its attitude is off by one degree: gravity no longer cancels, and a part of it is taken for acceleration." },
    { state: still, seconds: 3, says: "Ten seconds, and it believes to have left the room." },
    { state: { ...still, time: 3600 }, seconds: 6, says: "The street, the city: each ring is ten to sixty times as large as the one before, and in an hour it passes them all." },
    { state: { ...still, view: 1, time: 60 }, seconds: 0.1, says: "The same on axes on which equal steps are equal factors. The position grows with the square of the time: its line is twice as steep." },
    { state: { ...still, view: 1, angle_error: 0.1, time: 3600 }, says: "A tenth of the angle shifts all lines down by one decade. None gets less steep." },
    { state: { ...still, view: 1, angle_error: 0.1, gyro_bias: 0.003, time: 60 }, seconds: 0.1, says: "A gyro that reads 0.003 °/s at rest turns the vertical all the while. Its line is steeper: it begins far below the angle's, and crosses it after 100 seconds." },
  ],
  readouts,
  summary,
  describe,
  draw,
  handles,
};

export const mount = mountOf(definition);
