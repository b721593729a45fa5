/** Numbers that are the same ones for the same seed. */

/** Mulberry32: numbers in 0..1, enough for a monkey and for choosing pixels. */
export function randomFrom(seed) {
  let at = seed >>> 0;
  return () => {
    at = (at + 0x6d2b79f5) >>> 0;
    let t = Math.imul(at ^ (at >>> 15), at | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

/** A pixel of an n x n grid. */
export const pixelOf = (random, n) => [random(), random()].map((share) => Math.floor(n * share));
