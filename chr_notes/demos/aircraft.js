/** A small aircraft in its body frame: x forward, y right, z down, half a unit from nose to centre. */
import { flat, loft, partition, sparing } from "./draw.js";
import { keeping } from "./keeping.js";

/* global AIRCRAFT: build.py puts in the table of chr_notes/aircraft.py */

const CORNERS = 10; // of a section of the fuselage

const section = ([x, wide, high, middle]) =>
  Array.from({ length: CORNERS }, (_, i) => {
    const angle = (2 * Math.PI * (i + 0.5)) / CORNERS;
    return [x, wide * Math.cos(angle), middle + high * Math.sin(angle)];
  });

// A thin plate between a root and a tip.
const plate = ([root, tip], fill, upright = false) => {
  const outline = ([front, back, side, height, half]) => {
    const at = (x, offset) => (upright ? [x, offset, height] : [x, side, height + offset]);
    const thickest = (2 * front + back) / 3;
    return [at(front, 0), at(thickest, -half), at(back, 0), at(thickest, half)];
  };
  return loft([outline(root), outline(tip)], fill);
};

const mirrored = (polygons) =>
  polygons.map((polygon) => ({
    ...polygon,
    points: polygon.points.map(([x, y, z]) => [x, -y, z]).reverse(),
  }));

/**
 * A partition of the aircraft's polygons, which is made once, in its own axes. Nose, right wing tip
 * and belly carry the colours of the axes that they point along.
 */
export const aircraft = keeping(["body", "glass", "x", "y", "z"], ({ body, glass, x, y, z }) => {
  const { sections, wing, ...other } = AIRCRAFT;
  const inner = plate(wing.slice(0, 2), body);
  const [right, left] = [y, body].map((fill) => plate(wing.slice(1), fill));
  const tail = plate(other.tail, body);
  return partition(sparing([
    ...loft(sections.slice(0, -1).map(section), body),
    ...loft(sections.slice(-2).map(section), x),
    ...inner, ...right, ...tail,
    ...mirrored([...inner, ...left, ...tail]),
    ...plate(other.fin, body, true),
    ...loft(other.canopy.map(section), glass),
    ...loft(other.belly.map(section), z),
  ].map(flat)));
});
