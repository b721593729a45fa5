/** The words under the stage: what the scene teaches, the lesson's current step, or the player's current event. */
import type { Actions } from "../actions";
import type { RayEvent } from "../state/event-types";
import { memo } from "../state/memo";
import { isAsking, stopOf, type ViewState } from "../state/view-state";
import type { SceneData } from "../trace/types";
import { say } from "../words";
import { button, disable, element, marked, named, setWord } from "../element";
import { reachable } from "./scrolls";

/** Events and why a pixel is dark, in words: null until they have come. */
type Words = Pick<typeof import("../event-words"), "captionOf" | "whyOf" | "whyDark"> | null | undefined;

/** One event's sentence and its numbers. */
function caption(event: RayEvent, words: Words): HTMLElement[] {
  const { says = [], numbers = "" } = words?.captionOf(event) ?? {};
  return [element("p", "event-says", ...marked(says)), ...(numbers ? [element("p", "event-numbers numbers", numbers)] : [])];
}

/** Why the pixel is as bright as it is. */
function because(last: RayEvent, words: Words): HTMLElement | null {
  const why = last.what === "pixel" && words?.whyOf(last);
  return why ? element("p", "why", ...marked(words!.whyDark(why))) : null;
}

const LONG = 235; // characters: more do not fit into three lines of a desk's size

export function createLesson(acts: Pick<Actions, "step" | "turn" | "page">) {
  const reveal = button(say("lesson.reveal"), say("lesson.revealHelp"), () => acts.turn(1), { className: "primary reveal" });
  const text = element("div", "lesson-text");
  const place = element("span", "lesson-place numbers");
  const previous = button("\u2039", say("lesson.previous"), () => acts.turn(-1), { className: "sign" });
  const next = button("\u203a", say("lesson.next"), () => acts.page(1), { className: "sign next" });
  const end = button("\u00d7", say("lesson.end"), () => acts.step(null), { className: "sign quiet" });
  const start = button(say("lesson.start"), say("lesson.start"), () => acts.step(0), { className: "primary start-lesson" });
  const steps = element("div", "lesson-steps", previous, place, next, end);
  const root = named(element("section", "lesson", text, element("div", "lesson-buttons", start, reveal, steps)), say("lesson.region"));
  const written = memo<void>();
  const contentChanged = reachable(text);

  return {
    element: root,
    /** event: the current one; last: the selected pixel's, which tells why it is as bright as it is, while nothing else is told. */
    show(state: ViewState, scene: SceneData, event: RayEvent | null, last: RayEvent | undefined, words: () => Words) {
      const { step, revealed } = state;
      const running = step !== null;
      const asking = isAsking(state, scene);
      const isLast = step === scene.lesson.length - 1 && !asking;
      if (document.activeElement === reveal && !asking) next.focus(); // the focus must not fall off the page
      reveal.hidden = !asking || !!event;
      steps.hidden = !running;
      if (document.activeElement === start && running) next.focus();
      start.hidden = running || scene.lesson.length === 0;
      root.classList.toggle("running", running);
      root.classList.toggle("captioned", !!event);
      text.setAttribute("aria-live", state.playing ? "off" : "polite"); // playing, sentences would fall over one another
      if (running) {
        place.textContent = say("lesson.place", { step: step + 1, of: scene.lesson.length });
        disable(previous, step === 0 && !revealed);
        setWord(next, isLast ? say("lesson.on.word") : "\u203a", say(isLast ? "lesson.on.help" : "lesson.next"));
      }
      const isFirst = state.pixel.join() === scene.start.pixel.join(); // of it the scene's own sentence is told
      const told = event ?? (running || isFirst ? null : last);
      const known = told && words();
      written([scene.id, step, revealed, told, !known], () => {
        // The pipeline has sanitised a step's HTML.
        if (event) text.replaceChildren(...caption(event, known));
        else if (running) text.innerHTML = stopOf(scene, state)!.html;
        else text.replaceChildren((told && because(told, known)) ?? element("p", "teaches", scene.teaches));
        text.classList.toggle("long", text.textContent.length > LONG);
        text.scrollTop = 0;
        contentChanged();
      });
    },
  };
}
