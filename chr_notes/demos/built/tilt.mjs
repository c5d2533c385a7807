// Bundled by `python -m chr_notes.demos.build` with esbuild@0.28.2. Do not edit.
// From chr_notes/demos/*.js and chr_notes/generated/javascript.

// <define:AIRCRAFT>
var define_AIRCRAFT_default = { sections: [[-0.55, 0.012, 0.02, -0.05], [-0.42, 0.035, 0.045, -0.035], [-0.15, 0.075, 0.085, -0.01], [0.12, 0.085, 0.09, 0], [0.32, 0.07, 0.07, 0.01], [0.45, 0.04, 0.042, 0.018], [0.54, 8e-3, 8e-3, 0.02]], canopy: [[0.02, 0.035, 0.03, -0.085], [0.12, 0.05, 0.055, -0.085], [0.24, 0.045, 0.045, -0.07], [0.33, 0.02, 0.02, -0.05]], belly: [[-0.05, 0.03, 0.02, 0.085], [0.15, 0.03, 0.02, 0.085]], wing: [[0.2, -0.1, 0.06, 0.02, 0.022], [0.04, -0.09, 0.42, -5e-3, 0.012], [0, -0.085, 0.53, -0.013, 8e-3]], tail: [[-0.38, -0.52, 0.02, -0.05, 0.012], [-0.46, -0.53, 0.2, -0.06, 6e-3]], fin: [[-0.3, -0.52, 0, -0.05, 0.012], [-0.46, -0.56, 0, -0.25, 6e-3]] };

// <define:DASHES>
var define_DASHES_default = { x: [], y: [7, 3], z: [2, 2], alert: [7, 2, 2, 2] };

// parts.js
var SVG = "http://www.w3.org/2000/svg";
var rounded = (value) => String(Number(value.toFixed(2))).replace("-", "−");
function node(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}
var symbolOf = ([letter = "", subscript = ""]) => node("span", { class: "chr-symbol" }, letter, ...subscript ? [node("sub", {}, subscript)] : []);
function slider(control, touched) {
  const { name, label: label2, symbol, axis, min, max, step } = control;
  const { unit: unit2, toPosition = Number, toValue = Number } = control;
  const words2 = control.words ?? ((value2) => ({
    short: rounded(value2) + unit2.short,
    long: `${Number(value2.toFixed(2))} ${unit2.long}`
  }));
  const input = node("input", { type: "range", name, min, max, step });
  const value = node("span", { class: "chr-value", "aria-hidden": "true" });
  const symbols = symbolOf(symbol);
  symbols.setAttribute("aria-hidden", "true");
  const caption = node("span", { class: "chr-caption" }, label2, " ", symbols, value);
  const along = (position) => 100 * (position - min) / (max - min);
  const zero = along(Math.max(0, min));
  input.addEventListener("input", () => touched({ [name]: toValue(input.valueAsNumber) }));
  return {
    element: node("label", { class: "chr-slider", "data-axis": axis }, caption, input),
    show(state) {
      const { short, long } = words2(state[name]);
      const position = toPosition(state[name]);
      input.value = position;
      input.style.setProperty("--from", `${Math.min(zero, along(position))}%`);
      input.style.setProperty("--to", `${Math.max(zero, along(position))}%`);
      input.setAttribute("aria-valuetext", long);
      value.textContent = short;
    }
  };
}
function reserved(element, texts) {
  const longest = texts.reduce((long, text) => text.length > long.length ? text : long, "");
  const ghost = node("span", { class: "chr-ghost", "aria-hidden": "true" }, longest);
  return node("div", { class: "chr-reserved" }, element, ghost);
}
function readout(output, readouts2) {
  return { wide: Boolean(output.wide), ...output.table ? tableOf(output) : textOf(output, readouts2) };
}
function textOf({ name, label: label2, unit: unit2, wide, grid, longestAt }, readouts2) {
  const output = node("output", {
    name,
    "aria-live": "off",
    "aria-label": unit2 ? `${label2}, ${unit2.long}` : label2
  });
  const kind = wide ? " chr-wide" : grid ? " chr-grid" : "";
  const short = unit2?.short.trim() ?? "";
  const units = node("span", { class: short === "°" ? "chr-unit chr-degree" : "chr-unit" }, short);
  const aside = node("span", { class: "chr-note" });
  const element = node(
    "div",
    { class: `chr-readout${kind}` },
    node("span", { class: "chr-name" }, label2),
    longestAt ? reserved(output, longestAt.map((state) => readouts2(state)[name])) : node("div", {}, output, units, aside)
  );
  return {
    element,
    show(texts) {
      const { text, note = "" } = texts[name].text === void 0 ? { text: texts[name] } : texts[name];
      output.textContent = text;
      aside.textContent = note;
      element.toggleAttribute("data-void", note !== "");
    }
  };
}
function tableOf({ name }) {
  const table = node("table", { class: "chr-table chr-wide" });
  const cell = (head) => (text, column) => head || column === 0 ? node("th", { scope: head ? "col" : "row" }, text) : node("td", {}, text);
  return {
    element: table,
    show(texts) {
      const [head, ...rows] = texts[name];
      table.replaceChildren(
        node("thead", {}, node("tr", {}, ...head.map(cell(true)))),
        node("tbody", {}, ...rows.map((row) => node("tr", {}, ...row.map(cell(false)))))
      );
    }
  };
}
function legend(entries) {
  if (entries.length === 0) return [];
  const words2 = ({ symbol, text }) => symbol ? [symbolOf(symbol), ", ", text] : [text];
  const item = (entry) => node("li", {}, sample(entry), node("span", {}, ...words2(entry)));
  return [node("ul", { class: "chr-legend" }, ...entries.map(item))];
}
function sample({ colour, dash = [], width = 2.5, mark: mark2 }) {
  const part = (tag, attributes) => {
    const element = document.createElementNS(SVG, tag);
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    return element;
  };
  const svg = part("svg", { viewBox: "0 0 30 12", width: 30, height: 12, "aria-hidden": "true" });
  const style = `stroke: var(--chr-${colour}); stroke-width: ${width}px`;
  svg.append(part("line", { x1: 1, y1: 6, x2: 29, y2: 6, style, "stroke-dasharray": dash.join(" ") }));
  if (mark2) svg.append(part("path", { d: mark2, style: `fill: var(--chr-${colour})` }));
  return svg;
}

