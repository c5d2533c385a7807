/**
 * The detective: what two or more programs say of one rotation, and the conventions under which they
 * agree.
 */
import { SYSTEMS } from "./converting.js";
import { copied } from "./copying.js";
import { KINDS, findConventions, readAs } from "./detective_search.js";
import { button, field } from "./fields.js";
import { node } from "./parts.js";
import { numbersIn, rotationIn } from "./reading.js";
import { keepKeys } from "./stage.js";
import { exactly } from "./writing.js";

const ANNOUNCE_AFTER = 600; // milliseconds without a change
const SIZES = { angles: 3, matrix: 9, quaternion: 4, accel: 3, vectors: 6 };
const LABELS = {
  angles: "Three angles", matrix: "Matrix, row by row", quaternion: "Quaternion",
  accel: "Accelerometer at rest, any unit", vectors: "A vector before, and the same after the turn",
};
const UNITS = ["", "degrees", "radians"];
const WORDS = { n: "north", s: "south", e: "east", w: "west", u: "up", d: "down", f: "forward", b: "back", l: "left", r: "right" };

const axesWords = (names) => names.map((letters) => [...letters].map((letter) => WORDS[letter]).join("-")).join(" and ");
const rowsOf = (values, size) => Array.from({ length: values.length / size }, (_, i) => values.slice(size * i, size * (i + 1)));
const degreesOf = (error) => `${Number(((error * 180) / Math.PI).toPrecision(2))}°`;

