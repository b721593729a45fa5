/** Questions whose answers the trace knows: which pixels they are about is chosen by what happens there. */
import { the } from "../articles";
import { isSwitched } from "../state/switches";
import { triple } from "../state/vectors";
import { pixelIndex } from "../state/view-state";
import { KIND, RAY_KINDS } from "../trace/kinds";
import { VISIBILITY, type SceneData, type Trace } from "../trace/types";
import { number, say, vector } from "../words";
import { walksPixel, type Stop, type Traces } from "./seen";

export interface Question {
  asks: string;
  answer: string;
}

/** What is asked of a pixel. */
export type Pick = { pixel: number } & (
  | { of: "nearest" | "order" | "bytes" }
  | { of: "shadow"; light: number }
  | { of: "sent"; ray: number }
);

const NEAREST = 3; // questions of what is met first, each by another object
const GOLDEN = 0.381966; // of the pixels: a step that spreads them

const gcd = (a: number, b: number): number => (b ? gcd(b, a % b) : a);

/** All pixels, those that the lesson walks first, then spread over the picture. */
function spread({ n }: Trace, walked: readonly number[]): number[] {
  const count = n * n;
  let step = Math.floor(count * GOLDEN);
  while (gcd(step, count) !== 1) step++; // so it visits every pixel
  return [...new Set([...walked, ...Array.from({ length: count }, (_, k) => (k * step) % count)])];
}

const hitsAlong = (trace: Trace, pixel: number): number[] => Array.from({ length: trace.hitsStart[pixel + 1] - trace.hitsStart[pixel] }, (_, k) => trace.hitsStart[pixel] + k);

/** The first grid that the lesson shows as it was traced, and what of it is asked; walked pixels come first. */
export function worksheetOf(stops: readonly Stop[], traces: Traces): { n: number; picks: readonly Pick[] } {
  const states = stops.map(({ state }) => state).filter(({ switches }) => !isSwitched(switches));
  if (!states.length) return { n: 0, picks: [] };
  const [{ n }] = states;
  return { n, picks: picksOf(traces(n), states.filter((state) => state.n === n && walksPixel(state)).map(pixelIndex)) };
}

function picksOf(trace: Trace, walked: readonly number[]): Pick[] {
  const pixels = spread(trace, walked);
  const met = new Set<number>();
  const nearest = pixels.filter((pixel) => met.size < NEAREST && !met.has(trace.object[pixel]) && met.add(trace.object[pixel]));
  const first = (test: (pixel: number) => boolean) => pixels.filter((pixel) => trace.object[pixel] >= 0).find(test);
  const lightAt = (pixel: number, wanted: number) => trace.visibility.subarray(pixel * trace.lights, (pixel + 1) * trace.lights).indexOf(wanted);
  const shadows = [VISIBILITY.blocked, VISIBILITY.reached].flatMap((wanted): Pick[] => {
    const pixel = first((each) => lightAt(each, wanted) >= 0);
    return pixel === undefined ? [] : [{ of: "shadow", pixel, light: lightAt(pixel, wanted) }];
  });
  const sent = [KIND.reflected, KIND.refracted].flatMap((kind): Pick[] => {
    const rays = new Map<number, number>(); // that meet something, by their pixel's camera ray
    for (let ray = trace.n * trace.n; ray < trace.count; ray++) if (trace.kind[ray] === kind && trace.object[ray] >= 0) rays.set(trace.parent[ray], ray);
    const pixel = first((each) => rays.has(each));
    return pixel === undefined ? [] : [{ of: "sent", pixel, ray: rays.get(pixel)! }];
  });
  const order = pixels.find((pixel) => new Set(hitsAlong(trace, pixel).map((k) => trace.hitsObject[k])).size > 1);
  const bytes = pixels.find((pixel) => new Set(triple(trace.colour, pixel).map((part) => part.toFixed(2))).size > 1);
  const one = (of: "order" | "bytes", pixel: number | undefined): Pick[] => (pixel === undefined ? [] : [{ of, pixel }]);
  return [...nearest.map((pixel): Pick => ({ of: "nearest", pixel })), ...one("order", order), ...shadows, ...sent, ...one("bytes", bytes)];
}

export function questionOf(pick: Pick, trace: Trace, scene: SceneData): Question {
  const { pixel } = pick;
  const at = { x: pixel % trace.n, y: Math.floor(pixel / trace.n), n: trace.n };
  const name = the(scene.objects[trace.object[pixel]]?.name ?? "");
  const meets = (ray: number) =>
    trace.object[ray] < 0 ? say("slides.answerLeaves") : say("slides.answerNearest", { name: scene.objects[trace.object[ray]].name, t: number(trace.t[ray]), point: vector(triple(trace.point, ray)) });
  switch (pick.of) {
    case "nearest":
      return { asks: say("slides.askNearest", at), answer: meets(pixel) };
    case "order": {
      const hits = hitsAlong(trace, pixel).map((k) => say("event.meetsFirst.hit", { name: scene.objects[trace.hitsObject[k]].name, t: number(trace.hitsT[k]) }));
      return { asks: say("slides.askOrder", at), answer: hits.join("; ") };
    }
    case "shadow": {
      const of = pixel * trace.lights + pick.light;
      const isBlocked = trace.visibility[of] === VISIBILITY.blocked;
      const answer = isBlocked ? say("slides.answerBlocked", { name: the(scene.objects[trace.blocker[of]].name) }) : say("slides.answerArrives");
      return { asks: say("slides.askShadow", { ...at, name, light: the(scene.lights[pick.light].name) }), answer };
    }
    case "sent": {
      const key = RAY_KINDS[trace.kind[pick.ray]] === "reflected" ? "slides.askReflected" : "slides.askRefracted";
      return { asks: say(key, { ...at, name }), answer: meets(pick.ray) };
    }
    case "bytes": {
      const bytes = triple(trace.tiles, pixel).join(", ");
      return { asks: say("slides.askBytes", { ...at, colour: vector(triple(trace.colour, pixel)) }), answer: say("slides.answerBytes", { bytes }) };
    }
  }
}
