/**
 * A pixel's ray tree as what happens one after the other, with the numbers each sentence needs. All of
 * them are the trace's: stored factors times stored colours, measured lengths and angles; nothing is traced.
 */
import { RAY_KINDS, type SentKind } from "../trace/kinds";
import type { MaterialData, SceneData, Trace, Vec3 } from "../trace/types";
import type { Degrees, Happening, LightShare, RayEvent, Term } from "./event-types";
import { childrenIn, originOf, treeOf } from "./lines";
import { crossed, indexIn, type Media } from "./media";
import { add, dot, length, scale, sub, times, triple, unit } from "./vectors";

const SEEN = ["blocked", "reached", "away", "unasked", "off"] as const; // by VISIBILITY

const MEASURABLE = 1 / 30; // of the scene's radius: the file rounds points, shorter runs would be off by over 0.1 degrees
const TURN = 180 / Math.PI;

export function lightShares(trace: Trace, scene: SceneData, ray: number): LightShare[] {
  return scene.lights.map(({ name, colour }, light) => {
    const at = ray * trace.lights + light;
    const seen = SEEN[trace.visibility[at]];
    // Nobody asked, but the stored factor tells: with n.l <= 0 a surface faces away, shadows or not.
    return { name, colour, seen: seen === "unasked" && trace.diffuse[at] === 0 && trace.specular[at] === 0 ? "away" : seen, diffuse: trace.diffuse[at], specular: trace.specular[at] };
  });
}

type Colours = Pick<MaterialData, "ambient" | "diffuse" | "specular">;

/** What ambient and diffuse are multiplied by where a ray ends; null on an object without a base colour. */
export const baseAt = (trace: Trace, scene: SceneData, ray: number): Vec3 | null => (scene.objects[trace.object[ray]]?.base ? triple(trace.base, ray) : null);

/** What a ray ends on, its colours as they are there: ambient and diffuse times the base colour. None if it leaves. */
export function materialAt(trace: Trace, scene: SceneData, ray: number): MaterialData | undefined {
  const own = scene.materials[trace.material[ray]], base = triple(trace.base, ray);
  return own && { ...own, ambient: times(own.ambient, base), diffuse: times(own.diffuse, base) };
}

export const isGiving = ({ seen }: Pick<LightShare, "seen">): boolean => seen === "reached" || seen === "unasked";

/** What a light adds to a surface's own colour, before the share the surface keeps. */
export function given(material: Colours, light: LightShare): Vec3 {
  return isGiving(light) ? times(add(scale(material.diffuse, light.diffuse), scale(material.specular, light.specular)), light.colour) : [0, 0, 0];
}

/** The stored terms put together as the file format says. */
export const localColour = (material: Colours, lights: readonly LightShare[]): Vec3 =>
  lights.reduce((sum, light) => add(sum, given(material, light)), material.ambient);

/** All hits along a camera ray, the nearest first; of other rays they are not kept. */
export function hitsOf(trace: Trace, scene: SceneData, ray: number): { name: string; t: number }[] {
  if (trace.parent[ray] >= 0) return [];
  const [from, to] = [trace.hitsStart[ray], trace.hitsStart[ray + 1]];
  return Array.from({ length: to - from }, (_, k) => ({ name: nameOf(scene, trace.hitsObject[from + k]), t: trace.hitsT[from + k] }));
}

const nameOf = (scene: SceneData, object: number) => scene.objects[object]?.name ?? "?";
const tileOf = (trace: Trace, pixel: number) => [pixel % trace.n, Math.floor(pixel / trace.n)] as const;

/** From a ray's start to its end. */
const runOf = (trace: Trace, scene: SceneData, ray: number): Vec3 => sub(triple(trace.point, ray), originOf(trace, scene, ray));

/** Between a ray and the line along a normal. */
function angleOf(trace: Trace, scene: SceneData, ray: number, normal: Vec3): Degrees {
  const run = runOf(trace, scene, ray);
  return length(run) < MEASURABLE * scene.bounds.radius ? null : TURN * Math.acos(Math.min(1, Math.abs(dot(unit(run), normal))));
}

/** How a ray starts. media: what its parent came through. */
function departure(trace: Trace, scene: SceneData, ray: number, media: Media): Happening {
  const parent = trace.parent[ray];
  const what = RAY_KINDS[trace.kind[ray]];
  if (what === "camera") return { what, pixel: tileOf(trace, trace.pixel[ray]), eye: scene.camera.eye };
  const material = scene.materials[trace.material[parent]];
  const normal = triple(trace.normal, parent);
  const enters = trace.inside[parent] === 0;
  return {
    what, of: parent, name: nameOf(scene, trace.object[parent]), share: trace.weight[ray], keeps: trace.localWeight[parent], clear: material.transmit > 0, enters,
    from: enters || media.length ? indexIn(media, scene) : material.ior, to: indexIn(crossed(media, trace.object[parent], enters), scene),
    angle: angleOf(trace, scene, parent, normal), bent: angleOf(trace, scene, ray, normal),
  };
}

