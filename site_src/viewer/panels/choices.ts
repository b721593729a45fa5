/** A question's choices: one of them is chosen before the answer, and with it each says why it is right or wrong. */
import type { Actions } from "../actions";
import { button, element, named, setWord, swatch } from "../element";
import { isAsking, pixelIndex, type ViewState } from "../state/view-state";
import type { ChoiceData, SceneData, Trace } from "../trace/types";
import { hexOf, say } from "../words";
import { createMarks, letter } from "./choice-marks";
import { sayDone } from "./done";
import { createPredictions, type Predictions } from "./predictions";
import { reachable } from "./scrolls";

const NARROW = "(max-width: 760px)"; // there, and where it fills the page, choices stand below their question

type Choices = readonly ChoiceData[];
const NONE: Choices = [];

/** Its words, which the pipeline has sanitised, or the name of what it is. */
function label(choice: ChoiceData, k: number, scene: SceneData): HTMLElement {
  const words = element("span", "choice-words");
  if (choice.pixel) words.textContent = say("card.pixel", { column: choice.pixel[0], row: choice.pixel[1] });
  else if (choice.object !== undefined) words.textContent = scene.objects[choice.object].name;
  else words.innerHTML = choice.html;
  return element("span", "choice-label", element("span", "letter", letter(k)), ...(choice.colour ? [swatch(hexOf(choice.colour))] : []), words);
}

/** Radio buttons; the group is one stop for the Tab key, and Enter on what is chosen reveals. */
function createGroup(choices: Choices, scene: SceneData, choose: (k: number) => void, reveal: () => void) {
  const radios = choices.map((choice, k) => {
    const made = element("button", "option", label(choice, k, scene));
    made.type = "button";
    made.setAttribute("role", "radio");
    made.addEventListener("click", () => choose(k));
    return made;
  });
  const root = named(element("div", "options", ...radios), say("choices.name"), "radiogroup");
  root.addEventListener("keydown", (event) => {
    const at = radios.indexOf(event.target as HTMLButtonElement);
    const by = { ArrowDown: 1, ArrowRight: 1, ArrowUp: -1, ArrowLeft: -1 }[event.key];
    const isChosen = radios[at]?.getAttribute("aria-checked") === "true";
    if (!by && !(event.key === "Enter" && isChosen)) return;
    event.preventDefault();
    if (!by) return reveal();
    const next = (at + by + radios.length) % radios.length;
    choose(next);
    radios[next].focus();
  });
  return {
    element: root,
    focus: () => radios.find(({ tabIndex }) => tabIndex === 0)?.focus(),
    show(chosen: number | undefined) {
      radios.forEach((radio, k) => {
        radio.setAttribute("aria-checked", String(k === chosen));
        radio.tabIndex = k === (chosen ?? 0) ? 0 : -1;
      });
    },
  };
}

/** Each choice with its reason, the right one marked, and what was chosen. */
function reasons(choices: Choices, scene: SceneData, chosen: number | undefined): HTMLElement {
  const items = choices.map((choice, k) => {
    const verdict = element("span", "verdict", element("span", "unseen", say(choice.right ? "choices.right" : "choices.wrong"))); // seen as a sign
    const because = element("p", "because");
    because.innerHTML = choice.because;
    if (k === chosen) because.prepend(element("b", "yours", say("choices.yours")), " ");
    return element("li", `reason${choice.right ? " is-right" : ""}${k === chosen ? " is-yours" : ""}`, label(choice, k, scene), verdict, because);
  });
  return named(element("ol", "reasons", ...items), say("choices.reasons"));
}

interface Clipboard {
  copy: (text: string, done: () => void) => unknown;
}

/** Of what comes when asked for: what copies. On-demand itself imports this file. */
interface Parts {
  one(name: "at-hand", make: (part: Clipboard) => Clipboard): { use(to: (part: Clipboard) => void): void };
}

/** How many of the scene's questions were right at the first try: of those predicted so far, once there are two; when all are answered, to be copied. */
function score({ id, title, lesson }: SceneData, predictions: Predictions, copy: (text: string, done: () => void) => void): HTMLElement {
  const questions = lesson.flatMap(({ choices }, step) => (choices ? [{ choices, tried: predictions.tried(id, step) }] : []));
  const predicted = questions.filter(({ choices, tried }) => choices[tried ?? -1]);
  const right = predicted.filter(({ choices, tried }) => choices[tried!].right).length;
  const root = element("p", "score numbers", predicted.length < 2 ? "" : say("choices.score", { right, of: predicted.length }));
  if (questions.every(({ tried }) => tried !== undefined) && root.textContent) {
    const text = say("choices.copy.text", { title, right, of: questions.length });
    const made = button(say("choices.copy.word"), say("choices.copy.help"), () => copy(text, () => sayDone(made, say("choices.copy.done"))));
    root.append(" ", made);
  }
  return root;
}

