/** How the pixel's colour adds up: a formula a ray, with the numbers put in. */
import { the } from "../articles";
import type { Actions } from "../actions";
import { materialAt } from "../state/events";
import type { LightRow, RayRow } from "../state/ray-rows";
import { isAll } from "../state/vectors";
import { tileColour } from "../state/view-state";
import { isGrey, column, figure, indexed, math, operator, piece, times, under } from "./mathml";
import type { MaterialData, Trace, SceneData, Vec3 } from "../trace/types";
import { fixed, number, phrases, say } from "../words";
import type { RaysView } from "./card-types";
import { clickable, element, marked } from "../element";
import { markRow } from "./lit-row";

/** Colours of one formula: as columns as soon as one of them is not grey. */
type Colours = (v: Vec3) => MathMLElement;
const coloursOf = (all: readonly Vec3[]): Colours => (all.every(isGrey) ? (v) => figure(v[0]) : (v) => column(v.map(number)));

function lightTerm({ name, seen, by, diffuse, specular, colour }: LightRow, of: MaterialData, show: Colours) {
  const nothing = (why: string) => piece(operator("+"), under(math("mn", "0"), why));
  if (seen === "blocked") return nothing(say("sum.blocked", { light: name, by: the(by) }));
  if (seen === "off" || seen === "away") return nothing(say(seen === "off" ? "sum.isOff" : "sum.away", { light: name }));
  const paints = ([[diffuse, of.diffuse], [specular, of.specular]] as const).filter(([factor, paint]) => factor !== 0 && !isAll(paint, 0));
  const parts = paints.flatMap(([factor, paint], k) => [...(k ? [operator("+")] : []), figure(factor), times(), show(paint)]);
  const sum = parts.length ? parts : [math("mn", "0")];
  const lit = isAll(colour, 1) ? sum : [...(paints.length > 1 ? [operator("("), ...sum, operator(")")] : sum), times(), show(colour)];
  return piece(operator("+"), under(math("mrow", ...lit), name));
}

/** The surface's own colour: ambient, and what each light gives. */
function ownFormula(row: RayRow, of: MaterialData, isWhole: boolean) {
  const show = coloursOf([row.local, row.ambient, ...row.lights.flatMap(({ colour, diffuse, specular }) => [colour, ...(diffuse ? [of.diffuse] : []), ...(specular ? [of.specular] : [])])]);
  const left = isWhole ? [indexed("C", row.number), operator("=")] : [];
  return [
    piece(...left, indexed("L", row.number), operator("="), under(show(row.ambient), say("sum.ambient"))),
    ...row.lights.map((light) => lightTerm(light, of, show)),
    piece(operator("="), show(row.local)),
  ];
}

/** Shares of own colour and of the rays sent on. */
function sumFormula(row: RayRow, sent: readonly RayRow[]) {
  const terms = [
    ...(row.keeps > 0 && row.object ? [{ share: row.keeps, name: indexed("L", row.number), colour: row.local, words: say("sum.own") }] : []),
    ...sent.map((ray) => ({ share: ray.weight, name: indexed("C", ray.number), colour: ray.colour, words: say(`tree.kind.${ray.kind}`) })),
  ];
  const show = coloursOf([row.colour, ...terms.map(({ colour }) => colour)]);
  if (!terms.length) return [piece(indexed("C", row.number), operator("="), row.object ? under(math("mn", "0"), say("sum.nothing")) : under(show(row.colour), say("sum.background")))];
  const product = (share: number, by: MathMLElement) => (share === 1 ? [by] : [figure(share), times(), by]);
  const plus = (k: number) => (k ? [operator("+")] : [operator("=")]);
  const named = terms.map(({ share, name, words }, k) => piece(...(k ? [] : [indexed("C", row.number)]), ...plus(k), under(math("mrow", ...product(share, name)), words)));
  const put = terms.map(({ share, colour }, k) => piece(...plus(k), ...product(share, show(colour))));
  const result = terms.length > 1 || terms[0].share !== 1 ? [piece(operator("="), show(row.colour))] : [];
  return [...named, ...put, ...result];
}

/** x 255, clamped, rounded. */
function bytesFormula({ colour, number }: RayRow, tile: Vec3) {
  const grey = isGrey(colour);
  const show = (values: readonly string[]) => (grey ? math("mn", values[0]) : column(values));
  const scaled = colour.map((v) => fixed(255 * v, 1));
  const clamped = colour.some((v) => v < 0 || v > 1);
  return [
    piece(math("mn", "255"), times(), indexed("C", number), operator("="), show(scaled)),
    piece(under(operator("\u2192"), say(clamped ? "sum.clamped" : "sum.rounded")), show(tile.map(String))),
  ];
}

type What = "local" | "gather" | "pixel" | "background" | "meets";

export function createSums(acts: Pick<Actions, "goToEvent">): RaysView {
  const list = element("ol", "sums");

  function item(row: RayRow, whats: readonly What[], title: HTMLElement, formulas: readonly MathMLElement[][], ...more: HTMLElement[]) {
    const made = element("li", `sum ${row.kind}`, title, ...formulas.map((pieces) => element("div", "formula", ...pieces)), ...more);
    Object.assign(made.dataset, { ray: row.ray, whats: whats.join(" ") });
    return clickable(made, () => acts.goToEvent(row.ray, -1, ...whats));
  }

  function items(row: RayRow, rows: readonly RayRow[], scene: SceneData, trace: Trace, tile: Vec3) {
    const sent = rows.filter(({ of }) => of === row.number);
    const made: HTMLElement[] = [];
    const isPixel = row.of === 0;
    const isOwn = row.lights.length > 0;
    const material = materialAt(trace, scene, row.ray)!;
    const title = (name: "sum.pixel" | "sum.ray" | "sum.open" | "sum.surface") => element("p", "sum-title", ...marked(phrases(name, { ray: row.number, object: the(row.object) })));
    const isWhole = !sent.length && isOwn && row.keeps === 1; // the ray brings the surface's own colour and no more
    if (isPixel) {
      const exact = row.colour.every((v, c) => Math.round(255 * Math.min(1, Math.max(0, v))) === tile[c]);
      const note = exact ? [] : [element("p", "note", say("sum.off"))];
      made.push(item(row, ["pixel"], title("sum.pixel"), [sumFormula(row, sent), bytesFormula(row, tile)], ...note));
    } else if (!isWhole) made.push(item(row, sent.length ? ["gather"] : row.object ? ["meets"] : ["background"], title(row.object ? "sum.ray" : "sum.open"), [sumFormula(row, sent)]));
    if (isOwn) made.push(item(row, ["local"], title("sum.surface"), [ownFormula(row, material, isWhole && !isPixel)]));
    return made;
  }

  return {
    element: list,
    show({ rows, scene, trace, pixel }) {
      list.replaceChildren(...rows.flatMap((row) => items(row, rows, scene, trace, tileColour(trace, pixel))));
      list.scrollTop = 0;
    },
    /** Only an event has its formula. */
    light(_, event) {
      const all = [...list.children] as HTMLElement[];
      markRow(list, all, (event && all.find(({ dataset }) => dataset.ray === String(event.ray) && dataset.whats!.split(" ").includes(event.what))) ?? null, true);
    },
  };
}
