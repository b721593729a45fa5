/** A step of the lesson that uses a tool opens the drawer in which that is, the first time, with a word at the tool. */
import { element } from "../element";
import { isSwitched } from "../state/switches";
import type { ViewState } from "../state/view-state";
import { say } from "../words";
import { bringUp } from "./scrolls";
import { listenToTerms } from "./term-card";

const ROOM = "(min-width: 1100px)"; // else the drawer would take the stage's

/** The tool that a step's view uses, by where it stands in the drawer; null: none. */
function toolOf({ colours, slice, look, switches }: ViewState): string | null {
  if (isSwitched(switches)) return ".open-what-if";
  if (colours !== "picture") return ".tile-choice";
  return slice !== "none" || look !== "approximate" ? ".view-switch" : null;
}

/** On a phone a step that is gone to from further down the page would have its text under the stage. */
function showText() {
  const text = document.querySelector(".lesson")!;
  const under = document.querySelector(".stage")!.getBoundingClientRect();
  const { top, bottom } = text.getBoundingClientRect();
  if (top < Math.min(under.bottom, innerHeight) - 1 || bottom > innerHeight) bringUp(text, "auto");
}

/** open: opens the drawer, and calls what it is given when its tools are there. */
export function createGuide(open: (then: () => void) => void) {
  const word = element("p", "introduces", say("drawer.introduces"));
  const known = new Set<string>();
  let stop = "";
  const terms = listenToTerms(document.body);
  return {
    show(state: ViewState) {
      terms.step();
      const at = state.step === null ? "" : `${state.scene} ${state.step} ${state.revealed}`;
      if (at === stop) return;
      stop = at;
      word.remove();
      showText();
      const tool = at && toolOf(state);
      const isElsewhere = window.raywalkKiosk || state.projector || document.body.classList.contains("embed") || !matchMedia(ROOM).matches;
      if (!tool || known.has(tool) || isElsewhere) return;
      known.add(tool);
      open(() => at === stop && document.querySelector(`.drawer ${tool}`)?.after(word));
    },
  };
}
