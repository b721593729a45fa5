/** The algorithm beside the player, as pseudo-code to read: the line that the current event belongs to is marked. Nothing here runs. */
import type { RayEvent } from "../state/event-types";
import { treeOf } from "../state/lines";
import { BRANCHES, RAY_KINDS, RAYS, type SentKind } from "../trace/kinds";
import type { Trace } from "../trace/types";
import { say } from "../words";
import type { PixelRays, RaysView } from "./card-types";
import { element, named } from "../element";

type Sent = Exclude<SentKind, "total">; // in place of a reflected ray: the same line
type Line = readonly [indent: number, name: "pixels" | "pixel" | "trace" | "hit" | "miss" | "ambient" | "lights" | "shadow" | "add" | "share" | "left" | Sent | "back", ...whats: RayEvent["what"][]];

const LINES: readonly Line[] = [
  [0, "pixels"],
  [1, "pixel", "camera", "pixel"],
  [0, "trace"],
  [1, "hit", "meets"],
  [1, "miss", "background"],
  [1, "ambient"],
  [1, "lights"],
  [2, "shadow", "reached", "blocked", "away", "unasked", "off"],
  [3, "add"],
  [1, "share", "local"],
  [1, "left", "stops"],
  ...sentLines(),
  [1, "back", "gather"],
];
/** Lines that the event has come through too. */
const WITH: Readonly<Record<string, readonly string[]>> = { reached: ["add"], unasked: ["add"], local: ["ambient", "add"], ...Object.fromEntries(RAY_KINDS.map((kind) => [kind, ["trace"]])) };

/** A line for each branch: a hit sends on at most one ray of it. */
function sentLines(): Line[] {
  const branches = Array.from({ length: BRANCHES }, (_, branch) => RAY_KINDS.filter((kind) => kind !== "camera" && RAYS[kind].branch === branch));
  return branches.map((kinds) => [2, kinds[0] as Sent, ...kinds]);
}

const MOST_CALLS = 4; // shown of a chain

export function createCode(): RaysView {
  const lines = LINES.map(([indent, name]) => {
    const line = element("li", "", say(`code.line.${name}`));
    line.dataset.indent = String(indent);
    return line;
  });
  const calls = element("p", "code-calls numbers");
  const root = named(element("section", "code", calls, element("ol", "code-lines", ...lines)), say("code.title"));
  root.tabIndex = 0; // where it scrolls, by keyboard too
  let of: PixelRays | null = null;

  return {
    element: root,
    show: (next) => void (of = next),
    light(_, event) {
      LINES.forEach(([, name, ...whats], k) => {
        const isHere = !!event && whats.includes(event.what);
        lines[k].classList.toggle("here", isHere);
        lines[k].classList.toggle("with", !!event && !isHere && !!WITH[event.what]?.includes(name));
        if (isHere) lines[k].setAttribute("aria-current", "step");
        else lines[k].removeAttribute("aria-current");
      });
      calls.textContent = event && of ? callsOf(event.ray, of.trace, of.pixel) : say("code.idle");
    },
  };
}

/** Who called whom: trace(ray 3) in trace(ray 1). */
function callsOf(ray: number, trace: Trace, pixel: number): string {
  const numbers = treeOf(trace, pixel);
  const chain: string[] = [];
  for (let at = ray; at >= 0; at = trace.parent[at]) chain.push(say("code.call", { ray: numbers.indexOf(at) + 1 }));
  if (chain.length > MOST_CALLS) chain.splice(MOST_CALLS - 1, chain.length - MOST_CALLS, "\u2026");
  return chain.join(` ${say("code.in")} `);
}
