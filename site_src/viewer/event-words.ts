/** The player's sentences: one for each event, and under it its numbers. */
import type { Degrees, LightShare, RayEvent, Term } from "./state/events";
import type { LineKind } from "./state/lines";
import type { Vec3 } from "./trace/types";
import { bytes, LINE_WORDS, number, vector } from "./words";

/** Plain words, or words with a ray kind's colour; "" for bold. */
export type Phrase = string | readonly [string, LineKind | ""];

export interface Told {
  says: readonly Phrase[];
  numbers: string;
}

const bold = (text: string): Phrase => [text, ""];
const percent = (share: number) => `${Math.round(share * 1000) / 10}\u202f%`;
const at = (angle: Degrees) => (angle === null ? "" : ` \u00b7 angle ${angle.toFixed(1)}\u00b0`);
const bends = (angle: Degrees, bent: Degrees) => (angle === null || bent === null ? "" : `${at(angle)} to ${bent.toFixed(1)}\u00b0`);
const index = (n: number) => n.toFixed(2);
/** A grey as one number, a colour as three. */
const tone = (v: Vec3) => (v.every((each) => number(each) === number(v[0])) ? number(v[0]) : vector(v));
const isWhite = (v: Vec3) => v.every((each) => each === 1);
const isBlack = (v: Vec3) => v.every((each) => each === 0);
const hitList = (hits: readonly { name: string; t: number }[]) => hits.map(({ name, t }) => `${name} at ${number(t)}`).join(", ");

function lightNumbers({ name, seen, diffuse, specular, colour }: LightShare, of: { diffuse: Vec3; specular: Vec3 }): string {
  if (seen === "blocked") return `${name}: 0, in shadow`;
  if (seen === "away") return `${name}: 0, faces away`;
  const part = (word: string, factor: number, paint: Vec3) => (isBlack(paint) || number(factor) === number(0) ? [] : [`${word} ${number(factor)} \u00d7 ${tone(paint)}`]);
  const parts = [...part("diffuse", diffuse, of.diffuse), ...part("specular", specular, of.specular)];
  const sum = parts.length > 1 && !isWhite(colour) ? `(${parts.join(" + ")})` : parts.join(" + ");
  return `${name}: ${sum === "" ? "0" : isWhite(colour) ? sum : `${sum} \u00d7 its colour ${tone(colour)}`}`;
}

const termNumbers = ({ of, share, colour }: Term) => `${of === "local" ? "own" : of === "background" ? of : LINE_WORDS[of]} ${share === 1 ? "" : `${percent(share)} of `}${tone(colour)}`;
const sumNumbers = (terms: readonly Term[], colour: Vec3) => `${terms.map(termNumbers).join(" + ") || "nothing"} = ${tone(colour)}`;

export function tell(event: RayEvent): Told {
  switch (event.what) {
    case "camera":
      return { says: ["A ", ["camera ray", "camera"], ` leaves through pixel (${event.pixel.join(", ")}).`], numbers: `from the eye ${vector(event.eye)}` };
    case "meets": {
      const nearest = event.hits.length > 1 ? `${hitList(event.hits)}: the nearest wins` : `distance ${number(event.t)}`;
      return { says: ["It meets ", bold(event.name), event.hits.length > 1 ? " first: of all it would meet, the nearest counts." : "."], numbers: `${nearest} \u00b7 point ${vector(event.point)}` };
    }
    case "background":
      return { says: ["It meets nothing and leaves the scene: it brings the background's colour."], numbers: tone(event.colour) };
    case "reached":
      return { says: ["A ", ["shadow ray", "reached"], ` goes to ${event.name} and `, bold("arrives"), ": this light counts."], numbers: `distance ${number(event.long)}` };
    case "blocked":
      return { says: ["A ", ["shadow ray", "blocked"], ` goes to ${event.name} and is `, bold(`blocked by ${event.by}`), ": this light gives nothing here."], numbers: `blocked at ${number(event.at)}` };
    case "away":
      return { says: [`The surface faces away from ${event.name}: no shadow ray is needed, it gives nothing here.`], numbers: "" };
    case "unasked":
      return { says: [`This scene asks for no shadows: ${event.name} counts as seen.`], numbers: "" };
    case "local": {
      const sum = [`ambient ${tone(event.ambient)}`, ...event.lights.map((light) => lightNumbers(light, event))].join(" + ");
      const keeps = event.share < 1 ? ` \u00b7 ${percent(event.share)} of it counts, the rest is for rays sent on` : "";
      return { says: ["The surface's ", bold("own colour"), ": ambient, and what each light gives."], numbers: `${sum} = ${tone(event.colour)}${keeps}` };
    }
    case "reflected": {
      const ray: Phrase = ["reflected ray", "reflected"];
      const why = event.clear ? " mirrors a part" : event.keeps > 0 ? " mirrors as well" : " has no colour of its own";
      return { says: [bold(event.name), `${why}: it sends a `, ray, " on, at the angle the last one came in."], numbers: `share ${percent(event.share)}${at(event.angle)}` };
    }
    case "refracted":
      return {
        says: ["A ", ["refracted ray", "refracted"], event.enters ? " goes into " : " comes out of ", bold(event.name), event.from === event.to ? ", straight on." : ", bent at its surface."],
        numbers: `index ${index(event.from)} to ${index(event.to)}${bends(event.angle, event.bent)} \u00b7 share ${percent(event.share)}`,
      };
    case "total":
      return {
        says: ["Too flat to get out of ", bold(event.name), ": the ray is ", ["totally reflected", "total"], "."],
        numbers: `index ${index(event.from)} to ${index(event.to)}${at(event.angle)} \u00b7 share ${percent(event.share)}`,
      };
    case "stops":
      return {
        says: [bold(event.name), event.atLimit ? " would send a ray on, but the most bounces are reached: here the walk ends." : " would send a ray on, but too little of it would be seen in the pixel."],
        numbers: event.atLimit ? `at most ${event.limit} bounces` : "",
      };
    case "gather":
      return { says: ["The colours come back to ", bold(event.name), " and add up."], numbers: sumNumbers(event.terms, event.colour) };
    case "pixel":
      return {
        says: ["The colours come back and add up to ", bold(`pixel (${event.pixel.join(", ")})`), ": ", bold(event.bytes.join(", ")), "."],
        numbers: `${sumNumbers(event.terms, event.colour)} \u00b7 \u00d7 255: ${bytes(event.colour)}`,
      };
  }
}

/** The sentence alone, for the scrub bar's value. */
export const sentence = (event: RayEvent): string => tell(event).says.map((phrase) => (typeof phrase === "string" ? phrase : phrase[0])).join("");

export const PLAYER_WORDS = {
  region: "Step by step",
  play: ["Play", "Play the rays step by step (P)"],
  pause: ["Pause", "Pause (P)"],
  back: "One event back (comma)",
  on: "One event on (full stop)",
  end: "Leave the step-by-step player (Esc)",
  scrub: "Event",
  none: "All of the pixel's rays show",
  at: (event: number, of: number, says: string) => `${event + 1} of ${of}: ${says}`,
  count: (event: number | null, of: number) => (event === null ? `${of} events` : `${event + 1} / ${of}`),
  speed: "Speed of rendering and of the player",
};
