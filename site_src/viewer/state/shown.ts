/** What a state shows of its trace: lines, tiles, kinds. Remembered until what it depends on changes. */
import type { LineKind } from "../trace/kinds";
import type { SceneData, Trace } from "../trace/types";
import { picturePlane, type PicturePlane } from "./frustum";
import type { RayBoxes } from "../trace/boxes";
import type { Boxes, BoxLines } from "./box-lines";
import { glowing, grownLines, growingOf, type Growing } from "./growth";
import { memo } from "./memo";
import { kindsIn, linesOf, thinPixels, type Line } from "./lines";
import { plainly, type Costs, type CostsOf } from "./tile-views";
import { grownShare, linesUpTo, timelineOf, type Timeline } from "./timeline";
import { triple } from "./vectors";
import { pixelIndex, tilesShown, wantsBoxes, type ViewState } from "./view-state";

export interface Shown {
  plane: PicturePlane;
  tiles: number; // filled, in scan order
  chosen: readonly Line[]; // drawn thick: of the selected pixel, or of the tile being rendered
  thin: readonly Line[];
  left: number; // shadow rays that are not drawn because there are too many lines
  kinds: Kinds; // while lines grow: also of those to come, or the legend would flicker
  ringOn: readonly [number, number, number] | null; // colour the selected tile shows; null while it is empty
  growing: Growing | null; // the tile being rendered
  timeline: Timeline | null; // the selected pixel's events; null without a trace
  grown: number; // share of the current event's line
  costs: Costs | null; // what the tiles show; null without a trace
  boxes: RayBoxes | null; // that the selected camera ray tested, while the tiles show tests
  boxLines: BoxLines;
}

export const CROWD = 20000; // lines: more take seconds without a graphics card, and hide one another

interface Lines {
  lines: readonly Line[];
  left: number;
}

/** All lines, or without the shadow rays where there are too many to see any. */
export function withoutCrowd(all: readonly Line[]): Lines {
  const lines = all.length > CROWD ? all.filter((line) => line.light < 0) : all;
  return { lines, left: all.length - lines.length };
}

/** What lines are made from: switches that only dim or recolour leave them as they are. */
const linesFrom = (trace: Trace | null): unknown[] => (trace ? [trace.point, trace.pixel, trace.visibility] : [null]);

const range = (from: number, to: number) => Array.from({ length: to - from }, (_, k) => from + k);

const NO_BOXES: BoxLines = { entered: [], missed: [] };

/** Each remembers, so that a row's lines are not made anew for every frame. */
type Memo<T> = ReturnType<typeof memo<T>>;

function thinLines(thin: Memo<Lines>, state: ViewState, scene: SceneData, trace: Trace | null): Lines {
  const of = (pixels: readonly number[]) => (trace ? withoutCrowd(pixels.flatMap((pixel) => linesOf(trace, scene, pixel))) : withoutCrowd([]));
  if (state.tiles === "filling") {
    const [first, end] = glowing(state);
    return thin([...linesFrom(trace), "glow", first, end], () => of(range(first, end)));
  }
  const across = state.rays.includes("row") ? state.pixel[1] : -1;
  const downwards = state.rays.includes("column") ? state.pixel[0] : -1;
  const needs = state.rays.includes("all") ? [...linesFrom(trace), "all"] : [...linesFrom(trace), across, downwards];
  return thin(needs, () => of(thinPixels(state)));
}

function chosenLines(chosen: Memo<readonly Line[]>, state: ViewState, scene: SceneData, trace: Trace | null, timeline: Timeline | null): readonly Line[] {
  const index = pixelIndex(state);
  const growing = growingOf(state);
  if (!trace) return chosen([trace], () => []);
  if (growing) return chosen([...linesFrom(trace), state.drawn], () => grownLines(trace, scene, growing.row * state.n + growing.column, growing.share));
  const { event, share } = state;
  if (timeline && event !== null && event < timeline.events.length) return chosen([timeline, event, grownShare(timeline, event, share)], () => linesUpTo(timeline, trace, scene, index, event, share));
  const pixel = state.rays.includes("pixel") ? index : -1;
  return chosen([...linesFrom(trace), pixel], () => (pixel < 0 ? [] : linesOf(trace, scene, pixel)));
}

type Kinds = ReadonlySet<LineKind>;
function kindsOf(kinds: Memo<Kinds>, state: ViewState, scene: SceneData, trace: Trace | null, thick: readonly Line[], thin: readonly Line[]): Kinds {
  if (trace && state.tiles === "filling") return kinds(linesFrom(trace), () => kindsIn(trace));
  const isAtEvent = trace && state.event !== null;
  const index = pixelIndex(state);
  const needs = isAtEvent ? [...linesFrom(trace), index, thin] : [thick, thin];
  return kinds(needs, () => new Set([...(isAtEvent ? linesOf(trace, scene, index) : thick), ...thin].map((line) => line.kind)));
}

/** costing: what works out other things that tiles show than the picture; null until its script is there. */
export function createShown(costing: () => CostsOf | null) {
  const plane = memo<PicturePlane>();
  const chosen = memo<readonly Line[]>();
  const thin = memo<Lines>();
  const kinds = memo<Kinds>();
  const timelines = memo<Timeline | null>();
  const costs = memo<Costs | null>();
  const tested = memo<ReturnType<Boxes["of"]> | null>();

  return {
    of(state: ViewState, scene: SceneData, trace: Trace | null, boxesOfScene: Boxes | null = null): Shown {
      const index = pixelIndex(state);
      const tiles = tilesShown(state);
      const timeline = timelines([scene, trace, index], () => trace && timelineOf(trace, scene, index));
      const thick = chosenLines(chosen, state, scene, trace, timeline);
      const costsOf = state.colours === "picture" ? null : costing();
      const colours = costs([trace, scene, costsOf && state.colours], () => trace && (costsOf ? costsOf(trace, scene, state.colours) : plainly("picture", trace.tiles)));
      const boxes = trace && wantsBoxes(state, scene) && boxesOfScene?.scene === (scene.bodies ?? scene.of) ? boxesOfScene : null;
      const rayBoxes = tested([boxes, state.n, index], () => boxes && boxes.of(state.n, index));
      const { lines, left } = thinLines(thin, state, scene, trace);
      return {
        plane: plane([scene], () => picturePlane(scene)),
        tiles,
        chosen: thick,
        thin: lines,
        left,
        kinds: kindsOf(kinds, state, scene, trace, thick, lines),
        ringOn: colours && index < tiles ? triple(colours.colours, index) : null,
        growing: growingOf(state),
        timeline,
        grown: timeline && state.event !== null && state.event < timeline.events.length ? grownShare(timeline, state.event, state.share) : 1,
        costs: colours,
        boxes: rayBoxes,
        boxLines: rayBoxes?.lines ?? NO_BOXES,
      };
    },
  };
}
