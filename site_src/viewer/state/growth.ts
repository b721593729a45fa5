/** Rendering: the rays of the tile being filled grow from the camera on, to hits, lights and mirrors.
 *  All of it follows from how much is filled, so that every refresh rate shows the same. */
import type { SceneData, Trace } from "../trace/types";
import { linesOf, type Line } from "./lines";
import { along, length, sub } from "./vectors";
import { tilesASecond, type ViewState } from "./view-state";

const ARRIVED = 0.75; // of a tile's time: then all its rays are there, and stay until the tile is full
const GLOW_SECONDS = 0.08; // so long the rays of a full tile are still seen
const GLOW_MOST = 48; // tiles

export interface Growing {
  row: number;
  column: number;
  share: number; // of the way that all the tile's rays have to go
}

export function growingOf(state: ViewState): Growing | null {
  if (state.tiles !== "filling") return null;
  const tile = Math.min(Math.floor(state.drawn), state.n * state.n - 1);
  return { row: Math.floor(tile / state.n), column: tile % state.n, share: Math.min(1, (state.drawn - tile) / ARRIVED) };
}

/** Full tiles whose rays still glow: [first, end) in scan order. None while rays are slow enough to be followed. */
export function glowing(state: ViewState): readonly [number, number] {
  const end = Math.floor(state.drawn);
  const count = Math.min(GLOW_MOST, Math.floor(tilesASecond(state) * GLOW_SECONDS));
  return [Math.max(0, end - count), end];
}

/** A pixel's lines when all its rays together have gone `share` of the way: they leave the camera
 *  together, each ray starts where its parent arrives, and all have one speed. */
export function grownLines(trace: Trace, scene: SceneData, pixel: number, share: number): Line[] {
  const lines = linesOf(trace, scene, pixel);
  const arrives = new Map<number, number>(); // way gone from the camera to the end of each ray
  const spans = lines.map((line) => {
    const from = arrives.get(line.light < 0 ? trace.parent[line.ray] : line.ray) ?? 0;
    const to = from + length(sub(line.to, line.from));
    if (line.light < 0) arrives.set(line.ray, to);
    return { line, from, to };
  });
  const gone = share * Math.max(0, ...spans.map(({ to }) => to));
  return spans
    .filter(({ from }) => from < gone)
    .map(({ line, from, to }) => (to <= gone ? line : { ...line, to: along(line.from, line.to, (gone - from) / (to - from)), growing: true }));
}
