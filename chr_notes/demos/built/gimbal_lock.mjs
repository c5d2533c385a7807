// Bundled by `python -m chr_notes.demos.build` with esbuild@0.28.2. Do not edit.
// From chr_notes/demos/*.js and chr_notes/generated/javascript.

// <define:AIRCRAFT>
var define_AIRCRAFT_default = { sections: [[-0.55, 0.012, 0.02, -0.05], [-0.42, 0.035, 0.045, -0.035], [-0.15, 0.075, 0.085, -0.01], [0.12, 0.085, 0.09, 0], [0.32, 0.07, 0.07, 0.01], [0.45, 0.04, 0.042, 0.018], [0.54, 8e-3, 8e-3, 0.02]], canopy: [[0.02, 0.035, 0.03, -0.085], [0.12, 0.05, 0.055, -0.085], [0.24, 0.045, 0.045, -0.07], [0.33, 0.02, 0.02, -0.05]], belly: [[-0.05, 0.03, 0.02, 0.085], [0.15, 0.03, 0.02, 0.085]], wing: [[0.2, -0.1, 0.06, 0.02, 0.022], [0.04, -0.09, 0.42, -5e-3, 0.012], [0, -0.085, 0.53, -0.013, 8e-3]], tail: [[-0.38, -0.52, 0.02, -0.05, 0.012], [-0.46, -0.53, 0.2, -0.06, 6e-3]], fin: [[-0.3, -0.52, 0, -0.05, 0.012], [-0.46, -0.56, 0, -0.25, 6e-3]] };

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
function eulerRatesMatrix(roll, pitch) {
  const cosPitch = Math.cos(pitch);
  const tanPitch = Math.tan(pitch);
  const secPitch = 1 / cosPitch;
  const sinRoll = Math.sin(roll);
  const cosRoll = Math.cos(roll);
  return [
    1,
    sinRoll * tanPitch,
    cosRoll * tanPitch,
    0,
    cosRoll,
    -sinRoll,
    0,
    secPitch * sinRoll,
    cosRoll * secPitch
  ];
}
function eulerRatesDeterminant(pitch) {
  const cosPitch = Math.cos(pitch);
  const secPitch = 1 / cosPitch;
  return secPitch;
}
function eulerRatesCondition(pitch) {
  const sinPitch = Math.sin(pitch);
  const cosPitch = Math.cos(pitch);
  const secPitch = 1 / cosPitch;
  return (Math.abs(sinPitch) + 1) * Math.abs(secPitch);
}
function quaternionFromEuler(roll, pitch, yaw) {
  const sinHalfPitch = Math.sin(0.5 * pitch);
  const cosHalfPitch = Math.cos(0.5 * pitch);
  const sinHalfRoll = Math.sin(0.5 * roll);
  const cosHalfRoll = Math.cos(0.5 * roll);
  const sinHalfYaw = Math.sin(0.5 * yaw);
  const cosHalfYaw = Math.cos(0.5 * yaw);
  const cosHalfPitchCosHalfYaw = cosHalfPitch * cosHalfYaw;
  const sinHalfPitchSinHalfYaw = sinHalfPitch * sinHalfYaw;
  const a = cosHalfPitchCosHalfYaw * cosHalfRoll + sinHalfPitchSinHalfYaw * sinHalfRoll;
  const b = cosHalfPitchCosHalfYaw * sinHalfRoll - cosHalfRoll * sinHalfPitchSinHalfYaw;
  const cosHalfPitchSinHalfYaw = cosHalfPitch * sinHalfYaw;
  const cosHalfYawSinHalfPitch = cosHalfYaw * sinHalfPitch;
  const c = cosHalfPitchSinHalfYaw * sinHalfRoll + cosHalfRoll * cosHalfYawSinHalfPitch;
  const d = cosHalfPitchSinHalfYaw * cosHalfRoll - cosHalfYawSinHalfPitch * sinHalfRoll;
  const sign = a >= 0 ? 1 : -1;
  return [a * sign, b * sign, c * sign, d * sign];
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
var minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
var between = (a, b, t) => a.map((value, i) => value + t * (b[i] - value));
var cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0]
];
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
function ring({ u, v, inner, outer, depth, fill, marked, mark, count = 72 }) {
  const axis = cross(u, v);
  const at = (i, radius, height) => {
    const angle = 2 * Math.PI * i / count;
    return [0, 1, 2].map(
      (k) => radius * (u[k] * Math.cos(angle) + v[k] * Math.sin(angle)) + height * axis[k]
    );
  };
  const wall = (i, radius, low, high) => [
    at(i, radius, low),
    at(i, radius, high),
    at(i + 1, radius, high),
    at(i + 1, radius, low)
  ];
  const face = (i, a, b, height) => [
    at(i, a, height),
    at(i, b, height),
    at(i + 1, b, height),
    at(i + 1, a, height)
  ];
  return Array.from({ length: count }, (_, i) => {
    const colour = mark(i) ? marked : fill;
    return [
      { points: face(i, outer, inner, depth), fill: colour },
      { points: face(i, inner, outer, -depth), fill: colour },
      { points: wall(i, outer, -depth, depth), fill },
      { points: wall(i, inner, depth, -depth), fill }
    ];
  }).flat();
}
var acrossAs = (start, end, eye) => unit(cross(minus(end, start), minus(eye, start)));
function strip(points, width, fill, eye) {
  return points.slice(1).map((end, i) => {
    const start = points[i];
    const half = scaled(acrossAs(start, end, eye), width / 2);
    const corners = [sum(start, half), sum(end, half), minus(end, half), minus(start, half)];
    return { points: corners, fill, unlit: true, open: true };
  });
}
function arrowhead(start, point, width, fill, eye) {
  const half = scaled(acrossAs(start, point, eye), width / 2);
  return { points: [sum(start, half), point, minus(start, half)], fill, unlit: true, open: true };
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
var mixed = (a, b, t) => between(a, b, t);
var rgb = (channels) => `rgb(${channels.map((value) => Math.round(Math.min(255, value))).join(" ")})`;

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
  const { unit: unit2, toPosition = Number, toValue = Number } = control;
  const words = control.words ?? ((value2) => ({
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
      const { short, long } = words(state[name]);
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
  const words = ({ symbol, text }) => symbol ? [symbolOf(symbol), ", ", text] : [text];
  const item = (entry2) => node("li", {}, sample(entry2), node("span", {}, ...words(entry2)));
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

// copying.js
var THANKS = 1500;
function copying({ python, controls }, linkTo, current, live) {
  const call = (state) => `${python}(${controls.map(({ name }) => `${name}=${Number(state[name].toPrecision(15))}`).join(", ")})`;
  const ways = [
    ...linkTo ? [["link", "Copy link", linkTo]] : [],
    ["python", "Copy as Python", call]
  ];
  return ways.map(([name, words, text]) => {
    const button = node("button", { type: "button", name }, words);
    button.addEventListener("click", async () => {
      const done = await copied(text(current()));
      button.textContent = done ? "Copied" : "Not copied";
      live.textContent = button.textContent;
      setTimeout(() => button.textContent = words, THANKS);
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
function turnByHand(canvas, { turn: turn2, putBack }) {
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
    turn2([BY_POINTER * (now[0] - last[0]), BY_POINTER * (now[1] - last[1])]);
    last = now;
  });
  for (const end of ["pointerup", "pointercancel"])
    canvas.addEventListener(end, () => last = null);
  canvas.addEventListener("dblclick", putBack);
  canvas.addEventListener("keydown", (event) => {
    const way = KEYS[event.key];
    if (!way && event.key !== "Home") return;
    event.preventDefault();
    if (way) turn2(way.map((part) => BY_KEY * part));
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

// gimbal_lock.js
var DEGREE = Math.PI / 180;
var [BESIDE, ABOVE] = [62, -22];
var [NORTH, EAST, DOWN] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
var FLOOR = 1.4;
var [YAW_ARROW, PITCH_ARROW, ROLL_ARROW] = [1.42, 1.2, 1.17];
var LOCKED = 1e-9;
var MARKS = { x: () => true, y: (i) => i % 6 < 4, z: (i) => i % 2 === 0 };
var RINGS = {
  z: { u: EAST, v: DOWN, inner: 0.95, outer: 1.03, depth: 0.05 },
  y: { u: NORTH, v: EAST, inner: 0.81, outer: 0.89, depth: 0.05 },
  x: { u: DOWN, v: NORTH, inner: 0.67, outer: 0.75, depth: 0.05 }
};
function frames({ yaw, pitch, roll }) {
  const [phi, theta, psi] = [roll * DEGREE, pitch * DEGREE, yaw * DEGREE];
  return {
    z: matrixFromEuler(0, 0, psi),
    y: matrixFromEuler(0, theta, psi),
    x: matrixFromEuler(phi, theta, psi)
  };
}
function axesOf(state) {
  const [north, east, down] = toParent(frames(state).x, NORTH);
  const apart = Math.atan2(Math.hypot(north, east), down) / DEGREE;
  return { apart, locked: Math.hypot(north, east) < LOCKED, opposite: down < 0 };
}
var LOST = "About the dashed line no ring can turn it.";
function rings(state) {
  const { apart, locked, opposite } = axesOf(state);
  if (locked && opposite)
    return `Gimbal lock. Yaw and roll turn the aircraft about the same axis, in opposite senses: raise both by the same amount and it stays where it is. ${LOST}`;
  if (locked)
    return `Gimbal lock. Yaw and roll turn the aircraft about the same axis, in the same sense: raise one, lower the other by as much, and it stays where it is. ${LOST}`;
  const d = eulerRatesMatrix(state.roll * DEGREE, state.pitch * DEGREE);
  const fastest = formatted(Math.hypot(d[6], d[7], d[8]));
  const short = formatted(Math.min(apart, 180 - apart));
  return `The roll axis is ${short}° from the line of the yaw axis. To follow the aircraft, the yaw ring turns at up to ${fastest} × its speed.`;
}
var entry = (value) => Number(value.toFixed(3)).toFixed(3).replace("-", "−").padStart(6);
function readouts(state) {
  const angles = [state.roll * DEGREE, state.pitch * DEGREE, state.yaw * DEGREE];
  const matrix = matrixFromEuler(...angles).map(entry);
  return {
    determinant: formatted(eulerRatesDeterminant(state.pitch * DEGREE)),
    condition: formatted(eulerRatesCondition(state.pitch * DEGREE)),
    rings: rings(state),
    matrix: [0, 3, 6].map((start) => matrix.slice(start, start + 3).join(" ")).join("\n"),
    quaternion: quaternionFromEuler(...angles).map(entry).join("\n")
  };
}
function summary(state) {
  const { determinant, condition, rings: sentence } = readouts(state);
  return `Determinant ${determinant}, condition number ${condition}. ${sentence}`;
}
function describe(state) {
  const angles = ["yaw", "pitch", "roll"].map((name) => `${name} ${rounded(state[name])}°`).join(", ");
  const nose = state.pitch === 0 ? "level" : state.pitch > 0 ? "up" : "down";
  const { apart, locked } = axesOf(state);
  const axes = locked ? "The yaw axis and the roll axis are one line, and a dashed line shows the axis about which no ring can turn" : `The roll axis is ${formatted(Math.min(apart, 180 - apart))}° from the line of the yaw axis`;
  return `An aircraft in three rings, yaw outside, pitch in the middle, roll inside: ${angles}, nose ${nose}. ${axes}.`;
}
var arc = (u, v, centre, radius, from, to) => Array.from({ length: 25 }, (_, i) => {
  const angle = from + (to - from) * i / 24;
  return centre.map((c, k) => c + radius * (u[k] * Math.cos(angle) + v[k] * Math.sin(angle)));
});
function turn(u, v, centre, colour, eye) {
  const [first, last, tip] = [0.45, 1.8, 2.1].map((halfTurns) => halfTurns * Math.PI);
  const path = arc(u, v, centre, 0.17, first, last);
  const [end] = arc(u, v, centre, 0.165, tip, tip);
  return [...strip(path, 0.03, colour, eye), arrowhead(path.at(-1), end, 0.13, colour, eye)];
}
function tube(along, across, from, to, radius, fill) {
  const round = arc(across, cross(along, across), [0, 0, 0], radius, 0, 2 * Math.PI).slice(0, -1);
  const outline = (distance) => round.filter((_, i) => i % 3 === 0).map((point) => sum(point, scaled(along, distance)));
  return loft([outline(from), outline(to)], fill);
}
var pin = (along, across, from, to, fill) => [along, scaled(along, -1)].flatMap((side) => tube(side, across, from, to, 0.026, fill));
function dashes(along, from, to, count, colour, eye) {
  const at = (i) => scaled(along, from + (to - from) * i / (2 * count - 1));
  const each = (_, i) => strip([at(2 * i), at(2 * i + 1)], 0.022, colour, eye);
  return Array.from({ length: count }, each).flat();
}
var onFloor = (degrees, radius) => [
  radius * Math.cos(degrees * DEGREE),
  radius * Math.sin(degrees * DEGREE),
  FLOOR
];
function compass(context, { project }, colours) {
  const line = (points, thickness) => {
    context.beginPath();
    points.forEach((point) => context.lineTo(...project(point)));
    context.lineWidth = thickness;
    context.stroke();
  };
  const rim = Array.from({ length: 121 }, (_, i) => onFloor(3 * i, 1));
  context.beginPath();
  rim.forEach((point) => context.lineTo(...project(point)));
  context.fillStyle = colours("surface");
  context.fill();
  context.strokeStyle = colours("line");
  line(rim, 2);
  for (let heading = 0; heading < 360; heading += 10) {
    const quarter = heading % 90 === 0;
    line([onFloor(heading, quarter ? 0.86 : 0.91), onFloor(heading, 0.96)], quarter ? 2.5 : 1.2);
  }
}
function letters(context, { project }, colours, width) {
  ["N", "E", "S", "W"].forEach(
    (letter, i) => label(context, [letter], project(onFloor(90 * i, 1.14)), {
      colour: colours("muted"),
      rim: colours("page"),
      size: 13,
      width
    })
  );
}
function draw(context, size, state, colours, { heading, elevation }) {
  const seen = matrixFromEuler(0, elevation * DEGREE, heading * DEGREE);
  const view = camera(seen, 6, size, { wide: 3.3, high: 3.8, shift: -0.14 });
  const { eye, project } = view;
  const colour = (name) => parsed(colours(name));
  const frame = frames(state);
  const { locked } = axesOf(state);
  const [yAxis, xAxis] = [toParent(frame.y, EAST), toParent(frame.x, NORTH)];
  compass(context, view, colours);
  paint(context, [...solids(frame, colour), ...arrows(frame, colour, eye, locked)], view);
  letters(context, view, colours, size.width);
  const words = (text, point, name, offset) => label(context, [text], project(point), {
    colour: colours(name),
    rim: colours("page"),
    offset,
    width: size.width
  });
  words("z yaw", scaled(DOWN, -YAW_ARROW), "z", [30, 0]);
  const pitchEnd = scaled(yAxis, 1.3);
  const outwards = project(pitchEnd)[0] < size.width / 2 ? -6 : 6;
  words("y pitch", pitchEnd, "y", [outwards, 34]);
  words("x roll", scaled(xAxis, ROLL_ARROW), "x", [30, 0]);
}
function solids(frame, colour) {
  const steel = mixed(colour("body"), colour("muted"), 0.4);
  const rings2 = ["z", "y", "x"].flatMap((axis) => {
    const marked = colour(axis);
    const fill = mixed(marked, colour("page"), 0.55);
    return placed(ring({ ...RINGS[axis], fill, marked, mark: MARKS[axis] }), frame[axis]);
  });
  const names = ["body", "glass", "x", "y", "z"];
  const fills = Object.fromEntries(names.map((name) => [name, colour(name)]));
  return [
    ...rings2,
    ...pin(DOWN, NORTH, 1.03, 1.1, steel),
    ...tube(DOWN, NORTH, 1.1, FLOOR, 0.05, steel),
    ...placed(pin(EAST, DOWN, 0.89, 0.95, steel), frame.y),
    ...placed(pin(NORTH, EAST, 0.75, 0.81, steel), frame.x),
    ...placed(pin(NORTH, EAST, 0.52, 0.67, steel), frame.x),
    ...placed(aircraft(fills), frame.x)
  ];
}
function arrows(frame, colour, eye, locked) {
  const [yAxis, xAxis] = [toParent(frame.y, EAST), toParent(frame.x, NORTH)];
  const [level, right, down] = [NORTH, EAST, DOWN].map((axis) => toParent(frame.z, axis));
  const [pitchedRight, pitchedDown] = [EAST, DOWN].map((axis) => toParent(frame.y, axis));
  const lost = [
    ...dashes(level, -1.55, -0.25, 12, colour("alert"), eye),
    ...dashes(level, 0.25, 1.55, 12, colour("alert"), eye)
  ];
  return [
    ...dashes(DOWN, -1.1, -1.5, 4, colour("z"), eye),
    ...turn(level, right, scaled(DOWN, -YAW_ARROW), colour("z"), eye),
    ...dashes(yAxis, 1.03, 1.34, 2, colour("y"), eye),
    ...turn(down, level, scaled(yAxis, PITCH_ARROW), colour("y"), eye),
    ...dashes(xAxis, 0.89, 1.26, 1, colour("x"), eye),
    ...turn(pitchedRight, pitchedDown, scaled(xAxis, ROLL_ARROW), colour("x"), eye),
    ...locked ? lost : []
  ];
}
var LOCK = { yaw: 0, pitch: 90, roll: 0 };
var definition = {
  title: "Gimbal lock",
  python: "GimbalLockDemo",
  viewpoint: ({ yaw }) => ({ heading: yaw + BESIDE, elevation: ABOVE }),
  hint: "Bring pitch to 90°, then move yaw and roll, one after the other. What does each do to the aircraft?",
  aspect: 1.08,
  start: { yaw: 0, pitch: 0, roll: 0 },
  controls: [
    { name: "yaw", label: "Yaw", symbol: ["ψ"], axis: "z", min: -180, max: 180 },
    { name: "pitch", label: "Pitch", symbol: ["θ"], axis: "y", min: -90, max: 90 },
    { name: "roll", label: "Roll", symbol: ["φ"], axis: "x", min: -180, max: 180 }
  ].map((control) => ({ ...control, step: 1, unit: { short: "°", long: "degrees" } })),
  outputs: [
    { name: "rings", label: "The rings", wide: true, longestAt: [LOCK] },
    { name: "determinant", label: "Determinant of D" },
    { name: "condition", label: "Condition number" },
    { name: "matrix", label: "Matrix R", grid: true },
    { name: "quaternion", label: "Quaternion", grid: true }
  ],
  story: [
    { state: { yaw: 0, pitch: 0, roll: 0 }, says: "Three rings, three axes at right angles. Each ring turns the aircraft in a way that no other can." },
    { state: { yaw: 40, pitch: 0, roll: 0 }, says: "Yaw carries the whole arrangement round." },
    { state: { yaw: 40, pitch: 60, roll: 0 }, says: "Pitch tilts the roll axis towards the yaw axis. At 60° the yaw ring must already turn at up to twice the aircraft's speed." },
    { state: { yaw: 40, pitch: 90, roll: 0 }, says: "At 90° the roll axis lies along the yaw axis." },
    { state: { yaw: -20, pitch: 90, roll: -60 }, seconds: 3.5, says: "Yaw and roll turn together by the same amount, and the aircraft stays where it is: one turn is lost." },
    { state: { yaw: -20, pitch: 60, roll: -60 }, says: "Away from 90° all three turns are back." }
  ],
  readouts,
  summary,
  describe,
  draw
};
var mount = mountOf(definition);
var gimbal_lock_default = widget(mount);
export {
  gimbal_lock_default as default,
  mount
};
