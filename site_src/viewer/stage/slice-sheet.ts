/** What a slice's drawing shows, and where it lies on its canvas. Lengths in CSS pixels. */
import { frameOf, type Flat, type Section } from "../state/section";
import type { Shown } from "../state/shown";
import { besideOf } from "../state/silhouette";
import type { SceneData, Trace, Vec3 } from "../trace/types";

const EDGE = 34; // round the drawing, for labels
const ASIDE = 140; // more on its left, for the switch
const ABOVE = 24; // and over it
const NARROW = 700; // narrower, all of these stand outside

export interface SliceView extends Pick<Shown, "tiles" | "costs" | "chosen"> {
  section: Section;
  scene: SceneData; // as the switches make it
  trace: Trace;
  tile: number; // the selected one along the section
  large: boolean; // words, on a projector
}

export type Sheet = ReturnType<typeof sheetOf>;

export function sheetOf({ section, scene, trace, chosen }: SliceView, width: number, height: number) {
  const isWide = width >= NARROW;
  const [aside, above] = isWide ? [ASIDE, ABOVE] : [0, 0];
  const beside = besideOf(section, scene, trace, chosen);
  const [left, top, right, bottom] = frameOf({ ...section, curves: [...section.curves, ...beside] }, scene);
  const zoom = Math.min((width - aside - 2 * EDGE) / Math.max(right - left, 1e-9), (height - above - 2 * EDGE) / Math.max(bottom - top, 1e-9));
  const [shiftX, shiftY] = [(width + aside) / 2 - (zoom * (left + right)) / 2, (height + above) / 2 - (zoom * (top + bottom)) / 2];
  const at = ([x, y]: Flat): Flat => [shiftX + zoom * x, shiftY + zoom * y];
  return {
    isWide,
    zoom, // pixels in a world unit
    at,
    on: (point: Vec3) => at(section.flat(point)),
    back: (x: number, y: number): Flat => [(x - shiftX) / zoom, (y - shiftY) / zoom],
    isSeen: ([x, y]: Flat) => x >= aside && y >= 0 && x <= width && y <= height,
    beside, // outlines of what blocks a light and does not reach into the plane
  };
}