/** Where choices stand, and what beside them changes: the way to the answer is by a choice, or says that there is none. */
function createPlace(home: HTMLElement, root: HTMLElement, draw: () => void) {
  const find = (selector: string) => home.querySelector<HTMLElement>(selector)!;
  const [lesson, reveal, next, card] = [".lesson", ".reveal", ".lesson-steps .next", ".card"].map(find);
  const { classList } = document.body;
  const narrow = matchMedia(NARROW);
  narrow.addEventListener("change", draw);
  return {
    next,
    /** isOpen: nothing is chosen yet. */
    show({ projector }: ViewState, isShown: boolean, isOpen: boolean) {
      const isBelow = narrow.matches || projector || classList.contains("embed");
      const [into, before] = isBelow ? [lesson, find(".lesson-buttons")] : [card.parentElement!, card];
      if (isShown && root.nextElementSibling !== before) into.insertBefore(root, before);
      root.hidden = !isShown;
      lesson.classList.toggle("with-choices", isShown && isBelow);
      home.classList.toggle("prediction-beside", isShown && !isBelow);
      const isAlone = isOpen && !projector; // in a lecture a hall chooses, by hands
      lesson.classList.toggle("unanswered", isAlone);
      reveal.classList.toggle("primary", !isAlone);
      const isShort = !isAlone || classList.contains("embed");
      setWord(reveal, say(isShort ? "lesson.reveal" : "choices.without"), say(isAlone ? "choices.without" : "lesson.revealHelp"));
    },
  };
}

export function createChoices(acts: Pick<Actions, "turn" | "pick">, home: HTMLElement, changed: () => void, onDemand: Parts) {
  const root = named(element("section", "prediction"), say("choices.name"));
  const predictions = createPredictions();
  const atHand = onDemand.one("at-hand", (part) => part);
  const copy = (text: string, done: () => void) => atHand.use((part) => void part.copy(text, done));
  const place = createPlace(home, root, changed);
  const marks = createMarks(home);
  const contentChanged = reachable(root); // in a frame they scroll
  let group: ReturnType<typeof createGroup> | null = null;
  let shown = ""; // which question, asked or answered
  let pixel = ""; // the selected one when it was last looked at

  /** A pixel that a person selects is a choice where it is one, or shows an object that is. */
  function choosePicked(state: ViewState, choices: Choices, trace: Trace | null, choose: (k: number) => void) {
    const at = state.pixel.join();
    if (at === pixel) return;
    pixel = at;
    const object = trace?.object[pixelIndex(state)];
    const k = choices.findIndex((each) => each.pixel?.join() === at || (each.object !== undefined && each.object === object));
    if (k >= 0) choose(k);
  }

  return {
    show(state: ViewState, scene: SceneData, trace: Trace | null) {
      const { step } = state;
      const choices = (step !== null && scene.lesson[step]?.choices) || NONE;
      const asking = isAsking(state, scene);
      const chosen = step === null ? undefined : predictions.made(scene.id, step, choices.length);
      place.show(state, choices.length > 0, asking && choices.length > 0 && chosen === undefined);
      if (step !== null && choices.length && !asking) predictions.settle(scene.id, step);
      marks.show(state.n, choices);
      root.classList.toggle("asking", asking);
      const now = choices.length ? `${scene.id} ${step} ${asking}` : "";
      const choose = (k: number) => {
        predictions.make(scene.id, step!, k);
        const { pixel } = choices[k];
        if (pixel) acts.pick(...pixel);
        changed();
      };
      if (now !== shown) {
        const had = root.contains(document.activeElement) || document.activeElement === place.next;
        shown = now;
        pixel = state.pixel.join();
        group = asking && now ? createGroup(choices, scene, choose, () => acts.turn(1)) : null;
        root.replaceChildren(...(group ? [group.element] : [reasons(choices, scene, chosen), score(scene, predictions, copy)]));
        group?.show(chosen);
        if (had && now && !state.projector) group ? group.focus() : place.next.focus();
      }
      if (group) choosePicked(state, choices, trace, choose);
      group?.show(step === null ? undefined : predictions.made(scene.id, step, choices.length));
      contentChanged();
    },
  };
}