// copying.js
var THANKS = 1500;
function copying({ python, controls }, linkTo, current, live) {
  const call = (state) => `${python}(${controls.map(({ name }) => `${name}=${Number(state[name].toPrecision(15))}`).join(", ")})`;
  const ways = [
    ...linkTo ? [["link", "Copy link", linkTo]] : [],
    ["python", "Copy as Python", call]
  ];
  return ways.map(([name, words2, text]) => {
    const button = node("button", { type: "button", name }, words2);
    button.addEventListener("click", async () => {
      const done = await copied(text(current()));
      button.textContent = done ? "Copied" : "Not copied";
      live.textContent = button.textContent;
      setTimeout(() => button.textContent = words2, THANKS);
    });
    return button;
  });
}
async function copied(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const area = node("textarea", { class: "chr-live", "aria-hidden": "true" }, text);
    document.body.append(area);
    area.select();
    const done = document.execCommand("copy");
    area.remove();
    return done;
  }
}

// looking.js
var [BY_POINTER, BY_KEY] = [0.4, 5];
var [LOWEST, HIGHEST] = [-85, 15];
var KEYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
function sight(element, changed, signal) {
  let visible = true;
  const observer = new IntersectionObserver((entries) => {
    visible = entries.at(-1).isIntersecting;
    changed(visible);
  });
  observer.observe(element);
  signal.addEventListener("abort", () => observer.disconnect());
  return () => visible;
}
var turned = ({ heading, elevation }, [right, up]) => ({
  heading: (heading - right) % 360,
  elevation: Math.min(HIGHEST, Math.max(LOWEST, elevation - up))
});
function turnByHand(canvas, { turn, putBack }) {
  let last = null;
  canvas.tabIndex = 0;
  canvas.setAttribute("aria-description", "Arrow keys turn the picture, Home puts it back.");
  canvas.classList.add("chr-turns");
  canvas.addEventListener("pointerdown", (event) => {
    last = [event.clientX, event.clientY];
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", (event) => {
    if (last === null) return;
    const now = [event.clientX, event.clientY];
    turn([BY_POINTER * (now[0] - last[0]), BY_POINTER * (now[1] - last[1])]);
    last = now;
  });
  for (const end of ["pointerup", "pointercancel"])
    canvas.addEventListener(end, () => last = null);
  canvas.addEventListener("dblclick", putBack);
  canvas.addEventListener("keydown", (event) => {
    const way = KEYS[event.key];
    if (!way && event.key !== "Home") return;
    event.preventDefault();
    if (way) turn(way.map((part) => BY_KEY * part));
    else putBack();
  });
}

// story.js
var WAIT = 3500;
var MOVE = 2;
var stillness = () => matchMedia("(prefers-reduced-motion: reduce)");
function glide(from, goal, seconds, { between: between2, changed, done = () => {
} }) {
  if (stillness().matches) {
    changed(goal);
    done();
    return () => {
    };
  }
  const began = performance.now();
  let frame = requestAnimationFrame(function step(now) {
    const t = Math.min(1, Math.max(0, (now - began) / (1e3 * seconds)));
    changed(t === 1 ? goal : between2(from, goal, t * t * (3 - 2 * t)));
    if (t < 1) frame = requestAnimationFrame(step);
    else done();
  });
  return () => cancelAnimationFrame(frame);
}
function player(story, { current, between: between2, changed, say, name, signal }) {
  let next = 0;
  let running = false;
  let end = () => {
  };
  function rename() {
    if (running) name("Pause");
    else if (stillness().matches) name(next === 0 ? "Show me, step by step" : "Next step");
    else name(next === 0 ? "Play" : "Go on");
  }
  function stop() {
    end();
    end = () => {
    };
    running = false;
    rename();
  }
  function step() {
    const index = next;
    const { says, state, seconds = MOVE } = story[index];
    say(says);
    const done = () => {
      next = (index + 1) % story.length;
      if (!running || next === 0) return stop();
      const timer = setTimeout(step, WAIT);
      end = () => clearTimeout(timer);
      return void 0;
    };
    end = glide(current(), state, seconds, { between: between2, changed, done });
  }
  rename();
  stillness().addEventListener("change", stop, { signal });
  return {
    stop,
    press() {
      if (running) return stop();
      running = !stillness().matches;
      step();
      rename();
      return void 0;
    },
    rewind() {
      next = 0;
      say("");
      stop();
    }
  };
}

