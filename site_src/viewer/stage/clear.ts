/** What must be seen on the stage, so that nothing may lie on it: the selected pixel's rays and what they meet. CSS pixels. */
import type { Line } from "../state/lines";
import { corners } from "../state/placing";
import { seenPart, type Projection } from "../state/projection";
import { dot, length, triple, type Vec3 } from "../state/vectors";
import type { ObjectData } from "../trace/types";
import type { Box, Clear, Round } from "./labels";
import type { Drawn } from "./renderer";

const MOST = 400; // lines of a kind
const EDGE = 3; // round objects
const LARGE = 0.5; // of the stage: what takes more leaves no room beside it

/** near: world units before the observer from which on lines are seen. */
const strokesOf = (lines: readonly Line[], projection: Projection, near: number): number[] =>
  lines.slice(0, MOST).flatMap(({ from, to }) => (seenPart(projection, from, to, near) ?? []).flatMap(({ x, y }) => [x, y]));

/** A ball's outline; stretched balls' where they reach to on the screen. */
function roundOf({ transform }: ObjectData, { project, focal, right, up }: Projection): Round {
  const [a, b, c, middle] = [0, 4, 8, 12].map((at): Vec3 => triple(transform.slice(at, at + 3), 0));
  const { x, y, depth } = project(middle);
  const reach = (way: Vec3) => EDGE + (focal * Math.hypot(dot(a, way), dot(b, way), dot(c, way))) / Math.sqrt(Math.max(1e-9, depth ** 2 - Math.min(...[a, b, c].map(length)) ** 2));
  return { x, y, wide: reach(right), high: reach(up) };
}

function boxOf(points: readonly Vec3[], { project }: Projection): Box {
  const seen = points.map(project);
  const [xs, ys] = [seen.map(({ x }) => x), seen.map(({ y }) => y)];
  return { left: Math.min(...xs) - EDGE, right: Math.max(...xs) + EDGE, top: Math.min(...ys) - EDGE, bottom: Math.max(...ys) + EDGE };
}

/** over: what stands on the stage itself. */
export function clearOf({ view, projection }: Drawn, over: readonly Box[]): Clear {
  const { scene, trace, chosen, thin } = view;
  const room = LARGE * projection.width * projection.height;
  const near = scene.bounds.radius / 300;
  const met = new Set(trace ? chosen.filter(({ light, leaves, growing }) => light < 0 && !leaves && !growing).map(({ ray }) => trace.object[ray]) : []);
  const clear = { boxes: [...over], rounds: [] as Round[], strokes: strokesOf(chosen, projection, near), faint: strokesOf(thin, projection, near) };
  for (const index of met) {
    const object = scene.objects[index];
    const points = corners(object, scene);
    if (!points.length || points.some((point) => projection.project(point).depth < near)) continue; // endless, or all round the observer
    const round = object.type === "sphere" ? roundOf(object, projection) : null;
    const box = boxOf(points, projection);
    if (round ? Math.PI * round.wide * round.high < room : (box.right - box.left) * (box.bottom - box.top) < room) round ? clear.rounds.push(round) : clear.boxes.push(box);
  }
  return clear;
}
