/** What tracing the scene did not have to do, folded away under the ray card. */
import type { SceneData } from "../trace/types";
import { grouped, percent, say } from "../words";
import { element } from "./element";

/** Lines of label and value, as the plain article has them too. */
function lines({ savings }: SceneData): [string, string][] {
  const stages = savings.notRun.map((stage) => say(`savings.stages.${stage}`)).join(", ");
  const counts = savings.counts.map(([key, part, whole]): [string, string] => [
    say(`savings.${key}`),
    whole ? say("savings.of", { part: grouped(part), whole: grouped(whole), share: percent(part / whole) }) : grouped(part),
  ]);
  return stages ? [[say("savings.notRun"), stages], ...counts] : counts;
}

export function savingsList(scene: SceneData): HTMLElement {
  return element("dl", "figures", ...lines(scene).map(([label, value]) => element("div", "", element("dt", "", label), element("dd", "numbers", value))));
}

export function createSavings() {
  const root = element("details", "savings");
  let shown = "";
  return {
    element: root,
    show(scene: SceneData) {
      if (shown === scene.id) return;
      shown = scene.id;
      root.replaceChildren(element("summary", "", say("savings.title")), savingsList(scene), element("p", "savings-note", say("savings.note")));
    },
  };
}
