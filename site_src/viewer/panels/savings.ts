/** What tracing the scene did not have to do, folded away under the ray card. */
import type { SceneData } from "../trace/types";
import { say } from "../words";
import { element } from "../element";
import { savingsOf } from "./article";

/** side: the element that holds the card. */
export function createSavings(side: HTMLElement) {
  const summary = element("summary", "", say("savings.title"));
  const root = element("details", "savings", summary);
  side.append(root);
  let filled = "";
  return {
    show(scene: SceneData) {
      if (filled === scene.id) return;
      filled = scene.id;
      root.replaceChildren(summary, ...savingsOf(scene));
    },
  };
}
