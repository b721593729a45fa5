/** What tracing the scene did not have to do, folded away under the ray card. */
import type { SceneData } from "../trace/types";
import { grouped, percent, say } from "../words";
import { element } from "./element";

/** Lines of label and value, as the plain article has them too. */
function lines({ spared }: SceneData): [string, string][] {
  const stages = spared.notRun.map((stage) => say(`spared.stages.${stage}`)).join(", ");
  const counts = spared.counts.map(([key, part, whole]): [string, string] => [
    say(`spared.${key}`),
    whole ? say("spared.of", { part: grouped(part), whole: grouped(whole), share: percent(part / whole) }) : grouped(part),
  ]);
  return stages ? [[say("spared.notRun"), stages], ...counts] : counts;
}

export function sparedList(scene: SceneData): HTMLElement {
  return element("dl", "figures", ...lines(scene).map(([label, value]) => element("div", "", element("dt", "", label), element("dd", "numbers", value))));
}

export function createSpared() {
  const root = element("details", "spared");
  let shown = "";
  return {
    element: root,
    show(scene: SceneData) {
      if (shown === scene.id) return;
      shown = scene.id;
      root.replaceChildren(element("summary", "", say("spared.title")), sparedList(scene), element("p", "spared-note", say("spared.note")));
    },
  };
}
