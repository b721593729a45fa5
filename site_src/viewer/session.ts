/** What the page shows: the state, the scene and the rays it belongs to, and what follows from them. */
import type { Boxes } from "./state/box-lines";
import type { RayEvent } from "./state/event-types";
import { isSwitched, type Switches } from "./state/switches";
import { createShown, type Shown } from "./state/shown";
import type { CostsOf } from "./state/tile-views";
import type { Timeline } from "./state/timeline";
import type { LitLine, ViewState } from "./state/types";
import type { WhatIf } from "./state/what-if";
import type { Surrounded } from "./state/surrounded";
import type { TilePicture } from "./tile-picture";
import type { SceneData, SectionsData, Trace } from "./trace/types";

export interface Listeners {
  /** Something has changed that is seen. */
  changed: () => void;
  /** The state asks for another trace. */
  otherLevel: () => void;
}

type Recombine = (trace: Trace, scene: SceneData, switches: Switches) => WhatIf;

const EMPTY = {
  state: null as ViewState | null,
  scene: null as SceneData | null,
  sections: null as SectionsData | null, // of the scene, once a slice of it was asked for
  stop: null as SceneData | null, // the scene as it is at the stop of a sweep that came last; null: as it is
  missing: false, // the trace could not be loaded
  finest: null as Trace | null, // of the finest grid, once switches were set
  surroundings: null as Surrounded | null, // of the scene's mirrors and glass, once the look asked for them
  boxes: null as Boxes | null, // of the scene's meshes, once they were wanted
  lit: null as LitLine | null, // what the pointer is on
  pointed: null as readonly [number, number] | null, // the tile it is on
};

/** recombining: what switches make of the shown trace and of the finest; null until its script is there, as `costing` is. */
export function createSession(recombining: () => { shown: Recombine; finest: Recombine } | null, costing: () => CostsOf | null) {
  const shown = createShown(costing);
  let listeners: Listeners | null = null;
  let loaded: Trace | null = null;

  const session = {
    ...EMPTY,

    listen: (to: Listeners) => void (listeners = to),
    changed: () => listeners?.changed(),

    /** The state that a person's act leads to; the same object where it changed nothing. */
    set(next: ViewState) {
      const { state } = session;
      if (!state || next === state) return;
      session.state = next;
      if (next.n !== state.n || next.sweep !== state.sweep) listeners?.otherLevel();
      else session.changed();
    },

    /** Another scene; its rays are still to come. */
    enter(scene: SceneData, state: ViewState) {
      Object.assign(session, { scene, state, lit: null, stop: null });
      session.receive(null);
    },

    receive(trace: Trace | null) {
      loaded = trace;
      session.missing = false;
    },

    /** The trace of what the state shows, as it was traced; null while another one is on its way. */
    traced: (): Trace | null => (loaded && loaded.scene === session.here()?.of && loaded.n === session.state?.n ? loaded : null),

    /** The scene as it is traced here: at the state's stop. */
    here: () => (session.state?.sweep && session.stop) || session.scene,

    /** The scene and its trace as the switches make them; the same objects where nothing is switched. */
    switched(): { scene: SceneData; trace: Trace | null } | null {
      const { state } = session;
      const scene = session.here();
      const trace = session.traced();
      if (!state || !scene) return null;
      const recombine = trace && isSwitched(state.switches) && recombining()?.shown;
      return recombine ? recombine(trace, scene, state.switches) : { scene, trace };
    },

    /** What the finished picture would be with the switches set, as fine as traces are here; null where nothing is switched. */
    recombined(): TilePicture | null {
      const { state, finest } = session;
      const scene = session.here();
      if (!state || !scene || !isSwitched(state.switches)) return null;
      const trace = finest?.scene === scene.of ? finest : session.traced();
      const recombine = trace && recombining()?.finest;
      return recombine ? { n: trace.n, colours: recombine(trace, scene, state.switches).trace.tiles } : null;
    },

    trace: (): Trace | null => session.switched()?.trace ?? null,

    shown(): Shown | null {
      const now = session.switched();
      return session.state && now && shown.of(session.state, now.scene, now.trace, session.boxes);
    },

    /** Of the selected pixel; null until its rays are here. */
    timeline: (): Timeline | null => session.shown()?.timeline ?? null,

    /** The one the player is at. */
    currentEvent: (): RayEvent | null => {
      const event = session.state?.event ?? null;
      return event === null ? null : (session.timeline()?.events[event] ?? null);
    },
  };
  return session;
}

export type Session = ReturnType<typeof createSession>;