// controls.js
var ANNOUNCE_AFTER = 600;
var RESET = 0.45;
function mountDemo(element, definition2, opening, { now = {}, onChange = () => {
}, linkTo } = {}) {
  const home = { ...definition2.start, ...opening };
  const state = { ...home, ...within(definition2.controls, now) };
  const cleanup = new AbortController();
  const parts = build(definition2, touched);
  const { root, canvas, live, sliders, outputs, said, play, reset } = parts;
  const seenFrom = definition2.viewpoint;
  let viewpoint = seenFrom?.(state);
  let frame = 0;
  let timer = 0;
  let rest = () => {
  };
  let inSight = () => true;
  function paint2() {
    frame = 0;
    const ratio = devicePixelRatio || 1;
    const { width, height } = canvas.getBoundingClientRect();
    if (width === 0) return;
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    const context = canvas.getContext("2d");
    context.scale(ratio, ratio);
    definition2.draw(context, { width, height }, state, coloursOf(root), viewpoint);
  }
  function redraw() {
    if (inSight()) frame ||= requestAnimationFrame(paint2);
  }
  function show() {
    const texts = definition2.readouts(state);
    root.dataset.state = JSON.stringify(state);
    canvas.setAttribute("aria-label", definition2.describe(state));
    sliders.forEach((each) => each.show(state));
    outputs.forEach((each) => each.show(texts));
    redraw();
  }
  function announce() {
    live.textContent = `${said.textContent} ${definition2.summary(state)}`.trim();
  }
  function changed(part) {
    Object.assign(state, part);
    show();
    onChange({ ...state });
    clearTimeout(timer);
    timer = setTimeout(announce, ANNOUNCE_AFTER);
  }
  const between2 = betweenOf(definition2.controls);
  const tour = player(definition2.story, {
    between: between2,
    changed,
    current: () => ({ ...state }),
    say: (text) => said.textContent = text,
    name: (text) => play.textContent = text,
    signal: cleanup.signal
  });
  function interrupt() {
    rest();
    tour.stop();
    said.textContent = "";
  }
  function touched(part) {
    interrupt();
    changed(part);
  }
  play.addEventListener("click", () => {
    rest();
    tour.press();
  });
  reset.addEventListener("click", () => {
    rest();
    tour.rewind();
    rest = glide({ ...state }, home, RESET, { between: between2, changed });
    look(seenFrom?.(home));
  });
  for (const button of copying(definition2, linkTo, () => state, live))
    parts.buttons.append(button);
  function look(from) {
    if (!from) return;
    viewpoint = from;
    redraw();
  }
  if (seenFrom)
    turnByHand(canvas, {
      turn: (part) => look(turned(viewpoint, part)),
      putBack: () => look(seenFrom(home))
    });
  inSight = sight(canvas, (visible) => visible ? redraw() : tour.stop(), cleanup.signal);
  watch(root, canvas, redraw, cleanup.signal);
  element.replaceChildren(root);
  show();
  return {
    update(part) {
      interrupt();
      Object.assign(state, part);
      show();
    },
    destroy() {
      rest();
      tour.stop();
      cleanup.abort();
      clearTimeout(timer);
      cancelAnimationFrame(frame);
      root.remove();
    }
  };
}
var mountOf = (definition2) => {
  const mount2 = (element, state, given) => mountDemo(element, definition2, state, given);
  return Object.assign(mount2, { start: definition2.start });
};
function within(controls, given) {
  const inRange = controls.flatMap(({ name, min, max, toValue = Number }) => {
    const value = given[name] === "" ? NaN : Number(given[name]);
    return value >= toValue(min) && value <= toValue(max) ? [[name, value]] : [];
  });
  return Object.fromEntries(inRange);
}
function build(definition2, touched) {
  const canvas = node("canvas", {
    role: "img",
    style: `aspect-ratio: 1 / ${definition2.aspect}`
  });
  const live = node("p", { class: "chr-live", "aria-live": "polite" });
  const said = node("p", { class: "chr-said" });
  const sliders = definition2.controls.map((control) => slider(control, touched));
  const outputs = definition2.outputs.map((output) => readout(output, definition2.readouts));
  const play = node("button", { type: "button", name: "play" });
  const reset = node("button", { type: "button", name: "reset" }, "Reset");
  const hint = node("p", { class: "chr-hint" }, node("b", {}, "Try first."), ` ${definition2.hint}`);
  const stage = node("div", { class: "chr-stage" }, canvas);
  const buttons = node("div", { class: "chr-buttons" }, play, reset);
  const panel = node(
    "div",
    { class: "chr-panel chr-controls" },
    ...sliders.map((each) => each.element),
    buttons,
    reserved(said, definition2.story.map(({ says }) => says))
  );
  const part = (name, wide) => node("div", { class: name }, ...outputs.filter((each) => each.wide === wide).map((each) => each.element));
  const root = node(
    "div",
    // JupyterLab listens for shortcuts before the page does; this attribute tells it not to.
    { class: "chr-demo", role: "group", "aria-label": definition2.title, "data-lm-suppress-shortcuts": "true" },
    hint,
    node(
      "div",
      { class: "chr-body" },
      stage,
      panel,
      part("chr-sentence", true),
      ...legend(definition2.legend ?? []),
      part("chr-panel chr-readouts", false)
    ),
    live
  );
  for (const type of ["keydown", "keyup", "keypress"])
    root.addEventListener(type, (event) => {
      if (!event.ctrlKey && !event.metaKey && !event.altKey) event.stopPropagation();
    });
  return { root, canvas, live, said, sliders, outputs, play, reset, buttons };
}
var betweenOf = (controls) => (from, to, t) => Object.fromEntries(
  controls.map(({ name, toPosition = Number, toValue = Number }) => {
    const [start, end] = [toPosition(from[name]), toPosition(to[name])];
    return [name, start === end ? to[name] : toValue(start + t * (end - start))];
  })
);
function coloursOf(element) {
  const style = getComputedStyle(element);
  return (name) => style.getPropertyValue(`--chr-${name}`).trim();
}
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

// draw.js
var NEAR_PLANE = 1e-7;
var toChild = (m, [x, y, z]) => [
  m[0] * x + m[1] * y + m[2] * z,
  m[3] * x + m[4] * y + m[5] * z,
  m[6] * x + m[7] * y + m[8] * z
];
var toParent = (m, [x, y, z]) => [
  m[0] * x + m[3] * y + m[6] * z,
  m[1] * x + m[4] * y + m[7] * z,
  m[2] * x + m[5] * y + m[8] * z
];
var dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
var between = (a, b, t) => a.map((value, i) => value + t * (b[i] - value));
var sum = (a, b) => a.map((value, i) => value + b[i]);
var scaled = (a, factor) => a.map((value) => value * factor);
var unit = (a) => scaled(a, 1 / (Math.hypot(...a) || 1));
function camera(matrix, distance, { width, height }, { wide, high, shift }) {
  const eye = toParent(matrix, [-distance, 0, 0]);
  const zoom = Math.min(width / wide, height / high) * distance;
  const project = (point) => {
    const [depth, right, down] = toChild(matrix, point);
    const perspective = zoom / (distance + depth);
    return [width / 2 + perspective * right, height / 2 + perspective * (down + shift)];
  };
  return { eye, project, light: unit(toParent(matrix, [-1, -0.55, -1])) };
}
function plane(points) {
  const normal = [0, 0, 0];
  points.forEach((a, i) => {
    const b = points[(i + 1) % points.length];
    normal[0] += (b[1] - a[1]) * (a[2] + b[2]);
    normal[1] += (b[2] - a[2]) * (a[0] + b[0]);
    normal[2] += (b[0] - a[0]) * (a[1] + b[1]);
  });
  const direction = unit(normal);
  return { normal: direction, offset: dot(direction, points[0]) };
}
var flat = (polygon) => ({ ...polygon, plane: plane(polygon.points) });
var placed = (polygons, matrix) => polygons.map((polygon) => ({
  ...polygon,
  points: polygon.points.map((point) => toParent(matrix, point))
}));
function loft(outlines, fill) {
  const sides = outlines.slice(1).flatMap(
    (outline, i) => outline.map((point, j) => {
      const next = (j + 1) % outline.length;
      return { points: [outlines[i][next], outlines[i][j], point, outline[next]], fill };
    })
  );
  const caps = [outlines[0], [...outlines.at(-1)].reverse()].map((points) => ({ points, fill }));
  return [...sides, ...caps];
}
function partition(polygons) {
  if (polygons.length === 0) return null;
  const [first, ...rest] = polygons;
  const cut = first.plane;
  const within2 = [first];
  const front = [];
  const behind = [];
  for (const polygon of rest) {
    const heights = polygon.points.map((point) => dot(cut.normal, point) - cut.offset);
    const above = heights.some((height) => height > NEAR_PLANE);
    const below = heights.some((height) => height < -NEAR_PLANE);
    if (above && below) {
      front.push({ ...polygon, points: clipped(polygon.points, heights, 1) });
      behind.push({ ...polygon, points: clipped(polygon.points, heights, -1) });
    } else (above ? front : below ? behind : within2).push(polygon);
  }
  return { cut, within: within2, front: partition(front), behind: partition(behind) };
}
function clipped(points, heights, side) {
  return points.flatMap((point, i) => {
    const next = (i + 1) % points.length;
    const kept = side * heights[i] >= -NEAR_PLANE ? [point] : [];
    const crosses = Math.abs(heights[i]) > NEAR_PLANE && heights[i] * heights[next] < 0;
    if (!crosses || Math.abs(heights[next]) <= NEAR_PLANE) return kept;
    return [...kept, between(point, points[next], heights[i] / (heights[i] - heights[next]))];
  });
}
function fromBehind(tree, eye, visit) {
  if (tree === null) return;
  const seenFromFront = dot(tree.cut.normal, eye) > tree.cut.offset;
  fromBehind(seenFromFront ? tree.behind : tree.front, eye, visit);
  tree.within.forEach(visit);
  fromBehind(seenFromFront ? tree.front : tree.behind, eye, visit);
}
function paint(context, polygons, { eye, project, light }) {
  const visible = polygons.map(flat).filter(({ plane: { normal, offset }, open }) => open || dot(normal, eye) > offset);
  fromBehind(partition(visible), eye, ({ points, fill, unlit, plane: { normal } }) => {
    const brightness = unlit ? 1 : 0.62 + 0.4 * Math.max(0, dot(normal, light));
    context.beginPath();
    points.forEach((point) => context.lineTo(...project(point)));
    context.closePath();
    context.fillStyle = rgb(scaled(fill, brightness));
    context.strokeStyle = context.fillStyle;
    context.lineWidth = 0.6;
    context.fill();
    context.stroke();
  });
}
function label(context, [text, subscript = ""], [x, y], { colour, rim, size = 14, offset = [0, 0], width }) {
  const parts = [
    { text, font: `600 ${size}px system-ui, sans-serif`, drop: 0 },
    { text: subscript, font: `600 ${0.75 * size}px system-ui, sans-serif`, drop: 0.3 * size }
  ].filter((part) => part.text !== "").map((part) => {
    context.font = part.font;
    return { ...part, wide: context.measureText(part.text).width };
  });
  const half = parts.reduce((wide, part) => wide + part.wide, 0) / 2;
  const side = offset[0] === 0 ? 0 : Math.sign(offset[0]) * half + offset[0];
  const middle = Math.min(Math.max(x + side, half + 6), width - half - 6);
  context.textAlign = "left";
  context.textBaseline = "middle";
  context.lineJoin = "round";
  context.lineWidth = size / 3;
  context.strokeStyle = rim;
  context.fillStyle = colour;
  for (const write of ["strokeText", "fillText"]) {
    let start = middle - half;
    for (const part of parts) {
      context.font = part.font;
      context[write](part.text, start, y + offset[1] + part.drop);
      start += part.wide;
    }
  }
}
var parsed = (hex) => [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16));
var rgb = (channels) => `rgb(${channels.map((value) => Math.round(Math.min(255, value))).join(" ")})`;

