/** Nine buttons in the stage's corner that do what dragging and the wheel do. */
import { say } from "../words";
import { button, element, pressed, setWord } from "./element";

export interface ViewActs {
  /** Degrees to the right and up. */
  turn: (right: number, up: number) => void;
  /** Shares of the stage. */
  shift: (right: number, up: number) => void;
  come: (factor: number) => void;
  start: () => void;
  camera: () => void;
}

const DEGREES = 10;
const SHARE = 0.08;
const CLOSER = 0.85;

export function createViewPad(acts: ViewActs) {
  let shifting = false;
  const arrow = (sign: string, way: "up" | "down" | "left" | "right", right: number, up: number) => {
    const made = button(sign, "", () => (shifting ? acts.shift(-right * SHARE, -up * SHARE) : acts.turn(right * DEGREES, up * DEGREES)), {
      className: "sign",
    });
    return { made, way };
  };
  const arrows = [
    arrow("\u2191", "up", 0, 1),
    arrow("\u2190", "left", -1, 0),
    arrow("\u2192", "right", 1, 0),
    arrow("\u2193", "down", 0, -1),
  ];
  const [up, left, right, down] = arrows.map((each) => each.made);
  const mode = button(say("pad.turn.word"), say("pad.turn.help"), () => toggle());
  const root = element(
    "div",
    "view-pad",
    button("+", say("pad.nearer"), () => acts.come(CLOSER), { className: "sign" }),
    up,
    button("\u2212", say("pad.farther"), () => acts.come(1 / CLOSER), { className: "sign" }),
    left,
    mode,
    right,
    button(say("pad.start.word"), say("pad.start.help"), acts.start),
    down,
    button(say("pad.camera.word"), say("pad.camera.help"), acts.camera, { key: "R" }),
  );
  root.setAttribute("role", "group");
  root.setAttribute("aria-label", say("pad.name"));

  function toggle() {
    shifting = !shifting;
    name();
  }
  function name() {
    const does = shifting ? "shift" : "turn";
    const [word, help] = [say(`pad.${does}.word`), say(`pad.${does}.help`)];
    setWord(mode, word, help);
    pressed(mode, shifting);
    for (const { made, way } of arrows) {
      const says = say(`pad.${does}.${way}`);
      made.title = says;
      made.setAttribute("aria-label", says);
    }
  }
  name();
  return { element: root };
}
