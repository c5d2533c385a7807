/** Flat drawing on a canvas: lines, arrows, marks, and the frame of a chart. */

const ARROWHEAD = 9; // pixels

/** A line from point to point in pixels. */
export function line(context, points, { colour, width = 2, dash = [] }) {
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

/** Square dots at points in pixels. */
export function dots(context, points, { colour, width = 2 }) {
  context.beginPath();
  for (const [x, y] of points) {
    context.moveTo(x - width / 2, y);
    context.lineTo(x + width / 2, y);
  }
  context.strokeStyle = colour;
  context.lineWidth = width;
  context.stroke();
}

/** An arrow, whose shaft may be dashed; none where it would be shorter than a pixel. */
export function arrow(context, [x0, y0], [x1, y1], { colour, width = 2.5, dash = [] }) {
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

/** The point beside the middle of an arrow, so many pixels from it on the side away from `from`. */
export function beside([x0, y0], [x1, y1], [ax, ay], apart) {
  const [x, y] = [(x0 + x1) / 2, (y0 + y1) / 2];
  const length = Math.hypot(x1 - x0, y1 - y0);
  const across = [(y1 - y0) / length, (x0 - x1) / length];
  const off = (x - ax) * across[0] + (y - ay) * across[1];
  // In line with that point either side will do; the left one is taken.
  const side = Math.abs(off) > 1 ? Math.sign(off) : across[0] > 0 ? -1 : 1;
  return [x + side * apart * across[0], y + side * apart * across[1]];
}

const SHAPES = {
  circle: (context, x, y, r) => context.arc(x, y, r, 0, 2 * Math.PI),
  square: (context, x, y, r) => context.rect(x - 0.9 * r, y - 0.9 * r, 1.8 * r, 1.8 * r),
  triangle: (context, x, y, r) => {
    context.moveTo(x, y - 1.2 * r);
    context.lineTo(x + 1.1 * r, y + 0.8 * r);
    context.lineTo(x - 1.1 * r, y + 0.8 * r);
    context.closePath();
  },
};

/** A filled `shape` of a radius in pixels, with a rim that keeps it apart from what is below. */
export function mark(context, shape, [x, y], { colour, rim, radius = 5 }) {
  context.beginPath();
  SHAPES[shape](context, x, y, radius);
  context.fillStyle = colour;
  context.fill();
  if (!rim) return;
  context.strokeStyle = rim;
  context.lineWidth = 1.5;
  context.stroke();
}

/** Plain words at a point; `align` as on a canvas. */
export function words(context, text, [x, y], { colour, size = 12, align = "left", weight = 400 }) {
  context.font = `${weight} ${size}px system-ui, sans-serif`;
  context.textAlign = align;
  context.textBaseline = "middle";
  context.fillStyle = colour;
  context.fillText(text, x, y);
}

/** Names of curves, [{ text, y, colour, aside }], in a column at x or so far aside of it, each as near to its y as they stay apart. */
export function named(context, x, [top, bottom], names, colours) {
  const apart = 14; // pixels
  const sorted = names.toSorted((a, b) => a.y - b.y).map((each) => ({ ...each, y: Math.min(bottom, Math.max(top, each.y)) }));
  let next = top;
  for (const each of sorted) next = (each.y = Math.max(each.y, next)) + apart;
  next = bottom;
  for (const each of sorted.toReversed()) next = (each.y = Math.min(each.y, next)) - apart;
  for (const { text, y, colour, aside = 0 } of sorted) words(context, text, [x + aside, y], { colour: colours(colour), weight: 600 });
}

/** Draw in a part of the picture, as if it were all of it. */
export function inPart(context, [x, y, width, height], drawIt) {
  context.save();
  context.translate(x, y);
  context.beginPath();
  context.rect(0, 0, width, height);
  context.clip();
  drawIt({ width, height });
  context.restore();
}

/**
 * Numbers from -1 to 1 as bars in rows: [{ text, value, colour, twin }]. A twin is a second
 * number, shown as a ring.
 */
export function bars(context, { width, height }, title, rows, colours) {
  const [left, right, top, bottom] = [30, width - 12, 24, height - 20];
  const step = (bottom - top) / rows.length;
  const x = linear(-1, 1, left, right);
  words(context, title, [8, 12], { colour: colours("muted"), weight: 600 });
  for (const tick of [-1, 0, 1]) {
    line(context, [[x(tick), top], [x(tick), bottom]], { colour: colours(tick === 0 ? "muted" : "line"), width: 1 });
    words(context, `${tick}`.replace("-", "−"), [x(tick), bottom + 10], { colour: colours("muted"), size: 12, align: "center" });
  }
  rows.forEach(({ text, value, colour, twin }, i) => {
    const y = top + step * (i + 0.5);
    words(context, text, [left - 15, y], { colour: colours(colour), size: 14, align: "center", weight: 600 });
    line(context, [[left, y], [right, y]], { colour: colours("line"), width: 1 });
    line(context, [[x(0), y], [x(value), y]], { colour: colours(colour), width: Math.min(10, step / 2) });
    if (twin !== undefined) ringAt(context, [x(twin), y], colours(colour));
  });
}

/** An empty circle round a point in pixels. */
export function ringAt(context, [x, y], colour, { radius = 4, width = 1.5 } = {}) {
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.strokeStyle = colour;
  context.lineWidth = width;
  context.stroke();
}

/** From values between `low` and `high` to pixels between `start` and `end`. */
export const linear = (low, high, start, end) => (value) =>
  start + ((value - low) / (high - low)) * (end - start);

/** The same with equal steps for equal factors. */
export const logarithmic = (low, high, start, end) => {
  const scale = linear(Math.log10(low), Math.log10(high), start, end);
  return (value) => scale(Math.log10(value));
};
