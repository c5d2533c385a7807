/** What the detective says in words of what it found. */
import { SYSTEMS } from "./converting.js";
import { readAs, signSlips } from "./detective_search.js";
import { node } from "./parts.js";
import { exactly } from "./writing.js";

export const LABELS = {
  angles: "Three angles", matrix: "Matrix, row by row", quaternion: "Quaternion",
  accel: "Accelerometer at rest, any unit", vectors: "A vector before, and the same after the turn",
};
const ANGLES = ["α", "β", "γ"]; // as they are written
const unitWords = ({ degrees }) => (degrees ? "degrees" : "radians");
const WORDS = { n: "north", s: "south", e: "east", w: "west", u: "up", d: "down", f: "forward", b: "back", l: "left", r: "right" };

const axesWords = (names) => names.map((letters) => [...letters].map((letter) => WORDS[letter]).join("-")).join(" and ");
export const rowsOf = (values, size) => Array.from({ length: values.length / size }, (_, i) => values.slice(size * i, size * (i + 1)));
const degreesOf = (error) => `${Number(((error * 180) / Math.PI).toPrecision(2))}°`;

/** What a convention says of a kind of numbers, in words. */
export function meaningOf(kind, convention) {
  const { sequence, written, negated, scalar_first, quaternion, product, matrix, row_vectors, vectors, accelerometer } = convention;
  const way = (to) => (to === "to body" ? "from navigation to body" : "from body to navigation");
  if (kind === "angles") {
    const turns = `${sequence}, about ${sequence === sequence.toUpperCase() ? "rotating" : "fixed"} axes`;
    return `${turns}${written ? `, but written in the order ${[...written].join(", ")}` : ""}${negated ? `, with those about ${[...negated].join(" and ")} counted the other way` : ""}, in ${unitWords(convention)}`;
  }
  if (kind === "matrix") return `${way(matrix)}${row_vectors ? ", vectors as rows to its left" : ""}`;
  if (kind === "quaternion") return `${scalar_first ? "w, x, y, z" : "x, y, z, w"}; ${way(quaternion)}, ${product === "JPL" ? "JPL's product" : "Hamilton's product"}`;
  if (kind === "vectors") return way(vectors);
  return accelerometer < 0 ? "specific force: the upward push, so −g along a z that points down" : "g along z of the room";
}

/** Known systems that write a kind so. */
function systemsOf(kind, match) {
  const { convention } = match;
  const read = { ...readAs(convention), turns: turnsOf(convention) };
  const same = (system) =>
    kind === "angles" ? turnsOf(system) === read.turns
    : kind === "matrix" ? system.transposed === read.transposed
    : system.scalarFirst === read.scalarFirst && system.conjugated === read.conjugated;
  const inAxes = ({ axes }) => match.axes === null || axes.join() === match.axes[kind].join();
  return Object.values(SYSTEMS).filter((system) => inAxes(system) && same(system)).map(({ label }) => label);
}

/** The turns as a product of matrices: of each its axis, the place of its angle, and the sign. */
export function productOf(convention) {
  const { sequence } = convention;
  const { order, signs } = readAs(convention);
  const factors = [...sequence.toLowerCase()].map((axis, i) => ({ axis, place: order[i], sign: signs[i] }));
  return sequence === sequence.toUpperCase() ? factors : factors.reverse();
}

const productWords = (convention) =>
  productOf(convention).map(({ axis, place, sign }) => `R${axis}(${sign < 0 ? "−" : ""}${ANGLES[place]})`).join("·");

const isTransposed = (convention) => readAs(convention).transposed;

/** The turns about rotating axes, and where each is written. */
function turnsOf({ sequence, ...read }) {
  const { order, signs } = read.order ? read : readAs({ sequence, ...read });
  const turns = [...sequence.toLowerCase()].map((letter, i) => letter + order[i] + signs[i]);
  return (sequence === sequence.toUpperCase() ? turns : turns.reverse()).join();
}

export function matchParts(match, kinds) {
  const lines = kinds.map((kind) => {
    const axes = match.axes ? `; in ${axesWords(match.axes[kind])}` : "";
    const names = ["angles", "matrix", "quaternion"].includes(kind) ? systemsOf(kind, match) : [];
    const more = {
      angles: `. R = ${productWords(match.convention)}, with α, β, γ as written, each factor a turn of vectors, leads from body to navigation`,
      matrix: isTransposed(match.convention) ? ". Your matrix is the transpose of the one from navigation to body" : "",
    };
    return node("li", {}, node("b", {}, LABELS[kind].split(",")[0]), `: ${meaningOf(kind, match.convention)}${axes}${names.length > 0 ? ` — as ${names.join(", ")}` : ""}${more[kind] ?? ""}.`);
  });
  const others = match.others.map((each) => node("li", {}, kinds.map((kind) => meaningOf(kind, each)).join("; ")));
  return [
    node("ul", {}, ...lines),
    node("p", {}, `They agree within ${degreesOf(match.error)}.`),
    ...(others.length > 0 ? [node("details", {}, node("summary", {}, `The same numbers, described otherwise: ${others.length}`), node("ul", {}, ...others))] : []),
  ];
}

const listed = (values) => values.map((value) => exactly(Number(value.toFixed(4)))).join(", ");

export function exampleOf(matches, kinds) {
  if (matches.length < 2) return [];
  const [{ example }] = matches;
  if (example === null) return [node("p", {}, "No single further attitude decides: give another example.")];
  const [given, ...asked] = Object.keys(example);
  const { ask, read } = askedWords(matches, kinds, `${given} ${listed(example[given])}`);
  const rows = matches.map((match, i) =>
    node("li", {}, `Answer ${i + 1}${read(match)}: ${asked.map((kind) => `${kind} ${listed(match.example[kind])}`).join("; ")}`));
  return [node("p", {}, `To decide, ask your programs for ${ask}. They would say:`), node("ul", {}, ...rows)];
}

/** What to ask for, and in which unit each answer takes it: one for all, or each its own. */
export function askedWords(matches, kinds, angles) {
  if (!kinds.includes("angles")) return { ask: "a further attitude", read: () => "" };
  const units = new Set(matches.map(({ convention }) => unitWords(convention)));
  return units.size === 1
    ? { ask: `${angles} ${[...units][0]}`, read: () => "" }
    : { ask: `${angles} in their own unit`, read: ({ convention }) => `, in ${unitWords(convention)}` };
}

/** How many answers there are, and what speaks against them. */
export function verdictOf(matches, given, degrees) {
  const words = matches.length === 1 ? "One answer" : `${matches.length} answers, the simplest first`;
  const conditions = [
    ...(matches.every(({ axes }) => axes !== null) ? ["the programs use different axes"] : []),
    ...(matches.every(({ convention }) => convention.written) ? ["the angles stand in another order than that of their turns"] : []),
    ...(matches.every(({ convention }) => convention.negated) ? ["some angles count the other way"] : []),
  ];
  if (conditions.length === 0) return `${words}.`;
  const found = signSlips(given, degrees).map(({ kind, place }) => `of number ${place + 1} of the ${kind}`);
  const other = found.length > 0 ? ` A single wrong sign would explain the numbers too, in the same axes: that ${found.join(", or ")}.` : "";
  return `${words}, but ${matches.length === 1 ? "it holds" : "they hold"} only if ${conditions.join(" and ")}.${other}`;
}
