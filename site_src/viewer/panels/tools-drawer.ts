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
  toggle.setAttribute("aria-controls", root.id);
  const content = onDemand.one("drawer", ({ createDrawer }) => {
    const made = createDrawer(acts);
    root.append(...made.parts);
    return made;
  });
  const show = (on: boolean) => {
    root.hidden = !on;
    toggle.setAttribute("aria-expanded", String(on));
  };
  /** then: called when its tools are there. */
  function open(then: () => void) {
    show(true);
    content.use(() => {
      draw();
      then();
    });
  }
  function turn() {
    if (!root.hidden) return show(false);
    open(() => {
      root.scrollIntoView({ block: "nearest" });
      if (toggle.matches(":focus-visible")) root.querySelector("button")?.focus(); // opened by key, whose way on this is
    });
  }
  show(false);
  return {
    element: root,
    toggle,
    open,
    show(state: ViewState, scene: SceneData) {
      if (!root.hidden) content.now()?.show(state, scene);
    },
  };
}
