/**
 * A lesson as one goes through it, stop by stop: what slides, sheets and notes show of it. In two turns, as paper needs
 * the tracer twice: what hides a line from the observer, and all digits of the rays whose numbers are printed.
 */
import { tell } from "../event-words";
import { costsOf } from "../state/costs";
import { eventsOf, type RayEvent } from "../state/events";
import { picturePlane, type PicturePlane } from "../state/frustum";
import { linesOf, thinPixels, type Line } from "../state/lines";
import { observerOf, type Observer } from "../state/observer";
import { createProjection, type Projection } from "../state/projection";
import { rayRows, type RayRow } from "../state/ray-rows";
import { isSwitched, lampsOf, type Switches } from "../state/switches";
import { scale, triple, type Vec3 } from "../state/vectors";
import { goToStep, pixelIndex, startState, type ViewState } from "../state/view-state";
import { createWhatIf, switchedScene } from "../state/what-if";
import type { SceneData, Trace } from "../trace/types";
import { hexOf, plain } from "../words";
import { withExact, type ExactRays } from "./exact";
import { Sheet, type ChosenLine, type DrawnLine, type Figure, type Stretches } from "./figure";
import { picksOf, questionOf, type Question } from "./worksheet";

const MOST_THIN = 450; // lines: more hide one another, and make a slide slow to edit
const KEPT = { speed: 1, still: true, gl: true };

export interface Size {
  width: number; // of a figure, points
  height: number;
}

/** Grids of a scene as their files have them. */
export type Traces = (n: number) => Trace;

interface Stop {
  step: number; // of the lesson, from 0
  kind: "step" | "question" | "answer";
  state: ViewState;
}

function stopsOf(scene: SceneData): Stop[] {
  const start = startState(scene, KEPT);
  return scene.lesson.flatMap(({ answer }, step) => {
    const stop = (kind: Stop["kind"]): Stop => ({ step, kind, state: goToStep(scene, start, step, kind === "answer") });
    return answer ? [stop("question"), stop("answer")] : [stop("step")];
  });
}

/** A stop's lines in space, and where they are seen from. */
interface Seen {
  trace: Trace; // with the stop's switches set
  scene: SceneData; // likewise
  observer: Observer;
  view: Projection;
  chosen: readonly Line[];
  thin: readonly Line[];
  oneIn: number; // of how many pixels the thin lines show one
}

const whatIf = createWhatIf();
const hasChosen = ({ rays }: ViewState) => rays.includes("pixel");

function seenAt(state: ViewState, whole: SceneData, plane: PicturePlane, grid: Trace, { width, height }: Size): Seen {
  const observer = observerOf(state.observer, whole, plane, width / height);
  const { trace, scene } = whatIf.of(grid, whole, state.switches);
  const chosen = hasChosen(state) ? linesOf(trace, scene, pixelIndex(state)) : [];
  return { trace, scene, observer, view: createProjection(observer, width, height), chosen, ...thinned(trace, scene, thinAround(state)) };
}

/** Pixels whose rays are drawn thin; those of a slice are drawn in space. */
function thinAround(state: ViewState): number[] {
  const rays = state.slice === "none" ? state.rays : [...state.rays, state.slice];
  const chosen = hasChosen(state) ? pixelIndex(state) : -1;
  return thinPixels({ ...state, rays }).filter((pixel) => pixel !== chosen).sort((a, b) => a - b);
}

/** Lines of these pixels; where there are too many those of every k-th row and column. */
function thinned(trace: Trace, scene: SceneData, pixels: readonly number[]): Pick<Seen, "thin" | "oneIn"> {
  const { n } = trace;
  const isOne = new Set(pixels.map((pixel) => Math.floor(pixel / n))).size === 1 || new Set(pixels.map((pixel) => pixel % n)).size === 1;
  for (let oneIn = 1; oneIn <= n; oneIn++) {
    const middle = Math.floor(oneIn / 2);
    const isKept = (place: number) => place % oneIn === middle;
    // A single row or column keeps its place.
    const kept = pixels.filter((pixel, k) => (isOne ? isKept(k) : isKept(pixel % n) && isKept(Math.floor(pixel / n))));
    const thin = kept.flatMap((pixel) => linesOf(trace, scene, pixel)).sort((a, b) => a.ray - b.ray);
    if (thin.length <= MOST_THIN) return { thin, oneIn };
  }
  return { thin: [], oneIn: n };
}

