/** Where a demo draws: a canvas that is painted when it must be, and when somebody can see it. */
import { sight } from "./looking.js";

/** The colours by name, each looked up once. */
function coloursOf(element) {
  const [style, known] = [getComputedStyle(element), {}];
  return (name) => (known[name] ??= style.getPropertyValue(`--chr-${name}`).trim());
}

/** Make a canvas so large; to set its size, even to what it is, would make a new one of it. */
function fit(canvas, width, height) {
  if (canvas.width !== width) canvas.width = width;
  if (canvas.height !== height) canvas.height = height;
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

/**
 * Paint by `draw(context, { width, height }, colours)`, in the colours of `root`. `seen(visible)` is
 * called when the canvas comes into sight or leaves it. Returns what draws with the next frame,
 * unless nobody can see it: then once it comes into sight.
 */
export function painting(root, canvas, draw, { seen = () => {}, signal }) {
  let frame = 0;

  function paint() {
    frame = 0;
    const ratio = devicePixelRatio || 1;
    const { width, height } = canvas.getBoundingClientRect();
    if (width === 0) return;
    fit(canvas, Math.round(width * ratio), Math.round(height * ratio));
    const context = canvas.getContext("2d");
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, width, height);
    draw(context, { width, height }, coloursOf(root));
  }

  const redraw = () => {
    if (inSight()) frame ||= requestAnimationFrame(paint);
  };
  const inSight = sight(canvas, (visible) => {
    if (visible) redraw();
    seen(visible);
  }, signal);
  watch(root, canvas, redraw, signal);
  addEventListener("beforeprint", paint, { signal }); // no frame comes before the page is printed
  signal.addEventListener("abort", () => cancelAnimationFrame(frame));
  return redraw;
}

/** Keys that move a control are the demo's; with Ctrl or another such key they belong to the page. */
export function keepKeys(root) {
  for (const type of ["keydown", "keyup", "keypress"])
    root.addEventListener(type, (event) => {
      if (!event.ctrlKey && !event.metaKey && !event.altKey) event.stopPropagation();
    });
}
