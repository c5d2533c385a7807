/** Numbers out of a text, in whatever notation it has: what people copy from programs and papers. */

const NUMBER = String.raw`(?:\d+\.?\d*|\.\d+)(?:[eEdD][-+]?\d+)?`;
const ROOT = String.raw`(?:sqrt\(?\s*|√\(?)${NUMBER}\)?`;
const TURN = String.raw`(?:pi(?!\p{L})|π)`;
const FACTOR = String.raw`(?:${NUMBER}(?:${ROOT}|${TURN})?|${ROOT}|${TURN})`;
const SIGN = String.raw`[-+][^\S\n]*`;
// A digit within a name, such as float64 or q0, is no number; after a sign it is one.
const TERM = new RegExp(String.raw`(?:${SIGN}|(?<![\p{L}\p{N}_.]))(${FACTOR}(?:[*/]${FACTOR})*)([ijk](?![\p{L}\p{N}_]))?`, "gu");
const LABEL = /(?<![\p{L}\p{N}])q?_?([wxyz]|roll|pitch|yaw)["']?\s*[:=]\s*$/iu;
const UNITS = { i: "x", j: "y", k: "z" };

const factorOf = (text) => {
  const root = text.match(/^(.*?)(?:sqrt\(?\s*|√\(?)(.+?)\)?$/);
  if (root) return factorOf(root[1] || "1") * Math.sqrt(Number(root[2].replace(/d/i, "e")));
  const turn = text.match(/^(.*)(?:pi|π)$/);
  if (turn) return factorOf(turn[1] || "1") * Math.PI;
  return Number(text.replace(/d/i, "e"));
};

const termOf = (text) => {
  const [first, ...others] = text.split(/([*/])/);
  let value = factorOf(first);
  for (let i = 0; i < others.length; i += 2) value = others[i] === "*" ? value * factorOf(others[i + 1]) : value / factorOf(others[i + 1]);
  return value;
};

function plain(text) {
  const signs = text
    .replace(/[−–—‒﹣－]/g, "-")
    .replace(/[\u00a0\u2000-\u200b\u202f\u2060]/g, " ")
    .replace(/(?<=[\p{L}_\]])\[\d+\]/gu, ""); // sizes and indices of arrays
  // A list with a dash before each of its lines is no list of negative numbers.
  const lines = signs.split("\n").filter((line) => line.trim() !== "");
  const isList = lines.length > 2 && lines.every((line) => /^\s*- /.test(line));
  return isList ? lines.map((line) => line.replace("- ", "")).join("\n") : signs;
}

function terms(text) {
  return [...text.matchAll(TERM)].map((found) => {
    const [whole, term, unit] = found;
    const label = text.slice(0, found.index).match(LABEL)?.[1].toLowerCase();
    return { value: termOf(term) * (whole.startsWith("-") ? -1 : 1), label: unit ? UNITS[unit] : label };
  });
}

/**
 * The numbers of a text: { values, labels }, the labels those of a quaternion's parts or of angles
 * where each number has one (w: 0.9, x: …; 0.9 + 0.1i …; roll = …), or null. A comma counts as the
 * decimal sign where it must: with no point in the text, and something else between the numbers.
 */
export function numbersIn(text) {
  const clean = plain(text);
  const decimal = !/\.|,\s|,-|\d,\d+,/.test(clean) && /\d,\d+\s*[\s;]/.test(clean);
  const found = terms(decimal ? clean.replace(/(\d),(?=\d)/g, "$1.") : clean);
  const values = found.map(({ value }) => value);
  const labels = found.map(({ label }) => label ?? "");
  const units = labels.filter((label) => label !== "").length;
  // In a + bi + cj + dk the scalar has no unit.
  if (values.length === 4 && units === 3 && !labels.includes("w")) labels[labels.indexOf("")] = "w";
  const named = new Set(labels).size === labels.length && !labels.includes("");
  return { values, labels: named ? labels : null };
}

/** Nine of sixteen numbers: the rotation in a 4 by 4 matrix, its last row or column 0, 0, 0, 1. */
export function rotationIn(values) {
  const ends = (places) => places.every((place, i) => values[place] === (i === 3 ? 1 : 0));
  const is = values.length === 16 && (ends([12, 13, 14, 15]) || ends([3, 7, 11, 15]));
  return is ? [0, 1, 2, 4, 5, 6, 8, 9, 10].map((place) => values[place]) : values;
}
