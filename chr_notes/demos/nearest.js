/** The rotation nearest to a matrix, for numbers that were printed with few digits. */
import { cross, scaled } from "./draw.js";

const STEPS = 60;
const SETTLED = 4e-16;

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
