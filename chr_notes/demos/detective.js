/**
 * The detective: what two or more programs say of one rotation, and the conventions under which they
 * agree.
 */
import { copied } from "./copying.js";
import { KINDS, findConventions } from "./detective_search.js";
import { LABELS, exampleOf, matchParts, meaningOf, rowsOf, verdictOf } from "./detective_words.js";
import { button, field } from "./fields.js";
import { misprintWords } from "./nearest.js";
import { node, numberOf } from "./parts.js";
import { numbersIn, rotationIn } from "./reading.js";
import { keepKeys } from "./stage.js";
import { exactly } from "./writing.js";

const ANNOUNCE_AFTER = 600; // milliseconds without a change
const SIZES = { angles: 3, matrix: 9, quaternion: 4, accel: 3, vectors: 6 };
const UNITS = ["", "degrees", "radians"];
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
  const buttons = [button("clear", "Clear", () => changed({ ...NOTHING, unit: "" })), button("reset", "Reset", () => changed(home)), ...(link ? [link] : [])];
  const root = node("div", { class: "chr-demo chr-converter chr-detective", role: "group", "aria-label": "Detective", "data-lm-suppress-shortcuts": "true" },
    node("p", { class: "chr-hint" }, node("b", {}, "Paste"), " what two programs say of the same rotation, each into its field, as printed. Several examples may follow one another."),
    node("div", { class: "chr-body" },
      node("div", { class: "chr-panel" }, ...KINDS.map((kind) => fields[kind].element),
        node("label", { class: "chr-choice" }, node("span", { class: "chr-name" }, "Angles in"), unit),
        node("div", { class: "chr-buttons" }, ...buttons)),
      node("div", { class: "chr-panel" }, result)),
    live);
  keepKeys(root);

  /** The example that the page opens with says nothing of what a reader pastes. */
  const isExample = () => KINDS.every((kind) => state[kind].join() === start[kind].join());

  function typed(kind, text) {
    const values = kind === "matrix" ? rotationIn(numbersIn(text).values) : numbersIn(text).values;
    typedIn = kind;
    delete faults[kind];
    if (isExample()) state = { ...state, ...NOTHING };
    if (values.length % SIZES[kind] !== 0 || (values.length === 0 && text.trim() !== ""))
      faults[kind] = `${LABELS[kind]}: expected ${SIZES[kind]} numbers an example, found ${values.length}.`;
    else return changed({ [kind]: ordered(kind, text, values) }, true);
    show();
    return undefined;
  }

  function follow(part, keep = false) {
    if (!keep) {
      typedIn = null;
      Object.keys(faults).forEach((kind) => delete faults[kind]);
    }
    state = { ...state, ...part };
    show();
  }

  function changed(...given) {
    follow(...given);
    onChange({ ...state });
  }

  function found() {
    const kinds = KINDS.filter((kind) => state[kind].length > 0);
    const wrong = Object.values(faults);
    if (wrong.length > 0) return { words: wrong.join(" "), fault: true };
    if (kinds.length < 2) return { words: "Two kinds of numbers are needed, for example angles and a quaternion. Reset brings the example back." };
    const given = Object.fromEntries(kinds.map((kind) => [kind, rowsOf(state[kind], SIZES[kind])]));
    const degrees = state.unit === "" ? null : state.unit === "degrees";
    const { matches, fault, place } = findConventions(given, degrees);
    if (fault) return { words: `No answer: ${fault}.${given.matrix?.[place] ? misprintWords(given.matrix[place]) : ""}`, fault: true };
    return { words: verdictOf(matches, given, degrees), matches, kinds };
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
    update: follow,
    open: (given) => follow({ ...home, ...stated(given) }),
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
    if (given[kind] === undefined) continue;
    const text = String(given[kind]);
    const values = text === "" ? [] : text.split(",").map(numberOf);
    if (values.every(Number.isFinite) && values.length % SIZES[kind] === 0) known[kind] = values;
  }
  return known;
}

const NOTHING = Object.fromEntries(KINDS.map((kind) => [kind, []]));
const start = { angles: [17.19, 11.46, 5.73], matrix: [], quaternion: [0.0343, 0.106, 0.1436, 0.9833], accel: [], vectors: [], unit: "" };

export const mount = Object.assign(mountDetective, { start });
