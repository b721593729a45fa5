/** Roughly where an object is on the screen: round a ball a circle, round all else the box of its corners. CSS pixels. */
import type { ObjectData, SceneData } from "../trace/types";
import { corners } from "./placing";
import type { Projection } from "./projection";
import { length, triple } from "./vectors";

export interface Box {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

export interface Outline extends Box {
  isRound: boolean;
}

const EDGE = 3; // round objects

/** Box of a ball's outline, which is an ellipse; a stretched ball's is within it. Across and down alike two lines of sight touch the ball. */
function roundOf({ transform }: ObjectData, { project, focal, width, height }: Projection): Outline {
  const [middle, ...axes] = [12, 0, 4, 8].map((at) => triple(transform.slice(at, at + 3), 0));
  const { x, y, depth } = project(middle);
  const reach = Math.max(...axes.map(length));
  const beyond = Math.max(1e-9, depth ** 2 - reach ** 2);
  const [[left, right], [top, bottom]] = [[x, width / 2], [y, height / 2]].map(([at, sight]) => {
    const aside = ((at - sight) * depth) / focal;
    const half = reach * Math.sqrt(aside ** 2 + beyond);
    return [-1, 1].map((sign) => sight + (focal * (aside * depth + sign * half)) / beyond + sign * EDGE);
  });
  return { left, right, top, bottom, isRound: true };
}

/** near: world units before the observer from which on things are seen. null: it has no end, or is all round the observer. */
export function outlineOf(object: ObjectData, scene: SceneData, projection: Projection, near: number): Outline | null {
  const seen = corners(object, scene).map(projection.project);
  if (!seen.length || seen.some(({ depth }) => depth < near)) return null;
  if (object.type === "sphere") return roundOf(object, projection);
  const [xs, ys] = [seen.map(({ x }) => x), seen.map(({ y }) => y)];
  return { left: Math.min(...xs) - EDGE, right: Math.max(...xs) + EDGE, top: Math.min(...ys) - EDGE, bottom: Math.max(...ys) + EDGE, isRound: false };
}
