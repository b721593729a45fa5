/** The drawer of tools beside the stage, and the button that opens it. What is in it comes when it is first opened. */
import type { OnDemand } from "../on-demand";
import type { ViewState } from "../state/view-state";
import type { SceneData } from "../trace/types";
import { say } from "../words";
import { button, element, named } from "../element";
import type { DrawerActs } from "./drawer";

/** draw: what the page shows, once tools have come. */
export function createToolsDrawer(acts: DrawerActs, draw: () => void, onDemand: OnDemand) {
  const toggle = button(say("drawer.word"), say("drawer.help"), turn, { className: "open-drawer" });
  const root = named(element("section", "drawer"), say("drawer.word"));
  root.id = "drawer";
  root.hidden = true;
  toggle.setAttribute("aria-controls", root.id);
  const content = onDemand.one("drawer", ({ createDrawer }) => {
    const made = createDrawer(acts);
    root.append(...made.parts);
    return made;
  });
  function turn() {
    root.hidden = !root.hidden;
    toggle.setAttribute("aria-expanded", String(!root.hidden));
    if (root.hidden) return;
    content.use(() => {
      draw();
      root.scrollIntoView({ block: "nearest" });
      if (toggle.matches(":focus-visible")) root.querySelector("button")?.focus(); // opened by key, whose way on this is
    });
  }
  toggle.setAttribute("aria-expanded", "false");
  return {
    element: root,
    toggle,
    show(state: ViewState, scene: SceneData) {
      if (!root.hidden) content.now()?.show(state, scene);
    },
  };
}
