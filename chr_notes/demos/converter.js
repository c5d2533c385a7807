/**
 * A converter: one attitude in the conventions of two systems. What is typed, pasted or dragged on
 * one side is followed by all other numbers on both.
 */
import { describe, draw } from "./converter_picture.js";
import { KINDS, computed, sourceOf, stated, understood } from "./converter_state.js";
import { SHOWN_DIGITS, asText, differences, lockWords, noTurnWords, summary, triplesWords } from "./converter_words.js";
import { SEQUENCES, SYSTEMS, fromMatrix, turnNames } from "./converting.js";
import { copied } from "./copying.js";
import { transposed } from "./draw.js";
import { button, field } from "./fields.js";
import { byHand, turned } from "./looking.js";
import { nearestRotation } from "./nearest.js";
import { node, slider } from "./parts.js";
import { keepKeys, painting } from "./stage.js";
import { LANGUAGES, meanings } from "./writing.js";

const ANNOUNCE_AFTER = 600; // milliseconds without a change
const THANKS = 1500; // milliseconds for which a button says what it did
const LABELS = { angles: "Angles", quaternion: "Quaternion", "axis angle": "Axis and angle", matrix: "Matrix" };
const DEGREES = { short: "°", long: "degrees" };
const RADIANS = { short: " rad", long: "radians" };
const LAST = ["Picture and sliders", "the last valid attitude"];
const NARROW = 560; // as in demos.css

const option = (value, text = value) => node("option", { value }, text);

const choice = (name, label, ...options) => {
  const select = node("select", { name }, ...options);
  return { select, element: node("label", { class: "chr-choice" }, node("span", { class: "chr-name" }, label), select) };
};

/** The three choices that make a convention. */
function choices(side, label) {
  const systems = (documented) => Object.values(SYSTEMS).filter((each) => each.documented === documented).map(({ name, label: text }) => option(name, text));
  const turns = (rotating) => SEQUENCES.filter((name) => (name === name.toUpperCase()) === rotating).map((name) => option(name));
  const group = (text, options) => node("optgroup", { label: text }, ...options);
  return {
    [side]: choice(side, label, group("held by a worked number", systems(false)), group("by their documentation", systems(true))),
    [`${side}_sequence`]: choice(
      `${side}_sequence`, "Turns", group("about rotating axes", turns(true)), group("about fixed axes", turns(false)),
    ),
    [`${side}_unit`]: choice(`${side}_unit`, "Angles in", option("degrees"), option("radians")),
  };
}

function result(name, kind = name) {
  const label = node("span", { class: "chr-name" });
  const output = node("output", { name, "aria-live": "off" });
  return { label, output, element: node("div", { class: "chr-field", "data-kind": kind }, label, output) };
}

/**
 * Build the converter in `element`; see `mountDemo` in controls.js for what is given and returned.
 */
