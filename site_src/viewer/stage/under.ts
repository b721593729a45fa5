/** What lies under a place on the stage: a tile, a line. Places in CSS pixels. */
import type { LitLine } from "../state/types";
import type { Drawn } from "./renderer";

const NEAR_A_LINE = 9; // pixels

export type Tile = readonly [number, number]; // column, row

/** The tile there, or where it would be if the picture plane went on; null behind the observer. */
function cellUnder({ view, projection }: Drawn, x: number, y: number): Tile | null {
  const share = projection.onPicturePlane(view.plane, x, y);
  return share && [Math.floor(share[0] * view.state.n), Math.floor(share[1] * view.state.n)];
}

export function tileUnder(now: Drawn, x: number, y: number): Tile | null {
  const tile = cellUnder(now, x, y);
  return tile?.every((k) => k >= 0 && k < now.view.state.n) ? tile : null;
}

/** Of a hand that has gone over the edge. */
export function nearestTile(now: Drawn, x: number, y: number): Tile | null {
  const within = (k: number) => Math.max(0, Math.min(now.view.state.n - 1, k));
  const tile = cellUnder(now, x, y);
  return tile && [within(tile[0]), within(tile[1])];
}

/** The selected pixel's line nearest to the place, measured on the screen. */
export function lineUnder({ view, projection }: Drawn, x: number, y: number): LitLine | null {
  let nearest = NEAR_A_LINE;
  let found: LitLine | null = null;
  for (const line of view.chosen) {
    const [a, b] = [projection.project(line.from), projection.project(line.to)];
    if (a.depth <= 0 || b.depth <= 0) continue;
    const [dx, dy] = [b.x - a.x, b.y - a.y];
    const share = Math.max(0, Math.min(1, ((x - a.x) * dx + (y - a.y) * dy) / (dx * dx + dy * dy || 1)));
    const away = Math.hypot(a.x + share * dx - x, a.y + share * dy - y);
    if (away < nearest) [nearest, found] = [away, { ray: line.ray, light: line.light }];
  }
  return found;
}
