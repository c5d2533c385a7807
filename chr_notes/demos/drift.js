/**
 * Drift: an attitude that is off by a small angle lets a part of gravity through as acceleration,
 * and dead reckoning adds it up, once to a velocity and twice to a position.
 */
import { driftFromTiltError, positionAtLastVelocity, positionErrors } from "../generated/javascript/attitude.mjs";
import { line, linear, logarithmic, mapKey, mark, words } from "./chart.js";
import { mountOf } from "./controls.js";
import { label } from "./draw.js";
import { formatted } from "./parts.js";

/* global NOTES_GRAVITY, TABLE_1: build.py puts them in, m/s² and { degrees: cells as printed } */

const DEGREE = Math.PI / 180;
const [FIRST, LAST] = [1, 3600]; // seconds
const STEPS = 64; // of the slider; so many meet 10 s, 1 min and 10 min to two digits

/**
 * Errors in SI units after a time in seconds: of acceleration and velocity by the angle, of position
 * by each cause and by all together. `printed` is the position as the note reckons it.
 */
function errorsAfter(time, { angle_error: angle, accel_bias: accel, gyro_bias: gyro, accel_noise: noise }) {
  const given = [angle * DEGREE, time, NOTES_GRAVITY];
  const [acceleration, velocity] = driftFromTiltError(...given);
  const [position, byAccel, byGyro, , variance] = positionErrors(angle * DEGREE, accel, gyro * DEGREE, 0, 0, noise, 0, time, NOTES_GRAVITY);
  return {
    acceleration, velocity, position, byAccel, byGyro,
    noise: Math.sqrt(variance), total: position + byAccel + byGyro, printed: positionAtLastVelocity(...given),
  };
}

function readouts(state) {
  const errors = errorsAfter(state.time, state);
  return {
    total_error: formatted(errors.total),
    position_error: formatted(errors.position),
    accel_bias_error: formatted(errors.byAccel),
    gyro_bias_error: formatted(errors.byGyro),
    noise_error: formatted(errors.noise),
    acceleration_error: formatted(errors.acceleration),
    velocity_error: formatted(errors.velocity),
    printed_position_error: formatted(errors.printed),
    meaning: meaning(state, errors),
    row: row(state.angle_error),
  };
}

const SMALL = 20; // degrees, up to which an angle is about its sine

function meaning(state, { velocity, position, byAccel, byGyro, noise, total, printed: reckoned }) {
  const { time, gyro_bias: gyro } = state;
  if (total === 0 && noise === 0) return "With an exact attitude gravity cancels, and a sensor at rest believes that it is at rest.";
  const after = `After ${duration(time).long} a sensor that has not moved believes that it is ${distance(total)} away${placesLeft(total)}`;
  if (total === position && noise === 0)
    return `${after}, and moves at ${formatted(velocity)} m/s. In ten times as long, its velocity gets ten times as wrong, its position a hundred times. The note's table loses a factor ½: ${distance(reckoned)}.`;
  const causes = [
    [position, "by the angle, with the square of the time"],
    [byAccel, "by the accelerometer's bias, with the square too"],
    [byGyro, "by the gyro's bias, with the cube: it turns the vertical further and further"],
  ].filter(([error]) => error > 0).map(([error, words]) => `${distance(error)} ${words}`);
  const scatter = noise > 0 ? ` Noise scatters that by ${distance(noise)}.` : "";
  const beyond = gyro * time > SMALL ? ` By now the gyro's bias has turned the vertical by ${formatted(gyro * time)}°, too far for these formulas.` : "";
  return `${after}${causes.length > 0 ? `: ${causes.join("; ")}` : ""}.${scatter}${beyond}`;
}

// How far from the table each begins to be left, metres.
const PLACES = [[2.5, "the room"], [10, "the house"], [100, "the street"], [5e3, "the city"], [3e5, "the country"]];

