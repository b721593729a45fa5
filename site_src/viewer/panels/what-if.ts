/** What if: the panel of switches under the stage, and the button that undoes them all. It comes when first opened or set. */
import type { Actions } from "../actions";
import { isSwitched } from "../state/switches";
import type { ViewState } from "../state/view-state";
import type { SceneData } from "../trace/types";
import { say } from "../words";
import { button, element, named } from "../element";
import { createSwitches, type WhatIfActs } from "./what-if-switches";

/** home: the element that holds the page's parts. */
export function createWhatIf(acts: WhatIfActs & Pick<Actions, "asTraced">, home: HTMLElement) {
  const undo = button(say("whatIf.undo.word"), say("whatIf.undo.help"), acts.asTraced, { className: "undo-switches" });
  const switches = createSwitches(acts);
  const root = named(element("section", "what-if", ...switches.groups), say("whatIf.region"));
  root.id = "what-if";
  root.hidden = true;
  home.querySelector(".controls")!.before(undo);
  home.querySelector(".below")!.append(root);
  let opened = false; // when switches are first set outside of a lesson: only once, the person may close it

  function turn(open: boolean) {
    root.hidden = !open;
    document.querySelector(".open-what-if")?.setAttribute("aria-expanded", String(open));
  }
  return {
    turn: () => turn(!!root.hidden),
    show(state: ViewState, scene: SceneData) {
      const isAny = isSwitched(state.switches);
      undo.hidden = !isAny;
      if (isAny && !opened && state.step === null) { // a lesson says what it switches, and its stage keeps still
        opened = true;
        turn(true);
      }
      if (!root.hidden) switches.show(state, scene);
    },
  };
}
