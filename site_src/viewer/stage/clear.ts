/** What must be seen on the stage, so that nothing may lie on it: the selected pixel's rays, what they meet and what is in their way. CSS pixels. */
import type { Line } from "../state/lines";
import { corners } from "../state/placing";
import { seenPart, type Projection } from "../state/projection";
import { length, triple, type Vec3 } from "../state/vectors";
import type { ObjectData } from "../trace/types";
import type { Box, Clear, Round } from "./labels";
import type { Drawn } from "./renderer";

const MOST = 400; // lines of a kind
const EDGE = 3; // round objects
const LARGE = 0.5; // of the stage: what takes more leaves no room beside it

/** near: world units before the observer from which on lines are seen. */
const strokesOf = (lines: readonly Line[], projection: Projection, near: number): number[] =>
  lines.slice(0, MOST).flatMap(({ from, to }) => (seenPart(projection, from, to, near) ?? []).flatMap(({ x, y }) => [x, y]));

/** A ball's outline; a stretched one's is within it. */
function roundOf({ transform }: ObjectData, { project, focal }: Projection): Round {
  const [middle, ...axes] = [12, 0, 4, 8].map((at) => triple(transform.slice(at, at + 3), 0));
  const { x, y, depth } = project(middle);
  const reach = Math.max(...axes.map(length));
  return { x, y, radius: EDGE + (focal * reach) / Math.sqrt(Math.max(reach ** 2, depth ** 2 - reach ** 2)) };
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
  const met = new Set(trace ? chosen.filter(({ leaves, growing }) => !leaves && !growing).map(({ ray, light }) => (light < 0 ? trace.object[ray] : trace.blocker[ray * trace.lights + light])) : []);
  const clear = { boxes: [...over], rounds: [] as Round[], strokes: strokesOf(chosen, projection, near), faint: strokesOf(thin, projection, near) };
  for (const index of met) {
    if (index < 0) continue; // a light that is reached
    const object = scene.objects[index];
    const points = corners(object, scene);
    if (!points.length || points.some((point) => projection.project(point).depth < near)) continue; // endless, or all round the observer
    const round = object.type === "sphere" ? roundOf(object, projection) : null;
    const box = boxOf(points, projection);
    if (round ? Math.PI * round.radius ** 2 < room : (box.right - box.left) * (box.bottom - box.top) < room) round ? clear.rounds.push(round) : clear.boxes.push(box);
  }
  return clear;
}
