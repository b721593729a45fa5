/** A scene's right picture and the wrong ones that its mistakes make, each on one grid: what a student's picture is held against. */
/** How much nearer to the middle than they belong things are drawn, across and down: negative, if also on the other side. */
export type Factors = [number, number];

/** As build/raywalk/check/write.py writes it. */
export interface About {
  scene: string;
  grid: number; // the atlas' pictures are grid x grid
  own: number[]; // sizes that are parts of the scene's picture; the last is its own
  others: number[]; // sizes with a picture of their own
  grids: number[]; // of the frustum, whose pixels can be walked
  mistakes: { name: string; family: string; wrong: number[]; drawnIn?: Factors }[];
  leftOut: "" | "meshes" | "textures" | "lamps"; // why there are no mistakes
}

export interface Atlas {
  scene: string;
  size: number; // the grid is size x size
  right: Uint8Array; // red, green, blue, row by row
  /**
   * A second picture stands where it hangs on roundings (a shadow ray that meets its own surface): made in float32 by a program
   * with an offset, as most students' are.
   */
  mistakes: { name: string; family: string; pictures: Uint8Array[]; drawnIn?: Factors }[];
}

/** strips: bytes of pictures, one after the other, the right one first, then what others differ from it by, modulo 256. */
export function atlasOf({ scene, grid, mistakes }: Pick<About, "scene" | "grid" | "mistakes">, strips: Uint8Array): Atlas {
  const bytes = 3 * grid * grid;
  const strip = (k: number) => {
    const padded = new Uint8Array(4 * Math.ceil(bytes / 4));
    padded.set(strips.subarray(k * bytes, (k + 1) * bytes));
    return padded;
  };
  const right = strip(0);
  const wrong = (k: number) => {
    const laid = strip(k);
    addBytes(laid, right);
    return laid.subarray(0, bytes);
  };
  return { scene, size: grid, right: right.subarray(0, bytes), mistakes: mistakes.map(({ wrong: places, ...each }) => ({ ...each, pictures: places.map(wrong) })) };
}

const [LOW_BITS, TOP_BITS] = [0x7f7f7f7f, 0x80808080];

/** Modulo 256, four at a time: low bits carry no further than the top bit of their byte, where bits are added without a carry. */
function addBytes(to: Uint8Array<ArrayBuffer>, what: Uint8Array<ArrayBuffer>): void {
  const [sums, other] = [new Uint32Array(to.buffer), new Uint32Array(what.buffer)];
  for (let i = 0; i < sums.length; i++) sums[i] = ((sums[i] & LOW_BITS) + (other[i] & LOW_BITS)) ^ ((sums[i] ^ other[i]) & TOP_BITS);
}
