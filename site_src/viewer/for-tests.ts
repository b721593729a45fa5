/** window.raywalk: what tests may ask of the page. Its time is the browser's, which they may hold (tests/viewer/browser.mjs). */
import type { Session } from "./session";
import type { Shown } from "./state/shown";

export interface Asked {
  ready: () => Promise<void>;
  /** Done when all parts are there, except those that cannot be had. */
  whole: Promise<void>;
  stats: () => object;
  loading: () => readonly string[];
  moving: () => readonly unknown[];
  loseContext: () => void;
}

/** What is drawn, or nothing. */
const countsOf = ({ tiles: tilesShown = 0, chosen: lines = [], thin = [], left = 0, kinds = new Set(), growing = null, grown = 1, timeline, boxes }: Partial<Shown>) => ({
  tilesShown, chosen: lines.length, lines, thin: thin.length, left, kinds: [...kinds], growing, grown,
  events: timeline?.events ?? [],
  boxes: boxes?.boxes.length ?? 0,
});

export function exposeSession(session: Session, asked: Asked) {
  const read = {
    ...asked,
    get ready() {
      return asked.ready();
    },
    state: () => structuredClone(session.state),
    /** What is still loading; pictures that wait to be seen are not. */
    loading: () => [...asked.loading(), ...[...document.images].filter(({ complete, loading }) => !complete && loading !== "lazy").map(({ src }) => src)],
    /** What the page waits for; nothing: it is at rest, and a picture of it is the picture. */
    pending: () => [...read.loading(), ...asked.moving()],
    lesson: () => session.scene?.lesson ?? [],
    stats() {
      const bright = session.lit ?? session.currentEvent();
      return {
        ...asked.stats(),
        ...countsOf(session.shown() ?? {}),
        lit: bright && { ray: bright.ray, light: bright.light },
        tiles: [...(session.trace()?.tiles ?? [])],
      };
    },
  };
  Object.assign(window, { raywalk: read });
}
