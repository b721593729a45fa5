/** What a pixel of the small picture shows is said before it is pressed, in the browser's own tip: dark sides look alike. */
import { treeOf } from "../state/lines";
import type { ViewState } from "../state/view-state";
import type { SceneData, Trace } from "../trace/types";
import { say } from "../words";

export function createPointed(home: HTMLElement) {
  let nameAt: (column: number, row: number) => string = () => "";
  let n = 1;
  // The picture moves between the card and the stage: its place is asked of the event.
  home.addEventListener("pointermove", ({ target, clientX, clientY }) => {
    const frame = target instanceof Element && target.closest<HTMLElement>(".picture-frame");
    if (!frame) return;
    const { left, top, width, height } = frame.getBoundingClientRect();
    const place = (share: number) => Math.max(0, Math.min(n - 1, Math.floor(n * share)));
    frame.title = nameAt(place((clientX - left) / width), place((clientY - top) / height));
  });
  return {
    /** trace: null where the answer to a question is not to be given away. */
    show(state: ViewState, scene: SceneData, trace: Trace | null) {
      n = state.n;
      nameAt = (column, row) => (trace ? (scene.objects[trace.object[treeOf(trace, row * n + column)[0]]]?.name ?? say("card.background")) : "");
    },
  };
}
