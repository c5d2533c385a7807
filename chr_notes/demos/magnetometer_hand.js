/**
 * A sensor that is turned by hand: its attitudes as a text, four letters each, that an address can
 * carry. The last one is where it is now; those before it have been read.
 */
import {
  eulerFromQuaternion,
  quaternionFromAxisAngle,
  quaternionFromEuler,
  quaternionMultiply,
  rotateToBody,
} from "../generated/javascript/attitude.mjs";
import { scaled, sum } from "./draw.js";

/* global MAGNETOMETER: build.py puts it in, from magnetometer.py */

const { field: FIELD, walk: MOST, letters: LETTERS, turn_in: TURN_IN, apart: APART } = MAGNETOMETER;
const [DEGREE, BY_POINTER] = [Math.PI / 180, 0.8]; // degrees a pixel

/** What a text of attitudes has to match. */
export const TURNED = new RegExp(`^([\\w-]{4}){0,${MOST}}$`);

/** The attitude of four letters, as a quaternion: yaw, pitch and roll by eight bits each. */
function decoded(code) {
  const bits = [...code].reduce((all, letter) => 64 * all + LETTERS.indexOf(letter), 0);
  const [yaw, pitch, roll] = [16, 8, 0].map((low, i) => (TURN_IN[i] * DEGREE * (((bits >> low) & 255) - 128)) / 256);
  return quaternionFromEuler(roll, pitch, yaw);
}

function encoded(q) {
  const [roll, pitch, yaw] = eulerFromQuaternion(...q);
  const bits = [yaw, pitch, roll].reduce((all, angle, i) => {
    const step = Math.round((256 * angle) / (TURN_IN[i] * DEGREE)) + 128;
    return 256 * all + (i === 1 ? Math.min(255, step) : step & 255);
  }, 0);
  return [18, 12, 6, 0].map((low) => LETTERS[(bits >> low) & 63]).join("");
}

export const attitudes = (turned) => (turned.match(/.{4}/g) ?? []).map(decoded);

export const fieldAt = (q) => rotateToBody(...q, ...FIELD);

/** Whether two attitudes give readings that are worth having both. */
function differ(one, other) {
  const [[a, b, c], [x, y, z]] = [fieldAt(one), fieldAt(other)];
  return a * x + b * y + c * z < Math.cos(APART * DEGREE) * Math.hypot(a, b, c) ** 2;
}

/** The text with the sensor in another attitude: a new reading once it has turned far enough. */
export function turnedTo(turned, q) {
  const read = turned.slice(0, -4);
  const last = read && decoded(read.slice(-4));
  const kept = !last || differ(last, q) ? turned : read;
  return (kept + encoded(q)).slice(-4 * MOST);
}

/** What turns the sensor with the pointer, as one would a ball: `view` has its axes on the screen. */
export function turning({ turned }, now, [, right, down]) {
  return (_, [x, y]) => {
    const axis = sum(scaled(down, -x), scaled(right, y));
    const far = Math.hypot(x, y);
    if (far === 0) return {};
    const q = quaternionMultiply(...quaternionFromAxisAngle(...scaled(axis, 1 / far), far * BY_POINTER * DEGREE), ...now);
    turned = turnedTo(turned, q);
    return { turned };
  };
}
