/** The names on the stage: of the hit, of what blocks a light, of camera and lamps. */
import type { Line } from "../state/lines";
import { lampsOf } from "../state/switches";
import { triple } from "../state/vectors";
import type { Vec3 } from "../trace/types";
import { say, vector } from "../words";
import type { Label } from "./labels";
import type { Drawn, StageView } from "./renderer";

const BLOCKERS = 3; // named at most

/** Most important first. */
export function namesOf({ view, projection }: Drawn): Label[] {
  const { scene, switched, state } = view;
  if (state.observer === "camera" && (view.tiles > 0 || state.look === "traced")) return []; // the tiles hide what they would name
  const label = (key: string, text: string, at: Vec3, kind: Label["kind"], below = false): Label[] => {
    const { x, y, depth } = projection.project(at);
    const inside = depth > 0 && x > 0 && y > 0 && x < projection.width && y < projection.height;
    return inside ? [{ key, text, x, y, kind, below }] : [];
  };
  const hit = hitOf(view);
  return [
    ...(hit ? label("hit", vector(hit), hit, "hit") : []),
    ...blockersOf(view).flatMap(({ line, by }) => label(`stop ${line.ray} ${line.light}`, say("stage.blocked", { name: scene.objects[by].name }), line.to, "stop")),
    ...(state.observer === "camera" ? [] : label("camera", say("stage.camera"), switched.camera.eye, "sign", true)),
    // An area light's points are named once, at the first.
    ...lampsOf(scene).flatMap(({ name, lights: [k] }) => label(`light ${name}`, switched.lights[k].intensity > 0 ? name : say("stage.off", { light: name }), switched.lights[k].position, "sign")),
  ];
}

/** Where the current event's ray ends, else the camera ray; null before it has arrived, and where it leaves the scene. */
function hitOf({ trace, chosen, lit, state }: StageView): Vec3 | null {
  const ray = lit ? lit.ray : chosen.find((line) => line.light < 0)?.ray;
  const arrived = chosen.some((line) => line.ray === ray && line.light < 0 && !line.growing);
  return trace && ray !== undefined && arrived && state.tiles !== "filling" && trace.object[ray] >= 0 ? triple(trace.point, ray) : null;
}

/** Where shadow rays end too early, and at what: of the current event's ray, else of the first few. */
function blockersOf({ scene, trace, chosen, lit }: StageView) {
  const ended = trace ? chosen.filter((line) => line.kind === "blocked" && !line.growing) : [];
  const current = ended.filter((line) => line.ray === lit?.ray);
  const found = new Map<string, { line: Line; by: number }>(); // an area light's points are one light here, too
  const lamps = lampsOf(scene);
  for (const line of current.length ? current : ended) {
    const by = trace!.blocker[line.ray * trace!.lights + line.light];
    const key = `${by} ${line.ray} ${lamps.findIndex(({ lights }) => lights.includes(line.light))}`;
    if (by >= 0 && !found.has(key)) found.set(key, { line, by });
  }
  return [...found.values()].slice(0, BLOCKERS);
}