function placesLeft(metres) {
  const last = PLACES.findLast(([far]) => far < metres);
  return last ? `, out of ${last[1]}` : "";
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
    [`Table 1 at ${formatted(angle)}°`, "right", found ? "printed" : "no such row"],
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
    return `A map round the table on which a sensor lies, and the way that it believes to have gone: with an angle that is off by ${formatted(angle)}°, ${way}.${more}`;
  }
  const axes = "A chart on logarithmic axes of the errors of velocity and position from 1 second to 1 hour";
  if (total === 0 && noise === 0) return `${axes}. Without an error of angle it is empty.`;
  return `${axes}, for an angle that is off by ${formatted(angle)}°. All are straight lines, and position rises twice as steeply as velocity. At ${duration(time).long} velocity is off by ${formatted(velocity)} m/s, position by ${distance(position)}, and without the factor ½, as the note reckons, by ${distance(reckoned)}.${more}`;
}

/** A time in words, short and long. */
function duration(time) {
  const seconds = Number(time.toFixed(time < 10 ? 1 : 0));
  const parts = [
    [Math.floor(seconds / 3600), "h", "hour"],
    [Math.floor((seconds % 3600) / 60), "min", "minute"],
    [Number((seconds % 60).toFixed(1)), "s", "second"],
  ].filter(([count]) => count > 0);
  return {
    short: parts.map(([count, unit]) => `${count} ${unit}`).join(" "),
    long: parts.map(([count, , unit]) => `${count} ${unit}${count === 1 ? "" : "s"}`).join(" "),
  };
}

/** A length in words, three digits. */
function distance(metres) {
  const [value, unit] = metres < 1 ? [100 * metres, "cm"] : metres < 1000 ? [metres, "m"] : [metres / 1000, "km"];
  return `${Number(value.toPrecision(3))} ${unit}`;
}

// ── the picture ─────────────────────────────────────────────────────────────────────────────

const draw = (...given) => (given[2].view === 0 ? drawMap : drawGrowth)(...given);

const BEARING = 0.9; // radians from north: where the map lets the sensor go
const ROOM = 3; // metres: the least that the map shows

/** The places round the table, and the way that the sensor believes in, to a scale that both fit. */
function drawMap(context, { width, height }, state, colours) {
  const { time } = state;
  const [reach, middle] = [0.4 * Math.min(width, height), [width / 2, height / 2]];
  const { total, noise } = errorsAfter(time, state);
  const scale = linear(0, Math.max(total, noise, ROOM), 0, reach);
  const small = { colour: colours("muted"), size: 12 };
  for (const [far, name] of PLACES) {
    const radius = scale(far);
    if (radius < 5 || radius > height) continue;
    context.beginPath();
    if (far < 1e3) context.rect(middle[0] - radius, middle[1] - radius, 2 * radius, 2 * radius);
    else context.arc(...middle, radius, 0, 2 * Math.PI);
    context.strokeStyle = colours("muted");
    context.lineWidth = 1.5;
    context.stroke();
    if (radius > 22 && middle[1] + radius < height - 4) words(context, name, [middle[0], middle[1] + radius - 9], { ...small, align: "center" });
  }
  mapKey(context, [14, height - 16], scale, Math.max(total, noise, ROOM), distance, small);
  const at = (moment) => {
    const far = scale(errorsAfter(moment, state).total);
    return [middle[0] + far * Math.sin(BEARING), middle[1] - far * Math.cos(BEARING)];
  };
  line(context, [middle, at(time)], { colour: colours("proved"), width: 3 });
  if (noise > 0) {
    const around = Array.from({ length: 73 }, (_, i) => (i * Math.PI) / 36);
    const [x, y] = at(time);
    line(context, around.map((turn) => [x + scale(noise) * Math.cos(turn), y + scale(noise) * Math.sin(turn)]), { colour: colours("muted") });
    words(context, `noise scatters it by ${distance(noise)}`, [width - 8, height - 14], { ...small, align: "right", weight: 600 });
  }
  mark(context, "square", middle, { colour: colours("ink"), rim: colours("page"), radius: 5 });
  label(context, ["where it lies"], middle, { colour: colours("ink"), rim: colours("page"), width, size: 12, offset: [-10, 14] });
  if (total === 0) return;
  let last = middle;
  for (const [moment, text] of TIMES.filter(([each]) => each < time)) {
    const place = at(moment);
    if (place[0] - last[0] < 22 || at(time)[0] - place[0] < 22) continue;
    mark(context, "circle", place, { colour: colours("proved"), rim: colours("page"), radius: 3.5 });
    words(context, text, [place[0] + 8, place[1] + 8], small);
    last = place;
  }
  mark(context, "circle", at(time), { colour: colours("proved"), rim: colours("page"), radius: 7 });
  label(context, [`${distance(total)} after ${duration(time).short}`], at(time), { colour: colours("proved"), rim: colours("page"), width, size: 14, offset: [0, -16] });
}