function arrival(trace: Trace, scene: SceneData, ray: number): Happening {
  const object = trace.object[ray];
  if (object < 0) return { what: "background", colour: scene.background };
  return { what: "meets", name: nameOf(scene, object), t: trace.t[ray], point: triple(trace.point, ray), hits: hitsOf(trace, scene, ray) };
}

const event = (ray: number, happening: Happening, more: Partial<Pick<RayEvent, "light" | "line" | "long">> = {}): RayEvent => ({ ...happening, ray, light: -1, line: null, long: 0, ...more });

/** What each light says where a ray ends, and the colour they give together. */
function lighting(trace: Trace, scene: SceneData, ray: number): RayEvent[] {
  const lights = lightShares(trace, scene, ray);
  const asked = lights.map(({ name, seen }, light) => {
    const at = ray * trace.lights + light;
    const far = length(sub(scene.lights[light].position, triple(trace.point, ray)));
    const stopped = far * trace.blockedAt[at];
    if (seen === "blocked") return event(ray, { what: seen, name, by: nameOf(scene, trace.blocker[at]), at: stopped }, { light, line: seen, long: stopped });
    return event(ray, { what: seen, name }, seen === "reached" ? { light, line: seen, long: far } : { light });
  });
  const { ambient, diffuse, specular } = materialAt(trace, scene, ray)!;
  const colour = localColour({ ambient, diffuse, specular }, lights);
  return [...asked, event(ray, { what: "local", base: baseAt(trace, scene, ray), ambient, diffuse, specular, lights, share: trace.localWeight[ray], colour })];
}

/** What a ray's colour is the sum of. sent: the rays it led to. */
function termsOf(trace: Trace, scene: SceneData, ray: number, sent: readonly number[]): Term[] {
  const brought = sent.map((child): Term => ({ of: RAY_KINDS[trace.kind[child]] as SentKind, share: trace.weight[child], colour: triple(trace.colour, child) }));
  if (trace.object[ray] < 0) return [{ of: "background", share: 1, colour: scene.background }];
  if (trace.localWeight[ray] === 0) return brought;
  const own = localColour(materialAt(trace, scene, ray)!, lightShares(trace, scene, ray));
  return [{ of: "local", share: trace.localWeight[ray], colour: own }, ...brought];
}

/** What happens where a ray meets a surface, before the rays it leads to. */
function meeting(trace: Trace, scene: SceneData, ray: number, isLast: boolean): RayEvent[] {
  const { reflect, transmit } = scene.materials[trace.material[ray]];
  const stops: Happening = { what: "stops", name: nameOf(scene, trace.object[ray]), keeps: trace.localWeight[ray], limit: scene.depth, atLimit: trace.depth[ray] >= scene.depth };
  return [
    ...(trace.localWeight[ray] > 0 ? lighting(trace, scene, ray) : []),
    ...(isLast && (reflect > 0 || transmit > 0) ? [event(ray, stops, { line: RAY_KINDS[trace.kind[ray]] })] : []),
  ];
}

/** One pixel's events in true order: each ray with all it leads to before the next. */
export function eventsOf(trace: Trace, scene: SceneData, pixel: number): RayEvent[] {
  const children = childrenIn(trace, treeOf(trace, pixel));
  const events: RayEvent[] = [];

  /** media: what the ray travels in; before: what its parent came through. */
  function walk(ray: number, media: Media, before: Media) {
    const line = RAY_KINDS[trace.kind[ray]];
    const object = trace.object[ray];
    const sent = children.get(ray) ?? [];
    events.push(event(ray, departure(trace, scene, ray, before), { line, long: length(runOf(trace, scene, ray)) }), event(ray, arrival(trace, scene, ray), { line }));
    if (object >= 0) events.push(...meeting(trace, scene, ray, !sent.length));
    for (const child of sent) walk(child, RAY_KINDS[trace.kind[child]] === "refracted" ? crossed(media, object, trace.inside[ray] === 0) : media, media);
    const sum = { terms: termsOf(trace, scene, ray, sent), colour: triple(trace.colour, ray) };
    if (trace.parent[ray] < 0) events.push(event(ray, { what: "pixel", pixel: tileOf(trace, pixel), ...sum, bytes: triple(trace.tiles, pixel), before: [...events] }));
    else if (sent.length) events.push(event(ray, { what: "gather", name: nameOf(scene, object), ...sum }, { line }));
  }

  for (const ray of children.get(-1) ?? []) walk(ray, [], []);
  return events;
}