/** The first grid of a lesson as it was traced, and what of it a worksheet asks. */
function asked(stops: readonly Stop[], traces: Traces) {
  const asTraced = stops.filter(({ state }) => !isSwitched(state.switches));
  if (!asTraced.length) return { n: 0, picks: [] };
  const { n } = asTraced[0].state;
  return { n, picks: picksOf(traces(n), asTraced.filter(({ state }) => state.n === n && hasChosen(state)).map(({ state }) => pixelIndex(state))) };
}

/** One place to look from, and the scene as it is lit. */
export interface Look extends Size {
  eye: Vec3;
  right: Vec3;
  up: Vec3;
  forward: Vec3;
  focal: number;
  lit: Pick<SceneData, "depth" | "shadows"> & { intensities: readonly number[]; paints: readonly (readonly [Vec3, Vec3, Vec3])[] };
}

/** What the tracer is asked for. */
export interface Asked {
  looks: readonly Look[];
  stops: readonly { look: number; lines: readonly (readonly [Vec3, Vec3])[]; tiles: { n: number; origin: Vec3; across: Vec3; down: Vec3 } }[];
  exact: readonly { n: number; pixels: readonly number[] }[];
}

const isPaint = (part: string) => part === "ambient" || part === "diffuse" || part === "specular";

function lookOf({ observer, view }: Seen, whole: SceneData, switches: Switches): Look {
  const { right, up, forward, focal, width, height } = view;
  // Which rays are sent on stays: the view is pale, and mirrors are to be known as such.
  const { depth, shadows, lights, materials } = switchedScene(whole, { ...switches, without: switches.without.filter(isPaint) });
  const lit = { depth, shadows, intensities: lights.map(({ intensity }) => intensity), paints: materials.map(({ ambient, diffuse, specular }) => [ambient, diffuse, specular] as const) };
  return { eye: observer.eye, right, up, forward, focal, width, height, lit };
}

export function ask(scene: SceneData, traces: Traces, size: Size): Asked {
  const plane = picturePlane(scene);
  const stops = stopsOf(scene);
  const looks: string[] = [];
  const wanted = new Map<number, Set<number>>();
  const want = (n: number, pixel: number) => wanted.set(n, (wanted.get(n) ?? new Set()).add(pixel));
  const questions = asked(stops, traces);
  for (const { pixel } of questions.picks) want(questions.n, pixel);
  const lines = stops.map(({ state }) => {
    const seen = seenAt(state, scene, plane, traces(state.n), size);
    const look = JSON.stringify(lookOf(seen, scene, state.switches));
    if (!looks.includes(look)) looks.push(look);
    if (hasChosen(state)) want(state.n, pixelIndex(state));
    const { origin, across, down } = plane;
    return { look: looks.indexOf(look), lines: [...seen.chosen, ...seen.thin].map(({ from, to }) => [from, to] as const), tiles: { n: state.n, origin, across, down } };
  });
  const exact = [...wanted].map(([n, pixels]) => ({ n, pixels: [...pixels].sort((a, b) => a - b) }));
  return { looks: looks.map((look) => JSON.parse(look)), stops: lines, exact };
}

/** What the tracer answered. */
export interface Sights {
  stops: readonly { hidden: readonly Stretches[]; tiles: readonly number[] }[]; // of each line; tiles that are hidden
  exact: readonly ExactRays[];
}

/** A row of the card, and what a sum shows of it. */
type Row = Pick<RayRow, "number" | "kind" | "object" | "point" | "t" | "share" | "keeps" | "colour"> & {
  own: Vec3; // what the ray adds by itself, before its share
  gives: Vec3; // with it: what it adds to the pixel
  shows: string; // its colour, #rrggbb
  showsGiven: string;
};

export interface ToldStop {
  step: number;
  kind: Stop["kind"];
  look: number;
  n: number;
  pixel: readonly [number, number];
  filled: boolean;
  observer: Observer;
  isCamera: boolean; // the observer is the ray-tracing camera
  colours: ViewState["colours"];
  switches: { bounces: number | null; lamps: readonly (readonly [string, number])[]; shadows: boolean; without: readonly string[] };
  isSwitched: boolean;
  oneIn: number;
  figure: Figure;
  chosen: readonly ChosenLine[];
  thin: readonly DrawnLine[];
  tiles: string | null; // base64 of what filled tiles show, 8-bit; null if empty
  hiddenTiles: readonly number[];
  picture: { n: number; tiles: string } | null; // the finest grid with the switches set
  bytes: Vec3; // the selected tile's colour
  rows: readonly Row[]; // of the selected pixel; none where it is not walked
  events: readonly (Worded & { what: RayEvent["what"]; ray: number })[];
}

