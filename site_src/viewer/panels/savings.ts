/** What tracing the scene did not have to do, folded away under the ray card. */
import type { OnDemand } from "../on-demand";
import type { SceneData } from "../trace/types";
import { say } from "../words";
import { element } from "../element";

export function createSavings(onDemand: OnDemand) {
  const root = element("details", "savings");
  const summary = element("summary", "", say("savings.title"));
  const article = onDemand.one("article", (part) => part);
  let scene: SceneData | null = null;
  let filled = "";
  function fill() {
    if (!root.open || !scene || filled === scene.id) return;
    article.use(({ savingsOf }) => {
      filled = scene!.id;
      root.replaceChildren(summary, ...savingsOf(scene!));
    });
  }
  root.append(summary);
  root.addEventListener("toggle", fill);
  return {
    element: root,
    show(next: SceneData) {
      scene = next;
      fill();
    },
  };
}
