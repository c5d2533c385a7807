/** Looking at a picture: whether anybody can see it, and what a hand does in it. */
import { ringAt } from "./chart.js";

const [BY_POINTER, BY_KEY] = [0.4, 5]; // degrees a pixel, and a press of an arrow key
const [LOWEST, HIGHEST] = [-85, 15]; // degrees of elevation: the floor stays below
const KEYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
const [REACH, BY_KEY_HELD] = [22, 12]; // pixels round what can be held, and by a key

/** Call `changed(visible)` when `element` comes into sight or leaves it. Returns what tells. */
export function sight(element, changed, signal) {
  let visible = true;
  const observer = new IntersectionObserver((entries) => {
    visible = entries.at(-1).isIntersecting;
    changed(visible);
  });
  observer.observe(element);
  signal.addEventListener("abort", () => observer.disconnect());
  return () => visible;
}

/** A viewpoint from further to the right and above by [degrees, degrees]. */
export const turned = ({ heading, elevation }, [right, up]) => ({
  heading: (heading - right) % 360,
  elevation: Math.min(HIGHEST, Math.max(LOWEST, elevation - up)),
});

/** A ring round each point that can be held: the one sign for it in all pictures. */
export function handleSigns(context, handles, colours) {
  for (const { at, reach } of handles)
    if (!reach) for (const [name, width] of [["page", 5], ["accent", 2]]) ringAt(context, at, colours(name), { radius: 10, width });
}

/**
 * What a hand does in a picture. `handles()` are what can be held now: [{ at, reach, tall, hold }],
 * where it is in pixels, how far from there it is taken hold of (or over which height round it), and what
 * makes of the pointer's place, and of its way since, a part of the state for `put`. Elsewhere
 * `turn` turns the picture, if it can be turned, by arrow keys too; a double click and Home call
 * `putBack`. With Shift, arrow keys move the first of the handles.
 */
export function byHand(canvas, { turn, putBack, handles = () => [], put }) {
  let [first, last, move] = [null, null, null];
  const placeOf = ({ offsetX, offsetY }) => [offsetX, offsetY];
  const way = ([x, y], [u, v]) => [x - u, y - v];
  const heldAt = ([x, y]) =>
    handles().find(({ at, reach = REACH, tall }) =>
      tall ? Math.abs(x - at[0]) < reach && Math.abs(y - at[1]) < tall / 2 : Math.hypot(x - at[0], y - at[1]) < reach);

  canvas.classList.toggle("chr-turns", Boolean(turn));
  if (turn) {
    canvas.tabIndex = 0;
    const held = handles().length > 0 ? " With Shift, they move what can be taken hold of." : "";
    canvas.setAttribute("aria-description", `Arrow keys turn the picture, Home puts it back.${held}`);
  }
  canvas.addEventListener("pointerdown", (event) => {
    first = last = placeOf(event);
    move = heldAt(first)?.hold() ?? null;
    canvas.setPointerCapture(event.pointerId);
  });
  // What is held is moved, and the page not scrolled.
  canvas.addEventListener("touchstart", (event) => move && event.preventDefault(), { passive: false });
  canvas.addEventListener("pointermove", (event) => {
    const now = placeOf(event);
    if (last === null) return canvas.classList.toggle("chr-holds", heldAt(now) !== undefined);
    if (move) put(move(now, way(now, first)));
    else turn?.(way(now, last).map((part) => BY_POINTER * part));
    last = now;
    return undefined;
  });
  for (const end of ["pointerup", "pointercancel"])
    canvas.addEventListener(end, () => ([last, move] = [null, null]));
  if (!turn) return;
  canvas.addEventListener("dblclick", putBack);
  canvas.addEventListener("keydown", (event) => {
    const step = KEYS[event.key];
    if (!step && event.key !== "Home") return;
    event.preventDefault();
    const [held] = event.shiftKey && step ? handles() : [];
    const by = step?.map((part, i) => part * BY_KEY_HELD * (i === 0 ? 1 : -1));
    if (held) put(held.hold()([held.at[0] + by[0], held.at[1] + by[1]], by));
    else if (step) turn(step.map((part) => BY_KEY * part));
    else putBack();
  });
}
