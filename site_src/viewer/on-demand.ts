/**
 * What a first view does not show: each import() of this table becomes a classic script of its own (bundle.mjs), which
 * is loaded when it is first used, or before, when the browser has nothing else to do.
 */
import { addScript, LoadError } from "./load";
import type { Notice } from "./panels/notice";
import { troubleOfPart } from "./trouble";

const PARTS = {
  slice: () => import("./stage/slice"),
  "switch-acts": () => import("./switch-acts"),
  "what-if": () => import("./panels/what-if"),
  "card-rays": () => import("./panels/card-rays"),
  "card-tree": () => import("./panels/card-tree"),
  "card-sum": () => import("./panels/card-sum"),
  code: () => import("./panels/code"),
  saving: () => import("./saving"),
  drawer: () => import("./panels/drawer"),
  choices: () => import("./panels/choices"),
  guide: () => import("./panels/guide"),
  lecture: () => import("./panels/lecture"),
  spoken: () => import("./panels/spoken"),
  "traced-picture": () => import("./stage/traced-picture"),
  surroundings: () => import("./stage/surroundings"),
  marks: () => import("./stage/marks"),
  "tile-legend": () => import("./panels/tile-legend"),
  "box-lines": () => import("./state/box-lines"),
  inset: () => import("./stage/inset"),
  worked: () => import("./worked/worked"),
  sweeps: () => import("./sweeps/sweeps"),
  busy: () => import("./stage/busy"),
  flat: () => import("./stage/flat"),
  "event-words": () => import("./event-words"),
  told: () => import("./panels/told"),
  "at-hand": () => import("./panels/at-hand"),
};
type Parts = typeof PARTS;
export type PartName = keyof Parts;
type Part<K extends PartName> = Awaited<ReturnType<Parts[K]>>;
type Make = (shared: readonly unknown[]) => unknown;

declare global {
  interface Window {
    /** What the parts import of the viewer's modules, in an order that parts.mjs knows and puts here. */
    raywalkShared: readonly unknown[];
    raywalkParts: {
      /** What an import() is when it is bundled. */
      load: (name: string) => Promise<unknown>;
      /** A part's script calls this. */
      offer: (name: string, make: Make) => void;
    };
  }
}

/** own: the viewer's script, which names its parts' files beside it. */
export function createOnDemand(own: HTMLScriptElement, notice: Notice) {
  const files: Readonly<Record<string, string>> = JSON.parse(own.dataset.parts!);
  const offered = new Map<string, Make>();
  const failed = new Map<string, number>(); // how often each was asked for in vain
  const coming = new Map<PartName, Promise<unknown>>();
  const here = new Map<PartName, unknown>();

  window.raywalkParts = {
    offer: (name, make) => void offered.set(name, make),
    async load(name) {
      await addScript(new URL(files[name], own.src).href, name, failed.get(name));
      const make = offered.get(name);
      if (!make) throw new LoadError(name, "damaged");
      return make(window.raywalkShared);
    },
  };

  async function load(name: PartName) {
    try {
      here.set(name, await PARTS[name]());
      return here.get(name);
    } catch (error) {
      failed.set(name, (failed.get(name) ?? 0) + 1);
      coming.delete(name); // asked for anew the next time
      throw error;
    }
  }
  function come<K extends PartName>(name: K) {
    const promise = coming.get(name) ?? load(name);
    coming.set(name, promise);
    return promise as Promise<Part<K>>;
  }

  function want<K extends PartName>(name: K, act: (part: Part<K>) => void) {
    const ready = () => act(here.get(name) as Part<K>);
    if (here.has(name)) return ready(); // at once: what a click may do it may not do later
    void come(name).then(ready, () => {
      notice.say(...troubleOfPart(name, () => want(name, act)));
    });
  }

  return {
    /** Rejects if the part cannot be had. */
    come,
    /** Something that a part makes, once, when it is first used. */
    one<K extends PartName, T>(name: K, make: (part: Part<K>) => T) {
      let made: T | null = null;
      let isAsked = false;
      const makeOnce = (part: Part<K>) => (made ??= make(part));
      return {
        /** null: its script has not come yet. */
        now: () => (here.has(name) ? makeOnce(here.get(name) as Part<K>) : null),
        /** Acts with it as soon as it is there; if its script does not come, that is said. */
        use(act: (thing: T) => void) {
          isAsked = true;
          want(name, (part) => act(makeOnce(part)));
        },
        /** For what is drawn again and again: null until it is there. The first time it is asked for, and `come` is called then. */
        nowOr(come: () => void) {
          if (!here.has(name) && !isAsked) this.use(() => come());
          return this.now();
        },
        /** It is not asked for before it is wanted; from then on it is there. */
        when(isWanted: boolean, come: () => void) {
          return isWanted ? this.nowOr(come) : this.now();
        },
      };
    },
    /** Brings the parts before they are asked for, one after the other; those that do not come are asked for when used. */
    async bringAll() {
      for (const name of Object.keys(PARTS) as PartName[]) {
        await idle();
        await come(name).catch(() => {});
      }
    },
  };
}

export type OnDemand = ReturnType<typeof createOnDemand>;

const idle = () => new Promise((done) => (window.requestIdleCallback ?? setTimeout)(done));
