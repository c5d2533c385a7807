/**
 * Two more views of gimbal lock: a flight over the top, with angles and quaternion as curves, and
 * the three axes of the rings, along which a turn of the aircraft is split.
 */
import {
  eulerFromQuaternion,
  eulerRatesFromBodyRates,
  matrixFromEuler,
  quaternionAfterConstantRates,
  quaternionFromEuler,
} from "../generated/javascript/attitude.mjs";
import { inPart, line, linear, mark, words } from "./chart.js";
import { label, scaled, sum, toParent } from "./draw.js";
import { beyond, flown, globe, looking, path, pointer } from "./globe.js";
import { formatted } from "./parts.js";

/* global DASHES: build.py puts it in, { axis: pattern } */

const DEGREE = Math.PI / 180;
const NAMES = ["roll", "pitch", "yaw"];
const AXES = ["x", "y", "z"];

/** Quaternion and angles, radians, of an aircraft that in the flight flies on, pitching up. */
export function attitude(state, far = state.view === 1 ? state.flown : 0) {
  const start = NAMES.map((name) => state[name] * DEGREE);
  const q = quaternionAfterConstantRates(...quaternionFromEuler(...start), 0, 1, 0, far * DEGREE);
  return { q, euler: far === 0 ? start : eulerFromQuaternion(...q).slice(0, 3) };
}

/** How fast roll, pitch and yaw turn, by how fast the aircraft pitches up. */
export const parts = (roll, pitch) => eulerRatesFromBodyRates(roll, pitch, 0, 1, 0);

// ── over the top ────────────────────────────────────────────────────────────────────────────

const STEP = 3;
const LOOP = Array.from({ length: 360 / STEP + 1 }, (_, i) => STEP * i); // degrees

export function drawFlight(context, { width, height }, state, colours, viewpoint) {
  const [split, half] = [0.58 * height, width / 2];
  const all = LOOP.map((far) => attitude(state, far));
  inPart(context, [0, 0, width, split], (size) => {
    const view = looking(viewpoint, size);
    const nose = (q) => toParent(matrixFromEuler(...q.euler), [1, 0, 0]);
    globe(context, view, colours, size);
    path(context, view, all.map(nose), { colour: colours("muted"), width: 1.5, dash: [3, 3] });
    const now = attitude(state);
    flown(context, view, matrixFromEuler(...now.euler), colours, 0.9);
    mark(context, "circle", view.project(nose(now)), { colour: colours("x"), rim: colours("page") });
  });
  const charts = [
    { most: 180, unit: "°", lines: AXES.map((axis, i) => ({ name: NAMES[i], colour: axis, values: all.map(({ euler }) => euler[i] / DEGREE) })) },
    { most: 1, unit: "", lines: ["ink", ...AXES].map((colour, i) => ({ name: "abcd"[i], colour, values: all.map(({ q }) => q[i]) })) },
  ];
  charts.forEach((chart, i) =>
    inPart(context, [i * half, split, half, height - split], (size) => curves(context, size, chart, state.flown, colours)),
  );
}

/** Curves over the loop: thin where it is still to be flown, and broken where an angle jumps. */
function curves(context, { width, height }, { most, unit, lines }, far, colours) {
  const [left, right, top, bottom] = [52, width - 14, 26, height - 38];
  const [x, y] = [linear(0, 360, left, right), linear(-most, most, bottom, top)];
  const small = { colour: colours("muted"), size: 12 };
  for (const tick of [-most, 0, most]) {
    line(context, [[left, y(tick)], [right, y(tick)]], { colour: colours("line"), width: 1 });
    words(context, `${tick}${unit}`.replace("-", "−"), [left - 5, y(tick)], { ...small, align: "right" });
  }
  for (const tick of [0, 90, 180, 270, 360]) {
    line(context, [[x(tick), top], [x(tick), bottom]], { colour: colours("line"), width: 1 });
    if (tick % 360 !== 180 && tick < 360) words(context, `${tick}°`, [x(tick), bottom + 11], { ...small, align: "center" });
  }
  words(context, "pitched up by", [(left + right) / 2, bottom + 27], { ...small, align: "center" });
  line(context, [[x(far), top], [x(far), bottom]], { colour: colours("muted"), width: 1.5 });
  names(context, [8, 10], width - 8, lines, colours);
  lines.forEach(({ colour, values }, n) => {
    const style = { colour: colours(colour), dash: DASHES[colour] };
    const pieces = [[]];
    values.forEach((value, i) => {
      if (i > 0 && Math.abs(value - values[i - 1]) > most) pieces.push([]);
      pieces.at(-1).push([x(LOOP[i]), y(value)]);
    });
    for (const piece of pieces) {
      line(context, piece, { ...style, width: 1 });
      const flown = piece.filter(([at]) => at <= x(far));
      if (flown.length > 1) line(context, flown, { ...style, width: 3 });
    }
    // Where one lies on another, both are seen.
    mark(context, n % 2 ? "square" : "circle", [x(far), y(values[Math.round(far / STEP)])], { colour: colours(colour), rim: colours("page"), radius: 7 - 1.5 * n });
  });
}

