/** What a sweep moves, between its stops: only to be drawn. Rays and numbers there are of stops alone. */
import type { SceneData } from "../trace/types";
import { lampsOf } from "./switches";
import { placeOf, stopOf, type Place, type Sweep } from "./swept";

/** From neighbour to neighbour things turn by little: that numbers of a turn go straight shrinks a thing by 1 % in 15 degrees. */
const mixed = <T extends readonly number[]>(a: T, b: T, share: number): T => a.map((value, k) => value + (b[k] - value) * share) as unknown as T;

/** Each lamp with as many points as it has at most, at any of its scene's stops: some stand at one place then, together as bright as it was. */
function mostPoints(scene: SceneData, sweeps: readonly Sweep[]): SceneData["lights"] {
  return lampsOf(scene).flatMap(({ lights: own }, lamp) => {
    const most = Math.max(own.length, ...sweeps.map(({ points }) => points?.[lamp] ?? 0));
    const first = (point: number) => Math.ceil((point * most) / own.length);
    return own.flatMap((light, point) => {
      const count = first(point + 1) - first(point);
      return Array(count).fill({ ...scene.lights[light], intensity: scene.lights[light].intensity / count });
    });
  });
}

const known = new WeakMap<SceneData, SceneData>();

/** A scene as it is drawn, where lamps' points are more or fewer at stops: what draws lights wants as many at each. Made once of each. */
export function withMostPoints(scene: SceneData): SceneData {
  const { sweeps = [] } = scene;
  if (!sweeps.some(({ points }) => points)) return scene;
  const drawn = known.get(scene) ?? { ...scene, lights: mostPoints(scene, sweeps), asked: scene.lights };
  known.set(scene, drawn);
  return drawn;
}

/** One scene with the places of things and lights of both. */
const between = (a: SceneData, b: SceneData, share: number): SceneData =>
  share === 0 || a === b
    ? a
    : {
        ...a,
        objects: a.objects.map((each, k) => ({ ...each, transform: mixed(each.transform, b.objects[k].transform, share) })),
        lights: a.lights.map((each, k) => ({ ...each, position: mixed(each.position, b.lights[k].position, share) })),
      };

/** The scene, whatever its colours and switches, with what moves where it is at this place between the stops. */
export function movedTo(scene: SceneData, sweep: Sweep, stops: readonly SceneData[], at: Place): SceneData {
  const [column, row] = at.map(Math.floor);
  const [right, up] = [at[0] - column, at[1] - row];
  const there = (c: number, r: number) => stops[stopOf(sweep, [c, r]) - 1];
  const inRow = (r: number) => between(there(column, r), there(column + 1, r), right);
  const moved = between(inRow(row), inRow(row + 1), up);
  return {
    ...scene,
    of: `${scene.of} at ${at}`,
    objects: scene.objects.map((each, k) => ({ ...each, transform: moved.objects[k].transform })),
    lights: scene.lights.map((each, k) => ({ ...each, position: moved.lights[k].position })),
  };
}

export const isAt = (sweep: Sweep, stop: number, at: Place): boolean => String(placeOf(sweep, stop)) === String(at);
