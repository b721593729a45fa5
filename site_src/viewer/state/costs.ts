/** What a tile can show besides its colour: how much work its rays were, and what its camera ray met. */
import { KIND } from "../trace/kinds";
import { VISIBILITY, type SceneData, type Trace } from "../trace/types";
import { materialAt } from "./events";
import { HIDDEN } from "./switches";
import { plainly, type Costs, type TileView } from "./tile-views";

/** Anchors of the cividis map: the same order of lightness for every kind of colour vision
 *  (Nunez, Anderton, Renslow 2018). */
const CIVIDIS = [0x00224e, 0x123570, 0x3b496c, 0x575d6d, 0x707173, 0x8a8678, 0xa59c74, 0xc3b369, 0xe1cc55, 0xfee838];
const NOTHING = [17, 20, 25] as const; // a tile whose ray leaves the scene

/** 8-bit colour of a share of the scale. */
export function onScale(share: number): readonly [number, number, number] {
  const at = Math.min(1, Math.max(0, share)) * (CIVIDIS.length - 1);
  const k = Math.min(CIVIDIS.length - 2, Math.floor(at));
  const part = (shift: number) => {
    const [a, b] = [CIVIDIS[k], CIVIDIS[k + 1]].map((hex) => (hex >> shift) & 255);
    return Math.round(a + (at - k) * (b - a));
  };
  return [part(16), part(8), part(0)];
}

function sums(trace: Trace, of: (ray: number) => number, join: (a: number, b: number) => number): Float64Array {
  const values = new Float64Array(trace.n * trace.n);
  for (let ray = 0; ray < trace.count; ray++) {
    const pixel = trace.pixel[ray];
    if (pixel !== HIDDEN) values[pixel] = join(values[pixel], of(ray));
  }
  return values;
}

const add = (a: number, b: number) => a + b;

/** A ray and the shadow rays shot from where it ends. */
function raysAt(trace: Trace, ray: number): number {
  let count = 1;
  for (let at = ray * trace.lights; at < (ray + 1) * trace.lights; at++) {
    const seen = trace.visibility[at];
    if (seen === VISIBILITY.reached || seen === VISIBILITY.blocked) count++;
  }
  return count;
}

/** Of the light that the lamps would give a pixel along all its rays if nothing stood in the way, the share that is
 *  blocked or kept by glass: 1 - (what arrives) / (what would), both sums over hits and lamps of the hit's share in
 *  the pixel times its diffuse and highlight terms, red, green and blue added up. */
function shadowed(trace: Trace, scene: SceneData): Float64Array {
  const [would, arrives] = [new Float64Array(trace.n * trace.n), new Float64Array(trace.n * trace.n)];
  const share = trace.weight.slice(); // in the pixel: parents stand before their children
  for (let ray = 0; ray < trace.count; ray++) {
    if (trace.parent[ray] >= 0) share[ray] *= share[trace.parent[ray]];
    const pixel = trace.pixel[ray];
    if (pixel === HIDDEN || trace.object[ray] < 0) continue;
    const { diffuse, specular } = materialAt(trace, scene, ray)!;
    for (const [light, { colour }] of scene.lights.entries()) {
      const at = ray * trace.lights + light, seen = trace.visibility[at];
      if (seen === VISIBILITY.behind || seen === VISIBILITY.off) continue;
      const given = share[ray] * trace.localWeight[ray] * [0, 1, 2].reduce((sum, c) => sum + (trace.diffuse[at] * diffuse[c] + trace.specular[at] * specular[c]) * colour[c], 0);
      would[pixel] += seen === VISIBILITY.untested ? given : given / trace.passed[at];
      if (seen !== VISIBILITY.blocked) arrives[pixel] += given;
    }
  }
  return would.map((all, pixel) => (all > 0 ? 1 - arrives[pixel] / all : NaN));
}

/** A tile's number, NaN where it has none, and how it is written. A share's scale is from nothing to all,
 *  the others' from the least to the most there is. */
interface Scaled {
  of: (trace: Trace, scene: SceneData) => Float64Array; // (n * n)
  written: "count" | "length" | "share";
}

/** The table of what tiles can show by a scale of colours; its words are below tileView. */
const SCALED = {
  rays: { of: (trace) => sums(trace, (ray) => raysAt(trace, ray), add), written: "count" },
  depth: { of: (trace) => sums(trace, (ray) => trace.depth[ray], Math.max), written: "count" },
  tests: { of: (trace) => sums(trace, (ray) => trace.tests[ray], add), written: "count" },
  distance: { of: (trace) => sums(trace, (ray) => (trace.kind[ray] === KIND.camera ? (Number.isFinite(trace.t[ray]) ? trace.t[ray] : NaN) : 0), add), written: "length" },
  shadow: { of: shadowed, written: "share" },
} as const satisfies Readonly<Record<Exclude<TileView, "picture" | "normal">, Scaled>>;

export type ScaledView = keyof typeof SCALED;
export type CountedView = { [Each in ScaledView]: (typeof SCALED)[Each]["written"] extends "count" ? Each : never }[ScaledView];
export const scaleOf = (view: ScaledView): Scaled => SCALED[view];

function normals(trace: Trace): Uint8Array {
  const colours = new Uint8Array(3 * trace.n * trace.n);
  for (let k = 0; k < trace.n * trace.n; k++)
    for (let c = 0; c < 3; c++) colours[3 * k + c] = trace.object[k] < 0 ? NOTHING[c] : Math.round((255 * (trace.normal[3 * k + c] + 1)) / 2);
  return colours;
}

export function costsOf(trace: Trace, scene: SceneData, view: TileView): Costs {
  if (view === "picture") return plainly(view, trace.tiles);
  if (view === "normal") return plainly(view, normals(trace));
  const { of, written } = scaleOf(view);
  const values = of(trace, scene);
  const known = written === "share" ? Float64Array.of(0, 1) : values.filter((value) => !Number.isNaN(value));
  const [least, most] = [known.reduce((a, b) => Math.min(a, b), Infinity), known.reduce((a, b) => Math.max(a, b), -Infinity)];
  const colours = new Uint8Array(3 * values.length);
  for (let k = 0; k < values.length; k++) colours.set(Number.isNaN(values[k]) ? NOTHING : onScale(most > least ? (values[k] - least) / (most - least) : 0), 3 * k);
  return { view, colours, values, least: known.length ? least : 0, most: known.length ? most : 0 };
}
