/** Looking at a picture: whether anybody can see it, and turning it by hand. */

const [BY_POINTER, BY_KEY] = [0.4, 5]; // degrees a pixel, and a press of an arrow key
const [LOWEST, HIGHEST] = [-85, 15]; // degrees of elevation: the floor stays below
const KEYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

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

/** Turn by dragging and by arrow keys, put back by a double click and by Home. */
export function turnByHand(canvas, { turn, putBack }) {
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
    canvas.addEventListener(end, () => (last = null));
  canvas.addEventListener("dblclick", putBack);
  canvas.addEventListener("keydown", (event) => {
    const way = KEYS[event.key];
    if (!way && event.key !== "Home") return;
    event.preventDefault();
    if (way) turn(way.map((part) => BY_KEY * part));
    else putBack();
  });
}
