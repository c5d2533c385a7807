// Bundled by `python -m chr_notes.demos.build` with esbuild@0.28.2. Do not edit.
// From chr_notes/demos/*.js and chr_notes/generated/javascript.

// <define:TABLE_1>
var define_TABLE_1_default = { "0.1": ["0.017", "0.17", "1.7", "61.2", "6120", "220 e 3"], "0.5": ["0.086", "0.86", "8.6", "309.6", "30960", "1.1 e 6"], "1.0": ["0.17", "1.7", "17", "612", "61200", "2.2 e 6"], "1.5": ["0.256", "2.56", "25.6", "921.6", "92160", "3.3 e 6"], "2.0": ["0.342", "3.42", "34.2", "1231.2", "123120", "4.4 e 6"], "3.0": ["0.513", "5.13", "51.3", "1846.8", "184680", "6.6 e 6"], "5.0": ["0.854", "8.54", "85.4", "3074.4", "307440", "11 e 6"] };

// ../generated/javascript/attitude.mjs
function driftFromTiltError(angleError, time, gravity) {
  const sinAngleError = Math.sin(angleError);
  const gravitySinAngleError = gravity * sinAngleError;
  return [gravitySinAngleError, gravitySinAngleError * time, 0.5 * gravitySinAngleError * (time * time)];
}
function positionAtLastVelocity(angleError, time, gravity) {
  const sinAngleError = Math.sin(angleError);
  return gravity * sinAngleError * (time * time);
}

// chart.js
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
var logarithmic = (low, high, start, end) => {
  const scale = linear(Math.log10(low), Math.log10(high), start, end);
  return (value) => scale(Math.log10(value));
};

