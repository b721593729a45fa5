/** The view in the address: #n=15&p=7,9&rays=pixel,row&tiles=filled&cam=...  What is as at the scene's start is
 *  left out; in a lesson, what is as its step shows it: #step=3 is the whole of an untouched step. */
import type { SceneData, View } from "../trace/types";
import { applyView, goToStep, RAY_CHOICES, SLICES, SPEEDS, startState, stopOf, type RayChoice } from "./view-state";
import { TABS, type Kept, type ViewState } from "./types";
import { ADDRESS_KEYS } from "./address-keys";
import { LOOKS } from "./look";
import { AS_TRACED, readSwitches, writeSwitches } from "./switches";
import { TILE_VIEWS } from "./tile-views";
import { length, sub, type Vec3 } from "./vectors";

const FARTHEST = 50; // radii of the scene from its centre, for eye and target
const NEAREST = 1e-6;
const MOST_EVENTS = 1e6;

/** Six numbers, eye then target; enough digits that the same view comes back. */
const writeObserver = (observer: ViewState["observer"]) =>
  typeof observer === "string" ? observer : [...observer.eye, ...observer.target].map((v) => String(Number(v.toPrecision(5)))).join(",");

/** withScene: from file:// the page stays, so the scene goes into the address too. */
export function writeAddress(state: ViewState, scene: SceneData, withScene: boolean): string {
  const start = goToStep(scene, startState(scene, state), state.step, state.revealed);
  const parts: string[] = [];
  const put = (key: string, value: string | number) => parts.push(`${key}=${value}`);
  const putOther = (key: string, of: (state: ViewState) => string | number) => of(state) !== of(start) && put(key, of(state));
  const putField = (key: "n" | "look" | "slice" | "colours" | "sweep") => putOther(key, (of) => of[key]);
  if (withScene) put("scene", state.scene);
  putField("n");
  if (state.pixel.join() !== start.pixel.join() || state.n !== start.n) put("p", state.pixel.join());
  putOther("rays", ({ rays }) => rays.join() || "none");
  putOther("tiles", ({ tiles }) => (tiles === "empty" ? tiles : "filled"));
  putOther("cam", ({ before, observer }) => writeObserver(before ?? observer)); // the traced look has one place only
  putField("look");
  if (state.wipe) put("wipe", state.wipe);
  putField("slice");
  putOther("if", ({ switches }) => writeSwitches(switches) || "none");
  putField("colours");
  putField("sweep");
  if (state.step !== null) put("step", state.step + 1);
  if (state.revealed) put("answer", 1);
  if (state.event !== null) put("e", state.event + 1);
  if (state.tab !== "none") put("tab", state.tab);
  if (state.speed !== 1) put("speed", state.speed);
  if (state.projector) put("projector", 1);
  if (state.still) put("still", 1);
  if (!state.gl) put("gl", "none");
  return parts.join("&");
}

