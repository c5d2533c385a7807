/**
 * The opening state of a demo as an SVG, drawn by the demo itself on a context that writes down
 * what it is told. Run by build.py: reads [{ demo, state }] and the colours, writes the pictures.
 */
import { mount as converter } from "./converter.js";
import { DEMOS } from "./demos.js";
import { parsed } from "./draw.js";

const WIDTH = 380;
const PER_LETTER = 0.56; // of the size: about as wide as a letter is

const FINE = 2; // units of the picture to a pixel, all of them whole
const SPECK = 48; // twice the area, in square units, up to which the edges of neighbours cover a facet

const NAMES = new Map(); // of the rules for dark pages, the same in all pictures, which are packed together

const whole = (value) => Math.round(FINE * value);
const escaped = (text) => text.replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/"/g, "&quot;");

/** Twice the area of a path, positive where it runs clockwise on the screen. */
const area = (points) =>
  points.reduce((total, [x, y], i) => {
    const [u, v] = points[(i + 1) % points.length];
    return total + x * v - u * y;
  }, 0);

/** Points without those that are where the one before them is. */
const apart = (points, closed) =>
  points.filter(([x, y], i) => {
    const [u, v] = i > 0 ? points[i - 1] : closed ? points.at(-1) : [];
    return x !== u || y !== v;
  });

/** Corners of a facet on whole pixels, where its neighbours have theirs. */
const pixels = (points) => apart(points.map((point) => point.map((value) => FINE * Math.round(value / FINE))), true);

/** Points of an area without those on the straight line between their neighbours. */
const corners = (points) =>
  Object.assign(points.filter(([x, y], i) => {
    const [[u, v], [p, q]] = [points.at(i - 1), points[(i + 1) % points.length]];
    return (x - u) * (q - y) !== (y - v) * (p - x);
  }), { closed: true });

/** Whether a place is inside an area: a line from it to the right crosses the outline once, or thrice. */
const inside = ([x, y], points) =>
  points.reduce((odd, [u, v], i) => {
    const [p, q] = points.at(i - 1);
    return v > y !== q > y && x < u + ((y - v) * (p - u)) / (q - v) ? !odd : odd;
  }, false);

/** Places that show whether an area is hidden: a little inside of its corners and of its edges' middles. */
function places(points) {
  const between = ([x, y], [u, v], part) => [x + part * (u - x), y + part * (v - y)];
  const middle = points.reduce((sum, [x, y]) => [sum[0] + x / points.length, sum[1] + y / points.length], [0, 0]);
  const outline = points.flatMap((point, i) => [point, between(point, points.at(i - 1), 0.5)]);
  return outline.map((point) => between(point, middle, 0.1));
}

/** Parts without the facets that later ones hide. */
function seen(parts) {
  const above = {}; // facets by what they are clipped to
  const shown = (part) => {
    const others = (above[part.clipped] ??= []);
    const hidden = (points) => places(points).every((place) => others.some((other) => inside(place, other)));
    return part.shapes.reduceRight((kept, points) => {
      if (hidden(points)) return kept;
      others.push(points);
      return [points, ...kept];
    }, []);
  };
  return parts.reduceRight((kept, part) => {
    if (part.facet) part.shapes = shown(part);
    return part.shapes?.length === 0 ? kept : [part, ...kept];
  }, []);
}

/** Whole numbers in as few letters as can be. */
const listed = (numbers) => numbers.join(" ").replace(/ -/g, "-");

/** Shapes as the data of a path: each begins as seen from where the last one left the pen. */
function written(shapes) {
  let pen;
  return shapes.map((points) => {
    if (points.circle) {
      const [[x, y], r] = points.circle;
      pen = undefined;
      return `M${listed([x - r, y].map(whole))}a${listed([r, r].map(whole))} 0 1 1 0 .1z`;
    }
    const steps = points.slice(1).flatMap(([x, y], i) => [x - points[i][0], y - points[i][1]]);
    const start = pen ? `m${listed([points[0][0] - pen[0], points[0][1] - pen[1], ...steps])}` : `M${listed(points[0])}l${listed(steps)}`;
    pen = points.closed ? points[0] : points.at(-1);
    return `${start}${points.closed ? "z" : ""}`;
  }).join("");
}

