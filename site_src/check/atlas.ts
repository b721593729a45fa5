/** A scene's right picture and the wrong ones that its mistakes make, each on one grid: what a student's picture is held against. */
/** As build/raywalk/check/write.py writes it. */
export interface About {
  scene: string;
  grid: number; // the atlas' pictures are grid x grid
  own: number[]; // sizes that are parts of the scene's picture; the last is its own
  others: number[]; // sizes with a picture of their own
  grids: number[]; // of the frustum, whose pixels can be walked
  mistakes: { name: string; family: string; wrong: number[] }[];
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
  mistakes: { name: string; family: string; pictures: Uint8Array[] }[];
}

/** strips: bytes of pictures, one after the other, the right one first, then what others differ from it by, modulo 256. */
export function atlasOf({ scene, grid, mistakes }: Pick<About, "scene" | "grid" | "mistakes">, strips: Uint8Array): Atlas {
  const bytes = 3 * grid * grid;
  const strip = (k: number) => strips.slice(k * bytes, (k + 1) * bytes);
  const right = strip(0);
  const wrong = (k: number) => {
    const laid = strip(k);
    for (let i = 0; i < bytes; i++) laid[i] += right[i];
    return laid;
  };
  return { scene, size: grid, right, mistakes: mistakes.map(({ name, family, wrong: places }) => ({ name, family, pictures: places.map(wrong) })) };
}
