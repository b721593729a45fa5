/** The stops of a lesson as one goes through it, and what is seen at each: lines in space, and from where. */
import { picturePlane, type PicturePlane } from "../state/frustum";
import { linesOf, thinPixels, type Line } from "../state/lines";
import { observerOf } from "../state/observer";
import { createProjection, type Projection } from "../state/projection";
import { levelsOf, nearestLevel, stopIn } from "../state/swept";
import type { Observer, ViewState } from "../state/types";
import { goToStep, pixelIndex, setLevel, startState } from "../state/view-state";
import { createWhatIf } from "../state/what-if";
import type { SceneData, Trace } from "../trace/types";
import { closeUp } from "./close-up";

const MOST_THIN = 450; // lines: more hide one another, and make a slide slow to edit
const KEPT = { speed: 1, still: true, gl: true };

export interface Size {
  width: number; // of a figure, points
  height: number;
}

/** What all stops of a lesson share. */
export interface Setting {
  scene: SceneData;
  plane: PicturePlane;
  size: Size;
}

export const settingOf = (scene: SceneData, size: Size): Setting => ({ scene, plane: picturePlane(scene), size });

/** A scene's grids, by n. */
export type Traces = (n: number) => Trace;

/** What is there at a stop of a sweep; "": the scene itself. */
export type Places = (sweep: string) => { scene: SceneData; traces: Traces };

export interface Stop {
  step: number; // of the lesson, from 0
  kind: "step" | "question" | "answer";
  state: ViewState;
}

export function stopsOf(scene: SceneData): Stop[] {
  const start = startState(scene, KEPT);
  return scene.lesson.flatMap(({ answer }, step) => {
    const stop = (kind: Stop["kind"]): Stop => ({ step, kind, state: onGridOfStop(scene, goToStep(scene, start, step, kind === "answer")) });
    return answer ? [stop("question"), stop("answer")] : [stop("step")];
  });
}

/** Stops of a sweep have some of the scene's grids: the nearest is shown, as on the page. */
function onGridOfStop(scene: SceneData, state: ViewState): ViewState {
  const found = stopIn(scene, state.sweep);
  const levels = found && found.stop !== found.sweep.own ? levelsOf(scene, found.sweep.id) : [];
  return levels.length && !levels.includes(state.n) ? setLevel(state, nearestLevel(levels, state.n)) : state;
}

export interface Seen {
  trace: Trace; // with the stop's switches set
  scene: SceneData; // likewise
  observer: Observer;
  projection: Projection;
  chosen: readonly Line[];
  thin: readonly Line[];
  oneIn: number; // of how many pixels the thin lines show one
}

export const whatIf = createWhatIf();
export const walksPixel = ({ rays }: ViewState): boolean => rays.includes("pixel");

export function seenAt(state: ViewState, grid: Trace, { scene: whole, plane, size }: Setting): Seen {
  const { width, height } = size;
  const from = observerOf(state.observer, whole, plane, width / height);
  const observer = typeof state.observer === "string" ? from : closeUp(from, whole, plane, size);
  const { trace, scene } = whatIf.of(grid, whole, state.switches);
  const chosen = walksPixel(state) ? linesOf(trace, scene, pixelIndex(state)) : [];
  return { trace, scene, observer, projection: createProjection(observer, width, height), chosen, ...thinned(trace, scene, thinAround(state)) };
}

/** Pixels whose rays are drawn thin; those of a slice are drawn in space. */
function thinAround(state: ViewState): number[] {
  const rays = state.slice === "none" ? state.rays : [...state.rays, state.slice];
  const chosen = walksPixel(state) ? pixelIndex(state) : -1;
  return thinPixels({ ...state, rays }).filter((pixel) => pixel !== chosen).sort((a, b) => a - b);
}

/** Lines of these pixels; where there are too many those of every k-th row and column. */
function thinned(trace: Trace, scene: SceneData, pixels: readonly number[]): Pick<Seen, "thin" | "oneIn"> {
  const { n } = trace;
  const rows = new Set(pixels.map((pixel) => Math.floor(pixel / n)));
  const columns = new Set(pixels.map((pixel) => pixel % n));
  const isOne = rows.size === 1 || columns.size === 1; // a single row or column keeps its place
  for (let oneIn = 1; oneIn <= n; oneIn++) {
    const isKept = (place: number) => place % oneIn === Math.floor(oneIn / 2);
    const kept = pixels.filter((pixel, k) => (isOne ? isKept(k) : isKept(pixel % n) && isKept(Math.floor(pixel / n))));
    const thin = kept.flatMap((pixel) => linesOf(trace, scene, pixel)).sort((a, b) => a.ray - b.ray);
    if (thin.length <= MOST_THIN) return { thin, oneIn };
  }
  return { thin: [], oneIn: n };
}
