/** Noise that is the same in Python: noise.py says how it is made. */

/* global MULTIPLIER, MODULUS: build.py puts them in */

/** Rows of noise of variance 1, each value the sum of four even chances. */
export function noise(rows, columns, seed) {
  let last = seed;
  const chance = () => (last = (MULTIPLIER * last) % MODULUS) / MODULUS;
  const one = () => Math.sqrt(3) * (chance() + chance() + chance() + chance() - 2);
  return Array.from({ length: rows }, () => Array.from({ length: columns }, one));
}