// ../generated/javascript/attitude.mjs
function matrixFromEuler(roll, pitch, yaw) {
  const sinPitch = Math.sin(pitch);
  const cosPitch = Math.cos(pitch);
  const sinRoll = Math.sin(roll);
  const cosRoll = Math.cos(roll);
  const sinYaw = Math.sin(yaw);
  const cosYaw = Math.cos(yaw);
  const cosYawSinRoll = cosYaw * sinRoll;
  const cosRollSinYaw = cosRoll * sinYaw;
  const cosRollCosYaw = cosRoll * cosYaw;
  const sinRollSinYaw = sinRoll * sinYaw;
  return [
    cosPitch * cosYaw,
    cosPitch * sinYaw,
    -sinPitch,
    -cosRollSinYaw + cosYawSinRoll * sinPitch,
    cosRollCosYaw + sinPitch * sinRollSinYaw,
    cosPitch * sinRoll,
    cosRollCosYaw * sinPitch + sinRollSinYaw,
    cosRollSinYaw * sinPitch - cosYawSinRoll,
    cosPitch * cosRoll
  ];
}
function wrapAngle(angle) {
  const sinAngle = Math.sin(angle);
  const cosAngle = Math.cos(angle);
  const principal = Math.atan2(sinAngle, cosAngle);
  let wrapped;
  if (angle >= -3.141592653589793 && angle < 3.141592653589793) {
    wrapped = angle;
  } else if (principal >= 3.141592653589793) {
    wrapped = -3.141592653589793;
  } else {
    wrapped = principal;
  }
  return wrapped;
}
function accelerometerAtRest(roll, pitch, gravity) {
  const sinPitch = Math.sin(pitch);
  const cosPitch = Math.cos(pitch);
  const sinRoll = Math.sin(roll);
  const cosRoll = Math.cos(roll);
  const cosPitchGravity = cosPitch * gravity;
  return [gravity * sinPitch, -cosPitchGravity * sinRoll, -cosPitchGravity * cosRoll];
}
function tiltFromAccelerometer(accelX, accelY, accelZ) {
  const size = Math.abs(accelX) + Math.abs(accelY) + Math.abs(accelZ);
  const hasDirection = size <= 17976931348623157e292 && size > 0;
  const across = Math.hypot(accelY, accelZ);
  const rollSeen = Math.atan2(-accelY, -accelZ);
  let roll;
  if (!hasDirection) {
    roll = NaN;
  } else if (across <= 0) {
    roll = 0;
  } else if (rollSeen <= -3.141592653589793) {
    roll = 3.141592653589793;
  } else {
    roll = rollSeen;
  }
  const pitch = hasDirection ? Math.atan2(accelX, across) : NaN;
  return [roll, pitch];
}
function accelerometerFromAcceleration(accelNorth, accelEast, accelDown, roll, pitch, yaw, gravity) {
  const sinPitch = Math.sin(pitch);
  const cosPitch = Math.cos(pitch);
  const sinRoll = Math.sin(roll);
  const cosRoll = Math.cos(roll);
  const sinYaw = Math.sin(yaw);
  const cosYaw = Math.cos(yaw);
  const accelEastSinYaw = accelEast * sinYaw;
  const accelNorthCosYaw = accelNorth * cosYaw;
  const cosPitchSinRoll = cosPitch * sinRoll;
  const accelEastCosYaw = accelEast * cosYaw;
  const accelNorthSinYaw = accelNorth * sinYaw;
  const sinPitchSinRoll = sinPitch * sinRoll;
  const cosPitchCosRoll = cosPitch * cosRoll;
  const cosRollSinPitch = cosRoll * sinPitch;
  return [
    -accelDown * sinPitch + accelEastSinYaw * cosPitch + accelNorthCosYaw * cosPitch + gravity * sinPitch,
    accelDown * cosPitchSinRoll + accelEastCosYaw * cosRoll + accelEastSinYaw * sinPitchSinRoll + accelNorthCosYaw * sinPitchSinRoll - accelNorthSinYaw * cosRoll - cosPitchSinRoll * gravity,
    accelDown * cosPitchCosRoll - accelEastCosYaw * sinRoll + accelEastSinYaw * cosRollSinPitch + accelNorthCosYaw * cosRollSinPitch + accelNorthSinYaw * sinRoll - cosPitchCosRoll * gravity
  ];
}

