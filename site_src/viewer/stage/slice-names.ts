/** The names on a slice's drawing: the eye's, the lamps', the objects'. */
import { CURVE, type Curve, type Flat } from "../state/section";
import { say } from "../words";
import type { Label } from "./labels";
import type { Sheet, SliceView } from "./slice-sheet";

const PLACES = [0.5, 0.6, 0.4, 0.7, 0.3, 0.55, 0.45]; // along a line, the best first

/** Most important first. A narrow drawing names only those objects that the chosen rays meet. */
export function namesOf({ section, scene, trace, chosen }: SliceView, sheet: Sheet): Label[] {
  const label = (key: string, text: string, [x, y]: Flat, below = false, kind: Label["kind"] = "sign"): Label => ({ key, text, x, y, kind, below });
  const nameOf = (curve: Curve) => scene.objects[curve.object].name;
  const met = new Set(chosen.map(({ ray }) => trace.object[ray]));
  const lights = scene.lights.map(({ name, position, intensity }) => label(`light ${name}`, intensity > 0 ? name : say("stage.off", { light: name }), sheet.on(position)));
  const outlines = section.curves.filter(({ object }, k) => (sheet.isWide || met.has(object)) && section.curves.findIndex((each) => each.object === object) === k);
  return [
    label("eye", say("slice.eye"), sheet.at(section.eye), true),
    ...lights.filter(({ x, y }) => sheet.isSeen([x, y])),
    ...outlines.flatMap((curve) => anchorsOf(curve, sheet).map((at) => label(`object ${curve.object}`, nameOf(curve), at, curve.kind !== CURVE.open || runsAcross(curve)))),
    ...sheet.beside.flatMap((curve) => anchorsOf(curve, sheet).map((at) => label(`aside ${curve.object}`, say("slice.aside", { name: nameOf(curve) }), at, true, "stop"))),
  ];
}

/** A name beside a line that runs across would be struck through. */
function runsAcross({ points }: Curve): boolean {
  const [from, to] = [points[0], points[points.length - 1]];
  return Math.abs(from[1] - to[1]) < Math.abs(from[0] - to[0]);
}

/** Where a curve's name belongs: beneath its middle; beside a place of a line that is in the picture, if any is. */
function anchorsOf({ kind, points }: Curve, { at, isSeen }: Sheet): Flat[] {
  if (kind === CURVE.ellipse) return [at(points[0])];
  const mean = (axis: 0 | 1) => points.reduce((sum, p) => sum + p[axis], 0) / points.length;
  if (kind === CURVE.closed) return [at([mean(0), mean(1)])];
  const [from, to] = [at(points[0]), at(points[points.length - 1])];
  const along = PLACES.map((share): Flat => [from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])]);
  return [...along, from, to].filter(isSeen).slice(0, 1);
}
