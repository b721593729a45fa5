/** Pixels' events in words of rays that stand in no file: those of a right and a wrong program (mistake_pages/walked.py). */
import { sumNumbers } from "../event-words";
import type { RayEvent } from "../state/event-types";
import { eventsOf } from "../state/events";
import type { MaterialData, SceneData, Trace } from "../trace/types";
import { bytes as written } from "../words";
import { worded, type Worded } from "./worded";

/** One pixel's rays as a program has them: columns of Trace by its names; null where a number is infinite. */
export interface ProgramsRays {
  n: number;
  pixel: number; // row * n + column
  bytes: readonly number[]; // what the program writes
  columns: Readonly<Record<string, readonly (number | boolean | null)[]>>;
  materials: readonly MaterialData[]; // as the program takes them, as are bounce limit and base colours
  depth: number;
  based: readonly boolean[];
}

export interface EventBeside extends Worded {
  what: string;
}

const WHOLE = new Set(["kind", "depth", "inside", "visibility"]);
const INDICES = new Set(["parent", "object", "material", "tests", "blocker", "hitsStart", "hitsObject"]);

function typed(name: string, values: readonly (number | boolean | null)[]) {
  const numbers = values.map((value) => (value === null ? Infinity : Number(value)));
  if (WHOLE.has(name)) return Uint8Array.from(numbers);
  return INDICES.has(name) ? Int32Array.from(numbers) : Float64Array.from(numbers);
}

function traceOf({ n, pixel, bytes, columns }: ProgramsRays, scene: SceneData): Trace {
  const count = columns.kind.length;
  const tiles = new Uint8Array(3 * n * n);
  tiles.set(bytes, 3 * pixel);
  const read = Object.fromEntries(Object.entries(columns).map(([name, values]) => [name, typed(name, values)]));
  return { ...read, scene: scene.of, n, lights: scene.lights.length, count, pixel: new Int32Array(count).fill(pixel), tiles } as unknown as Trace;
}

/** The scene as the program takes it; names stay those of the scene. */
function takenFor(scene: SceneData, { materials, depth, based }: ProgramsRays): SceneData {
  return {
    ...scene,
    depth,
    materials: materials.map((material, k) => ({ ...material, name: scene.materials[k].name })),
    objects: scene.objects.map((object, k) => (based[k] ? { ...object, base: object.base ?? [1, 1, 1] } : object)),
  };
}

/** As the ray card tells it, but not why a pixel is dark: that is asked of right rays. What a program writes that is not
 *  its rounded sum of rays is told without the step that would make these bytes. */
function told(event: RayEvent): EventBeside {
  if (event.what !== "pixel") return { what: event.what, ...worded(event) };
  const plainly = worded({ ...event, before: [] });
  const isSum = written(event.colour) === event.bytes.join(", ");
  return { what: event.what, ...plainly, numbers: isSum ? plainly.numbers : sumNumbers(event.terms, event.colour) };
}

/** Of each program's rays. */
export const eventsBeside = (scene: SceneData, programs: readonly ProgramsRays[]): EventBeside[][] =>
  programs.map((program) => {
    const own = takenFor(scene, program);
    return eventsOf(traceOf(program, own), own, program.pixel).map(told);
  });