/** What of a canvas context the demos use. `twins` are the colours that another drawing was given, in order. */
class Recorder {
  constructor(twins = []) {
    Object.assign(this, { parts: [], stack: [], clips: 0, defs: [], offset: [0, 0], clipped: "", dash: [] });
    Object.assign(this, { twins, given: [], rules: new Set(), lineWidth: 1, font: "", textAlign: "left" });
  }
  /** A colour in both themes, [light, dark] in one string. */
  paired(colour) {
    this.given.push(colour);
    return colour.includes("|") ? colour : `${colour}|${this.twins[this.given.length - 1] ?? colour}`;
  }
  set fillStyle(colour) {
    this.filling = this.paired(colour);
  }
  get fillStyle() {
    return this.filling;
  }
  set strokeStyle(colour) {
    this.stroking = this.paired(colour);
  }
  get strokeStyle() {
    return this.stroking;
  }
  /** Attributes for a colour in both themes: the light one, and a class that has the dark one. */
  paint(property, colour) {
    const [light, dark] = colour.split("|");
    const rule = `${property}:${dark}`;
    if (!NAMES.has(rule)) NAMES.set(rule, `s${NAMES.size.toString(36)}`);
    this.rules.add(rule);
    return `class="${NAMES.get(rule)}" ${property}="${light}"`;
  }
  save() {
    const { offset, clipped, dash, filling, stroking, lineWidth, font, textAlign } = this;
    this.stack.push({ offset, clipped, dash, filling, stroking, lineWidth, font, textAlign });
  }
  restore() {
    Object.assign(this, this.stack.pop());
  }
  translate(x, y) {
    this.offset = [this.offset[0] + x, this.offset[1] + y];
  }
  beginPath() {
    this.paths = [];
  }
  at(x, y) {
    return [x + this.offset[0], y + this.offset[1]];
  }
  moveTo(x, y) {
    this.paths.push([this.at(x, y)]);
  }
  lineTo(x, y) {
    if (this.paths.length === 0) this.moveTo(x, y);
    else this.paths.at(-1).push(this.at(x, y));
  }
  closePath() {
    this.paths.at(-1).closed = true;
  }
  rect(x, y, width, height) {
    this.paths.push([this.at(x, y), this.at(x + width, y), this.at(x + width, y + height), this.at(x, y + height)]);
    this.closePath();
  }
  arc(x, y, radius) {
    this.paths.push(Object.assign([], { circle: [this.at(x, y), radius] }));
  }
  clip() {
    const name = `c${(this.clips += 1)}`;
    this.defs.push(`<clipPath id="${name}"><path d="${written(this.shapes())}"/></clipPath>`);
    this.clipped = ` clip-path="url(#${name})"`;
  }
  setLineDash(dash) {
    this.dash = dash;
  }
  /** The path in whole units; all areas run the same way, so that none cuts another. */
  shapes() {
    return this.paths.map((points) => {
      if (points.circle) return points;
      const ordered = points.closed && area(points) < 0 ? [...points].reverse() : points;
      const kept = apart(ordered.map((point) => point.map(whole)), points.closed);
      return Object.assign(kept, { closed: points.closed });
    }).filter((points) => points.circle || points.length > 1);
  }
  fill() {
    const shapes = this.shapes();
    if (shapes.length > 0) this.parts.push({ shapes, clipped: this.clipped, filled: this.fillStyle });
  }
  stroke() {
    const [last, shapes] = [this.parts.at(-1), this.shapes()];
    if (shapes.length === 0) return;
    if (last?.filled === this.strokeStyle && written(last.shapes) === written(shapes)) this.facet(last);
    else {
      const dash = this.dash.length > 0 ? ` stroke-dasharray="${this.dash.map(whole).join(" ")}"` : "";
      const line = `fill="none" ${this.paint("stroke", this.strokeStyle)} stroke-width="${whole(this.lineWidth)}"${dash}`;
      if (last?.line === line && last.clipped === this.clipped && dash === "") last.shapes.push(...shapes);
      else this.parts.push({ shapes, clipped: this.clipped, line });
    }
  }
  /** Make facets of the areas just filled, whose edge has their colour, and one with those before them. */
  facet(last) {
    last.facet = coarse(last.filled);
    last.shapes = last.shapes.map((points) => corners(pixels(points))).filter((points) => Math.abs(area(points)) > SPECK);
    const before = this.parts.at(-2);
    if (before?.facet === last.facet) before.shapes.push(...last.shapes);
    if (before?.facet === last.facet || last.shapes.length === 0) this.parts.pop();
  }
  fillRect(...box) {
    this.beginPath();
    this.rect(...box);
    this.fill();
  }
  measureText(text) {
    return { width: PER_LETTER * parseFloat(this.font.match(/([\d.]+)px/)[1]) * text.length };
  }
  strokeText(text, x, y) {
    this.text(text, x, y, ` ${this.paint("stroke", this.strokeStyle)} stroke-width="${whole(this.lineWidth)}"`);
  }
  fillText(text, x, y) {
    this.text(text, x, y, ` ${this.paint("fill", this.fillStyle)}`);
  }
  text(text, x, y, paint) {
    const [, weight, size] = this.font.match(/^(\d+) ([\d.]+)px/);
    const anchor = { left: "", center: ' text-anchor="middle"', right: ' text-anchor="end"' }[this.textAlign];
    const [u, v] = this.at(x, y);
    const place = `x="${whole(u)}" y="${whole(v + 0.35 * size)}" font-size="${whole(size)}"`;
    this.parts.push({ text: `<text ${place}${weight > 400 ? ` font-weight="${weight}"` : ""}${anchor}${paint}>${escaped(text)}</text>` });
  }
  svg(pixels, title, page) {
    const parts = seen(this.parts);
    const drawn = parts.map((part, i) => {
      if (part.text) return part.text;
      if (!part.facet) return `<path ${part.line ?? this.paint("fill", part.filled)}${part.clipped} d="${written(part.shapes)}"/>`;
      const path = `<path ${this.paint("color", part.facet)} d="${written(part.shapes)}"/>`;
      const [opens, closes] = [!parts[i - 1]?.facet, !parts[i + 1]?.facet];
      return `${opens ? `<g fill="currentColor" stroke="currentColor"${part.clipped}>` : ""}${path}${closes ? "</g>" : ""}`;
    });
    const [width, height] = [WIDTH, pixels].map(whole);
    const ground = this.paint("fill", page);
    const dark = [...this.rules].map((rule) => `.${NAMES.get(rule)}{${rule}}`).sort().join("");
    return (
      `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" font-family="system-ui,sans-serif" stroke-linejoin="round">` +
      `<title>${escaped(title)}</title><style>@media(prefers-color-scheme:dark){${dark}}</style><defs>${this.defs.join("")}</defs>` +
      `<path ${ground} d="M0 0h${width}v${height}H0z"/>${drawn.join("")}</svg>\n`
    );
  }
}

/** A colour `rgb(…)` or `#rrggbb` in both themes with one digit a channel, so that neighbours share it. */
function coarse(colours) {
  const one = (colour) => {
    const channels = colour.startsWith("#") ? parsed(colour) : colour.match(/\d+/g).map(Number);
    return `#${channels.map((value) => Math.round(value / 17).toString(16)).join("")}`;
  };
  return colours.split("|").map(one).join("|");
}

/** The SVG of a state, for both themes; without its style it is the one of the light theme. */
function still({ demo, state }, [light, dark]) {
  const { definition } = { ...DEMOS, converter }[demo];
  const full = { ...definition.start, ...state };
  const height = Math.round(WIDTH * definition.aspect);
  const drawn = (palette, twins) => {
    const recorder = new Recorder(twins);
    definition.draw(recorder, { width: WIDTH, height }, full, (name) => palette[name], definition.viewpoint?.(full));
    return recorder;
  };
  const both = drawn(light, drawn(dark).given);
  return both.svg(height, definition.describe(full), `${light.page}|${dark.page}`);
}

const { stills, palettes } = JSON.parse(await new Response(process.stdin).text());
process.stdout.write(JSON.stringify(stills.map((each) => still(each, palettes))));
