/** window.raywalk: what tests may ask of the page, and the one thing they may do, move time. */
import type { Session } from "./session";
import type { Shown } from "./state/shown";

export interface Asked {
  ready: () => Promise<void>;
  /** All parts have come, but for those that cannot be had. */
  whole: Promise<void>;
  stats: () => object;
  loseContext: () => void;
  /** Time stands still from now on, and moves by so many seconds when asked to. */
  hold: () => void;
  advance: (seconds: number) => void;
}

/** What is drawn, or nothing. */
const countsOf = (view: Shown | null) => ({
  tilesShown: view?.tiles ?? 0,
  chosen: view?.chosen.length ?? 0,
  lines: view?.chosen ?? [],
  thin: view?.thin.length ?? 0,
  left: view?.left ?? 0,
  kinds: [...(view?.kinds ?? [])],
  growing: view?.growing ?? null,
  grown: view?.grown ?? 1,
  events: view?.timeline?.events ?? [],
  boxes: view?.boxes?.boxes.length ?? 0,
});

export function exposeSession(session: Session, asked: Asked) {
  const read = {
    ...asked,
    get ready() {
      return asked.ready();
    },
    state: () => structuredClone(session.state),
    lesson: () => session.scene?.lesson ?? [],
    stats() {
      const bright = session.lit ?? session.told();
      return {
        ...asked.stats(),
        ...countsOf(session.shown()),
        lit: bright && { ray: bright.ray, light: bright.light },
        tiles: [...(session.trace()?.tiles ?? [])],
      };
    },
  };
  Object.defineProperty(window, "raywalk", { value: Object.freeze(read) });
}
