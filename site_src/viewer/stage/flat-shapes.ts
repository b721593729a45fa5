/** The scene as flat pieces for the renderer without WebGL: polygons and ellipses, far ones first. */
import { isClear, isMirror } from "../state/look";
import { isWithin, toWorld } from "../state/placing";
import type { Projection } from "../state/projection";
import { FORMS } from "../state/shapes";
import { cross, dot, length, scale, sub, times, unit, type Vec3 } from "../state/vectors";
import type { MaterialData, ObjectData, SceneData } from "../trace/types";
import { otherWalls, wallSheet } from "./wall-sheet";

export type Piece =
  | { kind: "polygon"; points: Vec3[]; colour: Vec3; alpha: number; depth: number }
  | { kind: "ball"; center: Vec3; axes: readonly [Vec3, Vec3, Vec3]; colour: Vec3; alpha: number; depth: number };

interface Face {
  points: Vec3[];
  normal: Vec3;
  twoSided: boolean;
}

const WALL_CELLS = 22;
const FINEST = 1 / 8; // of a cell, along another wall
const CALM: Vec3 = [0.26, 0.28, 0.32];

/** A body's colour on this stage: its own, or a steel and a pale blue for mirror and glass. */
export function bodyColour(material: MaterialData, { base = [1, 1, 1] }: ObjectData): { colour: Vec3; alpha: number } {
  if (isClear(material)) return { colour: [0.75, 0.88, 0.95], alpha: 0.3 };
  if (isMirror(material)) return { colour: [0.66, 0.7, 0.75], alpha: 1 };
  return { colour: times(material.diffuse, base), alpha: 1 };
}

function facesOf(object: ObjectData, scene: SceneData): Face[] {
  const form = FORMS[object.type];
  const twoSided = form.isOpen(object) && object.type !== "mesh"; // of a mesh half are too many
  return form.faces(object, scene).map((own) => {
    const points = own.map((p) => toWorld(object.transform, p));
    const normal = cross(sub(points[1], points[0]), sub(points[2], points[0]));
    const size = length(normal);
    return { points, normal: size > 0 ? scale(normal, 1 / size) : [0, 0, 1], twoSided };
  });
}

/** A wall as a patchwork that fades outwards and ends at the other walls. */
function wallPieces(object: ObjectData, scene: SceneData, eye: Vec3): Piece[] {
  const sheet = wallSheet(object, scene);
  if (dot(sub(eye, sheet.point), sheet.facing) <= 0) return [];
  const others = otherWalls(object, scene);
  const isSeen = (p: Vec3) => others.every(({ point, facing }) => dot(sub(p, point), facing) >= -1e-6);
  const at = (u: number, v: number) => sheet.at((2 * u) / WALL_CELLS - 1, (2 * v) / WALL_CELLS - 1);
  const shade = 0.82 + 0.18 * Math.abs(sheet.facing[1]); // upright walls a little darker than floors: paint, so that edges show
  const pieces: Piece[] = [];
  /** One patch; where another wall crosses it, in smaller patches. */
  function patch(u: number, v: number, wide: number) {
    const points = [at(u, v), at(u + wide, v), at(u + wide, v + wide), at(u, v + wide)];
    const seen = points.filter(isSeen).length;
    if (seen === 0) return;
    if (seen < 4 && wide > FINEST) {
      for (const [a, b] of [[0, 0], [1, 0], [0, 1], [1, 1]]) patch(u + (a * wide) / 2, v + (b * wide) / 2, wide / 2);
      return;
    }
    const center = at(u + wide / 2, v + wide / 2);
    const alpha = Math.min(1, Math.max(0, (1 - sheet.out(center)) / 0.5));
    const colour = times(paintAt(center, object, scene).diffuse, object.base ?? [1, 1, 1]).map((c, k) => c * CALM[k] * shade) as unknown as Vec3;
    if (alpha > 0) pieces.push({ kind: "polygon", points, colour, alpha, depth: Infinity });
  }
  for (let u = 0; u < WALL_CELLS; u++) for (let v = 0; v < WALL_CELLS; v++) patch(u, v, 1);
  return pieces;
}

/** The material of a wall's square. */
function paintAt(point: Vec3, { checker, material }: ObjectData, { materials }: SceneData): MaterialData {
  const square = checker ? checker.axes.reduce((sum, axis) => sum + Math.floor(dot(sub(point, checker.origin), axis) / checker.size), 0) : 0;
  return materials[checker && square % 2 !== 0 ? checker.material : material];
}

/** Built once a scene: faces in the world. */
export function shapesOf(scene: SceneData) {
  const bodies = scene.objects
    .filter((object) => object.type !== "plane" && object.type !== "sphere")
    .map((object) => ({ object, faces: facesOf(object, scene), room: isWithin(object, scene.camera.eye) }));

  /** All pieces as this observer sees them, far ones first. */
  return (eye: Vec3, projection: Projection): Piece[] => {
    const depth = (p: Vec3) => dot(sub(p, eye), projection.forward);
    const solid: Piece[] = [];
    for (const object of scene.objects) {
      if (object.type !== "sphere" || isWithin(object, scene.camera.eye)) continue;
      const m = object.transform;
      const center = m.slice(12, 15) as unknown as Vec3;
      const axes = [m.slice(0, 3), m.slice(4, 7), m.slice(8, 11)] as unknown as [Vec3, Vec3, Vec3];
      solid.push({ kind: "ball", center, axes, ...bodyColour(scene.materials[object.material], object), depth: depth(center) });
    }
    for (const { object, faces, room } of bodies) {
      const { colour, alpha } = bodyColour(scene.materials[object.material], object);
      for (const { points, normal, twoSided } of faces) {
        const towards = dot(normal, unit(sub(eye, points[0])));
        const outward = room ? dot(normal, sub(scene.camera.eye, points[0])) * towards < 0 : towards < 0 && !twoSided;
        if (outward) continue;
        const shade = 0.35 + 0.65 * Math.abs(towards); // faces turned to the observer are brighter: paint, not light
        solid.push({ kind: "polygon", points, colour: scale(colour, shade), alpha, depth: Math.max(...points.map(depth)) });
      }
    }
    solid.sort((a, b) => b.depth - a.depth);
    return [...scene.objects.filter((o) => o.type === "plane").flatMap((o) => wallPieces(o, scene, eye)), ...solid];
  };
}
