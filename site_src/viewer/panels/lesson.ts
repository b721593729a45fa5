/** The words under the stage: what the scene teaches, the lesson's current step, or the player's current event. */
import type { Actions } from "../actions";
import type { RayEvent, Why } from "../state/event-types";
import { memo } from "../state/memo";
import { isAsking, stopOf, type ViewState } from "../state/view-state";
import type { SceneData } from "../trace/types";
import { say } from "../words";
import { button, disable, element, marked, named, setWord } from "../element";
import { reachable } from "./scrolls";

/** Events and why a pixel is dark, in words: null until they have come. */
type Words = () => Pick<typeof import("../event-words"), "captionOf" | "whyDark"> | null;

/** One event's sentence and its numbers. */
function caption(event: RayEvent, words: Words): HTMLElement[] {
  const { says = [], numbers = "" } = words()?.captionOf(event) ?? {};
  return [element("p", "event-says", ...marked(says)), ...(numbers ? [element("p", "event-numbers numbers", numbers)] : [])];
}

/** For a lit pixel only once another than the scene's first one is selected. */
const isWorthSaying = (why: Why | null, { pixel }: ViewState, { start }: SceneData): why is Why => !!why && (why.tone !== "lit" || pixel.join() !== start.pixel.join());

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
    /** event: the current one; why: the selected pixel is as bright as it is, shown while nothing else is. */
    show(state: ViewState, scene: SceneData, event: RayEvent | null, why: Why | null, words: Words) {
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
      const isWhy = !event && !running && isWorthSaying(why, state, scene);
      written([scene.id, step, revealed, event, why, (event || isWhy) && !words()], () => {
        // The pipeline has sanitised a step's HTML.
        if (event) text.replaceChildren(...caption(event, words));
        else if (running) text.innerHTML = stopOf(scene, state)!.html;
        else text.replaceChildren(isWhy ? element("p", "why", ...marked(words()?.whyDark(why) ?? [])) : element("p", "teaches", scene.teaches));
        text.classList.toggle("long", text.textContent.length > LONG);
        text.scrollTop = 0;
        contentChanged();
      });
    },
  };
}