/** What an address asks for before its scene is known. */
export function readAddress(hash: string, query: string): { fields: Map<string, string>; scene: string | null; still: boolean; gl: boolean } {
  const fields = new Map([...new URLSearchParams(hash.replace(/^#/, ""))]);
  return {
    fields,
    scene: fields.get("scene") ?? null,
    still: fields.get("still") === "1",
    gl: fields.get("gl") !== "none" && new URLSearchParams(query).get("gl") !== "none",
  };
}

const numberIn = (text: string): number => (/^[-+]?\d+(\.\d*)?(e\d+)?$/i.test(text.trim()) ? Number(text) : Number.NaN);

/** allowed: in order. Asked for within them first: beside a huge number all are equally far. */
function nearestOf(asked: number, allowed: readonly number[]): number {
  const within = Math.max(allowed[0], Math.min(allowed.at(-1)!, asked));
  return allowed.reduce((best, each) => (Math.abs(each - within) < Math.abs(best - within) ? each : best));
}

/** The place asked for, or the nearest from which the scene is still to be seen; null if it is none. */
function readObserver(text: string, { center, radius }: SceneData["bounds"]): { observer: ViewState["observer"]; isMoved: boolean } | null {
  if (text === "start" || text === "camera") return { observer: text, isMoved: false };
  const v = text.split(",").map((each) => (each.trim() === "" ? Number.NaN : Number(each)));
  if (v.length !== 6 || !v.every(Number.isFinite)) return null;
  const far = FARTHEST * radius;
  const near = v.map((each, k) => Math.max(center[k % 3] - far, Math.min(center[k % 3] + far, each)));
  const [eye, target] = [near.slice(0, 3), near.slice(3)] as unknown as [Vec3, Vec3];
  const arm = sub(eye, target);
  // Straight above or below its target the observer has no upright.
  return length(arm) > NEAREST * radius && Math.hypot(arm[0], arm[2]) > NEAREST * radius ? { observer: { eye, target }, isMoved: near.join() !== v.join() } : null;
}

/** Reads an address's fields, and notes the keys that cannot be followed. */
function createReader(fields: ReadonlyMap<string, string>) {
  const damaged = new Set<string>();
  const noting = <T>(key: string, found: T, asked: T): T => {
    if (found !== asked) damaged.add(key);
    return found;
  };
  return {
    damaged,
    /** undefined where it is not asked for, or not to be understood. */
    read<T>(key: string, parse: (text: string) => T | null): T | undefined {
      const text = fields.get(key);
      const value = text === undefined ? undefined : parse(text);
      if (value === null) damaged.add(key);
      return value ?? undefined;
    },
    /** The whole number that is meant, at least `first` and at most `last`. */
    within(key: string, text: string, first: number, last: number): number | null {
      const asked = numberIn(text);
      return Number.isNaN(asked) || last < first ? null : noting(key, Math.max(first, Math.min(last, Math.round(asked))), asked);
    },
    /** The nearest of those that there are. */
    nearest(key: string, text: string, allowed: readonly number[]): number | null {
      const asked = numberIn(text);
      return Number.isNaN(asked) ? null : noting(key, nearestOf(asked, allowed), asked);
    },
  };
}
type Reader = ReturnType<typeof createReader>;

const oneOf = <T extends string>(all: readonly T[]) => (text: string): T | null => all.find((each) => each === text) ?? null;

/** stepView: of the lesson's step that is asked for. */
function viewOf({ read, within, nearest, damaged }: Reader, scene: SceneData, stepView: View): View {
  const resolution = read("n", (text) => nearest("n", text, scene.levels)) ?? stepView.resolution;
  const n = resolution ?? scene.start.resolution;
  const pixel = read("p", (text) => {
    const [column, row, ...more] = text.split(",").map((each) => within("p", each, 0, n - 1));
    return column === null || row === null || row === undefined || more.length ? null : ([column, row] as const);
  });
  const rays = read("rays", (text) => {
    const asked = text === "none" ? [] : text.split(",");
    return asked.every((each) => RAY_CHOICES.includes(each as RayChoice)) ? (asked as RayChoice[]) : null;
  });
  const observer = read("cam", (text) => {
    const found = readObserver(text, scene.bounds);
    if (found?.isMoved) damaged.add("cam");
    return found && found.observer;
  });
  return {
    resolution,
    pixel: pixel ?? (n === (stepView.resolution ?? scene.start.resolution) ? stepView.pixel : undefined),
    rays: rays ?? stepView.rays,
    tiles: read("tiles", oneOf(["empty", "filled"])) ?? stepView.tiles,
    observer: observer ?? stepView.observer,
    look: read("look", oneOf(LOOKS)) ?? stepView.look,
    slice: read("slice", oneOf(SLICES)) ?? stepView.slice,
    switches: stepView.switches,
    colours: read("colours", oneOf(TILE_VIEWS)) ?? stepView.colours,
    sweep: read("sweep", (text) => text) ?? stepView.sweep, // whether there is such a stop its part knows
  };
}

/** The state an address asks for, and the keys it names that cannot be followed: numbers are the nearest that
 *  there are, what is no number stays at the scene's start. */
export function followAddress(fields: ReadonlyMap<string, string>, scene: SceneData, kept: Kept): { state: ViewState; damaged: string[] } {
  const reader = createReader(fields);
  const { read, within, nearest, damaged } = reader;
  // What else a kiosk's address holds its own script reads, and says what it cannot follow.
  if (fields.get("kiosk") !== "1") for (const key of fields.keys()) if (!ADDRESS_KEYS.includes(key)) damaged.add(key);
  const number = read("step", (text) => within("step", text, 1, scene.lesson.length)) ?? null;
  const step = number === null ? null : number - 1;
  const revealed = read("answer", (text) => (text === "1" && step !== null && scene.lesson[step].answer ? true : null)) ?? false;
  const view = viewOf(reader, scene, stopOf(scene, { step, revealed })?.view ?? {});
  const wipe = read("wipe", (text) => (view.look === "traced" && numberIn(text) <= 1 ? numberIn(text) : null)) ?? 0;
  const event = read("e", (text) => within("e", text, 1, MOST_EVENTS)); // how many there are is known with the trace
  const speed = read("speed", (text) => nearest("speed", text, SPEEDS)) ?? kept.speed;
  const tab = read("tab", oneOf(TABS)) ?? kept.tab;
  const projector = read("projector", (text) => (text === "1" ? true : null)) ?? kept.projector;
  const state = applyView(scene, startState(scene, { ...kept, speed, projector, tab }), view);
  const switches = read("if", (text) => (text === "none" ? AS_TRACED : readSwitches(text, scene))) ?? state.switches;
  return { state: { ...state, wipe, step, revealed, event: event === undefined ? null : event - 1, switches }, damaged: [...damaged] };
}
