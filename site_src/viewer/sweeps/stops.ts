/** A sweep's stops as the page shows them: the scene as it is there, and its rays. */
import type { Loader } from "../load";
import type { Notice } from "../panels/notice";
import type { Session } from "../session";
import { besides, countOf, levelsOf, nearestLevel, sceneAt, stopIn, type Sweep } from "../state/swept";
import { setLevel } from "../state/view-state";
import { decodeWithRests } from "../trace/decode";
import { damaged } from "../trace/errors";
import type { SceneData, StopsData, Trace } from "../trace/types";
import { wholeAgain, type Table } from "../trace/whole";
import { list, say } from "../words";

const KEPT_FILES = 4; // of each kind
const KEPT_TRACES = 64; // decoded stops, a few hundred kilobytes each: all of a sweep at one grid

/** A sweep's rays at one grid: stops are decoded when they are asked for. */
type Rays = (stop: number) => Promise<Trace>;

/** What is published of a scene's sweeps. A file is read with the stop that is asked for: what is damaged is not kept. */
function readersOf(kept: Loader["kept"], scene: SceneData) {
  let wanted = 1; // the stop
  const traces = new Map<string, Promise<Trace>>();
  const come = new Map<string, readonly SceneData[]>();

  function stopsFrom<T>(json: unknown, id: string): readonly T[] {
    const { format, stops } = json as { format: number; stops: readonly T[] };
    if (format !== 1 || stops.length !== countOf(scene.sweeps!.find((each) => each.id === id)!)) throw damaged("not the stops of this sweep");
    return stops;
  }

  async function scenesFrom(json: unknown, name: string): Promise<readonly SceneData[]> {
    const id = name.split("/")[1];
    const made = stopsFrom<StopsData["stops"][number]>(json, id).map((stop, k) => sceneAt(scene, stop, id, k + 1));
    come.set(id, made);
    return made;
  }

  async function raysFrom(json: unknown, name: string): Promise<Rays> {
    const [of, id, n] = name.split("/");
    const whole = wholeAgain(stopsFrom<Table>(json, id));
    const rays = (stop: number) => {
      const key = `${name} ${stop}`;
      const trace = traces.get(key) ?? decodeWithRests(whole[stop - 1], { scene: of, n: Number(n) }, async () => {}).then((made) => Object.assign(made, { scene: `${of}/${id}/${stop}` }));
      traces.delete(key);
      traces.set(key, trace);
      for (const old of traces.keys()) if (traces.size > KEPT_TRACES) traces.delete(old);
      return trace;
    };
    await rays(wanted);
    return rays;
  }

  const scenes = kept(KEPT_FILES, scenesFrom);
  const rays = kept(KEPT_FILES, raysFrom);
  return {
    of: scene,
    /** Those of a sweep whose stops have come. */
    scenes: (id: string) => come.get(id) ?? null,
    async at(id: string, n: number, stop: number) {
      wanted = stop;
      const [there, decoded] = await Promise.all([scenes(`${scene.of}/${id}/stops`), rays(`${scene.of}/${id}/${n}`)]);
      return { there, trace: await decoded(stop), decoded };
    },
  };
}

let readers: ReturnType<typeof readersOf> | null = null; // of the scene that is shown: read anew, it is another

/** The scene at each stop of a sweep; null until they have come. */
export const scenesOf = (scene: SceneData, id: string) => (readers?.of === scene ? readers.scenes(id) : null);

/** Scene and rays at a stop; what turns out damaged is asked for once more, and with it the file. */
async function readAt(kept: Loader["kept"], scene: SceneData, id: string, n: number, stop: number) {
  const known = readers?.of === scene ? readers : null; // else of another scene, or of this one before it was read anew
  readers = known ?? readersOf(kept, scene);
  try {
    return await readers.at(id, n, stop);
  } catch (error) {
    if (!known) throw error;
    readers = readersOf(kept, scene);
    return readers.at(id, n, stop);
  }
}


/** A sweep's files, before any of its stops is asked for; what cannot be had is said when it is. */
export function bringStops({ scene, state }: Session, kept: Loader["kept"], id: string) {
  const sweep = scene!.sweeps!.find((each) => each.id === id)!;
  readAt(kept, scene!, id, nearestLevel(levelsOf(scene!, id), state!.n), sweep.own).then((read) => bringNear(read, sweep, sweep.own), () => {});
}

/** What stops beside it will show, before they are asked for; what cannot be had is said when it is. */
async function bringNear({ there, decoded }: Awaited<ReturnType<typeof readAt>>, sweep: Sweep, stop: number) {
  for (const near of besides(sweep, stop)) {
    await new Promise((done) => (window.requestIdleCallback ?? setTimeout)(done));
    await decoded(near).catch(() => {});
    if (near !== sweep.own) new Image().src = `${document.body.dataset.root ?? ""}scenes/${there[near - 1].of}/${there[near - 1].picture}`;
  }
}

let tell: Notice | null = null;

/** A slice is of the scene as it stands: where something has moved it is left, and that is said. */
export function leaveSlice(session: Session) {
  const here = session.here()!;
  if (session.state!.slice === "none" || here === session.scene || here.bodies) return;
  queueMicrotask(() => session.set({ ...session.state!, slice: "none" })); // not while the page is drawn
  tell?.say(say("sweep.noSlice"), {});
}

/** The rays at the stop that the state asks for; the session has the scene as it is there from then on. */
export async function stopAt(session: Session, loader: Loader, notice: Notice): Promise<Trace> {
  const scene = session.scene!;
  const asked = session.state!;
  const { sweep: text, n } = asked;
  tell = notice;
  /** Unless another stop was asked for meanwhile. */
  const come = (stop: SceneData | null, trace: Trace) => {
    if (session.scene === scene && session.state!.sweep === text && session.state!.n === n) session.stop = stop;
    return trace;
  };
  const own = async () => come(null, await loader.trace(scene.of, n));
  const found = stopIn(scene, text);
  if (!found) {
    notice.say(say("trouble.address", { keys: list(["sweep"]) }), { about: "address" });
    session.set({ ...asked, sweep: "" });
    return own();
  }
  const { sweep, stop } = found;
  if (stop === sweep.own) return own();
  const levels = levelsOf(scene, sweep.id);
  if (!levels.includes(n)) {
    session.set(setLevel(asked, nearestLevel(levels, n)));
    return own(); // dropped: the other grid was asked for
  }
  const read = await readAt(loader.kept, scene, sweep.id, n, stop);
  void bringNear(read, sweep, stop);
  return come(read.there[stop - 1], read.trace);
}
