/** An attitude as lines of a program, or of a paper: what "Copy as" copies. */
import { quaternionFromMatrix } from "../generated/javascript/attitude.mjs";
import { SYSTEMS, turnNames } from "./converting.js";

/** The shortest text that a double is read back from; minus zero is zero. */
export const exactly = (value) => String(value + 0);

const listed = (values) => values.map(exactly).join(", ");
const rowsOf = (matrix) => [0, 3, 6].map((i) => matrix.slice(i, i + 3));
const unitOf = ({ degrees }) => (degrees ? "degrees" : "radians");

const DIGITS = 15; // all that survive a few operations in doubles
const DECIMALS = 8; // what leaves the three numbers of a row beside each other on a phone
const NOISE = 4e-16; // of the largest number: less than the last digit of that

/** Numbers to show: without the noise of the last digits, and on a narrow screen with fewer. */
export function shown(values, kind, narrow = false) {
  const size = Math.max(...(kind === "axis angle" ? values.slice(0, 3) : values).map(Math.abs));
  const short = (value) => (Math.abs(value) < 1e-6 ? value.toPrecision(3) : value.toFixed(DECIMALS));
  return values.map((value) => {
    const digits = narrow ? short(value) : value.toPrecision(DIGITS);
    return exactly(Math.abs(value) < NOISE * size ? 0 : Number(digits));
  });
}

/** What a convention's values mean, in a few words each. */
export const meanings = (convention) => ({
  angles: `${turnNames(convention).join(", ")}, ${unitOf(convention)}`,
  quaternion: convention.scalarFirst ? "w, x, y, z" : "x, y, z, w",
  matrix: convention.transposed ? "from body to navigation" : "from navigation to body",
  "axis angle": `x, y, z, and the angle in ${unitOf(convention)}`,
});

/** A convention in Python: the name of a system, or one that is changed. */
function inPython({ name, sequence, degrees }) {
  const own = SYSTEMS[name];
  const changes = [
    ...(sequence === own.sequence ? [] : [`sequence="${sequence}"`, 'written=""', 'negated=""']),
    ...(degrees === own.degrees ? [] : [`degrees=${degrees ? "True" : "False"}`]),
  ];
  const table = own.documented ? "DOCUMENTED" : "PRESETS";
  return changes.length === 0 ? [`"${name}"`] : [`replace(${table}["${name}"], ${changes.join(", ")})`, table];
}

function python({ kind, value, source, target }) {
  const [[from, one], [to, other]] = [source, target].map(inPython);
  const tables = [...new Set([one, other])].filter(Boolean).sort();
  const given = kind === "matrix" ? `[${rowsOf(value).map((row) => `[${listed(row)}]`).join(", ")}]` : `[${listed(value)}]`;
  return [
    ...(tables.length > 0 ? ["from dataclasses import replace", ""] : []),
    "import chr_notes",
    ...(tables.length > 0 ? [`from chr_notes.systems.convention import ${tables.join(", ")}`] : []),
    "",
    `source, target = ${from}, ${to}`,
    `given = ${given}`,
    "converted = {",
    `    to: chr_notes.convert(given, source, target, kind="${kind}", to=to)`,
    '    for to in ("angles", "quaternion", "axis angle", "matrix")',
    "}",
  ].join("\n");
}

/**
 * SciPy's rotations turn vectors as the body has turned, have the scalar last, and write the angles in
 * the order of the turns: what the target has otherwise is said behind each call.
 */
function scipy({ matrix, target }) {
  const means = meanings(target);
  const [a, ...vector] = quaternionFromMatrix(...matrix);
  const places = [0, 1, 2].map((place) => target.order.indexOf(place));
  const signs = places.map((place) => target.signs[place]);
  const turns = [
    `rotation.as_euler("${target.sequence}", degrees=${target.degrees ? "True" : "False"})`,
    ...(places.join() === "0,1,2" ? [] : [`[[${places.join(", ")}]]`]),
    ...(signs.some((sign) => sign < 0) ? [` * [${signs.join(", ")}]`] : []),
  ];
  const q = [
    "rotation.as_quat()",
    ...(target.conjugated ? [" * [-1, -1, -1, 1]"] : []),
  ].join("");
  const rolled = target.conjugated ? `(${q})` : q;
  return [
    "from scipy.spatial.transform import Rotation",
    "",
    `# Takes components from the body's axes to the room's, both those of ${target.label}.`,
    `rotation = Rotation.from_quat([${listed([...vector, a])}])`,
    `angles = ${turns.join("")}  # ${means.angles}`,
    `quaternion = ${target.scalarFirst ? `${rolled}[[3, 0, 1, 2]]` : q}  # ${means.quaternion}`,
    `matrix = rotation.as_matrix()${target.transposed ? "" : ".T"}  # ${means.matrix}`,
  ].join("\n");
}

const constants = (declared, [open, close], [start, end]) => ({ converted, target }) => {
  const means = meanings(target);
  const line = (name, sizes, text, kind) => `${declared(name, sizes)} = ${text}; ${start}${target.label}: ${means[kind]}${end}`;
  const flat = (values) => `${open}${listed(values)}${close}`;
  return [
    line("angles", "[3]", flat(converted.angles), "angles"),
    line("quaternion", "[4]", flat(converted.quaternion), "quaternion"),
    line("axis_angle", "[4]", flat(converted["axis angle"]), "axis angle"),
    line("matrix", "[3][3]", `${open}${rowsOf(converted.matrix).map(flat).join(", ")}${close}`, "matrix"),
  ].join("\n");
};

const inLatex = (value) => exactly(value).replace(/e\+?(-?\d+)$/, " \\cdot 10^{$1}");

function latex({ converted, target }) {
  const means = meanings(target);
  const column = (values) => `\\begin{pmatrix} ${values.map(inLatex).join(" \\\\ ")} \\end{pmatrix}`;
  return [
    `% ${target.label}: the matrix ${means.matrix}; the quaternion ${means.quaternion}`,
    `R = \\begin{pmatrix} ${rowsOf(converted.matrix).map((row) => row.map(inLatex).join(" & ")).join(" \\\\ ")} \\end{pmatrix}`,
    `q = ${column(converted.quaternion)}`,
  ].join("\n");
}

/**
 * How to write { kind, value, source, target, matrix, converted }: the matrix from navigation to body
 * in the target's axes, and what it says by kind.
 */
export const LANGUAGES = {
  Python: python,
  SciPy: scipy,
  C: constants((name, sizes) => `const double ${name}${sizes}`, ["{", "}"], ["/* ", " */"]),
  JavaScript: constants((name) => `const ${name}`, ["[", "]"], ["// ", ""]),
  LaTeX: latex,
};