/** Beside each other, as they are drawn: [{ name, colour }]. */
function names(context, [left, y], wide, lines, colours) {
  const letters = lines.reduce((total, { name }) => total + 7 * name.length, 0); // pixels
  const each = Math.min(26, (wide - letters) / lines.length);
  let place = left;
  lines.forEach(({ name, colour }) => {
    line(context, [[place, y], [place + each - 12, y]], { colour: colours(colour), dash: DASHES[colour], width: 3 });
    words(context, name, [place + each - 8, y], { colour: colours(colour), size: 12, weight: 600 });
    place += each + 7 * name.length;
  });
}

// ── the rates ───────────────────────────────────────────────────────────────────────────────

const [SIZE, ROOM, MOST] = [0.85, 1.1, 5]; // lengths of a unit and of the longest part, and what the chart shows

/** Directions of the axes of roll, pitch and yaw, which are unit vectors. */
export function axesOf([roll, pitch, yaw]) {
  const [ahead, level] = [matrixFromEuler(roll, pitch, yaw), matrixFromEuler(0, 0, yaw)];
  return [ahead.slice(0, 3), level.slice(3, 6), [0, 0, 1]];
}

/** The turn split along the axes; where it is `locked`, nothing along them makes the turn. */
export function drawRates(context, { width, height }, state, colours, viewpoint, locked) {
  const split = 0.66 * height;
  const { euler } = attitude(state);
  const found = locked ? [] : parts(euler[0], euler[1]);
  inPart(context, [0, 0, width, split], (size) => {
    const view = looking(viewpoint, size, 2.75);
    const [axes, taken] = [axesOf(euler), []];
    const unit = Math.min(SIZE, ...found.map((part) => ROOM / Math.abs(part)));
    const corner = (i, j, k) => view.project([i, j, k].map((on, n) => scaled(axes[n], unit * on)).reduce(sum));
    for (const [i, j] of [[0, 0], [0, 1], [1, 0], [1, 1]])
      for (const edge of [[corner(0, i, j), corner(1, i, j)], [corner(i, 0, j), corner(i, 1, j)], [corner(i, j, 0), corner(i, j, 1)]])
        line(context, edge, { colour: colours("muted"), width: 1.2 });
    flown(context, view, matrixFromEuler(...euler), colours, 1.1);
    const ends = axes.map((axis) => [-1.2, 1.2].map((far) => view.project(scaled(axis, far))));
    ends.forEach((both, i) => line(context, both, { colour: colours(AXES[i]), width: 1.5, dash: DASHES[AXES[i]] }));
    let from = [0, 0, 0];
    found.forEach((part, i) => {
      const end = sum(from, scaled(axes[i], unit * part));
      pointer(context, view, end, { from, colour: AXES[i], colours, width: 5 });
      from = end;
    });
    const style = { rim: colours("page"), size: 13, width: size.width, taken };
    ends.forEach(([back, front], i) => {
      label(context, [[NAMES[i], ...found.slice(i, i + 1).map(formatted)].join(" ")], beyond(back, front), { ...style, colour: colours(AXES[i]) });
    });
    if (unit === SIZE) label(context, ["box"], beyond(view.project([0, 0, 0]), corner(1, 1, 1)), { ...style, colour: colours("muted") });
    const turn = toParent(matrixFromEuler(...euler), [0, unit, 0]);
    pointer(context, view, turn, { name: ["turn"], colour: "ink", colours, width: 3.5, room: size, taken });
  });
  overPitch(context, [44, width - 14, split + 24, height - 24], euler, found, colours);
}

function overPitch(context, [left, right, top, bottom], [roll, pitch], found, colours) {
  const small = { colour: colours("muted"), size: 12 };
  const [x, y] = [linear(-90, 90, left, right), linear(-MOST, MOST, bottom, top)];
  words(context, "parts, by pitch", [8, top - 14], { ...small, weight: 600 });
  names(context, [right - 156, top - 14], 162, AXES.map((colour, i) => ({ name: NAMES[i], colour })), colours);
  for (const tick of [-MOST, 0, MOST]) {
    line(context, [[left, y(tick)], [right, y(tick)]], { colour: colours("line"), width: 1 });
    words(context, `${tick} ×`.replace("-", "−"), [left - 5, y(tick)], { ...small, align: "right" });
  }
  for (const tick of [-90, 0, 90])
    words(context, `${tick}°`.replace("-", "−"), [x(tick), bottom + 13], { ...small, align: tick < 0 ? "left" : tick > 0 ? "right" : "center" });
  context.save();
  context.beginPath();
  context.rect(left, top, right - left, bottom - top);
  context.clip();
  line(context, [[x(pitch / DEGREE), top], [x(pitch / DEGREE), bottom]], { colour: colours("muted"), width: 1 });
  const steps = Array.from({ length: 179 }, (_, i) => i - 89);
  AXES.forEach((axis, i) => {
    line(context, steps.map((at) => [x(at), y(parts(roll, at * DEGREE)[i])]), { colour: colours(axis), dash: DASHES[axis], width: 2 });
  });
  context.restore();
  // Beyond the chart a part is at its edge, as a triangle.
  found.forEach((part, i) => {
    const off = Math.abs(part) > MOST;
    const at = [x(pitch / DEGREE) - (off ? 14 * (i === 0 ? 1 : 0) : 0), y(Math.min(MOST, Math.max(-MOST, part)))];
    mark(context, off ? "triangle" : "circle", at, { colour: colours(AXES[i]), rim: colours("page") });
  });
}
