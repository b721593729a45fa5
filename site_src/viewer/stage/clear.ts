/** What must be seen on the stage, so that nothing may lie on it: lamps, the selected pixel's rays, what they meet and what is in their way. CSS pixels. */
import type { Line } from "../state/lines";
import { outlineOf, type Box } from "../state/outlines";
import { seenPart, type Projection } from "../state/projection";
import type { Clear, Round } from "./labels";
import type { Drawn } from "./renderer";

const MOST = 400; // lines of a kind
const LAMP = 8; // pixels: half of its dot
const LARGE = 0.5; // of the stage: what takes more leaves no room beside it

/** near: world units before the observer from which on lines are seen. */
const strokesOf = (lines: readonly Line[], projection: Projection, near: number): number[] =>
  lines.slice(0, MOST).flatMap(({ from, to }) => (seenPart(projection, from, to, near) ?? []).flatMap(({ x, y }) => [x, y]));

/** over: what stands on the stage itself. */
export function clearOf({ view, projection }: Drawn, over: readonly Box[]): Clear {
  const { scene, trace, chosen, thin } = view;
  const room = LARGE * projection.width * projection.height;
  const near = scene.bounds.radius / 300;
  const met = new Set(trace ? chosen.filter(({ leaves, growing }) => !leaves && !growing).map(({ ray, light }) => (light < 0 ? trace.object[ray] : trace.blocker[ray * trace.lights + light])) : []);
  const clear = { boxes: [...over], rounds: [] as Round[], strokes: strokesOf(chosen, projection, near), faint: strokesOf(thin, projection, near) };
  for (const { position } of scene.lights) {
    const { x, y, depth } = projection.project(position);
    if (depth > 0) clear.rounds.push({ x, y, radius: LAMP });
  }
  for (const index of met) {
    if (index < 0) continue; // a light that is reached
    const outline = outlineOf(scene.objects[index], scene, projection, near);
    if (!outline) continue;
    const { left, right, top, bottom, isRound } = outline;
    const [wide, high] = [right - left, bottom - top];
    if (wide * high * (isRound ? Math.PI / 4 : 1) >= room) continue;
    isRound ? clear.rounds.push({ x: left + wide / 2, y: top + high / 2, radius: Math.max(wide, high) / 2 }) : clear.boxes.push(outline);
  }
  return clear;
}
