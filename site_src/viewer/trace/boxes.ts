/** A mesh's bounding sphere and boxes, and which of them each camera ray entered, as the pipeline found. */
import { TraceError } from "./errors";
import type { BoxesData, Vec3 } from "./types";

export interface BoxTested {
  low: Vec3;
  high: Vec3;
  entered: boolean;
}

/** What one camera ray tested. */
export interface RayBoxes {
  spheres: readonly { centre: Vec3; radius: number; entered: boolean }[];
  boxes: readonly BoxTested[];
  without: number; // tests, had there been no boxes
}

export function checkedBoxes(json: unknown, scene: string): BoxesData {
  const boxes = json as BoxesData;
  if (boxes?.format !== 1 || boxes.scene !== scene || !Array.isArray(boxes.meshes)) throw new TraceError("damaged", "no boxes");
  return boxes;
}

function isIn(runs: readonly number[], ray: number): boolean {
  let [end, inside] = [0, false];
  for (const length of runs) {
    end += length;
    if (ray < end) return inside;
    inside = !inside;
  }
  return false;
}

const cornersOf = (box: readonly number[]) => ({ low: [box[0], box[1], box[2]] as const, high: [box[3], box[4], box[5]] as const });

/** A box is tested if its parent is entered, the first one by every ray that crosses the sphere. */
export function boxesOf(data: BoxesData, n: number, ray: number): RayBoxes {
  const spheres: { centre: Vec3; radius: number; entered: boolean }[] = [];
  const boxes: BoxTested[] = [];
  for (const mesh of data.meshes) {
    const [ofSphere, ...ofBoxes] = mesh.levels[n] ?? [];
    if (!ofSphere) continue;
    const [x, y, z, radius] = mesh.sphere;
    const crosses = isIn(ofSphere, ray);
    spheres.push({ centre: [x, y, z], radius, entered: crosses });
    const entered = ofBoxes.map((runs) => isIn(runs, ray));
    for (const [k, box] of mesh.boxes.entries())
      if (crosses && (mesh.parents[k] < 0 || entered[mesh.parents[k]])) boxes.push({ ...cornersOf(box), entered: entered[k] });
  }
  return { spheres, boxes, without: data.primitives + data.meshes.reduce((sum, { triangles }) => sum + triangles, 0) };
}