export interface ToldLesson {
  stops: readonly ToldStop[];
  questions: readonly Question[];
}

/** An event as it is told. */
interface Worded {
  says: string;
  phrases: readonly (readonly [string, string | null])[]; // null: plain, "": bold, else a kind of ray
  numbers: string;
}

function worded(event: RayEvent): Worded {
  const { says, numbers } = tell(event);
  return { says: plain(says), phrases: says.map((phrase) => (typeof phrase === "string" ? [phrase, null] : phrase)), numbers };
}

const base64 = (bytes: Uint8Array) => btoa(bytes.reduce((text, byte) => text + String.fromCharCode(byte), ""));

function rowOf({ number, kind, object, point, t, share, keeps, colour, own: surface }: RayRow): Row {
  const own = object ? scale(surface, keeps) : surface;
  const gives = scale(own, share);
  return { number, kind, object, point, t, share, keeps, colour, own, gives, shows: hexOf(colour), showsGiven: hexOf(gives) };
}

function toldStop({ step, kind, state }: Stop, scene: SceneData, plane: PicturePlane, traces: Traces, exact: Traces, size: Size, looks: Asked["stops"][number], sights: Sights["stops"][number]): ToldStop {
  const { n, pixel, switches, colours } = state;
  const seen = seenAt(state, scene, plane, exact(n), size);
  const index = pixelIndex(state);
  const rows = hasChosen(state) ? rayRows(seen.trace, seen.scene, index) : [];
  const numbers = new Map(rows.map(({ ray, number }) => [ray, number]));
  const events = kind === "question" || !rows.length ? [] : eventsOf(seen.trace, seen.scene, index);
  const sheet = new Sheet(scene, seen.view, seen.observer.eye);
  const finest = Math.max(...scene.levels);
  return {
    step, kind, look: looks.look, n, pixel, colours, observer: seen.observer, oneIn: seen.oneIn,
    filled: state.tiles === "filled",
    isCamera: state.observer === "camera",
    switches: { ...switches, lamps: lampsOf(scene).flatMap(({ name }, k) => ((switches.lamps[k] ?? 1) === 1 ? [] : [[name, switches.lamps[k]] as const])) },
    isSwitched: isSwitched(switches),
    figure: sheet.figure(plane, n, switches),
    chosen: seen.chosen.map((line, k) => sheet.chosen(line, sights.hidden[k], seen.trace, numbers.get(line.ray)!)),
    thin: seen.thin.map((line, k) => sheet.drawn(line, sights.hidden[seen.chosen.length + k])),
    tiles: state.tiles === "filled" ? base64(costsOf(seen.trace, colours).colours) : null,
    hiddenTiles: sights.tiles,
    picture: isSwitched(switches) ? { n: finest, tiles: base64(whatIf.of(traces(finest), scene, switches).trace.tiles) } : null,
    bytes: triple(seen.trace.tiles, index),
    rows: rows.map(rowOf),
    events: events.map((event) => ({ what: event.what, ray: numbers.get(event.ray)!, ...worded(event) })),
  };
}

/** scene: in the language that is spoken. */
export function tellLesson(scene: SceneData, traces: Traces, size: Size, looks: Asked, sights: Sights): ToldLesson {
  const plane = picturePlane(scene);
  const stops = stopsOf(scene);
  const laid = new Map(sights.exact.map((rays) => [rays.n, withExact(traces(rays.n), scene, rays)]));
  const exact = (n: number) => laid.get(n) ?? traces(n);
  const { n, picks } = asked(stops, traces);
  return {
    stops: stops.map((stop, k) => toldStop(stop, scene, plane, traces, exact, size, looks.stops[k], sights.stops[k])),
    questions: picks.map((pick) => questionOf(pick, exact(n), scene)),
  };
}

/** A pixel's events in words, as `raywalk inspect --events --json` lists them. */
export function tellEvents(scene: SceneData, trace: Trace, [column, row]: readonly [number, number]) {
  if (column >= trace.n || row >= trace.n) throw new Error(`pixel ${column},${row} is outside of 0..${trace.n - 1}`);
  return eventsOf(trace, scene, row * trace.n + column).map((event) => {
    const { what, ray, light, line, long, ...facts } = event;
    return { what, ray, light, line, long, facts, ...worded(event) };
  });
}
