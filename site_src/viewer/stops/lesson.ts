/** A lesson's stops as slides, sheets and notes show them: words, numbers, figures. slides/stops.py reads it. */
import { costsOf } from "../state/costs";
import type { RayEvent } from "../state/event-types";
import { eventsOf } from "../state/events";
import { rayRows, type RayRow } from "../state/ray-rows";
import { brightness, isSwitched, lampsOf, type Switches } from "../state/switches";
import type { Observer, ViewState } from "../state/types";
import { scale, triple, type Vec3 } from "../state/vectors";
import { levelsOf, someOfRow, stopIn } from "../state/swept";
import { pixelIndex, stopOf } from "../state/view-state";
import { shortValueAt, sweepName, valueAt } from "../sweep-words";
import type { SceneData } from "../trace/types";
import { hexOf, say } from "../words";
import { placeOf, type Asked } from "./asked";
import { boxesAt, type Drawable } from "./boxes";
import { withExact, type ExactRays } from "./exact";
import { Sheet, type ChosenLine, type DrawnLine, type Figure, type Stretches } from "./figure";
import { seenAt, settingOf, stopsOf, walksPixel, whatIf, type Seen, type Setting, type Size, type Places, type Stop, type Traces } from "./seen";
import { worded, type Worded } from "./worded";

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

const MOST_IN_STRIP = 5; // pictures side by side

/** Some stops of the sweep at which a step is: each as the finest grid shows it, with the step's switches. */
export interface Strip {
  name: string;
  pictures: readonly { value: string; isHere: boolean; n: number; tiles: string }[];
}

export interface LessonStop {
  step: number;
  kind: Stop["kind"];
  viewpoint: number; // of those asked for
  n: number;
  pixel: readonly [number, number];
  filled: boolean;
  observer: Observer;
  isCamera: boolean; // the observer looks through the ray-tracing camera
  isElsewhere: boolean; // it asks for the approximate look, of which paper shows the traced scene instead
  colours: ViewState["colours"];
  switches: Omit<Switches, "lamps"> & { lamps: readonly (readonly [string, number])[] }; // those that are not as traced
  isSwitched: boolean;
  moved?: string; // at which stop of a sweep the scene is shown, in words
  strip?: Strip; // of that sweep, where nothing is asked
  oneIn: number;
  figure: Figure;
  chosen: readonly ChosenLine[];
  thin: readonly DrawnLine[];
  tiles: string | null; // base64 of what filled tiles show, 8-bit; null if empty
  hiddenTiles: readonly number[];
  picture: { n: number; tiles: string } | null; // the finest grid with the switches set
  bytes: Vec3; // the selected tile's colour
  rows: readonly Row[]; // of the selected pixel; none where it is not walked
  events: readonly (Worded & { what: RayEvent["what"]; ray: number; light: number })[]; // none where a question would be answered
}

export interface Lesson {
  stops: readonly LessonStop[];
}

const base64 = (bytes: Uint8Array) => btoa(bytes.reduce((text, byte) => text + String.fromCharCode(byte), ""));

function rowOf({ number, kind, object, point, t, share, keeps, colour, local }: RayRow): Row {
  const own = object ? scale(local, keeps) : local;
  const gives = scale(own, share);
  return { number, kind, object, point, t, share, keeps, colour, own, gives, shows: hexOf(colour), showsGiven: hexOf(gives) };
}

/** The selected pixel's rays and events, where they are walked. */
function walk({ kind, state }: Stop, { trace, scene }: Seen): Pick<LessonStop, "rows" | "events"> & { numbers: ReadonlyMap<number, number> } {
  const index = pixelIndex(state);
  const rows = walksPixel(state) ? rayRows(trace, scene, index) : [];
  const numbers = new Map(rows.map(({ ray, number }) => [ray, number]));
  const events = kind === "question" || !rows.length ? [] : eventsOf(trace, scene, index);
  return { numbers, rows: rows.map(rowOf), events: events.map((event) => ({ what: event.what, ray: numbers.get(event.ray)!, light: event.light, ...worded(event) })) };
}

