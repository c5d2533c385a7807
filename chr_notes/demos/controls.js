/**
 * What every demo has in common: a picture, sliders, readouts, a story, and a way to mount it all.
 *
 * A demo is a definition, a plain object:
 *   title     the name of the demo, for those who do not see it
 *   hint      what to try first, or in each view, [text]
 *   aspect    height of the picture by its width
 *   legend    [{ colour, dash, width, symbol, text }]: the lines that need explaining
 *   controls  one slider and field each, see `slider` in parts.js; or `choices`, see typed.js
 *             and `also`, a part of the state that comes with each change of it, and `stops`,
 *             [[value, text]], buttons that go there; a `rare` one is folded away
 *   rarely    what is folded away, in words
 *   texts     { name: what the whole of it matches }: the parts of the state that are texts, if any
 *   outputs   one readout each, see `readout` in parts.js
 *   python    the name of its class, for "Copy as Python"
 *   extra     ({ put(state), signal }) => elements that stand below the buttons, if there are any
 *   start     the state, { control name: number }, where none is given
 *   viewpoint (state) => { heading, elevation } in degrees: from where the picture of a state that
 *             a page opens with is seen. A picture that has one can be turned by hand.
 *   story     [{ says, state, seconds }]: what Play shows, see story.js
 *   readouts  (state) => { output name: text, see `readout` in parts.js }
 *   summary   (state) => the sentence to be announced once the reader stops moving a slider
 *   describe  (state) => the picture in words, for those who do not see it
 *   handles   (state, { width, height }, viewpoint) => what of the picture can be moved, see looking.js
 *   draw      (context, { width, height }, state, colours, viewpoint)
 */
import { copying } from "./copying.js";
import { byHand, handleSigns, turned } from "./looking.js";
import { legend, node, numberOf, readout, reserved, slider } from "./parts.js";
import { keepKeys, painting } from "./stage.js";
import { glide, player } from "./story.js";
import { choice, stops, typed } from "./typed.js";

const ANNOUNCE_AFTER = 600; // milliseconds without a change
const RESET = 0.45; // seconds from a state back to the start

/**
 * Build the demo in `element`. `opening` is the state that Reset returns to; `now` is another to
 * begin with, such as one from the address. `onChange(state, moving)` is called for each change by
 * the reader, with `moving` for one on the way to another, and `linkTo(state)` gives the address of
 * a state, where there is one. Returns `update(state)`, for changes from elsewhere, `open(now)`, to
 * begin again with another state, and `destroy()`.
 */
function mountDemo(element, definition, opening, { now = {}, onChange = () => {}, linkTo } = {}) {
  const home = { ...definition.start, ...opening };
  const begun = (given) => ({ ...home, ...within(definition, given) });
  const state = begun(now);
  const cleanup = new AbortController();
  const parts = build(definition, { touched, tell, go });
  const { root, canvas, live, sliders, outputs, sentence, said, play, reset, hint, hints, more } = parts;
  const seenFrom = definition.viewpoint;
  let viewpoint = seenFrom?.(state);

  let timer = 0;
  let told = ""; // of what was typed, until the next change
  let rest = () => {};
  let midway = false; // on the way from one state to another
  let goal = null; // where a glide leads that is no part of the story

  function show() {
    const texts = definition.readouts(state);
    root.dataset.state = JSON.stringify(state);
    canvas.setAttribute("aria-label", definition.describe(state));
    sliders.forEach((each) => each.show(state));
    outputs.forEach((each) => each.show(texts));
    hint.textContent = hints[state.view] ?? hints[0];
    redraw();
  }

  /** What is folded away is open where it is not as it usually is. */
  function unfold() {
    const unusual = ({ name, rare }) => rare && state[name] !== definition.start[name];
    for (const each of more) each.open = definition.controls.some(unusual);
  }

  function announce() {
    live.textContent = [said.textContent, told, definition.summary(state)].filter(Boolean).join(" ");
  }

  function tell(words) {
    told = words;
    live.textContent = words;
  }

  function changed(part, moving = false) {
    midway = moving;
    Object.assign(state, part);
    show();
    onChange({ ...state }, moving);
    clearTimeout(timer);
    timer = setTimeout(announce, ANNOUNCE_AFTER);
  }

  const between = betweenOf(definition);
  const tour = player(definition.story, {
    between,
    changed,
    current: () => ({ ...state }),
    say: (text) => (said.textContent = text),
    name: (text) => (play.textContent = text),
    stopped: land,
    signal: cleanup.signal,
  });

  /** What ends on its way is at once where it led, or, in a story, at the steps of the sliders next to it. */
  function land() {
    if (midway) changed(goal ?? Object.assign({}, ...sliders.map((each) => each.atStep())));
  }

  /** End whatever moves by itself. */
  function halt() {
    rest();
    tour.stop();
    goal = null;
  }

  /** What a change from outside the story does. */
  function interrupt() {
    halt();
    said.textContent = "";
  }

  /** Another state from outside, whatever was on its way. */
  function follow(next) {
    midway = false;
    interrupt();
    Object.assign(state, next);
    show();
  }

  function glideTo(next) {
    goal = next;
    rest = glide({ ...state }, next, RESET, { between, changed });
  }

  function touched(part) {
    told = "";
    interrupt();
    changed(part);
  }

  function go(part) {
    told = "";
    interrupt();
    glideTo({ ...state, ...part });
  }

  play.addEventListener("click", () => {
    rest();
    goal = null;
    // What is said is seen below the picture, also where that sticks to the top of the window.
    sentence.style.scrollMarginTop = `calc(var(--chr-below, 0px) + ${canvas.offsetHeight}px)`;
    sentence.scrollIntoView({ block: "nearest" });
    tour.press();
  });
  reset.addEventListener("click", () => {
    rest();
    goal = null;
    tour.rewind();
    glideTo(home);
    look(seenFrom?.(home));
  });
  for (const button of copying(definition, linkTo, () => state, live))
    parts.buttons.append(button);

  if (definition.extra)
    parts.buttons.after(node("div", { class: "chr-buttons" }, ...definition.extra({ put: touched, signal: cleanup.signal })));

  function look(from) {
    if (!from) return;
    viewpoint = from;
    redraw();
  }

  const size = () => ({ width: canvas.clientWidth, height: canvas.clientHeight });
  const touch = {
    handles: () => definition.handles?.(state, size(), viewpoint) ?? [],
    put: touched,
    turn: seenFrom && ((part) => look(turned(viewpoint, part))),
    putBack: () => look(seenFrom(home)),
  };
  if (seenFrom || definition.handles) byHand(canvas, touch);
  const drawn = (context, size, colours) => {
    definition.draw(context, size, state, colours, viewpoint);
    handleSigns(context, touch.handles(), colours);
  };
  const redraw = painting(root, canvas, drawn, {
    seen: (visible) => visible || halt(),
    signal: cleanup.signal,
  });
  element.replaceChildren(root);
  show();
  unfold();

  return {
    update: follow,
    open(given) {
      follow(begun(given));
      unfold();
      look(seenFrom?.(state));
    },
    destroy() {
      midway = false;
      rest();
      tour.stop();
      cleanup.abort();
      clearTimeout(timer);
      root.remove();
    },
  };
}