// vibration.json
var vibration_default = [
  [0.212, -0.178, -0.208],
  [2.11, 0.095, 0.63],
  [0.612, -0.584, -0.872],
  [-0.652, -0.057, -0.305],
  [-0.212, 0.178, 0.208],
  [-0.024, 0.066, 0.547],
  [0.136, -0.187, -0.193],
  [-0.555, 2.22, -2.895],
  [-0.28, 0.017, 1.563],
  [1.1, 1.571, 1.342],
  [0.709, 1.01, -0.278],
  [1.38, 0.742, -1.057],
  [0.856, -0.849, -0.489],
  [0.921, 0.487, 2.119],
  [-1.38, -0.742, 1.057],
  [-0.061, -0.406, -0.263],
  [1.041, 1.333, -0.079],
  [0.511, -0.847, 0.125],
  [-0.709, -1.01, 0.278],
  [-0.452, -2.152, -0.541],
  [-2.674, -0.047, -0.386],
  [-0.718, -0.432, 1.341],
  [0.832, 1.769, -0.134],
  [0.063, 0.809, -0.458],
  [-0.149, 0.792, 0.535],
  [0.447, -0.413, 0.319],
  [2.674, 0.047, 0.386],
  [-2.243, 0.607, -1.364],
  [0.715, 0.241, 0.26],
  [1.353, 0.679, -1.014],
  [0.555, -2.22, 2.895],
  [0.386, -0.698, 0.027],
  [0.854, -0.108, 0.053],
  [-0.612, 0.584, 0.872],
  [-0.715, -0.241, -0.26],
  [-0.158, -2.284, -0.377],
  [-0.652, -0.732, -0.74],
  [-0.43, -0.917, 1.418],
  [-2.015, -1.462, 1.913],
  [0.158, 2.284, 0.377],
  [-0.386, 0.698, -0.027],
  [-0.921, -0.487, -2.119],
  [-0.47, -0.371, -1.625],
  [0.452, 2.152, 0.541],
  [-1.353, -0.679, 1.014],
  [0.803, 0.612, -0.856],
  [-1.1, -1.571, -1.342],
  [0.433, 0.024, -2.087],
  [-0.511, 0.847, -0.125],
  [0.061, 0.406, 0.263],
  [0.871, -0.331, 1.065],
  [1.205, -0.377, -0.892],
  [0.718, 0.432, -1.341],
  [0.28, -0.017, -1.563],
  [0.652, 0.732, 0.74],
  [-1.041, -1.333, 0.079],
  [0.462, -1.27, -0.813],
  [0.845, 0.181, 0.28],
  [0.47, 0.371, 1.625],
  [1.772, -0.635, 1.403],
  [-0.832, -1.769, 0.134],
  [2.015, 1.462, -1.913],
  [-1.583, -0.511, 0.192],
  [-1.772, 0.635, -1.403],
  [-0.856, 0.849, 0.489],
  [-0.854, 0.108, -0.053],
  [0.652, 0.057, 0.305],
  [-0.063, -0.809, 0.458],
  [0.269, 0.99, 0.472],
  [0.057, -0.577, 0.248],
  [1.583, 0.511, -0.192],
  [1.713, 0.447, 1.75],
  [-1.713, -0.447, -1.75],
  [-0.242, -0.149, 0.107],
  [-0.868, 1.317, 0.511],
  [0.149, -0.792, -0.535],
  [0.956, 0.49, -0.509],
  [-0.136, 0.187, 0.193],
  [-0.057, 0.577, -0.248],
  [-2.11, -0.095, -0.63],
  [0.155, 1.175, -0.635],
  [-1.205, 0.377, 0.892],
  [-0.155, -1.175, 0.635],
  [1.184, -1.42, -0.057],
  [-0.269, -0.99, -0.472],
  [-0.871, 0.331, -1.065],
  [-0.447, 0.413, -0.319],
  [0.43, 0.917, -1.418],
  [-0.803, -0.612, 0.856],
  [0.122, -2.736, -0.933],
  [-1.184, 1.42, 0.057],
  [-0.845, -0.181, -0.28],
  [0.024, -0.066, -0.547],
  [-0.122, 2.736, 0.933],
  [-0.956, -0.49, 0.509],
  [-0.433, -0.024, 2.087],
  [-0.462, 1.27, 0.813],
  [0.868, -1.317, -0.511],
  [0.242, 0.149, -0.107],
  [2.243, -0.607, 1.364]
];

// tilt_estimates.js
var DEGREE = Math.PI / 180;
var attitude = ({ roll, pitch }) => [roll * DEGREE, pitch * DEGREE];
var unaccelerated = (state) => state.forward_acceleration === 0 && state.lateral_acceleration === 0;
function reading(state) {
  const angles2 = [...attitude(state), 0];
  const acceleration = [state.forward_acceleration, state.lateral_acceleration, 0];
  return accelerometerFromAcceleration(
    ...toParent(matrixFromEuler(...angles2), acceleration),
    ...angles2,
    9.80665
  );
}
var readings = (state) => {
  const still2 = reading(state);
  return vibration_default.map((shake) => sum(still2, scaled(shake, state.vibration)));
};
var upToHalfTurn = (angle) => -wrapAngle(-angle);
var rms = (values) => Math.hypot(...values) / Math.sqrt(values.length);
var errors = (state, sensed) => {
  const truth = attitude(state);
  return tiltFromAccelerometer(...sensed).map((angle, i) => wrapAngle(angle - truth[i]) / DEGREE);
};
function estimates(state) {
  const average = reading(state);
  const error = errors(state, average);
  const single = readings(state).map((sensed) => errors(state, sensed));
  const scatter = error.map(
    (mean, i) => rms(single.map((each) => wrapAngle((each[i] - mean) * DEGREE) / DEGREE))
  );
  const estimate = tiltFromAccelerometer(...average).map((angle) => upToHalfTurn(angle) / DEGREE);
  const unknown = [Math.hypot(average[1], average[2]), Math.hypot(...average)].map(
    (force) => force < 1e-9
  );
  return { estimate, error, single, scatter, unknown };
}

