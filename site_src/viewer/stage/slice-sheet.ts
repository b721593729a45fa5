/** What a slice's drawing shows, and where it lies on its canvas. Lengths in CSS pixels. */
import type { Costs } from "../state/costs";
import type { Line } from "../state/lines";
import { frameOf, type Curve, type Flat, type Section } from "../state/section";
import { besideOf } from "../state/silhouette";
import type { SceneData, Trace, Vec3 } from "../trace/types";

const EDGE = 34; // round the drawing, for labels
const ASIDE = 140; // more on its left, for the switch
const ABOVE = 24; // and over it
const NARROW = 700; // narrower, all of these stand outside

export interface SliceView {
  section: Section;
  scene: SceneData; // as the switches make it
  trace: Trace;
  tile: number; // the selected one along the section
  tiles: number; // filled, in scan order
  costs: Costs | null; // their colours
  chosen: readonly Line[];
  large: boolean; // words, on a projector
}

export interface Sheet {
  width: number;
  height: number;
  isWide: boolean;
  zoom: number; // pixels in a world unit
  at: (place: Flat) => Flat;
  on: (point: Vec3) => Flat;
  back: (x: number, y: number) => Flat;
  isSeen: (at: Flat) => boolean;
  beside: readonly Curve[]; // outlines of what blocks a light and does not reach into the plane
}

export function sheetOf({ section, scene, trace, chosen }: SliceView, width: number, height: number): Sheet {
  const isWide = width >= NARROW;
  const [aside, above] = isWide ? [ASIDE, ABOVE] : [0, 0];
  const beside = besideOf(section, scene, trace, chosen);
  const [left, top, right, bottom] = frameOf({ ...section, curves: [...section.curves, ...beside] }, scene);
  const zoom = Math.min((width - aside - 2 * EDGE) / Math.max(right - left, 1e-9), (height - above - 2 * EDGE) / Math.max(bottom - top, 1e-9));
  const [shiftX, shiftY] = [(width + aside) / 2 - (zoom * (left + right)) / 2, (height + above) / 2 - (zoom * (top + bottom)) / 2];
  const at = ([x, y]: Flat): Flat => [shiftX + zoom * x, shiftY + zoom * y];
  return {
    width,
    height,
    isWide,
    zoom,
    at,
    on: (point) => at(section.flat(point)),
    back: (x, y) => [(x - shiftX) / zoom, (y - shiftY) / zoom],
    isSeen: ([x, y]) => x >= aside && y >= 0 && x <= width && y <= height,
    beside,
  };
}
