/** The strip of controls under the stage: render, which rays, which grid. */
import { RAY_CHOICES, type RayChoice, type ViewState } from "../state/view-state";
import type { SceneData } from "../trace/types";
import { CONTROL_WORDS as WORDS } from "../words";
import { button, element, pressed, setWord } from "./element";

export interface ControlActs {
  render: () => void;
  rays: (choice: RayChoice) => void;
  level: (by: 1 | -1) => void;
}

export function createControls(acts: ControlActs) {
  const render = button(WORDS.render.empty, WORDS.renderHelp, acts.render, { key: "Space", className: "render" });
  const choices = new Map(
    RAY_CHOICES.map((choice) => {
      const [word, key, help] = WORDS.choices[choice];
      return [choice, button(word, help, () => acts.rays(choice), { key })] as const;
    }),
  );
  const coarser = button("\u2212", WORDS.coarser, () => acts.level(-1), { className: "sign" });
  const finer = button("+", WORDS.finer, () => acts.level(1), { className: "sign" });
  const size = element("output", "grid-size");

  const group = (name: string, className: string, ...parts: HTMLElement[]) => {
    const joined = element("div", "joined", ...parts);
    const whole = element("div", `group ${className}`, element("span", "group-name", name), joined);
    whole.setAttribute("role", "group");
    whole.setAttribute("aria-label", name);
    return whole;
  };
  const root = element(
    "div",
    "controls",
    element("div", "group", render),
    group(WORDS.rays, "choices", ...choices.values()),
    group(WORDS.grid, "levels", coarser, size, finer),
  );
  return {
    element: root,
    show(state: ViewState, scene: SceneData) {
      setWord(render, WORDS.render[state.tiles]);
      for (const [choice, each] of choices) pressed(each, state.rays.includes(choice));
      size.textContent = WORDS.gridSize(state.n);
      // Not `disabled`: the focus would fall off the button under a keyboard user's finger.
      coarser.setAttribute("aria-disabled", String(state.n === scene.levels[0]));
      finer.setAttribute("aria-disabled", String(state.n === scene.levels[scene.levels.length - 1]));
    },
    dispose: () => root.remove(),
  };
}