const RANGE = [3e-3, 3e7]; // m/s and m
const TIMES = [[1, "1 s"], [10, "10 s"], [60, "1 min"], [600, "10 min"], [3600, "1 h"]];
const DECADES = [[0.01, "0.01"], [0.1, "0.1"], [1, "1"], [10, "10"], [100, "100"], [1e3, "1000"], [1e4, "10⁴"], [1e5, "10⁵"], [1e6, "10⁶"], [1e7, "10⁷"]];
const SIZES = [[100, "a sports field"], [1e4, "a city"], [1e6, "a country"]]; // for scale

// What grows; `at` and `offset` place its words beside its line.
const CURVES = [
  { error: "velocity", text: "velocity", colour: "accent", dash: [2, 3], width: 3, shape: "square", at: 500, offset: [14, 14] },
  { error: "position", text: "position", colour: "proved", dash: [], width: 3, shape: "circle", at: 60, offset: [14, 12] },
  { error: "printed", text: "without ½", colour: "corrected", dash: [8, 4], width: 2.5, shape: "triangle", at: 120, offset: [-14, -10] },
  { error: "byAccel", text: "accelerometer bias", colour: "y", dash: [2, 6], width: 2.5, shape: "triangle", at: 8, offset: [14, 12] },
  { error: "byGyro", text: "gyro bias", colour: "z", dash: [10, 3, 2, 3], width: 2.5, shape: "square", at: 900, offset: [-14, -10] },
  { error: "noise", text: "noise", colour: "muted", dash: [1, 4], width: 2.5, shape: "circle", at: 30, offset: [14, 12] },
];

function drawGrowth(context, { width, height }, state, colours) {
  const { time } = state;
  const now = errorsAfter(time, state);
  const curves = CURVES.filter(({ error }) => now[error] > 0);
  const [left, right, top, bottom] = [46, width - 14, 30, height - 40];
  const [x, y] = [logarithmic(FIRST, LAST, left, right), logarithmic(...RANGE, bottom, top)];
  const at = (curve, moment) => [x(moment), y(errorsAfter(moment, state)[curve.error])];
  const small = { colour: colours("muted"), size: 12 };

  words(context, "error, m/s or m", [8, 14], { ...small, weight: 600 });
  words(context, "time without help from outside", [right, height - 10], { ...small, align: "right", weight: 600 });
  for (const [value, text] of DECADES) {
    line(context, [[left, y(value)], [right, y(value)]], { colour: colours("line"), width: 1 });
    words(context, text, [left - 6, y(value)], { ...small, align: "right" });
  }
  for (const [moment, text] of TIMES) {
    line(context, [[x(moment), top], [x(moment), bottom]], { colour: colours("line"), width: 1 });
    words(context, text, [x(moment), bottom + 14], { ...small, align: moment === LAST ? "right" : moment === FIRST ? "left" : "center" });
  }
  for (const [metres, text] of SIZES) words(context, text, [left + 6, y(metres) - 8], small);
  if (curves.length === 0) {
    label(context, ["no error of angle, no drift"], [(left + right) / 2, (top + bottom) / 2], {
      colour: colours("ink"), rim: colours("page"), width,
    });
    return;
  }
  context.save();
  context.beginPath();
  context.rect(left, top, right - left, bottom - top);
  context.clip();
  line(context, [[x(time), bottom], [x(time), top]], { colour: colours("ink"), width: 1.5 });
  curves.forEach((curve) => {
    const style = { colour: colours(curve.colour), dash: curve.dash, width: curve.width };
    line(context, [at(curve, FIRST), at(curve, LAST)], style);
  });
  context.restore();
  curves.forEach((curve) => {
    const style = { colour: colours(curve.colour), rim: colours("page"), width };
    label(context, [curve.text], at(curve, curve.at), { ...style, offset: curve.offset, size: 13 });
  });
  curves.forEach((curve) =>
    mark(context, curve.shape, at(curve, time), { colour: colours(curve.colour), rim: colours("page"), radius: 6 }),
  );
}