// aircraft.js
var CORNERS = 10;
var section = ([x, wide, high, middle]) => Array.from({ length: CORNERS }, (_, i) => {
  const angle = 2 * Math.PI * (i + 0.5) / CORNERS;
  return [x, wide * Math.cos(angle), middle + high * Math.sin(angle)];
});
var plate = ([root, tip], fill, upright = false) => {
  const outline = ([front, back, side, height, half]) => {
    const at = (x, offset) => upright ? [x, offset, height] : [x, side, height + offset];
    const thickest = (2 * front + back) / 3;
    return [at(front, 0), at(thickest, -half), at(back, 0), at(thickest, half)];
  };
  return loft([outline(root), outline(tip)], fill);
};
var mirrored = (polygons) => polygons.map((polygon) => ({
  ...polygon,
  points: polygon.points.map(([x, y, z]) => [x, -y, z]).reverse()
}));
function aircraft({ body, glass, x, y, z }) {
  const { sections, wing, ...other } = define_AIRCRAFT_default;
  const inner = plate(wing.slice(0, 2), body);
  const [right, left] = [y, body].map((fill) => plate(wing.slice(1), fill));
  const tail = plate(other.tail, body);
  return [
    ...loft(sections.slice(0, -1).map(section), body),
    ...loft(sections.slice(-2).map(section), x),
    ...inner,
    ...right,
    ...tail,
    ...mirrored([...inner, ...left, ...tail]),
    ...plate(other.fin, body, true),
    ...loft(other.canopy.map(section), glass),
    ...loft(other.belly.map(section), z)
  ];
}

// chart.js
var ARROWHEAD = 9;
function line(context, points, { colour, width = 2, dash = [] }) {
  context.save();
  context.beginPath();
  points.forEach(([x, y]) => context.lineTo(x, y));
  context.strokeStyle = colour;
  context.lineWidth = width;
  context.lineJoin = "round";
  context.setLineDash(dash);
  context.stroke();
  context.restore();
}
function arrow(context, [x0, y0], [x1, y1], { colour, width = 2.5, dash = [] }) {
  const length = Math.hypot(x1 - x0, y1 - y0);
  if (length < 1) return;
  const head = Math.min(ARROWHEAD + width, length);
  const [along, across] = [[(x1 - x0) / length, (y1 - y0) / length], 0.42 * head];
  const neck = [x1 - head * along[0], y1 - head * along[1]];
  line(context, [[x0, y0], neck], { colour, width, dash });
  context.beginPath();
  context.moveTo(x1, y1);
  context.lineTo(neck[0] - across * along[1], neck[1] + across * along[0]);
  context.lineTo(neck[0] + across * along[1], neck[1] - across * along[0]);
  context.closePath();
  context.fillStyle = colour;
  context.fill();
}
function beside([x0, y0], [x1, y1], [ax, ay], apart) {
  const [x, y] = [(x0 + x1) / 2, (y0 + y1) / 2];
  const length = Math.hypot(x1 - x0, y1 - y0);
  const across = [(y1 - y0) / length, (x0 - x1) / length];
  const off = (x - ax) * across[0] + (y - ay) * across[1];
  const side = Math.abs(off) > 1 ? Math.sign(off) : across[0] > 0 ? -1 : 1;
  return [x + side * apart * across[0], y + side * apart * across[1]];
}
var SHAPES = {
  circle: (context, x, y, r) => context.arc(x, y, r, 0, 2 * Math.PI),
  square: (context, x, y, r) => context.rect(x - 0.9 * r, y - 0.9 * r, 1.8 * r, 1.8 * r),
  triangle: (context, x, y, r) => {
    context.moveTo(x, y - 1.2 * r);
    context.lineTo(x + 1.1 * r, y + 0.8 * r);
    context.lineTo(x - 1.1 * r, y + 0.8 * r);
    context.closePath();
  }
};
function mark(context, shape, [x, y], { colour, rim, radius = 5 }) {
  context.beginPath();
  SHAPES[shape](context, x, y, radius);
  context.fillStyle = colour;
  context.fill();
  if (!rim) return;
  context.strokeStyle = rim;
  context.lineWidth = 1.5;
  context.stroke();
}
function words(context, text, [x, y], { colour, size = 12, align = "left", weight = 400 }) {
  context.font = `${weight} ${size}px system-ui, sans-serif`;
  context.textAlign = align;
  context.textBaseline = "middle";
  context.fillStyle = colour;
  context.fillText(text, x, y);
}
var linear = (low, high, start, end) => (value) => start + (value - low) / (high - low) * (end - start);

