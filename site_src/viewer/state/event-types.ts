/** What can happen on a pixel's ray tree, with the numbers that a sentence about it needs. */
import type { Vec3 } from "../trace/types";
import type { LineKind, SentKind } from "../trace/kinds";

export interface LightShare {
  name: string;
  seen: "reached" | "blocked" | "away" | "unasked" | "off";
  diffuse: number; // to be multiplied by the material's colour and the light's
  specular: number;
  colour: Vec3; // the light's
}

/** One term of a colour: share x colour. */
export interface Term {
  of: "local" | "background" | SentKind;
  share: number;
  colour: Vec3;
}

export type Degrees = number | null; // null: between points too close together to measure it

/** A hit sends a ray on. */
export interface Departure {
  what: SentKind;
  name: string; // of the object
  of: number; // the ray that came there
  share: number;
  keeps: number; // share of the surface's own colour
  clear: boolean; // it lets light through
  enters: boolean; // or would, were it not reflected
  from: number; // index of refraction on this side
  to: number; // and on the other
  angle: Degrees; // to the normal, as it came
  bent: Degrees; // as it goes on
}

export type Happening =
  | { what: "camera"; pixel: readonly [number, number]; eye: Vec3 }
  | Departure
  | { what: "meets"; name: string; t: number; point: Vec3; hits: readonly { name: string; t: number }[] }
  | { what: "background"; colour: Vec3 }
  | { what: "reached" | "away" | "unasked" | "off"; name: string }
  | { what: "blocked"; name: string; by: string; at: number } // world units from the hit
  | { what: "local"; base: Vec3 | null; ambient: Vec3; diffuse: Vec3; specular: Vec3; lights: readonly LightShare[]; share: number; colour: Vec3 }
  | { what: "stops"; name: string; keeps: number; limit: number; atLimit: boolean }
  | { what: "gather"; name: string; terms: readonly Term[]; colour: Vec3 }
  | { what: "pixel"; pixel: readonly [number, number]; terms: readonly Term[]; colour: Vec3; bytes: Vec3; before: readonly RayEvent[] };

export type RayEvent = Happening & {
  ray: number; // index into the trace; of a shadow ray: the ray whose hit it leaves
  light: number; // of a light's event, else -1
  line: LineKind | null; // whose colour it has on the timeline
  long: number; // world units of line that grow; 0: nothing does
};

/** A surface that sends a ray on. */
export type Passing = Pick<Departure, "what" | "name" | "enters">;

export interface Reason {
  how: "blocked" | "away" | "little" | "off" | "reached" | "paint"; // paint: no light, the surface itself is dark
  by: string; // what blocks
  lights: readonly string[];
}

export interface Why {
  tone: "dark" | "shadow" | "lit"; // shadow: not dark, but a light is blocked where the ray ends
  end: "local" | "background" | "stops";
  ray: number; // index into the trace
  way: readonly Passing[]; // that led to it, from the eye on
  share: number; // in the pixel's colour
  name: string; // of the object where it ends
  reasons: readonly Reason[];
}
