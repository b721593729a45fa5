/** Hair lines: a set of segments in one colour. */
import { BufferAttribute, BufferGeometry, LineBasicMaterial, LineSegments } from "three";
import type { Vec3 } from "../trace/types";

const ON_TOP = 3; // after bodies and tiles

/** onTop: nothing hides them. */
export function createSegments(color: string, opacity: number, onTop: boolean) {
  const geometry = new BufferGeometry();
  const object = new LineSegments(geometry, new LineBasicMaterial({ color, opacity, transparent: true, depthTest: !onTop }));
  object.renderOrder = ON_TOP;
  object.frustumCulled = false;
  return {
    object,
    show(ends: readonly (readonly [Vec3, Vec3])[]) {
      geometry.dispose();
      geometry.setAttribute("position", new BufferAttribute(new Float32Array(ends.flat(2)), 3));
      object.visible = ends.length > 0;
    },
  };
}
