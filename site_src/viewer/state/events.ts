/**
 * A pixel's ray tree as what happens one after the other, with the numbers each sentence needs. All of
 * them are the trace's: stored factors times stored colours, measured lengths and angles; nothing is traced.
 */
import { RAY_KINDS, type LineKind } from "../trace/kinds";
import { VISIBILITY, type SceneData, type Trace, type Vec3 } from "../trace/types";
import type { Degrees, Happening, LightShare, RayEvent, Term } from "./event-types";
import { originOf, treeOf } from "./lines";
import { crossed, indexIn, type Media } from "./media";
import { add, dot, length, scale, sub, triple, unit } from "./vectors";
import { whyOf } from "./why";

const SEEN = { [VISIBILITY.blocked]: "blocked", [VISIBILITY.reached]: "reached", [VISIBILITY.behind]: "away", [VISIBILITY.untested]: "unasked", [VISIBILITY.off]: "off" } as const;

const MEASURABLE = 1 / 30; // of the scene's radius: the file rounds points, shorter ways would be off by over 0.1 degrees
const TURN = 180 / Math.PI;

export function lightShares(trace: Trace, scene: SceneData, ray: number): LightShare[] {
  return scene.lights.map(({ name, colour }, light) => {
    const at = ray * trace.lights + light;
    return { name, colour, seen: SEEN[trace.visibility[at] as keyof typeof SEEN], diffuse: trace.diffuse[at], specular: trace.specular[at] };
  });
}

export const times = (a: Vec3, b: Vec3): Vec3 => [a[0] * b[0], a[1] * b[1], a[2] * b[2]];

/** The stored terms put together as the file format says, before the share the surface keeps. */
export function localColour(material: { ambient: Vec3; diffuse: Vec3; specular: Vec3 }, lights: readonly LightShare[]): Vec3 {
  const lit = lights.filter(({ seen }) => seen === "reached" || seen === "unasked");
  return lit.reduce(
    (sum, light) => add(sum, times(add(scale(material.diffuse, light.diffuse), scale(material.specular, light.specular)), light.colour)),
    material.ambient,
  );
}

/** One pixel's events in true order: each ray with all it leads to before the next. */
export function eventsOf(trace: Trace, scene: SceneData, pixel: number): RayEvent[] {
  const tree = treeOf(trace, pixel);
  const children = new Map<number, number[]>();
  for (const ray of tree) children.set(trace.parent[ray], [...(children.get(trace.parent[ray]) ?? []), ray]);
  const place = [pixel % trace.n, Math.floor(pixel / trace.n)] as const;
  const events: RayEvent[] = [];
  const nameOf = (object: number) => scene.objects[object]?.name ?? "?";
  const way = (ray: number) => sub(triple(trace.point, ray), originOf(trace, scene, ray));
  /** Between a ray and the line along a normal. */
  const angle = (ray: number, normal: Vec3): Degrees =>
    length(way(ray)) < MEASURABLE * scene.bounds.radius ? null : TURN * Math.acos(Math.min(1, Math.abs(dot(unit(way(ray)), normal))));
  const put = (ray: number, happening: Happening, { light = -1, line = null as LineKind | null, long = 0 } = {}) =>
    events.push({ ...happening, ray, light, line, long });

  function departure(ray: number, media: Media, after: Media): Happening {
    const parent = trace.parent[ray];
    const kind = RAY_KINDS[trace.kind[ray]];
    if (parent < 0) return { what: "camera", pixel: place, eye: scene.camera.eye };
    const material = scene.materials[trace.material[parent]];
    const normal = triple(trace.normal, parent);
    const base = { name: nameOf(trace.object[parent]), share: trace.weight[ray], angle: angle(parent, normal) };
    const leaves = trace.inside[parent] === 1;
    const from = leaves && !media.length ? material.ior : indexIn(media, scene);
    if (kind === "refracted") return { what: kind, ...base, enters: !leaves, from, to: indexIn(after, scene), bent: angle(ray, normal) };
    if (kind === "total") return { what: kind, ...base, from, to: indexIn(crossed(media, trace.object[parent], !leaves), scene) };
    return { what: "reflected", ...base, keeps: trace.localWeight[parent], clear: material.transmit > 0 };
  }

  function arrival(ray: number): Happening {
    if (trace.object[ray] < 0) return { what: "background", colour: scene.background };
    const hits: { name: string; t: number }[] = [];
    if (trace.parent[ray] < 0)
      for (let k = trace.hitsStart[ray]; k < trace.hitsStart[ray + 1]; k++) hits.push({ name: nameOf(trace.hitsObject[k]), t: trace.hitsT[k] });
    return { what: "meets", name: nameOf(trace.object[ray]), t: trace.t[ray], point: triple(trace.point, ray), hits };
  }

  function lighting(ray: number) {
    const point = triple(trace.point, ray);
    const lights = lightShares(trace, scene, ray);
    for (const [light, { name, seen }] of lights.entries()) {
      const at = ray * trace.lights + light;
      const far = length(sub(scene.lights[light].position, point));
      if (seen === "reached") put(ray, { what: seen, name }, { light, line: seen, long: far });
      else if (seen !== "blocked") put(ray, { what: seen, name }, { light });
      else {
        const stopped = far * trace.blockedAt[at];
        put(ray, { what: seen, name, by: nameOf(trace.blocker[at]), at: stopped }, { light, line: seen, long: stopped });
      }
    }
    const { ambient, diffuse, specular } = scene.materials[trace.material[ray]];
    put(ray, { what: "local", ambient, diffuse, specular, lights, share: trace.localWeight[ray], colour: localColour({ ambient, diffuse, specular }, lights) });
  }

  function terms(ray: number): Term[] {
    const sent = (children.get(ray) ?? []).map((child): Term => ({ of: RAY_KINDS[trace.kind[child]] as Term["of"], share: trace.weight[child], colour: triple(trace.colour, child) }));
    if (trace.object[ray] < 0) return [{ of: "background", share: 1, colour: scene.background }];
    if (trace.localWeight[ray] === 0) return sent;
    const own = localColour(scene.materials[trace.material[ray]], lightShares(trace, scene, ray));
    return [{ of: "local", share: trace.localWeight[ray], colour: own }, ...sent];
  }

  /** media: what the ray travels in; before: what its parent came through. */
  function walk(ray: number, media: Media, before: Media) {
    const line = RAY_KINDS[trace.kind[ray]];
    put(ray, departure(ray, before, media), { line, long: length(way(ray)) });
    put(ray, arrival(ray), { line });
    const object = trace.object[ray];
    const sent = children.get(ray) ?? [];
    if (object >= 0) {
      if (trace.localWeight[ray] > 0) lighting(ray);
      const { reflect, transmit } = scene.materials[trace.material[ray]];
      if (!sent.length && (reflect > 0 || transmit > 0))
        put(ray, { what: "stops", name: nameOf(object), limit: scene.depth, atLimit: trace.depth[ray] >= scene.depth }, { line });
    }
    for (const child of sent) walk(child, RAY_KINDS[trace.kind[child]] === "refracted" ? crossed(media, object, trace.inside[ray] === 0) : media, media);
    const colour = triple(trace.colour, ray);
    const bytes = triple(trace.tiles, pixel);
    if (trace.parent[ray] < 0) put(ray, { what: "pixel", pixel: place, terms: terms(ray), colour, bytes, why: whyOf(trace, tree, events, bytes) });
    else if (sent.length) put(ray, { what: "gather", name: nameOf(object), terms: terms(ray), colour }, { line });
  }

  for (const ray of children.get(-1) ?? []) walk(ray, [], []);
  return events;
}
