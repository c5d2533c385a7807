/** A sphere of directions round a body, seen by a camera: circles, arrows and names on it. */
import { matrixFromEuler } from "../generated/javascript/attitude.mjs";
import { aircraft } from "./aircraft.js";
import { arrow, line } from "./chart.js";
import { camera, label, paint, parsed, scaled, sum, toParent, viewIn } from "./draw.js";

const DEGREE = Math.PI / 180;
const DISTANCE = 7;
const RING = 13; // pixels from the end of what is held to the outside of the ring round it
const [NORTH, EAST, DOWN] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
const NAMES = [["N", NORTH], ["E", EAST], ["S", scaled(NORTH, -1)], ["W", scaled(EAST, -1)], ["down", DOWN]];

/** A camera at a viewpoint in degrees, which shows so much: a sphere of radius 1 and names round it. */
export const looking = ({ heading, elevation }, size, shown = 2.75) =>
  camera(matrixFromEuler(0, elevation * DEGREE, heading * DEGREE), DISTANCE, size, { wide: shown, high: shown, shift: 0 });

/** Points round the origin from the unit vector `u` towards `v`, which is at right angles to it. */
export const arcOf = (u, v, from = 0, to = 2 * Math.PI, count = 72) =>
  Array.from({ length: count + 1 }, (_, i) => {
    const angle = from + ((to - from) * i) / count;
    return sum(scaled(u, Math.cos(angle)), scaled(v, Math.sin(angle)));
  });

const nearer = (point, eye) => point[0] * eye[0] + point[1] * eye[1] + point[2] * eye[2] > 0;

/** A path on the sphere; what is on the far side is thinner. */
export function path(context, { eye, project }, points, { width = 2, ...style }) {
  const pieces = [];
  points.slice(1).forEach((point, i) => {
    const near = nearer(point, eye);
    if (pieces.at(-1)?.near !== near) pieces.push({ near, places: [project(points[i])] });
    pieces.at(-1).places.push(project(point));
  });
  for (const { near, places } of pieces) line(context, places, { ...style, width: near ? width : width / 2 });
}

/** The sphere: its level circle, the meridians through the first two axes, and names round it. */
export function globe(context, view, colours, size, { radius = 1, names = NAMES, taken } = {}) {
  const circles = [arcOf(NORTH, EAST), arcOf(NORTH, DOWN), arcOf(EAST, DOWN)];
  circles.forEach((circle, i) => {
    const points = circle.map((point) => scaled(point, radius));
    path(context, view, points, { colour: colours(i === 0 ? "muted" : "shade"), width: 1.2 });
  });
  namesRound(context, view, colours, size, { radius, names, taken });
}

/** Those names alone. */
export function namesRound(context, view, colours, size, { radius = 1, names = NAMES, taken }) {
  names.forEach(([name, direction]) =>
    label(context, [name], view.project(scaled(direction, 1.13 * radius)), {
      colour: colours("muted"), rim: colours("page"), size: 12, width: size.width, taken,
    }),
  );
}

/** The aircraft at the centre, in an attitude given as a matrix from the inertial frame. */
export function flown(context, view, matrix, colours, size = 1) {
  paint(context, [], view, [], aircraftIn(view, matrix, colours, size));
}

/** The same as a body to `paint`. */
export function aircraftIn(view, matrix, colours, size = 1) {
  const fills = Object.fromEntries(["body", "glass", "x", "y", "z"].map((name) => [name, parsed(colours(name))]));
  return { tree: aircraft(fills), view: viewIn(view, matrix, size) };
}

/** Where a name of so many letters stands beyond the end of an arrow, clear of its head and of the ring round what is held. */
export function beyond([x0, y0], [x1, y1], letters = 1, held = false) {
  const length = Math.hypot(x1 - x0, y1 - y0);
  const [right, down] = length < 1 ? [0, -1] : [(x1 - x0) / length, (y1 - y0) / length];
  const off = held ? 10 : 0;
  return [x1 + (6 + off + 4 * letters) * right, y1 + (11 + off) * down];
}

/**
 * An arrow from the centre, or from another point, with a name beyond its end, in a picture of the size `room`.
 * What is held ends at the ring round its end, where no name is put.
 */
export function pointer(context, view, end, { name, from = [0, 0, 0], colour, colours, room, taken, held, ...style }) {
  const [start, tip] = [from, end].map(view.project);
  const whole = Math.hypot(tip[0] - start[0], tip[1] - start[1]);
  const part = held ? Math.max(0, 1 - RING / whole) : 1;
  const drawn = start.map((value, i) => value + part * (tip[i] - value));
  arrow(context, start, drawn, { colour: colours(colour), width: 3, ...style });
  if (name)
    label(context, name, beyond(start, tip, name.join("").length, held), {
      colour: colours(colour), rim: colours("page"), size: 13, ...room, taken,
    });
  if (held) taken.push({ x: tip[0], y: tip[1], half: RING, high: RING });
}

/**
 * What holds a direction of this length by its end: `part([yaw, pitch])`, in degrees, is what becomes of the
 * state. It stays on its side of the sphere, near or far, and at the rim where the pointer goes beyond.
 */
export function directed(view, end, part) {
  const far = !nearer(end, view.eye);
  const [radius, away] = [Math.hypot(...end), Math.hypot(...view.eye)];
  const hold = () => (place) => {
    const ray = view.ray(place);
    const length = Math.hypot(...ray);
    const along = -(ray[0] * view.eye[0] + ray[1] * view.eye[1] + ray[2] * view.eye[2]) / length;
    const half = Math.sqrt(Math.max(0, radius * radius - away * away + along * along));
    const [north, east, down] = sum(view.eye, scaled(ray, (along + (far ? half : -half)) / length));
    return part([Math.atan2(east, north), Math.atan2(-down, Math.hypot(north, east))].map((angle) => Math.round(angle / DEGREE)));
  };
  return { at: view.project(end), hold };
}

/** Where the nose points at a yaw and a pitch in degrees: a direction by two angles. */
export const direction = (yaw, pitch) => toParent(matrixFromEuler(0, pitch * DEGREE, yaw * DEGREE), NORTH);
