/** The ways in which what is on the page changes: each makes the next state out of this one. */
import type { LessonStop, SceneData, Trace, View } from "../trace/types";
import { NO_EVENT } from "./play";
import type { TileView } from "./tile-views";
import { AS_TRACED, switchesFrom, type Switches } from "./switches";
import type { Kept, ViewState } from "./types";
import { triple } from "./vectors";

export type { ViewState };
export type RayChoice = ViewState["rays"][number];
export const RAY_CHOICES: readonly RayChoice[] = ["pixel", "row", "column", "all"];
export const SPEEDS: readonly number[] = [0.25, 0.5, 1, 2, 4, 8];

const FILL_SECONDS = 3; // a whole picture at speed 1, whatever the resolution

const middle = (pixel: readonly [number, number], n: number): readonly [number, number] => [
  (pixel[0] + 0.5) / n,
  (pixel[1] + 0.5) / n,
];

export function startState(scene: SceneData, kept: Kept): ViewState {
  const { resolution, pixel } = scene.start;
  return {
    ...kept,
    projector: kept.projector ?? false,
    tab: kept.tab ?? "none",
    scene: scene.id,
    n: resolution,
    pixel,
    place: middle(pixel, resolution),
    rays: ["pixel"],
    tiles: "empty",
    drawn: 0,
    observer: "start",
    look: "approximate",
    wipe: 0,
    before: null,
    slice: "none",
    step: null,
    revealed: false,
    ...NO_EVENT,
    switches: AS_TRACED,
    colours: "picture",
    sweep: "",
  };
}

export function select(state: ViewState, column: number, row: number): ViewState {
  const wrap = (k: number) => ((k % state.n) + state.n) % state.n;
  const pixel = [wrap(column), wrap(row)] as const;
  const isSame = pixel.join() === state.pixel.join();
  return { ...state, pixel, place: middle(pixel, state.n), ...(isSame ? {} : NO_EVENT) };
}

export const move = (state: ViewState, right: number, down: number): ViewState =>
  select(state, state.pixel[0] + right, state.pixel[1] + down);

export function setLevel(state: ViewState, n: number): ViewState {
  if (n === state.n) return state;
  const at = (share: number) => Math.min(n - 1, Math.floor(share * n));
  const tiles = state.tiles === "filling" ? "filled" : state.tiles;
  return { ...state, n, pixel: [at(state.place[0]), at(state.place[1])], tiles, ...NO_EVENT };
}

/** The neighbouring frustum resolution; the same state at either end. */
export function stepLevel(state: ViewState, scene: SceneData, by: 1 | -1): ViewState {
  return setLevel(state, scene.levels[scene.levels.indexOf(state.n) + by] ?? state.n);
}

export function toggleRays(state: ViewState, choice: RayChoice): ViewState {
  const on = new Set(state.rays);
  if (!on.delete(choice)) on.add(choice);
  return { ...state, rays: RAY_CHOICES.filter((each) => on.has(each)) };
}

/** Space: start filling; while filling, to the end; when full, empty again. */
export function pressRender(state: ViewState): ViewState {
  if (state.tiles === "empty") return { ...state, tiles: state.still ? "filled" : "filling", drawn: 0, playing: false };
  return { ...state, tiles: state.tiles === "filling" ? "filled" : "empty", drawn: 0 };
}

export const tilesASecond = ({ n, speed }: Pick<ViewState, "n" | "speed">): number => (speed * n * n) / FILL_SECONDS;

/** seconds: time that has passed. */
export function advance(state: ViewState, seconds: number): ViewState {
  if (state.tiles !== "filling") return state;
  const total = state.n * state.n;
  const drawn = state.drawn + seconds * tilesASecond(state);
  return drawn >= total ? { ...state, tiles: "filled", drawn: 0 } : { ...state, drawn };
}

/** Tiles that show their colour, in scan order from the top left. */
export const tilesShown = ({ tiles, drawn, n }: ViewState): number =>
  tiles === "filled" ? n * n : tiles === "empty" ? 0 : Math.floor(drawn);

export type Slice = ViewState["slice"];
export const SLICES: readonly Slice[] = ["none", "row", "column"];
export const nextSlice = (slice: Slice): Slice => SLICES[(SLICES.indexOf(slice) + 1) % SLICES.length];

export const nextSpeed = (speed: number): number => SPEEDS[(SPEEDS.indexOf(speed) + 1) % SPEEDS.length];

/** A lesson step's or an address's view; what it does not name is as at the scene's start. */
export function applyView(scene: SceneData, state: ViewState, view: View): ViewState {
  const start = startState(scene, state);
  const n = view.resolution ?? start.n;
  const from = view.pixel ? select({ ...start, n }, ...view.pixel) : setLevel(start, n);
  return {
    ...from,
    n,
    rays: view.rays ?? start.rays,
    tiles: view.tiles ?? start.tiles,
    observer: view.look === "traced" ? "camera" : (view.observer ?? start.observer), // the picture's only place
    look: view.look ?? start.look,
    before: view.look === "traced" ? (view.observer ?? start.observer) : null,
    slice: view.slice ?? start.slice,
    switches: switchesFrom(view.switches, scene),
    colours: view.colours ?? start.colours,
    sweep: view.sweep ?? "",
    step: state.step,
    revealed: state.revealed,
  };
}

/** Of the lesson: a step, or its answer where that is revealed. */
export const stopOf = ({ lesson }: SceneData, { step, revealed }: Pick<ViewState, "step" | "revealed">): LessonStop | undefined => (step === null ? undefined : (revealed && lesson[step]?.answer) || lesson[step]);

/** Are the boxes that the selected ray tested to be drawn? */
export const wantsBoxes = (state: ViewState, scene: SceneData): boolean => state.colours === "tests" || !!stopOf(scene, state)?.view.boxes;

/** revealed: with the step's answer, if it has one. */
export function goToStep(scene: SceneData, state: ViewState, step: number | null, revealed = false): ViewState {
  const stop = stopOf(scene, { step, revealed });
  if (!stop) return { ...state, step: null, revealed: false };
  return applyView(scene, { ...state, step, revealed: stop !== scene.lesson[step!] }, stop.view);
}

/** The lesson's next or previous stop, steps and answers alike; the same state at either end. */
export function turnStep(scene: SceneData, state: ViewState, by: 1 | -1): ViewState {
  const { step, revealed } = state;
  if (step === null) return state;
  if (by > 0 ? scene.lesson[step].answer && !revealed : revealed) return goToStep(scene, state, step, by > 0);
  return scene.lesson[step + by] ? goToStep(scene, state, step + by, by < 0) : state;
}

/** Does the step ask something that is still to be predicted? */
export const isAsking = ({ step, revealed }: ViewState, scene: SceneData): boolean => step !== null && !revealed && !!scene.lesson[step]?.answer;

export const pixelIndex = ({ pixel, n }: Pick<ViewState, "pixel" | "n">): number => pixel[1] * n + pixel[0];

/** What switches and other colours do is seen on the tiles: empty ones are filled. */
const seen = (state: ViewState): ViewState => (state.tiles === "empty" ? { ...state, tiles: "filled" } : state);

export const setSwitches = (state: ViewState, switches: Switches): ViewState =>
  switches === state.switches ? state : seen({ ...state, switches });

export const setColours = (state: ViewState, colours: TileView): ViewState =>
  colours === state.colours ? state : seen({ ...state, colours });

/** 8-bit colour of a tile as the picture has it. */
export const tileColour = (trace: Trace, pixel: number) => triple(trace.tiles, pixel);
