/** Events in words, as plain data. */
import { captionOf } from "../event-words";
import type { RayEvent } from "../state/event-types";
import { eventsOf } from "../state/events";
import { whyOf } from "../state/why";
import type { SceneData, Trace } from "../trace/types";
import { plain } from "../words";

export interface Worded {
  says: string;
  phrases: readonly (readonly [string, string | null])[]; // null: plain, "": bold, else a kind of ray
  numbers: string;
}

export function worded(event: RayEvent): Worded {
  const { says, numbers } = captionOf(event);
  return { says: plain(says), phrases: says.map((phrase) => (typeof phrase === "string" ? [phrase, null] : phrase)), numbers };
}

/** A pixel's events, as `raywalk inspect --events --json` lists them. */
export function listEvents(scene: SceneData, trace: Trace, [column, row]: readonly [number, number]) {
  return eventsOf(trace, scene, row * trace.n + column).map((event) => {
    const { what, ray, light, line, long, ...facts } = event.what === "pixel" ? { ...event, before: undefined, why: whyOf(event) } : event;
    return { what, ray, light, line, long, facts, ...worded(event) };
  });
}
