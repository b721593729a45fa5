/** What can be moved: a slider a sweep, which stops where the scene was traced, and goes to and fro by itself. */
import { button, disable, element, group, named, pressed } from "../element";
import { singleKeys } from "../panels/remember";
import type { Session } from "../session";
import { stopIn } from "../state/swept";
import type { ViewState } from "../state/types";
import type { SceneData } from "../trace/types";
import { sweepName, valueAt, type Sweep } from "../sweep-words";
import { say } from "../words";

export { stopAt } from "./stops";

const PACE = 450; // ms a stop, by itself
const TYPING = "input:not([type=range]), textarea, select, dialog, [contenteditable]";

/** Goes to and fro between the first stop and the last, while it is on. */
function createPlaying(step: () => void) {
  let timer = 0;
  const stop = () => (clearInterval(timer), (timer = 0));
  return {
    isOn: () => timer !== 0,
    stop,
    turn() {
      if (timer) stop();
      else timer = window.setInterval(step, PACE);
    },
  };
}

function createSlider(session: Session, sweep: Sweep, name: string) {
  const count = sweep.values.length;
  const stopNow = () => (session.scene && session.state && stopIn(session.scene, session.state.sweep)?.sweep.id === sweep.id ? stopIn(session.scene, session.state.sweep)!.stop : sweep.own);
  const to = (stop: number) => session.set({ ...session.state!, sweep: `${sweep.id}:${Math.max(1, Math.min(count, stop))}`, tiles: "filled", playing: false });
  const act = (by: number) => (playing.stop(), to(stopNow() + by));
  let way = 1;
  const playing = createPlaying(() => {
    if (!range.isConnected || document.hidden) return playing.stop();
    if (stopNow() === (way > 0 ? count : 1)) way = -way;
    to(stopNow() + way);
  });

  const range = named(element("input", "stops"), name);
  Object.assign(range, { type: "range", min: "1", max: String(count), step: "1" });
  range.addEventListener("input", () => (playing.stop(), to(Number(range.value))));
  const before = button("\u2039", say("sweep.before", { name }), () => act(-1), { className: "sign" });
  const after = button("\u203a", say("sweep.after", { name }), () => act(1), { className: "sign" });
  const play = button(say("sweep.play.word"), say("sweep.play.help"), () => (playing.turn(), session.changed()), { className: "to-and-fro" });
  const value = element("output", "numbers");
  return {
    element: group(name, "sweep", before, range, after, play, value),
    act,
    stop: playing.stop,
    show() {
      const stop = stopNow();
      const text = say("sweep.stop", { stop, count, value: valueAt(sweep, stop) });
      range.value = String(stop);
      range.setAttribute("aria-valuetext", text);
      if (value.textContent !== text) value.textContent = text;
      disable(before, stop === 1);
      disable(after, stop === count);
      pressed(play, playing.isOn());
    },
  };
}

/** home: the element that holds the page's parts. */
export function createSweeps(session: Session, home: HTMLElement) {
  const root = named(element("section", "sweeps"), say("sweep.region"));
  root.id = "sweeps";
  root.hidden = true;
  home.querySelector(".below")!.append(root);
  let shown: SceneData["sweeps"];
  let sliders: ReturnType<typeof createSlider>[] = [];

  function build(scene: SceneData) {
    for (const each of sliders) each.stop();
    sliders = (scene.sweeps ?? []).map((each) => createSlider(session, each, sweepName(scene, each.id)));
    root.replaceChildren(...sliders.map((each) => each.element));
  }

  function turn(open: boolean) {
    root.hidden = !open;
    opener.setAttribute("aria-expanded", String(open));
  }
  const opener = button(say("sweep.open.word"), say("sweep.open.help"), () => (turn(!!root.hidden), session.changed()), { className: "open-sweeps" });
  opener.setAttribute("aria-controls", root.id);

  window.addEventListener("keydown", (event) => {
    if (event.key !== "<" && event.key !== ">") return;
    const taken = event.ctrlKey || event.altKey || event.metaKey || event.defaultPrevented || (event.target as Element).closest?.(TYPING);
    if (taken || !singleKeys.on || !session.scene?.sweeps?.length) return;
    turn(true);
    active().act(event.key === "<" ? -1 : 1);
  });
  /** Whose stop is shown, else the first. */
  const active = () => sliders[session.scene!.sweeps!.findIndex(({ id }) => session.state!.sweep.startsWith(`${id}:`))] ?? sliders[0];

  return {
    show(state: ViewState, scene: SceneData) {
      if (shown !== scene.sweeps) build(scene);
      shown = scene.sweeps;
      // Once there is anything in the drawer; before its neighbour, behind which the guide puts a word.
      if (!opener.isConnected) document.querySelector("#drawer .open-what-if")?.before(opener);
      opener.hidden = !shown;
      if (!shown) return turn(false);
      if (state.sweep && root.hidden) turn(true);
      for (const each of sliders) each.show();
    },
  };
}
