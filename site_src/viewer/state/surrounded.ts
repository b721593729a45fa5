/** What a scene's mirrors and glass have round them, once the part `surroundings` has made it ready to be drawn. */

/** What makes a body look as its surroundings; the stage makes a material of it. */
export interface SurroundedLook {
  vertexShader: string;
  fragmentShader: string;
  defines: Readonly<Record<string, number>>;
  picture: HTMLImageElement; // uniform `around`
  uniforms: Record<string, { value: unknown }>;
  isClear: boolean; // rays go through it, and must be seen
}

export interface Surrounded {
  scene: string;
  /** null: this object neither mirrors nor lets through. faces: it has no normals but its triangles' own. */
  lookOf: (object: number, faces: boolean) => SurroundedLook | null;
  /** Lays over flat mirrors what they show; returns what takes it away. solids: three's group of the scene's objects. */
  onFlat: (solids: never) => () => void;
}