/** The shaded view behind a stop. */
interface Behind {
  viewpoint: number; // of those asked for
  isRasterised: boolean;
}

/** What a sweep has moved, and where to. */
function movedIn(scene: SceneData, text: string): string {
  const { sweep, stop } = stopIn(scene, text)!;
  return say("sweep.at", { name: sweepName(scene, sweep.id), value: valueAt(sweep, stop) });
}

function stripOf({ kind, state }: Stop, places: Places): Strip | null {
  const scene = places("").scene;
  const found = kind === "question" ? null : stopIn(scene, state.sweep);
  if (!found) return null;
  const { sweep, stop } = found;
  const pictures = someOfRow(sweep, stop, MOST_IN_STRIP).map((k) => {
    const there = places(`${sweep.id}:${k}`);
    const n = Math.max(...levelsOf(scene, sweep.id));
    return { value: shortValueAt(sweep, k), isHere: k === stop, n, tiles: base64(whatIf.of(there.traces(n), there.scene, state.switches).trace.tiles) };
  });
  return { name: sweepName(scene, sweep.id), pictures };
}

function lessonStop(stop: Stop, setting: Setting, [filed, exact]: readonly [Traces, Traces], { viewpoint, isRasterised }: Behind, sights: Sights["stops"][number], drawable: Drawable): LessonStop {
  const { step, kind, state } = stop;
  const { n, pixel, switches, colours } = state;
  const { scene } = setting;
  const seen = seenAt(state, exact(n), setting);
  const { numbers, ...walked } = walk(stop, seen);
  const sheet = new Sheet(scene, seen.projection, seen.observer.eye);
  const lamps = lampsOf(scene).map(({ name }, lamp) => [name, brightness(switches, lamp)] as const);
  const finest = Math.max(...scene.levels);
  const { view } = stopOf(scene, state)!;
  return {
    step, kind, viewpoint, n, pixel, colours, observer: seen.observer, oneIn: seen.oneIn, ...walked,
    filled: state.tiles === "filled",
    isCamera: state.observer === "camera",
    isElsewhere: view.look === "approximate" && !isRasterised,
    switches: { ...switches, lamps: lamps.filter(([, factor]) => factor !== 1) },
    isSwitched: isSwitched(switches),
    ...(state.sweep && { moved: movedIn(scene, state.sweep) }),
    figure: sheet.figure(setting.plane, n, switches, view, kind === "question" ? [] : boxesAt(state, scene, view, drawable)),
    chosen: seen.chosen.map((line, k) => sheet.chosen(line, sights.hidden[k], seen.trace, numbers.get(line.ray)!)),
    thin: seen.thin.map((line, k) => sheet.drawn(line, sights.hidden[seen.chosen.length + k])),
    tiles: state.tiles === "filled" ? base64(costsOf(seen.trace, seen.scene, colours).colours) : null,
    hiddenTiles: sights.tiles,
    picture: isSwitched(switches) || state.sweep ? { n: finest, tiles: base64(whatIf.of(filed(finest), scene, switches).trace.tiles) } : null,
    bytes: triple(seen.trace.tiles, pixelIndex(state)),
  };
}

/** places: scenes in the language that is spoken, grids as their files have them. */
export function lessonOf(places: Places, size: Size, asked: Asked, sights: Sights, drawable: Drawable): Lesson {
  const laid = new Map(
    sights.exact.map((rays) => {
      const { scene, traces } = places(rays.sweep ?? "");
      return [placeOf(rays), withExact(traces(rays.n), scene, rays)];
    }),
  );
  const behind = asked.stops.map(({ viewpoint }): Behind => ({ viewpoint, isRasterised: "maps" in asked.viewpoints[viewpoint] }));
  return {
    stops: stopsOf(places("").scene).map((stop, k) => {
      const { sweep } = stop.state;
      const { scene, traces } = places(sweep);
      const exact = (n: number) => laid.get(placeOf({ n, sweep })) ?? traces(n);
      const strip = stripOf(stop, places);
      return { ...lessonStop(stop, settingOf(scene, size), [traces, exact], behind[k], sights.stops[k], drawable), ...(strip && { strip }) };
    }),
  };
}
