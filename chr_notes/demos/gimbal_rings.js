/** The picture of the rings: three that turn on each other, an aircraft in them, and a compass below. */
import { matrixFromEuler } from "../generated/javascript/attitude.mjs";
import {
  arrowhead, camera, cross, flat, label, loft, mixed, paint, parsed, placed, ring, scaled, strip,
  sum, toParent,
} from "./draw.js";
import { attitude } from "./gimbal_views.js";
import { aircraftIn } from "./globe.js";
import { keeping } from "./keeping.js";

const DEGREE = Math.PI / 180;
const [NORTH, EAST, DOWN] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
const FLOOR = 1.56; // below the centre
const [YAW_ARROW, PITCH_ARROW, ROLL_ARROW] = [1.42, 1.2, 1.17]; // distances from the centre

// The second cue of an axis: which segments of its ring are bright.
const MARKS = { x: () => true, y: (i) => i % 6 < 4, z: (i) => i % 2 === 0 };

/** Each ring with its pins by its colours, in its own axes, made anew only where these change. */
function ringsOf(shapes) {
  const made = ([axis, { pins, ...shape }]) => [
    axis,
    keeping(["fill", "marked", "steel"], ({ steel, ...paints }) => [...ring({ ...shape, ...paints, mark: MARKS[axis] }), ...pins(steel)].map(flat)),
  ];
  return Object.fromEntries(Object.entries(shapes).map(made));
}

const RINGS = ringsOf({
  z: {
    u: EAST, v: DOWN, inner: 0.95, outer: 1.03, depth: 0.05,
    pins: (steel) => [...pin(DOWN, NORTH, 1.03, 1.1, steel), ...tube(DOWN, NORTH, 1.1, FLOOR, 0.05, steel)],
  },
  y: { u: NORTH, v: EAST, inner: 0.81, outer: 0.89, depth: 0.05, pins: (steel) => pin(EAST, DOWN, 0.89, 0.95, steel) },
  x: {
    u: DOWN, v: NORTH, inner: 0.67, outer: 0.75, depth: 0.05,
    pins: (steel) => [...pin(NORTH, EAST, 0.75, 0.81, steel), ...pin(NORTH, EAST, 0.52, 0.67, steel)],
  },
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
  const rim = Array.from({ length: 121 }, (_, i) => onFloor(3 * i, 0.84));
  context.beginPath();
  rim.forEach((point) => context.lineTo(...project(point)));
  context.fillStyle = colours("surface");
  context.fill();
  context.strokeStyle = colours("shade");
  line(rim, 2);
  for (let heading = 0; heading < 360; heading += 10) {
    const quarter = heading % 90 === 0;
    line([onFloor(heading, quarter ? 0.7 : 0.75), onFloor(heading, 0.8)], quarter ? 2.5 : 1.2);
  }
}

/** The letters of the compass, inside of it: they stand in front of the post and below the rings. */
function letters(context, { project }, colours, width, taken) {
  ["N", "E", "S", "W"].forEach((letter, i) =>
    label(context, [letter], project(onFloor(90 * i, 0.52)), {
      colour: colours("muted"), rim: colours("surface"), size: 13, width, taken,
    }),
  );
}

const lookAt = ({ heading, elevation }, size) =>
  camera(matrixFromEuler(0, elevation * DEGREE, heading * DEGREE), 6, size, { wide: 3.1, high: 3.75, shift: -0.2 });

/** The rings; `locked` where two of their axes are one line. */
export function drawRings(context, size, state, colours, viewpoint, locked) {
  const view = lookAt(viewpoint, size);
  const { eye, project } = view;
  const colour = (name) => parsed(colours(name));
  const frame = frames(state);
  const [yAxis, xAxis] = [toParent(frame.y, EAST), toParent(frame.x, NORTH)];

  compass(context, view, colours);
  const solids = [...rings(frame, colour, view), ...arrows(frame, colour, eye, locked)];
  paint(context, solids, view, SHELLS, aircraftIn(view, frame.x, colours));

  const taken = [];
  letters(context, view, colours, size.width, taken);
  const words = (text, point, name, side, down = 0) =>
    label(context, [text], project(point), {
      colour: colours(name), rim: colours("page"), offset: [side * 26, down], width: size.width, taken,
    });
  words("z yaw", scaled(DOWN, -YAW_ARROW), "z", 1.3); // clear of the head beside it
  const middle = project([0, 0, 0])[0];
  const outwards = (point) => (project(point)[0] < middle - 12 ? -1 : 1);
  const [pitchEnd, rollEnd] = [scaled(yAxis, 1.3), scaled(xAxis, ROLL_ARROW)];
  words("y pitch", pitchEnd, "y", outwards(pitchEnd), 14);
  words("x roll", rollEnd, "x", outwards(rollEnd));
}

/** Each ring by the point of it that is nearest: it is drawn along the way in which it turns. */
export function handles(state, size, viewpoint) {
  if (state.view !== 0) return [];
  const view = lookAt(viewpoint, size);
  const frame = frames(state);
  const held = (name, axis, arm) => {
    const nearest = arm[0] * view.eye[0] + arm[1] * view.eye[1] + arm[2] * view.eye[2] > 0 ? arm : scaled(arm, -1);
    const at = view.project(nearest);
    const next = view.project(sum(nearest, scaled(cross(axis, nearest), 0.01)));
    const along = [0, 1].map((i) => (next[i] - at[i]) / 0.01); // pixels a radian
    const pace = Math.max(along[0] ** 2 + along[1] ** 2, size.width ** 2 / 100);
    const hold = () => (_, [right, down]) => {
      const angle = Math.round(state[name] + (right * along[0] + down * along[1]) / pace / DEGREE);
      return { [name]: name === "pitch" ? Math.min(90, Math.max(-90, angle)) : angle - 360 * Math.round(angle / 360) };
    };
    return { at, hold };
  };
  return [
    held("yaw", DOWN, toParent(frame.z, scaled(EAST, 0.99))),
    held("pitch", toParent(frame.z, EAST), toParent(frame.y, scaled(NORTH, 0.85))),
    held("roll", toParent(frame.y, NORTH), toParent(frame.x, scaled(DOWN, 0.71))),
  ];
}

/** Rings, pins and the stand. */
function rings(frame, colour, view) {
  const steel = mixed(colour("body"), colour("muted"), 0.4);
  return ["z", "y", "x"].flatMap((axis) => {
    const marked = colour(axis);
    const fill = mixed(marked, colour("body"), 0.6);
    return placed(RINGS[axis]({ fill, marked, steel }), frame[axis], view);
  });
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
    ...dashes(yAxis, 0.95, 1.5, 3, colour("y"), eye),
    ...dashes(yAxis, -0.95, -1.5, 3, colour("y"), eye),
    ...turn(down, level, scaled(yAxis, PITCH_ARROW), colour("y"), eye),
    ...[[0.89, 0.95], [0.95, 1.04], [1.04, 1.26]].flatMap(([from, to]) => dashes(xAxis, from, to, 1, colour("x"), eye)),
    ...turn(pitchedRight, pitchedDown, scaled(xAxis, ROLL_ARROW), colour("x"), eye),
    ...(locked ? lost : []),
  ];
}

