/**
 * What every demo has in common: a picture, sliders, readouts, and a way to mount it all.
 *
 * A demo is a definition, a plain object:
 *   title     what the picture shows, for those who do not see it
 *   controls  [{ name, label, symbol, axis, min, max, step, unit, digits }]: one slider each
 *   outputs   [{ name, label, wide }]: one readout each
 *   start     the state, { control name: number }, that Reset returns to
 *   readouts  (state) => { output name: text }
 *   summary   (state) => the sentence to be announced once the reader stops moving a slider
 *   draw      (context, { width, height }, state, colours)
 */

const ANNOUNCE_AFTER = 600; // milliseconds without a change
const GLIDE = 450; // milliseconds from a state back to the start

/** Four significant digits, or the sign of infinity where doubles can no longer tell. */
export function formatted(value) {
  if (!(Math.abs(value) < 1e12)) return value < 0 ? "−∞" : "∞";
  return String(Number(value.toPrecision(4))).replace("-", "−");
}

/** True where the reader's system asks for less motion. */
export const prefersStillness = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

/**
 * Build the demo in `element`. `onChange(state)` is called for each change by the reader.
 * Returns `update(state)`, for changes from elsewhere, and `destroy()`.
 */
export function mountDemo(element, definition, initial, onChange = () => {}) {
  const state = { ...definition.start, ...initial };
  const cleanup = new AbortController();
  const canvas = node("canvas", { role: "img", "aria-label": definition.title });
  const live = node("p", { class: "chr-live", "aria-live": "polite" });
  const sliders = definition.controls.map((control) => slider(control, changed));
  const outputs = definition.outputs.map(readout);
  const reset = node("button", { type: "button", name: "reset" }, "Reset");
  const panel = node(
    "div",
    { class: "chr-panel" },
    ...sliders.map((each) => each.element),
    node("div", { class: "chr-readouts" }, ...outputs.map((each) => each.element)),
    node("div", { class: "chr-buttons" }, reset),
  );
  const root = node(
    "div",
    // JupyterLab listens for shortcuts before the page does; this attribute tells it not to.
    { class: "chr-demo", role: "group", "aria-label": definition.title, "data-lm-suppress-shortcuts": "true" },
    node("div", { class: "chr-body" }, node("div", { class: "chr-stage" }, canvas), panel),
    live,
  );
  for (const type of ["keydown", "keyup", "keypress"])
    root.addEventListener(type, (event) => event.stopPropagation());

  let frame = 0;
  let timer = 0;

  function paint() {
    frame = 0;
    const ratio = devicePixelRatio || 1;
    const { width, height } = canvas.getBoundingClientRect();
    if (width === 0) return;
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    const context = canvas.getContext("2d");
    context.scale(ratio, ratio);
    definition.draw(context, { width, height }, state, coloursOf(root));
  }

  function redraw() {
    frame ||= requestAnimationFrame(paint);
  }

  function show() {
    const texts = definition.readouts(state);
    sliders.forEach((each) => each.show(state));
    outputs.forEach((each) => each.show(texts));
    redraw();
  }

  function changed(part) {
    Object.assign(state, part);
    show();
    onChange({ ...state });
    clearTimeout(timer);
    timer = setTimeout(() => (live.textContent = definition.summary(state)), ANNOUNCE_AFTER);
  }

  reset.addEventListener("click", () => glide(state, definition.start, changed, cleanup.signal));
  watch(root, canvas, redraw, cleanup.signal);
  element.replaceChildren(root);
  show();

  return {
    update(part) {
      Object.assign(state, part);
      show();
    },
    destroy() {
      cleanup.abort();
      clearTimeout(timer);
      cancelAnimationFrame(frame);
      root.remove();
    },
  };
}

/** An element with attributes and children. */
export function node(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

function slider({ name, label, symbol, axis, min, max, step, unit, digits = 0 }, changed) {
  const input = node("input", { type: "range", name, min, max, step });
  const value = node("span", { class: "chr-value", "aria-hidden": "true" });
  const symbols = node("span", { class: "chr-symbol", "aria-hidden": "true" }, symbol);
  const caption = node("span", { class: "chr-caption" }, label, " ", symbols, value);
  input.addEventListener("input", () => changed({ [name]: input.valueAsNumber }));
  return {
    element: node("label", { class: "chr-slider", "data-axis": axis }, caption, input),
    show(state) {
      const text = `${Number(state[name].toFixed(digits + 2))}${unit.short}`.replace("-", "−");
      input.value = state[name];
      input.setAttribute("aria-valuetext", `${Number(state[name].toFixed(2))} ${unit.long}`);
      value.textContent = text;
    },
  };
}

function readout({ name, label, wide }) {
  // An output is a live region by itself; the demo has one of its own that waits for a pause.
  const output = node("output", { name, "aria-live": "off" });
  return {
    element: node("div", { class: wide ? "chr-readout chr-wide" : "chr-readout" }, node("span", {}, label), output),
    show(texts) {
      output.textContent = texts[name];
    },
  };
}

function coloursOf(element) {
  const style = getComputedStyle(element);
  return (name) => style.getPropertyValue(`--chr-${name}`).trim();
}

/** Redraw when the size or the theme of the page changes. */
function watch(root, canvas, redraw, signal) {
  const sizes = new ResizeObserver(redraw);
  sizes.observe(canvas);
  const themes = new MutationObserver(redraw);
  for (const host of [document.documentElement, document.body])
    themes.observe(host, { attributes: true });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw, { signal });
  signal.addEventListener("abort", () => {
    sizes.disconnect();
    themes.disconnect();
  });
}

/** Go from one state to another in a moment, or at once where motion is not wanted. */
function glide(state, goal, changed, signal) {
  if (prefersStillness()) return changed(goal);
  const from = { ...state };
  const began = performance.now();
  const step = (now) => {
    if (signal.aborted) return;
    const t = Math.min(1, Math.max(0, (now - began) / GLIDE));
    const eased = t * t * (3 - 2 * t);
    const between = ([name, end]) => [name, t === 1 ? end : from[name] + eased * (end - from[name])];
    changed(Object.fromEntries(Object.entries(goal).map(between)));
    if (t < 1) requestAnimationFrame(step);
  };
  requestAnimationFrame(step);
}
