/** What if: the button that opens the switches, which come when first opened, under the stage, and the one that undoes them all. */
import type { Actions } from "../actions";
import type { OnDemand } from "../on-demand";
import { isSwitched } from "../state/switches";
import type { ViewState } from "../state/view-state";
import type { SceneData } from "../trace/types";
import { say } from "../words";
import { button, element, named } from "../element";
import type { WhatIfActs } from "./what-if-switches";

export function createWhatIf(acts: WhatIfActs & Pick<Actions, "asTraced">, onDemand: OnDemand) {
  const toggle = button(say("whatIf.open.word"), say("whatIf.open.help"), () => (root.hidden ? open() : close()), { className: "open-what-if" });
  const undo = button(say("whatIf.undo.word"), say("whatIf.undo.help"), acts.asTraced, { className: "undo-switches" });
  const root = named(element("section", "what-if"), say("whatIf.region"));
  root.id = "what-if";
  toggle.setAttribute("aria-controls", root.id);
  const switches = onDemand.one("what-if-switches", ({ createSwitches }) => {
    const made = createSwitches(acts);
    root.append(...made.groups);
    return made;
  });
  let shown: readonly [ViewState, SceneData] | null = null; // the scene as it was traced
  let opened = false; // when switches are first set outside of a lesson: only once, the person may close it

  const open = () =>
    switches.use(({ show }) => {
      if (shown) show(...shown);
      root.hidden = false;
      toggle.setAttribute("aria-expanded", "true");
    });
  function close() {
    root.hidden = true;
    toggle.setAttribute("aria-expanded", "false");
  }
  close();

  return {
    element: root,
    toggle,
    undo,
    show(...next: readonly [ViewState, SceneData]) {
      shown = next;
      if (!root.hidden) switches.now()?.show(...next);
      const isAny = isSwitched(next[0].switches);
      undo.hidden = !isAny;
      if (!isAny || opened || next[0].step !== null) return; // a lesson says what it switches, and its stage keeps still
      opened = true;
      open();
    },
  };
}
