/** The strip of controls under the stage: render, which rays, which grid. */
import { RAY_CHOICES, type RayChoice, type ViewState } from "../state/view-state";
import type { SceneData } from "../trace/types";
import { say } from "../words";
import { button, element, pressed, setWord } from "./element";

export interface ControlActs {
  render: () => void;
  rays: (choice: RayChoice) => void;
  level: (by: 1 | -1) => void;
}

const KEYS: Readonly<Record<RayChoice, string>> = { pixel: "", row: "H", column: "V", all: "A" };

export function createControls(acts: ControlActs) {
  const render = button(say("controls.render.empty"), say("controls.renderHelp"), acts.render, { key: "Space", className: "render" });
  const choices = new Map(
    RAY_CHOICES.map((choice) => {
      const [word, help] = [say(`controls.choices.${choice}.word`), say(`controls.choices.${choice}.help`)];
      return [choice, button(word, help, () => acts.rays(choice), { key: KEYS[choice] })] as const;
    }),
  );
  const coarser = button("\u2212", say("controls.coarser"), () => acts.level(-1), { className: "sign" });
  const finer = button("+", say("controls.finer"), () => acts.level(1), { className: "sign" });
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
    group(say("controls.rays"), "choices", ...choices.values()),
    group(say("controls.grid"), "levels", coarser, size, finer),
  );
  return {
    element: root,
    show(state: ViewState, scene: SceneData) {
      setWord(render, say(`controls.render.${state.tiles}`));
      for (const [choice, each] of choices) pressed(each, state.rays.includes(choice));
      size.textContent = say("controls.gridSize", { n: state.n });
      // Not `disabled`: the focus would fall off the button under a keyboard user's finger.
      coarser.setAttribute("aria-disabled", String(state.n === scene.levels[0]));
      finer.setAttribute("aria-disabled", String(state.n === scene.levels[scene.levels.length - 1]));
    },
  };
}