// tilt_picture.js
var PER_GRAVITY = 0.6;
var SIZE = 1.25;
var PLUMB = 1;
var DISTANCE = 60;
var WEST = -Math.PI / 2;
var VIEWS = [
  { title: "from behind", view: matrixFromEuler(0, 0, 0) },
  { title: "from the right", view: matrixFromEuler(0, 0, WEST) }
];
var STRIPS = [
  { title: "roll error over 1 s", axis: "x", shape: "circle" },
  { title: "pitch error over 1 s", axis: "y", shape: "square" }
];
var DASH = { ...define_DASHES_default, real: [9, 5], believed: [2, 4] };
var LEGEND = [
  { symbol: ["f"], colour: "ink", width: 3.5, text: "what the accelerometer feels" },
  { symbol: ["−g"], colour: "z", dash: DASH.z, width: 3, text: "held up against gravity" },
  { symbol: ["a", "x"], colour: "x", width: 3, text: "forward acceleration" },
  { symbol: ["a", "y"], colour: "y", dash: DASH.y, width: 3, text: "lateral acceleration" },
  { colour: "ink", dash: DASH.real, width: 2, text: "the real vertical" },
  { colour: "alert", dash: DASH.believed, width: 3, text: "the vertical it believes in" }
];
function draw(context, { width, height }, state, colours) {
  const [half, views] = [width / 2, 0.66 * height];
  const found = estimates(state);
  [0, 1].forEach((i) => {
    inPart(
      context,
      [i * half, 0, half, views],
      (size) => scene(context, size, state, VIEWS[i], found, colours)
    );
    inPart(
      context,
      [i * half, views, half, height - views],
      (size) => strip(context, size, found, i, colours)
    );
  });
  line(context, [[half, 10], [half, height - 10]], { colour: colours("line"), width: 1 });
}
function inPart(context, [x, y, width, height], drawIt) {
  context.save();
  context.translate(x, y);
  context.beginPath();
  context.rect(0, 0, width, height);
  context.clip();
  drawIt({ width, height });
  context.restore();
}
function scene(context, size, state, { title, view }, { unknown }, colours) {
  const attitudeMatrix = matrixFromEuler(...attitude(state), 0);
  const look = camera(view, DISTANCE, size, { wide: 2.2, high: 2.85, shift: 0.12 });
  const at = (point) => look.project(point);
  const toInertial = (vector) => toParent(attitudeMatrix, vector);
  const along = (vector, length) => scaled(vector, length / Math.hypot(...vector));
  words(context, title, [size.width / 2, 14], { colour: colours("muted"), align: "center", weight: 600 });
  const centre = at([0, 0, 0]);
  const level = [[8, centre[1]], [size.width - 8, centre[1]]];
  line(context, level, { colour: colours("line"), width: 1 });
  const names = ["body", "glass", "x", "y", "z"];
  const fills = Object.fromEntries(names.map((name) => [name, parsed(colours(name))]));
  paint(context, placed(aircraft(fills), scaled(attitudeMatrix, SIZE)), look);
  const believed = (sensed) => at(along(toInertial(sensed), -PLUMB));
  if (state.vibration > 0)
    readings(state).forEach(
      (sensed) => mark(context, "circle", believed(sensed), { colour: `${colours("alert")}66`, radius: 2 })
    );
  line(context, [centre, at([0, 0, PLUMB * 1.12])], { colour: colours("ink"), width: 2, dash: DASH.real });
  if (!unknown[1]) {
    const bob = believed(reading(state));
    line(context, [centre, bob], { colour: colours("alert"), width: 3, dash: DASH.believed });
    mark(context, "circle", bob, { colour: colours("alert"), rim: colours("page"), radius: 7 });
  }
  arrows(context, state, { at, toInertial, colours, width: size.width });
}
var LEGIBLE = 12;
function arrows(context, state, { at, toInertial, colours, width }) {
  const [force, gravity, forward, lateral] = LEGEND;
  const parts = [
    { ...gravity, vector: accelerometerAtRest(...attitude(state), 9.80665) },
    { ...forward, vector: [state.forward_acceleration, 0, 0] },
    { ...lateral, vector: [0, state.lateral_acceleration, 0] }
  ];
  const steps = parts.map(({ vector }) => scaled(toInertial(vector), PER_GRAVITY / 9.80665));
  const total = steps.reduce(sum);
  const [centre, tip] = [at([0, 0, 0]), at(total)];
  const middle = at(scaled(total, 0.5));
  const letter = (symbol, point, colour) => label(context, symbol, point, { colour: colours(colour), rim: colours("page"), width, size: 13 });
  const shafts = steps.map((_, i) => [0, 1].map((end) => at([[0, 0, 0], ...steps.slice(0, i + end)].reduce(sum))));
  shafts.forEach(
    ([from, to], i) => arrow(context, from, to, { colour: colours(parts[i].colour), width: 3, dash: parts[i].dash })
  );
  const still2 = unaccelerated(state);
  if (!still2) arrow(context, centre, tip, { colour: colours(force.colour), width: 3.5 });
  shafts.forEach(([from, to], i) => {
    if (Math.hypot(to[0] - from[0], to[1] - from[1]) > LEGIBLE)
      letter(parts[i].symbol, beside(from, to, middle, 13), parts[i].colour);
  });
  const length = Math.hypot(tip[0] - centre[0], tip[1] - centre[1]) || 1;
  const beyond = tip.map((value, i) => value + 14 * (value - centre[i]) / length);
  letter(still2 ? ["f = −g"] : force.symbol, beyond, force.colour);
}
var LIMITS = [2, 5, 10, 20, 45, 90, 180];
function strip(context, { width, height }, { error, scatter, single, unknown }, which, colours) {
  const { title, axis, shape } = STRIPS[which];
  const values = single.map((each) => each[which]);
  const largest = Math.max(Math.abs(error[which]), ...values.map(Math.abs));
  const limit = LIMITS.find((each) => each >= largest * 1.05) ?? 180;
  const [left, right, top, bottom] = [46, width - 12, 26, height - 22];
  const [x, y] = [linear(0, 1, left, right), linear(-limit, limit, bottom, top)];
  const small = { colour: colours("muted"), size: 12 };
  words(context, title, [8, 10], { ...small, weight: 600 });
  for (const tick of [-limit, 0, limit]) {
    line(context, [[left, y(tick)], [right, y(tick)]], { colour: colours("line"), width: 1 });
    words(context, `${tick}°`.replace("-", "−"), [left - 5, y(tick)], { ...small, align: "right" });
  }
  line(context, [[left, y(0)], [right, y(0)]], { colour: colours("ink"), width: 1.5, dash: DASH.real });
  if (scatter[which] > 0) values.forEach(
    (value, i) => mark(context, shape, [x((i + 0.5) / values.length), y(value)], { colour: `${colours(axis)}80`, radius: 2 })
  );
  words(context, "0 s", [left, bottom + 12], small);
  words(context, "1 s", [right, bottom + 12], { ...small, align: "right" });
  if (unknown[which]) {
    const style = { colour: colours("alert"), rim: colours("page"), width, size: 13 };
    label(context, ["undefined"], [(left + right) / 2, y(limit / 2)], style);
    return;
  }
  const average = [[left, y(error[which])], [right, y(error[which])]];
  line(context, average, { colour: colours("page"), width: 6 });
  line(context, average, { colour: colours("alert"), width: 3, dash: DASH.believed });
  mark(context, "circle", average[1], { colour: colours("alert"), rim: colours("page"), radius: 5 });
}

// widget.js
var SYNC_EVERY = 200;
function paced(send, interval) {
  let timer = 0;
  let waiting = null;
  function flush() {
    clearTimeout(timer);
    timer = 0;
    if (waiting === null) return;
    const state = waiting;
    waiting = null;
    timer = setTimeout(flush, interval);
    send(state);
  }
  return {
    push(state) {
      waiting = state;
      if (timer === 0) flush();
    },
    end() {
      flush();
      clearTimeout(timer);
    }
  };
}
var widget = (mount2) => ({
  render({ model, el }) {
    const names = Object.keys(mount2.start);
    const state = () => Object.fromEntries(names.map((name) => [name, model.get(name)]));
    let own = false;
    const sync = paced((changed) => {
      own = true;
      names.forEach((name) => model.set(name, changed[name]));
      own = false;
      model.save_changes();
    }, SYNC_EVERY);
    const demo = mount2(el, state(), { onChange: sync.push });
    const follow = () => own || demo.update(state());
    names.forEach((name) => model.on(`change:${name}`, follow));
    return () => {
      names.forEach((name) => model.off(`change:${name}`, follow));
      demo.destroy();
      sync.end();
    };
  }
});

