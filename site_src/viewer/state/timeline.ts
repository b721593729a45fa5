/** A pixel's events along time, and the lines that are there at each moment. Seconds at speed 1. */
import type { SceneData, Trace } from "../trace/types";
import type { RayEvent } from "./event-types";
import { eventsOf } from "./events";
import { linesOf, type Line } from "./lines";
import { along } from "./vectors";

export interface Timeline {
  events: readonly RayEvent[];
  starts: readonly number[]; // of each event, and the end of the last
  grows: readonly number[]; // seconds at each event's beginning in which its line grows
}

const READ_SECONDS = 2; // a sentence stays after its line has grown
const CROSSING = 1.6; // seconds in which a ray crosses the scene's radius: every line has that speed

export function timelineOf(trace: Trace, scene: SceneData, pixel: number): Timeline {
  const events = eventsOf(trace, scene, pixel);
  const grows = events.map((event) => (event.long / scene.bounds.radius) * CROSSING);
  const starts = [0];
  for (const seconds of grows) starts.push(starts.at(-1)! + seconds + READ_SECONDS);
  return { events, starts, grows };
}

/** Where the like of an event is after a switch: of the same ray, or the same light; null where it is gone. */
export function eventLike({ events }: Timeline, before: RayEvent): number | null {
  const same = (alike: (event: RayEvent) => boolean) => events.findIndex((event) => event.ray === before.ray && event.light === before.light && alike(event));
  const exact = same((event) => event.what === before.what);
  const found = exact >= 0 || before.light < 0 ? exact : same(() => true);
  return found < 0 ? null : found;
}

const keyOf = ({ ray, light }: { ray: number; light: number }) => `${ray} ${light}`;

/** How much of its line an event has grown when `share` of its time has passed. */
export function grownShare({ starts, grows }: Timeline, event: number, share: number): number {
  const passed = share * (starts[event + 1] - starts[event]);
  return grows[event] > 0 ? Math.min(1, passed / grows[event]) : 1;
}

/** The pixel's lines up to an event, the event's own as far as it has grown. */
export function linesUpTo(timeline: Timeline, trace: Trace, scene: SceneData, pixel: number, event: number, share: number): Line[] {
  const all = new Map(linesOf(trace, scene, pixel).map((line) => [keyOf(line), line]));
  const seen: Line[] = [];
  for (let k = 0; k <= event; k++) {
    const happening = timeline.events[k];
    const line = happening.long > 0 ? all.get(keyOf(happening)) : undefined;
    if (!line) continue;
    const grown = k === event ? grownShare(timeline, k, share) : 1;
    seen.push(grown < 1 ? { ...line, to: along(line.from, line.to, grown), growing: true } : line);
  }
  return seen;
}