/** The function that mounts one kind of demo, with its definition and the state that it starts from. */
export const mountOf = (definition) => {
  const mount = (element, state, given) => mountDemo(element, definition, state, given);
  return Object.assign(mount, { definition, start: definition.start });
};

/** What of a state from outside is a number of a control, within its slider's range, or a text as it is to be. */
function within({ controls, texts = {} }, given) {
  const asTheyAre = Object.entries(texts).flatMap(([name, pattern]) => (pattern.test(given[name] ?? "-") ? [[name, given[name]]] : []));
  const inRange = controls.flatMap(({ name, choices, min = 0, max = choices?.length - 1, toValue = Number }) => {
    const value = numberOf(given[name]);
    return value >= toValue(min) && value <= toValue(max) && !(choices && value % 1) ? [[name, value]] : [];
  });
  return Object.fromEntries([...inRange, ...asTheyAre]);
}

/** The elements of a demo. */
function build(definition, { touched, tell, go }) {
  const canvas = node("canvas", {
    role: "img", style: `aspect-ratio: 1 / ${definition.aspect}`,
  });
  const live = node("p", { class: "chr-live", "aria-live": "polite" });
  const said = node("p", { class: "chr-said" });
  const sliders = definition.controls.map((control) => {
    const put = (part) => touched({ ...control.also, ...part });
    return control.choices ? choice(control, put) : both(control, put, tell, go);
  });
  const outputs = definition.outputs.map((output) => readout(output, definition.readouts));
  const play = node("button", { type: "button", name: "play" });
  const reset = node("button", { type: "button", name: "reset" }, "Reset");
  const hints = [definition.hint].flat().map((text) => ` ${text}`);
  const hint = node("span", {});
  const trial = node("span", {}, node("b", {}, "Try first."), hint);
  const stage = node("div", { class: "chr-stage" }, canvas);
  const buttons = node("div", { class: "chr-buttons" });
  const [often, seldom] = [false, true].map((rare) => sliders.filter((_, i) => Boolean(definition.controls[i].rare) === rare).map((each) => each.element));
  const more = seldom.length > 0 ? [node("details", {}, node("summary", {}, definition.rarely), ...seldom)] : [];
  // On a phone Play stands next to the sentence that it changes.
  const panel = node("div", { class: "chr-panel chr-controls" }, node("div", { class: "chr-buttons" }, play, reset), ...often, ...more, buttons);
  const part = (name, wide) =>
    node("div", { class: name }, ...outputs.filter((each) => each.wide === wide).map((each) => each.element));
  const story = reserved(said, definition.story.map(({ says }) => says));
  const sentence = node("div", { class: "chr-sentence" }, part("chr-meaning", true), story);
  const root = node(
    "div",
    // JupyterLab listens for shortcuts before the page does; this attribute tells it not to.
    { class: "chr-demo", role: "group", "aria-label": definition.title, "data-lm-suppress-shortcuts": "true" },
    node("p", { class: "chr-hint" }, reserved(trial, hints.map((text) => `Try first.${text}`))),
    node(
      "div",
      { class: "chr-body" },
      stage,
      ...legend(definition.legend ?? []),
      sentence,
      panel,
      part("chr-panel chr-readouts", false),
    ),
    live,
  );
  keepKeys(root);
  return { root, canvas, live, sentence, said, sliders, outputs, play, reset, buttons, hint, hints, more };
}

/** A slider, a field beside it, and a button for each of its stops below. */
function both(control, touched, tell, go) {
  const part = slider(control, touched, typed(control, touched, (words) => {
    part.tell(words);
    tell(`${control.label}: ${words}.`);
  }));
  if (!control.stops) return part;
  const row = stops(control, go);
  part.element.append(row.element);
  return { ...part, show: (state) => (part.show(state), row.show(state)) };
}

/** States on the way from one to another, in equal steps of the sliders' positions. */
const betweenOf = ({ controls }) => (from, to, t) => ({
  ...to,
  ...Object.fromEntries(
    controls.map(({ name, choices, toPosition = Number, toValue = Number }) => {
      const [start, end] = [toPosition(from[name]), toPosition(to[name])];
      return [name, choices || start === end ? to[name] : toValue(start + t * (end - start))];
    }),
  ),
});
