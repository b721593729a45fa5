/** What an unattended screen shows: every scene's lesson in turn, its tiles filling and its rays being walked. */
import { countOf, onTheWay, stopIn, wayTo } from "../state/swept";
import { isAsking } from "../state/view-state";
import type { KioskViewer } from "./hook";

const CHECKED_EVERY = 250; // ms
const PLAYS_UP_TO = 3; // times a stop's pace: then the next stop comes, whatever still plays
const SWEEP_PACE = 0.6; // seconds a stop of what moves
const PATIENCE = 20; // seconds for a scene to come
const RENEWED_AFTER = 6 * 3_600_000; // ms: then, between two rounds, the page is loaded anew; nothing can pile up for months

/** false where it takes too long. */
function inTime(what: Promise<boolean>): Promise<boolean> {
  let timer = 0;
  const late = new Promise<false>((done) => (timer = window.setTimeout(() => done(false), 1000 * PATIENCE)));
  return Promise.race([what, late]).finally(() => clearTimeout(timer));
}

const range = (from: number, to: number) => Array.from({ length: Math.abs(to - from) }, (_, k) => from + Math.sign(to - from) * (k + 1));

/** Where a step shows a stop of a sweep: from there to the last, back to the first and there again; of a grid in rows, each
 *  from the end at which the one before was left. Not while it asks. */
function stopsFrom({ scene, state }: KioskViewer["session"]): string[] {
  const found = scene && state && !isAsking(state, scene) && stopIn(scene, state.sweep);
  if (!found) return [];
  const { sweep, stop } = found;
  const [here, last] = [wayTo(sweep, stop), countOf(sweep) - 1];
  return [...range(here, last), ...range(last, 0), ...range(0, here)].map((to) => `${sweep.id}:${onTheWay(sweep, to)}`);
}

/** pace: seconds that a stop of a lesson is shown. */
export function createAttract(viewer: KioskViewer, pace: number, acts: { stuck: () => void; renew: () => void }) {
  const { session } = viewer;
  const reduced = matchMedia("(prefers-reduced-motion: reduce)");
  let cut = () => {};
  const wait = (seconds: number) =>
    new Promise<void>((done) => {
      const timer = setTimeout(done, 1000 * seconds);
      cut = () => (clearTimeout(timer), done());
    });
  let running = false;
  let stops = 0;
  let cycles = 0; // scenes shown to their end

  const tiles = () => session.state?.tiles;
  const moves = () => !reduced.matches && !session.state?.still;

  /** Until it no longer goes on, or for too long. */
  async function whileIt(goesOn: () => boolean) {
    const every = Math.min(CHECKED_EVERY / 1000, pace);
    for (let gone = 0; running && goesOn() && gone < PLAYS_UP_TO * pace; gone += every) await wait(every);
  }

  /** One stop of a lesson: its words and view, then its rays. */
  async function showStop(isFirst: boolean) {
    stops++;
    if (isFirst && moves() && tiles() === "empty") {
      viewer.acts.render();
      await whileIt(() => tiles() === "filling");
      if (running && tiles() === "filling") viewer.acts.render();
    }
    if (running) await wait(pace);
    for (const sweep of moves() ? stopsFrom(session) : []) if (running) await (session.set({ ...session.state!, sweep }), wait(Math.min(pace, SWEEP_PACE)));
    if (!running || !moves() || !session.state?.rays.includes("pixel") || !session.timeline()) return;
    viewer.acts.play();
    await whileIt(() => session.state?.playing === true);
    if (running) viewer.acts.endEvents();
  }

  /** The lesson's next stop; false at its end. */
  function turn(): boolean {
    const before = session.state;
    viewer.acts.turn(1);
    return session.state !== before;
  }

  async function showScene(id: string): Promise<boolean> {
    const isHere = await inTime(viewer.begin(id));
    if (!running || !isHere) return isHere;
    for (let isFirst = true; running && (isFirst || turn()); isFirst = false) await showStop(isFirst);
    if (running) cycles++;
    return true;
  }

  return {
    async run() {
      running = true;
      let lost = 0; // scenes in a row that could not be shown
      let isOld = false;
      const from = Math.max(0, viewer.ids.indexOf(session.state?.scene ?? ""));
      for (let at = from; running; at++) {
        if (!isOld && at > from && at % viewer.ids.length === 0 && performance.now() > RENEWED_AFTER) {
          isOld = true;
          acts.renew(); // goes on showing what is here until the page can be had
        }
        const isShown = await showScene(viewer.ids[at % viewer.ids.length]);
        lost = isShown ? 0 : lost + 1;
        if (!running) return;
        if (lost > viewer.ids.length) return acts.stuck();
        if (!isShown) await wait(pace);
      }
    },
    stop() {
      running = false;
      cut();
    },
    runs: () => running,
    scene: () => session.state?.scene ?? null,
    counts: () => ({ stops, cycles }),
  };
}
