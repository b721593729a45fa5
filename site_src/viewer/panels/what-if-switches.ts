/** The what-if switches: how many bounces, which lamps, which parts of the light. */
import type { Actions } from "../actions";
import { partsOf } from "../state/switchable";
import { BRIGHTEST, bouncesOf, brightness, lampsOf, PARTS } from "../state/switches";
import type { ViewState } from "../state/view-state";
import type { SceneData } from "../trace/types";
import { percent, say } from "../words";
import { button, disable, element, group, named } from "../element";

export type WhatIfActs = Pick<Actions, "bounces" | "lamp" | "stepLamp" | "turnLamp" | "shadows" | "part">;

/** A box to tick with its word, both of which press it. */
function tick(word: string, help: string, turn: () => void) {
  const box = element("input");
  box.type = "checkbox";
  box.addEventListener("change", turn);
  const label = element("label", "tick", box, element("span", "", word));
  label.title = help;
  return { box, label };
}

function createLamp(acts: WhatIfActs, name: string, lamp: number) {
  const { box, label } = tick(name, say("whatIf.lamp", { light: name, key: (lamp + 1) % 10 }), () => acts.turnLamp(lamp));
  const range = named(element("input", "brightness"), say("whatIf.brightness", { light: name }));
  Object.assign(range, { type: "range", min: "0", max: String(BRIGHTEST), step: "0.05" });
  range.addEventListener("input", () => acts.lamp(lamp, Number(range.value)));
  const darker = button("\u2212", say("whatIf.darker", { light: name }), () => acts.stepLamp(lamp, -1), { className: "sign" });
  const brighter = button("+", say("whatIf.brighter", { light: name }), () => acts.stepLamp(lamp, 1), { className: "sign" });
  const share = element("output", "numbers");
  return {
    element: element("div", "lamp", label, darker, range, brighter, share),
    show(factor: number) {
      box.checked = factor > 0;
      range.value = String(factor);
      const text = percent(factor);
      share.textContent = text;
      range.setAttribute("aria-valuetext", text);
      disable(darker, factor === 0);
      disable(brighter, factor === BRIGHTEST);
    },
  };
}

/** All switches, as panels of groups. */
export function createSwitches(acts: WhatIfActs) {
  const fewer = button("\u2212", say("whatIf.fewer"), () => acts.bounces(-1), { className: "sign" });
  const more = button("+", say("whatIf.more"), () => acts.bounces(1), { className: "sign" });
  const limit = element("output", "limit numbers");
  const lampsBox = element("div", "lamps");
  const shadows = tick(say("whatIf.shadows"), say("whatIf.shadowsHelp"), acts.shadows);
  const parts = PARTS.map((part) => ({ part, ...tick(say(`whatIf.part.${part}`), say(`whatIf.partHelp.${part}`), () => acts.part(part)) }));
  let lamps: ReturnType<typeof createLamp>[] = [];
  let shown: SceneData | null = null;

  function showScene(scene: SceneData) {
    shown = scene;
    lamps = lampsOf(scene).map(({ name }, k) => createLamp(acts, name, k));
    lampsBox.replaceChildren(...lamps.map((lamp) => lamp.element));
    const here = partsOf(scene);
    for (const { part, label } of parts) label.hidden = !here.includes(part);
    shadows.box.disabled = !scene.shadows;
    shadows.label.title = say(scene.shadows ? "whatIf.shadowsHelp" : "whatIf.noShadows");
    const traced = scene.depth ? say("whatIf.traced", { count: scene.depth }) : say("whatIf.noneTraced");
    limit.title = traced;
    more.title = `${say("whatIf.more")}: ${traced}`;
  }

  return {
    groups: [
      group(say("whatIf.bounces"), "bounces", element("div", "joined", fewer, limit, more)),
      group(say("whatIf.lights"), "lamp-switches", lampsBox),
      group(say("whatIf.parts"), "parts", shadows.label, ...parts.map(({ label }) => label)),
    ],
    show({ switches }: ViewState, scene: SceneData) {
      if (shown !== scene) showScene(scene);
      const bounces = bouncesOf(switches, scene);
      limit.textContent = String(bounces);
      disable(fewer, bounces === 0);
      disable(more, bounces === scene.depth);
      for (const [k, lamp] of lamps.entries()) lamp.show(brightness(switches, k));
      shadows.box.checked = scene.shadows && switches.shadows;
      for (const { part, box } of parts) box.checked = !switches.without.includes(part);
    },
  };
}
