/** What a tile can show, in the order of the menu: its colour, at once; the rest is worked out by costs.ts, which comes when asked for. */
import type { SceneData, Trace, View } from "../trace/types";

export type TileView = NonNullable<View["colours"]>;

export interface Costs {
  view: TileView;
  colours: Uint8Array; // (3 * n * n)
  values: Float64Array | null; // (n * n), NaN where a tile has none; null where colours say all
  least: number;
  most: number;
}

export const TILE_VIEWS = Object.keys({ picture: 0, rays: 0, depth: 0, tests: 0, distance: 0, shadow: 0, normal: 0 } satisfies Record<TileView, 0>) as TileView[];

/** Colours that say all. */
export const plainly = (view: TileView, colours: Uint8Array): Costs => ({ view, colours, values: null, least: 0, most: 0 });

export type CostsOf = (trace: Trace, scene: SceneData, view: TileView) => Costs;
