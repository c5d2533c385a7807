/**
 * Solid drawing in a few lines of canvas: frames, polygons, a camera, and an order of painting.
 *
 * A point is an array of three numbers, a rotation a flat row-major array of nine that takes
 * parent coordinates to child coordinates, as `matrixFromEuler` returns it. Coordinates are
 * north-east-down, so that a camera is one more body frame: x into the picture, y to the right,
 * z down the screen.
 */

const NEAR_PLANE = 1e-7; // closer to a plane than this counts as in it

/** Coordinates in the child frame of a vector known in the parent frame. */
export const toChild = (m, [x, y, z]) => [
  m[0] * x + m[1] * y + m[2] * z,
  m[3] * x + m[4] * y + m[5] * z,
  m[6] * x + m[7] * y + m[8] * z,
];

/** Coordinates in the parent frame of a vector known in the child frame. */
export const toParent = (m, [x, y, z]) => [
  m[0] * x + m[3] * y + m[6] * z,
  m[1] * x + m[4] * y + m[7] * z,
  m[2] * x + m[5] * y + m[8] * z,
];

/** The rotation by `later` after that by `first`: the product of two matrices. */
export const times = (later, first) => {
  const columns = [0, 1, 2].map((k) => toChild(later, [first[k], first[3 + k], first[6 + k]]));
  return [0, 1, 2].flatMap((row) => columns.map((column) => column[row]));
};

export const transposed = (m) => [m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]];

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const between = (a, b, t) => a.map((value, i) => value + t * (b[i] - value));
export const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
export const sum = (a, b) => a.map((value, i) => value + b[i]);
export const scaled = (a, factor) => a.map((value) => value * factor);
const unit = (a) => scaled(a, 1 / (Math.hypot(...a) || 1));

/**
 * A camera that looks at the origin with attitude `matrix` from `distance` away. It shows at
 * least `wide` by `high` units round the origin; `shift` moves what it shows down by so many.
 */
export function camera(matrix, distance, { width, height }, { wide, high, shift }) {
  const eye = toParent(matrix, [-distance, 0, 0]);
  const zoom = Math.min(width / wide, height / high) * distance;
  const project = (point) => {
    const [depth, right, down] = toChild(matrix, point);
    const perspective = zoom / (distance + depth);
    return [width / 2 + perspective * right, height / 2 + perspective * (down + shift)];
  };
  // The way from the eye through a point of the picture, where nothing is shifted.
  const ray = ([x, y]) => toParent(matrix, [1, (x - width / 2) / zoom, (y - height / 2) / zoom]);
  // The light stands above the viewer's left shoulder.
  return { eye, project, ray, light: unit(toParent(matrix, [-1, -0.55, -1])) };
}

// ── polygons ────────────────────────────────────────────────────────────────────────────────
// { points, fill: [red, green, blue], unlit?: no shading, open?: seen from both sides }
// The corners of a closed polygon run clockwise as seen from outside.

