/** A small aeroplane in its body frame: x forward, y right, z down, half a unit from nose to centre. */
import { loft } from "./draw.js";

const CORNERS = 10; // of a section of the fuselage

// x, half width, half height, height of the middle: from the tail forward
const SECTIONS = [
  [-0.55, 0.012, 0.02, -0.05],
  [-0.42, 0.035, 0.045, -0.035],
  [-0.15, 0.075, 0.085, -0.01],
  [0.12, 0.085, 0.09, 0],
  [0.32, 0.07, 0.07, 0.01],
  [0.45, 0.04, 0.042, 0.018],
];
const TIP = [0.54, 0.008, 0.008, 0.02];

const section = ([x, wide, high, middle]) =>
  Array.from({ length: CORNERS }, (_, i) => {
    const angle = (2 * Math.PI * (i + 0.5)) / CORNERS;
    return [x, wide * Math.cos(angle), middle + high * Math.sin(angle)];
  });

// A thin plate between a root and a tip, both [leading x, trailing x, y, z, half thickness].
const plate = (root, tip, fill, upright = false) => {
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
 * Polygons of the aeroplane. Nose, right wing tip and belly carry the colours of the axes that
 * they point along.
 */
export function aircraft({ body, glass, x, y, z }) {
  const wing = plate([0.2, -0.1, 0.06, 0.02, 0.022], [0.04, -0.09, 0.42, -0.005, 0.012], body);
  const tip = plate([0.04, -0.09, 0.42, -0.005, 0.012], [0.0, -0.085, 0.53, -0.013, 0.008], y);
  const bare = plate([0.04, -0.09, 0.42, -0.005, 0.012], [0.0, -0.085, 0.53, -0.013, 0.008], body);
  const tail = plate([-0.38, -0.52, 0.02, -0.05, 0.012], [-0.46, -0.53, 0.2, -0.06, 0.006], body);
  const fin = plate([-0.3, -0.52, 0, -0.05, 0.012], [-0.46, -0.56, 0, -0.25, 0.006], body, true);
  const canopy = loft(
    [
      section([0.02, 0.035, 0.03, -0.085]),
      section([0.12, 0.05, 0.055, -0.085]),
      section([0.24, 0.045, 0.045, -0.07]),
      section([0.33, 0.02, 0.02, -0.05]),
    ],
    glass,
  );
  const belly = loft([section([-0.05, 0.03, 0.02, 0.085]), section([0.15, 0.03, 0.02, 0.085])], z);
  return [
    ...loft(SECTIONS.map(section), body),
    ...loft([SECTIONS.at(-1), TIP].map(section), x),
    ...wing, ...tip, ...tail,
    ...mirrored([...wing, ...bare, ...tail]),
    ...fin, ...canopy, ...belly,
  ];
}
