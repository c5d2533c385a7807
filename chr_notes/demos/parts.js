/** The parts of a demo's panel, and numbers as text. */

const SVG = "http://www.w3.org/2000/svg";

/** Four significant digits, or the sign of infinity where doubles can no longer tell. */
export function formatted(value) {
  if (!(Math.abs(value) < 1e12)) return value < 0 ? "−∞" : "∞";
  return String(Number(value.toPrecision(4))).replace("-", "−");
}

/** Two decimals at most. */
export const rounded = (value) => String(Number(value.toFixed(2))).replace("-", "−");

/** Three decimals in a column; rounded twice, so that nothing is shown as −0.000. */
export const entry = (value) => Number(value.toFixed(3)).toFixed(3).replace("-", "−").padStart(6);

const DECIMAL = /^-?(\d+\.?\d*|\.\d+)(e[-+]\d+)?$/; // as these pages write a number, with or without its zeros

/** The number that a text from an address, or a number, says; else none. */
export const numberOf = (given) => (typeof given === "number" || DECIMAL.test(given) ? Number(given) : NaN);

/** An element with attributes and children. */
export function node(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

/** A symbol of one letter or of [letter, subscript], as it stands beside words. */
export const symbolOf = ([letter = "", subscript = ""]) =>
  node("span", { class: "chr-symbol" }, letter, ...(subscript ? [node("sub", {}, subscript)] : []));

/**
 * A slider for the control { name, label, symbol, axis, min, max, step, unit: { short, long } }.
 *
 * Where equal steps of the slider are not equal steps of the value, `toPosition(value)` and
 * `toValue(position)` go between the two, min, max and step are positions, and `words(value)`
 * stands for the number and its unit. With `typed`, a field for the number, only words that say
 * something else stand in the caption, and what `tell(words)` says until the next change.
 */
export function slider(control, touched, typed) {
  const { name, label, symbol, axis, min, max, step } = control;
  const { unit, toPosition = Number, toValue = Number } = control;
  const words = control.words ?? ((value) => ({
    short: rounded(value) + unit.short,
    long: `${Number(value.toFixed(2))} ${unit.long}`,
  }));
  const input = node("input", { type: "range", name, min, max, step });
  const value = node("span", { class: "chr-value", "aria-hidden": "true" });
  const symbols = symbolOf(symbol);
  symbols.setAttribute("aria-hidden", "true");
  const caption = node("span", { class: "chr-caption" }, label, " ", symbols, value);
  const along = (position) => (100 * (position - min)) / (max - min);
  const zero = along(Math.max(0, min));
  input.addEventListener("input", () => touched({ [name]: toValue(input.valueAsNumber) }));
  const label_ = node("label", { class: "chr-slider", "data-axis": axis }, caption, input);
  return {
    element: typed ? node("div", { class: "chr-control" }, label_, typed.element) : label_,
    tell: (text) => (value.textContent = text),
    atStep: () => ({ [name]: toValue(input.valueAsNumber) }), // an input is nowhere else
    show(state) {
      typed?.show(state);
      const { short, long } = words(state[name]);
      const position = toPosition(state[name]);
      input.value = position;
      // The coloured part of the track runs from zero to the value.
      input.style.setProperty("--from", `${Math.min(zero, along(position))}%`);
      input.style.setProperty("--to", `${Math.max(zero, along(position))}%`);
      input.setAttribute("aria-valuetext", long);
      value.textContent = typed && (!control.words || typed.text() === short) ? "" : short;
    },
  };
}

/**
 * An element whose text changes, in a place that is large enough for the longest of `texts`: what
 * stands below does not move.
 */
export function reserved(element, texts) {
  const longest = texts.reduce((long, text) => (text.length > long.length ? text : long), "");
  const ghost = node("span", { class: "chr-ghost", "aria-hidden": "true" }, longest);
  return node("div", { class: "chr-reserved" }, element, ghost);
}

/**
 * A readout of the output { name, label, unit: { short, long }, wide, grid, table, longestAt }: a
 * number and its unit, a sentence (`wide`), numbers in rows and columns (`grid`, its `rows` named),
 * or a table (`folded`, under these words), whose text is an array of rows with the headings first; a row that begins with ▸ is lit. A text may be
 * { text, note }: the note stands beside it and says what is to be thought of the number. A sentence
 * is as long as anywhere at one of the states `longestAt`.
 */
export function readout(output, readouts) {
  return { wide: Boolean(output.wide), ...(output.table ? tableOf(output) : textOf(output, readouts)) };
}

function textOf({ name, label, unit, wide, grid, rows, longestAt }, readouts) {
  // An output is a live region by itself; the demo has one of its own that waits for a pause.
  const output = node("output", {
    name, "aria-live": "off", "aria-label": unit ? `${label}, ${unit.long}` : label,
  });
  const kind = wide ? " chr-wide" : grid ? " chr-grid" : "";
  const short = unit?.short.trim() ?? "";
  const units = node("span", { class: short === "°" ? "chr-unit chr-degree" : "chr-unit" }, short);
  const aside = node("span", { class: "chr-note" });
  const element = node(
    "div",
    { class: `chr-readout${kind}` },
    node("span", { class: "chr-name" }, label),
    longestAt
      ? reserved(output, longestAt.map((state) => readouts(state)[name]))
      : node("div", {}, ...(rows ? [node("span", { class: "chr-rows", "aria-hidden": "true" }, rows.join("\n"))] : []), output, units, aside),
  );
  return {
    element,
    show(texts) {
      const { text, note = "" } = texts[name].text === undefined ? { text: texts[name] } : texts[name];
      if (output.textContent !== text) output.textContent = text;
      if (aside.textContent !== note) aside.textContent = note;
      units.hidden = text === "–";
      element.toggleAttribute("data-void", note !== "");
    },
  };
}

function tableOf({ name, folded }) {
  const table = node("table", { class: "chr-table chr-wide" });
  const cell = (head) => (text, column) =>
    head || column === 0
      ? node("th", { scope: head ? "col" : "row" }, text)
      : node("td", {}, text);
  return {
    element: folded ? node("details", { class: "chr-wide" }, node("summary", {}, folded), table) : table,
    show(texts) {
      const [head, ...rows] = texts[name];
      table.replaceChildren(
        node("thead", {}, node("tr", {}, ...head.map(cell(true)))),
        node("tbody", {}, ...rows.map((row) => node("tr", row[0].startsWith("▸") ? { class: "chr-lit" } : {}, ...row.map(cell(false))))),
      );
    },
  };
}

/** A list of lines as they are drawn, each with what it stands for; nothing for no lines. */
export function legend(entries) {
  if (entries.length === 0) return [];
  const words = ({ symbol, text }) => (symbol ? [symbolOf(symbol), ", ", text] : [text]);
  const item = (entry) => node("li", {}, sample(entry), node("span", {}, ...words(entry)));
  return [node("ul", { class: "chr-legend" }, ...entries.map(item))];
}

function sample({ colour, dash = [], width = 2.5, mark }) {
  const part = (tag, attributes) => {
    const element = document.createElementNS(SVG, tag);
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    return element;
  };
  const svg = part("svg", { viewBox: "0 0 30 12", width: 30, height: 12, "aria-hidden": "true" });
  const style = `stroke: var(--chr-${colour}); stroke-width: ${width}px`;
  svg.append(part("line", { x1: 1, y1: 6, x2: 29, y2: 6, style, "stroke-dasharray": dash.join(" ") }));
  if (mark) svg.append(part("path", { d: mark, style: `fill: var(--chr-${colour})` }));
  return svg;
}
