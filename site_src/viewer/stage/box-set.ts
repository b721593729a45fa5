/** Bounding volumes as hair lines: bright where the ray went in, grey where it was only tested. */
import { BufferAttribute, BufferGeometry, Group, LineBasicMaterial, LineSegments } from "three";
import { STAGE } from "../palette";
import type { BoxLines } from "../state/box-lines";

export function createBoxSet() {
  const object = new Group();
  const make = (colour: string, opacity: number) => {
    // Nothing hides them: most boxes lie inside the mesh.
    const material = new LineBasicMaterial({ color: colour, transparent: true, opacity, depthTest: false, depthWrite: false });
    const lines = new LineSegments(new BufferGeometry(), material);
    lines.renderOrder = 3;
    lines.frustumCulled = false;
    object.add(lines);
    return lines;
  };
  const parts = { missed: make(STAGE.boxMissed, 0.6), entered: make(STAGE.boxEntered, 0.85) };
  return {
    object,
    show(boxes: BoxLines) {
      for (const name of ["missed", "entered"] as const) {
        const { geometry } = parts[name];
        geometry.dispose();
        geometry.setAttribute("position", new BufferAttribute(new Float32Array(boxes[name].flat(2)), 3));
        parts[name].visible = boxes[name].length > 0;
      }
    },
  };
}
