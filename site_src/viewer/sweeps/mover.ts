/** What moves one sweep: its slider or pad, a stop back and on, and to and fro by itself; and at which stop it is. */
import { button, disable, element, group, pressed } from "../element";
import type { Session } from "../session";
import { countOf, onTheWay, stopIn, wayTo } from "../state/swept";
import { acrossName, sweepName, valueAt, valuesAt, type Sweep } from "../sweep-words";
import type { SceneData } from "../trace/types";
import { say } from "../words";
import { createPad } from "./pad";
import { createSlider } from "./slider";
import type { MoverActs } from "./types";

const PACE = 450; // ms a stop, by itself

/** Goes on while it is on. */
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

/** hold: what is drawn follows the finger. */
export function createMover(session: Session, scene: SceneData, sweep: Sweep, hold: MoverActs["hold"]) {
  const [name, across] = [sweepName(scene, sweep.id), acrossName(scene, sweep.id)];
  const count = countOf(sweep);
  function stopNow() {
    const found = session.scene && session.state && stopIn(session.scene, session.state.sweep);
    return found?.sweep.id === sweep.id ? found.stop : sweep.own;
  }
  const to = (stop: number) => session.set({ ...session.state!, sweep: `${sweep.id}:${stop}`, tiles: "filled", playing: false });
  /** A stop on or back, on the way through all of them. */
  const go = (by: number) => to(onTheWay(sweep, Math.max(0, Math.min(count - 1, wayTo(sweep, stopNow()) + by))));
  const act = (by: number) => (playing.stop(), go(by));
  let way = 1;
  const playing = createPlaying(() => {
    if (!control.element.isConnected || document.hidden) return playing.stop();
    if (wayTo(sweep, stopNow()) === (way > 0 ? count - 1 : 0)) way = -way;
    go(way);
  });

  const acts: MoverActs = {
    now: stopNow,
    to: (stop) => (playing.stop(), stop !== stopNow() && to(stop)),
    hold,
  };
  const control = sweep.across ? createPad(acts, sweep, across ? say("sweep.crossed", { name, across }) : name) : createSlider(acts, sweep, name);
  const before = button("\u2039", say("sweep.before", { name }), () => act(-1), { className: "sign" });
  const after = button("\u203a", say("sweep.after", { name }), () => act(1), { className: "sign" });
  const play = button(say("sweep.play.word"), say("sweep.play.help"), () => (playing.turn(), session.changed()), { className: "to-and-fro" });
  const value = element("output", "numbers");
  const root = sweep.across
    ? group(name, "sweep crossed", control.element, element("div", "crossed-words", element("div", "joined", before, after), play, value))
    : group(name, "sweep", before, control.element, after, play, value);
  return {
    element: root,
    act,
    stop: playing.stop,
    show() {
      const stop = stopNow();
      const [one, other] = valuesAt(sweep, stop);
      const values = across ? say("sweep.both", { name, value: one, across, other }) : valueAt(sweep, stop);
      const text = say("sweep.stop", { stop, count, value: values });
      control.show(stop, text);
      if (value.textContent !== text) value.textContent = text;
      disable(before, wayTo(sweep, stop) === 0);
      disable(after, wayTo(sweep, stop) === count - 1);
      pressed(play, playing.isOn());
    },
  };
}
