/** A sweep's stops as the page shows them: the scene as it is there, and its rays. */
import type { Loader } from "../load";
import type { Notice } from "../panels/notice";
import type { Session } from "../session";
import { levelsOf, sceneAt, stopIn } from "../state/swept";
import { setLevel } from "../state/view-state";
import { decodeWithRests } from "../trace/decode";
import type { SceneData, StopsData, Trace } from "../trace/types";
import { wholeAgain, type Table } from "../trace/whole";
import { list, say } from "../words";

const KEPT = 32; // decoded stops: a few hundred kilobytes each at most

interface Grids {
  stops: readonly Table[];
}

/** Decoded stops, and scenes at them, the last few of each. */
const known = new Map<string, unknown>();
function kept<T>(name: string, make: () => T): T {
  const value = known.has(name) ? (known.get(name) as T) : make();
  known.delete(name);
  known.set(name, value);
  for (const old of known.keys()) if (known.size > 2 * KEPT) known.delete(old);
  return value;
}
let of: SceneData | null = null; // whose stops they are: read anew, a scene is another

/** The rays at the stop that the state asks for; the session has the scene as it is there from then on. */
export async function stopAt(session: Session, loader: Loader, notice: Notice): Promise<Trace> {
  const scene = session.scene!;
  const asked = session.state!;
  const { sweep: text, n } = asked;
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
    session.set(setLevel(asked, levels.reduce((a, b) => (Math.abs(b - n) < Math.abs(a - n) ? b : a))));
    return own(); // dropped: the other grid was asked for
  }
  const folder = `${scene.of}/${sweep.id}`;
  const [moved, grids] = await Promise.all([loader.data(`${folder}/stops`) as Promise<StopsData>, loader.data(`${folder}/${n}`) as Promise<Grids>]);
  if (of !== scene) known.clear();
  of = scene;
  const there = kept(`${folder}/${stop}`, () => sceneAt(scene, moved, sweep.id, stop));
  const trace = await kept(`${folder}/${stop}/${n}`, async () => {
    const whole = kept(`${folder}//${n}`, () => wholeAgain(grids.stops));
    return Object.assign(await decodeWithRests(whole[stop - 1], { scene: scene.of, n }, async () => {}), { scene: there.of });
  });
  return come(there, trace);
}
