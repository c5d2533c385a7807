/** Linear equations, by elimination with the largest pivot. */

const SINGULAR = 1e-13; // of the largest element: a smaller pivot is what rounding leaves of none

/** The solution of `matrix` (rows) times x = `right`; null where there is no one solution. */
export function solved(matrix, right) {
  const rows = matrix.map((row, i) => [...row, right[i]]);
  const size = Math.max(...matrix.flat().map(Math.abs));
  for (let k = 0; k < rows.length; k++) {
    const pivot = rows.slice(k).reduce((best, row, i) => (Math.abs(row[k]) > Math.abs(rows[best][k]) ? k + i : best), k);
    [rows[k], rows[pivot]] = [rows[pivot], rows[k]];
    if (!(Math.abs(rows[k][k]) > SINGULAR * size)) return null;
    for (let i = k + 1; i < rows.length; i++) {
      const factor = rows[i][k] / rows[k][k];
      for (let j = k; j <= rows.length; j++) rows[i][j] -= factor * rows[k][j];
    }
  }
  const found = [];
  for (let k = rows.length - 1; k >= 0; k--) {
    const known = rows[k].slice(k + 1, -1).reduce((total, factor, i) => total + factor * found[k + 1 + i], 0);
    found[k] = (rows[k].at(-1) - known) / rows[k][k];
  }
  return found;
}