function plane(points) {
  // Newell's normal: right for any flat polygon, whichever corners happen to be in line.
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

/** A polygon with the plane that it lies in. */
export const flat = (polygon) => ({ ...polygon, plane: plane(polygon.points) });

const isSeen = ({ plane: { normal, offset }, open }, eye) => open || dot(normal, eye) > offset;

/** Those of some `flat` polygons that are seen, where `matrix` places them. */
export function placed(polygons, matrix, { eye }) {
  const from = toChild(matrix, eye);
  return polygons.filter((polygon) => isSeen(polygon, from)).map(({ points, fill, plane: { normal, offset } }) => ({
    points: points.map((point) => toParent(matrix, point)),
    fill,
    plane: { normal: toParent(matrix, normal), offset },
  }));
}

/** A view as it is in the axes of a body of some size that `matrix` places. */
export const viewIn = ({ eye, light, project }, matrix, size = 1) => ({
  eye: scaled(toChild(matrix, eye), 1 / size),
  light: toChild(matrix, light),
  project: (point) => project(toParent(matrix, scaled(point, size))),
});

/**
 * A closed band of quadrilaterals over successive outlines, and a cap at either end. The
 * outlines run clockwise for one who looks from the first towards the last.
 */
export function loft(outlines, fill) {
  const sides = outlines.slice(1).flatMap((outline, i) =>
    outline.map((point, j) => {
      const next = (j + 1) % outline.length;
      return { points: [outlines[i][next], outlines[i][j], point, outline[next]], fill };
    }),
  );
  const caps = [outlines[0], [...outlines.at(-1)].reverse()].map((points) => ({ points, fill }));
  return [...sides, ...caps];
}

/**
 * A ring of rectangular section round the origin, in the plane of the unit vectors `u` and `v`.
 * `mark(i)` says which of `count` segments carry the colour `marked` on their flat faces.
 */
export function ring({ u, v, inner, outer, depth, fill, marked, mark, count = 36 }) {
  const axis = cross(u, v);
  const at = (i, radius, height) => {
    const angle = (2 * Math.PI * i) / count;
    return [0, 1, 2].map(
      (k) => radius * (u[k] * Math.cos(angle) + v[k] * Math.sin(angle)) + height * axis[k],
    );
  };
  const wall = (i, radius, low, high) => [
    at(i, radius, low), at(i, radius, high), at(i + 1, radius, high), at(i + 1, radius, low),
  ];
  const face = (i, a, b, height) => [
    at(i, a, height), at(i, b, height), at(i + 1, b, height), at(i + 1, a, height),
  ];
  return Array.from({ length: count }, (_, i) => {
    const colour = mark(i) ? marked : fill;
    return [
      { points: face(i, outer, inner, depth), fill: colour },
      { points: face(i, inner, outer, -depth), fill: colour },
      { points: wall(i, outer, -depth, depth), fill },
      { points: wall(i, inner, depth, -depth), fill },
    ];
  }).flat();
}

const acrossAs = (start, end, eye) => unit(cross(minus(end, start), minus(eye, start)));

/** A flat strip from point to point that turns its broad side to the eye. */
export function strip(points, width, fill, eye) {
  return points.slice(1).map((end, i) => {
    const start = points[i];
    const half = scaled(acrossAs(start, end, eye), width / 2);
    const corners = [sum(start, half), sum(end, half), minus(end, half), minus(start, half)];
    return { points: corners, fill, unlit: true, open: true };
  });
}

/** A flat triangle from `start`, where it is widest, to its point, turned to the eye as well. */
export function arrowhead(start, point, width, fill, eye) {
  const half = scaled(acrossAs(start, point, eye), width / 2);
  return { points: [sum(start, half), point, minus(start, half)], fill, unlit: true, open: true };
}

// ── order of painting ───────────────────────────────────────────────────────────────────────

/** Whether a polygon reaches above a plane, and below it. */
function sides({ normal, offset }, points) {
  let [above, below] = [false, false];
  for (const point of points) {
    const height = dot(normal, point) - offset;
    above ||= height > NEAR_PLANE;
    below ||= height < -NEAR_PLANE;
  }
  return [above, below];
}

/** `flat` polygons in an order in which a partition cuts few: first those whose planes cut the fewest others. */
export function sparing(polygons) {
  const cuts = ({ plane: cut }) => polygons.filter(({ points }) => sides(cut, points).every(Boolean)).length;
  return polygons.map((polygon) => [cuts(polygon), polygon]).sort(([a], [b]) => a - b).map(([, polygon]) => polygon);
}

/**
 * A binary space partition of `flat` polygons. Sorting by distance fails where a polygon reaches
 * both behind and in front of another; here the plane of the first one cuts all others in two.
 */
export function partition(polygons) {
  if (polygons.length === 0) return null;
  const [first, ...rest] = polygons;
  const cut = first.plane;
  const within = [first];
  const front = [];
  const behind = [];
  for (const polygon of rest) {
    const [above, below] = sides(cut, polygon.points);
    if (above && below) {
      const heights = polygon.points.map((point) => dot(cut.normal, point) - cut.offset);
      front.push({ ...polygon, points: clipped(polygon.points, heights, 1) });
      behind.push({ ...polygon, points: clipped(polygon.points, heights, -1) });
    } else (above ? front : below ? behind : within).push(polygon);
  }
  return { cut, within, front: partition(front), behind: partition(behind) };
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

/** Call `visit` for each polygon of a partition, from the farthest to the nearest. */
export function fromBehind(tree, eye, visit) {
  if (tree === null) return;
  const seenFromFront = dot(tree.cut.normal, eye) > tree.cut.offset;
  fromBehind(seenFromFront ? tree.behind : tree.front, eye, visit);
  tree.within.forEach(visit);
  fromBehind(seenFromFront ? tree.front : tree.behind, eye, visit);
}

/**
 * The polygons in sets to be painted one after the other, where all stand in shells round the
 * origin: `radii` are those of the spheres between the shells, from the outermost one. What is on
 * the far side of a sphere is behind all that is in it, and what is on the near side before it.
 */
function inShells(polygons, radii, eye) {
  const sets = Array.from({ length: 2 * radii.length + 1 }, () => []);
  for (const polygon of polygons) {
    const centre = scaled(polygon.points.reduce(sum), 1 / polygon.points.length);
    const shell = radii.findIndex((radius) => Math.hypot(...centre) > radius);
    const nearer = dot(centre, minus(eye, centre)) > 0;
    sets[shell < 0 ? radii.length : nearer ? sets.length - 1 - shell : shell].push(polygon);
  }
  return sets;
}

/**
 * Paint polygons, hidden parts removed and flat shaded, on a 2-d canvas context. In the midst of the
 * shells stands a `body`, if there is one: a partition of its own, with the view in its own axes.
 */
export function paint(context, polygons, view, radii = [], body = null) {
  const visible = polygons.map((polygon) => (polygon.plane ? polygon : flat(polygon))).filter((polygon) => isSeen(polygon, view.eye));
  // What follows with the same fill in the same light is one area, whatever the colours are; an open
  // polygon, which may run either way, is its own.
  let [filled, lit] = [null, 0];
  context.lineWidth = 0.6;
  const finish = () => {
    if (filled === null) return;
    const colour = rgb(scaled(filled, lit)); // reading it back from the context takes longer than painting
    context.fillStyle = colour;
    context.strokeStyle = colour; // covers the hairline between neighbours
    context.fill();
    context.stroke();
  };
  const visitIn = ({ eye, light, project }) => (polygon) => {
    if (!isSeen(polygon, eye)) return;
    const { points, fill, unlit, open, plane: { normal } } = polygon;
    const brightness = unlit ? 1 : 0.62 + 0.4 * Math.max(0, dot(normal, light));
    if (fill !== filled || brightness !== lit || open) {
      finish();
      context.beginPath();
      [filled, lit] = [fill, brightness];
    }
    points.forEach((point, i) => context[i === 0 ? "moveTo" : "lineTo"](...project(point)));
    context.closePath();
  };
  inShells(visible, radii, view.eye).forEach((each, i) => {
    fromBehind(partition(each), view.eye, visitIn(view));
    if (body && i === radii.length) fromBehind(body.tree, body.view.eye, visitIn(body.view));
  });
  finish();
}

/**
 * Words at a point of the picture, over everything, with a rim that keeps them legible: [words]
 * or [words, subscript]. `offset` moves them aside, in pixels; they never leave the picture, and
 * stand to the right of what is at its upper edge, or its lower one, where they know its `height`.
 * Where one of the boxes `taken` is in the way, { x, y, half, high } round its middle, they stand
 * above or below it, still in the picture; their own one is added.
 */
export function label(context, [text, subscript = ""], [x, y], { colour, rim, size = 14, offset = [0, 0], width, height = Infinity, taken = [] }) {
  const parts = [
    { text, font: `600 ${size}px system-ui, sans-serif`, drop: 0 },
    { text: subscript, font: `600 ${0.85 * size}px system-ui, sans-serif`, drop: 0.3 * size },
  ].filter((part) => part.text !== "").map((part) => {
    context.font = part.font;
    return { ...part, wide: context.measureText(part.text).width };
  });
  const half = parts.reduce((wide, part) => wide + part.wide, 0) / 2;
  const side = offset[0] === 0 ? 0 : Math.sign(offset[0]) * half + offset[0];
  const [high, low] = [0.6 * size, height - 0.6 * size];
  const inside = Math.min(Math.max(y + offset[1], high), low) - y - offset[1]; // from above or below the picture
  const middle = Math.min(Math.max(x + side + (inside && half + 16), half + 6), width - half - 6);
  const lines = [0, -1, 1, -2, 2, -3, 3].map((n) => y + offset[1] + inside + 1.1 * n * size);
  const covers = (at) => (box) => Math.abs(box.x - middle) < box.half + half + 2 && Math.abs(box.y - at) < box.high + size / 2;
  const line = lines.find((at) => at >= high && at <= low && !taken.some(covers(at))) ?? lines[0];
  taken.push({ x: middle, y: line, half, high: size / 2 });
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
      context[write](part.text, start, line + part.drop);
      start += part.wide;
    }
  }
}

// ── colours ─────────────────────────────────────────────────────────────────────────────────

/** `#rrggbb` as three numbers from 0 to 255. */
export const parsed = (hex) => [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16));

/** A colour on the way from one to another. */
export const mixed = (a, b, t) => between(a, b, t);

export const rgb = (channels) =>
  `rgb(${channels.map((value) => Math.round(Math.min(255, value))).join(" ")})`;
