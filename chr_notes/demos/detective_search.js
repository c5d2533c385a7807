/**
 * Which conventions explain what two programs say of one rotation, as `chr_notes.find_conventions`
 * does it in Python: the same candidates, from Python's table, in the same order.
 */
import { inAxesOf, matrixOfTurns, fromMatrix, toBody } from "./converting.js";
import { toChild, transposed } from "./draw.js";
import { nearestRotation } from "./nearest.js";

/* global DETECTIVE: build.py puts in what chr_notes/demos/detective.py has of Python's tables */

const { fields: FIELDS, plain, reordered, signed, named, kept, axes: AXES, tried, generic, own, rounds, shapes, ordinals, tolerance } = DETECTIVE;
const [DEGREE, ATTITUDES] = [Math.PI / 180, ["angles", "matrix", "quaternion"]];
const IDENTITY = [1, 0, 0, 0, 1, 0, 0, 0, 1];

export const KINDS = Object.keys(shapes);

/** What is wrong with what is given, for the reader, and in which example. */
class Misfit extends Error {
  constructor(message, place = null) {
    super(message);
    this.place = place;
  }
}

const theExample = (place) => (place < ordinals.length ? `the ${ordinals[place]} example` : `example ${place + 1}`);

/** Some fields of a convention, as converting.js reads it. */
export function readAs(fields) {
  const { sequence, written, negated, matrix, row_vectors, quaternion, product, ...other } = { ...own, ...fields };
  return {
    ...other, sequence,
    order: written ? [...sequence.toLowerCase()].map((letter) => written.indexOf(letter)) : [0, 1, 2],
    signs: [...sequence.toLowerCase()].map((letter) => (negated.includes(letter) ? -1 : 1)),
    transposed: (matrix === "to navigation") !== row_vectors,
    scalarFirst: other.scalar_first,
    conjugated: (quaternion === "to body") !== (product === "JPL"),
  };
}

const candidates = (kind, units, wide) => {
  if (kind !== "angles") return FIELDS[kind];
  const each = (names) => [false, true].filter((degrees) => units.includes(degrees)).flatMap((degrees) => names.map((turns) => ({ ...turns, degrees })));
  return [...each(plain.map((sequence) => ({ sequence }))), ...(wide ? [...each(reordered), ...each(signed)] : [])];
};

// ── what is given ───────────────────────────────────────────────────────────────────────────

const norm = (values) => Math.hypot(...values);

function rounding(kind, rows) {
  const values = rows.flat();
  let unit = 10 ** -rounds.most_decimals;
  for (let decimals = 0; decimals < rounds.most_decimals; decimals++) {
    const size = 10 ** decimals;
    if (values.every((value) => Math.abs(value - Math.round(value * size) / size) < 1e-9 / size)) {
      unit = 1 / size;
      break;
    }
  }
  if (kind === "angles") return 1.5 * unit;
  return (rounds.sizes[kind] * unit) / Math.max(Math.min(...rows.map(norm)), unit);
}

function rotationOf(matrix, place, rounded) {
  const nearest = nearestRotation(matrix);
  if (nearest === null) throw new Misfit(`matrix: expected rotations, got a reflection in ${theExample(place)}`, place);
  const size = nearest.reduce((total, value, i) => total + value * matrix[i], 0) / 3; // by least squares
  const off = nearest.map((value, i) => Math.abs(matrix[i] / size - value));
  // Digits may be cut off instead of rounded.
  if (norm(off) > 2 * rounded + tolerance)
    throw new Misfit(`matrix: expected rotations, but ${theExample(place)} is none: its elements are off the nearest one by up to ${Math.max(...off).toFixed(4)}, more than by its digits`, place);
  return nearest;
}

function unitOf(kind, row, place, rounded) {
  if (kind === "angles") return row;
  if (kind === "matrix") return rotationOf(row, place, rounded);
  const parts = kind === "vectors" ? [row.slice(0, 3), row.slice(3)] : [row];
  if (parts.some((part) => norm(part) === 0)) throw new Misfit(`${kind}: expected no row of zeros, got one`);
  return parts.flatMap((part) => part.map((value) => value / norm(part)));
}