/** In the chart the time is taken where the pointer is. */
const handles = ({ view, time }, { width, height }) => {
  if (view === 0) return [];
  const [left, right, from, to] = [46, width - 14, Math.log10(FIRST), Math.log10(LAST)];
  const at = [logarithmic(FIRST, LAST, left, right)(time), height / 2];
  const timeAt = (x) => 10 ** Math.min(to, Math.max(from, linear(left, right, from, to)(x)));
  return [{ at, tall: height, hold: () => ([x]) => ({ time: Number(timeAt(x).toPrecision(2)) }) }];
};

const METRES = { short: "m", long: "metres" };
const still = { view: 0, angle_error: 1, accel_bias: 0, gyro_bias: 0, accel_noise: 0, time: 10 };
const SECONDS = {
  toPosition: (value) => (STEPS * Math.log(value / FIRST)) / Math.log(LAST / FIRST),
  toValue: (position) => Number((FIRST * (LAST / FIRST) ** (position / STEPS)).toPrecision(2)),
};

const definition = {
  python: "DriftDemo",
  title: "Drift of dead reckoning",
  hint: "Take the time from 10 seconds to an hour. Which error grows faster, and how far does the sensor get? Then make the angle ten times smaller.",
  aspect: 1.35,
  start: still,
  controls: [
    { name: "view", label: "Show", choices: ["a map", "the growth of the errors"] },
    { name: "angle_error", label: "Error of the angle", symbol: ["ε"], min: 0, max: 5, step: 0.1, unit: { short: "°", long: "degrees" } },
    { name: "accel_bias", label: "Bias of the accelerometer", symbol: [], min: 0, max: 0.5, step: 0.01, unit: { short: " m/s²", long: "metres per second squared" } },
    { name: "gyro_bias", label: "Bias of the gyro", symbol: [], min: 0, max: 0.02, step: 0.001, unit: { short: " °/s", long: "degrees per second" }, words: (bias) => ({ short: `${formatted(bias)} °/s`, long: `${formatted(bias)} degrees per second` }) },
    { name: "accel_noise", label: "Noise of the accelerometer", symbol: [], min: 0, max: 0.05, step: 0.001, unit: { short: " m/s²/√Hz", long: "metres per second squared per root hertz" }, words: (noise) => ({ short: `${formatted(noise)} m/s²/√Hz`, long: `${formatted(noise)} metres per second squared per root hertz` }) },
    { name: "time", label: "Time", symbol: ["t"], min: 0, max: STEPS, step: 1, unit: { short: " s", long: "seconds" }, words: duration, ...SECONDS },
  ],
  outputs: [
    { name: "meaning", label: "What it means", wide: true, longestAt: [{ ...still, angle_error: 4.6, accel_bias: 0.46, gyro_bias: 0.019, accel_noise: 0.049, time: 2597 }] },
    { name: "total_error", label: "Position error", unit: METRES },
    { name: "position_error", label: "… by the angle", unit: METRES },
    { name: "accel_bias_error", label: "… by the accelerometer", unit: METRES },
    { name: "gyro_bias_error", label: "… by the gyro", unit: METRES },
    { name: "noise_error", label: "… by noise, RMS", unit: METRES },
    { name: "printed_position_error", label: "… without ½, by the angle", unit: METRES },
    { name: "acceleration_error", label: "Acceleration, by the angle", unit: { short: "m/s²", long: "metres per second squared" } },
    { name: "velocity_error", label: "Velocity, by the angle", unit: { short: "m/s", long: "metres per second" } },
    { name: "row", table: true },
  ],
  story: [
    { state: { ...still, time: 1 }, says: "A sensor lies on a table. Its attitude is off by one degree: gravity no longer cancels, and a part of it is taken for acceleration." },
    { state: still, seconds: 3, says: "Ten seconds, and it believes to have left the room." },
    { state: { ...still, time: 3600 }, seconds: 6, says: "The street, the city: in an hour the map has to grow a hundred thousand times." },
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