/** What a convention says of a kind of numbers, in words. */
function meaningOf(kind, convention) {
  const { sequence, written, negated, degrees, scalar_first, quaternion, product, matrix, row_vectors, vectors, accelerometer } = convention;
  const way = (to) => (to === "to body" ? "from navigation to body" : "from body to navigation");
  if (kind === "angles") {
    const turns = `${sequence}, about ${sequence === sequence.toUpperCase() ? "rotating" : "fixed"} axes`;
    return `${turns}${written ? `, but written in the order ${[...written].join(", ")}` : ""}${negated ? `, with those about ${[...negated].join(" and ")} counted the other way` : ""}, in ${degrees ? "degrees" : "radians"}`;
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
  return Object.values(SYSTEMS).filter((system) => inAxes(system) && same(system)).map(({ name }) => name);
}

/** The turns about rotating axes, and where each is written. */
function turnsOf({ sequence, ...read }) {
  const { order, signs } = read.order ? read : readAs({ sequence, ...read });
  const turns = [...sequence.toLowerCase()].map((letter, i) => letter + order[i] + signs[i]);
  return (sequence === sequence.toUpperCase() ? turns : turns.reverse()).join();
}

function matchParts(match, kinds) {
  const lines = kinds.map((kind) => {
    const axes = match.axes ? `; in ${axesWords(match.axes[kind])}` : "";
    const names = ["angles", "matrix", "quaternion"].includes(kind) ? systemsOf(kind, match) : [];
    return node("li", {}, node("b", {}, LABELS[kind].split(",")[0]), `: ${meaningOf(kind, match.convention)}${axes}${names.length > 0 ? ` — as ${names.join(", ")}` : ""}`);
  });
  const others = match.others.map((each) => node("li", {}, kinds.map((kind) => meaningOf(kind, each)).join("; ")));
  return [
    node("ul", {}, ...lines),
    node("p", {}, `They agree within ${degreesOf(match.error)}.`),
    ...(others.length > 0 ? [node("details", {}, node("summary", {}, `The same numbers, described otherwise: ${others.length}`), node("ul", {}, ...others))] : []),
  ];
}

const listed = (values) => values.map((value) => exactly(Number(value.toFixed(4)))).join(", ");

function exampleOf(matches, kinds) {
  if (matches.length < 2) return [];
  const [{ example }] = matches;
  if (example === null) return [node("p", {}, "No single further attitude decides: give another example.")];
  const [given, ...asked] = Object.keys(example);
  const rows = matches.map((match, i) => node("li", {}, `Answer ${i + 1}: ${asked.map((kind) => `${kind} ${listed(match.example[kind])}`).join("; ")}`));
  const ask = kinds.includes("angles") ? `${given} ${listed(example[given])}` : "a further attitude";
  return [node("p", {}, `To decide, ask your programs for ${ask}. They would say:`), node("ul", {}, ...rows)];
}

function mountDetective(element, opening, { now = {}, onChange = () => {}, linkTo } = {}) {
  const home = { ...start, ...opening };
  let state = { ...home, ...stated(now) };
  const faults = {};
  let typedIn = null;
  let timer = 0;
  const fields = Object.fromEntries(KINDS.map((kind) => [kind, field(kind, typed, kind === "matrix" ? 3 : 1)]));
  const unit = node("select", { name: "unit" }, ...UNITS.map((name) => node("option", { value: name }, name || "not known")));
  unit.addEventListener("change", () => changed({ unit: unit.value }));
  const result = node("div", { class: "chr-found" });
  const live = node("p", { class: "chr-live", "aria-live": "polite" });
  const link = linkTo && button("link", "Copy link", async () => {
    live.textContent = (await copied(linkTo(state))) ? "Copied" : "Not copied";
    link.textContent = live.textContent;
    setTimeout(() => (link.textContent = "Copy link"), 1500);
  });
  const buttons = [button("clear", "Clear", () => changed({ ...start, ...Object.fromEntries(KINDS.map((kind) => [kind, []])), unit: "" })), button("reset", "Reset", () => changed(home)), ...(link ? [link] : [])];
  const root = node("div", { class: "chr-demo chr-converter chr-detective", role: "group", "aria-label": "Detective", "data-lm-suppress-shortcuts": "true" },
    node("p", { class: "chr-hint" }, node("b", {}, "Paste"), " what two programs say of the same rotation, each into its field, as printed. Several examples may follow one another."),
    node("div", { class: "chr-body" },
      node("div", { class: "chr-panel" }, ...KINDS.map((kind) => fields[kind].element),
        node("label", { class: "chr-choice" }, node("span", { class: "chr-name" }, "Angles in"), unit),
        node("div", { class: "chr-buttons" }, ...buttons)),
      node("div", { class: "chr-panel" }, result)),
    live);
  keepKeys(root);

  function typed(kind, text) {
    const values = kind === "matrix" ? rotationIn(numbersIn(text).values) : numbersIn(text).values;
    typedIn = kind;
    delete faults[kind];
    if (values.length % SIZES[kind] !== 0 || (values.length === 0 && text.trim() !== ""))
      faults[kind] = `${LABELS[kind]}: expected ${SIZES[kind]} numbers an example, found ${values.length}.`;
    else return changed({ [kind]: ordered(kind, text, values) }, true);
    show();
    return undefined;
  }

  function changed(part, keep = false) {
    if (!keep) {
      typedIn = null;
      Object.keys(faults).forEach((kind) => delete faults[kind]);
    }
    state = { ...state, ...part };
    show();
    onChange({ ...state });
  }

  function found() {
    const kinds = KINDS.filter((kind) => state[kind].length > 0);
    const wrong = Object.values(faults);
    if (wrong.length > 0) return { words: wrong.join(" "), fault: true };
    if (kinds.length < 2) return { words: "Two kinds of numbers are needed, for example angles and a quaternion." };
    const given = Object.fromEntries(kinds.map((kind) => [kind, rowsOf(state[kind], SIZES[kind])]));
    const { matches, fault } = findConventions(given, state.unit === "" ? null : state.unit === "degrees");
    if (fault) return { words: `No answer: ${fault}.`, fault: true };
    const words = matches.length === 1 ? "One answer." : `${matches.length} answers, the simplest first.`;
    return { words, matches, kinds };
  }

  function show() {
    root.dataset.state = JSON.stringify(state);
    const { words, matches = [], kinds, fault } = found();
    for (const kind of KINDS) {
      fields[kind].name.textContent = LABELS[kind];
      if (kind !== typedIn) fields[kind].input.value = rowsOf(state[kind], kind === "matrix" ? 3 : SIZES[kind]).map((row) => row.map(exactly).join(", ")).join("\n");
      fields[kind].input.setAttribute("aria-invalid", String(kind in faults));
    }
    unit.value = state.unit;
    const verdict = node("output", { name: "verdict", "aria-live": "off", ...(fault ? { class: "chr-fault" } : {}) }, words);
    result.replaceChildren(verdict, node("ol", {}, ...matches.map((match) => node("li", {}, ...matchParts(match, kinds)))), ...exampleOf(matches, kinds ?? []));
    clearTimeout(timer);
    timer = setTimeout(() => (live.textContent = `${words} ${matches.length > 0 ? kinds.map((kind) => meaningOf(kind, matches[0].convention)).join("; ") : ""}`), ANNOUNCE_AFTER);
  }

  element.replaceChildren(root);
  show();
  return {
    update(part) {
      typedIn = null;
      state = { ...state, ...part };
      show();
    },
    destroy() {
      clearTimeout(timer);
      root.remove();
    },
  };
}

/** A quaternion with labels is put in the order x, y, z, w; without, it stands as it is. */
function ordered(kind, text, values) {
  const { labels } = numbersIn(text);
  if (kind !== "quaternion" || labels === null || values.length !== 4) return values;
  return ["x", "y", "z", "w"].map((name) => values[labels.indexOf(name)]);
}

/** What of a state from an address is one. */
function stated(given) {
  const known = UNITS.includes(given.unit) ? { unit: given.unit } : {};
  for (const kind of KINDS) {
    if (typeof given[kind] !== "string") continue;
    const values = given[kind] === "" ? [] : given[kind].split(",").map(Number);
    if (values.every(Number.isFinite) && values.length % SIZES[kind] === 0) known[kind] = values;
  }
  return known;
}

const start = { angles: [17.19, 11.46, 5.73], matrix: [], quaternion: [0.0343, 0.106, 0.1436, 0.9833], accel: [], vectors: [], unit: "" };

export const mount = Object.assign(mountDetective, { start });
