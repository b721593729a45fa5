/** A scene at a stop of one of its sweeps. A stop is to the page what a scene is: `of` tells them apart. */
import { lampsOf } from "./switches";
import type { LightData, SceneData, StopsData } from "../trace/types";

/** What varies; of two values, `across` are the other one's. */
export type Sweep = NonNullable<SceneData["sweeps"]>[number];

/** Column and row of its grid, from 0; between stops they are no whole numbers. */
export type Place = readonly [number, number];

export const rowsOf = ({ across }: Sweep): number => across?.values.length ?? 1;
export const countOf = (sweep: Sweep): number => sweep.values.length * rowsOf(sweep);
/** Column and row of a stop, from 0: stops are numbered row by row. */
export const placeOf = ({ values }: Sweep, stop: number): Place => [(stop - 1) % values.length, Math.floor((stop - 1) / values.length)];
/** The stop in that column and row, or the nearest to it. */
export function stopOf(sweep: Sweep, [column, row]: Place): number {
  const within = (at: number, count: number) => Math.max(0, Math.min(count - 1, Math.round(at)));
  return within(row, rowsOf(sweep)) * sweep.values.length + within(column, sweep.values.length) + 1;
}
/** A few stops of a stop's row, itself among them, from end to end. */
export function someOfRow(sweep: Sweep, stop: number, most: number): number[] {
  const [column, row] = placeOf(sweep, stop);
  const count = Math.min(most, sweep.values.length);
  const columns = Array.from({ length: count }, (_, k) => Math.round((k * (sweep.values.length - 1)) / (count - 1)));
  const nearest = columns.reduce((a, b) => (Math.abs(b - column) < Math.abs(a - column) ? b : a));
  return columns.map((each) => stopOf(sweep, [each === nearest ? column : each, row]));
}
/** Stops beside one, those ahead first. */
export function besides(sweep: Sweep, stop: number): number[] {
  const [column, row] = placeOf(sweep, stop);
  const near = [[column + 1, row], [column - 1, row], [column, row + 1], [column, row - 1]] as const;
  return [...new Set(near.map((at) => stopOf(sweep, at)))].filter((each) => each !== stop);
}

/** The k-th stop, from 0, of the way through all of them: to and fro in rows, so that each is beside the one before. */
export function onTheWay({ values: { length } }: Sweep, k: number): number {
  const [column, row] = [k % length, Math.floor(k / length)];
  return row * length + (row % 2 ? length - 1 - column : column) + 1;
}
/** Where on that way a stop is: what turns a row round turns it back. */
export const wayTo = (sweep: Sweep, stop: number): number => onTheWay(sweep, stop - 1) - 1;

/** Sweep and stop of "lamp-height:7"; null where the scene has no such stop. */
export function stopIn(scene: SceneData, text: string) {
  const [id, number] = text.split(":");
  const sweep: Sweep | undefined = scene.sweeps?.find((each) => each.id === id);
  const stop = Number(number);
  return sweep && Number.isInteger(stop) && stop >= 1 && stop <= countOf(sweep) ? { sweep, stop } : null;
}

/** Grids whose rays a sweep's stops have. */
export const levelsOf = (scene: SceneData, id: string): number[] => scene.levels.filter((n) => `${id}/${n}` in scene.files);
/** Of these the one most like n. */
export const nearestLevel = (levels: readonly number[], n: number) => levels.reduce((a, b) => (Math.abs(b - n) < Math.abs(a - n) ? b : a));

type Things = readonly { readonly name: string }[];
const laidOver = <T extends Things>(things: T, others: readonly object[] | undefined): T => (others ? (things.map((thing, k) => ({ ...thing, ...others[k] })) as unknown as T) : things);

/** A stop's lights; where a lamp has another number of points they are all its own, named as the scene's are in its language. */
function lightsAt(scene: SceneData, others: readonly object[] | undefined): SceneData["lights"] {
  const own = others as readonly LightData[] | undefined;
  if (!own?.[0]?.name) return laidOver(scene.lights, others);
  const names = lampsOf(scene).map(({ name }) => name);
  return lampsOf({ lights: own }).flatMap(({ name, lights }, lamp) => lights.map((k) => ({ ...own[k], name: names[lamp] + own[k].name.slice(name.length) })));
}

/** The scene as it is at a stop, from 1. */
export function sceneAt(scene: SceneData, given: StopsData["stops"][number], id: string, stop: number): SceneData {
  const { objects, lights, materials, ...other } = given;
  return {
    ...scene,
    ...other,
    of: `${scene.of}/${id}/${stop}`,
    ...(!objects && !other.camera && { bodies: scene.of }),
    levels: levelsOf(scene, id),
    objects: laidOver(scene.objects, objects),
    lights: lightsAt(scene, lights),
    materials: laidOver(scene.materials, materials),
  };
}
