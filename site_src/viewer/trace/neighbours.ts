/** Which rays lie beside a ray in the picture and came there by the same bounces. */

export const ABSENT = -1; // kind and group of a ray that stores nothing in a column

/** Rows of the neighbours by row, -1 where there is none. */
export interface Sides {
  left: Int32Array;
  up: Int32Array;
  upLeft: Int32Array;
  upRight: Int32Array;
}

export const noSides = (count: number): Sides => ({
  left: new Int32Array(count), up: new Int32Array(count), upLeft: new Int32Array(count), upRight: new Int32Array(count),
});

/** Writes the rays beside each of the n x n camera rays. */
export function fillRaster(n: number, { left, up, upLeft, upRight }: Sides) {
  for (let k = 0, row = 0; row < n; row++)
    for (let column = 0; column < n; column++, k++) {
      left[k] = column > 0 ? k - 1 : -1;
      up[k] = row > 0 ? k - n : -1;
      upLeft[k] = row > 0 && column > 0 ? k - n - 1 : -1;
      upRight[k] = row > 0 && column < n - 1 ? k - n + 1 : -1;
    }
}

/** Writes, for these rows, the sides that are of a ray's group. */
export function alike(rows: Int32Array, group: Int32Array, sides: Sides, out: Sides) {
  const { left, up, upLeft, upRight } = sides;
  const { left: outLeft, up: outUp, upLeft: outUpLeft, upRight: outUpRight } = out;
  for (let k = 0; k < rows.length; k++) {
    const row = rows[k], mine = group[row];
    const l = left[row], u = up[row], ul = upLeft[row], ur = upRight[row];
    outLeft[row] = l >= 0 && group[l] === mine ? l : -1;
    outUp[row] = u >= 0 && group[u] === mine ? u : -1;
    outUpLeft[row] = ul >= 0 && group[ul] === mine ? ul : -1;
    outUpRight[row] = ur >= 0 && group[ur] === mine ? ur : -1;
  }
}
