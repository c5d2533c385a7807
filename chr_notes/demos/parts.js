/** The parts of a demo's panel, and numbers as text. */

const SVG = "http://www.w3.org/2000/svg";

/** Four significant digits, or the sign of infinity where doubles can no longer tell. */
export function formatted(value) {
  if (!(Math.abs(value) < 1e12)) return value < 0 ? "−∞" : "∞";
  return String(Number(value.toPrecision(4))).replace("-", "−");
}

/** Two decimals at most. */
export const rounded = (value) => String(Number(value.toFixed(2))).replace("-", "−");

/** An element with attributes and children. */
export function node(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

/**
 * A slider for the control { name, label, symbol, axis, min, max, step, unit: { short, long } }.
 *
 * Where equal steps of the slider are not equal steps of the value, `toPosition(value)` and
 * `toValue(position)` go between the two, min, max and step are positions, and `words(value)`
 * stands for the number and its unit.
 */
export function slider(control, touched) {
  const { name, label, symbol, axis, min, max, step } = control;
  const { unit, toPosition = Number, toValue = Number } = control;
  const words = control.words ?? ((value) => ({
    short: rounded(value) + unit.short,
    long: `${Number(value.toFixed(2))} ${unit.long}`,
  }));
  const input = node("input", { type: "range", name, min, max, step });
  const value = node("span", { class: "chr-value", "aria-hidden": "true" });
  const symbols = node("span", { class: "chr-symbol", "aria-hidden": "true" }, symbol);
  const caption = node("span", { class: "chr-caption" }, label, " ", symbols, value);
  input.addEventListener("input", () => touched({ [name]: toValue(input.valueAsNumber) }));
  return {
    element: node("label", { class: "chr-slider", "data-axis": axis }, caption, input),
    show(state) {
      const { short, long } = words(state[name]);
      input.value = toPosition(state[name]);
      input.setAttribute("aria-valuetext", long);
      value.textContent = short;
    },
  };
}

/**
 * A readout of the output { name, label, unit, wide, grid, table }: a number and its unit, a
 * sentence (`wide`), numbers in rows and columns (`grid`), or a table, whose text is an array of
 * rows with the headings first.
 */
export function readout(output) {
  return output.table ? tableOf(output) : textOf(output);
}

function textOf({ name, label, unit, wide, grid }) {
  // An output is a live region by itself; the demo has one of its own that waits for a pause.
  const output = node("output", { name, "aria-live": "off" });
  const kind = wide ? " chr-wide" : grid ? " chr-grid" : "";
  const units = unit ? [node("span", { class: unit === "°" ? "chr-unit chr-degree" : "chr-unit" }, unit)] : [];
  return {
    element: node(
      "div",
      { class: `chr-readout${kind}` },
      node("span", { class: "chr-name" }, label),
      node("div", {}, output, ...units),
    ),
    show(texts) {
      output.textContent = texts[name];
    },
  };
}

function tableOf({ name }) {
  const table = node("table", { class: "chr-table chr-wide" });
  const cell = (head) => (text, column) =>
    head || column === 0
      ? node("th", { scope: head ? "col" : "row" }, text)
      : node("td", {}, text);
  return {
    element: table,
    show(texts) {
      const [head, ...rows] = texts[name];
      table.replaceChildren(
        node("thead", {}, node("tr", {}, ...head.map(cell(true)))),
        node("tbody", {}, ...rows.map((row) => node("tr", {}, ...row.map(cell(false))))),
      );
    },
  };
}

/** A list of lines as they are drawn, each with what it stands for; nothing for no lines. */
export function legend(entries) {
  if (entries.length === 0) return [];
  return [node("ul", { class: "chr-legend" }, ...entries.map((entry) => node("li", {}, sample(entry), entry.text)))];
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