function examplesOf(given) {
  const kinds = KINDS.filter((kind) => given[kind]);
  if (kinds.length < 2 || kinds.every((kind) => ["accel", "vectors"].includes(kind)))
    throw new Misfit("expected two or more of them, one an attitude");
  const counts = kinds.map((kind) => given[kind].length);
  if (new Set(counts).size > 1 || counts.includes(0)) throw new Misfit(`expected as many examples of each, got ${counts.join(", ")}`);
  const off = Object.fromEntries(kinds.map((kind) => [kind, rounding(kind, given[kind])]));
  return {
    kinds, count: counts[0],
    values: Object.fromEntries(kinds.map((kind) => [kind, given[kind].map((row, i) => unitOf(kind, row, i, off[kind]))])),
    rounding: off,
  };
}

const onlyOf = (given, kinds) => ({ ...given, kinds, values: Object.fromEntries(kinds.map((kind) => [kind, given.values[kind]])) });
const oneOf = (given, i) => ({ ...given, count: 1, values: Object.fromEntries(given.kinds.map((kind) => [kind, [given.values[kind][i]]])) });
const knowsTheBody = ({ kinds }) => kinds.includes("angles") || kinds.includes("accel");

// ── the search ──────────────────────────────────────────────────────────────────────────────

/** Angle of the turn between two matrices, or between two unit vectors; thousands are compared. */
function angleBetween(one, other, most) {
  let total = 0;
  for (let i = 0; i < one.length; i++) total += (one[i] - other[i]) * (one[i] - other[i]);
  return 2 * Math.asin(Math.min(Math.sqrt(total) / most, 1));
}

/** The largest angle between what programs say, and how large it may be. */
function turnedApart(given, fields, attitudes) {
  const [first, ...others] = attitudes;
  const { vectors, accel } = given.values;
  let error = 0;
  for (let i = 0; i < first.length; i++) {
    for (const other of others) error = Math.max(error, angleBetween(first[i], other[i], Math.sqrt(8)));
    if (vectors) error = Math.max(error, angleBetween(toChild(fields.vectors === "to body" ? first[i] : transposed(first[i]), vectors[i].slice(0, 3)), vectors[i].slice(3), 2));
    if (accel) error = Math.max(error, angleBetween([2, 5, 8].map((k) => fields.accelerometer * first[i][k]), accel[i], 2));
  }
  let allowed = rounds.least_error;
  for (const kind of given.kinds)
    allowed += Math.min(kind === "angles" && fields.degrees ? given.rounding[kind] * DEGREE : given.rounding[kind], rounds.most_error);
  return [error, allowed];
}

const inOwn = (axes) => ({ navigation: IDENTITY, body: IDENTITY, ...axes });
const changed = (matrix, from, to) => inAxesOf(matrix, inOwn(from), inOwn(to));
const ONE = { usual: {}, kind: "", other: {} };

/** All ways in which one kind may be in other axes than the rest, each relation once. */
function otherAxes({ kinds }) {
  const attitudes = kinds.filter((kind) => ATTITUDES.includes(kind));
  if (attitudes.length < Math.max(2, kinds.length)) return [];
  return (attitudes.length === 2 ? attitudes.slice(1) : attitudes).flatMap((kind) => {
    const seen = new Set();
    return AXES.flatMap((usual) => AXES.map((other) => ({ usual, kind, other }))).filter(({ usual, other }) => {
      const turns = { sequence: "xyz" };
      // What becomes of no turn and of one turn tells the relation.
      const relation = [IDENTITY, matrixOfTurns([0.1, 0.2, 0.3], turns.sequence)].map((matrix) => changed(matrix, other, usual).map((value) => Math.round(1e6 * value) + 0)).join();
      if (usual === other || seen.has(relation)) return false;
      return seen.add(relation);
    });
  });
}

