/** The renderer that is used: WebGL's, and the flat one where the browser refuses WebGL or the driver has taken it away. */
import type { StageRenderer } from "./renderer";
import { createWebglRenderer } from "./webgl";

const RECOVER_AFTER = 1000; // ms: the driver needs a moment
const RECOVERIES = 2; // a graphics card that goes on dropping drawings is left alone

export interface DrawingActs {
  /** Gives what makes the flat renderer, as soon as it has come. */
  flatRenderer: (use: (make: () => StageRenderer) => void) => void;
  /** WebGL is refused or was lost, and the flat renderer takes over; null: WebGL is back. */
  flat: (why: "refused" | "lost" | null) => void;
  /** Another renderer is used, which has no size yet. */
  replaced: () => void;
}

export function createDrawing(element: HTMLElement, withGl: boolean, acts: DrawingActs) {
  let losses = 0;
  let renderer = (withGl && createWebglRenderer(fallBack)) || nothingDrawn();
  element.prepend(renderer.canvas);
  if (renderer.isFlat)
    queueMicrotask(() => {
      goFlat();
      if (withGl) acts.flat("refused");
    });

  function replaceBy(other: StageRenderer) {
    renderer.dispose();
    renderer = other;
    element.prepend(renderer.canvas);
    acts.replaced();
  }
  function goFlat() {
    const waiting = nothingDrawn();
    replaceBy(waiting);
    acts.flatRenderer((make) => renderer === waiting && replaceBy(make()));
  }
  function fallBack() {
    goFlat();
    acts.flat("lost");
    if (++losses <= RECOVERIES) setTimeout(recover, RECOVER_AFTER);
  }
  function recover() {
    const anew = createWebglRenderer(fallBack);
    if (!anew) return;
    replaceBy(anew);
    acts.flat(null);
  }
  return { renderer: () => renderer };
}

/** Until the flat renderer's script is there. */
function nothingDrawn(): StageRenderer {
  const canvas = document.createElement("canvas");
  const nothing = () => {};
  return { canvas, isFlat: true, draw: nothing, forget: nothing, resize: nothing, dispose: () => canvas.remove(), held: () => ({}) };
}
