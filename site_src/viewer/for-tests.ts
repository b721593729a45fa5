/** window.raywalk: what tests may ask of the page, and the one thing they may do, move time. */
import type { Shown } from "./state/shown";
import type { ViewState } from "./state/view-state";

export interface Asked {
  state: () => ViewState | null;
  ready: () => Promise<void>;
  stats: () => object;
  lesson: () => readonly object[];
  loseContext: () => void;
  /** Time stands still from now on, and moves by so many seconds when asked to. */
  hold: () => void;
  advance: (seconds: number) => void;
}

/** What is drawn, or nothing. */
export const countsOf = (view: Shown | null) => ({
  tilesShown: view?.tiles ?? 0,
  chosen: view?.chosen.length ?? 0,
  lines: view?.chosen ?? [],
  thin: view?.thin.length ?? 0,
  left: view?.left ?? 0,
  kinds: [...(view?.kinds ?? [])],
  growing: view?.growing ?? null,
  grown: view?.grown ?? 1,
  events: view?.timeline?.events ?? [],
});

export function exposeForTests(asked: Asked) {
  const read = {
    ...asked,
    state: () => structuredClone(asked.state()),
    get ready() {
      return asked.ready();
    },
  };
  Object.defineProperty(window, "raywalk", { value: Object.freeze(read) });
}
