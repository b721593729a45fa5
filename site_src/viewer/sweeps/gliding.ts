/** What is drawn moves on between stops: it follows the finger, and glides to the stop whose rays are shown. */
import type { Session } from "../session";
import { isAt, movedTo, withMostPoints } from "../state/between";
import { placeOf, stopIn, type Place } from "../state/swept";
import type { SceneData } from "../trace/types";
import { scenesOf } from "./stops";

const LAG = 80; // ms in which two thirds of the way are gone
const THERE = 0.01; // of the way between two stops
const LONGEST = 100; // ms of a frame

export function createGliding(session: Session) {
  const reduced = matchMedia("(prefers-reduced-motion: reduce)");
  let of = ""; // scene and sweep
  let at: Place = [0, 0];
  let held: Place | null = null;
  let last = 0;

  /** Whose stop is shown, else whose was: its own stop is the scene. */
  function shown() {
    const { scene, state } = session;
    const id = of.startsWith(`${scene!.id} `) ? of.split(" ")[1] : scene!.sweeps?.[0].id;
    const own = scene!.sweeps?.find((each) => each.id === id);
    return stopIn(scene!, state!.sweep) ?? (own && { sweep: own, stop: own.own });
  }

  function glided(scene: SceneData): SceneData {
    const now = shown();
    const stops = now && scenesOf(session.scene!, now.sweep.id);
    if (!now) return scene;
    const goal = placeOf(now.sweep, now.stop);
    const name = `${session.scene!.id} ${now.sweep.id}`;
    if (of !== name || !stops || reduced.matches || session.state!.still) [of, at, held] = [name, goal, null];
    const passed = performance.now() - last;
    last += passed;
    const share = held ? 1 : 1 - Math.exp(-Math.min(LONGEST, passed) / LAG);
    const to = held ?? goal;
    const next: Place = [at[0] + (to[0] - at[0]) * share, at[1] + (to[1] - at[1]) * share];
    at = Math.max(...next.map((each, k) => Math.abs(each - to[k]))) < THERE ? to : next;
    if (at !== to) session.changed(); // and so on, frame by frame
    return !stops || isAt(now.sweep, now.stop, at) ? scene : movedTo(scene, now.sweep, stops.map(withMostPoints), at);
  }

  return {
    /** Follows the finger between stops; null: it was let go. */
    hold(place: Place | null) {
      held = place;
      session.changed();
    },
    /** The scene of this moment's drawing, and that whose bodies and lamps are moved: the scene itself, or where more than places is other the
     *  stop's. scene: at its stop. */
    drawn: (scene: SceneData) => ({ scene: withMostPoints(shown()?.sweep.anew ? session.here()! : session.scene!), switched: glided(withMostPoints(scene)) }),
  };
}
