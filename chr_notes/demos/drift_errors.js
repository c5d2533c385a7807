/** What dead reckoning is off by after a time, and times and lengths in words. */
import { driftFromTiltError, positionAtLastVelocity, positionErrors } from "../generated/javascript/attitude.mjs";
import { formatted } from "./parts.js";

/* global NOTES_GRAVITY: build.py puts it in, m/s² */

const DEGREE = Math.PI / 180;
export const [FIRST, LAST] = [1, 3600]; // seconds
export const STEPS = 64; // of the slider; so many meet 10 s, 1 min and 10 min to two digits

/**
 * Errors in SI units after a time in seconds: of acceleration and velocity by the angle, of position
 * by each cause and by all together. `printed` is the position as the note reckons it.
 */
export function errorsAfter(time, { angle_error: angle, accel_bias: accel, gyro_bias: gyro, accel_noise: noise }) {
  const given = [angle * DEGREE, time, NOTES_GRAVITY];
  const [acceleration, velocity] = driftFromTiltError(...given);
  const [position, byAccel, byGyro, , variance] = positionErrors(angle * DEGREE, accel, gyro * DEGREE, 0, 0, noise, 0, time, NOTES_GRAVITY);
  return {
    acceleration, velocity, position, byAccel, byGyro,
    noise: Math.sqrt(variance), total: position + byAccel + byGyro, printed: positionAtLastVelocity(...given),
  };
}

/** A length with four digits, from ten kilometres on in kilometres. */
export const metres = (value) => (value < 1e4 ? `${formatted(value)} m` : `${formatted(value / 1000)} km`);

// How far from the table each begins to be left, metres.
export const PLACES = [[2.5, "the room"], [10, "the house"], [100, "the street"], [5e3, "the city"], [3e5, "the country"]];

export function placesLeft(metres) {
  const last = PLACES.findLast(([far]) => far < metres);
  return last ? `, out of ${last[1]}` : "";
}

/** A time in words, short and long. */
export function duration(time) {
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

/** A length in words, three digits and the unit, which no line parts. */
export function distance(metres) {
  const [value, unit] = metres < 1 ? [100 * metres, "cm"] : metres < 1000 ? [metres, "m"] : [metres / 1000, "km"];
  return `${Number(value.toPrecision(3))}\u00a0${unit}`;
}

export const SECONDS = {
  toPosition: (value) => (STEPS * Math.log(value / FIRST)) / Math.log(LAST / FIRST),
  toValue: (position) => Number((FIRST * (LAST / FIRST) ** (position / STEPS)).toPrecision(2)),
};
