/** What the converter says in words of a state. */
import { computed } from "./converter_state.js";
import { shown } from "./writing.js";

export const SHOWN_DIGITS = { wide: "15 significant digits", narrow: "8 decimals" };

/** The values of a kind as a text, a matrix in three rows. */
export function asText(kind, values, narrow = false) {
  const texts = shown(values, kind, narrow);
  return kind === "matrix" ? [0, 3, 6].map((i) => texts.slice(i, i + 3).join(", ")).join("\n") : texts.join(", ");
}

const axesWords = ({ room, along }) => `${room.join("-")} and ${along.join("-")}`;

/** What two conventions have not in common, a sentence each. */
export function differences(source, target) {
  const way = ({ transposed }) => (transposed ? "from body to navigation" : "from navigation to body");
  const place = ({ scalarFirst }) => (scalarFirst ? "first" : "last");
  const unit = ({ degrees }) => (degrees ? "degrees" : "radians");
  const turns = ({ sequence, signs }) => [sequence, ...[...sequence.toLowerCase()].filter((letter, i) => signs[i] < 0).map((letter) => `${letter} the other way`)].join(", ");
  const leads = ({ conjugated }) => (conjugated ? "conjugate" : "plain");
  const differ = (by, words) => (by(source) === by(target) ? [] : [words]);
  return [
    ...differ(axesWords, `Axes: ${axesWords(source)} become ${axesWords(target)}.`),
    ...differ(way, `The matrix leads ${way(source)} in one, ${way(target)} in the other.`),
    ...differ(leads, "The quaternions of one are the conjugates of the other's."),
    ...differ(place, `The scalar part stands ${place(source)} in one, ${place(target)} in the other.`),
    ...differ(turns, `The angles are ${turns(source)} in one, ${turns(target)} in the other.`),
    ...differ(unit, `Angles in ${unit(source)} become ${unit(target)}.`),
  ];
}

/** How far from the lock, in words. */
export function lockWords({ locked, fromLock }) {
  if (locked) return "At the lock: the first and the third turn go about one line. The last turn is set to 0, the other carries the rest.";
  if (fromLock < 1) return `${Number(fromLock.toPrecision(3))}° from the lock: a small error of the attitude is a large one of the outer angles.`;
  return `${Number(fromLock.toFixed(2))}° from the lock.`;
}

const OPPOSITE = { north: "south", south: "north", east: "west", west: "east" };

/** Where the body looks that has not turned in the room of a convention. */
function facing({ room, along }) {
  const ahead = along.findIndex((word) => word === "forward" || word === "back");
  return along[ahead] === "forward" ? room[ahead] : OPPOSITE[room[ahead]];
}

/** Where no turn is another attitude for each system, and what to choose if it should not be. */
export function noTurnWords(source, target) {
  const [one, other] = [source, target].map(facing);
  if (one === other) return "";
  const local = [source, target].some(({ name }) => name === "ROS")
    ? " A robot's own frame (odom, map) has no east: x is ahead from where it started. For that choose ROS (local frame)."
    : "";
  return `No turn faces ${one} in ${source.label}, ${other} in ${target.label}.${local}`;
}

/** The other triples of angles, in words. */
export function triplesWords({ triples: [, ...others], locked }, { degrees }, narrow) {
  const whole = degrees ? "360°" : "2π";
  if (locked) return `any two outer angles that make the same turn together, and ${whole} more or less of any angle`;
  return `${others.map((angles) => asText("angles", angles, narrow)).join(" or ")}; and ${whole} more or less of any angle`;
}

/** What is announced when a state has come to rest: both sides, as a control may change one alone. */
export function summary(state) {
  const { source, target, here, there } = computed(state);
  const short = (values) => values.map((value) => Number(value.toFixed(4))).join(", ").replaceAll("-", "−");
  const side = ({ label, degrees }, { angles, quaternion }) =>
    `${label}: angles ${short(angles)}, ${degrees ? "degrees" : "radians"}, quaternion ${short(quaternion)}.`;
  return `From ${side(source, here)} To ${side(target, there)} ${lockWords(there)}`;
}
