/** The player's events in words: a sentence each, and under it its numbers. */
import { the } from "./articles";
import type { Degrees, LightShare, RayEvent, Term, Why } from "./state/event-types";
import { isAll } from "./state/vectors";
import { whyOf } from "./state/why";
import type { Vec3 } from "./trace/types";
import { wayWords } from "./way-words";
import { allOf, bytes, fixed, list, number, percent, phrases, plain, say, tone, vector, type Phrase } from "./words";

export interface Caption {
  says: readonly Phrase[];
  numbers: string;
}

const MOST_NAMED = 4; // lamps, one by one

/** Numbers that stand beside one another. */
const beside = (...parts: readonly string[]) => parts.filter(Boolean).join(" \u00b7 ");
const degrees = (angle: number) => fixed(angle, 1);
const angleOf = (angle: Degrees) => (angle === null ? "" : say("event.departure.angle", { angle: degrees(angle) }));
const bends = (angle: Degrees, bent: Degrees) => (angle === null || bent === null ? "" : say("event.departure.bends", { angle: degrees(angle), bent: degrees(bent) }));
const index = (from: number, to: number) => say("event.departure.index", { from: fixed(from, 2), to: fixed(to, 2) });
/** Through a border that bends nothing; and where a wrong program leaves glass unbent, as far as the angles shown tell. */
const isStraight = ({ from, to, angle, bent }: { from: number; to: number; angle: Degrees; bent: Degrees }) => from === to || (!!angle && !!bent && degrees(angle) !== degrees(0) && degrees(angle) === degrees(bent));
const share = (part: number) => say("event.departure.share", { share: percent(part) });

function lightNumbers({ name, seen, diffuse, specular, colour }: LightShare, of: { diffuse: Vec3; specular: Vec3 }): string {
  if (seen === "blocked") return say("event.local.inShadow", { light: name });
  if (seen === "off") return say("event.local.isOff", { light: name });
  if (seen === "away") return say("event.local.facesAway", { light: name });
  const part = (what: "diffuse" | "specular", factor: number, paint: Vec3) =>
    isAll(paint, 0) || number(factor) === number(0) ? [] : [say(`event.local.${what}`, { factor: number(factor), colour: tone(paint) })];
  const parts = [...part("diffuse", diffuse, of.diffuse), ...part("specular", specular, of.specular)];
  const sum = parts.length > 1 && !isAll(colour, 1) ? `(${parts.join(" + ")})` : parts.join(" + ");
  if (sum === "" || isAll(colour, 1)) return say("event.local.gives", { light: name, sum: sum || "0" });
  return say("event.local.givesColoured", { light: name, sum, colour: tone(colour) });
}

/** Of many lamps those that say the same to the last digit shown say it once: a large lamp is up to a hundred points. */
function lightsNumbers(lights: readonly LightShare[], of: { diffuse: Vec3; specular: Vec3 }): string[] {
  if (lights.length <= MOST_NAMED) return lights.map((light) => lightNumbers(light, of));
  const saying = lights.map((light) => lightNumbers({ ...light, name: "" }, of));
  return [...new Set(saying)].map((said) => {
    const alike = lights.filter((_, k) => saying[k] === said);
    return lightNumbers({ ...alike[0], name: alike.length > 1 ? say("event.local.each", { count: alike.length }) : alike[0].name }, of);
  });
}

function termNumbers(term: Term): string {
  const of = say(`event.term.${term.of}`);
  const colour = tone(term.colour);
  return term.share === 1 ? say("event.term.whole", { of, colour }) : say("event.term.part", { of, share: percent(term.share), colour });
}

export const sumNumbers = (terms: readonly Term[], colour: Vec3) => `${terms.map(termNumbers).join(" + ") || say("event.term.nothing")} = ${tone(colour)}`;

export { whyOf };

