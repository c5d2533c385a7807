/** The rotation nearest to a matrix, for numbers that were printed with few digits. */
import { rotationDefect } from "../generated/javascript/attitude.mjs";
import { cross, scaled } from "./draw.js";

const STEPS = 60;
const SETTLED = 4e-16;
const ALONE = 5; // so many times nearer to a rotation must one number bring a matrix

/** Cofactors and determinant of a matrix: its inverse transposed, and that which divides it. */
function cofactors(m) {
  const rows = [0, 3, 6].map((i) => m.slice(i, i + 3));
  const made = rows.map((_, i) => cross(rows[(i + 1) % 3], rows[(i + 2) % 3]));
  return [made.flat(), rows[0].reduce((total, value, i) => total + value * made[0][i], 0)];
}

/**
 * The nearest rotation in the sense of least squares, by Newton's iteration: the mean of a matrix and
 * of its inverse transposed, again and again. Null where there is none: without three directions, or
 * where a reflection is nearer.
 */
export function nearestRotation(matrix) {
  const size = Math.max(...matrix.map(Math.abs));
  let now = scaled(matrix, 1 / size);
  for (let step = 0; step < STEPS; step++) {
    const [parts, determinant] = cofactors(now);
    if (!(determinant > 1e-9)) return null;
    const next = now.map((value, i) => (value + parts[i] / determinant) / 2);
    const moved = Math.max(...next.map((value, i) => Math.abs(value - now[i])));
    now = next;
    if (moved < SETTLED) break;
  }
  return now;
}

/**
 * The one number that is wrong in what would else be a rotation: { place, value }, where it stands in
 * the flat matrix and what would fit; null if no single one explains it. In a rotation each element is
 * its own cofactor, which the element itself has no part in.
 */
export function misprint(matrix) {
  const [parts] = cofactors(matrix);
  const mended = parts.map((value, place) => {
    const [defect, determinant] = rotationDefect(...matrix.map((each, i) => (i === place ? value : each)));
    return { place, value, defect: determinant > 0 ? defect : Infinity };
  });
  const [best, second] = mended.sort((a, b) => a.defect - b.defect);
  const [defect] = rotationDefect(...matrix);
  return ALONE * best.defect < defect && 2 * best.defect <= second.defect ? { place: best.place, value: best.value } : null;
}

/** The same in words, with a space before them. */
export function misprintWords(matrix) {
  const one = misprint(matrix);
  if (one === null) return "";
  const place = `row ${Math.floor(one.place / 3) + 1}, column ${(one.place % 3) + 1}`;
  return ` One number alone would explain it: ${place}, ${matrix[one.place]}, where ${Number(one.value.toPrecision(4))} would fit.`;
}
