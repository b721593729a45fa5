/** Why a pixel is dark, or lit: the ray whose end counts most in it, and what the lights say there. From its events alone. */
import type { Departure, LightShare, Reason, RayEvent, Why } from "./event-types";

const DARK = 80; // of 255: its brightest channel is below
const LITTLE = 0.25; // of the light, by its stored diffuse factor
const HOWS: readonly Reason["how"][] = ["blocked", "away", "little", "off", "reached", "paint"]; // causes first

function howOf({ seen, diffuse }: LightShare, dark: boolean): Reason["how"] {
  if (seen === "reached" || seen === "unasked") return dark && diffuse < LITTLE ? "little" : "reached";
  return seen;
}

/** Lights grouped by what is to be said of them. by: what blocks each. */
function reasonsOf(lights: readonly LightShare[], by: ReadonlyMap<string, string>, dark: boolean): Reason[] {
  const stated = lights.map((light) => ({ how: howOf(light, dark), by: by.get(light.name) ?? "", light: light.name }));
  const found = HOWS.flatMap((how) => {
    const alike = stated.filter((each) => each.how === how);
    return [...new Set(alike.map((each) => each.by))].map((by) => ({ how, by, lights: alike.filter((each) => each.by === by).map((each) => each.light) }));
  });
  return dark && found.every(({ how }) => how === "reached") ? [...found, { how: "paint", by: "", lights: [] }] : found;
}

const isSentOn = (event: RayEvent): event is RayEvent & Departure => "of" in event;

/** A pixel's last event, told by those before it, in any order. */
export function whyOf({ bytes, before }: Pick<RayEvent & { what: "pixel" }, "bytes" | "before">): Why | null {
  const sent = new Map(before.filter(isSentOn).map((each) => [each.ray, each]));
  const wayOf = (ray: number): (RayEvent & Departure)[] => {
    const last = sent.get(ray);
    return last ? [...wayOf(last.of), last] : [];
  };
  const dark = Math.max(...bytes) < DARK;
  /** What is in a light's way from this ray's hit. */
  const blockers = (ray: number) => new Map(before.flatMap((each) => (each.what === "blocked" && each.ray === ray ? [[each.name, each.by]] : [])));
  let why: Why | null = null;
  for (const event of before) {
    const { what, ray } = event;
    if (what !== "local" && what !== "stops" && what !== "background") continue;
    const way = wayOf(ray);
    const share = way.reduce((all, each) => all * each.share, what === "local" ? event.share : what === "stops" ? 1 - event.keeps : 1);
    // Of equals the first ray, and of its ends its own colour.
    if (why && (share - why.share || why.ray - ray || (what === "local" ? 1 : -1)) < 0) continue;
    const reasons = what === "local" ? reasonsOf(event.lights, blockers(ray), dark) : [];
    const tone = dark ? "dark" : reasons.some(({ how }) => how === "blocked") ? "shadow" : "lit";
    const met = before.find((each) => each.what === "meets" && each.ray === ray);
    why = { ray, tone, end: what, way, share, name: met?.what === "meets" ? met.name : "", reasons };
  }
  return why;
}
