/** What can be moved: the sliders and pads under the stage, and what opens them. */
import { button, element, named, setWord } from "../element";
import type { Loader } from "../load";
import { singleKeys } from "../panels/remember";
import { svg } from "../panels/svg";
import type { Session } from "../session";
import { sweepName } from "../sweep-words";
import type { ViewState } from "../state/types";
import type { SceneData } from "../trace/types";
import { say } from "../words";
import { createGliding } from "./gliding";
import { createMover } from "./mover";
import { bringStops, leaveSlice } from "./stops";

export { stopAt } from "./stops";

const TYPING = "input:not([type=range]), textarea, select, dialog, [contenteditable]";
const SIGN = "M1.5 8 H14.5 M5 4 L1 8 L5 12 M11 4 L15 8 L11 12"; // to and fro

/** What opens them, in sight wherever something moves: with the controls, in a lecture beside what the lines mean, in a frame beside Play. */
function createOpener(id: string, press: () => void) {
  const made = button(say("sweep.open.word"), say("sweep.open.help"), press, { className: "open-sweeps" });
  made.prepend(svg("svg", { width: 16, height: 16, viewBox: "0 0 16 16", "aria-hidden": "true" }, svg("path", { d: SIGN, fill: "none", stroke: "currentColor", "stroke-width": 2 })));
  made.setAttribute("aria-controls", id);
  return {
    element: made,
    place() {
      const home = document.querySelector(".lecture-row") ?? document.querySelector(document.body.classList.contains("embed") ? ".below-row" : ".controls")!;
      if (made.parentElement !== home) home.append(made);
    },
  };
}

/** home: the element that holds the page's parts. */
export function createSweeps(session: Session, home: HTMLElement, kept: Loader["kept"]) {
  const root = named(element("section", "sweeps"), say("sweep.region"));
  root.id = "sweeps";
  root.hidden = true;
  home.querySelector(".below")!.append(root);
  const { hold, drawn } = createGliding(session);
  let shown: SceneData["sweeps"];
  let movers: ReturnType<typeof createMover>[] = [];

  function build(scene: SceneData) {
    for (const each of movers) each.stop();
    movers = (scene.sweeps ?? []).map((each) => createMover(session, scene, each, hold));
    root.replaceChildren(...movers.map((each) => each.element));
    setWord(opener.element, scene.sweeps?.length === 1 ? sweepName(scene, scene.sweeps[0].id) : say("sweep.open.word"));
  }

  function turn(open: boolean) {
    root.hidden = !open;
    opener.element.setAttribute("aria-expanded", String(open));
    if (open) for (const { id } of session.scene?.sweeps ?? []) bringStops(session, kept, id);
  }
  const opener = createOpener(root.id, () => {
    turn(!!root.hidden);
    session.changed();
    root.scrollIntoView({ block: "nearest" });
  });

  window.addEventListener("keydown", (event) => {
    if (event.key !== "<" && event.key !== ">") return;
    const taken = event.ctrlKey || event.altKey || event.metaKey || event.defaultPrevented || (event.target as Element).closest?.(TYPING);
    if (taken || !singleKeys.on || !session.scene?.sweeps?.length) return;
    turn(true);
    active().act(event.key === "<" ? -1 : 1);
  });
  /** Whose stop is shown, else the first. */
  const active = () => movers[session.scene!.sweeps!.findIndex(({ id }) => session.state!.sweep.startsWith(`${id}:`))] ?? movers[0];

  return {
    drawn,
    show(state: ViewState, scene: SceneData) {
      if (shown !== scene.sweeps) build(scene);
      shown = scene.sweeps;
      opener.place();
      opener.element.hidden = !shown;
      if (!shown) return turn(false);
      if (state.sweep && root.hidden) turn(true);
      for (const each of movers) each.show();
      leaveSlice(session);
    },
  };
}
