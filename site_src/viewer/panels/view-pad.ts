/** Nine buttons in the stage's corner that do what dragging and the wheel do. */
import { CONTROL_WORDS } from "../words";
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
  const words = CONTROL_WORDS.view;
  let shifting = false;
  const arrow = (sign: string, way: string, right: number, up: number) => {
    const made = button(sign, way, () => (shifting ? acts.shift(-right * SHARE, -up * SHARE) : acts.turn(right * DEGREES, up * DEGREES)), {
      className: "sign",
    });
    return { made, way };
  };
  const arrows = [
    arrow("\u2191", words.up, 0, 1),
    arrow("\u2190", words.left, -1, 0),
    arrow("\u2192", words.right, 1, 0),
    arrow("\u2193", words.down, 0, -1),
  ];
  const [up, left, right, down] = arrows.map((each) => each.made);
  const mode = button(words.turn[0], words.turn[1], () => toggle());
  const root = element(
    "div",
    "view-pad",
    button("+", words.nearer, () => acts.come(CLOSER), { className: "sign" }),
    up,
    button("\u2212", words.farther, () => acts.come(1 / CLOSER), { className: "sign" }),
    left,
    mode,
    right,
    button(words.start[0], words.start[1], acts.start),
    down,
    button(words.camera[0], words.camera[1], acts.camera, { key: "R" }),
  );
  root.setAttribute("role", "group");
  root.setAttribute("aria-label", words.pad);

  function toggle() {
    shifting = !shifting;
    name();
  }
  function name() {
    const [word, help] = shifting ? words.shift : words.turn;
    setWord(mode, word);
    mode.title = help;
    mode.setAttribute("aria-label", `${word}: ${help}`);
    pressed(mode, shifting);
    for (const { made, way } of arrows) {
      made.title = `${word} ${way}`;
      made.setAttribute("aria-label", `${word} the view ${way}`);
    }
  }
  name();
  return { element: root, dispose: () => root.remove() };
}
