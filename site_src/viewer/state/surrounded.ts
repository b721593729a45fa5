/** What a scene's mirrors and glass have round them, once the part `surroundings` has made it ready to be drawn. */
export interface Surrounded {
  scene: string;
  /** A material of three's for the stage; null: this object neither mirrors nor lets through. side: three's, which faces are
   *  drawn. faces: it has no normals but its triangles' own. */
  lookOf: (object: number, side: 0 | 1 | 2, faces: boolean) => object | null;
}
