/** The strip of controls under the stage: render, which rays, which grid. */
import type { Actions } from "../actions";
import { RAY_CHOICES, type RayChoice, type ViewState } from "../state/view-state";
import type { SceneData } from "../trace/types";
import { say } from "../words";
import { button, disable, element, group, pressed, setWord } from "../element";

const KEYS: Readonly<Record<RayChoice, string>> = { pixel: "", row: "H", column: "V", all: "A" };

export function createControls(acts: Pick<Actions, "render" | "rays" | "level">) {
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

  const joined = (label: string, className: string, ...parts: HTMLElement[]) => group(label, className, element("div", "joined", ...parts));
  const root = element(
    "div",
    "controls",
    element("div", "group", render),
    group(say("controls.rays"), "choices", ...choices.values()),
    joined(say("controls.grid"), "levels", coarser, size, finer),
  );
  return {
    element: root,
    show(state: ViewState, scene: SceneData) {
      setWord(render, say(`controls.render.${state.tiles}`));
      for (const [choice, each] of choices) pressed(each, state.rays.includes(choice));
      size.textContent = say("controls.gridSize", { n: state.n });
      disable(coarser, state.n === scene.levels[0]);
      disable(finer, state.n === scene.levels.at(-1)!);
    },
  };
}
