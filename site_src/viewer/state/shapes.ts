/** Shapes as they are drawn: a row a shape, in its own space, which an object's transform places. */
import type { ObjectData, SceneData, Vec3 } from "../trace/types";
import { meshOf } from "./mesh";
import { dot } from "./vectors";

type Box = readonly [Vec3, Vec3]; // low and high corner

interface Form {
  /** Box round it; null of what is endless. */
  box(object: ObjectData, scene: SceneData): Box | null;
  /** Polygons in its place, anticlockwise as seen from outside; none of what is drawn without. */
  faces(object: ObjectData, scene: SceneData): Vec3[][];
  /** Whether it is seen from both sides: it has no inside, or may have none. */
  isOpen(object: ObjectData): boolean;
  /** Whether a point is in it, as in a room. */
  holds?(p: Vec3, object: ObjectData): boolean;
}

const ROUND = 32; // corners of a circle
const MOST_FACES = 12000; // of a mesh; of a heavier one every k-th is drawn
const AROUND: Box = [[-1, -1, -1], [1, 1, 1]];

function ring(radius: number, z: number): Vec3[] {
  const angles = Array.from({ length: ROUND }, (_, k) => (2 * Math.PI * k) / ROUND);
  return angles.map((angle) => [radius * Math.cos(angle), radius * Math.sin(angle), z]);
}

/** Radii at z = -1 and 1 of what a straight line makes that is turned about z. */
export const endsOf = ({ tip = 1 }: ObjectData): readonly [number, number] => [tip, 1];

/** Its sides, and its caps unless it is open. */
function turned(object: ObjectData): Vec3[][] {
  const [low, high] = endsOf(object);
  const [from, to] = [ring(low, -1), ring(high, 1)];
  const sides = from.map((corner, k) => [to[(k + 1) % ROUND], to[k], corner, from[(k + 1) % ROUND]]);
  return object.open ? sides : [...sides, to, ...(low > 0 ? [[...from].reverse()] : [])];
}

const boxFaces = [0, 1, 2].flatMap((axis) =>
  [-1, 1].map((side) =>
    [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([u, v]) => {
      const corner: number[] = [];
      [corner[axis], corner[(axis + 1) % 3], corner[(axis + 2) % 3]] = [side, side * u, v];
      return corner as unknown as Vec3;
    }),
  ),
);

function meshFaces({ mesh }: ObjectData, { meshes }: SceneData): Vec3[][] {
  const data = mesh ? meshes[mesh] : undefined;
  if (!data) return [];
  const { positions, indices } = meshOf(data);
  const corner = (i: number) => positions.subarray(3 * i, 3 * i + 3) as unknown as Vec3;
  const step = Math.ceil(indices.length / 3 / MOST_FACES);
  const count = Math.ceil(indices.length / 3 / step);
  return Array.from({ length: count }, (_, k) => [0, 1, 2].map((c) => corner(indices[3 * k * step + c])));
}

export const FORMS: Record<ObjectData["type"], Form> = {
  sphere: { box: () => AROUND, faces: () => [], isOpen: () => false, holds: (p) => dot(p, p) < 1 },
  box: { box: () => AROUND, faces: () => boxFaces, isOpen: () => false, holds: (p) => p.every((c) => Math.abs(c) < 1) },
  cylinder: {
    box: () => AROUND,
    faces: turned,
    isOpen: ({ open }) => open === true,
    holds: ([x, y, z], { tip = 1 }) => Math.hypot(x, y) < tip + ((1 - tip) * (1 + z)) / 2 && Math.abs(z) < 1,
  },
  plane: { box: () => null, faces: () => [], isOpen: () => true },
  disc: { box: () => [[-1, -1, 0], [1, 1, 0]], faces: () => [ring(1, 0)], isOpen: () => true },
  triangle: { box: () => [[0, 0, 0], [1, 1, 0]], faces: () => [[[0, 0, 0], [1, 0, 0], [0, 1, 0]]], isOpen: () => true },
  mesh: { box: ({ mesh }, { meshes }) => (mesh && meshes[mesh]?.box) || AROUND, faces: meshFaces, isOpen: () => true },
};
