/** What the page is at: the state, the scene and the rays it belongs to, and what follows from them. */
import type { CardLine } from "./panels/card";
import type { RayEvent } from "./state/events";
import type { SectionsData } from "./state/section";
import { createShown, type Shown } from "./state/shown";
import type { Timeline } from "./state/timeline";
import type { ViewState } from "./state/view-state";
import type { SceneData, Trace } from "./trace/types";

export interface Listeners {
  /** Something has changed that is seen. */
  changed: () => void;
  /** The state asks for another trace. */
  otherLevel: () => void;
}

export function createSession() {
  const shown = createShown();
  let listeners: Listeners | null = null;
  let loaded: Trace | null = null;

  const session = {
    state: null as ViewState | null,
    scene: null as SceneData | null,
    sections: null as SectionsData | null, // of the scene, once a slice of it was asked for
    missing: false, // the trace could not be loaded
    lit: null as CardLine | null, // what the pointer is on

    listen: (to: Listeners) => void (listeners = to),
    changed: () => listeners?.changed(),

    /** The state that a person's act leads to; the same object where it changed nothing. */
    set(next: ViewState) {
      const { state } = session;
      if (!state || next === state) return;
      const levelChanged = next.n !== state.n;
      session.state = next;
      if (levelChanged) listeners?.otherLevel();
      else session.changed();
    },

    receive(trace: Trace | null) {
      loaded = trace;
      session.missing = false;
    },

    /** The trace of what the state shows; null while another one is on its way. */
    trace: (): Trace | null => (loaded && loaded.scene === session.state?.scene && loaded.n === session.state.n ? loaded : null),

    shown: (): Shown | null => (session.state && session.scene ? shown.of(session.state, session.scene, session.trace()) : null),

    /** Of the selected pixel; null until its rays are here. */
    timeline: (): Timeline | null => session.shown()?.timeline ?? null,

    /** The event the player is at. */
    told: (): RayEvent | null => {
      const event = session.state?.event ?? null;
      return event === null ? null : (session.timeline()?.events[event] ?? null);
    },
  };
  return session;
}

export type Session = ReturnType<typeof createSession>;