function* product(lists) {
  if (lists.length === 0) yield [];
  else for (const first of lists[0]) for (const rest of product(lists.slice(1))) yield [first, ...rest];
}

const matches = (fields, choices) => choices.some((choice) => Object.keys(fields).every((name) => choice[name] === fields[name]));

/** Each convention, simplest first, with its error and how large that may be. */
function* judged(given, units, wide) {
  const readings = given.kinds.map((kind) =>
    candidates(kind, units, wide).map((fields) => ({
      kind, fields,
      attitude: ATTITUDES.includes(kind) ? given.values[kind].map((value) => toBody(value, readAs(fields), kind)) : null,
    })));
  for (const axes of wide ? [ONE, ...otherAxes(given)] : [ONE]) {
    const free = knowsTheBody(given) || axes !== ONE ? null : given.kinds[0];
    const choices = readings.map((each) => each
      .filter(({ kind, fields }) => kind !== free || matches(fields, named))
      .map((reading) => reading.kind === axes.kind ? { ...reading, attitude: reading.attitude.map((matrix) => changed(matrix, axes.other, axes.usual)) } : reading));
    for (const chosen of product(choices)) {
      const fields = Object.assign({}, ...chosen.map((each) => each.fields));
      const [error, allowed] = turnedApart(given, fields, chosen.map((each) => each.attitude).filter(Boolean));
      yield { fields, error, allowed, axes };
    }
  }
}

function whatDoesNotFit(given, units) {
  const all = (some) => [...judged(some, units, true)];
  for (let i = 0; given.count > 1 && i < given.count; i++)
    if (!all(oneOf(given, i)).some(({ error, allowed }) => error <= allowed))
      return `expected examples of one rotation each, but no convention explains ${theExample(i)}`;
  for (const [i, one] of given.kinds.entries())
    for (const other of given.kinds.slice(i + 1)) {
      if ([one, other].every((kind) => ["accel", "vectors"].includes(kind))) continue;
      const least = all(onlyOf(given, [one, other])).reduce((best, each) => (each.error - each.allowed < best.error - best.allowed ? each : best));
      if (least.error > least.allowed)
        return `expected ${one} and ${other} of one rotation, but under every convention they are at least ${Number((least.error / DEGREE).toPrecision(3))}° apart`;
    }
  return "expected one convention for all examples; each pair by itself has some, but not all one";
}

// ── what is found ───────────────────────────────────────────────────────────────────────────

const opposite = (way) => (way === "to body" ? "to navigation" : "to body");

/** The other descriptions with the same numbers. */
function othersOf(convention, given) {
  const same = (c) => c;
  const ways = [
    ...(given.kinds.includes("matrix") ? [[same, (c) => ({ ...c, matrix: opposite(c.matrix), row_vectors: true })]] : []),
    ...(given.kinds.includes("quaternion") ? [[same, (c) => ({ ...c, quaternion: opposite(c.quaternion), product: "JPL" })]] : []),
    ...(knowsTheBody(given) ? [] : [[same, (c) => ({ ...c, matrix: opposite(c.matrix), quaternion: opposite(c.quaternion), vectors: opposite(c.vectors) })]]),
  ];
  return [...product(ways)].slice(1).map((each) => each.reduce((c, way) => way(c), convention));
}

