/** An attitude as lines of a program, or of a paper: what "Copy as" copies. */
import { quaternionFromMatrix } from "../generated/javascript/attitude.mjs";
import { SYSTEMS, turnNames } from "./converting.js";

/** The shortest text that a double is read back from; minus zero is zero. */
export const exactly = (value) => String(value + 0);

const listed = (values) => values.map(exactly).join(", ");
const rowsOf = (matrix) => [0, 3, 6].map((i) => matrix.slice(i, i + 3));
const unitOf = ({ degrees }) => (degrees ? "degrees" : "radians");

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
    '    for to in ("angles", "quaternion", "matrix")',
    "}",
  ].join("\n");
}

/** SciPy's rotations turn vectors as the body has turned, and have the scalar last. */
function scipy({ matrix, target }) {
  const [a, ...vector] = quaternionFromMatrix(...matrix);
  return [
    "from scipy.spatial.transform import Rotation",
    "",
    `rotation = Rotation.from_quat([${listed([...vector, a])}])  # from the body's axes to the room's, those of ${target.name}`,
    "matrix = rotation.as_matrix()",
    `angles = rotation.as_euler("${target.sequence}", degrees=${target.degrees ? "True" : "False"})`,
  ].join("\n");
}

const constants = (declared, [open, close], [start, end]) => ({ converted, target }) => {
  const means = meanings(target);
  const line = (name, sizes, text, kind) => `${declared(name, sizes)} = ${text}; ${start}${target.name}: ${means[kind]}${end}`;
  const flat = (values) => `${open}${listed(values)}${close}`;
  return [
    line("angles", "[3]", flat(converted.angles), "angles"),
    line("quaternion", "[4]", flat(converted.quaternion), "quaternion"),
    line("matrix", "[3][3]", `${open}${rowsOf(converted.matrix).map(flat).join(", ")}${close}`, "matrix"),
  ].join("\n");
};

const inLatex = (value) => exactly(value).replace(/e\+?(-?\d+)$/, " \\cdot 10^{$1}");

function latex({ converted, target }) {
  const means = meanings(target);
  const column = (values) => `\\begin{pmatrix} ${values.map(inLatex).join(" \\\\ ")} \\end{pmatrix}`;
  return [
    `% ${target.name}: the matrix ${means.matrix}; the quaternion ${means.quaternion}`,
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