// tilt.js
var RIGHT = 5e-3;
var ANGLES = ["roll", "pitch"];
function angles(state) {
  const found = estimates(state);
  return ANGLES.map((name, i) => ({
    name,
    estimate: rounded(found.estimate[i]),
    error: rounded(found.error[i]),
    scatter: rounded(found.scatter[i]),
    wrong: Math.abs(found.error[i]) > RIGHT,
    scattered: found.scatter[i] > RIGHT,
    unknown: found.unknown[i]
  }));
}
function readouts(state) {
  const texts = angles(state).flatMap(
    ({ name, unknown, ...numbers }) => ["estimate", "error", "scatter"].map((kind) => [
      `${name}_${kind}`,
      { text: numbers[kind], note: unknown ? "undefined" : "" }
    ])
  );
  return { ...Object.fromEntries(texts), meaning: meaning(state) };
}
function meaning(state) {
  const [roll, pitch] = angles(state);
  if (pitch.unknown)
    return "The body falls freely: nothing holds it up, and its accelerometer feels nothing. Its angles are what rounding makes of no reading, and mean nothing.";
  const wrong = [roll, pitch].filter((angle) => angle.wrong && !angle.unknown);
  const sentences = [];
  if (roll.unknown)
    sentences.push(`What the sensor feels lies along the roll axis: at any roll it would feel the same. The ${roll.estimate}° is left by rounding and means nothing.`);
  if (wrong.length > 0) {
    const list = wrong.map(({ name, error }) => `its ${name} is wrong by ${error}°`).join(" and ");
    sentences.push(`The sensor takes the acceleration for tilt: ${list}, for as long as the acceleration lasts.`);
  } else if (!roll.unknown)
    sentences.push(
      unaccelerated(state) ? "The body does not accelerate, so the two verticals agree and both angles are right." : "The acceleration happens to leave both angles as they are."
    );
  if (roll.scattered || pitch.scattered) sentences.push("Single readings scatter; the average reading does not.");
  return sentences.join(" ");
}
function summary(state) {
  const texts = angles(state).map(
    ({ name, estimate, error, scatter, unknown }) => unknown ? `${name} undefined` : `${name} ${estimate} degrees, error ${error}, scatter ${scatter}`
  );
  return `Estimated ${texts.join("; ")}. ${meaning(state)}`;
}
function describe(state) {
  const [north, east, down] = toParent(matrixFromEuler(...attitude(state), 0), reading(state));
  const apart = rounded(Math.atan2(Math.hypot(north, east), -down) * 180 / Math.PI);
  const [roll, pitch] = angles(state);
  const { forward_acceleration: forward, lateral_acceleration: lateral, vibration } = state;
  const vertical = pitch.unknown ? "It believes in no vertical" : `The vertical that it believes in leans ${apart}° from the real one`;
  const shaken = vibration > 0 ? `, and single readings scatter round it: ${roll.scatter}° in roll, ${pitch.scatter}° in pitch` : "";
  return `An aircraft from behind and from the right. Roll ${rounded(state.roll)}°, pitch ${rounded(state.pitch)}°. It accelerates by ${rounded(forward)} m/s² forward and ${rounded(lateral)} m/s² to the right. ${vertical}${shaken}.`;
}
var DEGREES = { short: "°", long: "degrees" };
var METRES = { short: " m/s²", long: "metres per second squared" };
var still = { roll: 0, pitch: 0, forward_acceleration: 0, lateral_acceleration: 0, vibration: 0 };
var FALLING = { ...still, roll: 90, lateral_acceleration: 9.80665 };
var PUSHED = { roll: -150, pitch: 10, forward_acceleration: -9.9, lateral_acceleration: -9.9, vibration: 5 };
var definition = {
  python: "TiltDemo",
  title: "Tilt from an accelerometer",
  hint: "Move the forward acceleration. Which of the two angles goes wrong? Then try the lateral one, and the vibration.",
  aspect: 1.12,
  start: still,
  legend: LEGEND,
  controls: [
    { name: "roll", label: "Roll", symbol: ["φ"], axis: "x", min: -180, max: 180, step: 1, unit: DEGREES },
    { name: "pitch", label: "Pitch", symbol: ["θ"], axis: "y", min: -90, max: 90, step: 1, unit: DEGREES },
    { name: "forward_acceleration", label: "Forward acceleration", symbol: ["a", "x"], axis: "x", min: -10, max: 10, step: 0.1, unit: METRES },
    { name: "lateral_acceleration", label: "Lateral acceleration", symbol: ["a", "y"], axis: "y", min: -10, max: 10, step: 0.1, unit: METRES },
    { name: "vibration", label: "Vibration, RMS", symbol: [], min: 0, max: 5, step: 0.1, unit: METRES }
  ],
  outputs: [
    { name: "meaning", label: "What it means", wide: true, longestAt: [FALLING, PUSHED, { ...PUSHED, roll: 30, pitch: 90 }] },
    { name: "roll_estimate", label: "Roll estimate", unit: DEGREES },
    { name: "pitch_estimate", label: "Pitch estimate", unit: DEGREES },
    { name: "roll_error", label: "Roll error", unit: DEGREES },
    { name: "pitch_error", label: "Pitch error", unit: DEGREES },
    { name: "roll_scatter", label: "Roll scatter", unit: DEGREES },
    { name: "pitch_scatter", label: "Pitch scatter", unit: DEGREES }
  ],
  story: [
    { state: still, says: "At rest and level, the accelerometer feels one thing: what holds it up against gravity. The vertical that it believes in is the real one." },
    { state: { ...still, roll: 25, pitch: 15 }, says: "Tilted, and still at rest: both angles are right." },
    { state: { ...still, forward_acceleration: 4 }, says: "Level again, and gaining speed. An aircraft at rest with its nose up would give the same reading, so that is what the sensor believes." },
    { state: { ...still, roll: 30, lateral_acceleration: 4.9 }, says: "Banked in a turn. The reading has no sideways part left, and the sensor takes 30° of roll for none." },
    { state: { ...still, vibration: 3 }, says: "At rest, but shaken. Single readings scatter on both sides, and the average reading is right." },
    { state: { ...still, forward_acceleration: 4, vibration: 3 }, says: "Shaken and gaining speed. An average gets rid of the shaking and keeps the error of the acceleration." }
  ],
  readouts,
  summary,
  describe,
  draw
};
var mount = mountOf(definition);
var tilt_default = widget(mount);
export {
  tilt_default as default,
  mount
};