/** What each program would say of one attitude. */
function saidOf({ convention, relation }, given, turns) {
  const made = {};
  const read = readAs(convention);
  const usual = (matrix, kind, back) => {
    if (kind !== relation.kind) return matrix;
    return back ? changed(matrix, relation.usual, relation.other) : changed(matrix, relation.other, relation.usual);
  };
  let attitude;
  if (given.kinds.includes("angles")) {
    made.angles = turns;
    attitude = usual(toBody(turns, read, "angles"), "angles", false);
  } else {
    attitude = matrixOfTurns(turns.map((angle) => angle * DEGREE), "xyz");
    const toBodyFirst = given.kinds[0] === "matrix" ? convention.matrix === "to body" : convention.quaternion === "to navigation";
    if (!toBodyFirst) attitude = transposed(attitude);
  }
  for (const kind of ["matrix", "quaternion"])
    if (given.kinds.includes(kind)) made[kind] = fromMatrix(usual(attitude, kind, true), read, kind);
  if (given.kinds.includes("vectors")) made.vectors = toChild(convention.vectors === "to body" ? attitude : transposed(attitude), [1, 2, 3]);
  if (given.kinds.includes("accel")) made.accel = [2, 5, 8].map((k) => convention.accelerometer * attitude[k]);
  return made;
}

const farthest = (one, other) => Math.max(...one.map((value, i) => Math.abs(value - other[i])));
const flat = (found, given, turns) => Object.values(saidOf(found, given, turns)).flat();

/** One match for what says the same of any attitude, and what decides between several. */
function toldApart(found, given) {
  const left = [];
  for (const match of found) {
    const said = flat(match, given, generic);
    const same = left.find((each) => farthest(each.said, said) < 1e-9);
    if (same) same.others.push(match.convention, ...match.others);
    else left.push({ ...match, said });
  }
  const decides = left.length > 1 && tried.find((turns) => {
    const all = left.map((each) => flat(each, given, turns));
    return all.every((one, i) => all.slice(0, i).every((other) => farthest(one, other) > 1e-2));
  });
  return left.map(({ convention, error, others, axes, ...each }) => ({
    convention, error, others, axes,
    example: decides ? saidOf({ convention, ...each }, given, decides) : null,
  }));
}

/**
 * The conventions under which programs say the same of { angles, matrix, quaternion, vectors, accel },
 * each a list of rows. Returns { matches }, as Python's, or { fault }, in words.
 */
export function findConventions(given, degrees = null) {
  try {
    const examples = examplesOf(given);
    const units = degrees === null ? [false, true] : [degrees];
    for (const wide of [false, true]) {
      const found = [...judged(examples, units, wide)].filter(({ error, allowed }) => error <= allowed);
      if (found.length === 0) continue;
      const plainness = ({ fields, axes }) => (axes === ONE ? 0 : 400) + (fields.negated ? 200 : 0) + (fields.written ? 100 : 0) + plain.indexOf({ ...own, ...fields }.sequence);
      const rank = ({ error, allowed }) => Math.round(1e9 * Math.max(error, kept * allowed));
      found.sort((a, b) => rank(a) - rank(b) || plainness(a) - plainness(b));
      return {
        matches: toldApart(found.map(({ fields, error, axes }) => {
          const { name } = axes.usual;
          const frames = axes === ONE ? {} : { navigation: name[0], body: name[1] };
          const convention = { ...own, ...fields, ...frames };
          const of = (kind) => (kind === axes.kind ? axes.other.name : name);
          return {
            convention, error, relation: axes, others: othersOf(convention, examples),
            axes: axes === ONE ? null : Object.fromEntries(examples.kinds.map((kind) => [kind, of(kind)])),
          };
        }), examples),
      };
    }
    return { fault: whatDoesNotFit(examples, units) };
  } catch (error) {
    if (error instanceof Misfit) return { fault: error.message, place: error.place };
    throw error;
  }
}

/** The numbers of angles or of a quaternion whose other sign would do in one pair of frames: { kind, place }. */
export function signSlips(given, degrees = null) {
  const units = degrees === null ? [false, true] : [degrees];
  const fits = (other) => [...judged(examplesOf(other), units, false)].some(({ error, allowed }) => error <= allowed);
  return ["angles", "quaternion"].filter((kind) => given[kind]).flatMap((kind) =>
    given[kind][0]
      .map((_, place) => ({ kind, place }))
      .filter(({ place }) => fits({ ...given, [kind]: given[kind].map((row) => row.map((value, i) => (i === place ? -value : value))) })));
}
