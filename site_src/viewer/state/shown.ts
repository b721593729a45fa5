/** What a state shows of its trace: lines, tiles, kinds. Remembered until what it depends on changes. */
import type { SceneData, Trace } from "../trace/types";
import { picturePlane, type PicturePlane } from "./frustum";
import { linesOf, thinPixels, type Line, type LineKind } from "./lines";
import { pixelIndex, tileColour, tilesShown, type ViewState } from "./view-state";

export interface Shown {
  plane: PicturePlane;
  tiles: number; // filled, in scan order
  chosen: readonly Line[]; // drawn thick: of the selected pixel, or of the tile being rendered
  thin: readonly Line[];
  kinds: ReadonlySet<LineKind>;
  ringOn: readonly [number, number, number] | null; // colour the selected tile shows; null while it is empty
}

const CROWD = 20000; // lines: more take seconds without a graphics card, and hide one another

/** All lines, or without the shadow rays where there are too many to see any. */
const withoutCrowd = (lines: Line[]): Line[] => (lines.length > CROWD ? lines.filter((line) => line.light < 0) : lines);

/** Remembers the last value; makes it anew when one of the things it was made from is another. */
function lastly<T>() {
  let from: readonly unknown[] = [];
  let value: T;
  return (needs: readonly unknown[], make: () => T): T => {
    if (needs.length !== from.length || needs.some((need, k) => need !== from[k])) {
      value = make();
      from = needs;
    }
    return value;
  };
}

export function createShown() {
  const plane = lastly<PicturePlane>();
  const chosen = lastly<readonly Line[]>();
  const thin = lastly<readonly Line[]>();
  const kinds = lastly<ReadonlySet<LineKind>>();
  return {
    of(state: ViewState, scene: SceneData, trace: Trace | null): Shown {
      const index = pixelIndex(state);
      const tiles = tilesShown(state);
      const filling = state.tiles === "filling";
      const thick = filling ? Math.min(tiles, state.n * state.n - 1) : state.rays.includes("pixel") ? index : -1;
      const rays = filling ? "" : state.rays.join();
      const across = rays.includes("row") ? state.pixel[1] : -1;
      const downwards = rays.includes("column") ? state.pixel[0] : -1;
      const isAll = rays.includes("all");
      const needs = isAll ? [scene, trace, "all"] : [scene, trace, across, downwards];
      const thickLines = chosen([scene, trace, thick], () => (trace && thick >= 0 ? linesOf(trace, scene, thick) : []));
      const thinLines = thin(needs, () => (trace && !filling ? withoutCrowd(thinPixels(state).flatMap((pixel) => linesOf(trace, scene, pixel))) : []));
      return {
        plane: plane([scene], () => picturePlane(scene)),
        tiles,
        chosen: thickLines,
        thin: thinLines,
        kinds: kinds([thickLines, thinLines], () => new Set([...thickLines, ...thinLines].map((line) => line.kind))),
        ringOn: trace && index < tiles ? tileColour(trace, index) : null,
      };
    },
  };
}
