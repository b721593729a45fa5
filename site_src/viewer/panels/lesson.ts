/** The sentence under the stage: what the scene teaches, the lesson's current step, or what the player tells. */
import type { RayEvent, Why } from "../state/event-types";
import { isAsking, type ViewState } from "../state/view-state";
import type { SceneData } from "../trace/types";
import { say } from "../words";
import { button, element, marked } from "./element";
import { reachable } from "./scrolls";

/** What the player tells and why a pixel is dark, in words: null until they have come. */
type Words = () => Pick<typeof import("../event-words"), "tell" | "whyDark"> | null;

/** One event's sentence and its numbers. */
function telling(event: RayEvent, words: Words): HTMLElement[] {
  const { says = [], numbers = "" } = words()?.tell(event) ?? {};
  return [element("p", "event-says", ...marked(says)), ...(numbers ? [element("p", "event-numbers numbers", numbers)] : [])];
}

/** Of a lit pixel not before another one was selected than the scene's own. */
const isWorthSaying = (why: Why | null, { pixel }: ViewState, { start }: SceneData): why is Why => !!why && (why.tone !== "lit" || pixel.join() !== start.pixel.join());

export function createLesson(acts: { step: (step: number | null) => void; turn: (by: 1 | -1) => void }) {
  const reveal = button(say("lesson.reveal"), say("lesson.revealHelp"), () => acts.turn(1), { className: "primary reveal" });
  const text = element("div", "lesson-text");
  const place = element("span", "lesson-place numbers");
  const previous = button("\u2039", say("lesson.previous"), () => acts.turn(-1), { className: "sign" });
  const next = button("\u203a", say("lesson.next"), () => acts.turn(1), { className: "sign" });
  const end = button("\u00d7", say("lesson.end"), () => acts.step(null), { className: "sign quiet" });
  const start = button(say("lesson.start"), say("lesson.start"), () => acts.step(0), { className: "primary start-lesson" });
  const steps = element("div", "lesson-steps", previous, place, next, end);
  const root = element("section", "lesson", text, element("div", "lesson-buttons", start, reveal, steps));
  root.setAttribute("aria-label", say("lesson.region"));
  let shown: readonly unknown[] = [];
  const lookAgain = reachable(text);

  return {
    element: root,
    /** told: the event the player is at; why: of the selected pixel's light; said while nothing else is. */
    show(state: ViewState, scene: SceneData, told: RayEvent | null, why: Why | null, words: Words) {
      const { step, revealed } = state;
      const running = step !== null;
      const asking = isAsking(state, scene);
      if (document.activeElement === reveal && !asking) next.focus(); // the focus must not fall off the page
      reveal.hidden = !asking || !!told;
      start.hidden = running || scene.lesson.length === 0;
      steps.hidden = !running;
      root.classList.toggle("running", running);
      root.classList.toggle("telling", !!told);
      text.setAttribute("aria-live", state.playing ? "off" : "polite"); // playing, sentences would fall over one another
      if (running) {
        place.textContent = say("lesson.place", { step: step + 1, of: scene.lesson.length });
        previous.setAttribute("aria-disabled", String(step === 0 && !revealed));
        next.setAttribute("aria-disabled", String(step === scene.lesson.length - 1 && !asking));
      }
      const isWhy = !told && !running && isWorthSaying(why, state, scene);
      const key = [scene.id, step, revealed, told, why, (told || isWhy) && !words()];
      if (key.every((each, k) => each === shown[k])) return;
      shown = key;
      // The pipeline has sanitised a step's HTML.
      if (told) text.replaceChildren(...telling(told, words));
      else if (running) text.innerHTML = ((revealed && scene.lesson[step].answer) || scene.lesson[step]).html;
      else text.replaceChildren(isWhy ? element("p", "why", ...marked(words()?.whyDark(why) ?? [])) : element("p", "teaches", scene.teaches));
      text.scrollTop = 0;
      lookAgain();
    },
  };
}
