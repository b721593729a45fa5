/** The renderer that is used: WebGL's, and the flat one where the browser refuses WebGL or the driver has taken it away. */
import { createFlatRenderer } from "./flat";
import type { StageRenderer } from "./renderer";
import { createWebglRenderer } from "./webgl";

const RECOVER_AFTER = 1000; // ms: the driver needs a moment
const RECOVERIES = 2; // a graphics card that goes on dropping drawings is left alone

export interface DrawingActs {
  /** WebGL is refused or was lost, and the flat renderer has taken over; null: WebGL is back. */
  flat: (why: "refused" | "lost" | null) => void;
  /** Another renderer, that has no size yet. */
  replaced: () => void;
}

export function createDrawing(element: HTMLElement, withGl: boolean, acts: DrawingActs) {
  let losses = 0;
  let renderer = (withGl && createWebglRenderer(fallBack)) || createFlatRenderer();
  element.prepend(renderer.canvas);
  if (withGl && renderer.isFlat) queueMicrotask(() => acts.flat("refused"));

  function replaceBy(other: StageRenderer, why: "lost" | null) {
    renderer.dispose();
    renderer = other;
    element.prepend(renderer.canvas);
    acts.replaced();
    acts.flat(why);
  }
  function fallBack() {
    replaceBy(createFlatRenderer(), "lost");
    if (++losses <= RECOVERIES) setTimeout(recover, RECOVER_AFTER);
  }
  function recover() {
    const anew = createWebglRenderer(fallBack);
    if (anew) replaceBy(anew, null);
  }
  return { renderer: () => renderer };
}