function mountConverter(element, opening, { now = {}, onChange = () => {}, linkTo } = {}) {
  const home = { ...start, ...opening };
  let state = { ...home, ...stated(now) };
  let viewpoint = definition.viewpoint();
  let narrow = false;
  let typedIn = null; // the field in which the reader writes keeps what was written
  let fault = null;
  let timer = 0;
  const cleanup = new AbortController();

  const selects = { ...choices("source", "From"), ...choices("target", "To") };
  const fields = Object.fromEntries(KINDS.map((kind) => [kind, field(kind, typed, kind === "matrix" ? 3 : 1)]));
  const results = Object.fromEntries(KINDS.map((kind) => [kind, result(`target_${kind.replace(" ", "_")}`, kind)]));
  const also = {
    target_negative: result("target_negative", "quaternion"), target_triples: result("target_triples", "angles"),
    source_lock: result("source_lock", "lock"), target_lock: result("target_lock", "lock"),
    source_triples: result("source_triples", "angles"), meaning: result("meaning", "lock"),
  };
  const noTurn = node("p", { class: "chr-aside" });
  const digits = node("p", { class: "chr-aside" });
  const turns = node("div", { class: "chr-turns3" });
  const canvas = node("canvas", { role: "img", style: `aspect-ratio: 1 / ${definition.aspect}` });
  const live = node("p", { class: "chr-live", "aria-live": "polite" });
  const wrong = node("p", { class: "chr-fault", hidden: "" });
  const language = node("select", { name: "language", "aria-label": "Language" }, ...Object.keys(LANGUAGES).map((name) => option(name)));

  const nearest = button("nearest", "Take the nearest rotation", () => {
    const value = nearestRotation(fault.matrix);
    if (value) changed({ kind: "matrix", value });
  });
  const said = {
    here: node("div", { class: "chr-choices" }, selects.source.element, selects.source_sequence.element, selects.source_unit.element),
    there: node("div", { class: "chr-choices" }, selects.target.element, selects.target_sequence.element, selects.target_unit.element),
  };
  const copy = (name, text, make) => button(name, text, async ({ currentTarget }) => {
    const done = await copied(make());
    currentTarget.textContent = done ? "Copied" : "Not copied";
    live.textContent = currentTarget.textContent;
    setTimeout(() => (currentTarget.textContent = text), THANKS);
  });
  const written = () => {
    const { source, target, matrix, there } = computed(state);
    return LANGUAGES[language.value]({ kind: state.kind, value: state.value, source, target, matrix, converted: there });
  };
  const buttons = node("div", { class: "chr-buttons" },
    button("swap", "Swap", swap), button("transpose", "Transpose", transpose), button("reset", "Reset", () => changed(home)),
    ...(linkTo ? [copy("link", "Copy link", () => linkTo(state))] : []));
  const ofAttitude = [...buttons.querySelectorAll(':is([name="swap"], [name="transpose"], [name="link"])')];
  const copies = node("div", { class: "chr-buttons" }, copy("code", "Copy as", written), language);
  const root = node(
    "div",
    { class: "chr-demo chr-converter", role: "group", "aria-label": definition.title, "data-lm-suppress-shortcuts": "true" },
    node("p", { class: "chr-hint" }, node("b", {}, "Type or paste"), ` ${definition.hint}`),
    node("div", { class: "chr-body" },
      node("div", { class: "chr-stage" }, canvas),
      node("div", { class: "chr-panel" }, said.here, fields.angles.element, turns, also.source_triples.element, also.source_lock.element,
        fields.quaternion.element, fields["axis angle"].element, fields.matrix.element, wrong, buttons),
      node("div", { class: "chr-panel" }, said.there, noTurn, results.angles.element, also.target_triples.element, also.target_lock.element,
        results.quaternion.element, also.target_negative.element, results["axis angle"].element, results.matrix.element, copies, digits),
      node("div", { class: "chr-panel" }, also.meaning.element)),
    live,
  );
  keepKeys(root);

  for (const [name, { select }] of Object.entries(selects))
    select.addEventListener("change", () => {
      const [side] = name.split("_");
      // Another system comes with its own sequence and unit.
      const own = name === side ? { [`${side}_sequence`]: "", [`${side}_unit`]: "" } : {};
      resettled({ [name]: select.value, ...own });
    });

  /** Another convention. The same system with other turns or another unit has the same attitude. */
  function resettled(part) {
    const next = { ...state, ...part };
    const spelled = next.source === state.source && ["angles", "axis angle"].includes(state.kind) && !("target" in part);
    changed(spelled ? { ...part, value: fromMatrix(computed(state).own, sourceOf(next), state.kind) } : part);
  }

  function typed(kind, text, pasted) {
    const made = understood(text, kind, sourceOf(state), pasted);
    typedIn = made.kind && made.kind !== kind ? null : kind;
    if (made.fault) {
      fault = made.fault;
      show();
      announceSoon();
    } else changed(made, true);
  }

  function swap() {
    const { there } = computed(state);
    const sides = { source: state.target, source_sequence: state.target_sequence, source_unit: state.target_unit,
      target: state.source, target_sequence: state.source_sequence, target_unit: state.source_unit };
    changed({ ...sides, value: there[state.kind] });
  }

  function transpose() {
    const { here } = computed(state);
    changed({ kind: "matrix", value: transposed(here.matrix) });
  }

  function follow(part, keep = false) {
    if (!keep) typedIn = null;
    fault = null;
    state = { ...state, ...part };
    show();
  }

  function changed(...given) {
    follow(...given);
    onChange({ ...state });
    announceSoon();
  }

  function announceSoon() {
    clearTimeout(timer);
    timer = setTimeout(() => (live.textContent = fault ? `${fault.words} ${LAST.join(" show ")}.` : summary(state)), ANNOUNCE_AFTER);
  }

  let shownTurns = "";
  let sliders = [];

  /** Three sliders for the angles, made anew where their names or unit change. */
  function showTurns(source, angles) {
    const names = turnNames(source);
    const key = names.join() + source.degrees;
    if (key !== shownTurns) {
      shownTurns = key;
      const [most, step, unit] = source.degrees ? [180, 1, DEGREES] : [3.14, 0.01, RADIANS];
      sliders = names.map((name, i) =>
        slider({ name: `turn_${i + 1}`, label: name, symbol: [], axis: name.at(-1), min: -most, max: most, step, unit },
          (part) => {
            const value = [...computed(state).here.angles];
            value[i] = part[`turn_${i + 1}`];
            changed({ kind: "angles", value });
          }));
      turns.replaceChildren(...sliders.map((each) => each.element));
    }
    sliders.forEach((each, i) => each.show({ [`turn_${i + 1}`]: angles[i] }));
  }

  function show() {
    const { source, target, here, there } = computed(state);
    root.dataset.state = JSON.stringify(state);
    root.toggleAttribute("data-fault", fault !== null);
    canvas.setAttribute("aria-label", fault === null ? describe(state) : `The last valid attitude. ${describe(state)}`);
    for (const each of [...ofAttitude, ...copies.children]) each.disabled = fault !== null;
    noTurn.textContent = noTurnWords(source, target);
    noTurn.hidden = noTurn.textContent === "";
    digits.textContent = `Shown with ${narrow ? SHOWN_DIGITS.narrow : SHOWN_DIGITS.wide}, copied with all.`;
    const names = { source, target };
    for (const [side, convention] of Object.entries(names)) {
      selects[side].select.value = convention.name;
      selects[`${side}_sequence`].select.value = convention.sequence;
      selects[`${side}_unit`].select.value = convention.degrees ? "degrees" : "radians";
    }
    const [mine, theirs] = [meanings(source), meanings(target)];
    for (const kind of KINDS) {
      const { name, input } = fields[kind];
      name.textContent = `${LABELS[kind]}: ${mine[kind]}`;
      if (kind !== typedIn) input.value = fault === null ? asText(kind, here[kind], narrow && kind !== state.kind) : "";
      input.setAttribute("aria-invalid", String(fault !== null && kind === typedIn));
      results[kind].label.textContent = `${LABELS[kind]}: ${theirs[kind]}`;
      results[kind].output.setAttribute("aria-label", `${LABELS[kind]} for ${target.label}`);
      results[kind].output.textContent = fault === null ? asText(kind, there[kind], narrow) : "–";
    }
    const more = {
      target_negative: ["The same attitude", asText("quaternion", there.quaternion.map((value) => -value), narrow)],
      source_triples: fault === null ? ["The same attitude", triplesWords(here, source, narrow)] : LAST,
      target_triples: ["The same attitude", triplesWords(there, target, narrow)],
      source_lock: ["Lock", lockWords(here)],
      target_lock: ["Lock", lockWords(there)],
      meaning: ["What differs", differences(source, target).join(" ") || "Nothing: both write an attitude with the same numbers."],
    };
    for (const [name, [label, text]] of Object.entries(more)) {
      also[name].label.textContent = label;
      also[name].output.setAttribute("aria-label", label);
      also[name].output.textContent = fault === null || ["meaning", "source_triples"].includes(name) ? text : "–";
    }
    wrong.hidden = fault === null;
    wrong.replaceChildren(...(fault === null ? [] : [fault.words, ...(fault.matrix && nearestRotation(fault.matrix) ? [" ", nearest] : [])]));
    showTurns(source, here.angles);
    redraw();
  }

  byHand(canvas, {
    turn: (part) => ((viewpoint = turned(viewpoint, part)), redraw()),
    putBack: () => ((viewpoint = definition.viewpoint()), redraw()),
  });
  const redraw = painting(root, canvas, (context, size, colours) => draw(context, size, state, colours, viewpoint), { signal: cleanup.signal });
  element.replaceChildren(root);
  show();
  const sizes = new ResizeObserver(([{ contentRect }]) => {
    if (contentRect.width < NARROW === narrow) return;
    narrow = !narrow;
    show();
  });
  sizes.observe(root);

  return {
    update: follow,
    open: (given) => follow({ ...home, ...stated(given) }),
    destroy() {
      cleanup.abort();
      sizes.disconnect();
      clearTimeout(timer);
      root.remove();
    },
  };
}

const start = {
  kind: "angles", value: [10, 20, 30],
  source: "CHR", source_sequence: "", source_unit: "",
  target: "ROS", target_sequence: "", target_unit: "degrees",
};

const definition = {
  title: "Converter",
  hint: "three angles, a quaternion, an axis with its angle, or a matrix, in any notation, into any field below. All others follow.",
  aspect: 0.5,
  viewpoint: () => ({ heading: -115, elevation: -20 }),
  start,
  describe,
  draw,
};

export const mount = Object.assign(mountConverter, { definition, start });