// parts.js
var SVG = "http://www.w3.org/2000/svg";
function formatted(value) {
  if (!(Math.abs(value) < 1e12)) return value < 0 ? "−∞" : "∞";
  return String(Number(value.toPrecision(4))).replace("-", "−");
}
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
  const { unit, toPosition = Number, toValue = Number } = control;
  const words2 = control.words ?? ((value2) => ({
    short: rounded(value2) + unit.short,
    long: `${Number(value2.toFixed(2))} ${unit.long}`
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
function textOf({ name, label: label2, unit, wide, grid, longestAt }, readouts2) {
  const output = node("output", {
    name,
    "aria-live": "off",
    "aria-label": unit ? `${label2}, ${unit.long}` : label2
  });
  const kind = wide ? " chr-wide" : grid ? " chr-grid" : "";
  const short = unit?.short.trim() ?? "";
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
        node("tbody", {}, ...rows.map((row2) => node("tr", {}, ...row2.map(cell(false)))))
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
function glide(from, goal, seconds, { between, changed, done = () => {
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
    changed(t === 1 ? goal : between(from, goal, t * t * (3 - 2 * t)));
    if (t < 1) frame = requestAnimationFrame(step);
    else done();
  });
  return () => cancelAnimationFrame(frame);
}
function player(story, { current, between, changed, say, name, signal }) {
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
    end = glide(current(), state, seconds, { between, changed, done });
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
  function paint() {
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
    if (inSight()) frame ||= requestAnimationFrame(paint);
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
  const between = betweenOf(definition2.controls);
  const tour = player(definition2.story, {
    between,
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
    rest = glide({ ...state }, home, RESET, { between, changed });
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

// drift.js
var DEGREE = Math.PI / 180;
var [FIRST, LAST] = [1, 3600];
var STEPS = 64;
function errorsAfter(time, angle) {
  const given = [angle * DEGREE, time, 9.8];
  const [acceleration, velocity, position] = driftFromTiltError(...given);
  return { acceleration, velocity, position, printed: positionAtLastVelocity(...given) };
}
function readouts({ angle_error: angle, time }) {
  const errors = errorsAfter(time, angle);
  return {
    acceleration_error: formatted(errors.acceleration),
    velocity_error: formatted(errors.velocity),
    position_error: formatted(errors.position),
    printed_position_error: formatted(errors.printed),
    meaning: meaning(time, errors),
    row: row(angle)
  };
}
function meaning(time, { velocity, position, printed: reckoned }) {
  if (position === 0) return "With an exact attitude gravity cancels, and a sensor at rest believes that it is at rest.";
  return `After ${duration(time).long} a sensor that has not moved believes that it is ${distance(position)} away and moves at ${formatted(velocity)} m/s. In ten times as long, its velocity gets ten times as wrong, its position a hundred times. The note's table loses a factor ½: ${distance(reckoned)}.`;
}
var COLUMNS = [
  { text: "acceleration, m/s²", time: 0, error: "acceleration" },
  { text: "velocity, 10 s, m/s", time: 10, error: "velocity" },
  { text: "position, 10 s, m", time: 10, error: "position" },
  { text: "position, 1 min, m", time: 60, error: "position" },
  { text: "position, 10 min, m", time: 600, error: "position" },
  { text: "position, 1 h, m", time: 3600, error: "position" }
];
function row(angle) {
  const found = Object.entries(define_TABLE_1_default).find(([degrees]) => Number(degrees) === angle);
  const cells = found?.[1] ?? COLUMNS.map(() => "–");
  return [
    [`Table 1 at ${formatted(angle)}°`, "right", found ? "printed" : "no such row"],
    ...COLUMNS.map(({ text, time, error }, i) => [text, formatted(errorsAfter(time, angle)[error]), cells[i]])
  ];
}
function summary(state) {
  const texts = readouts(state);
  return `Acceleration error ${texts.acceleration_error} metres per second squared. ${texts.meaning}`;
}
function describe({ angle_error: angle, time }) {
  const axes = "A chart on logarithmic axes of the errors of velocity and position from 1 second to 1 hour";
  if (angle === 0) return `${axes}. Without an error of angle it is empty.`;
  const { velocity, position, printed: reckoned } = errorsAfter(time, angle);
  return `${axes}, for an angle that is off by ${formatted(angle)}°. All are straight lines, and position rises twice as steeply as velocity. At ${duration(time).long} velocity is off by ${formatted(velocity)} m/s, position by ${distance(position)}, and without the factor ½, as the note reckons, by ${distance(reckoned)}.`;
}
function duration(time) {
  const seconds = Number(time.toFixed(time < 10 ? 1 : 0));
  const parts = [
    [Math.floor(seconds / 3600), "h", "hour"],
    [Math.floor(seconds % 3600 / 60), "min", "minute"],
    [Number((seconds % 60).toFixed(1)), "s", "second"]
  ].filter(([count]) => count > 0);
  return {
    short: parts.map(([count, unit]) => `${count} ${unit}`).join(" "),
    long: parts.map(([count, , unit]) => `${count} ${unit}${count === 1 ? "" : "s"}`).join(" ")
  };
}
function distance(metres) {
  const [value, unit] = metres < 1 ? [100 * metres, "cm"] : metres < 1e3 ? [metres, "m"] : [metres / 1e3, "km"];
  return `${Number(value.toPrecision(3))} ${unit}`;
}
var RANGE = [3e-3, 3e7];
var TIMES = [[1, "1 s"], [10, "10 s"], [60, "1 min"], [600, "10 min"], [3600, "1 h"]];
var DECADES = [[0.01, "0.01"], [0.1, "0.1"], [1, "1"], [10, "10"], [100, "100"], [1e3, "1000"], [1e4, "10⁴"], [1e5, "10⁵"], [1e6, "10⁶"], [1e7, "10⁷"]];
var SIZES = [[100, "a sports field"], [1e4, "a city"], [1e6, "a country"]];
var CURVES = [
  { error: "velocity", text: "velocity", colour: "accent", dash: [2, 3], width: 3, shape: "square", at: 500, offset: [14, 14] },
  { error: "position", text: "position", colour: "proved", dash: [], width: 3, shape: "circle", at: 60, offset: [14, 12] },
  { error: "printed", text: "without ½", colour: "corrected", dash: [8, 4], width: 2.5, shape: "triangle", at: 120, offset: [-14, -10] }
];
function draw(context, { width, height }, { angle_error: angle, time }, colours) {
  const [left, right, top, bottom] = [46, width - 14, 30, height - 40];
  const [x, y] = [logarithmic(FIRST, LAST, left, right), logarithmic(...RANGE, bottom, top)];
  const at = (curve, moment) => [x(moment), y(errorsAfter(moment, angle)[curve.error])];
  const small = { colour: colours("muted"), size: 12 };
  words(context, "error, m/s or m", [8, 14], { ...small, weight: 600 });
  words(context, "time without help from outside", [right, height - 10], { ...small, align: "right", weight: 600 });
  for (const [value, text] of DECADES) {
    line(context, [[left, y(value)], [right, y(value)]], { colour: colours("line"), width: 1 });
    words(context, text, [left - 6, y(value)], { ...small, align: "right" });
  }
  for (const [moment, text] of TIMES) {
    line(context, [[x(moment), top], [x(moment), bottom]], { colour: colours("line"), width: 1 });
    words(context, text, [x(moment), bottom + 14], { ...small, align: moment === LAST ? "right" : moment === FIRST ? "left" : "center" });
  }
  for (const [metres, text] of SIZES) words(context, text, [left + 6, y(metres) - 8], small);
  if (angle === 0) {
    label(context, ["no error of angle, no drift"], [(left + right) / 2, (top + bottom) / 2], {
      colour: colours("ink"),
      rim: colours("page"),
      width
    });
    return;
  }
  context.save();
  context.beginPath();
  context.rect(left, top, right - left, bottom - top);
  context.clip();
  line(context, [[x(time), bottom], [x(time), top]], { colour: colours("ink"), width: 1.5 });
  CURVES.forEach((curve) => {
    const style = { colour: colours(curve.colour), dash: curve.dash, width: curve.width };
    line(context, [at(curve, FIRST), at(curve, LAST)], style);
  });
  context.restore();
  CURVES.forEach((curve) => {
    const style = { colour: colours(curve.colour), rim: colours("page"), width };
    label(context, [curve.text], at(curve, curve.at), { ...style, offset: curve.offset, size: 13 });
  });
  CURVES.forEach(
    (curve) => mark(context, curve.shape, at(curve, time), { colour: colours(curve.colour), rim: colours("page"), radius: 6 })
  );
}
var METRES = { short: "m", long: "metres" };
var still = { angle_error: 1, time: 10 };
var SECONDS = {
  toPosition: (value) => STEPS * Math.log(value / FIRST) / Math.log(LAST / FIRST),
  toValue: (position) => Number((FIRST * (LAST / FIRST) ** (position / STEPS)).toPrecision(2))
};
var definition = {
  python: "DriftDemo",
  title: "Drift of dead reckoning",
  hint: "Take the time from 10 seconds to an hour. Which error grows faster? Then make the angle ten times smaller.",
  aspect: 1.35,
  start: still,
  controls: [
    { name: "angle_error", label: "Error of the angle", symbol: ["ε"], min: 0, max: 5, step: 0.1, unit: { short: "°", long: "degrees" } },
    { name: "time", label: "Time", symbol: ["t"], min: 0, max: STEPS, step: 1, words: duration, ...SECONDS }
  ],
  outputs: [
    { name: "meaning", label: "What it means", wide: true, longestAt: [{ angle_error: 4.6, time: 2597 }] },
    { name: "acceleration_error", label: "Acceleration error", unit: { short: "m/s²", long: "metres per second squared" } },
    { name: "velocity_error", label: "Velocity error", unit: { short: "m/s", long: "metres per second" } },
    { name: "position_error", label: "Position error", unit: METRES },
    { name: "printed_position_error", label: "Position without ½", unit: METRES },
    { name: "row", table: true }
  ],
  story: [
    { state: { angle_error: 1, time: 1 }, says: "The attitude is off by one degree. Gravity no longer cancels: a part of it is taken for acceleration." },
    { state: { angle_error: 1, time: 10 }, seconds: 3, says: "Ten seconds. The velocity grows in step with time: ten times the time, ten times the error." },
    { state: { angle_error: 1, time: 60 }, seconds: 3, says: "One minute. The position grows with the square: its line is twice as steep." },
    { state: { angle_error: 1, time: 3600 }, seconds: 5, says: "One hour, and the sensor believes itself in another country." },
    { state: { angle_error: 0.1, time: 3600 }, says: "A tenth of the angle shifts all lines down by one decade. None gets less steep." }
  ],
  readouts,
  summary,
  describe,
  draw
};
var mount = mountOf(definition);
var drift_default = widget(mount);
export {
  drift_default as default,
  mount
};