/** In one sentence why a pixel is dark, partly so, or lit. */
export function whyDark({ tone, end, way, share, name, reasons }: Why): Phrase[] {
  const at = { share: percent(share), name: the(name) };
  const of = reasons.reduce((sum, { lights }) => sum + lights.length, 0);
  const listed = (lights: readonly string[]) => (lights.length > MOST_NAMED ? say("why.lamps", { number: lights.length, of }) : allOf(lights.map(the)));
  const said = end === "local" ? reasons.map(({ how, by, lights }) => phrases(`why.${how}`, { lights: listed(lights), name: the(name), by: the(by) })) : [phrases(`why.${end}`, at)];
  const parts = end === "stops" || (end === "local" && way.length) ? [phrases("why.at", at), ...said] : said;
  return [...phrases(`why.${tone}`), ...(way.length ? [say("card.sharedBy", { way: wayWords(way), object: "" })] : []), ...parts.flatMap((part, k) => (k ? ["; ", ...part] : part)), "."];
}

const darkly = (why: Why | null): Phrase[] => (why && why.tone !== "lit" ? [" ", ...whyDark(why)] : []);

export function captionOf(event: RayEvent): Caption {
  const { what } = event;
  switch (what) {
    case "camera":
      return { says: phrases("event.camera.says", { x: event.pixel[0], y: event.pixel[1] }), numbers: say("event.camera.numbers", { eye: vector(event.eye) }) };
    case "meets": {
      const { name, hits } = event;
      const point = vector(event.point);
      if (hits.length < 2) return { says: phrases("event.meets.says", { name: the(name) }), numbers: say("event.meets.numbers", { t: number(event.t), point }) };
      const met = list(hits.map((hit) => say("event.meetsFirst.hit", { name: hit.name, t: number(hit.t) })));
      return { says: phrases("event.meetsFirst.says", { name: the(name) }), numbers: say("event.meetsFirst.numbers", { hits: met, point }) };
    }
    case "background":
      return { says: phrases("event.background.says"), numbers: tone(event.colour) };
    case "reached":
      return { says: phrases("event.reached.says", { light: the(event.name) }), numbers: say("event.reached.numbers", { long: number(event.long) }) };
    case "blocked":
      return { says: phrases("event.blocked.says", { light: the(event.name), name: the(event.by) }), numbers: say("event.blocked.numbers", { at: number(event.at) }) };
    case "away":
    case "unasked":
    case "off":
      return { says: phrases(`event.${what}.says`, { light: the(event.name) }), numbers: "" };
    case "local": {
      const sum = [say("event.local.ambient", { colour: tone(event.ambient) }), ...lightsNumbers(event.lights, event)].join(" + ");
      const keeps = event.share < 1 ? say("event.local.keeps", { share: percent(event.share) }) : "";
      return { says: phrases("event.local.says"), numbers: beside(event.base ? say("card.base", { colour: tone(event.base) }) : "", `${sum} = ${tone(event.colour)}`, keeps) };
    }
    case "reflected": {
      const how = event.clear ? "clear" : event.keeps > 0 ? "coloured" : "mirror";
      return { says: phrases(`event.reflected.${how}`, { name: the(event.name) }), numbers: beside(share(event.share), angleOf(event.angle)) };
    }
    case "refracted": {
      const how = `${event.enters ? "in" : "out"}${isStraight(event) ? "Straight" : ""}` as const;
      return {
        says: phrases(`event.refracted.${how}`, { name: the(event.name) }),
        numbers: beside(index(event.from, event.to), bends(event.angle, event.bent), share(event.share)),
      };
    }
    case "total":
      return { says: phrases("event.total.says", { name: the(event.name) }), numbers: beside(index(event.from, event.to), angleOf(event.angle), share(event.share)) };
    case "stops":
      return {
        says: phrases(`event.stops.${event.atLimit ? "atLimit" : "tooLittle"}`, { name: the(event.name) }),
        numbers: event.atLimit ? say("event.stops.limit", { count: event.limit }) : "",
      };
    case "gather":
      return { says: phrases("event.gather.says", { name: the(event.name) }), numbers: sumNumbers(event.terms, event.colour) };
    case "pixel":
      return {
        says: [...phrases("event.pixel.says", { x: event.pixel[0], y: event.pixel[1], bytes: event.bytes.join(", ") }), ...darkly(whyOf(event))],
        numbers: beside(sumNumbers(event.terms, event.colour), `\u00d7 255, ${say("sum.clamped")}: ${bytes(event.colour)}`),
      };
  }
}

/** The sentence alone, for the scrub bar's value. */
export const sentence = (event: RayEvent): string => plain(captionOf(event).says);
